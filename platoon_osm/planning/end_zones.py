"""Roads for residents, customers and deliveries: open to who starts or ends there, not to others.

Such roads that hang together are a zone, with the open roads that one reaches only through them, as
the yard behind a private gate. A trip whose origin or destination lies inside may drive its zone; a
junction that the open network passes too is not inside, for a trip that starts there needs no such
road. Every other zone is closed to the trip, so nobody drives through one.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork

__all__ = ["EndZones"]

Marks = NDArray[np.bool_]

MOSTLY_CONNECTED = 0.5
"""Share of the open road that must hang together to tell what is behind a zone."""


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
        self._leaves, self._arrives = _public(net, through)
        # Open roads that the rest neither reaches nor is reached from lie behind the zone.
        behind = through & ~(self._leaves[net.head] | self._arrives[net.tail])
        inside = ends | behind
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


def _public(net: RoadNetwork, through: Marks) -> tuple[Marks, Marks]:
    """Mark the nodes from which the open network is reached without a zone, and those it reaches.

    The open network is the largest part of the open roads that is strongly connected; where most
    of them are in none, as on one carriageway, any open road will do.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import breadth_first_order, connected_components

    tail, head = net.tail[through], net.head[through]
    ones = np.ones(len(tail), np.int8)
    graph = csr_array((ones, (tail, head)), shape=(net.n, net.n))
    _, part = connected_components(graph, connection="strong")
    same = part[tail] == part[head]
    metres = np.bincount(part[tail][same], net.length_m[through][same], part.max(initial=0) + 1)
    total = float(net.length_m[through].sum())
    if not total or metres.max(initial=0.0) < MOSTLY_CONNECTED * total:
        leaves, arrives = np.zeros(net.n, bool), np.zeros(net.n, bool)
        leaves[tail], arrives[head] = True, True
        return leaves, arrives
    start = int(np.flatnonzero(part == np.argmax(metres))[0])
    reached = []
    for matrix in (graph.T.tocsr(), graph):
        seen = np.zeros(net.n, bool)
        seen[breadth_first_order(matrix, start, return_predecessors=False)] = True
        reached.append(seen)
    return reached[0], reached[1]
