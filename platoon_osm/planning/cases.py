"""Cases A, B and C of the paper as one kernel with different entries and exits.

The master's route r_0 .. r_K is fixed. A member from o to g pays

    D(o, r_i) + P_j - P_i + D(r_j, g),    i < j,

D being the least cost alone and P the platoon weight along the route up to each node; or D(o, g) if
it stays alone. One pass that carries the least D(o, r_i) - P_i so far finds the best pair in O(K).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..costs.weights import EdgeWeights
from ..errors import ScenarioError
from ..network.road_network import RoadNetwork
from ..network.search import ReferenceEngine

__all__ = ["CASES", "Case", "MemberPlans", "best_pairs", "choose_points",
           "entry_exit_costs", "plan_members", "route_nodes"]  # fmt: skip

Case = Literal["A", "B", "C"]
CASES = ("A", "B", "C", "D")
Floats = NDArray[np.float64]
Index = NDArray[np.int64]

TIE = 1e-11
"""Costs that differ by less, relative to the cost alone, are equal: sums of the same edges in
another order differ in their last digits, and the answer must not depend on it."""


class _Distances(Protocol):
    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats: ...


@dataclass(frozen=True, slots=True, eq=False)
class MemberPlans:
    """The best merging and separation points of N members on one master route, (N,) each.

    Attributes
    ----------
    merge, separation : nodes; -1 for a member that stays alone.
    merge_index, separation_index : positions of those nodes on the route; -1 likewise.
    cost, solo_cost : of the member as planned, and alone.
    applicable : whether the case can apply at all (A: the destination lies on the route; B: the
        origin does).
    """

    merge: Index
    separation: Index
    merge_index: Index
    separation_index: Index
    cost: Floats
    solo_cost: Floats
    applicable: NDArray[np.bool_]


def route_nodes(net: RoadNetwork, route: ArrayLike) -> Index:
    """Return the K + 1 nodes of a route of K edges.

    Raises
    ------
    ScenarioError
        If the edges do not follow each other.
    """
    edges = np.asarray(route, np.int64)
    if not len(edges):
        raise ScenarioError("route: it has no edges; the master must drive somewhere")
    if not np.array_equal(net.head[edges[:-1]], net.tail[edges[1:]]):
        raise ScenarioError("route: its edges do not follow each other; give them in driving order")
    return net.path_nodes(edges)


def plan_members(
    net: RoadNetwork,
    weights: EdgeWeights,
    route: ArrayLike,
    origins: ArrayLike,
    destinations: ArrayLike,
    case: Case = "C",
    *,
    entries: Sequence[Iterable[int]] | None = None,
    exits: Sequence[Iterable[int]] | None = None,
) -> MemberPlans:
    """Find where N members merge with a master and separate from it, at least cost to each.

    Parameters
    ----------
    route : (K,) edge ids of the master's route, in driving order.
    origins, destinations : (N,) nodes.
    case : "A" separates at the destination, "B" merges at the origin, "C" is free in both.
    entries, exits : for B and A, per member, the nodes that count as its origin and destination,
        where a place has several, such as both carriageways of a junction; by default the one.

    Returns
    -------
    MemberPlans
        Least cost; among equal costs the longest platoon, then the earliest merging point.

    Raises
    ------
    ScenarioError
        Unknown case, a node outside the network, or a route that is none.
    """
    if case not in ("A", "B", "C"):
        raise ScenarioError(f'case {case!r}: one master and members are planned by "A", "B" or "C"')
    start, end = (np.atleast_1d(np.asarray(nodes, np.int64)) for nodes in (origins, destinations))
    for label, nodes in (("origin", start), ("destination", end)):
        outside = (nodes < 0) | (nodes >= net.n)
        if outside.any():
            raise ScenarioError(
                f"{label} {nodes[np.argmax(outside)]}: the network has nodes 0 to {net.n - 1}"
            )
    nodes = route_nodes(net, route)
    costs = entry_exit_costs(ReferenceEngine(net, weights.solo), nodes, start, end)
    return choose_points(net, weights, route, start, end, case, costs, entries, exits)


def choose_points(
    net: RoadNetwork,
    weights: EdgeWeights,
    route: ArrayLike,
    origins: Index,
    destinations: Index,
    case: Case,
    costs: tuple[Floats, Floats, Floats],
    entries: Sequence[Iterable[int]] | None = None,
    exits: Sequence[Iterable[int]] | None = None,
    gain: ArrayLike | None = None,
) -> MemberPlans:
    """Choose merging and separation points from known costs alone, as `plan_members` does.

    Parameters
    ----------
    costs : entry (N, K + 1), exit (N, K + 1) and solo (N,), as from `entry_exit_costs`.
    gain : (N, K) what others save on each edge of the route if the member drives it in the
        platoon; it counts in the choice, not in the member's cost.
    """
    entry, leave, solo = costs
    nodes = route_nodes(net, route)
    edges = np.asarray(route, np.int64)
    platoon = np.concatenate([[0.0], np.cumsum(weights.platoon[edges])])
    length = np.concatenate([[0.0], np.cumsum(net.length_m[edges])])
    applicable = np.ones(len(solo), bool)
    if case == "A":
        leave, applicable = _only_at(leave, nodes, destinations, exits)
    elif case == "B":
        entry, applicable = _only_at(entry, nodes, origins, entries)
    if gain is None:
        i, j, cost = best_pairs(entry, leave, platoon, length, solo)
    else:
        i, j = np.full(len(solo), -1, np.int64), np.full(len(solo), -1, np.int64)
        for member, row in enumerate(np.asarray(gain, np.float64)):
            # Subtracting the running gain from the running weight is the same kernel again.
            reduced = platoon - np.concatenate([[0.0], np.cumsum(row)])
            one = slice(member, member + 1)
            i[one], j[one], _ = best_pairs(entry[one], leave[one], reduced, length, solo[one])
        everyone = np.arange(len(solo))
        together = entry[everyone, i] + (platoon[j] - platoon[i]) + leave[everyone, j]
        cost = np.where(i >= 0, together, solo)
    joined = i >= 0
    return MemberPlans(
        merge=np.where(joined, nodes[i], -1),
        separation=np.where(joined, nodes[j], -1),
        merge_index=i,
        separation_index=j,
        cost=cost,
        solo_cost=solo,
        applicable=applicable,
    )


def _only_at(
    costs: Floats, nodes: Index, own: Index, places: Sequence[Iterable[int]] | None
) -> tuple[Floats, NDArray[np.bool_]]:
    """Keep costs only where a route node is the member's own place; inf elsewhere."""
    allowed = nodes[None, :] == own[:, None]
    if places is not None:
        for row, members_nodes in enumerate(places):
            allowed[row] |= np.isin(nodes, list(members_nodes))
    return np.where(allowed, costs, np.inf), allowed.any(axis=1)


def entry_exit_costs(
    engine: _Distances, nodes: Index, origins: Index, destinations: Index
) -> tuple[Floats, Floats, Floats]:
    """Return D(o, r_i) (N, K + 1), D(r_j, g) (N, K + 1) and D(o, g) (N,).

    Searches from members or from the route's nodes, whichever are fewer.
    """
    few_members = len(np.unique(origins)) <= len(nodes)
    if few_members:
        away = engine.distances(origins)
        entry, solo = away[:, nodes], away[np.arange(len(origins)), destinations]
    else:
        entry = engine.distances(nodes, forward=False)[:, origins].T
        solo = _pair_costs(engine, origins, destinations)
    if len(np.unique(destinations)) <= len(nodes):
        leave = engine.distances(destinations, forward=False)[:, nodes]
    else:
        leave = engine.distances(nodes)[:, destinations].T
    return entry, leave, solo


def _pair_costs(engine: _Distances, origins: Index, destinations: Index) -> Floats:
    forward = len(np.unique(origins)) <= len(np.unique(destinations))
    sources, targets = (origins, destinations) if forward else (destinations, origins)
    distinct, row = np.unique(sources, return_inverse=True)
    result = np.empty(len(origins))
    for begin in range(0, len(distinct), 256):
        part = engine.distances(distinct[begin : begin + 256], forward)
        mine = np.flatnonzero((row >= begin) & (row < begin + 256))
        result[mine] = part[row[mine] - begin, targets[mine]]
    return result


def best_pairs(
    entry: Floats, leave: Floats, platoon: Floats, length: Floats, solo: Floats
) -> tuple[Index, Index, Floats]:
    """Return for each member the best positions i < j on the route and the cost.

    Parameters
    ----------
    entry, leave : (N, K + 1) costs alone to each route node, and from each to the destination.
    platoon, length : (K + 1,) platoon weight and metres along the route up to each node.
    solo : (N,) cost alone.

    Returns
    -------
    i, j : (N,) -1 where staying alone is cheaper.
    cost : (N,)
    """
    lead = np.minimum.accumulate(entry - platoon, axis=1)
    total = lead + platoon + leave
    least = total.min(axis=1, initial=np.inf)
    slack = TIE * np.where(np.isfinite(solo), solo, np.where(np.isfinite(least), least, 0.0))
    best_i = np.full(len(solo), -1, np.int64)
    best_j = np.full(len(solo), -1, np.int64)
    cost = solo.copy()
    for member in np.flatnonzero(least <= solo + slack):
        limit = least[member] + slack[member]
        ends = np.flatnonzero(total[member] <= limit)
        # The carried minimum never rises, so the first entry that is good enough is found by
        # bisection; it is also the one with the longest platoon, for lengths only grow.
        wanted = limit - platoon[ends] - leave[member, ends]
        starts = np.searchsorted(-lead[member], -wanted, side="left")
        together = length[ends] - length[np.minimum(starts, ends)]
        best = int(np.lexsort((ends, starts, -together))[0])
        i, j = int(starts[best]), int(ends[best])
        if i < j and together[best] > 0:
            best_i[member], best_j[member] = i, j
            cost[member] = entry[member, i] + (platoon[j] - platoon[i]) + leave[member, j]
    return best_i, best_j, cost
