"""A master and its members under the clock, while the master does not wait.

Driving times along its route, the members' Pareto ways to and from it, and between which departures
of the master each could merge and separate at each node. So all that members can do at any
departure is known at once (`timing/open_points.py`), as is what they pay in all, as a curve.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..search.tie_rule import slack_of
from .question import Question
from .star import Star, StarChoice
from .timing.departure_curve import Gains, MemberSteps, StepCurve
from .timing.member_ways import Ways
from .timing.open_points import Delays, OpenPoints

__all__ = ["TimedStar"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]


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
        prices = question.time_prices
        self.price, self.is_free = prices.waiting, prices.are_free
        everyone = range(len(question.ends))
        pace = question.fleet.drive_s(everyone)
        own = [question.fleet.drive_s((k,))[star.route] for k in everyone]
        self.is_even = prices.are_even and all(np.array_equal(one, pace[star.route]) for one in own)
        """Whether all drive the route as fast alone as together, and prices are proportional."""
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
            Costs count waiting and delay at their prices.
        """
        found = self.star.choose(
            case, self.question.problem.optimum, self.open_costs(points, departure)
        )
        late = self.leads_late(departure)
        return replace(found, cost=found.cost + late, bound=found.bound + late) if late else found

    @cached_property
    def delays(self) -> Delays | None:
        """What delay costs the members; None if it is free."""
        price = self.question.time_prices.delay
        if not price:
            return None
        asked = [self.question.asked_windows[k].earliest for k in self.star.members]
        drive = [self.question.alone_s[k] for k in self.star.members]
        return Delays(
            np.array([0.0 if one is None else price for one in asked]),
            np.array(
                [one + own for one, own in zip((e or 0.0 for e in asked), drive, strict=True)]
            ),
        )

    @property
    def lead_rate(self) -> float:
        """What it costs the master to leave a second later."""
        asked = self.question.asked_windows[self.star.master].earliest
        return 0.0 if asked is None else self.question.time_prices.delay

    def leads_late(self, departure: float) -> float:
        """Return what it costs the master to leave at a moment.

        Parameters
        ----------
        departure : float
            When it leaves [s].

        Returns
        -------
        float
            The price of its delay.
        """
        asked = self.question.asked_windows[self.star.master].earliest
        return 0.0 if asked is None else self.lead_rate * (departure - asked)

    def steps(
        self,
        points: OpenPoints,
        along: Floats,
        gains: Gains | None = None,
        latest: float | None = None,
    ) -> MemberSteps:
        """Return what each member pays, by the master's departure.

        Parameters
        ----------
        points : OpenPoints
            Of a case.
        along : ndarray of float, (M, K + 1)
            What each pays in company up to each position.
        gains : Gains, optional
            What the master gains; then positions are found too.
        latest : float, optional
            The last departure to look at [s]; by default the master's own.

        Returns
        -------
        MemberSteps
            Waiting and delay at their prices.
        """
        return points.steps(along, self.solo, self.slack, gains, self.price, latest, self.delays)

    def summed(self, steps: MemberSteps, fixed: float, gains: Gains | None = None) -> StepCurve:
        """Return what all pay, by the master's departure.

        Parameters
        ----------
        steps : MemberSteps
            Of the members.
        fixed : float
            What the master pays.
        gains : Gains, optional
            What it gains, if the steps were found with it.

        Returns
        -------
        StepCurve
            The master's delay included.
        """
        return steps.curve(fixed + self.leads_late(0.0), gains, self.lead_rate)

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
        return *points.at(departure, len(self.route_s), self.price, self.delays), self.solo

    def member_curve(self, points: OpenPoints) -> tuple[StepCurve, MemberSteps]:
        """Return what all pay if each member pays least, and the members' steps.

        Parameters
        ----------
        points : OpenPoints
            Of a case.

        Returns
        -------
        StepCurve
            Exact where time is free or the master gains nothing, else a lower bound.
        MemberSteps
            Of which it is the sum.
        """
        fixed = self.star.master_alone
        if not self.is_free and self.gains.gain.any():
            steps = self.steps(points, self.along)
            return self.summed(steps, fixed - float(np.maximum(self.gains.gain, 0.0).sum())), steps
        gains = self.gains if self.gains.gain.any() else None
        steps = self.steps(points, self.along, gains)
        return self.summed(steps, fixed, gains), steps

    def shown_curve(self, points: OpenPoints) -> tuple[StepCurve, MemberSteps]:
        """Return what all pay if each member pays least: what can be had at every departure.

        Parameters
        ----------
        points : OpenPoints
            Of a case.

        Returns
        -------
        StepCurve
            Where time is priced, what the master gains is left out.
        MemberSteps
            Of which it is the sum, with positions where time is free.
        """
        gains = self.gains if self.is_free else None
        steps = self.steps(points, self.along, gains)
        return self.summed(steps, self.star.master_alone, gains), steps

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
        if to:
            _, time_s = points.entry_way(member, at, departure)
        else:
            _, time_s = points.exit_way(member, at, departure, self.delays)
        return self.question.ways_in_time.route(vehicle, int(self.star.nodes[at]), time_s, to)
