"""Where members merge and separate, for a whole grid of (tau, xi) at once.

Searches alone do not depend on (tau, xi), and a platoon weight is a length times one factor
p(tau, xi). So for a member every pair of points i < j on the master's route is a line in p,

    D(o, r_i) + D(r_j, g) + p (L_j - L_i),

and the answers over the grid are the lower envelope of these lines.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..search.tie_rule import TIE, in_order_of_preference, is_platoon

__all__ = ["best_on_grid", "shared_metres"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

BLOCK = 4_000_000
"""Values in memory at once."""


def best_on_grid(
    entry: Floats, leave: Floats, solo: Floats, length: Floats, factor: Floats
) -> tuple[Index, Index, Floats]:
    """Return the best positions i < j on the route for each member and platoon factor.

    The same answers as `planning.cases.plan_members` gives for one (tau, xi) at a time: least
    cost, then the longest platoon, then the earliest merging point.

    Parameters
    ----------
    entry, leave : ndarray of float, (N, K + 1)
        Costs alone to each node of the route, and from each to the destination.
    solo : ndarray of float, (N,)
        Cost alone.
    length : ndarray of float, (K + 1,)
        Metres along the route up to each node.
    factor : ndarray of float, (G,)
        Platoon cost of one metre.

    Returns
    -------
    i, j : ndarray of int, (N, G)
        Positions on the route; -1 where staying alone is cheaper.
    cost : ndarray of float, (N, G)
        What the member pays in all.
    """
    first, last = np.triu_indices(len(length), 1)
    together = length[last] - length[first]
    # In this order the first line within the tolerance is the one that ties prefer.
    order = in_order_of_preference(first, last, together)
    first, last, together = first[order], last[order], together[order]
    members, points = len(solo), len(factor)
    best_i = np.full((members, points), -1, np.int64)
    best_j = best_i.copy()
    cost = np.repeat(solo[:, None], points, axis=1)
    if not len(first) or not points:
        return best_i, best_j, cost
    if members * len(first) * points <= BLOCK:
        groups = [np.arange(members)]
    else:
        groups = list(np.arange(members)[:, None])
    for group in groups:
        apart = entry[group][:, first] + leave[group][:, last]
        # A line that is above staying alone at the least factor is above it everywhere.
        hopeful = (apart + factor.min() * together <= solo[group, None] * (1 + 4 * TIE)).any(axis=0)
        at = np.flatnonzero(hopeful)
        if not len(at):
            continue
        step = max(1, BLOCK // (len(group) * len(at)))
        for begin in range(0, points, step):
            part = np.s_[begin : begin + step]
            found = _best_lines(apart[:, at], together[at], solo[group], factor[part])
            line, value, joined = found
            block = np.ix_(group, np.arange(points)[part])
            best_i[block] = np.where(joined, first[at][line], -1)
            best_j[block] = np.where(joined, last[at][line], -1)
            cost[block] = np.where(joined, value, solo[group, None])
    return best_i, best_j, cost


def _best_lines(
    apart: Floats, together: Floats, solo: Floats, factor: Floats
) -> tuple[Index, Floats, NDArray[np.bool_]]:
    """Return for each member and factor the preferred of its lowest lines (N, G)."""
    # Lines last, so that minimum and first match run over neighbours in memory.
    values = apart[:, None, :] + factor[:, None] * together
    least = values.min(axis=2)
    slack = TIE * solo[:, None]
    line = (values <= (least + slack)[:, :, None]).argmax(axis=2)
    value = np.take_along_axis(values, line[:, :, None], axis=2)[:, :, 0]
    real = is_platoon(together[line], least, solo[:, None], slack)
    return line, value, (least <= solo[:, None] + slack) & real


def shared_metres(i: Index, j: Index, length: Floats) -> Floats:
    """Return how many metres of the master's route have company, for each point.

    Parameters
    ----------
    i, j : ndarray of int, (N, G)
        Positions on the route; -1 for members that stay alone.
    length : ndarray of float, (K + 1,)
        Metres along the route up to each node.

    Returns
    -------
    ndarray of float, (G,)
        Metres, each counted once however many members drive it.
    """
    at = np.arange(len(length) - 1)
    company = ((at >= i[:, :, None]) & (at < j[:, :, None])).any(axis=0)
    metres: Floats = company @ np.diff(length)
    return metres
