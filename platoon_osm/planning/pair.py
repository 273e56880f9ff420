"""Case D: two vehicles, both routes free, exact in five searches.

u1, u2 are costs alone from the two origins, v1, v2 to the two destinations. One search under the
pair's weight, started at every node x with u1(x) + u2(x), gives the least cost of both being at y
after some shared stretch; adding v1(y) + v2(y) and taking the least over y is the answer. One
shared stretch is enough: between a split and a second merge both could take the cheaper of the
two ways together (waiting free, vehicles alike).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..costs.weights import EdgeWeights
from ..network.road_network import RoadNetwork
from ..network.search import ReferenceEngine, Tree
from .cases import TIE

__all__ = ["PairPlan", "plan_pair"]

Edges = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class PairPlan:
    """The best joint plan of two vehicles.

    Attributes
    ----------
    cost : of both together; `solo_cost` if each drives alone.
    merge, separation : nodes; -1 if they stay apart.
    before, after : the two vehicles' edges before merging and after separating.
    shared : edges they drive together.
    """

    cost: float
    solo_cost: float
    merge: int
    separation: int
    before: tuple[Edges, Edges]
    shared: Edges
    after: tuple[Edges, Edges]


def plan_pair(
    net: RoadNetwork,
    weights: EdgeWeights,
    origins: tuple[int, int],
    destinations: tuple[int, int],
) -> PairPlan:
    """Plan two vehicles, the first leading where they drive together.

    Raises
    ------
    NoRouteError
        If one of them cannot reach its destination even alone.
    """
    alone = ReferenceEngine(net, weights.solo)
    u = [alone.tree(node) for node in origins]
    v = [alone.tree(node, forward=False) for node in destinations]
    paths = [u[k].path(destinations[k]) for k in (0, 1)]
    solo_cost = float(u[0].dist[destinations[0]] + u[1].dist[destinations[1]])
    together = ReferenceEngine(net, weights.master + weights.platoon).seeded(u[0].dist + u[1].dist)
    total = together.dist + v[0].dist + v[1].dist
    least = float(total.min(initial=np.inf))
    slack = TIE * solo_cost
    nothing = np.zeros(0, np.int64)
    apart = PairPlan(
        solo_cost, solo_cost, -1, -1, (paths[0], paths[1]), nothing, (nothing, nothing)
    )
    if least > solo_cost + slack:
        return apart
    shared, end = _longest(net, together, np.flatnonzero(total <= least + slack))
    if not len(shared):
        return apart
    start = int(net.tail[shared[0]])
    return PairPlan(
        cost=float(total[end]),
        solo_cost=solo_cost,
        merge=start,
        separation=end,
        before=(u[0].path(start), u[1].path(start)),
        shared=shared,
        after=(v[0].path(end), v[1].path(end)),
    )


def _longest(net: RoadNetwork, together: Tree, ends: NDArray[np.int64]) -> tuple[Edges, int]:
    """Of equally good separation points take that with the longest shared stretch."""
    best, best_key, best_end = np.zeros(0, np.int64), (-1.0, 0), -1
    for end in ends.tolist():
        path = together.path(end)
        key = (float(net.length_m[path].sum()), -end)
        if key > best_key:
            best, best_key, best_end = path, key, end
    return best, best_end
