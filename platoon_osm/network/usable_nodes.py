"""Nodes where a trip may start or end: from there, or to there, the main network is connected."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .components import MOSTLY_CONNECTED, connected_share, strong_components
from .location import Role
from .road_network import RoadNetwork

__all__ = ["UsableNodes"]


class UsableNodes:
    """Nodes of a network by the part they can play in a trip; kept with it by `net.attached`.

    An origin is a node from which the main strong component is reached, a destination one that it
    reaches, any node one inside it. Where most of the road is in no such component, as on a single
    motorway without a way back, it is no measure: then a trip may start wherever a road leads on,
    and end wherever one arrives.

    Parameters
    ----------
    net : RoadNetwork
        Whose nodes.
    closed : ndarray of bool, (m,), optional
        Edges that count as none, for they are closed to a vehicle.
    """

    def __init__(self, net: RoadNetwork, closed: NDArray[np.bool_] | None = None) -> None:
        # Not the network itself, which holds this: both would outlive their use together.
        self._m, self._n = net.m, net.n
        self._open = np.ones(net.m, bool) if closed is None else ~closed
        self._ends = net.tail, net.head
        self._tail, self._head = net.tail[self._open], net.head[self._open]
        part = net.strong_component() if closed is None else strong_components(net, self._open)
        self._main: NDArray[np.bool_] = part == 0
        self._mostly = connected_share(net, part, self._open) >= MOSTLY_CONNECTED
        self._by_role: dict[Role, NDArray[np.bool_]] = {}

    def of(self, role: Role) -> NDArray[np.bool_]:
        """Mark the nodes that fit a role.

        Parameters
        ----------
        role : {"origin", "destination", "any"}
            What the node is to be.

        Returns
        -------
        ndarray of bool, (n,)
            Read-only.
        """
        if role not in self._by_role:
            nodes = self._found(role)
            nodes.flags.writeable = False
            self._by_role[role] = nodes
        return self._by_role[role]

    def edges(self, role: Role) -> NDArray[np.bool_]:
        """Mark the edges on which a trip may start or end between two nodes.

        Parameters
        ----------
        role : {"origin", "destination", "any"}
            What the place is to be.

        Returns
        -------
        ndarray of bool, (m,)
            Those that lead to a node that fits, or come from one.
        """
        if not self._mostly:
            return self._open
        fits, (tail, head) = self.of(role), self._ends
        if role == "origin":
            return self._open & fits[head]
        return self._open & (fits[tail] if role == "destination" else fits[tail] | fits[head])

    def _found(self, role: Role) -> NDArray[np.bool_]:
        if not self._mostly:
            leaves = np.bincount(self._tail, minlength=self._n) > 0
            arrives = np.bincount(self._head, minlength=self._n) > 0
            by_role: dict[Role, NDArray[np.bool_]] = {
                "origin": leaves, "destination": arrives, "any": leaves | arrives,
            }  # fmt: skip
            return by_role[role]
        if role == "any":
            return self._main
        ends = (self._head, self._tail) if role == "origin" else (self._tail, self._head)
        return self._closure(*ends)

    def _closure(self, tail: NDArray[np.int32], head: NDArray[np.int32]) -> NDArray[np.bool_]:
        """Mark all nodes that the main component reaches over these edges, itself included."""
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import breadth_first_order

        # One extra node leads to the whole component, so that one walk finds all that hangs on it.
        n, start = self._n, np.flatnonzero(self._main)
        tails = np.concatenate([tail, np.full(len(start), n)])
        heads = np.concatenate([head, start])
        graph = csr_array((np.ones(len(tails), np.int8), (tails, heads)), shape=(n + 1, n + 1))
        seen = np.zeros(n + 1, bool)
        seen[breadth_first_order(graph, n, return_predecessors=False)] = True
        reached: NDArray[np.bool_] = seen[:n]
        return reached
