"""Case D: two vehicles, both routes free, exact in four searches and a fifth over few nodes.

u1, u2 are costs alone from the two origins, v1, v2 to the two destinations. One more search, under
the pair's weight and started at every node x with u1(x) + u2(x), gives the least cost of both being
at y after some shared stretch; adding v1(y) + v2(y) and taking the least over y is the answer. One
shared stretch is enough: between a split and a second merge both could take the cheaper of the
two ways together (waiting free, vehicles alike).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..costs.weights import EdgeWeights
from ..network.road_network import RoadNetwork
from ..search.least_paths import LeastCosts, fewest_edges, good_edges
from ..search.protocol import EngineName
from ..search.searches import engine_for
from ..search.tie_rule import TIE
from ..search.trees import Trees

__all__ = ["PairPlan", "plan_pair"]

Edges = NDArray[np.int64]
Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class PairPlan:
    """The best joint plan of two vehicles.

    Attributes
    ----------
    cost : float
        Of both together; `solo_cost` if each drives alone.
    solo_cost : float
        Of both, each alone.
    merge, separation : int
        Nodes; -1 if they stay apart.
    before, after : tuple of ndarray of int, (2,)
        The two vehicles' edges before merging and after separating.
    shared : ndarray of int, (k,)
        Edges they drive together.
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
    trees: Trees | tuple[Trees, Trees] | None = None,
    pair_weight: Floats | None = None,
    alike: bool = True,
) -> PairPlan:
    """Plan two vehicles, the first leading where they drive together.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    weights : EdgeWeights
        What its edges cost.
    origins, destinations : tuple of int, (2,)
        Nodes of both vehicles.
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.
    trees : Trees or tuple of Trees, optional
        Searches under `weights.solo` that are known already; `engine` is then theirs. Of unlike
        vehicles those of each.
    pair_weight : ndarray of float, (m,), optional
        What both pay together on each edge, inf where one of them may not drive; by default what
        master and member pay.
    alike : bool
        Whether both pay the same alone wherever both may drive.

    Returns
    -------
    PairPlan
        The routes that cost least together.

    Raises
    ------
    NoRouteError
        If one of them cannot reach its destination even alone.
    """
    if trees is None:
        trees = Trees(engine_for(net, weights.solo, engine, 4))
    own = trees if isinstance(trees, tuple) else (trees, trees)
    u, v = _of_both(own, origins, True), _of_both(own, destinations, False)
    solo_cost = float(u[0].dist[destinations[0]] + u[1].dist[destinations[1]])
    if not np.isfinite(solo_cost):
        for tree, node in zip(u, destinations, strict=True):
            tree.path(node)  # says which of them has no route
    if pair_weight is None:
        pair_weight = weights.master + weights.platoon
    slack = TIE * solo_cost
    there, onward = [tree.dist for tree in u], [tree.dist for tree in v]
    if alike:
        together = own[0].engine.shared_stretch(
            pair_weight, there, onward, solo_cost + slack, slack
        )
    else:
        # The bound of that search takes both to pay the same alone.
        together = engine_for(net, pair_weight, engine, 2).seeded(there[0] + there[1])
    near = np.flatnonzero(np.isfinite(together.dist))
    total = together.dist[near] + onward[0][near] + onward[1][near]
    least = float(total.min(initial=np.inf))
    if least > solo_cost + slack:
        return _apart(u, destinations, solo_cost)
    limit = least + slack
    ends = {
        node: float(onward[0][node] + onward[1][node]) for node in near[total <= limit].tolist()
    }
    shared, end = _longest(net, together, pair_weight, ends, limit, slack)
    if not len(shared) or (least >= solo_cost - slack and not net.length_m[shared].any()):
        return _apart(u, destinations, solo_cost)
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


def _of_both(
    trees: tuple[Trees, Trees], nodes: tuple[int, int], forward: bool
) -> Sequence[LeastCosts]:
    """Return the searches of both vehicles, in one go where they are alike."""
    if trees[0] is trees[1]:
        return trees[0].trees(nodes, forward)
    return [tree.tree(node, forward) for tree, node in zip(trees, nodes, strict=True)]


def _apart(there: Sequence[LeastCosts], destinations: tuple[int, int], cost: float) -> PairPlan:
    """Return the plan in which each drives alone."""
    first, second = (tree.path(node) for tree, node in zip(there, destinations, strict=True))
    nothing = np.zeros(0, np.int64)
    return PairPlan(cost, cost, -1, -1, (first, second), nothing, (nothing, nothing))


def _longest(
    net: RoadNetwork,
    together: LeastCosts,
    weight: Floats,
    ends: dict[int, float],
    limit: float,
    slack: float,
) -> tuple[Edges, int]:
    """Of equally good shared stretches return the longest [m], and the node where it ends.

    `ends` are the nodes where a plan within the limit may part, and what is left to pay there. Of
    equally long stretches that to the smallest node is taken, of these one of fewest edges.
    """
    good = good_edges(net, weight, together.dist, ends, limit)
    starts = [node for node, rest in good.cost.items() if together.label(node) + rest <= limit]
    edges = _tight_edges(net, together.dist, weight, good.edges, slack)
    longest = _longest_to(edges, starts)
    reached = [node for node in ends if node in longest]
    if not reached:
        # Only over edges that lead on at no cost; any stretch will do.
        end = min(ends)
        return together.path(end), end
    end = max(reached, key=lambda node: (longest[node], -node))
    exact = [
        edge
        for edge, tail, head, length in edges
        if tail in longest and longest[tail] + length == longest[head]
    ]
    first = [node for node in starts if longest[node] == 0]
    return np.array(fewest_edges(net, exact, first, end), np.int64), end


def _longest_to(edges: list[tuple[int, int, int, float]], starts: list[int]) -> dict[int, float]:
    """Return the nodes that some edges lead to from any start, and how far that may be [m].

    Empty if there is no longest way, for one could drive in circles.
    """
    longest = dict.fromkeys(starts, 0.0)
    # Edges of zero length join nodes of one label in any order, so one pass may not be enough.
    for _ in range(len(edges) + 1):
        improved = False
        for _, tail, head, length in edges:
            reach = longest.get(tail, -np.inf) + length
            if reach > longest.get(head, -np.inf):
                longest[head], improved = reach, True
        if not improved:
            return longest
    return {}


def _tight_edges(
    net: RoadNetwork, label: Floats, weight: Floats, good: list[int], slack: float
) -> list[tuple[int, int, int, float]]:
    """Return edge, tail, head and length [m] of good edges that lead on, the first to drive first.

    An edge that leads on at no cost could be driven in circles for ever; if it has no length, that
    makes nothing longer.
    """
    edges = np.array(sorted(good), np.int64)
    edges = edges[(weight[edges] > slack) | (net.length_m[edges] == 0)]
    edges = edges[np.argsort(label[net.tail[edges]], kind="stable")]
    columns = (edges, net.tail[edges], net.head[edges], net.length_m[edges])
    return list(zip(*(column.tolist() for column in columns), strict=True))
