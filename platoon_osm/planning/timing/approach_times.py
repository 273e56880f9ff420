"""How long the cheapest ways from a place to all nodes take, or from all nodes to it, at once.

With D the least costs of a search, a node v is reached over the edge (u, v) for which
D(u) + w - D(v) is least: 0 but for last digits. Following those edges back to the start by doubling
pointers adds up the driving times of all nodes in as many steps as the longest way has digits in
base two. Where several ways cost the same, the one whose time is added up may be another than the
one that is driven; whoever needs that to the second asks for the way.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...search.least_paths import LeastCosts

__all__ = ["times_along"]

Floats = NDArray[np.float64]


def times_along(tree: LeastCosts, drive_s: Floats) -> Floats:
    """Return how long the cheapest way between a place and each node takes.

    Parameters
    ----------
    tree : LeastCosts
        A search from one node, or to it.
    drive_s : ndarray of float, (m,)
        Driving time of each edge [s].

    Returns
    -------
    ndarray of float, (n,)
        Seconds; inf where there is no way.
    """
    net, cost = tree.net, tree.dist
    near, far = (net.tail, net.head) if tree.forward else (net.head, net.tail)
    there = np.isfinite(cost[near]) & np.isfinite(cost[far]) & np.isfinite(tree.weight)
    edges = np.flatnonzero(there)
    slack = cost[near[edges]] + tree.weight[edges] - cost[far[edges]]
    # Of the edges into a node the tightest comes first; the place itself has none that is tight.
    order = np.lexsort((edges, slack, far[edges]))
    ends, first = np.unique(far[edges[order]], return_index=True)
    chosen = edges[order[first]]
    before = np.arange(net.n)
    time = np.zeros(net.n)
    inner = cost[ends] > 0
    before[ends[inner]] = near[chosen[inner]]
    time[ends[inner]] = drive_s[chosen[inner]]
    while True:
        further = before[before]
        if (further == before).all():
            break
        time = time + time[before]
        before = further
    return np.where(np.isfinite(cost), time, np.inf)
