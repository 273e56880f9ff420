"""The searches of a plan: each made once, handed down, and forgotten with it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import SearchError
from .arguments import checked_node, checked_nodes, described
from .protocol import Engine, LeastCosts

__all__ = ["KEPT_BYTES", "Trees"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]

KEPT_BYTES = 256 * 2**20
"""Rows are kept up to this: 670 searches of 50,000 nodes, 33 of a million, more than a plan of a
master and its members asks for twice."""


class Trees:
    """Searches of one engine that several parts of a plan need.

    Parameters
    ----------
    engine : Engine
        Searches under one weight.

    Attributes
    ----------
    engine : Engine
        The same.
    searches : int
        Single-source searches run so far.

    Raises
    ------
    SearchError
        If it is no engine.
    """

    def __init__(self, engine: Engine) -> None:
        if not hasattr(engine, "trees") or not hasattr(engine, "net"):
            raise SearchError(
                f"engine is {described(engine)}; give one, as from Searches(net).under(weight)"
            )
        self.engine = engine
        self.searches = 0
        self._known: dict[tuple[int, bool], LeastCosts] = {}

    def tree(self, node: int, forward: bool = True) -> LeastCosts:
        """Return least costs and paths from a node to all, or from all to it.

        Parameters
        ----------
        node : int
            Node searched from.
        forward : bool
            Whether paths start at the node; else they end there.

        Returns
        -------
        LeastCosts
            Costs of all nodes, and their paths.
        """
        return self.trees([checked_node(self.engine.net, node)], forward)[0]

    def trees(self, nodes: ArrayLike, forward: bool = True) -> list[LeastCosts]:
        """Return least costs and paths of several nodes; missing ones are searched together.

        Parameters
        ----------
        nodes : array_like of int, (k,)
            Nodes searched from.
        forward : bool
            Whether paths start at the nodes; else they end there.

        Returns
        -------
        list of LeastCosts
            One a node.
        """
        wanted = checked_nodes(self.engine.net, nodes).tolist()
        forward = bool(forward)
        missing = [node for node in dict.fromkeys(wanted) if (node, forward) not in self._known]
        found = dict(zip(missing, self.engine.trees(missing, forward), strict=True))
        self.searches += len(missing)
        result = [found[node] if node in found else self._known[node, forward] for node in wanted]
        for node, tree in found.items():
            self._known[node, forward] = tree
        most = max(KEPT_BYTES // (8 * max(self.engine.net.n, 1)), 1)
        for key in list(self._known)[:-most]:
            del self._known[key]
        return result

    def costs(self, nodes: ArrayLike, forward: bool = True) -> Floats:
        """Return least costs from some nodes to all, or from all to these.

        Parameters
        ----------
        nodes : array_like of int, (k,)
            Nodes searched from.
        forward : bool
            Whether paths start at the nodes; else they end there.

        Returns
        -------
        ndarray of float, (k, n)
            Costs; inf where there is no way.
        """
        rows = [tree.dist for tree in self.trees(nodes, forward)]
        return np.array(rows).reshape(len(rows), self.engine.net.n)

    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats:
        """Return what `costs` does, under the name that engines give it.

        Parameters
        ----------
        nodes : array_like of int, (k,)
            Nodes searched from.
        forward : bool
            Whether paths start at the nodes; else they end there.

        Returns
        -------
        ndarray of float, (k, n)
            Costs; inf where there is no way.
        """
        return self.costs(nodes, forward)

    def path(self, source: int, target: int) -> Longs:
        """Return the edges of the least-cost path between two nodes.

        Parameters
        ----------
        source : int
            Node where it starts.
        target : int
            Node where it ends.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order; from whichever search is known, for all find the same path.

        Raises
        ------
        NoRouteError
            There is no way.
        """
        start, end = (checked_node(self.engine.net, node) for node in (source, target))
        if (start, True) not in self._known and (end, False) in self._known:
            return self._known[end, False].path(start)
        return self.tree(start).path(end)

    def table(self, sources: ArrayLike, targets: ArrayLike) -> Floats:
        """Return least costs between sources and targets, from known searches where there are.

        Parameters
        ----------
        sources : array_like of int, (S,)
            Nodes where paths start.
        targets : array_like of int, (T,)
            Nodes where they end.

        Returns
        -------
        ndarray of float, (S, T)
            Costs; inf where there is no way.
        """
        net = self.engine.net
        start, row = np.unique(checked_nodes(net, sources), return_inverse=True)
        end, column = np.unique(checked_nodes(net, targets), return_inverse=True)
        found = np.empty((len(start), len(end)))
        new_start = np.array([(node, True) not in self._known for node in start.tolist()], bool)
        new_end = np.array([(node, False) not in self._known for node in end.tolist()], bool)
        for k in np.flatnonzero(~new_end).tolist():
            found[:, k] = self._known[int(end[k]), False].dist[start]
        for k in np.flatnonzero(~new_start).tolist():
            found[k] = self._known[int(start[k]), True].dist[end]
        if new_start.any() and new_end.any():
            found[np.ix_(new_start, new_end)] = self._missing(start[new_start], end[new_end])
        return found[row[:, None], column]

    def _missing(self, start: Longs, end: Longs) -> Floats:
        """Return costs (S, T) that no known row holds."""
        if self.engine.name == "hierarchy":
            # It looks at little more than the way between both; whole rows would cost more.
            self.searches += min(len(start), len(end))
            return self.engine.many_to_many(start, end)
        if len(start) <= len(end):
            return self.costs(start)[:, end]
        return self.costs(end, forward=False)[:, start].T
