"""A master and its members: cases A, B and C share the master's route and all their searches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..network.placed import access_of
from ..network.road_network import RoadNetwork
from ..plans.stretches import Run, runs_alone, runs_along
from .cases import Floats, choose_points, running_sum
from .ends import TripEnds
from .fleet import Fleet
from .join_costs import JoinCosts, road_of
from .member_plans import MemberPlans
from .problem import Optimum
from .routers import Router
from .system import choose_for_system

__all__ = ["Star", "StarChoice"]

Edges = NDArray[np.int64]

Way = Callable[[int, int, bool], Edges]
"""From a vehicle, a position on the route, and whether it leads there, to edges."""


@dataclass(frozen=True, slots=True, eq=False)
class StarChoice:
    """Where the members of one master merge and separate.

    Attributes
    ----------
    case : str
        "A", "B" or "C".
    points : MemberPlans
        The members' points, in the order of `Star.members`.
    cost : float
        Of all vehicles together.
    bound : float
        No choice of points costs less; `cost` itself where members do not depend on each other.
    price : ndarray of float, (K,), or None
        The prices of edges that prove the bound, where they do.
    """

    case: str
    points: MemberPlans
    cost: float
    bound: float
    price: Floats | None = None


class Star:
    """One master's route, and what it takes to join and leave it.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    fleet : Fleet
        What edges cost each vehicle, and where it may drive.
    ends : sequence of TripEnds, (N,)
        Where vehicles go.
    master : int
        The vehicle that keeps its route.
    routers : sequence of Router, (N,)
        How each vehicle gets to the route and from it.
    alone : sequence of ndarray of int, (N,), optional
        The route of each vehicle alone, if it is known.
    costs : JoinCosts, optional
        What joining costs, if it is shared with other masters.

    Attributes
    ----------
    alone : list of ndarray of int, (N,)
        The route of each vehicle alone.
    route : ndarray of int, (K,)
        That of the master.
    members : list of int
        All vehicles but the master.
    """

    def __init__(
        self,
        net: RoadNetwork,
        fleet: Fleet,
        ends: Sequence[TripEnds],
        master: int,
        routers: Sequence[Router],
        alone: Sequence[Edges] | None = None,
        costs: JoinCosts | None = None,
    ) -> None:
        self.net, self.fleet, self.ends, self.master = net, fleet, ends, master
        self.routers = routers
        known = alone or [
            router.route(item.origin, item.destination)
            for router, item in zip(routers, ends, strict=True)
        ]
        self.alone = list(known)
        self._shared = costs or JoinCosts(
            net, ends, [road_of(net, own) for own in self.alone], routers, fleet
        )
        # A way beside the road is nobody's company: members join on the road, and leave there.
        whole = self.alone[master]
        ways = access_of(net, whole)
        self.route = whole[~ways]
        begin = int(np.argmin(ways)) if len(self.route) else len(whole)
        self._before, self._after = whole[:begin], whole[begin + len(self.route) :]
        self.members = [index for index in range(len(ends)) if index != master]
        self._origins = np.array([ends[k].origin for k in self.members], np.int64)
        self._destinations = np.array([ends[k].destination for k in self.members], np.int64)

    @property
    def solo_cost(self) -> float:
        """Cost of all routes alone."""
        return sum(float(self.fleet[k].solo[own].sum()) for k, own in enumerate(self.alone))

    @cached_property
    def costs(self) -> tuple[Floats, Floats, Floats]:
        """What members pay to join (M, K + 1), to leave (M, K + 1) and alone (M,)."""
        return self._shared.of(self.master, self.members)

    @cached_property
    def nodes(self) -> Edges:
        """The nodes of the master's route, (K + 1,)."""
        return self._shared.nodes[self.master]

    @cached_property
    def bound(self) -> float:
        """No case, and no choice of points, costs less in all; quicker than choosing them."""
        entry, leave, solo = self.costs
        alone = self.master_alone
        if not self.members or not len(self.route):
            return alone + float(solo.sum())
        least = solo.copy()
        for rows in self._alike(np.arange(len(self.members))):
            platoon = running_sum(self.fleet[self.members[rows[0]]].platoon[self.route])
            lead = np.minimum.accumulate(entry[rows] - platoon, axis=1)
            joined = (lead[:, :-1] + platoon[1:] + leave[rows, 1:]).min(axis=1)
            least[rows] = np.minimum(joined, solo[rows])
        return float(least.sum()) + alone - float(np.maximum(self.gain, 0.0).sum())

    @property
    def master_alone(self) -> float:
        """Cost of the master without any company."""
        return float(self.fleet[self.master].solo[self.alone[self.master]].sum())

    @property
    def gain(self) -> Floats:
        """What the master saves on each edge of its route if it has company there, (K,)."""
        weights = self.fleet[self.master]
        return (weights.solo - weights.master)[self.route]

    @property
    def ways_beside(self) -> tuple[Edges, Edges]:
        """The master's ways beside the road, before its route and after it."""
        return self._before, self._after

    def _alike(self, rows: Edges) -> list[Edges]:
        """Return members by their kind, as positions in `rows`."""
        kind = np.array([self.fleet.kind[self.members[k]] for k in rows.tolist()], np.int64)
        return [np.flatnonzero(kind == one) for one in np.unique(kind)]

    def choose(
        self, case: Any, optimum: Optimum, costs: tuple[Floats, Floats, Floats] | None = None
    ) -> StarChoice:
        """Choose the members' points.

        Parameters
        ----------
        case : {"A", "B", "C"}
            Which points are free.
        optimum : {"member", "system"}
            Whose cost is least.
        costs : tuple of ndarray of float, optional
            In place of `costs`, with inf where a member cannot join or leave in time.

        Returns
        -------
        StarChoice
            The points, their cost and its bound.
        """
        everyone = np.arange(len(self.members))
        known = costs or self.costs
        gain, alone = self.gain, self.master_alone
        if optimum == "member" or not self.members:
            points = self._points(case, None, everyone, known)
            met = points.covered(len(self.route)).any(axis=0)
            cost = float(points.cost.sum()) + alone - float(gain[met].sum())
            return StarChoice(case, points, cost, cost)
        found = choose_for_system(
            lambda gains, rows: self._points(case, gains, rows, known), gain, len(self.members)
        )
        return StarChoice(case, found.members, found.cost + alone, found.bound + alone, found.price)

    def _points(
        self, case: Any, gain: Floats | None, rows: Edges, costs: tuple[Floats, Floats, Floats]
    ) -> MemberPlans:
        entry, leave, solo = costs
        if not len(self.route) or not len(rows):
            return MemberPlans.apart(solo[rows])
        groups = self._alike(rows)
        found = [
            self._alike_points(
                case, None if gain is None else gain[at], rows[at],
                (entry[rows[at]], leave[rows[at]], solo[rows[at]]),
            )
            for at in groups
        ]  # fmt: skip
        return found[0] if len(found) == 1 else MemberPlans.together(found, groups)

    def _alike_points(
        self, case: Any, gain: Floats | None, rows: Edges, costs: tuple[Floats, Floats, Floats]
    ) -> MemberPlans:
        """Choose points of members that are alike; where a road is closed to them, none pass."""
        some = [self.ends[self.members[k]] for k in rows]
        kind = self.members[rows[0]]
        closed = self.fleet.closed_on(kind, self.route)
        if closed is not None:
            # Dearer than driving alone at once, yet of its size, so that no digit is lost.
            bar = np.where(closed, 2 * costs[2][:, None] + 1.0, 0.0)
            gain = -bar if gain is None else gain - bar
        return choose_points(
            self.net, self.fleet[kind], self.route, self._origins[rows], self._destinations[rows],
            case, costs, [item.origins for item in some], [item.destinations for item in some],
            gain,
        )  # fmt: skip

    def within(
        self,
        points: MemberPlans,
        case: Any,
        most: int,
        costs: tuple[Floats, Floats, Floats] | None = None,
    ) -> MemberPlans:
        """Return points with which no platoon is larger than allowed.

        The members that gain most come first; each of the others takes its best stretch where
        there is room left, which is not the best for all.

        Parameters
        ----------
        points : MemberPlans
            The members' points.
        case : {"A", "B", "C"}
            Which points are free.
        most : int
            Vehicles of the largest platoon, the master among them.
        costs : tuple of ndarray of float, optional
            As in `choose`.

        Returns
        -------
        MemberPlans
            The given ones if they fit already.
        """
        there = points.covered(len(self.route))
        if int(there.sum(axis=0).max(initial=0)) < most:
            return points
        users = np.zeros(len(self.route), np.int64)
        chosen = points
        forbidding = -2.0 * float(self.fleet[self.master].solo.sum() + points.solo_cost.sum())
        for member in np.argsort(points.cost - points.solo_cost, kind="stable").tolist():
            if there[member].any() and (users[there[member]] >= most - 1).any():
                room = np.where(users >= most - 1, forbidding, 0.0)
                turn = self._points(case, room[None, :], np.array([member]), costs or self.costs)
                chosen = chosen.with_row(member, turn)
                there[member] = turn.covered(len(self.route))[0]
            users += there[member]
        return chosen

    def routes(self, points: MemberPlans, way: Way | None = None) -> list[list[Run]]:
        """Return who drives what with whom.

        Parameters
        ----------
        points : MemberPlans
            The members' points.
        way : callable, optional
            Returns a member's way to a position of the route (True) or from it (False); by default
            the cheapest.

        Returns
        -------
        list of list of Run, (N, ...)
            Each vehicle's runs in driving order; the master leads.
        """
        way = way or self._cheapest
        joined = [(self.members[k], int(points.merge_index[k]), int(points.separation_index[k]))
                  for k in np.flatnonzero(points.merge_index >= 0).tolist()]  # fmt: skip
        there: list[list[int]] = [[self.master] for _ in self.route]
        for index, i, j in joined:
            for at in range(i, j):
                there[at].append(index)
        companies = [tuple(company) for company in there]
        routes = [runs_alone(route, index) for index, route in enumerate(self.alone)]
        routes[self.master] = [
            *runs_alone(self._before, self.master),
            *runs_along(self.route, companies),
            *runs_alone(self._after, self.master),
        ]
        for index, i, j in joined:
            before, after = way(index, i, True), way(index, j, False)
            routes[index] = [
                *runs_alone(before, index),
                *runs_along(self.route[i:j], companies[i:j]),
                *runs_alone(after, index),
            ]
        return routes

    def _cheapest(self, vehicle: int, position: int, forward: bool) -> Edges:
        own, node = self.ends[vehicle], int(self.nodes[position])
        pair = (own.origin, node) if forward else (node, own.destination)
        return self.routers[vehicle].route(*pair)
