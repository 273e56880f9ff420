"""How likely the merges of a plan succeed if vehicles are late, and what is left of its saving.

A merge has a gain G: what all would pay more if it were missed and all else went as planned. The
others can wait for the movers as long as each of them still arrives within its own limits, and a
mover for the others likewise; waits that are planned later on the way are room as well. A second's
waiting costs all who wait: the objective's price of waiting, and that of delay for those who name
an earliest departure. How long to wait follows from these (`chance/giving_up.py`).

Where one vehicle joins one and neither had company before, chance and expected wait are closed
forms. Later merges depend on earlier ones; for them days are drawn at random, with a seed, and
played through the plan (`late_days.py`), and the best wait is that of the days drawn. The expected
saving is always counted on these days, and told in closed form too where all merges have one, no
vehicle has two of them and delay has no price.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ..chance.delays import Delays
from ..chance.gaps import Gap, gap_of
from ..chance.giving_up import counted_wait_s, last_to_come_s, wait_up_to_s
from ..chance.simulated import check_runs
from ..costs.objective import Objective
from ..costs.time_prices import TimePrices
from ..costs.weights import EdgeWeights
from ..errors import ScenarioError
from ..kinds import kind_of
from ..plans.chances import Chances, MeetingChance
from ..plans.plan import Plan
from ..plans.standing import rested_s
from ..plans.timetable import VehicleTimes
from .course import Course, Merge, course_of
from .late_days import LateDays, played
from .timing.limits import PATIENCE_MIN

__all__ = ["RUNS", "DelaysSimulated", "simulate_delays", "with_chances"]

Floats = NDArray[np.float64]

RUNS = 10_000
"""Days drawn for a plan of a few vehicles."""
MOST_NUMBERS = 20_000_000
"""Fewer days are drawn where one array of them would hold more."""
FEWEST_RUNS = 200


@dataclass(frozen=True, slots=True, eq=False)
class DelaysSimulated:
    """What came of days on which vehicles of a plan were late.

    Attributes
    ----------
    chances : Chances
        For the record of the plan.
    saved : ndarray of float, (runs,)
        What the plan saved on each day, waiting and delay at their prices, in its unit.
    met : ndarray of bool, (merges, runs)
        Which merges succeeded, in the order of `chances.meetings`.
    late_s : ndarray of float, (N, runs)
        By how much each vehicle came after its latest arrival [s]; 0 if it named none.
    waited_s : ndarray of float, (N, runs)
        How long each waited for others on the road [s].
    """

    chances: Chances
    saved: Floats
    met: NDArray[np.bool_]
    late_s: Floats
    waited_s: Floats

    @property
    def in_time(self) -> Floats:
        """How often each vehicle arrived in time, (N,)."""
        found: Floats = np.mean(self.late_s <= 0, axis=1)
        return found


def simulate_delays(
    plan: Plan,
    delays: Delays,
    *,
    runs: int = RUNS,
    seed: int = 0,
    objective: Objective | EdgeWeights | None = None,
) -> DelaysSimulated:
    """Play days on which vehicles are late through a plan.

    Parameters
    ----------
    plan : Plan
        With a timetable.
    delays : Delays
        How late its vehicles may be.
    runs : int
        How many days.
    seed : int
        Of numpy's generator; the same gives the same days.
    objective : Objective or EdgeWeights, optional
        Whose prices of waiting and delay count; without it both are free.

    Returns
    -------
    DelaysSimulated
        Chances of the merges, and what is left of the saving.

    Raises
    ------
    ScenarioError
        A plan without times, no delays, or no whole numbers of runs and seed.
    """
    if not isinstance(delays, Delays):
        raise ScenarioError(f"delays: {kind_of(delays)} given; make it Delays(spread_min)")
    check_runs(runs, seed)
    prices = TimePrices() if objective is None else TimePrices.of(objective)
    return _Simulation(plan, delays, prices, runs, seed).told()


def with_chances(
    plan: Plan, delays: Delays, objective: Objective | EdgeWeights, seed: int = 0
) -> Plan:
    """Return a plan with the chances of its merges; the plan itself if it has no times.

    Parameters
    ----------
    plan : Plan
        Any.
    delays : Delays
        How late its vehicles may be.
    objective : Objective or EdgeWeights
        Whose prices of waiting and delay count.
    seed : int
        Of the days drawn.

    Returns
    -------
    Plan
        The same with `chances`.
    """
    if plan.timetable is None:
        return plan
    runs = runs_for(plan)
    found = simulate_delays(plan, delays, runs=runs, seed=seed, objective=objective)
    return replace(plan, chances=found.chances)


def runs_for(plan: Plan, most: int = RUNS) -> int:
    """Return how many days are drawn for a plan.

    Parameters
    ----------
    plan : Plan
        Any.
    most : int
        For a plan of a few vehicles.

    Returns
    -------
    int
        Fewer for plans of many vehicles, and for large platoons.
    """
    largest = max(len(stretch.vehicles) for stretch in plan.stretches)
    numbers = max(len(plan.trips), largest**2)
    return max(FEWEST_RUNS, min(most, MOST_NUMBERS // numbers))


@dataclass(slots=True)
class _Told:
    """What is known of a merge once it was played."""

    window_s: float
    wait_s: float
    early_s: float
    gap: Gap | None


@dataclass(slots=True)
class _Simulation:
    """Days drawn for one plan."""

    plan: Plan
    delays: Delays
    prices: TimePrices
    runs: int
    seed: int
    course: Course = field(init=False)
    quiet: LateDays = field(init=False)
    told_of: dict[int, _Told] = field(default_factory=dict)

    def told(self) -> DelaysSimulated:
        """Return what came of all days."""
        plan = self.plan
        self.course = course_of(plan)
        merges = self.course.merges
        count = len(merges)
        # First a day on which nobody is late, then one for each merge on which only that is missed.
        missed = np.concatenate([np.zeros((count, 1), bool), np.eye(count, dtype=bool)], axis=1)
        still = np.zeros((len(plan.trips), 1 + count))
        self.quiet = played(plan, self.course, still, missed=missed)
        names = [trip.vehicle for trip in plan.trips]
        late = self.delays.draws(names, self.runs, self.seed).T
        days = played(plan, self.course, late, self._waits)
        saved = self._saved(days, late)
        planned = float(self._saved(self.quiet, still)[0])
        meetings = tuple(self._meeting(k, merge, days) for k, merge in enumerate(merges))
        runs = len(saved)
        error = float(saved.std(ddof=1)) / math.sqrt(runs) if runs > 1 else 0.0
        chances = Chances(
            self.delays.kind, self.seed, runs, meetings, planned, float(saved.mean()), error,
            self._closed_form(planned, meetings),
        )  # fmt: skip
        met = np.array([days.met[merge.event] for merge in merges])
        latest = [own.latest_arrival_s for own in self._times]
        limits = np.array([math.inf if at is None else at for at in latest])
        over = np.maximum(days.arrival_s - limits[:, None], 0.0)
        return DelaysSimulated(chances, saved, met.reshape(count, runs), over, days.waited_s)

    @property
    def _times(self) -> tuple[VehicleTimes, ...]:
        assert self.plan.timetable is not None
        return self.plan.timetable.vehicles

    def _saved(self, days: LateDays, late: Floats) -> Floats:
        """Return what is saved day by day; who drives alone is as late by itself."""
        saved: Floats = self.plan.solo_cost - days.paid.sum(axis=0)
        if self.prices.waiting:
            saved = saved - self.prices.waiting * days.waited_s.sum(axis=0)
        if self.prices.delay:
            for k, own in enumerate(self._times):
                if own.earliest_departure_s is not None:
                    alone = own.earliest_departure_s + self._alone_s(k)
                    over = np.maximum(days.arrival_s[k] - late[k] - alone, 0.0)
                    saved = saved - self.prices.delay * over
        return saved

    def _gain(self, place: int, vehicles: Sequence[int] | None = None) -> float:
        """Return what some, or all, pay more if a merge is missed."""
        paid = self.quiet.paid if vehicles is None else self.quiet.paid[list(vehicles)]
        return float(paid[:, 1 + place].sum() - paid[:, 0].sum())

    def _window(self, merge: Merge, vehicles: Sequence[int]) -> float:
        """Return how long all of some vehicles can wait at a merge within their limits."""
        room = math.inf
        for k in vehicles:
            waits = self.quiet.waited_s[k, 0] - self.quiet.waited_before_s[merge.event][k]
            room = min(room, self._limit(k) - self.quiet.arrival_s[k, 0] + waits)
        return max(float(room), 0.0)

    def _limit(self, vehicle: int) -> float:
        """Return when a vehicle is there at the latest, by its trip or its patience."""
        own = self._times[vehicle]
        if own.latest_arrival_s is not None:
            return float(own.latest_arrival_s)
        assert self.plan.timetable is not None
        until = self.plan.timetable.patient_until_s(vehicle, self._alone_s(vehicle))
        if until is None:
            patience = self.plan.timetable.patience_s
            until = own.arrival_s + (60.0 * PATIENCE_MIN if patience is None else patience)
        return float(until)

    def _alone_s(self, vehicle: int) -> float:
        """Return how long a vehicle takes alone, with as much rest as it has in the plan [s]."""
        return self.plan.trips[vehicle].alone.time_s + rested_s(self._times[vehicle])

    def _price(self, vehicles: Sequence[int]) -> float:
        """Return what a second's waiting costs some vehicles."""
        named = sum(self._times[k].earliest_departure_s is not None for k in vehicles)
        return self.prices.waiting * len(vehicles) + self.prices.delay * named

    def _waits(self, merge: Merge, gaps_s: Floats) -> tuple[float, float]:
        """Return how long the others wait for the movers, and a mover for them."""
        place = [one.event for one in self.course.merges].index(merge.event)
        gain = self._gain(place)
        sides = (merge.others, merge.movers)
        windows = [self._window(merge, side) for side in sides]
        prices = [self._price(side) for side in sides]
        gap: Gap | None = None
        if merge.is_first:
            mover, host = (self.plan.trips[k].vehicle for k in (merge.movers[0], merge.host))
            gap = gap_of(self.delays, mover, host, float(self.quiet.gaps_s[merge.event][0]))
            gap = gap if gap.spread_s else None
        if gap is None:
            counted = (gaps_s, -gaps_s)
            wait, early = (
                counted_wait_s(some, window, gain, price)
                for some, window, price in zip(counted, windows, prices, strict=True)
            )
        else:
            wait, early = (
                min(wait_up_to_s(one, window, gain, price), last_to_come_s(one, window))
                if price > 0
                else wait_up_to_s(one, window, gain, price)
                for one, window, price in zip((gap, gap.turned()), windows, prices, strict=True)
            )
        self.told_of[merge.event] = _Told(windows[0], wait, early, gap)
        return wait, early

    def _meeting(self, place: int, merge: Merge, days: LateDays) -> MeetingChance:
        event, told = merge.event, self.told_of[merge.event]
        gaps, gap = days.gaps_s[event], told.gap
        if gap is None:
            mean, spread = float(gaps.mean()), float(gaps.std())
            chance, wait = float(days.met[event].mean()), float(days.waits_s[event].mean())
        else:
            mean, spread = gap.mean_s, gap.spread_s
            chance = max(gap.by(told.wait_s) - gap.by(-told.early_s), 0.0)
            wait = gap.expected_wait_s(told.wait_s) + gap.turned().expected_wait_s(told.early_s)
        # If it just comes when the others leave it is later than planned by so much.
        behind = max(told.wait_s - float(self.quiet.gaps_s[event][0]), 0.0)
        late = 0.0
        for k in merge.movers:
            latest = self._times[k].latest_arrival_s
            if latest is not None:
                late = max(late, float(self.quiet.arrival_s[k, 1 + place]) + behind - latest)
        return MeetingChance(
            event, chance, mean, spread, wait, told.window_s, told.wait_s, self._gain(place),
            self._gain(place, merge.movers), told.early_s, late,
        )  # fmt: skip

    def _closed_form(self, planned: float, meetings: Sequence[MeetingChance]) -> float | None:
        """Return the expected saving where merges do not depend on each other."""
        merges = self.course.merges
        who = [k for merge in merges for k in (*merge.movers, *merge.others)]
        closed = all(self.told_of[merge.event].gap is not None for merge in merges)
        if self.prices.delay or not closed or len(who) != len(set(who)):
            return None
        found = planned + self.prices.waiting * float(self.quiet.waited_s[:, 0].sum())
        for one in meetings:
            found -= (1 - one.chance) * one.gain + self.prices.waiting * one.expected_wait_s
        return found
