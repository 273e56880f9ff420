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
    local : (n,) row of each rank; -1 outside.
    first : (r + 1,) where the arcs of each row begin.
    head : (b,) row of each arc's upper end.
    arc : (b,) the arc in the whole hierarchy.
    row : (k,) row of each target.
    """

    local: Ints
    first: Ints
    head: Ints
    arc: Ints
    row: Ints


def select(topology: Topology, targets: Longs) -> Selection:
    """Return what sweeps to some targets need."""
    t = topology
    ranks = t.rank[targets]
    local, first, head, arc = _select(ranks, t.first, t.head, t.parent)
    return Selection(local, first, head, arc, local[ranks])


def selected_table(
    metric: Metric, sources: Longs, targets: Longs, forward: bool = True, threads: int = 1
) -> Floats:
    """Return costs (s, t) from sources to targets, or from targets to sources if not forward."""
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
    """Climb from a rank; `dist` (n,) is inf before, and what was reached holds costs after."""
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

    `local` gives the row of each rank, -1 for none.
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
