"""Ways of which none is both cheaper and quicker: exact labels of cost and driving time.

Labels leave the queue by cost, and by time among equal costs. So at a node every label that has
been taken is no dearer than a new one, and the new one is worth taking iff it is quicker than the
last. What cannot lead to a way that pays, or to one in time, is dropped: to its cost, and to its
time, the least of what remains is added. A plain function of numbers and arrays.
"""

from __future__ import annotations

import heapq

import numpy as np
from numpy.typing import NDArray

__all__ = ["pareto_labels"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]

QUICKER_S = 1e-6
"""A label is quicker if it saves more than last digits of sums [s]."""


def pareto_labels(
    first: Longs, edges: Longs, other: Longs, weight: Floats, drive_s: Floats, root: int,
    cost_left: Floats, time_left: Floats, most_cost: float, most_s: float, most_labels: int,
) -> tuple[Longs, Floats, Floats, Longs, Longs, bool]:  # fmt: skip
    """Return all labels from a node that can still pay and be in time.

    Parameters
    ----------
    first : ndarray of int, (n + 1,)
        Where each node's edges begin in `edges`.
    edges : ndarray of int, (m,)
        Edge ids by node: those that leave it, or those that reach it if ways end at the root.
    other : ndarray of int, (m,)
        The other end of each edge, by edge id.
    weight, drive_s : ndarray of float, (m,)
        Cost, inf where closed, and driving time [s] of each edge.
    root : int
        The node where ways start, or end.
    cost_left, time_left : ndarray of float, (n,)
        The least that remains from each node on, at whatever is least there; inf where nothing
        that is wanted can be reached.
    most_cost, most_s : float
        What a whole way may cost and take.
    most_labels : int
        How many labels are taken before the search gives up.

    Returns
    -------
    node : ndarray of int, (L,)
        Where each label stands; those of one node by rising cost and falling time.
    cost, time_s : ndarray of float, (L,)
        Of the way there.
    before : ndarray of int, (L,)
        The label it came from; -1 at the root.
    by : ndarray of int, (L,)
        The edge it came by; -1 at the root.
    complete : bool
        Whether the search did not give up.
    """
    quickest = np.full(len(first) - 1, np.inf)
    room = 1024
    node = np.empty(room, np.int64)
    cost = np.empty(room)
    time_s = np.empty(room)
    before = np.empty(room, np.int64)
    by = np.empty(room, np.int64)
    taken = 0
    complete = True
    queue = [(0.0, 0.0, root, -1, -1)]
    while len(queue) > 0:
        so_far, spent, at, came, edge = heapq.heappop(queue)
        if not spent < quickest[at] - QUICKER_S:
            continue
        if taken == most_labels:
            complete = False
            break
        if taken == room:
            room *= 2
            wider = np.empty(room, np.int64)
            wider[:taken] = node
            node = wider
            wider = np.empty(room, np.int64)
            wider[:taken] = before
            before = wider
            wider = np.empty(room, np.int64)
            wider[:taken] = by
            by = wider
            longer = np.empty(room)
            longer[:taken] = cost
            cost = longer
            longer = np.empty(room)
            longer[:taken] = time_s
            time_s = longer
        quickest[at] = spent
        node[taken], cost[taken], time_s[taken] = at, so_far, spent
        before[taken], by[taken] = came, edge
        for k in range(first[at], first[at + 1]):
            onward = edges[k]
            to = other[onward]
            total, later = so_far + weight[onward], spent + drive_s[onward]
            if (
                later < quickest[to] - QUICKER_S
                and total + cost_left[to] <= most_cost
                and later + time_left[to] <= most_s
            ):
                heapq.heappush(queue, (total, later, to, taken, onward))
        taken += 1
    return (
        node[:taken].copy(), cost[:taken].copy(), time_s[:taken].copy(), before[:taken].copy(),
        by[:taken].copy(), complete,
    )  # fmt: skip
