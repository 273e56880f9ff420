"""A master and its members under the clock, while the master does not wait.

Driving times along its route, the members' Pareto ways to and from it, and between which departures
of the master each could merge and separate at each node. So all that members can do at any
departure is known at once (`timing/open_points.py`), as is what they pay in all, as a curve.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..search.tie_rule import slack_of
from .member_plans import MemberPlans
from .question import Question
from .star import Star, StarChoice
from .timing.departure_curve import Gains, MemberSteps, StepCurve
from .timing.member_ways import Ways
from .timing.open_points import OpenPoints

__all__ = ["TimedStar", "waiting_price"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]


def waiting_price(objective: Any) -> float | None:
    """Return what a second's waiting costs.

    Parameters
    ----------
    objective : Objective or EdgeWeights
        Whose price.

    Returns
    -------
    float or None
        None if its price is not proportional to the time.
    """
    hour, three = float(objective.waiting(3600.0)), float(objective.waiting(10800.0))
    return hour / 3600 if abs(three - 3 * hour) <= 1e-9 * abs(three) else None


class TimedStar:
    """One master and its members under the clock.

    Parameters
    ----------
    question : Question
        Whose trips name times.
    star : Star
        The master and its members.
    """

    def __init__(self, question: Question, star: Star) -> None:
        assert question.windows is not None
        self.question, self.star = question, star
        self.windows = question.windows
        known = waiting_price(question.problem.objective)
        self.price = known or 0.0
        everyone = range(len(question.ends))
        pace = question.fleet.drive_s(everyone)
        own = [question.fleet.drive_s((k,))[star.route] for k in everyone]
        self.is_even = known is not None and all(
            np.array_equal(one, pace[star.route]) for one in own
        )
        """Whether all drive the route as fast alone as together, and waiting is proportional."""
        before, after = star.ways_beside
        master = question.fleet.drive_s((star.master,))
        self.before_s, self.after_s = float(master[before].sum()), float(master[after].sum())
        # A platoon drives as the slowest: whoever joins, that of all is slow enough.
        self.route_s = self.before_s + np.concatenate([[0.0], np.cumsum(pace[star.route])])

    @cached_property
    def solo(self) -> Floats:
        """Cost of each member alone, (M,)."""
        return self.star.costs[2]

    @cached_property
    def slack(self) -> Floats:
        """How far costs of each member may differ and be equal, (M,)."""
        return np.array([slack_of(float(alone), np.inf) for alone in self.solo])

    @cached_property
    def gains(self) -> Gains:
        """What the master gains by company."""
        length = self.star.net.length_m[self.star.route]
        return Gains(self.star.gain, np.concatenate([[0.0], np.cumsum(length)]))

    @cached_property
    def along(self) -> Floats:
        """What each member pays in company up to each position, (M, K + 1); more if barred."""
        star = self.star
        found = np.zeros((len(star.members), len(star.route) + 1))
        for row, member in enumerate(star.members):
            own = star.fleet[member].platoon[star.route]
            closed = star.fleet.closed_on(member, star.route)
            if closed is not None:
                own = own + np.where(closed, 2 * self.solo[row] + 1.0, 0.0)
            np.cumsum(own, out=found[row, 1:])
        return found

    @cached_property
    def _every(self) -> tuple[Ways, Ways]:
        ways = self.question.ways_in_time
        into, onward = (
            Ways.joined([ways.to(member, self.star.nodes, forward) for member in self.star.members])
            for forward in (True, False)
        )
        return into, onward

    @property
    def is_complete(self) -> bool:
        """Whether no way that counts is missing."""
        ways = self.question.ways_in_time
        return all(ways.is_complete(member) for member in self.star.members)

    def points(self, case: str) -> OpenPoints:
        """Return between which departures members can join and leave.

        Parameters
        ----------
        case : {"A", "B", "C"}
            Which points are free.

        Returns
        -------
        OpenPoints
            Of the members, in the star's order.
        """
        into, onward = self._every
        if case in ("A", "B"):
            fixed = onward if case == "A" else into
            there = np.zeros((len(self.star.members), len(self.star.nodes)), bool)
            for row, member in enumerate(self.star.members):
                own = self.question.ends[member]
                places = own.destinations if case == "A" else own.origins
                there[row] = np.isin(self.star.nodes, list(places))
            kept = fixed.kept(there[fixed.member, fixed.at])
            into, onward = (into, kept) if case == "A" else (kept, onward)
        return OpenPoints.of(
            self.windows[self.star.master], [self.windows[k] for k in self.star.members],
            self.route_s, into, onward, self.after_s,
        )  # fmt: skip

    def chosen(self, case: str, points: OpenPoints, departure: float) -> StarChoice:
        """Return what members choose if the master leaves at a moment.

        Parameters
        ----------
        case : {"A", "B", "C"}
            Which points are free.
        points : OpenPoints
            Of that case.
        departure : float
            When the master leaves [s].

        Returns
        -------
        StarChoice
            Costs count priced waiting.
        """
        return self.star.choose(
            case, self.question.problem.optimum, self.open_costs(points, departure)
        )

    def open_costs(self, points: OpenPoints, departure: float) -> tuple[Floats, Floats, Floats]:
        """Return what it costs to join, to leave and to stay alone at a departure.

        Parameters
        ----------
        points : OpenPoints
            Of a case.
        departure : float
            When the master leaves [s].

        Returns
        -------
        entry, leave : ndarray of float, (M, K + 1)
            Inf where it is too late.
        solo : ndarray of float, (M,)
            Costs alone.
        """
        return *points.at(departure, len(self.route_s), self.price), self.solo

    def member_curve(self, points: OpenPoints) -> tuple[StepCurve, MemberSteps]:
        """Return what all pay if each member pays least, and the members' steps.

        Parameters
        ----------
        points : OpenPoints
            Of a case.

        Returns
        -------
        StepCurve
            Exact where waiting is free or the master gains nothing, else a lower bound.
        MemberSteps
            Of which it is the sum.
        """
        fixed = self.star.master_alone
        if self.price and self.gains.gain.any():
            steps = points.steps(self.along, self.solo, self.slack, None, self.price)
            return steps.curve(fixed - float(np.maximum(self.gains.gain, 0.0).sum())), steps
        gains = self.gains if self.gains.gain.any() else None
        steps = points.steps(self.along, self.solo, self.slack, gains, self.price)
        return steps.curve(fixed, gains), steps

    def shown_curve(self, points: OpenPoints) -> tuple[StepCurve, MemberSteps]:
        """Return what all pay if each member pays least: what can be had at every departure.

        Parameters
        ----------
        points : OpenPoints
            Of a case.

        Returns
        -------
        StepCurve
            Where waiting is priced, what the master gains is left out.
        MemberSteps
            Of which it is the sum, with positions where waiting is free.
        """
        gains = None if self.price else self.gains
        steps = points.steps(self.along, self.solo, self.slack, gains, self.price)
        return steps.curve(self.star.master_alone, gains), steps

    def way(self, points: OpenPoints, departure: float, vehicle: int, at: int, to: bool) -> Longs:
        """Return the way that a member takes.

        Parameters
        ----------
        points : OpenPoints
            Of the case.
        departure : float
            When the master leaves [s].
        vehicle : int
            Position in the plan.
        at : int
            Position on the route.
        to : bool
            Whether the way leads there; else from there.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order.
        """
        member = self.star.members.index(vehicle)
        find = points.entry_way if to else points.exit_way
        _, time_s = find(member, at, departure)
        return self.question.ways_in_time.route(vehicle, int(self.star.nodes[at]), time_s, to)

    def waits_s(self, points: OpenPoints, found: MemberPlans, departure: float) -> float:
        """Return how long members wait at their merging points in all.

        Parameters
        ----------
        points : OpenPoints
            Of the case.
        found : MemberPlans
            Where members merge.
        departure : float
            When the master leaves [s].

        Returns
        -------
        float
            Seconds.
        """
        total = 0.0
        for member in np.flatnonzero(found.merge_index >= 0).tolist():
            at = int(found.merge_index[member])
            _, time_s = points.entry_way(member, at, departure)
            late = self.windows[self.star.members[member]].latest
            if late is not None:
                total += max(0.0, departure + self.route_s[at] - late - time_s)
        return total
