"""The search for the best plan of a whole fleet.

A round of the search cuts the day in two at an instant drawn near its middle: trucks whose windows
end before it, and trucks whose windows begin behind it, never meet, and each side is worked off
with random numbers of its own, in any order or at once; trucks across the cut wait for the next
round. So the answer depends on the seed and the number of moves, and not on the number of threads.
Where too many lie across, one round is for all.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from ..instance import Instance
from . import draws
from .compiled import EXPLORE, SWEEP
from .desk import Plan, Taste, desk
from .guidance import GuideOf, SharesOf
from .insertion import meeting_points
from .margin import worth_a_look
from .moves import crew
from .occupancy import Costs, Occupancy
from .pairs_used import Prices, Used, priced, used_pairs
from .schedules import Schedules

__all__ = ["FleetSearch"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]
FixedWays = Mapping[int, tuple[Ints, Ints]]

LARGE = 2000
"""From so many trucks on, a plan is begun with prepared lanes."""

SATURATED = 8000
"""From so many trucks on, some moves are group moves."""

GROUP_MOVES = 0.3
"""Their share then."""

NEIGHBOURS = 20
"""Trucks of a neighbourhood at most, below so many as are large; a few more beyond."""

MARGIN = 0.25
"""See `margin`; eight times as wide below `LARGE` trucks."""

HOT = 0.7
"""The highest temperature, as a part of what a mean trip could save; a tenth below `LARGE`."""

CHUNK = 250
"""Moves between two questions whether to stop."""

ORDERS = 100
"""In how many orders trucks that must keep apart are put in before that is given up."""

PLAIN_S = 2e-3
"""How long a response takes where nothing is compiled, about [s]."""


@dataclass(slots=True, eq=False)
class _View:
    """What moves work on: pairs in use, shares, the plan in terms of them."""

    used: Used
    which: Ints
    place: Ints
    prices: Prices
    guide: NDArray[np.int32]
    guide_count: Ints
    trusted: bool


class FleetSearch:
    """A plan of a fleet that gets better.

    Parameters
    ----------
    instance : Instance
        The problem.
    threads : int
        How many at once; the answer is the same for any.
    seed : int
        Of all random numbers.
    apart : tuple of ndarray of int64, optional
        Trucks that each truck must not drive together with: `first_apart` (N + 1,) and `apart`.
    fixed : mapping of int to (ndarray of int64, ndarray of int64)
        Trucks that drive lanes at instants that are told, and never otherwise; none that keeps
        apart from others.

    Attributes
    ----------
    best : Schedules
        The cheapest plan so far; before `construct`, each truck's response to those before it.
    cost : int
        What it costs [grains].
    """

    def __init__(
        self,
        instance: Instance,
        threads: int = 1,
        seed: int = 0,
        apart: tuple[Ints, Ints] | None = None,
        fixed: FixedWays = MappingProxyType({}),
    ) -> None:
        self.instance = instance
        self._threads = max(1, threads)
        self._seed = seed
        count = instance.trucks
        self._apart = _both_ways(count, apart)
        self._costs = Costs(
            instance.alone, instance.member, instance.extra, instance.largest, instance.waiting
        )
        widest = int(np.diff(instance.first_pair).max(initial=0))
        self._width = max(1, min(widest, instance.nodes) + 1)
        self._legs = np.zeros((count, self._width), np.int32)
        self._departs = np.zeros((count, self._width), np.int64)
        self._count = np.zeros(count, np.int64)
        self._is_free = np.ones(count, np.bool_)
        self._is_free[list(fixed)] = False
        room = np.bincount(instance.pair_lane, minlength=instance.lanes) + 2
        self._points = (np.zeros(0, np.int64), np.zeros(0, np.int64))
        if count >= LARGE:
            self._points = meeting_points(instance)
            room = room + np.bincount(self._points[0], minlength=instance.lanes)
        self._room = room
        self._fix(fixed)
        savings = np.zeros(instance.lanes)
        paid = instance.alone > 0
        savings[paid] = 1 - instance.member[paid] / instance.alone[paid]
        mean = float(savings[paid].mean()) if paid.any() else 0.0
        per_trip = float(instance.alone_cost.mean()) if count else 0.0
        self._hot = HOT * mean * per_trip * (1.0 if count >= LARGE else 0.1)
        self._calls = 0
        self._order: tuple[Ints, Ints] | None = None
        self._last: tuple[object, object] | None = None
        self._view = self._viewed(None, None)
        self._current = 0
        self._current = self._sweeps([_taste(0.0)])
        self._kept = self._copied()
        self.cost = self._current

    @property
    def best(self) -> Schedules:
        """The cheapest plan so far."""
        return self._whole(self._kept)

    def construct(self, shares: SharesOf | None, guide: GuideOf | None) -> None:
        """Build a plan from nothing, and keep it if it is the cheapest so far.

        Parameters
        ----------
        shares : SharesOf or None
            The bound's shares.
        guide : GuideOf or None
            What they say of each truck.

        Raises
        ------
        ScenarioError
            Trucks that must keep apart and cannot.
        """
        self._see(shares, guide)
        before = (self._legs.copy(), self._departs.copy(), self._count.copy(), self._current)
        trust = 1.0 if self._view.trusted else 0.0
        plain = [_taste(trust), _taste(0.0), _taste(0.0), _taste(0.0)]
        ways: list[tuple[list[Taste], list[Taste]]] = [([], plain)]
        if self.instance.trucks >= LARGE:
            fading = [_taste(0.0, 1.0 - step / 3.0) for step in (1, 2, 3)]
            ways.append(([_taste(0.0, 1.0), _taste(0.0, 1.0)], fading))
        found = None
        for prepared, tastes in ways:
            self._calls += 1
            self._count[:] = 0
            if prepared:
                self._sweeps(prepared, *self._points)
            cost = self._sweeps(tastes)
            if found is None or cost < found[3]:
                found = (self._legs.copy(), self._departs.copy(), self._count.copy(), cost)
        if found is None or found[3] > before[3]:
            found = before
        self._legs, self._departs, self._count, self._current = found
        self._note()

    def take(self, lanes: Sequence[Ints], departs: Sequence[Ints]) -> None:
        """Go on from a plan that was made elsewhere, if it is the cheapest so far.

        Parameters
        ----------
        lanes, departs : sequence of ndarray of int64, (N, ...)
            Lanes of each truck in driving order, and when it enters them [ticks].
        """
        count = np.array([len(own) for own in lanes], np.int64)
        truck = np.repeat(np.arange(len(count)), count)
        used = np.arange(self._width)[None, :] < count[:, None]
        legs, instants = np.zeros_like(self._departs), np.zeros_like(self._departs)
        instants[used] = np.concatenate(departs)
        order, sorted_key = self._sorted_pairs()
        wanted = truck * self.instance.lanes + np.concatenate(lanes)
        legs[used] = order[np.searchsorted(sorted_key, wanted)]
        kept = (legs, instants, count)
        cost = self._whole(kept).cost(self.instance)
        if cost >= self.cost:
            return
        self._kept, self.cost, self._current = kept, cost, cost
        self._departs, self._count = instants.copy(), count.copy()
        # With its pairs among those that are looked at.
        self._view, self._last = self._viewed(None, None), None
        self._legs = self._view.place[legs].astype(np.int32)

    def improve(
        self,
        shares: SharesOf | None,
        guide: GuideOf | None,
        moves: int,
        heat: float,
        stop: Callable[[], bool],
    ) -> None:
        """Do some moves, one round of the search.

        Parameters
        ----------
        shares : SharesOf or None
            The bound's shares.
        guide : GuideOf or None
            What they say of each truck.
        moves : int
            How many.
        heat : float
            From 1, rises in cost are accepted as at first, to 0, none are; the temperature goes
            with its square.
        stop : callable
            Asked between chunks of moves; True ends the round.
        """
        if not self._is_free.any() or self.instance.pairs == 0:
            return
        self._calls += 1
        self._see(shares, guide)
        slabs = self._slabs()
        each = -(-moves // len(slabs))
        temperature = self._hot * heat * heat

        def work(number: int) -> int:
            return self._explored(slabs[number], number, each, temperature, stop)

        if self._threads > 1 and len(slabs) > 1:
            with ThreadPoolExecutor(min(self._threads, len(slabs))) as pool:
                changes = list(pool.map(work, range(len(slabs))))
        else:
            changes = [work(number) for number in range(len(slabs))]
        self._current += sum(changes)
        self._note()

    def refix(self, fixed: FixedWays, always: bool = False) -> bool:
        """Let the fixed trucks drive otherwise beside the best plan so far, if that costs less.

        Parameters
        ----------
        fixed : mapping of int to (ndarray of int64, ndarray of int64)
            The same trucks, with other lanes and instants.
        always : bool
            Whether it is done at any cost.

        Returns
        -------
        bool
            Whether they do.
        """
        before = self._fixed
        self._fix(fixed)
        cost = self.best.cost(self.instance)
        if cost >= self.cost and not always:
            self._fix(before)
            return False
        # The plan at hand goes on beside the new ways.
        self.cost, self._current = cost, self._now().cost(self.instance)
        self._note()
        return True

    # What rounds are made of.

    def _fix(self, fixed: FixedWays) -> None:
        """Note what the fixed trucks drive, with room for them on their lanes."""
        self._fixed = fixed
        none = np.zeros(0, np.int64)
        self._taken = (
            np.concatenate([none, *(lanes for lanes, _ in fixed.values())]),
            np.concatenate([none, *(departs for _, departs in fixed.values())]),
        )
        room = self._room + np.bincount(self._taken[0], minlength=self.instance.lanes)
        self._row_first = np.concatenate([[0], np.cumsum(room)]).astype(np.int64)

    def _slabs(self) -> list[Ints]:
        """Return trucks that may be moved, in sets that never meet."""
        instance = self.instance
        every = np.flatnonzero(self._is_free)
        rng = np.random.default_rng([abs(self._seed), 1, self._calls])
        middle = ((instance.earliest + instance.latest) // 2)[every]
        cut = int(np.quantile(middle, 0.5 + 0.2 * (2 * rng.random() - 1)))
        early, late = every[instance.latest[every] < cut], every[instance.earliest[every] > cut]
        if min(len(early), len(late)) < 50 or len(early) + len(late) < 0.6 * len(every):
            return [every]
        return [early, late]

    def _explored(
        self, active: Ints, number: int, moves: int, temperature: float, stop: Callable[[], bool]
    ) -> int:
        """Do the moves of one set of trucks; return what all pay more."""
        view, count = self._view, self.instance.trucks
        lanes, entered = self._occupied()
        is_active = np.zeros(count, bool)
        is_active[active] = True
        state = draws.started(self._seed, 2, self._calls, number)
        work, some = desk(view.used, self._width), crew(count, self._width)
        sums = np.zeros(len(active))
        size = NEIGHBOURS + (4 if count >= LARGE else 0)
        size = max(2, min(size, len(active)))
        group = GROUP_MOVES if count >= SATURATED else 0.05
        kernel = EXPLORE.ready(moves * size * PLAIN_S)
        change, done = 0, 0
        while done < moves:
            now = min(CHUNK, moves - done)
            change += int(
                kernel(
                    now, size, group, temperature, active, is_active, view.guide,
                    view.guide_count, view.used, view.prices, self._costs, lanes, self._plan(),
                    entered, work, state, some, sums,
                )
            )  # fmt: skip
            done += now
            if done < moves and stop():
                break
        return change

    def _sweeps(
        self, tastes: Sequence[Taste], lane: Ints | None = None,
        instant: Ints | None = None,
    ) -> int:  # fmt: skip
        """Let all trucks respond, once for each taste; return what the plan costs then."""
        extra = None if lane is None or instant is None else (lane, instant)
        rng = np.random.default_rng([abs(self._seed), 4, self._calls, len(tastes)])
        begun = self._legs.copy(), self._departs.copy(), self._count.copy()
        first: list[int] = []
        stuck = -1
        for _ in range(ORDERS):
            stuck = self._swept(tastes, extra, rng, first)
            if stuck < 0:
                return self._now().cost(self.instance)
            # Others went in before it and left it no way: it begins.
            first = [stuck, *(one for one in first if one != stuck)]
            legs, departs, taken = begun
            self._legs, self._departs, self._count = legs.copy(), departs.copy(), taken.copy()
        raise ScenarioError(
            f"fleet: truck {stuck} must keep apart from others, and no way was found in which it "
            "does; widen its window"
        )

    def _swept(
        self, tastes: Sequence[Taste], extra: tuple[Ints, Ints] | None,
        rng: np.random.Generator, first: Sequence[int],
    ) -> int:  # fmt: skip
        """Let all trucks respond, some before all others; return one that has no way, else -1."""
        view, count = self._view, self.instance.trucks
        lanes, entered = self._occupied(extra)
        state = draws.started(self._seed, 3, self._calls)
        work, some = desk(view.used, self._width), crew(count, self._width)
        kernel = SWEEP.ready(count * len(tastes) * PLAIN_S)
        for taste in tastes:
            order = rng.permutation(count).astype(np.int64)
            order = order[self._is_free[order]]
            if len(self._apart[1]):
                # Who must keep apart comes first, the one with the least time before others.
                bound = np.diff(self._apart[0]) > 0
                spare = (self.instance.latest - self.instance.earliest).astype(np.float64)
                if first:
                    spare *= rng.uniform(0.5, 1.5, count)
                    spare[list(first)] = np.arange(len(first)) - len(first)
                order = order[np.lexsort((spare[order], ~bound[order]))]
            _, stuck = kernel(
                order, -1e-6, taste, view.used, view.prices, self._costs, lanes,
                self._plan(), entered, work, state, some,
            )  # fmt: skip
            if stuck >= 0:
                return int(stuck)
        return -1

    def _occupied(self, extra: tuple[Ints, Ints] | None = None) -> tuple[Occupancy, Ints]:
        """Return who enters which lane when, and when each pair is entered."""
        view = self._view
        used = np.arange(self._width)[None, :] < self._count[:, None]
        legs, departs = self._legs[used].astype(np.int64), self._departs[used]
        entered = np.full(len(view.which), -1, np.int64)
        entered[legs] = departs
        lane = view.used.lane[legs]
        no_more = np.zeros(0, np.int64)
        for lanes_more, instants in (self._taken, extra or (no_more, no_more)):
            lane, departs = np.append(lane, lanes_more), np.append(departs, instants)
        first = self._row_first
        at, count = np.zeros(first[-1], np.int64), np.zeros(first[-1], np.int64)
        size = np.zeros(self.instance.lanes, np.int64)
        if len(lane):
            order = np.lexsort((departs, lane))
            lane, departs = lane[order], departs[order]
            new = np.concatenate([[True], (np.diff(lane) != 0) | (np.diff(departs) != 0)])
            begin = np.flatnonzero(new)
            own = lane[begin]
            size = np.bincount(own, minlength=self.instance.lanes).astype(np.int64)
            rank = np.arange(len(begin)) - np.searchsorted(own, own)
            at[first[own] + rank] = departs[begin]
            count[first[own] + rank] = np.diff(np.append(begin, len(lane)))
        return Occupancy(first, size, at, count), entered

    def _plan(self) -> Plan:
        return Plan(self._legs, self._departs, self._count, *self._apart)

    def _copied(self) -> tuple[Ints | NDArray[np.int32], Ints, Ints]:
        """Return the plan at hand, in pairs of the instance."""
        pairs = self._view.which[self._legs] if len(self._view.which) else self._legs
        return pairs.astype(np.int32), self._departs.copy(), self._count.copy()

    def _now(self) -> Schedules:
        return self._whole(self._copied())

    def _whole(self, plan: tuple[Ints | NDArray[np.int32], Ints, Ints]) -> Schedules:
        """Return a plan in pairs of the instance as schedules of all trucks."""
        pairs, departs, count = plan
        lanes = (self.instance.pair_lane[pairs] if self.instance.pairs else pairs).astype(np.int32)
        if self._fixed:
            wider = max(0, max(len(own) for own, _ in self._fixed.values()) - lanes.shape[1])
            lanes = np.pad(lanes, ((0, 0), (0, wider)))
            departs = np.pad(departs, ((0, 0), (0, wider)))
            count = count.copy()
            for k, (own, at) in self._fixed.items():
                lanes[k, : len(own)], departs[k, : len(own)], count[k] = own, at, len(own)
        return Schedules(lanes, departs, count)

    def _note(self) -> None:
        """Keep the plan at hand if it is the cheapest."""
        if self._current < self.cost:
            self._kept = self._copied()
            self.cost = self._current

    def _see(self, shares: SharesOf | None, guide: GuideOf | None) -> None:
        """Take other shares, and the pairs that they make worth a look."""
        if self._last is not None and self._last[0] is shares and self._last[1] is guide:
            return
        self._last = (shares, guide)
        old, legs = self._view.which, self._legs
        pairs = old[legs] if len(old) else legs.astype(np.int64)
        self._view = self._viewed(shares, guide, pairs)
        if len(old):
            self._legs = np.maximum(self._view.place[pairs], 0).astype(np.int32)

    def _viewed(
        self, shares: SharesOf | None, guide: GuideOf | None, plan: Ints | None = None
    ) -> _View:
        """Return what moves work on."""
        instance = self.instance
        keep: Marks | None = None
        if shares is not None and guide is not None and not instance.given and instance.pairs:
            part = MARGIN * (1.0 if instance.trucks >= LARGE else 8.0)
            keep = worth_a_look(instance, guide.least, shares.pairs, part)
            for pairs, count in ((plan, self._count), (self._kept[0], self._kept[2])):
                if pairs is not None:
                    used = np.arange(self._width)[None, :] < count[:, None]
                    keep[pairs[used]] = True
        used_now, which = used_pairs(instance, keep)
        place = np.full(instance.pairs, -1, np.int64)
        place[which] = np.arange(len(which))
        none = np.zeros(0, np.int64)
        if shares is None:
            prices = priced(
                used_now, which, none, none, none, np.zeros(1, np.int64), np.zeros(0),
                np.zeros(instance.trucks) if guide is None else guide.cost,
            )  # fmt: skip
        else:
            prices = priced(
                used_now, which, shares.starts, shares.pairs, shares.first_bucket,
                shares.first_share, np.asarray(shares.share, np.float64),
                np.zeros(instance.trucks) if guide is None else guide.cost,
            )  # fmt: skip
        way = np.full((instance.trucks, 1), -1, np.int32)
        way_count = np.zeros(instance.trucks, np.int64)
        if guide is not None:
            way, way_count = self._guided(guide, place)
        return _View(used_now, which, place, prices, way, way_count, shares is not None)

    def _sorted_pairs(self) -> tuple[Ints, Ints]:
        """Return the instance's pairs by truck and lane, and what they are sorted by."""
        instance = self.instance
        if self._order is None:
            key = instance.pair_truck * instance.lanes + instance.pair_lane
            order = np.argsort(key, kind="stable")
            self._order = (order, key[order])
        return self._order

    def _guided(self, guide: GuideOf, place: Ints) -> tuple[NDArray[np.int32], Ints]:
        """Return the pairs of the trucks' cheapest schedules by the shares."""
        instance = self.instance
        order, sorted_key = self._sorted_pairs()
        way = np.full(guide.lanes.shape, -1, np.int32)
        used = np.arange(guide.lanes.shape[1])[None, :] < guide.count[:, None]
        truck = np.repeat(np.arange(instance.trucks), guide.count)
        wanted = truck * instance.lanes + guide.lanes[used].astype(np.int64)
        found = np.minimum(np.searchsorted(sorted_key, wanted), max(len(order) - 1, 0))
        way[used] = np.where(sorted_key[found] == wanted, place[order[found]], -1)
        return np.ascontiguousarray(way), np.ascontiguousarray(guide.count, np.int64)


def _taste(trust: float, crowd: float = 0.0) -> Taste:
    return Taste(trust, 0.0, 0.0, crowd, -1, -1, 0.0)


def _both_ways(count: int, apart: tuple[Ints, Ints] | None) -> tuple[Ints, Ints]:
    """Return who must keep apart from whom, told by either of two."""
    if apart is None:
        return np.zeros(count + 1, np.int64), np.zeros(0, np.int64)
    one = np.repeat(np.arange(count, dtype=np.int64), np.diff(apart[0]))
    pairs = np.unique(np.concatenate([one * count + apart[1], apart[1] * count + one]))
    first = np.searchsorted(pairs // count, np.arange(count + 1)).astype(np.int64)
    return first, pairs % count
