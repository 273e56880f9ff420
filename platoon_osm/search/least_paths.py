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

from collections.abc import Callable
from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork
from .arguments import checked_node, no_route
from .joining import TIE

__all__ = ["LeastCosts"]

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

    def _label(self, node: int) -> float:
        """Return what starting at a node costs."""
        if self.root >= 0:
            return 0.0 if node == self.root else NOWHERE
        return float(sum(part[node] for part in self.labels))


@dataclass(frozen=True, slots=True, eq=False)
class _Good:
    """The edges of paths that are good enough.

    Attributes
    ----------
    out : for each node on them, the edges by which they go on.
    into : for each node on them, the edges by which they come.
    before : least cost of getting to a node from where paths start.
    head, tail, weight : of an edge.
    """

    out: dict[int, list[int]]
    into: dict[int, list[int]]
    before: Callable[[int], float]
    head: memoryview
    tail: memoryview
    weight: memoryview


def _chosen(costs: LeastCosts, end: int) -> list[int]:
    """Return the edges of the path between the root, or a start, and a node."""
    net, forward, root = costs.net, costs.forward, costs.root
    # Indexing a memoryview gives plain numbers, in half the time that an array takes.
    dist, weight = costs.dist.data, costs.weight.data
    head, tail = net.head.data, net.tail.data
    limit = dist[end] * (1 + TIE)
    if forward:
        arrays = net.incoming()
        edges, first, other = arrays[0].data, arrays[1].data, tail
    else:
        edges, first, other = None, net.first_out.data, head
    cost = {end: 0.0}
    by: dict[int, int] = {}
    good: list[int] = []
    queue = [(0.0, end)]
    while queue:
        so_far, node = heappop(queue)
        if so_far > cost[node] or node == root:
            continue  # found a better way since; or there is no more to go
        begin, stop = first[node], first[node + 1]
        for edge in range(begin, stop) if edges is None else edges[begin:stop]:
            total = so_far + weight[edge]
            onward = other[edge]
            if total + dist[onward] <= limit and onward != node:
                good.append(edge)
                if total < cost.get(onward, NOWHERE):
                    cost[onward] = total
                    by[onward] = edge
                    heappush(queue, (total, onward))
    if root >= 0 and len(good) == len(cost) - 1:
        return _only(by, root, end, head if forward else tail, forward)
    out: dict[int, list[int]] = {}
    into: dict[int, list[int]] = {}
    for edge in sorted(good):
        out.setdefault(tail[edge], []).append(edge)
        into.setdefault(head[edge], []).append(edge)
    before = dist.__getitem__ if forward else cost.__getitem__
    ways = _Good(out, into, before, head, tail, weight)
    if not forward:
        return _fewest(ways, {end: 0.0}, root, limit)
    starts = {node: costs._label(node) for node in cost}
    starts = {node: label for node, label in starts.items() if label + cost[node] <= limit}
    return _fewest(ways, starts, end, limit)


def _only(by: dict[int, int], root: int, end: int, step: memoryview, forward: bool) -> list[int]:
    """Return the edges of the only path there is."""
    path = []
    node = root
    while node != end:
        path.append(by[node])
        node = step[path[-1]]
    return path if forward else path[::-1]


def _fewest(good: _Good, starts: dict[int, float], end: int, limit: float) -> list[int]:
    """Return the path of fewest edges from a start, of these the lexicographically smallest."""
    left = {end: 0}
    wave = [end]
    for node in wave:
        for edge in good.into.get(node, ()):
            before = good.tail[edge]
            if before not in left:
                left[before] = left[node] + 1
                wave.append(before)
    node = min((node for node in starts if node in left), key=lambda node: (left[node], node))
    total = starts[node]
    path: list[int] = []
    for rest in range(left[node] - 1, -1, -1):
        edge = next(e for e in good.out[node] if left.get(good.head[e]) == rest)
        path.append(edge)
        total += good.weight[edge]
        node = good.head[edge]
    return path if total <= limit else _within_budget(good, starts, end, limit) or path


def _within_budget(
    good: _Good, starts: dict[int, float], end: int, limit: float
) -> list[int] | None:
    """Return the same as `_fewest`, where good edges add up to paths that are not good enough.

    The k-th layer holds the least cost to the end with exactly k edges.
    """
    layers = [{end: 0.0}]
    while not (able := _able(starts, layers[-1], limit)):
        layer: dict[int, float] = {}
        for node, cost in layers[-1].items():
            for edge in good.into.get(node, ()):
                before, total = good.tail[edge], cost + good.weight[edge]
                fits = total + good.before(before) <= limit
                if fits and total < layer.get(before, NOWHERE):
                    layer[before] = total
        if not layer or len(layers) > len(good.into):
            return None
        layers.append(layer)
    node = min(able)
    spent = starts[node]
    path: list[int] = []
    for layer in layers[-2::-1]:
        rest = {
            edge: good.weight[edge] + layer.get(good.head[edge], NOWHERE) for edge in good.out[node]
        }
        # Sums in another order may miss the budget by a last digit; the least then keeps to it.
        least = min(rest, key=rest.__getitem__)
        path.append(next((edge for edge in rest if spent + rest[edge] <= limit), least))
        spent += good.weight[path[-1]]
        node = good.head[path[-1]]
    return path


def _able(starts: dict[int, float], layer: dict[int, float], limit: float) -> list[int]:
    """Return the starts from which the end is reached within the limit."""
    return [v for v, cost in layer.items() if starts.get(v, NOWHERE) + cost <= limit]
