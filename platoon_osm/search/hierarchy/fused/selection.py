"""Searches from many sources to some targets: only the part of a hierarchy that leads there.

References
----------
.. [1] Delling, Goldberg, Werneck, "Faster batched shortest paths in road networks", ATMOS 2011
   (RPHAST).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..customization import Metric
from ..preparing.symbolic import Topology
from ..runtime.jit import compiled
from ..runtime.threads import run_all
from ..sweeping.rows import sweep_rows

__all__ = ["Selection", "climb", "into_lane", "select", "selected_table"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]

LANES = 32
"""Sources swept together."""
WORTH_A_THREAD = 400_000
"""Arcs times sources from which on the work is shared among threads."""


@dataclass(frozen=True, slots=True, eq=False)
class Selection:
    """The part of a hierarchy that a sweep to some targets needs: they and all their ancestors.

    Attributes
    ----------
    local : ndarray of int, (n,)
        Row of each rank; -1 outside.
    first : ndarray of int, (r + 1,)
        Where the arcs of each row begin.
    head : ndarray of int, (b,)
        Row of each arc's upper end.
    arc : ndarray of int, (b,)
        The arc in the whole hierarchy.
    row : ndarray of int, (k,)
        Row of each target.
    """

    local: Ints
    first: Ints
    head: Ints
    arc: Ints
    row: Ints


def select(topology: Topology, targets: Longs) -> Selection:
    """Return what sweeps to some targets need.

    Parameters
    ----------
    topology : Topology
        The whole hierarchy.
    targets : ndarray of int, (k,)
        Nodes.

    Returns
    -------
    Selection
        The part that leads to them.
    """
    t = topology
    ranks = t.rank[targets]
    local, first, head, arc = _select(ranks, t.first, t.head, t.parent)
    return Selection(local, first, head, arc, local[ranks])


def selected_table(
    metric: Metric, sources: Longs, targets: Longs, forward: bool = True, threads: int = 1
) -> Floats:
    """Return costs (s, t) from sources to targets, or from targets to sources if not forward.

    Parameters
    ----------
    metric : Metric
        The hierarchy under one weight.
    sources : ndarray of int, (s,)
        Nodes where paths start, if forward.
    targets : ndarray of int, (t,)
        Nodes where they end, if forward.
    forward : bool
        Whether paths lead to the targets; else they start there.
    threads : int
        Cores to use; results do not depend on it.

    Returns
    -------
    ndarray of float, (s, t)
        Costs; inf where there is no way.
    """
    t = metric.topology
    found = np.empty((len(sources), len(targets)))
    if not found.size:
        return found
    part = select(t, targets)
    cost, descend = metric.towards(forward)
    own = descend[part.arc]
    starts = t.rank[sources]
    width = min(LANES, max(8, -(-len(starts) // threads)))

    def lanes(begin: int) -> None:
        end = begin + width
        _selected(
            starts[begin:end], t.first, t.head, t.parent, cost,
            part.local, part.first, part.head, own, part.row, found[begin:end],
        )  # fmt: skip

    small = len(part.head) * len(sources) < WORTH_A_THREAD
    run_all(lanes, range(0, len(starts), width), 1 if small else threads)
    return found


@compiled
def climb(start: int, first: Ints, head: Ints, parent: Ints, cost: Floats, dist: Floats) -> None:
    """Climb from a rank; `dist` (n,) is inf before, and what was reached holds costs after.

    Parameters
    ----------
    start : int
        The rank.
    first : ndarray of int, (n + 1,)
        Where the arcs of each rank begin.
    head : ndarray of int, (a,)
        Rank of each arc's upper end.
    parent : ndarray of int, (n,)
        Rank of the lowest upper neighbour; -1 for roots.
    cost : ndarray of float, (a,)
        Cost of each arc upward.
    dist : ndarray of float, (n,)
        Costs by rank, written here.
    """
    dist[start] = 0.0
    v = start
    while v >= 0:
        d = dist[v]
        for a in range(first[v], first[v + 1]):
            u = head[a]
            if d + cost[a] < dist[u]:
                dist[u] = d + cost[a]
        v = parent[v]


@compiled
def into_lane(
    start: int, lane: int, parent: Ints, local: Ints, dist: Floats, known: NDArray[np.bool_],
    table: Floats,
) -> None:  # fmt: skip
    """Copy what was climbed from a start into its lane, and forget it.

    Parameters
    ----------
    start : int
        The rank that was climbed from.
    lane : int
        Column of the table.
    parent : ndarray of int, (n,)
        Rank of the lowest upper neighbour; -1 for roots.
    local : ndarray of int, (n,)
        Row of each rank; -1 for none.
    dist : ndarray of float, (n,)
        Costs by rank, inf again after.
    known : ndarray of bool, (r,)
        Rows that hold costs already.
    table : ndarray of float, (r, lanes)
        Costs so far.
    """
    v = start
    while v >= 0:
        r = local[v]
        if r >= 0:
            if not known[r]:
                known[r] = True
                table[r] = np.inf
            table[r, lane] = dist[v]
        dist[v] = np.inf
        v = parent[v]


@compiled
def _select(targets: Ints, first: Ints, head: Ints, parent: Ints) -> tuple[Ints, Ints, Ints, Ints]:
    n = len(parent)
    local = np.full(n, -1, np.int32)
    count = arcs = 0
    for k in range(len(targets)):
        v = targets[k]
        while v >= 0 and local[v] < 0:
            local[v] = 0
            count += 1
            arcs += first[v + 1] - first[v]
            v = parent[v]
    own_first = np.zeros(count + 1, np.int32)
    own_head, arc = np.empty(arcs, np.int32), np.empty(arcs, np.int32)
    row = 0
    for v in range(n):
        if local[v] == 0:
            local[v] = row
            row += 1
    row = at = 0
    for v in range(n):
        if local[v] >= 0:
            for a in range(first[v], first[v + 1]):
                own_head[at] = local[head[a]]
                arc[at] = a
                at += 1
            row += 1
            own_first[row] = at
    return local, own_first, own_head, arc


@compiled
def _selected(
    starts: Ints, first: Ints, head: Ints, parent: Ints, cost: Floats,
    local: Ints, own_first: Ints, own_head: Ints, own_descend: Floats, row: Ints, found: Floats,
) -> None:  # fmt: skip
    rows, width = len(own_first) - 1, len(starts)
    table = np.empty((rows, width))
    known = np.zeros(rows, np.bool_)
    dist = np.full(len(parent), np.inf)
    for lane in range(width):
        climb(starts[lane], first, head, parent, cost, dist)
        into_lane(starts[lane], lane, parent, local, dist, known, table)
    sweep_rows(0, rows, own_first, own_head, own_descend, known, table)
    for lane in range(width):
        for k in range(len(row)):
            found[lane, k] = table[row[k], lane]
