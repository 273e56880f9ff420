"""The lower bound on a fleet's costs, which rises step by step.

Rounds alternate: steps of ascent over the shares of the listed pairs; an evaluation over all pairs,
in which an unlisted one costs the least that it may, so that the bound holds; and new pairs, those
that cheapest schedules used, or smaller buckets. Routes given, all pairs are listed from the start;
routes free, those of the routes alone, and those whose windows overlap no other.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from .ascent import Volume
from .buckets import Buckets, Clock, bucketed, inherited
from .crews import Crew
from .projecting import projected
from .searching import Searching
from .shares import Shares
from .splitting import cuts_of
from .stabbing import first_shares
from .ways import ways_of
from .whole import whole_shares

__all__ = ["ROUNDING", "Bound", "Guide"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

LISTING_ROUNDS = 4
"""Rounds that list pairs before buckets are cut."""

FIRST_STEPS, LISTING_STEPS, LEAST_STEPS, MOST_STEPS = 80, 30, 80, 240
"""Steps of the first round, of one that lists pairs, and of others at least and at most."""

LOOK = 40
"""Steps between two looks at what was gained."""

ENOUGH = 0.03
"""A round ends if less than this part of what is missing was gained between two looks."""

PART, LEAST_PART, AGAIN = 0.5, 0.05, 1.5
"""The part of a step that the ascent begins with; rounds that go on with an average begin with so
many times what the round before ended with, but neither with less nor with more."""

MANY_PAIRS = 100_000
"""From so many pairs on rounds that list pairs, too, go on with the average of the round before."""

FIRST_WEIGHT, WEIGHT, KEPT_WEIGHT = 0.1, 0.07, 0.02
"""What the next schedules weigh in the average: in the first round, in others that begin it anew,
and in those that go on with it."""

PATIENCE = 8
"""Failures in a row before steps shrink."""

FINE_WEIGHT, FINE_PATIENCE = 0.002, 20
"""The same of an ascent that goes on where that one jams: see `Bound.improve`."""

LOOSENED = 0.002
"""It begins with so much of each price shared evenly, for from a corner steps lead nowhere."""

EARLY_ROUNDS = 2
"""Rounds in which shares still change much, those that list pairs not counted."""

BEYOND_EARLY, BEYOND = 0.007, 0.02
"""The part of the savings by which steps aim beyond the best at least, for a target too near jams:
in the first rounds, when shares that rise too fast have to fall again, and later."""

FARTHEST = 0.06
"""The part of the savings by which they aim beyond the best at most: while no plan is known nothing
else tells how far shares may rise, and steps that aim too far fail."""

BEYOND_FOR_LEADERS = 0.2
"""By how much more where leaders save as much as others; less in proportion where they save less.
Plans lie further below the linear program there, so that the best plan is too near as a target."""

ROUNDING = 1e-9
"""The part by which the bound is lowered for rounding in sums; `certified` is exact."""


@dataclass(frozen=True, slots=True, eq=False)
class Guide:
    """What the bound tells the search for a plan.

    Attributes
    ----------
    least : ndarray of float64, (P,)
        The least share of each pair over its window [grains].
    cost : ndarray of float64, (N,)
        What each truck's cheapest schedule costs [grains].
    lanes : ndarray of int32, (N, w)
        Its lanes.
    departs : ndarray of int64, (N, w)
        When it enters them [ticks].
    count : ndarray of int64, (N,)
        How many lanes it has.
    """

    least: Floats
    cost: Floats
    lanes: NDArray[np.int32]
    departs: Ints
    count: Ints


class Bound:
    """A lower bound on what the plans of a fleet cost.

    Parameters
    ----------
    instance : Instance
        The fleet's problem.
    threads : int
        Cores to use; the answer does not depend on it.
    seed : int
        Of draws, of which there are none so far.

    Attributes
    ----------
    shares : Shares
        The best found.
    cost : float
        The bound that they give [grains].
    guide : Guide
        What they tell the search for a plan.
    settled : bool
        Whether nothing more is to be gained.
    """

    def __init__(self, instance: Instance, threads: int = 1, seed: int = 0) -> None:
        self._instance, self._threads, self._seed = instance, threads, seed
        self._clock = Clock.of(instance)
        self._every = ways_of(instance, np.arange(instance.pairs))
        self._cuts = np.empty(0, np.int64)
        led, saved = instance.leader_saves.sum(), (instance.alone - instance.member).sum()
        self._for_leaders = BEYOND_FOR_LEADERS * float(led) / max(float(saved), 1.0)
        self._round, self._stale, self._fine = 0, 0, False
        self.settled = False
        self.cost = -np.inf
        self._listed = _first_pairs(instance)
        self._buckets = bucketed(instance, self._clock, self._listed, self._cuts)
        with Crew(threads) as crew:
            share = first_shares(instance, self._buckets)
            self._evaluate(share, crew)
            self._start(share, crew)

    def improve(
        self, target: float, steps: int, stop: Callable[[], bool], fine: bool = False
    ) -> None:
        """Raise the bound.

        Parameters
        ----------
        target : float
            What the best plan costs [grains].
        steps : int
            About how many steps to take.
        stop : callable
            Is asked before each step whether to end.
        fine : bool
            Whether to go on from now on where the usual ascent jams. The bound ends higher then,
            but its shares guide the search for a plan less well (docs/fleets-bound.md).
        """
        alone = float(self._instance.alone_cost.sum())
        target = min(target, alone)
        with Crew(self._threads) as crew:
            if fine and not self._fine:
                self._next(crew, target)
                self._fine, self.settled, self._stale = True, False, 0
                share = _loosened(self._buckets, self._volume.shares, self._instance.largest)
                self._start(share, crew, self._volume.average, self._volume.part)
            fresh = False
            for _ in range(steps):
                if self.settled or stop():
                    break
                best = self._volume.best
                near = min(target, best + FARTHEST * (alone - best))
                self._volume.step(crew, max(near, best + self._beyond * (alone - best)))
                self._steps += 1
                fresh = True
                if self._steps % LOOK == 0 and self._round >= LISTING_ROUNDS:
                    self._gather()
                if self._ended(target, near):
                    self._next(crew, target)
                    fresh = False
            if fresh:
                self._evaluate(self._volume.shares, crew)

    def certified(self) -> tuple[Shares, int]:
        """Return whole shares, and the bound that they give, exactly.

        Returns
        -------
        shares : Shares
            Rounded down so that they are valid in whole numbers.
        cost : int
            What the trucks' cheapest schedules cost together under them, searched anew without
            shortcuts [grains].
        """
        own = self._best
        share = whole_shares(own, self.shares.share, self._instance)
        searching = Searching(
            self._instance, own, share.astype(np.float64), every=True, ways=self._every
        )
        with Crew(self._threads) as crew:
            searching.search(crew, pruned=False)
        # Whole numbers below 2^53 are exact in double precision, and so are their sums.
        return _shares(own, share), int(searching.routes.cost.astype(np.int64).sum())

    def _start(
        self, share: Floats, crew: Crew, average: Floats | None = None, part_before: float = PART
    ) -> None:
        """Begin a round with buckets that were made anew."""
        searching = Searching(self._instance, self._buckets, share)
        if average is None:
            part, weight = PART, FIRST_WEIGHT if self._round == 0 else WEIGHT
        else:
            part = min(max(AGAIN * part_before, LEAST_PART), PART)
            weight = FINE_WEIGHT if self._fine else KEPT_WEIGHT
        self._volume = Volume(
            self._buckets, searching, self._instance.largest,
            part=part, weight=weight, before=average,
            patience=FINE_PATIENCE if self._fine else PATIENCE,
        )  # fmt: skip
        self._volume.begin(crew)
        self._steps, self._looked = 0, self._volume.best

    def _ended(self, target: float, near: float) -> bool:
        """Tell whether a round has done what it can; steps aim at `near`."""
        if target - self._volume.best <= 1e-9 * abs(target):
            return True
        if self._listing:
            return self._steps >= (FIRST_STEPS if self._round == 0 else LISTING_STEPS)
        if self._steps % LOOK:
            return False
        gained, self._looked = self._volume.best - self._looked, self._volume.best
        if self._steps >= MOST_STEPS:
            return True
        alone = float(self._instance.alone_cost.sum())
        missing = max(near - self._volume.best, self._beyond * (alone - self._volume.best))
        return self._steps >= LEAST_STEPS and gained < ENOUGH * missing

    @property
    def _beyond(self) -> float:
        """The part of the savings by which steps aim beyond the best at least."""
        return self._for_leaders + (BEYOND_EARLY if self._early else BEYOND)

    @property
    def _early(self) -> bool:
        """Whether shares still change much."""
        listing = 0 if self._instance.given else LISTING_ROUNDS
        return self._round < listing + EARLY_ROUNDS

    @property
    def _listing(self) -> bool:
        """Whether rounds are short, for many pairs are not listed yet."""
        return self._round < LISTING_ROUNDS and len(self._listed) < self._instance.pairs

    def _next(self, crew: Crew, target: float) -> None:
        """End a round: evaluate, list pairs and cut buckets, and begin the next."""
        before = self.cost
        share = self._volume.shares
        used = self._evaluate(share, crew)
        listed = np.union1d(self._listed, used)
        cuts = self._cuts
        if self._round >= LISTING_ROUNDS or len(listed) == len(self._listed):
            self._gather()
            cuts = np.union1d(cuts, self._gathered)
        self._gathered = np.empty(0, np.int64)
        buckets = bucketed(
            self._instance, self._clock, listed, np.union1d(cuts, self._buckets.keys)
        )
        self._stale = self._stale + 1 if self.cost - before <= 1e-4 * (target - self.cost) else 0
        same = buckets.shares == self._buckets.shares
        self.settled = target - self.cost <= 1e-9 * abs(target) or (same and self._stale >= 3)
        unlisted = -self._instance.leader_saves[self._instance.pair_lane[listed]]
        average, many = None, self._instance.pairs >= MANY_PAIRS
        if many or self._round + 1 >= LISTING_ROUNDS or len(listed) == self._instance.pairs:
            # Where schedules led before is where they lead at first: the average goes on.
            none = np.zeros(len(unlisted), np.float64)
            average = inherited(self._buckets, self._volume.average, buckets, none)
        share = inherited(self._buckets, share, buckets, unlisted.astype(np.float64))
        if len(listed) > len(self._listed):
            # What pairs that were not listed left unused is handed out.
            projected(
                share, buckets.first_member, buckets.entry, buckets.extra, buckets.leader,
                self._instance.largest,
            )  # fmt: skip
        self._listed, self._buckets, self._cuts = listed, buckets, cuts
        self._round += 1
        self._start(share, crew, average, self._volume.part)

    _gathered: Ints = np.empty(0, np.int64)

    def _gather(self) -> None:
        """Keep where the schedules found last would cut buckets."""
        new = cuts_of(self._clock, self._buckets, self._volume.searching)
        self._gathered = np.union1d(self._gathered, new)

    def _evaluate(self, share: Floats, crew: Crew) -> Ints:
        """Work out the bound over all pairs, keep it if it is the best, and return pairs in use."""
        assert np.isfinite(share).all(), "shares are finite"
        own = self._buckets
        searching = Searching(self._instance, own, share, every=True, ways=self._every)
        value = searching.search(crew) * (1.0 - ROUNDING)
        if value > self.cost or not np.isfinite(self.cost):
            self.cost, self._best = value, own
            self.shares = _shares(own, share)
            self.guide = _guide(searching)
        return searching.used()


def _first_pairs(instance: Instance) -> Ints:
    """Return the pairs to list first."""
    if instance.given:
        return np.arange(instance.pairs)
    order = np.lexsort((instance.opens, instance.pair_lane))
    lane, opens = instance.pair_lane[order], instance.opens[order]
    # The last closing of those before, lane by lane: lanes are set so far apart that none reach.
    apart = int(instance.closes.max() - instance.opens.min()) + 2 if instance.pairs else 0
    reach = np.maximum.accumulate(instance.closes[order] + lane * apart)
    meets = np.zeros(instance.pairs, np.bool_)
    late = opens[1:] + lane[1:] * apart <= reach[:-1]
    meets[1:] |= late
    meets[:-1] |= late
    lone = np.empty(instance.pairs, np.bool_)
    lone[order] = ~meets
    return np.flatnonzero(instance.on_alone | lone)


def _loosened(buckets: Buckets, share: Floats, largest: int) -> Floats:
    """Return valid shares a little nearer to even ones."""
    members = np.diff(buckets.first_member)
    even = np.empty(buckets.shares)
    even[buckets.entry] = np.repeat(buckets.extra / np.maximum(members, 1), members)
    loosened = (1.0 - LOOSENED) * share + LOOSENED * even
    # Even shares leave some of a price unused where leaders save or platoons are limited.
    projected(
        loosened, buckets.first_member, buckets.entry, buckets.extra, buckets.leader, largest
    )  # fmt: skip
    return loosened


def _shares(buckets: Buckets, share: Floats | Ints) -> Shares:
    return Shares(
        lane_first=buckets.lane_first, starts=buckets.starts, pairs=buckets.pairs,
        first_bucket=buckets.first_bucket, first_share=buckets.first_share, share=share,
    )  # fmt: skip


def _guide(searching: Searching) -> Guide:
    least = np.minimum.reduceat(searching.share, searching.prices.first_share[:-1])
    lanes, departs, count = searching.schedules()
    return Guide(least, searching.routes.cost, lanes, departs, count)
