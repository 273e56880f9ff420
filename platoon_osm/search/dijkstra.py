"""Shortest paths by scipy's Dijkstra: the reference engine, and the oracle of every faster one."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..network.road_network import RoadNetwork
from .arguments import checked_labels, checked_node, checked_nodes, checked_weight, no_route
from .joining import Found, Positions, best_pairs, entry_exit_costs, only_at

__all__ = ["ReferenceEngine", "Tree", "astar"]

Floats = NDArray[np.float64]
Edges = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Tree:
    """Least costs between one place and all nodes, and the edges that give them.

    Attributes
    ----------
    dist : (n,) cost from the source (forward) or to the target (backward); inf if unreachable.
    edge : (n,) edge by which the path enters (forward) or leaves (backward) each node; -1 none.
    forward : direction of the search.
    """

    net: RoadNetwork
    dist: Floats
    edge: Edges
    forward: bool

    def path(self, node: int) -> Edges:
        """Return edge ids, in driving order, of the least-cost path to (or from) a node.

        Raises
        ------
        NoRouteError
            If the node cannot be reached.
        """
        if not np.isfinite(self.dist[node]):
            raise no_route(self.net, node, self.forward)
        step = self.net.tail if self.forward else self.net.head
        edges = []
        while (edge := int(self.edge[node])) >= 0:
            edges.append(edge)
            node = int(step[edge])
        return np.array(edges[::-1] if self.forward else edges, np.int64)


class ReferenceEngine:
    """Searches of one network under one weight.

    Parallel edges stay apart in the network; here the lightest of them stands for all. Edges of
    infinite weight are closed.

    Parameters
    ----------
    weight : (m,) costs, not negative and not NaN.

    Raises
    ------
    ValueError
        A weight that is negative, NaN or of the wrong shape.
    """

    name = "reference"

    def __init__(self, net: RoadNetwork, weight: ArrayLike) -> None:
        from scipy.sparse import csr_array

        values = checked_weight(net, weight)
        self.net = net
        self.weight = values.copy()
        open_edges = np.flatnonzero(np.isfinite(values))
        key = net.tail[open_edges].astype(np.int64) * net.n + net.head[open_edges]
        order = np.lexsort((open_edges, values[open_edges], key))
        key = key[order]
        lightest = np.ones(len(key), bool)
        lightest[1:] = key[1:] != key[:-1]
        self._edge = open_edges[order][lightest]
        self._key = key[lightest]
        shape = (net.n, net.n)
        tails, heads = net.tail[self._edge], net.head[self._edge]
        first = np.zeros(net.n + 1, np.int32)
        np.cumsum(np.bincount(tails, minlength=net.n), out=first[1:])
        self._forward = csr_array((values[self._edge], heads, first), shape=shape)
        by_head = np.lexsort((tails, heads))
        first_in = np.zeros(net.n + 1, np.int32)
        np.cumsum(np.bincount(heads, minlength=net.n), out=first_in[1:])
        self._backward = csr_array(
            (values[self._edge][by_head], tails[by_head], first_in), shape=shape
        )

    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats:
        """Return costs (k, n) from each of k nodes to all, or from all to each if not forward."""
        from scipy.sparse.csgraph import dijkstra

        wanted = checked_nodes(self.net, nodes)
        if not len(wanted):
            return np.zeros((0, self.net.n))
        distinct, back = np.unique(wanted, return_inverse=True)
        graph = self._forward if forward else self._backward
        found: Floats = np.atleast_2d(dijkstra(graph, indices=distinct))
        return found[back]

    def tree(self, node: int, forward: bool = True) -> Tree:
        """Return the tree of least-cost paths from a node, or to it if not forward."""
        from scipy.sparse.csgraph import dijkstra

        start = checked_node(self.net, node)
        graph = self._forward if forward else self._backward
        dist, before = dijkstra(graph, True, np.array(start), True)
        return Tree(self.net, dist, self._edges_of(before, forward), forward)

    def trees(self, nodes: ArrayLike, forward: bool = True) -> list[Tree]:
        """Return the trees of several nodes."""
        return [self.tree(node, forward) for node in checked_nodes(self.net, nodes).tolist()]

    def seeded(self, labels: ArrayLike) -> Tree:
        """Search forward from all nodes at once, node x starting at cost `labels[x]`.

        Parameters
        ----------
        labels : (n,) starting costs; inf where no path may start.

        Returns
        -------
        Tree
            `edge` is -1 where the best path starts at the node itself.
        """
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import dijkstra

        seeds = checked_labels(self.net, labels)
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
        dist, before = dijkstra(graph, True, np.array(n), True)
        before = before[:n].copy()
        before[before == n] = -1
        return Tree(self.net, dist[:n], self._edges_of(before, True), True)

    def shared_stretch(
        self,
        pair: ArrayLike,
        there: Sequence[Floats],
        onward: Sequence[Floats],
        limit: float,
        slack: float = 0.0,
    ) -> Tree:
        """Return the least costs of two vehicles that meet, and drive together, up to each node.

        Parameters
        ----------
        pair : (m,) cost of both together.
        there, onward : two arrays (n,) each: costs alone, under this engine's weight, from the
            origins and to the destinations.
        limit, slack : costs are exact at every node that a plan passes or parts at which costs at
            most `limit`, and at most `slack` more than the best; elsewhere they may be inf.
        """
        del onward, limit, slack  # this search finds everything, whatever is needed
        return ReferenceEngine(self.net, pair).seeded(there[0] + there[1])

    def many_to_many(self, sources: ArrayLike, targets: ArrayLike) -> Floats:
        """Return least costs (S, T) between sources and targets, searched from the fewer."""
        start, end = checked_nodes(self.net, sources), checked_nodes(self.net, targets)
        if len(start) <= len(end):
            return self.distances(start)[:, end]
        return self.distances(end, forward=False)[:, start].T

    def one_to_many(self, source: int, targets: ArrayLike) -> Floats:
        """Return least costs (T,) from a source to targets."""
        row: Floats = self.distances(source)[0, checked_nodes(self.net, targets)]
        return row

    def path(self, source: int, target: int) -> Edges:
        """Return the edges of a least-cost path.

        Raises
        ------
        NoRouteError
            If there is none.
        """
        return self.tree(source).path(int(checked_nodes(self.net, target)[0]))

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
        route : (K + 1,) nodes.
        origins, destinations : (N,) nodes.
        platoon, length_m : (K + 1,) platoon weight and metres along the route up to each node.
        entries, exits : positions each member may use, as first (N + 1,) and positions; by
            default all.

        Returns
        -------
        i, j : (N,) -1 where staying alone is cheaper.
        cost, solo : (N,)
        """
        start, end = checked_nodes(self.net, origins), checked_nodes(self.net, destinations)
        entry, leave, solo = entry_exit_costs(self, checked_nodes(self.net, route), start, end)
        i, j, cost = best_pairs(
            only_at(entry, entries), only_at(leave, exits), platoon, length_m, solo
        )
        return i, j, cost, solo

    def _edges_of(self, before: NDArray[np.int32], forward: bool) -> Edges:
        nodes = np.arange(self.net.n, dtype=np.int64)
        edges = np.full(self.net.n, -1, np.int64)
        known = before >= 0
        pairs = (before, nodes) if forward else (nodes, before)
        key = pairs[0][known].astype(np.int64) * self.net.n + pairs[1][known]
        edges[known] = self._edge[np.searchsorted(self._key, key)]
        return edges


def astar(
    net: RoadNetwork, weight: ArrayLike, source: int, target: int, heuristic: ArrayLike
) -> tuple[float, Edges]:
    """Search by A* with a closed set, as in the paper: no node is opened twice.

    With an admissible and consistent heuristic the answer is optimal; with the paper's inflated
    one (section 2 of the method) it is only a route, and the caller reports its excess.

    Parameters
    ----------
    weight : (m,) costs, not negative.
    heuristic : (n,) estimated cost from each node to the target.

    Returns
    -------
    cost, edges
        Cost inf and no edges if there is no route.
    """
    costs = np.asarray(weight, np.float64)
    estimate = np.asarray(heuristic, np.float64)
    best: dict[int, float] = {source: 0.0}
    entered: dict[int, int] = {}
    closed: set[int] = set()
    queue = [(float(estimate[source]), source)]
    while queue:
        _, node = heapq.heappop(queue)
        if node in closed:
            continue
        if node == target:
            edges = []
            while node != source:
                edges.append(entered[node])
                node = int(net.tail[edges[-1]])
            return best[target], np.array(edges[::-1], np.int64)
        closed.add(node)
        for edge in range(net.first_out[node], net.first_out[node + 1]):
            head = int(net.head[edge])
            cost = best[node] + float(costs[edge])
            if head not in closed and cost < best.get(head, np.inf):
                best[head] = cost
                entered[head] = edge
                heapq.heappush(queue, (cost + float(estimate[head]), head))
    return float("inf"), np.zeros(0, np.int64)
