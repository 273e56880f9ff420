"""Shortest paths by scipy's Dijkstra: the reference engine, and the oracle of every faster one."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..network.road_network import RoadNetwork
from .arguments import (
    checked_along,
    checked_labels,
    checked_network,
    checked_node,
    checked_nodes,
    checked_pairs,
    checked_positions,
    checked_two,
    checked_weight,
)  # fmt: skip
from .joining import Found, Positions, best_pairs, entry_exit_costs, only_at
from .least_paths import LeastCosts

__all__ = ["ReferenceEngine", "Tree", "lightest_edges"]

Floats = NDArray[np.float64]
Edges = NDArray[np.int64]
Tree = LeastCosts


def lightest_edges(net: RoadNetwork, weight: Floats) -> Edges:
    """Return of each bundle of parallel edges the lightest, by tail and head; none that is closed.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : ndarray of float, (m,)
        Cost of each edge, 0 or more; inf where closed.

    Returns
    -------
    ndarray of int, (k,)
        Edge ids; of equally light ones the smallest.
    """
    open_edges = np.flatnonzero(np.isfinite(weight))
    key = net.tail[open_edges].astype(np.int64) * net.n + net.head[open_edges]
    order = np.lexsort((weight[open_edges], key))
    key = key[order]
    first = np.ones(len(key), bool)
    first[1:] = key[1:] != key[:-1]
    found: Edges = open_edges[order][first]
    return found


class ReferenceEngine:
    """Searches of one network under one weight.

    Parallel edges stay apart in the network; here the lightest of them stands for all. Edges of
    infinite weight are closed.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.

    Attributes
    ----------
    net : RoadNetwork
        The network searched.
    weight : ndarray of float, (m,)
        A copy of the costs.

    Raises
    ------
    SearchError
        A weight that is negative, NaN or of the wrong shape.
    """

    name = "reference"

    def __init__(self, net: RoadNetwork, weight: ArrayLike) -> None:
        from scipy.sparse import csr_array

        self.net = checked_network(net)
        # A copy, for paths are chosen under the weight that the costs were found with.
        values = checked_weight(net, weight).copy()
        self.weight = values
        edge = lightest_edges(net, values)
        shape = (net.n, net.n)
        tails, heads = net.tail[edge], net.head[edge]
        first = np.zeros(net.n + 1, np.int32)
        np.cumsum(np.bincount(tails, minlength=net.n), out=first[1:])
        self._forward = csr_array((values[edge], heads, first), shape=shape)
        by_head = np.lexsort((tails, heads))
        first_in = np.zeros(net.n + 1, np.int32)
        np.cumsum(np.bincount(heads, minlength=net.n), out=first_in[1:])
        self._backward = csr_array((values[edge][by_head], tails[by_head], first_in), shape=shape)

    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats:
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
        from scipy.sparse.csgraph import dijkstra

        wanted = checked_nodes(self.net, nodes)
        if not len(wanted):
            return np.zeros((0, self.net.n))
        distinct, back = np.unique(wanted, return_inverse=True)
        graph = self._forward if forward else self._backward
        found: Floats = np.atleast_2d(dijkstra(graph, indices=distinct))
        return found if len(distinct) == 1 == len(wanted) else found[back]

    def tree(self, node: int, forward: bool = True) -> LeastCosts:
        """Return least costs from a node to all, or to it if not forward, and their paths.

        Parameters
        ----------
        node : int
            Node searched from.
        forward : bool
            Whether paths start at the node; else they end there.

        Returns
        -------
        LeastCosts
            Costs of all nodes; paths are found when they are asked for.
        """
        return self.trees([checked_node(self.net, node)], forward)[0]

    def trees(self, nodes: ArrayLike, forward: bool = True) -> list[LeastCosts]:
        """Return the trees of several nodes.

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
        wanted = checked_nodes(self.net, nodes)
        rows = self.distances(wanted, forward)
        return [
            LeastCosts(self.net, self.weight, row, node, forward=bool(forward))
            for node, row in zip(wanted.tolist(), rows, strict=True)
        ]

    def seeded(self, labels: ArrayLike) -> LeastCosts:
        """Search forward from all nodes at once, each starting at a cost of its own.

        Parameters
        ----------
        labels : array_like of float, (n,)
            Starting costs; inf where no path may start.

        Returns
        -------
        LeastCosts
            Costs of all nodes; a path is empty where it is best to start at the node itself.
        """
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import dijkstra

        seeds = checked_labels(self.net, labels).copy()
        n = self.net.n
        starts = np.flatnonzero(np.isfinite(seeds))
        # One extra node with an edge of the label's cost to every start makes it one search.
        graph = csr_array(
            (
                np.concatenate([self._forward.data, seeds[starts]]),
                np.concatenate([self._forward.indices, starts]),
                np.append(self._forward.indptr, self._forward.indptr[-1] + len(starts)),
            ),
            shape=(n + 1, n + 1),
        )
        dist: Floats = dijkstra(graph, indices=np.array(n))
        return LeastCosts(self.net, self.weight, dist[:n], labels=(seeds,))

    def shared_stretch(
        self,
        pair: ArrayLike,
        there: Sequence[Floats],
        onward: Sequence[Floats],
        limit: float,
        slack: float = 0.0,
    ) -> LeastCosts:
        """Return least costs of two vehicles that meet, and drive together, up to each node.

        Parameters
        ----------
        pair : array_like of float, (m,)
            Cost of each edge for both together.
        there : sequence of array_like of float, (n,)
            Of either vehicle the costs alone, under this engine's weight, from its origin.
        onward : sequence of array_like of float, (n,)
            Of either vehicle the costs alone to its destination.
        limit : float
            Costs are exact at every node that a plan passes or parts at which costs at most this;
            elsewhere they may be inf.
        slack : float
            The same of plans that cost at most so much more than the best.

        Returns
        -------
        LeastCosts
            Costs of both; a path is what they drive together.
        """
        checked_two(self.net, onward, "onward")
        del limit, slack  # this search finds everything, whatever is needed
        one, other = checked_two(self.net, there, "there")
        return ReferenceEngine(self.net, checked_weight(self.net, pair, "pair")).seeded(one + other)

    def many_to_many(self, sources: ArrayLike, targets: ArrayLike) -> Floats:
        """Return least costs between sources and targets, searched from the fewer.

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
        start, end = checked_nodes(self.net, sources), checked_nodes(self.net, targets)
        if len(start) <= len(end):
            return self.distances(start)[:, end]
        return self.distances(end, forward=False)[:, start].T

    def one_to_many(self, source: int, targets: ArrayLike) -> Floats:
        """Return least costs from a source to targets.

        Parameters
        ----------
        source : int
            Node where paths start.
        targets : array_like of int, (T,)
            Nodes where they end.

        Returns
        -------
        ndarray of float, (T,)
            Costs; inf where there is no way.
        """
        start, end = checked_node(self.net, source), checked_nodes(self.net, targets)
        row: Floats = self.distances(start)[0, end]
        return row

    def path(self, source: int, target: int) -> Edges:
        """Return the edges of the least-cost path, chosen as `least_paths` says.

        Parameters
        ----------
        source : int
            Node where the path starts.
        target : int
            Node where it ends.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order.

        Raises
        ------
        NoRouteError
            If there is none.
        """
        return self.tree(source).path(target)

    def best_on_route(
        self,
        route: Edges,
        origins: Edges,
        destinations: Edges,
        platoon: Floats,
        length_m: Floats,
        entries: Positions | None = None,
        exits: Positions | None = None,
    ) -> Found:
        """Return for N members the best positions i < j on a route, and what they cost.

        Parameters
        ----------
        route : array_like of int, (K + 1,)
            Nodes of the route.
        origins : array_like of int, (N,)
            Nodes where members start.
        destinations : array_like of int, (N,)
            Nodes where they go.
        platoon : array_like of float, (K + 1,)
            Platoon weight along the route up to each node.
        length_m : array_like of float, (K + 1,)
            Metres along the route up to each node.
        entries : tuple of array_like of int, optional
            Positions where each member may join, as first (N + 1,) and positions; by default all.
        exits : tuple of array_like of int, optional
            Positions where each member may leave, likewise.

        Returns
        -------
        i : ndarray of int, (N,)
            Positions where they join; -1 where staying alone is cheaper.
        j : ndarray of int, (N,)
            Positions where they leave; -1 likewise.
        cost : ndarray of float, (N,)
            What each pays.
        solo : ndarray of float, (N,)
            What each pays alone.
        """
        nodes = checked_nodes(self.net, route)
        start, end = checked_pairs(self.net, origins, destinations)
        along = checked_along(nodes, platoon, "platoon")
        metres = checked_along(nodes, length_m, "length_m")
        join = checked_positions(nodes, len(start), entries, "entries")
        part = checked_positions(nodes, len(start), exits, "exits")
        entry, leave, solo = entry_exit_costs(self, nodes, start, end)
        i, j, cost = best_pairs(only_at(entry, join), only_at(leave, part), along, metres, solo)
        return i, j, cost, solo
