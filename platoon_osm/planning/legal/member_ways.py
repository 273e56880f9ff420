"""The way of a member that follows the timetable of a master, and its legal trip on it.

A member drives to a merging point alone, with the platoon along the master's route, and on alone;
it may also leave the platoon, follow it alone, and join it again where it pauses. Where it drives
with the platoon it leaves every position at the master's moment.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ...driving.limits import Limits
from ...plans.stretches import Run, runs_alone, runs_along
from .legal_question import LegalQuestion
from .one_driver import fastest
from .platoon_record import MASTER, Timetable
from .road import FREE, LegalTrip, Road, road_of
from .star_input import StarWay
from .star_times import OPEN_S
from .way_points import WayPoints, joined, part_of_way

__all__ = ["MemberWays", "Together"]

Seconds = NDArray[np.int64]
Edges = NDArray[np.int64]

Together = tuple[int, int]
"""From which node of the master's route to which a member drives with it."""

BEFORE_S = 3 * 86_400
"""A member that names no earliest departure leaves no earlier before it merges [s]."""


class MemberWays:
    """The ways of the members of one star.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    own : StarWay
        The star.
    """

    def __init__(self, legal: LegalQuestion, own: StarWay) -> None:
        self.legal, self.own = legal, own
        self._own: dict[tuple[int, int, int], tuple[Edges, WayPoints]] = {}
        self._alone: dict[tuple[int, int, int], WayPoints] = {}

    def way(
        self, row: int, together: Sequence[Together], leave_s: Seconds, slack_s: int = 0
    ) -> WayPoints:
        """Return a member's way with the master's moments as appointments.

        Parameters
        ----------
        row : int
            The member, as its star numbers it.
        together : sequence of (int, int)
            Where it drives with the master, in driving order.
        leave_s : ndarray of int, (P + 1,)
            When the master leaves each position of its way [s].
        slack_s : int
            From the first merging point on, closings begin so much later [s]; see `Real`.

        Returns
        -------
        WayPoints
            From its origin to its destination.
        """
        times = self.own.times
        before = self.approach(row, together[0][0])[1]
        parts: list[WayPoints] = []
        last = None
        for i, j in together:
            if last is not None:
                parts.append(self._between(row, last, i))
            first, end = int(times.node_at[i]), int(times.node_at[j])
            part = part_of_way(self.own.way, first, end, 1 - times.relief)
            moments = np.append(leave_s[first:end], FREE)
            parts.append(WayPoints(replace(part.road, leave_s=moments), part.points))
            last = j
        assert last is not None
        parts.append(self.onward(row, last)[1])
        if slack_s:
            parts = [WayPoints(closed_later(one.road, slack_s), one.points) for one in parts]
        return joined([before, *parts])

    def trip(
        self, row: int, together: Sequence[Together], leave_s: Seconds, slack_s: int = 0
    ) -> LegalTrip | None:
        """Return the fastest legal trip of a member that drives with the master.

        Parameters
        ----------
        row : int
            The member, as its star numbers it.
        together : sequence of (int, int)
            Where it drives with the master, in driving order.
        leave_s : ndarray of int, (P + 1,)
            When the master leaves each position of its way [s].
        slack_s : int
            Of a question about a span of departures, see `Real` [s].

        Returns
        -------
        LegalTrip or None
            None if it cannot keep the law and its window that way.
        """
        times = self.own.times
        window, rules = times.windows[row], times.member_rules[row]
        way = self.way(row, together, leave_s, slack_s)
        i = together[0][0]
        earliest = window.earliest_s
        if earliest == -OPEN_S:
            merges = int(leave_s[times.node_at[i]])
            earliest = merges - int(times.approach_s[row, i]) - BEFORE_S
        return fastest(
            way.road, longer_duty(rules.limits, slack_s), rules.state, rules.state_at_s, earliest,
            None if window.latest_s == OPEN_S else window.latest_s,
            None if window.arrival_s == OPEN_S else window.arrival_s + slack_s, times.monday_s,
        )  # fmt: skip

    def master_trip(self, leave_s: Seconds, slack_s: int = 0) -> LegalTrip | None:
        """Return the legal trip of the master that leaves its positions at given moments.

        Parameters
        ----------
        leave_s : ndarray of int, (P + 1,)
            When it leaves each position of its way [s].
        slack_s : int
            Of a question about a span of departures, see `Real` [s].

        Returns
        -------
        LegalTrip or None
            None if it cannot keep the law and its window that way.
        """
        times = self.own.times
        road = replace(times.road, leave_s=np.append(leave_s[:-1], FREE))
        road = closed_later(road, slack_s) if slack_s else road
        window, leaves = times.window, int(leave_s[0])
        return fastest(
            road, longer_duty(times.rules.limits, slack_s), times.rules.state,
            times.rules.state_at_s, leaves, leaves,
            None if window.arrival_s == OPEN_S else window.arrival_s + slack_s, times.monday_s,
        )  # fmt: skip

    def real(self, member: int, i: int, j: int, timetable: Timetable) -> LegalTrip | None:
        """Answer the search's question how a vehicle really drives; see `Real`.

        Parameters
        ----------
        member : int
            The member, as its star numbers it; or `MASTER`.
        i, j : int
            Nodes of the master's route between which it drives with it.
        timetable : Timetable
            The master's.

        Returns
        -------
        LegalTrip or None
            None if it cannot.
        """
        if member == MASTER:
            return self.master_trip(timetable.leave_s, timetable.slack_s)
        return self.trip(member, [(i, j)], timetable.leave_s, timetable.slack_s)

    def road_to(self, member: int, node: int) -> Road:
        """Return a member's way to a node of the master's route; see `OwnRoads`.

        Parameters
        ----------
        member : int
            The member, as its star numbers it.
        node : int
            The node's position on the route.

        Returns
        -------
        Road
            From its origin.
        """
        return self.approach(member, node)[1].road

    def road_from(self, member: int, node: int) -> Road:
        """Return a member's way from a node of the master's route; see `OwnRoads`.

        Parameters
        ----------
        member : int
            The member, as its star numbers it.
        node : int
            The node's position on the route.

        Returns
        -------
        Road
            To its destination.
        """
        return self.onward(member, node)[1].road

    def approach(self, row: int, i: int) -> tuple[Edges, WayPoints]:
        """Return a member's way to a node of the master's route.

        Parameters
        ----------
        row : int
            The member, as its star numbers it.
        i : int
            The node's position on the route.

        Returns
        -------
        edges : ndarray of int
            In driving order; none where it starts there.
        way : WayPoints
            Its points.
        """
        star = self.own.star
        origin = self.legal.question.ends[star.members[row]].origin
        return self._by_itself(row, origin, int(star.nodes[i]))

    def onward(self, row: int, j: int) -> tuple[Edges, WayPoints]:
        """Return a member's way from a node of the master's route.

        Parameters
        ----------
        row : int
            The member, as its star numbers it.
        j : int
            The node's position on the route.

        Returns
        -------
        edges : ndarray of int
            In driving order; none where it ends there.
        way : WayPoints
            Its points.
        """
        star = self.own.star
        destination = self.legal.question.ends[star.members[row]].destination
        return self._by_itself(row, int(star.nodes[j]), destination)

    def _by_itself(self, row: int, start: int, end: int) -> tuple[Edges, WayPoints]:
        """Return a member's own way between two nodes, worked out once."""
        if (row, start, end) not in self._own:
            member = self.own.star.members[row]
            edges = self.own.star.routers[member].route(start, end)
            self._own[row, start, end] = edges, self.legal.way(member, edges)
        return self._own[row, start, end]

    def _between(self, row: int, start: int, end: int) -> WayPoints:
        """Return the master's route between two of its nodes, driven by a member alone."""
        if (row, start, end) not in self._alone:
            star = self.own.star
            some = self.legal.way(star.members[row], star.route[start:end])
            self._alone[row, start, end] = some
        return self._alone[row, start, end]

    def runs(self, together: Sequence[Sequence[Together]]) -> list[list[Run]]:
        """Return who drives what with whom.

        Parameters
        ----------
        together : sequence of sequence of (int, int), (M, ...)
            Where each member drives with the master; nothing for one that stays alone.

        Returns
        -------
        list of list of Run, (N, ...)
            Each vehicle's in driving order; the master leads.
        """
        star = self.own.star
        alone = star.alone
        there: list[list[int]] = [[star.master] for _ in star.route]
        for row, some in enumerate(together):
            for i, j in some:
                for at in range(i, j):
                    there[at].append(star.members[row])
        companies = [tuple(company) for company in there]
        found = [runs_alone(route, index) for index, route in enumerate(alone)]
        whole, first = alone[star.master], self.own.first
        found[star.master] = [
            *runs_alone(whole[:first], star.master),
            *runs_along(star.route, companies),
            *runs_alone(whole[first + len(star.route) :], star.master),
        ]
        for row, some in enumerate(together):
            if not some:
                continue
            member = star.members[row]
            own: list[Run] = runs_alone(self.approach(row, some[0][0])[0], member)
            last = some[0][0]
            for i, j in some:
                own += runs_alone(star.route[last:i], member)
                own += runs_along(star.route[i:j], companies[i:j])
                last = j
            found[member] = [*own, *runs_alone(self.onward(row, last)[0], member)]
        return found


def longer_duty(limits: Limits, by_s: int) -> Limits:
    """Return limits whose duty periods are longer.

    Parameters
    ----------
    limits : Limits
        Of a vehicle.
    by_s : int
        By how much [s]; below 0 for shorter ones.

    Returns
    -------
    Limits
        The same where nothing is changed.
    """
    if not by_s:
        return limits
    return replace(
        limits, window_s=limits.window_s + by_s, long_window_s=limits.long_window_s + by_s
    )


def closed_later(road: Road, by_s: int) -> Road:
    """Return a road whose closings begin later, and end when they do.

    Parameters
    ----------
    road : Road
        With closings or without.
    by_s : int
        By how much they begin later [s]; below 0 for earlier.

    Returns
    -------
    Road
        Closings that would end before they begin are none.
    """
    if not len(road.forbidden_s):
        return road
    closed: list[list[tuple[int, int]]] = []
    for hop in range(road.hops):
        own: list[tuple[int, int]] = []
        for begin, end in road.forbidden(hop).tolist():
            if begin + by_s >= end:
                continue
            if own and begin + by_s < own[-1][1]:
                own[-1] = (own[-1][0], max(own[-1][1], end))
            else:
                own.append((begin + by_s, end))
        closed.append(own)
    return road_of(
        road.drive_s, road.stay_s, clock_s=road.clock_s, leave_s=road.leave_s, forbidden=closed
    )
