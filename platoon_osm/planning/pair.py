"""Case D: two vehicles, both routes free, exact in four searches and a fifth over few nodes.

u1, u2 are costs alone from the two origins, v1, v2 to the two destinations. One more search, under
the pair's weight and started at every node x with u1(x) + u2(x), gives the least cost of both being
at y after some shared stretch; adding v1(y) + v2(y) and taking the least over y is the answer. One
shared stretch is enough: between a split and a second merge both could take the cheaper of the
two ways together (waiting free, vehicles alike).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..costs.weights import EdgeWeights
from ..network.road_network import RoadNetwork
from ..search.joining import TIE
from ..search.protocol import EngineName, LeastCosts
from ..search.searches import engine_for
from ..search.trees import Trees

__all__ = ["PairPlan", "plan_pair"]

Edges = NDArray[np.int64]
Floats = NDArray[np.float64]


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
    engine: EngineName = "auto",
    trees: Trees | None = None,
) -> PairPlan:
    """Plan two vehicles, the first leading where they drive together.

    Parameters
    ----------
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.
    trees : Trees, optional
        Searches under `weights.solo` that are known already; `engine` is then theirs.

    Raises
    ------
    NoRouteError
        If one of them cannot reach its destination even alone.
    """
    if trees is None:
        trees = Trees(engine_for(net, weights.solo, engine, 4))
    u, v = trees.trees(origins), trees.trees(destinations, forward=False)
    paths = [u[k].path(destinations[k]) for k in (0, 1)]
    solo_cost = float(u[0].dist[destinations[0]] + u[1].dist[destinations[1]])
    pair_weight = weights.master + weights.platoon
    slack = TIE * solo_cost
    there, onward = [tree.dist for tree in u], [tree.dist for tree in v]
    together = trees.engine.shared_stretch(pair_weight, there, onward, solo_cost + slack, slack)
    near = np.flatnonzero(np.isfinite(together.dist))
    total = together.dist[near] + onward[0][near] + onward[1][near]
    least = float(total.min(initial=np.inf))
    nothing = np.zeros(0, np.int64)
    apart = PairPlan(
        solo_cost, solo_cost, -1, -1, (paths[0], paths[1]), nothing, (nothing, nothing)
    )
    if least > solo_cost + slack:
        return apart
    ends = near[total <= least + slack]
    starts = near[there[0][near] + there[1][near] <= together.dist[near] + slack]
    shared, end = _longest(net, together, pair_weight, starts, ends, slack)
    if not len(shared) or (least >= solo_cost - slack and not net.length_m[shared].any()):
        return apart
    start = int(net.tail[shared[0]])
    return PairPlan(
        cost=float(together.dist[end] + onward[0][end] + onward[1][end]),
        solo_cost=solo_cost,
        merge=start,
        separation=end,
        before=(u[0].path(start), u[1].path(start)),
        shared=shared,
        after=(v[0].path(end), v[1].path(end)),
    )


def _longest(
    net: RoadNetwork,
    together: LeastCosts,
    weight: Floats,
    starts: Edges,
    ends: Edges,
    slack: float,
) -> tuple[Edges, int]:
    """Of equally good shared stretches return the longest [m], and the node where it ends.

    The tree holds one least-cost stretch to each node. All of them consist of tight edges: those
    by which the label of their head can be reached.
    """
    label = together.dist
    edges = _tight_edges(net, label, weight, ends, slack)
    edges = edges[np.argsort(label[net.tail[edges]], kind="stable")]
    longest = dict.fromkeys(starts.tolist(), 0.0)
    by: dict[int, int] = {}
    improved = True
    # Edges of zero length join nodes of one label in any order, so one pass may not be enough.
    while improved:
        improved = False
        for edge in edges.tolist():
            head = int(net.head[edge])
            reach = longest.get(int(net.tail[edge]), -np.inf) + float(net.length_m[edge])
            if reach > longest.get(head, -np.inf):
                longest[head], by[head], improved = reach, edge, True
    reached = [node for node in ends.tolist() if node in longest]
    if not reached:
        # Only over edges that lead on at no cost; any stretch will do.
        end = int(ends[0])
        return together.path(end), end
    end = max(reached, key=lambda node: (longest[node], -node))
    stretch: list[int] = []
    node = end
    while node in by:
        stretch.append(by[node])
        node = int(net.tail[stretch[-1]])
    return np.array(stretch[::-1], np.int64), end


def _tight_edges(
    net: RoadNetwork, label: Floats, weight: Floats, ends: NDArray[np.int64], slack: float
) -> Edges:
    """Return the tight edges on the ways to some nodes, found walking backwards from these."""
    incoming, first_in = net.incoming()
    found: list[int] = []
    seen = set(ends.tolist())
    queue = list(seen)
    while queue:
        node = queue.pop()
        for edge in incoming[first_in[node] : first_in[node + 1]].tolist():
            tail = int(net.tail[edge])
            # An edge that leads on at no cost could be driven in circles for ever.
            onward = label[tail] < label[node] or net.length_m[edge] == 0
            if onward and label[tail] + weight[edge] <= label[node] + slack:
                found.append(edge)
                if tail not in seen:
                    seen.add(tail)
                    queue.append(tail)
    return np.array(sorted(found), np.int64)
