"""Cases A, B and C of the paper as one kernel with different entries and exits.

The master's route r_0 .. r_K is fixed. A member from o to g pays

    D(o, r_i) + P_j - P_i + D(r_j, g),    i < j,

D being the least cost alone and P the platoon weight along the route up to each node; or D(o, g) if
it stays alone. One pass that carries the least D(o, r_i) - P_i so far finds the best pair in O(K).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..costs.objective import edge_weights
from ..costs.weights import EdgeWeights
from ..errors import ScenarioError, brief
from ..network.road_network import RoadNetwork
from ..search.arguments import checked_network
from ..search.engine import EngineName, engine_for
from ..search.joining import best_pairs, entry_exit_costs, only_at
from .member_plans import MemberPlans

__all__ = ["CASES", "Case", "best_pairs", "choose_points", "entry_exit_costs", "plan_members",
           "route_nodes", "within_case"]  # fmt: skip

Case = Literal["A", "B", "C"]
CASES = ("A", "B", "C", "D")
Floats = NDArray[np.float64]
Index = NDArray[np.int64]


def route_nodes(net: RoadNetwork, route: ArrayLike) -> Index:
    """Return the nodes of a route.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    route : array_like of int, (K,)
        Edge ids in driving order.

    Returns
    -------
    ndarray of int, (K + 1,)
        Its nodes.

    Raises
    ------
    ScenarioError
        If there are no edges, or they do not follow each other.
    """
    edges = _positions("route", "edges", route)
    if not len(edges):
        raise ScenarioError("route: it has no edges; the master must drive somewhere")
    outside = (edges < 0) | (edges >= net.m)
    if outside.any():
        raise ScenarioError(
            f"route: edge {edges[np.argmax(outside)]}: the network has edges 0 to {net.m - 1}"
        )
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
    engine: EngineName = "auto",
) -> MemberPlans:
    """Find where N members merge with a master and separate from it, at least cost to each.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    weights : EdgeWeights
        What edges cost.
    route : array_like of int, (K,)
        Edge ids of the master's route, in driving order.
    origins, destinations : array_like of int, (N,)
        Nodes.
    case : {"A", "B", "C"}
        "A" separates at the destination, "B" merges at the origin, "C" is free in both.
    entries, exits : sequence of iterable of int, (N, ...), optional
        For B and A, per member, the nodes that count as its origin and destination, where a place
        has several, such as both carriageways of a junction; by default the one.
    engine : {"auto", "reference", "hierarchy"}
        Which engine searches, "auto" the one that is likely faster.

    Returns
    -------
    MemberPlans
        Least cost; among equal costs the longest platoon, then the earliest merging point.

    Raises
    ------
    ScenarioError
        Unknown case, a node outside the network, a route that is none, weights of another network.
    SearchError
        No network, or no such engine.
    """
    net = checked_network(net)
    weights = edge_weights(weights, net, "members")
    if not isinstance(case, str) or case not in ("A", "B", "C"):
        raise ScenarioError(
            f'case {brief(case)}: one master and members are planned by "A", "B" or "C"'
        )
    start, end = (
        _positions("members", "nodes", origins),
        _positions("members", "nodes", destinations),
    )
    if start.shape != end.shape:
        raise ScenarioError(
            f"members: {len(start)} origins and {len(end)} destinations; give one of each a member"
        )
    for label, nodes in (("origin", start), ("destination", end)):
        outside = (nodes < 0) | (nodes >= net.n)
        if outside.any():
            raise ScenarioError(
                f"{label} {nodes[np.argmax(outside)]}: the network has nodes 0 to {net.n - 1}"
            )
    nodes = route_nodes(net, route)
    edges = np.asarray(route, np.int64)
    entry_at = _places_on(nodes, start, entries) if case == "B" else None
    exit_at = _places_on(nodes, end, exits) if case == "A" else None
    searches = min(len(np.unique(start)), len(nodes)) + min(len(np.unique(end)), len(nodes))
    i, j, cost, solo = engine_for(net, weights.solo, engine, searches).best_on_route(
        nodes, start, end, running_sum(weights.platoon[edges]), running_sum(net.length_m[edges]),
        entry_at, exit_at,
    )  # fmt: skip
    restricted = entry_at or exit_at
    applicable = np.diff(restricted[0]) > 0 if restricted else np.ones(len(solo), bool)
    return MemberPlans.at(nodes, i, j, cost, solo, applicable)


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
    net : RoadNetwork
        The network.
    weights : EdgeWeights
        What edges cost.
    route : array_like of int, (K,)
        Edge ids of the master's route, in driving order.
    origins, destinations : ndarray of int, (N,)
        Nodes.
    case : {"A", "B", "C"}
        As in `plan_members`.
    costs : tuple of ndarray of float
        Entry (N, K + 1), exit (N, K + 1) and solo (N,), as from `entry_exit_costs`.
    entries, exits : sequence of iterable of int, (N, ...), optional
        As in `plan_members`.
    gain : array_like of float, (N, K), optional
        What others save on each edge of the route if the member drives it in the platoon; it
        counts in the choice, not in the member's cost.

    Returns
    -------
    MemberPlans
        Ties as in `plan_members`.
    """
    entry, leave, solo = costs
    nodes = route_nodes(net, route)
    edges = np.asarray(route, np.int64)
    platoon, length = running_sum(weights.platoon[edges]), running_sum(net.length_m[edges])
    entry, leave, applicable = within_case(
        nodes, case, (entry, leave), origins, destinations, entries, exits
    )
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
    return MemberPlans.at(nodes, i, j, cost, solo, applicable)


def within_case(
    nodes: Index,
    case: Case,
    costs: tuple[Floats, Floats],
    origins: Index,
    destinations: Index,
    entries: Sequence[Iterable[int]] | None = None,
    exits: Sequence[Iterable[int]] | None = None,
) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Return what joining and leaving cost where a case allows it.

    Parameters
    ----------
    nodes : ndarray of int, (K + 1,)
        Of the route.
    case : {"A", "B", "C"}
        As in `plan_members`.
    costs : tuple of ndarray of float
        Entry and exit, (N, K + 1) each.
    origins, destinations : ndarray of int, (N,)
        Nodes.
    entries, exits : sequence of iterable of int, (N, ...), optional
        As in `plan_members`.

    Returns
    -------
    entry, leave : ndarray of float, (N, K + 1)
        The same, inf where the case allows nobody.
    applicable : ndarray of bool, (N,)
        Whether it allows a member anything.
    """
    entry, leave = costs
    applicable = np.ones(len(origins), bool)
    if case == "A":
        places = _places_on(nodes, destinations, exits)
        leave, applicable = only_at(leave, places), np.diff(places[0]) > 0
    elif case == "B":
        places = _places_on(nodes, origins, entries)
        entry, applicable = only_at(entry, places), np.diff(places[0]) > 0
    return entry, leave, applicable


def running_sum(values: Floats) -> Floats:
    """Return the sums of the first 0, 1, .. K of some values.

    Parameters
    ----------
    values : ndarray of float, (K,)
        Any.

    Returns
    -------
    ndarray of float, (K + 1,)
        Begins with 0.
    """
    return np.concatenate([[0.0], np.cumsum(values)])


def _positions(what: str, of: str, values: ArrayLike) -> Index:
    """Return positions as an array (k,)."""
    try:
        found = np.atleast_1d(np.asarray(values))
    except (TypeError, ValueError):
        found = np.array([None])
    if found.ndim != 1 or (found.size and found.dtype.kind not in "iu"):
        raise ScenarioError(
            f"{what}: give {of} as a list of whole numbers, not {repr(values)[:60]}"
        )
    return found.astype(np.int64)


def _places_on(
    nodes: Index, own: Index, places: Sequence[Iterable[int]] | None
) -> tuple[Index, Index]:
    """Return where on the route each member's own place is, as first (N + 1,) and positions."""
    if places is None:
        order = np.argsort(nodes, kind="stable")
        low, high = (np.searchsorted(nodes[order], own, side) for side in ("left", "right"))
        first = np.concatenate([[0], np.cumsum(high - low)])
        step = np.arange(first[-1]) - np.repeat(first[:-1], high - low)
        return first, order[np.repeat(low, high - low) + step]
    places = list(places)
    if len(places) != len(own):
        raise ScenarioError(
            f"members: places of {len(places)}, there are {len(own)}; give those of each member"
        )
    found = [
        np.flatnonzero(np.isin(nodes, [mine, *others]))
        for mine, others in zip(own.tolist(), places, strict=True)
    ]
    first = np.concatenate([[0], np.cumsum([len(at) for at in found])]).astype(np.int64)
    return first, np.concatenate([np.zeros(0, np.int64), *found])
