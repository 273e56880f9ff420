"""Which of several equally good paths is taken: one rule, whatever engine found the costs.

Of all paths between two nodes the one is taken

1. that costs least, costs within `TIE` of the least, relative to it, being equal;
2. of these, that has the fewest edges;
3. of these, whose edge ids, read from the origin on, are lexicographically smallest.

Where several nodes may start at a cost of their own, that cost counts, and of starts with equally
few edges to drive the smallest node is taken before the edge ids are compared.

The rule asks for paths, not for trees of predecessors, so an engine need only give the costs D of
all nodes from one place (or to it). Let c(v) be the least cost from node v to the other end t. Edge
(u, v) of weight w lies on a path that is good enough iff

    D(u) + w + c(v) <= (1 + TIE) D(t),

and a search backwards from t that goes along such edges only meets little else than the path it
looks for. What is on the right is one budget for the whole path: it is not granted to each edge
anew, and sums of the same edges in another order, which differ by some 1e-13, do not exceed it. So
the edges found are the same from either end, and under either engine. Most often they are one
path. Else edges are counted from the destination back, and one walk from the origin takes the
smallest edge id that has fewer left to drive. Good edges may add up to a path that is not good
enough; then the least cost is counted for each number of edges, and the walk keeps to the budget.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork
from .arguments import checked_node, no_route
from .tie_rule import TIE

__all__ = ["GoodEdges", "LeastCosts", "fewest_edges", "good_edges"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]

NOWHERE = float("inf")


@dataclass(frozen=True, slots=True, eq=False)
class LeastCosts:
    """Least costs between one place, or nodes where paths may start, and all nodes; their paths.

    Attributes
    ----------
    net : RoadNetwork
        The network searched.
    weight : ndarray of float, (m,)
        Cost of each edge, inf where closed.
    dist : ndarray of float, (n,)
        Cost from the start (forward) or to the root (backward); inf where there is no way, or none
        that was of interest.
    root : int
        The node searched from; -1 where several may start.
    labels : tuple of ndarray of float, (n,)
        Where several nodes may start: what that costs is their sum.
    forward : bool
        Whether paths lead from the root; else they lead there.
    """

    net: RoadNetwork
    weight: Floats
    dist: Floats
    root: int = -1
    labels: tuple[Floats, ...] = ()
    forward: bool = True

    def path(self, node: int) -> Longs:
        """Return the path to a node, or from it if not forward, that the rule chooses.

        Parameters
        ----------
        node : int
            The other end.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order.

        Raises
        ------
        NoRouteError
            If there is no way.
        SearchError
            A node outside the network.
        """
        end = checked_node(self.net, node)
        if not np.isfinite(self.dist[end]):
            raise no_route(self.net, end, self.forward)
        return np.array(_chosen(self, end), np.int64)

    def edges_to(self, nodes: Iterable[int]) -> list[int]:
        """Return the edges of the paths to some nodes, or from them if not forward.

        Parameters
        ----------
        nodes : iterable of int
            The other ends; there is a way to each.

        Returns
        -------
        list of int
            Edge ids; those of equally good paths, too.
        """
        far = {node: float(self.dist[node]) for node in nodes}
        most = max(far.values(), default=0.0)
        ends = {node: most - own for node, own in far.items()}
        limit = most * (1 + TIE)
        return good_edges(
            self.net, self.weight, self.dist, ends, limit, self.forward, self.root
        ).edges

    def label(self, node: int) -> float:
        """Return what starting at a node costs.

        Parameters
        ----------
        node : int
            Node position.

        Returns
        -------
        float
            0 at the root; inf where no path may start.
        """
        if self.root >= 0:
            return 0.0 if node == self.root else NOWHERE
        return float(sum(part[node] for part in self.labels))


@dataclass(frozen=True, slots=True, eq=False)
class GoodEdges:
    """The edges of paths that are good enough, found from one end.

    Attributes
    ----------
    net : RoadNetwork
        The network searched.
    edges : list of int
        Edge ids.
    cost : dict of int to float
        The nodes on these paths, and their least costs to (or from) the end.
    by : dict of int to int
        For each of these nodes but the end, an edge by which it costs that.
    """

    net: RoadNetwork
    edges: list[int]
    cost: dict[int, float]
    by: dict[int, int]


def good_edges(
    net: RoadNetwork,
    weight: Floats,
    dist: Floats,
    ends: dict[int, float],
    limit: float,
    forward: bool = True,
    root: int = -1,
) -> GoodEdges:
    """Return all edges of paths whose cost is within a limit, found from where the paths end.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : ndarray of float, (m,)
        Cost of each edge, inf where closed.
    dist : ndarray of float, (n,)
        Least cost of each node from where paths start (forward), or to where they end (backward).
    ends : dict of int to float
        The nodes at the other end of the paths, and what is added there.
    limit : float
        Cost of a path, with what is added, that is still good enough.
    forward : bool
        Whether `dist` is counted from where paths start.
    root : int
        The only node that `dist` is counted from, or to; -1 if there are several.

    Returns
    -------
    GoodEdges
        Edges, and costs of the nodes they join.
    """
    # Indexing a memoryview gives plain numbers, in half the time that an array takes.
    far, price = dist.data, weight.data
    if forward:
        arrays = net.incoming()
        edges, first, other = arrays[0].data, arrays[1].data, net.tail.data
    else:
        edges, first, other = None, net.first_out.data, net.head.data
    cost = dict(ends)
    by: dict[int, int] = {}
    good: list[int] = []
    queue = sorted((so_far, node) for node, so_far in ends.items())
    while queue:
        so_far, node = heappop(queue)
        if so_far > cost[node] or node == root:
            continue  # found a better way since; or there is no more to go
        begin, stop = first[node], first[node + 1]
        for edge in range(begin, stop) if edges is None else edges[begin:stop]:
            total = so_far + price[edge]
            onward = other[edge]
            if total + far[onward] <= limit and onward != node:
                good.append(edge)
                if total < cost.get(onward, NOWHERE):
                    cost[onward] = total
                    by[onward] = edge
                    heappush(queue, (total, onward))
    return GoodEdges(net, good, cost, by)


def fewest_edges(
    net: RoadNetwork, edges: Iterable[int], starts: Collection[int], end: int
) -> list[int]:
    """Return the path along some edges that has the fewest, and of these the smallest edge ids.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    edges : iterable of int
        Edge ids that the path may take.
    starts : collection of int
        Nodes where it may start; of equally near ones the smallest is taken.
    end : int
        Node where it ends; it can be reached from a start.

    Returns
    -------
    list of int
        Edge ids in driving order.
    """
    out, into = _joined(net, edges)
    tail, head = net.tail.data, net.head.data
    left = {end: 0}
    wave = [end]
    for node in wave:
        for edge in into.get(node, ()):
            before = tail[edge]
            if before not in left:
                left[before] = left[node] + 1
                wave.append(before)
    node = min((node for node in starts if node in left), key=lambda node: (left[node], node))
    path: list[int] = []
    for rest in range(left[node] - 1, -1, -1):
        path.append(next(edge for edge in out[node] if left.get(head[edge]) == rest))
        node = head[path[-1]]
    return path


def _chosen(costs: LeastCosts, end: int) -> list[int]:
    """Return the edges of the path between the root, or a start, and a node."""
    net, forward, root = costs.net, costs.forward, costs.root
    limit = float(costs.dist[end]) * (1 + TIE)
    good = good_edges(net, costs.weight, costs.dist, {end: 0.0}, limit, forward, root)
    if root >= 0 and len(good.edges) == len(good.cost) - 1:
        return _only(good, root, end, forward)
    if forward:
        starts = {node: costs.label(node) for node in good.cost}
        starts = {node: cost for node, cost in starts.items() if cost + good.cost[node] <= limit}
        before: Callable[[int], float] = costs.dist.data.__getitem__
    else:
        starts, end = {end: 0.0}, root
        before = good.cost.__getitem__
    path = fewest_edges(net, good.edges, starts, end)
    start = int(net.tail[path[0]]) if path else end
    total = starts[start] + sum(costs.weight[path].tolist())
    if total <= limit:
        return path
    return _within_budget(costs, good, before, starts, end, limit) or path


def _only(good: GoodEdges, root: int, end: int, forward: bool) -> list[int]:
    """Return the edges of the only path there is."""
    step = (good.net.head if forward else good.net.tail).data
    path = []
    node = root
    while node != end:
        path.append(good.by[node])
        node = step[path[-1]]
    return path if forward else path[::-1]


def _joined(
    net: RoadNetwork, edges: Iterable[int]
) -> tuple[dict[int, list[int]], dict[int, list[int]]]:
    """Return of some edges those that leave each node, and those that reach it, ascending."""
    tail, head = net.tail.data, net.head.data
    out: dict[int, list[int]] = {}
    into: dict[int, list[int]] = {}
    for edge in sorted(edges):
        out.setdefault(tail[edge], []).append(edge)
        into.setdefault(head[edge], []).append(edge)
    return out, into


def _within_budget(
    costs: LeastCosts,
    good: GoodEdges,
    before: Callable[[int], float],
    starts: dict[int, float],
    end: int,
    limit: float,
) -> list[int] | None:
    """Return what `fewest_edges` would, where edges add up to paths that are not good enough.

    The k-th layer holds the least cost to the end with exactly k edges; `before` tells the least
    cost of getting to a node.
    """
    out, into = _joined(good.net, good.edges)
    tail, head, weight = good.net.tail.data, good.net.head.data, costs.weight.data
    layers = [{end: 0.0}]
    while not (able := _able(starts, layers[-1], limit)):
        layer: dict[int, float] = {}
        for node, cost in layers[-1].items():
            for edge in into.get(node, ()):
                onward, total = tail[edge], cost + weight[edge]
                if total + before(onward) <= limit and total < layer.get(onward, NOWHERE):
                    layer[onward] = total
        if not layer or len(layers) > len(good.cost):
            return None
        layers.append(layer)
    node = min(able)
    spent = starts[node]
    path: list[int] = []
    for layer in layers[-2::-1]:
        rest = {edge: weight[edge] + layer.get(head[edge], NOWHERE) for edge in out[node]}
        # Sums in another order may miss the budget by a last digit; the least then keeps to it.
        least = min(rest, key=rest.__getitem__)
        path.append(next((edge for edge in rest if spent + rest[edge] <= limit), least))
        spent += weight[path[-1]]
        node = head[path[-1]]
    return path


def _able(starts: dict[int, float], layer: dict[int, float], limit: float) -> list[int]:
    """Return the starts from which the end is reached within the limit."""
    return [v for v, cost in layer.items() if starts.get(v, NOWHERE) + cost <= limit]
