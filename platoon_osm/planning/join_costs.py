"""What it costs every vehicle to reach the routes of all others: one table, whoever is master."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..network.placed import access_of
from ..network.road_network import RoadNetwork
from .cases import Floats, route_nodes
from .ends import TripEnds
from .fleet import Fleet
from .routers import Router

__all__ = ["JoinCosts", "road_of"]

Index = NDArray[np.int64]

MOST_VALUES = 20_000_000
"""Costs kept at once, 160 MB; with more, each master's are worked out when it is tried."""


def road_of(net: RoadNetwork, route: Index) -> Index:
    """Return the edges of a route that are road, not ways beside it.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    route : ndarray of int, (k,)
        Edge ids in driving order.

    Returns
    -------
    ndarray of int
        Those that others can share.
    """
    return route[~access_of(net, route)]


class JoinCosts:
    """Costs alone between the ends of trips and the nodes of their routes.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    ends : sequence of TripEnds, (N,)
        Where vehicles go.
    routes : sequence of ndarray of int, (N, ...)
        Of each vehicle's route alone what is road, as from `road_of`.
    routers : sequence of Router, (N,)
        How each vehicle gets to a route and from it.
    fleet : Fleet
        Which vehicles are alike.

    Attributes
    ----------
    solo : ndarray of float, (N,)
        Cost of each alone.
    """

    def __init__(
        self,
        net: RoadNetwork,
        ends: Sequence[TripEnds],
        routes: Sequence[Index],
        routers: Sequence[Router],
        fleet: Fleet,
    ) -> None:
        self._routers, self._fleet = routers, fleet
        self._origins = np.array([item.origin for item in ends], np.int64)
        self._destinations = np.array([item.destination for item in ends], np.int64)
        self.nodes = [
            route_nodes(net, route) if len(route) else np.zeros(0, np.int64) for route in routes
        ]
        self.solo = np.array(
            [
                routers[k].table(self._origins[k : k + 1], self._destinations[k : k + 1])[0, 0]
                for k in range(len(ends))
            ],
            np.float64,
        )
        self._known: tuple[Index, Floats, Floats] | None = None

    @cached_property
    def at_once(self) -> bool:
        """Whether the costs of all routes fit into memory at once."""
        return len(self._origins) * len(np.unique(np.concatenate(self.nodes))) <= MOST_VALUES

    def of(self, master: int, members: Sequence[int]) -> tuple[Floats, Floats, Floats]:
        """Return what members pay to join and leave a master's route, and alone.

        Parameters
        ----------
        master : int
            Whose route it is.
        members : sequence of int, (M,)
            Who joins.

        Returns
        -------
        entry : ndarray of float, (M, K + 1)
            Costs alone to each node of the route.
        leave : ndarray of float, (M, K + 1)
            Costs alone from each node.
        solo : ndarray of float, (M,)
            Costs alone all the way.
        """
        some = np.asarray(members, np.int64)
        nodes = self.nodes[master]
        if not self.at_once or len(self.nodes) < 3:
            # Two vehicles ask for one route each; there is nothing to share.
            return *self._between(some, nodes), self.solo[some]
        if self._known is None:
            every = np.unique(np.concatenate(self.nodes))
            self._known = every, *self._between(np.arange(len(self._origins)), every)
        every, entry, leave = self._known
        columns = np.searchsorted(every, nodes)
        return entry[np.ix_(some, columns)], leave[np.ix_(some, columns)], self.solo[some]

    def _between(self, some: Index, nodes: Index) -> tuple[Floats, Floats]:
        """Return what some vehicles (M,) pay from their origins to nodes (K,), and from there."""
        entry, leave = np.empty((len(some), len(nodes))), np.empty((len(some), len(nodes)))
        kind = np.array(self._fleet.kind)[some]
        for one in np.unique(kind).tolist():
            rows = np.flatnonzero(kind == one)
            table = self._routers[int(some[rows[0]])].table
            entry[rows] = table(self._origins[some[rows]], nodes)
            leave[rows] = table(nodes, self._destinations[some[rows]]).T
        return entry, leave
