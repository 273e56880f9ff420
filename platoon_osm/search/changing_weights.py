"""Searches of one network under weights that change from one to the next.

What does not depend on the weight, the order of the edges by tail and head and the bundles of
parallel ones, is worked out once; then a search costs little more than itself.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork
from .least_paths import LeastCosts

__all__ = ["ChangingWeights"]

Floats = NDArray[np.float64]


class ChangingWeights:
    """Single searches under any weight; `net.attached(ChangingWeights)` keeps one.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    """

    def __init__(self, net: RoadNetwork) -> None:
        self._net = net
        self._forward = _Side(net.n, net.tail, net.head)
        self._backward = _Side(net.n, net.head, net.tail)

    def search(
        self, weight: Floats, node: int, forward: bool = True, limit: float = np.inf
    ) -> LeastCosts:
        """Return least costs from a node to all, or to it if not forward, and their paths.

        Parameters
        ----------
        weight : ndarray of float, (m,)
            Cost of each edge, 0 or more; inf where closed.
        node : int
            Node searched from.
        forward : bool
            Whether paths start at the node; else they end there.
        limit : float
            Costs beyond it are of no interest and become inf.

        Returns
        -------
        LeastCosts
            Under the rule of `least_paths`, as from any engine.
        """
        from scipy.sparse.csgraph import dijkstra

        graph = (self._forward if forward else self._backward).graph(weight)
        found: Floats = dijkstra(graph, indices=[node], limit=limit)[0]
        return LeastCosts(self._net, weight, found, node, forward=forward)


class _Side:
    """The edges of a network in the order of one end, parallel ones together."""

    def __init__(self, n: int, near: NDArray[np.int32], far: NDArray[np.int32]) -> None:
        self._n = n
        self._order = np.lexsort((far, near))
        key = near[self._order].astype(np.int64) * n + far[self._order]
        self._first = np.flatnonzero(np.concatenate([[True], key[1:] != key[:-1]])[: len(key)])
        kept = self._order[self._first]
        self._far = far[kept]
        self._begin = np.zeros(n + 1, np.int32)
        np.cumsum(np.bincount(near[kept], minlength=n), out=self._begin[1:])

    def graph(self, weight: Floats) -> Any:
        """Return the matrix of the lightest edges."""
        from scipy.sparse import csr_array

        lightest = weight[self._order]
        if len(lightest):
            lightest = np.minimum.reduceat(lightest, self._first)
        return csr_array((lightest, self._far, self._begin), shape=(self._n, self._n))
