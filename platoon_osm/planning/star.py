"""A master and its members: cases A, B and C share the master's route and all their searches."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..costs.weights import EdgeWeights
from ..errors import ScenarioError
from ..network.placed import access_of
from ..network.road_network import RoadNetwork
from ..plans.stretches import Run, runs_alone, runs_along
from .cases import Floats, MemberPlans, choose_points, route_nodes
from .ends import TripEnds
from .problem import Optimum
from .routers import Router
from .system import choose_for_system

__all__ = ["Star", "StarChoice"]

Edges = NDArray[np.int64]


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
    """

    case: str
    points: MemberPlans
    cost: float
    bound: float


class Star:
    """One master's route, and what it takes to join and leave it.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    weights : EdgeWeights
        What edges cost.
    ends : sequence of TripEnds, (N,)
        Where vehicles go.
    master : int
        The vehicle that keeps its route.
    router : Router
        How vehicles get to the route and from it.

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
        weights: EdgeWeights,
        ends: Sequence[TripEnds],
        master: int,
        router: Router,
    ) -> None:
        self.net, self.weights, self.ends, self.master = net, weights, ends, master
        self.router = router
        self.alone = [router.route(item.origin, item.destination) for item in ends]
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
        return sum(float(self.weights.solo[route].sum()) for route in self.alone)

    @cached_property
    def _costs(self) -> tuple[Floats, Floats, Floats]:
        """Costs to join (M, K + 1), to leave (M, K + 1) and alone (M,) of the members."""
        nodes = route_nodes(self.net, self.route)
        entry = self.router.table(self._origins, nodes)
        leave = self.router.table(nodes, self._destinations).T
        return entry, leave, self._solo

    @property
    def _solo(self) -> Floats:
        """Costs alone (M,) of the members."""
        pairs = zip(self._origins, self._destinations, strict=True)
        solo = [float(self.router.table(np.array([o]), np.array([d]))[0, 0]) for o, d in pairs]
        return np.array(solo, np.float64)

    def choose(self, case: Any, optimum: Optimum) -> StarChoice:
        """Choose the members' points.

        Parameters
        ----------
        case : {"A", "B", "C"}
            Which points are free.
        optimum : {"member", "system"}
            Whose cost is least.

        Returns
        -------
        StarChoice
            The points, their cost and its bound.

        Raises
        ------
        ScenarioError
            The system's optimum is asked for, and company costs the master more than driving alone.
        """
        everyone = np.arange(len(self.members))
        gain = (self.weights.solo - self.weights.master)[self.route]
        alone = float(self.weights.solo[self.alone[self.master]].sum())
        if optimum == "member" or not self.members:
            points = self._points(case, None, everyone)
            met = _company(points, len(self.route))
            cost = float(points.cost.sum()) + alone - float(gain[met].sum())
            return StarChoice(case, points, cost, cost)
        if (gain < 0).any():
            raise ScenarioError(
                f"objective 'system': edge {self.route[np.argmax(gain < 0)]} costs the master more "
                "in company than alone; plan with objective 'member'"
            )
        found = choose_for_system(
            lambda gains, rows: self._points(case, gains, rows), gain, len(self.members)
        )
        return StarChoice(case, found.members, found.cost + alone, found.bound + alone)

    def _points(self, case: Any, gain: Floats | None, rows: Edges) -> MemberPlans:
        if not len(self.route):
            return _apart(self._solo[rows])
        entry, leave, solo = self._costs
        some = [self.ends[self.members[k]] for k in rows]
        return choose_points(
            self.net, self.weights, self.route, self._origins[rows], self._destinations[rows],
            case, (entry[rows], leave[rows], solo[rows]),
            [item.origins for item in some], [item.destinations for item in some], gain,
        )  # fmt: skip

    def routes(self, points: MemberPlans) -> list[list[Run]]:
        """Return who drives what with whom.

        Parameters
        ----------
        points : MemberPlans
            The members' points.

        Returns
        -------
        list of list of Run, (N, ...)
            Each vehicle's runs in driving order; the master leads.
        """
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
        nodes = self.net.path_nodes(self.route)
        for index, i, j in joined:
            own = self.ends[index]
            before = self.router.route(own.origin, int(nodes[i]))
            after = self.router.route(int(nodes[j]), own.destination)
            routes[index] = [
                *runs_alone(before, index),
                *runs_along(self.route[i:j], companies[i:j]),
                *runs_alone(after, index),
            ]
        return routes


def _apart(solo: Floats) -> MemberPlans:
    """Return the plans of members (N,) whose master drives no road that they could share."""
    nowhere = np.full(len(solo), -1, np.int64)
    return MemberPlans(
        nowhere, nowhere, nowhere, nowhere, solo, solo, np.ones(len(solo), bool)
    )  # fmt: skip


def _company(points: MemberPlans, edges: int) -> NDArray[np.bool_]:
    """Mark the edges of the route (K,) on which the master has company."""
    change = np.zeros(edges + 1, np.int64)
    joined = points.merge_index >= 0
    np.add.at(change, points.merge_index[joined], 1)
    np.add.at(change, points.separation_index[joined], -1)
    return np.cumsum(change[:-1]) > 0
