"""Days on which vehicles are late, played through a plan: who meets whom, and what it costs.

Each vehicle leaves as planned and is late by its delay from then on. Where a stretch begins with a
merge, with T_o and T_m when the others and a mover come there,

    they meet iff -w_m <= T_m - T_o <= w_o,

where w_o is how long the others wait for the movers and w_m how long a mover waits for them; nobody
knows beforehand how late the other is. The platoon leaves when the last who meets is there; others
who wait in vain leave at T_o + w_o. Who misses a merge drives its planned road by itself, or with
those it came with, until it is to merge again. So what is late is late at the next merge, too.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..plans.plan import Plan
from .course import AT_ORIGIN, Course, Merge, Step
from .partial_company import paid_on

__all__ = ["LateDays", "WaitRule", "always_wait", "played"]

Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]

WaitRule = Callable[[Merge, Floats], tuple[float, float]]
"""How long the others wait for the movers of a merge, and a mover for them [s], given by how much
the last mover comes later than they, day by day [s]."""


def always_wait(merge: Merge, gaps_s: Floats) -> tuple[float, float]:
    """Return that everybody waits for everybody.

    Parameters
    ----------
    merge : Merge
        Any.
    gaps_s : ndarray of float, (runs,)
        Any.

    Returns
    -------
    tuple of float, (2,)
        For ever [s].
    """
    del merge, gaps_s
    return np.inf, np.inf


@dataclass(slots=True, eq=False)
class LateDays:
    """What came of days on which vehicles were late.

    Attributes
    ----------
    paid : ndarray of float, (N, runs)
        What each vehicle paid for driving, in the unit of the plan.
    waited_s : ndarray of float, (N, runs)
        How long each waited for others on the road [s].
    arrival_s : ndarray of float, (N, runs)
        When each arrived [s].
    gaps_s : dict of int to ndarray of float, (runs,)
        By event, by how much the last mover came later than the others [s].
    met : dict of int to ndarray of bool, (runs,)
        By event, whether all met.
    waits_s : dict of int to ndarray of float, (runs,)
        By event, how long whoever was there first waited [s].
    waited_before_s : dict of int to ndarray of float, (N,)
        By event, how long each vehicle had waited before the merge on the first day [s].
    """

    paid: Floats
    waited_s: Floats
    arrival_s: Floats
    gaps_s: dict[int, Floats]
    met: dict[int, Marks]
    waits_s: dict[int, Floats]
    waited_before_s: dict[int, Floats]


def played(
    plan: Plan,
    course: Course,
    delays_s: Floats,
    wait_rule: WaitRule = always_wait,
    missed: Marks | None = None,
) -> LateDays:
    """Play days through a plan.

    Parameters
    ----------
    plan : Plan
        With a timetable.
    course : Course
        Of the plan.
    delays_s : ndarray of float, (N, runs)
        How late each vehicle is [s].
    wait_rule : callable
        How long who is there first waits.
    missed : ndarray of bool, (merges, runs), optional
        Merges of `course.merges` that are missed whatever happens, without any waiting.

    Returns
    -------
    LateDays
        All days at once.
    """
    return _Play(plan, course, delays_s, wait_rule, missed).days()


class _Play:
    """The state of all days at once: where vehicles are when, and with whom."""

    def __init__(
        self,
        plan: Plan,
        course: Course,
        delays_s: Floats,
        wait_rule: WaitRule,
        missed: Marks | None,
    ) -> None:
        self.plan, self.course, self.wait_rule = plan, course, wait_rule
        shape = delays_s.shape
        self.end = np.asarray(course.departures_s)[:, None] + delays_s
        self.label = np.repeat(np.arange(shape[0])[:, None], shape[1], axis=1)
        self.missed = {
            merge.event: None if missed is None else missed[k]
            for k, merge in enumerate(course.merges)
        }
        zeros = np.zeros(shape)
        self.found = LateDays(zeros, zeros.copy(), self.end, {}, {}, {}, {})

    def days(self) -> LateDays:
        """Return what came of all days."""
        for step in self.course.steps:
            some = list(step.vehicles)
            ready = self.end[some] + np.array(step.stands_s)[:, None]
            ready = np.maximum(ready, np.array(step.not_before_s)[:, None])
            start = ready if len(some) == 1 else self._together(step, ready)
            self.found.waited_s[some] += start - ready
            paid = paid_on(self.plan.stretches[step.stretch], self.label[some])
            for vehicle, cost in zip(some, paid, strict=True):
                self.found.paid[vehicle] += cost
            self.end[some] = start + step.drive_s
        return self.found

    def _together(self, step: Step, ready: Floats) -> Floats:
        """Return when each vehicle of a company starts, and note who drives with whom."""
        some = list(step.vehicles)
        place = {vehicle: k for k, vehicle in enumerate(some)}
        came_with = self._came_with(step)
        start = np.stack([np.where(own, ready, -np.inf).max(axis=0) for own in came_with])
        for merge in step.merges:
            self._merge(step, merge, place, came_with, start)
        return start

    def _came_with(self, step: Step) -> NDArray[np.bool_]:
        """Return who comes there together, (k, k, runs)."""
        label, before = self.label[list(step.vehicles)], np.array(step.before)
        same = label[:, None, :] == label[None, :, :]
        near = (before[:, None] == before[None, :]) & (before != AT_ORIGIN)[:, None]
        near |= np.eye(len(before), dtype=bool)
        if not step.merges:  # no merge is told, so who starts there does so together
            near |= (before == AT_ORIGIN)[:, None] | (before == AT_ORIGIN)[None, :]
            same |= near[:, :, None] & (before == AT_ORIGIN)[:, None, None]
        found: NDArray[np.bool_] = same & near[:, :, None]
        return found

    def _merge(
        self,
        step: Step,
        merge: Merge,
        place: dict[int, int],
        came_with: NDArray[np.bool_],
        start: Floats,
    ) -> None:
        """Let movers join who is there with the host; `start` is when each is there."""
        host = place[merge.host]
        movers = [place[k] for k in merge.movers]
        event, forced = merge.event, self.missed[merge.event]
        # Others who missed an earlier merge stay by themselves.
        joined = came_with[host].copy()
        came = start[host].copy()
        gap = start[movers] - came
        waits, early = self.wait_rule(merge, gap.max(axis=0))
        meets = (gap <= waits) & (gap >= -early)
        vain, gives_up = (gap > waits).any(axis=0), gap < -early
        if forced is not None:
            meets, vain, gives_up = meets & ~forced, vain & ~forced, gives_up & ~forced
        leaves = np.maximum(came, np.where(meets, start[movers], -np.inf).max(axis=0))
        leaves = np.where(vain, np.maximum(leaves, came + waits), leaves)
        found = self.found
        found.gaps_s[event] = gap.max(axis=0)
        found.waited_before_s[event] = found.waited_s[:, 0].copy()
        found.met[event] = meets.all(axis=0)
        found.waits_s[event] = leaves - came + np.clip(-gap, 0.0, early).max(axis=0)
        for k, mover in enumerate(movers):
            # By itself it drives on when it is there, or gives up the others.
            alone = start[mover] + np.where(gives_up[k], early, 0.0)
            # With the number of who comes first of those it came with they stay together.
            fresh = len(self.label) * (event + 1) + np.argmax(came_with[mover], axis=0)
            vehicle = step.vehicles[mover]
            self.label[vehicle] = np.where(meets[k], self.label[merge.host], fresh)
            start[mover] = np.where(meets[k], leaves, alone)
            joined[mover] = meets[k]
        start[:] = np.where(joined, leaves, start)
        came_with |= joined[:, None] & joined[None, :]
