"""Where vehicles best join a route and leave it, from known costs alone: the reference.

A member from o to g pays D(o, r_i) + P_j - P_i + D(r_j, g) if it joins the route r_0 .. r_K at
r_i and leaves it at r_j, i < j, D being the least cost alone and P the platoon weight along the
route up to each node. One pass that carries the least D(o, r_i) - P_i so far finds the best pair.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .tie_rule import is_platoon, preferred, slack_of

__all__ = ["Found", "Positions", "best_pairs", "entry_exit_costs", "only_at"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]
Found = tuple[Index, Index, Floats, Floats]
Positions = tuple[Index, Index]


class _Distances(Protocol):
    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats: ...


def only_at(costs: Floats, positions: Positions | None) -> Floats:
    """Keep costs (N, K + 1) only at the positions each member may use; inf elsewhere.

    Parameters
    ----------
    costs : ndarray of float, (N, K + 1)
        Of each member at each position.
    positions : tuple of ndarray of int or None
        First (N + 1,) and positions on the route; None allows all.

    Returns
    -------
    ndarray of float, (N, K + 1)
        Costs.
    """
    if positions is None:
        return costs
    first, at = positions
    kept = np.full(costs.shape, np.inf)
    member = np.repeat(np.arange(len(costs)), np.diff(first))
    kept[member, at] = costs[member, at]
    return kept


def entry_exit_costs(
    engine: _Distances, nodes: Index, origins: Index, destinations: Index
) -> tuple[Floats, Floats, Floats]:
    """Return D(o, r_i) (N, K + 1), D(r_j, g) (N, K + 1) and D(o, g) (N,).

    Searches from members or from the route's nodes, whichever are fewer.

    Parameters
    ----------
    engine : Engine
        Whatever gives costs from nodes to all, and from all to nodes.
    nodes : ndarray of int, (K + 1,)
        Nodes of the route.
    origins : ndarray of int, (N,)
        Nodes where members start.
    destinations : ndarray of int, (N,)
        Nodes where they go.

    Returns
    -------
    entry : ndarray of float, (N, K + 1)
        Costs alone to each route node.
    leave : ndarray of float, (N, K + 1)
        Costs alone from each route node.
    solo : ndarray of float, (N,)
        Costs alone all the way.
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
    entry : ndarray of float, (N, K + 1)
        Costs alone to each route node.
    leave : ndarray of float, (N, K + 1)
        Costs alone from each route node to the destination.
    platoon : ndarray of float, (K + 1,)
        Platoon weight along the route up to each node.
    length : ndarray of float, (K + 1,)
        Metres along the route up to each node.
    solo : ndarray of float, (N,)
        Cost alone.

    Returns
    -------
    i : ndarray of int, (N,)
        Positions where they join; -1 where staying alone is cheaper.
    j : ndarray of int, (N,)
        Positions where they leave; -1 likewise.
    cost : ndarray of float, (N,)
        What each pays.
    """
    lead = np.minimum.accumulate(entry - platoon, axis=1)
    # Strictly i < j: with costs that are not least costs, as A*'s are not, a detour over one node
    # of the route may seem cheaper than both staying alone and a platoon, and hide the platoon.
    total = np.full(entry.shape, np.inf)
    total[:, 1:] = lead[:, :-1] + platoon[1:] + leave[:, 1:]
    least = total.min(axis=1, initial=np.inf)
    best_i = np.full(len(solo), -1, np.int64)
    best_j = np.full(len(solo), -1, np.int64)
    cost = solo.copy()
    for member in np.flatnonzero(np.isfinite(least)):
        slack = slack_of(solo[member], least[member])
        if least[member] > solo[member] + slack:
            continue
        limit = least[member] + slack
        ends = np.flatnonzero(total[member] <= limit)
        i, j, together = preferred(ends, limit, lead[member], leave[member], platoon, length)
        if i < j and is_platoon(together, least[member], solo[member], slack):
            best_i[member], best_j[member] = i, j
            cost[member] = entry[member, i] + (platoon[j] - platoon[i]) + leave[member, j]
    return best_i, best_j, cost
