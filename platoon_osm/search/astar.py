"""The paper's A*: a node is opened again whenever a cheaper way to it is found.

An open set O holds what is to be explored, a closed set C what was. The node u of O with the least
f(u) = g(u) + h(u) moves to C; if it is the target, the search ends. Of each neighbour v,

    if v is in neither set, or g(u) + w(u, v) < g(v):  g(v) and v's parent are set, v is put into O.

So a closed node comes back, and if h never exceeds what remains, the answer is optimal even where h
is not consistent. Many programmes leave the second half of that condition out for closed nodes:
each is explored once, and a cheaper way found later is lost. That is `reopen=False`.

It ends: g(v) is always what some way without a circle costs, and each time v is put into O again
g(v) has fallen, so v is explored at most once for each such cost. Those can be exponentially many
where h changes steeply along roads; under the paper's heuristic a search takes a few times the
steps it takes without reopening.

Of nodes with equal f the one of the smallest number is explored first; the paper does not say.
"""

from __future__ import annotations

import heapq

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import SearchError, brief
from ..network.road_network import RoadNetwork
from .arguments import checked_labels, checked_network, checked_node, checked_weight

__all__ = ["astar"]

Edges = NDArray[np.int64]


def astar(
    net: RoadNetwork,
    weight: ArrayLike,
    source: int,
    target: int,
    heuristic: ArrayLike,
    reopen: bool = True,
) -> tuple[float, Edges]:
    """Search by A* as the paper prints it, or with each node explored once.

    With a heuristic that never exceeds what remains the answer is optimal; without reopening it
    must be consistent too. With the paper's inflated one (section 2 of the method) the answer is
    only a route, and the caller reports its excess.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    source : int
        Node where the path starts.
    target : int
        Node where it ends.
    heuristic : array_like of float, (n,)
        Estimated cost from each node to the target.
    reopen : bool
        Whether a node explored before is explored again once a cheaper way to it is found, as the
        paper has it.

    Returns
    -------
    cost : float
        What the route costs; inf if there is none.
    edges : ndarray of int, (k,)
        Edge ids in driving order.

    Raises
    ------
    SearchError
        A weight, node or heuristic that is none.
    """
    costs = checked_weight(checked_network(net), weight)
    source, target = checked_node(net, source), checked_node(net, target)
    estimate = checked_labels(net, heuristic, "estimate")
    if not isinstance(reopen, bool | np.bool_):
        raise SearchError(f"reopen = {brief(reopen)} must be True or False")
    best: dict[int, float] = {source: 0.0}
    entered: dict[int, int] = {}
    # The queue keeps what became outdated; what is really open stands here.
    opened = {source}
    queue = [(float(estimate[source]), source)]
    while queue:
        _, node = heapq.heappop(queue)
        if node not in opened:
            continue
        if node == target:
            edges = []
            while node != source:
                edges.append(entered[node])
                node = int(net.tail[edges[-1]])
            return best[target], np.array(edges[::-1], np.int64)
        opened.remove(node)
        for edge in range(net.first_out[node], net.first_out[node + 1]):
            head = int(net.head[edge])
            cost = best[node] + float(costs[edge])
            if cost < best.get(head, np.inf) and (reopen or head not in best or head in opened):
                best[head] = cost
                entered[head] = edge
                opened.add(head)
                heapq.heappush(queue, (cost + float(estimate[head]), head))
    return float("inf"), np.zeros(0, np.int64)
