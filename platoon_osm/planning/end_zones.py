"""Roads for residents, customers and deliveries: open to who starts or ends there, not to others.

Such roads that hang together are a zone, with the open roads that one reaches only through them, as
the yard behind a private gate. A trip whose origin or destination lies inside may drive its zone; a
junction that the open network passes too is not inside, for a trip that starts there needs no such
road. Every other zone is closed to the trip, so nobody drives through one.

A search knows edges, not what was driven before: it may leave the trip's own zone and cut through
it later. Its routes are the best of more than the lawful ones, so one that does not return is best
among these; one that does is found by `returns` and told.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork
from ..network.usable_nodes import UsableNodes

__all__ = ["EndZones"]

Marks = NDArray[np.bool_]


class EndZones:
    """The zones of a network for one kind of vehicle.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    ends : ndarray of bool, (m,)
        Edges that may only be driven at the ends of a trip.
    closed : ndarray of bool, (m,)
        Edges that may not be driven at all.
    """

    def __init__(self, net: RoadNetwork, ends: Marks, closed: Marks) -> None:
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import connected_components

        self._net, self._ends, self._closed = net, ends, closed
        through = ~ends & ~closed
        # Whence the open network is reached without a zone, and what it reaches without one.
        public = UsableNodes(net, ~through)
        self._leaves, self._arrives = public.of("origin"), public.of("destination")
        # Open roads that the rest neither reaches nor is reached from lie behind the zone.
        behind = through & ~(self._leaves[net.head] | self._arrives[net.tail])
        self._inside = inside = ends | behind
        tail, head = net.tail[inside], net.head[inside]
        graph = csr_array((np.ones(len(tail), np.int8), (tail, head)), shape=(net.n, net.n))
        _, self._zone = connected_components(graph, directed=False)

    def closed_to(self, origins: Iterable[int], destinations: Iterable[int]) -> Marks:
        """Mark the edges that are closed to a trip.

        Parameters
        ----------
        origins, destinations : iterable of int
            Nodes where it may start, and end.

        Returns
        -------
        ndarray of bool, (m,)
            Zones of other people, and what is closed anyway.
        """
        inside = [int(self._zone[v]) for v in origins if not self._leaves[v]]
        inside += [int(self._zone[v]) for v in destinations if not self._arrives[v]]
        others: Marks = self._ends & ~np.isin(self._zone[self._net.tail], inside)
        return self._closed | others

    def returns(self, edges: NDArray[np.int64], within: tuple[bool, bool]) -> int | None:
        """Return where a route drives such a road that is neither its first nor its last mile.

        Parameters
        ----------
        edges : ndarray of int64, (k,)
            In driving order; none of them is closed to the trip.
        within : (bool, bool)
            Whether the trip starts, and ends, between the ends of an edge, not at a node.

        Returns
        -------
        int or None
            The first edge of such a piece; None if the route has none.
        """
        inside = self._inside[edges]
        outside = np.flatnonzero(~inside)
        if not len(outside):
            return None
        wrong = self._ends[edges]
        if within[0] or not self._leaves[self._net.tail[edges[0]]]:
            wrong[: outside[0]] = False
        if within[1] or not self._arrives[self._net.head[edges[-1]]]:
            wrong[outside[-1] :] = False
        return int(edges[wrong.argmax()]) if wrong.any() else None
