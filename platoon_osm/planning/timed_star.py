"""A master that does not wait, and its members: the departure at which all pay least, exactly.

Under "member" each member pays least itself, at every departure; of all departures the one is taken
at which all together pay least, what the master gains included. Where waiting is free that is read
off one curve.

Under "system" members and master together pay least. The master gains once an edge, so members
hang together. With prices p of that condition, as in `system.py`, they do not, and their curve is a
lower bound of the total at every departure. The departure at which the bound is least is planned;
its prices give a further bound; and so on until no departure can be better than the best plan, or
the work is done. Between a departure and the next moment at which anything opens the total never
falls, so a bound at the one holds up to the other.

If the master may wait, every member may be met at a departure of its own: the sum of what each pays
at best, less what the master gains, is a lower bound of that.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..search.tie_rule import TIE, slack_of
from .member_plans import MemberPlans
from .question import Question
from .star import Star, StarChoice
from .timing.bound_curves import BoundCurves
from .timing.departure_curve import Gains, MemberSteps, StepCurve
from .timing.member_ways import Ways
from .timing.open_points import HAIR_S, OpenPoints

__all__ = ["NoWait", "TimedStar", "waiting_price"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
Marks = NDArray[np.bool_]

MOST_PLANNED = 40
"""Departures that are planned under "system", if members are few."""

MEMBER_PLANS = 2_000
"""Members planned in all: with many of them, fewer departures are."""

SHARES = (1.0, 0.5, 0.25, 0.0)
"""Prices to begin with, as shares of what the master gains."""


@dataclass(frozen=True, slots=True, eq=False)
class NoWait:
    """The best plan of a master that does not wait.

    Attributes
    ----------
    departure : float
        When it is at the begin of its route [s].
    choice : StarChoice
        Where members merge and separate; its bound holds for every departure.
    is_proved : bool
        Whether the bound holds at all: driving times are equal alone and together, and all ways
        that count are known.
    """

    departure: float
    choice: StarChoice
    is_proved: bool


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

    def best(self, case: str) -> NoWait | None:
        """Return the best plan for a master that does not wait.

        Parameters
        ----------
        case : {"A", "B", "C"}
            Which points are free.

        Returns
        -------
        NoWait or None
            None if the master cannot be in time with company at all.
        """
        points = self.points(case)
        if points.earliest > points.latest + HAIR_S or not len(self.star.route):
            return None
        if self.question.problem.optimum == "system":
            departure, choice, bound = self._for_system(case, points)
        else:
            departure, choice, bound = self._for_members(case, points)
        found = StarChoice(choice.case, choice.points, choice.cost, min(bound, choice.cost))
        return NoWait(departure, found, self.is_even and self.is_complete)

    def _for_members(self, case: str, points: OpenPoints) -> tuple[float, StarChoice, float]:
        curve = self.member_curve(points)[0]
        step, bound = curve.best(TIE * self.star.solo_cost)
        departure = curve.moment(step)
        return departure, self.chosen(case, points, departure), bound

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

    def _relaxed(self, points: OpenPoints, price: Floats, latest: float | None) -> MemberSteps:
        """Return the steps of members that count a price of the master's gain on every edge."""
        along = self.along.copy()
        along[:, 1:] -= np.cumsum(price)
        return points.steps(along, self.solo, self.slack, None, self.price, latest)

    def _granted(self, price: Floats) -> float:
        """Return what the master pays if it is granted what the prices leave of its gain."""
        return self.star.master_alone - float((self.gains.gain - price).sum())

    def _for_system(self, case: str, points: OpenPoints) -> tuple[float, StarChoice, float]:
        gain = self.gains.gain
        bounds = BoundCurves(points)
        for share in SHARES:
            price = share * gain
            bounds.add(self._relaxed(points, price, None).curve(self._granted(price)))
        best: tuple[float, StarChoice] | None = None
        most = max(2, min(MOST_PLANNED, MEMBER_PLANS // max(len(self.solo), 1)))
        for _ in range(most):
            begin, departure, least = bounds.lowest()
            if best is not None and least >= best[1].cost - TIE * self.star.solo_cost:
                break
            found = self.chosen(case, points, departure)
            bounds.settle(begin, departure, found.bound)
            if best is None or found.cost < best[1].cost - TIE * self.star.solo_cost:
                best = departure, found
            if found.price is not None:
                steps = self._relaxed(points, found.price, None)
                bounds.add(steps.curve(self._granted(found.price)))
        assert best is not None
        return *best, bounds.lowest()[2]

    def bound_if_waiting(self, case: str, also: Sequence[Floats] = ()) -> float:
        """Return what no plan costs less than, whether the master waits or not.

        Parameters
        ----------
        case : {"A", "B", "C"}
            Which points are free.
        also : sequence of ndarray of float, (K,)
            Prices to try besides those to begin with.

        Returns
        -------
        float
            For members that share one stretch each with the master.
        """
        gain = np.maximum(self.gains.gain, 0.0)
        points = self.points(case)
        members = max(len(self.solo), 1)
        found = -np.inf
        for price in (*(share * gain for share in SHARES), gain / members, *also):
            least = self._relaxed(points, price, points.latest_waiting).least()
            granted = self.star.master_alone - float((gain - price).sum())
            found = max(found, float(least.sum()) + granted)
        return found - TIE * self.star.solo_cost

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
