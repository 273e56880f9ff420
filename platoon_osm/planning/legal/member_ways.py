"""The ways of members that follow the timetable of a master, on the roads of a network.

A member drives to a merging point alone, with the platoon along the master's route, and on alone;
it may also leave the platoon, follow it alone, and join it again where it pauses. Where it drives
with the platoon it leaves every position at the master's moment.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...plans.stretches import Run, runs_alone, runs_along
from .legal_question import LegalQuestion
from .platoon.real import RoadTrips, Together
from .platoon.record import Timetable
from .star_input import StarWay
from .way_points import WayPoints, joined, part_of_way

__all__ = ["MemberWays"]

Edges = NDArray[np.int64]
Marks = NDArray[np.bool_]


class MemberWays:
    """The ways of the members of one star.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    own : StarWay
        The star.

    Attributes
    ----------
    trips : RoadTrips
        Answers how the vehicles really drive.
    """

    def __init__(self, legal: LegalQuestion, own: StarWay) -> None:
        self.legal, self.own = legal, own
        self._alone: dict[tuple[int, int, int], WayPoints] = {}
        self.trips = RoadTrips(
            own.times,
            lambda row, i: self.approach(row, i)[1].road,
            lambda row, j: self.onward(row, j)[1].road,
            lambda row, i, j: self._between(row, i, j).road,
        )

    def way(self, row: int, together: Sequence[Together], timetable: Timetable) -> WayPoints:
        """Return a member's way with the master's moments as appointments.

        Parameters
        ----------
        row : int
            The member, as its star numbers it.
        together : sequence of (int, int)
            Where it drives with the master, in driving order.
        timetable : Timetable
            The master's.

        Returns
        -------
        WayPoints
            From its origin to its destination.
        """
        times = self.own.times
        parts = [self.approach(row, together[0][0])[1]]
        last = None
        for i, j in together:
            if last is not None:
                parts.append(self._between(row, last, i))
            parts.append(part_of_way(self.own.way, int(times.node_at[i]), int(times.node_at[j])))
            last = j
        assert last is not None
        whole = joined([*parts, self.onward(row, last)[1]])
        return WayPoints(self.trips.joint(row, together, timetable), whole.points)

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
        member = star.members[row]
        origin = self.legal.question.ends[member].origin
        return self.legal.cheapest_way(member, origin, int(star.nodes[i]))

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
        member = star.members[row]
        destination = self.legal.question.ends[member].destination
        return self.legal.cheapest_way(member, int(star.nodes[j]), destination)

    def _between(self, row: int, start: int, end: int) -> WayPoints:
        """Return the master's route between two of its nodes, driven by a member alone."""
        if (row, start, end) not in self._alone:
            star = self.own.star
            some = self.legal.way(star.members[row], star.route[start:end])
            self._alone[row, start, end] = some
        return self._alone[row, start, end]

    def open(self) -> Marks:
        """Return which members have no closed roads on any of their own ways.

        Returns
        -------
        ndarray of bool, (M,)
            As far as anybody drives there at such hours.
        """
        star, times = self.own.star, self.own.times
        found = np.full(len(star.members), not self.legal.has_closings)
        for row, member in enumerate(star.members):
            ends, trees = self.legal.question.ends[member], self.legal.question.trees[member]
            for root, costs, forward in (
                (ends.origin, times.entry, True), (ends.destination, times.leave, False)
            ):  # fmt: skip
                if not found[row]:
                    break
                tree = trees.tree(root, forward)
                edges = tree.edges_to(star.nodes[np.isfinite(costs[row])].tolist())
                found[row] = all(self.legal.is_open(member, edge) for edge in edges)
        return found

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
