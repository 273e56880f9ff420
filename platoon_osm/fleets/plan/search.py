"""The search for the best plan of a whole fleet.

A plan is made by sweeps of responses, then bettered by neighbourhoods, a round after the other. The
sets of trucks of a round never meet, and each has random numbers of its own. So the answer depends
on the seed and the number of moves, and not on the number of threads.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from .at_hand import AtHand
from .desk import Taste
from .fixed import FixedWays
from .guidance import GuideOf, SharesOf
from .habits import LARGE, habits_of
from .insertion import meeting_points
from .schedules import Schedules
from .slabs import explored, slabs
from .sweeps import plain_taste, sweeps

__all__ = ["FleetSearch"]

Ints = NDArray[np.int64]


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
        self._points = (np.zeros(0, np.int64), np.zeros(0, np.int64))
        if instance.trucks >= LARGE:
            self._points = meeting_points(instance)
        self._at = AtHand(instance, _both_ways(instance.trucks, apart), fixed, self._points[0])
        self._hot = _temperature(instance, habits_of(instance.trucks).hot)
        self._calls = 0
        self._current = self._swept([plain_taste(0.0)])
        self._kept = self._at.copied()
        self.cost = self._current

    @property
    def best(self) -> Schedules:
        """The cheapest plan so far."""
        return self._at.whole(self._kept)

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
        at = self._at
        at.see(shares, guide, self._kept)
        before = (at.legs.copy(), at.departs.copy(), at.count.copy(), self._current)
        trust = 1.0 if at.view.trusted else 0.0
        plain = [plain_taste(trust), plain_taste(0.0), plain_taste(0.0), plain_taste(0.0)]
        ways: list[tuple[list[Taste], list[Taste]]] = [([], plain)]
        if at.large:
            fading = [plain_taste(0.0, 1.0 - step / 3.0) for step in (1, 2, 3)]
            ways.append(([plain_taste(0.0, 1.0), plain_taste(0.0, 1.0)], fading))
        found = None
        for prepared, tastes in ways:
            self._calls += 1
            at.count[:] = 0
            if prepared:
                self._swept(prepared, self._points)
            cost = self._swept(tastes)
            if found is None or cost < found[3]:
                found = (at.legs.copy(), at.departs.copy(), at.count.copy(), cost)
        if found is None or found[3] > before[3]:
            found = before
        at.legs, at.departs, at.count, self._current = found
        self._note()

    def take(self, lanes: Sequence[Ints], departs: Sequence[Ints]) -> None:
        """Go on from a plan that was made elsewhere, if it is the cheapest so far.

        Parameters
        ----------
        lanes, departs : sequence of ndarray of int64, (N, ...)
            Lanes of each truck in driving order, and when it enters them [ticks].
        """
        kept = self._at.kept_of(lanes, departs)
        cost = self._at.whole(kept).cost(self.instance)
        if cost >= self.cost:
            return
        self._kept, self.cost, self._current = kept, cost, cost
        self._at.take(kept)

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
        if not self._at.is_free.any() or self.instance.pairs == 0:
            return
        self._calls += 1
        self._at.see(shares, guide, self._kept)
        sets = self._slabs()
        each = -(-moves // len(sets))
        temperature = self._hot * heat * heat

        def work(number: int) -> int:
            stream = (self._seed, self._calls, number)
            return explored(self._at, sets[number], each, temperature, stream, stop)

        if self._threads > 1 and len(sets) > 1:
            with ThreadPoolExecutor(min(self._threads, len(sets))) as pool:
                changes = list(pool.map(work, range(len(sets))))
        else:
            changes = [work(number) for number in range(len(sets))]
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
        before = self._at.fixed
        self._at.fix(fixed)
        cost = self.best.cost(self.instance)
        if cost >= self.cost and not always:
            self._at.fix(before)
            return False
        # The plan at hand goes on beside the new ways.
        self.cost, self._current = cost, self._now().cost(self.instance)
        self._note()
        return True

    def _slabs(self) -> list[Ints]:
        """Return trucks that may be moved, in sets that never meet."""
        every = np.flatnonzero(self._at.is_free)
        return slabs(self.instance, every, self._seed, self._calls)

    def _swept(self, tastes: Sequence[Taste], extra: tuple[Ints, Ints] | None = None) -> int:
        """Let all trucks respond, once for each taste; return what the plan costs then."""
        return sweeps(self._at, tastes, self._seed, self._calls, extra)

    def _now(self) -> Schedules:
        """Return the plan at hand."""
        return self._at.whole(self._at.copied())

    def _note(self) -> None:
        """Keep the plan at hand if it is the cheapest."""
        if self._current < self.cost:
            self._kept = self._at.copied()
            self.cost = self._current


def _temperature(instance: Instance, hot: float) -> float:
    """Return the highest temperature [grains], `hot` of what a mean trip could save."""
    savings = np.zeros(instance.lanes)
    paid = instance.alone > 0
    savings[paid] = 1 - instance.member[paid] / instance.alone[paid]
    mean = float(savings[paid].mean()) if paid.any() else 0.0
    per_trip = float(instance.alone_cost.mean()) if instance.trucks else 0.0
    return hot * mean * per_trip


def _both_ways(count: int, apart: tuple[Ints, Ints] | None) -> tuple[Ints, Ints]:
    """Return who must keep apart from whom, told by either of two."""
    if apart is None:
        return np.zeros(count + 1, np.int64), np.zeros(0, np.int64)
    one = np.repeat(np.arange(count, dtype=np.int64), np.diff(apart[0]))
    pairs = np.unique(np.concatenate([one * count + apart[1], apart[1] * count + one]))
    first = np.searchsorted(pairs // count, np.arange(count + 1)).astype(np.int64)
    return first, pairs % count
