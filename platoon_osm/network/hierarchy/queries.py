"""Searches over a customized hierarchy: climb the elimination tree, then sweep down once.

A search needs no queue: the nodes it climbs are the ancestors of its source. A sweep from the
highest rank to the lowest then gives every node its distance. Many sources are swept together,
their distances side by side in memory: one look at an arc serves all of them.

References
----------
.. [1] Delling, Goldberg, Nowatzyk, Werneck, "PHAST: hardware-accelerated shortest path trees",
   IPDPS 2011.
.. [2] Delling, Goldberg, Werneck, "Faster batched shortest paths in road networks", ATMOS 2011
   (RPHAST).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .customization import Metric
from .jit import compiled
from .symbolic import Topology
from .threads import run_all

__all__ = ["Selection", "from_labels", "from_many", "from_one", "select", "selected_table"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]

LANES = 64
"""Sources swept together."""
FEW = 4
"""Up to so many sources are swept one by one: lanes left empty cost as much as full ones."""
WORTH_A_THREAD = 400_000
"""Arcs from which on one sweep is shared among threads."""


def from_one(metric: Metric, node: int, forward: bool = True, threads: int = 1) -> Floats:
    """Return costs (n,) from a node to all, or from all to it if not forward."""
    t = metric.topology
    climb, descend = metric.towards(forward)
    found = np.empty(t.n)
    if threads <= 1 or len(t.head) < WORTH_A_THREAD:
        _one(int(t.rank[node]), t.first, t.head, t.parent, climb, descend, t.node, found)
        return found
    dist = _climbed(int(t.rank[node]), t.first, t.head, t.parent, climb)
    _descend_together(metric, descend, dist, found, threads)
    return found


def from_labels(metric: Metric, labels: Floats, threads: int = 1) -> Floats:
    """Return for each node the least cost (n,) of a path that starts at any x with cost labels[x].

    Every node may be a start, so all are climbed from, in order of rank.
    """
    t = metric.topology
    found = np.empty(t.n)
    if threads <= 1 or len(t.head) < WORTH_A_THREAD:
        _labels(t.first, t.head, metric.up, metric.down, t.node, labels, found)
        return found
    dist = labels[t.node]
    top = t.top

    def ascend(part: tuple[int, int]) -> Floats:
        own = np.full(t.n - top, np.inf)
        _ascend(*part, t.first, t.head, metric.up, dist, top, own)
        return own

    for own in run_all(ascend, t.parts(), threads):
        np.minimum(dist[top:], own, out=dist[top:])
    _ascend(top, t.n, t.first, t.head, metric.up, dist, t.n, dist[:0])
    _descend_together(metric, metric.down, dist, found, threads)
    return found


def _descend_together(
    metric: Metric, descend: Floats, dist: Floats, found: Floats, threads: int
) -> None:
    t = metric.topology
    arrays = (t.first, t.head, descend, t.node, dist, found)
    _descend(t.top, t.n, *arrays)
    run_all(lambda part: _descend(part[0], part[1], *arrays), t.parts(), threads)


def from_many(metric: Metric, nodes: Longs, forward: bool = True, threads: int = 1) -> Floats:
    """Return costs (k, n) from each of k nodes to all, or from all to each.

    The result is the transpose of an array in which all distances of one node lie side by side.
    """
    t, count = metric.topology, len(nodes)
    climb, descend = metric.towards(forward)
    if count <= FEW:
        rows = np.empty((count, t.n))

        def one(k: int) -> None:
            start = int(t.rank[nodes[k]])
            _one(start, t.first, t.head, t.parent, climb, descend, t.node, rows[k])

        small = len(t.head) * count < WORTH_A_THREAD
        run_all(one, range(count), 1 if small else threads)
        return rows
    table = np.empty((t.n, count))
    starts, ranks = t.rank[nodes], np.arange(t.n, dtype=np.int32)
    large = len(t.head) * min(count, LANES) > WORTH_A_THREAD * 8

    def lanes(begin: int) -> None:
        part = starts[begin : begin + LANES]
        known = np.zeros(t.n, np.bool_)
        lane = (known, table, begin)
        _climb_lanes(part, t.first, t.head, t.parent, climb, t.node, ranks, *lane)
        arcs = (t.first, t.head, descend, t.node, *lane, len(part))
        if not large or threads <= 1:
            _sweep_lanes(0, t.n, *arcs)
            return
        # Threads share the subtrees, not the lanes: long rows are faster, arcs are read once.
        _sweep_lanes(t.top, t.n, *arcs)
        run_all(lambda part: _sweep_lanes(part[0], part[1], *arcs), t.parts(), threads)

    run_all(lanes, range(0, count, LANES), 1 if large else threads)
    return table.T


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
    climb, descend = metric.towards(forward)
    own = descend[part.arc]
    starts = t.rank[sources]
    width = min(LANES // 2, max(8, -(-len(starts) // threads)))

    def lanes(begin: int) -> None:
        end = begin + width
        _selected(
            starts[begin:end], t.first, t.head, t.parent, climb,
            part.local, part.first, part.head, own, part.row, found[begin:end],
        )  # fmt: skip

    small = len(part.head) * len(sources) < WORTH_A_THREAD
    run_all(lanes, range(0, len(starts), width), 1 if small else threads)
    return found


@compiled
def _climb(start: int, first: Ints, head: Ints, parent: Ints, climb: Floats, dist: Floats) -> None:
    dist[start] = 0.0
    v = start
    while v >= 0:
        d = dist[v]
        for a in range(first[v], first[v + 1]):
            u = head[a]
            if d + climb[a] < dist[u]:
                dist[u] = d + climb[a]
        v = parent[v]


@compiled
def _climbed(start: int, first: Ints, head: Ints, parent: Ints, climb: Floats) -> Floats:
    dist = np.full(len(parent), np.inf)
    _climb(start, first, head, parent, climb, dist)
    return dist


@compiled
def _ascend(
    low: int, high: int, first: Ints, head: Ints, climb: Floats, dist: Floats, top: int,
    top_dist: Floats,
) -> None:  # fmt: skip
    for v in range(low, high):
        d = dist[v]
        for a in range(first[v], first[v + 1]):
            u, new = head[a], d + climb[a]
            if u < top:
                before = dist[u]
                dist[u] = new if new < before else before
            elif new < top_dist[u - top]:
                top_dist[u - top] = new


@compiled
def _descend(
    low: int, high: int, first: Ints, head: Ints, descend: Floats, node: Ints, dist: Floats,
    found: Floats,
) -> None:  # fmt: skip
    end = first[high]
    for v in range(high - 1, low - 1, -1):
        best, begin = dist[v], first[v]
        for a in range(begin, end):
            # Unsigned, an index needs no look at its sign: a third of the time of the sweep.
            new = dist[np.uint64(head[a])] + descend[a]
            best = new if new < best else best
        dist[v] = best
        found[node[v]] = best
        end = begin


@compiled
def _one(
    start: int, first: Ints, head: Ints, parent: Ints, climb: Floats, descend: Floats,
    node: Ints, found: Floats,
) -> None:  # fmt: skip
    dist = np.full(len(parent), np.inf)
    _climb(start, first, head, parent, climb, dist)
    _descend(0, len(parent), first, head, descend, node, dist, found)


@compiled
def _labels(
    first: Ints, head: Ints, climb: Floats, descend: Floats, node: Ints, labels: Floats,
    found: Floats,
) -> None:  # fmt: skip
    n = len(node)
    dist = np.empty(n)
    for v in range(n):
        dist[v] = labels[node[v]]
    _ascend(0, n, first, head, climb, dist, n, dist[:0])
    _descend(0, n, first, head, descend, node, dist, found)


@compiled
def _sweep_lanes(
    low: int, high: int, first: Ints, head: Ints, descend: Floats, place: Ints,
    known: NDArray[np.bool_], table: Floats, begin: int, width: int,
) -> None:  # fmt: skip
    """Sweep lanes of a table from rank `high` down to `low`; rank v has the row place[v].

    Rows not `known` yet hold nothing. Arcs are taken two at a time to spare loads. The sum of the
    second is compared last: a comparison with the value in memory would become a masked store,
    which is twice as slow.
    """
    for v in range(high - 1, low - 1, -1):
        r, a, end = place[v], first[v], first[v + 1]
        if not known[v]:
            if a == end:
                for k in range(begin, begin + width):
                    table[r, k] = np.inf
                continue
            h, w = place[head[a]], descend[a]
            if (end - a) & 1:
                for k in range(begin, begin + width):
                    table[r, k] = table[h, k] + w
                a += 1
            else:
                g, x = place[head[a + 1]], descend[a + 1]
                for k in range(begin, begin + width):
                    p, q = table[h, k] + w, table[g, k] + x
                    table[r, k] = p if p < q else q
                a += 2
        elif (end - a) & 1:
            h, w = place[head[a]], descend[a]
            for k in range(begin, begin + width):
                p, s = table[h, k] + w, table[r, k]
                table[r, k] = p if p < s else s
            a += 1
        while a < end:
            h, w = place[head[a]], descend[a]
            g, x = place[head[a + 1]], descend[a + 1]
            for k in range(begin, begin + width):
                p, q, s = table[h, k] + w, table[g, k] + x, table[r, k]
                p = p if p < s else s
                table[r, k] = p if p < q else q
            a += 2


@compiled
def _into_lane(
    start: int, lane: int, parent: Ints, local: Ints, place: Ints, dist: Floats,
    known: NDArray[np.bool_], table: Floats, begin: int, width: int,
) -> None:  # fmt: skip
    """Copy what was climbed from a start into its lane, and forget it.

    `local` gives the row of `known` for each rank, -1 for none; `place` the row of the table.
    """
    v = start
    while v >= 0:
        r = local[v]
        if r >= 0:
            if not known[r]:
                known[r] = True
                for k in range(begin, begin + width):
                    table[place[r], k] = np.inf
            table[place[r], begin + lane] = dist[v]
        dist[v] = np.inf
        v = parent[v]


@compiled
def _climb_lanes(
    starts: Ints, first: Ints, head: Ints, parent: Ints, climb: Floats, node: Ints, ranks: Ints,
    known: NDArray[np.bool_], table: Floats, begin: int,
) -> None:  # fmt: skip
    width = len(starts)
    dist = np.full(len(parent), np.inf)
    for lane in range(width):
        _climb(starts[lane], first, head, parent, climb, dist)
        _into_lane(starts[lane], lane, parent, ranks, node, dist, known, table, begin, width)


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
    starts: Ints, first: Ints, head: Ints, parent: Ints, climb: Floats,
    local: Ints, own_first: Ints, own_head: Ints, own_descend: Floats, row: Ints, found: Floats,
) -> None:  # fmt: skip
    rows, width = len(own_first) - 1, len(starts)
    table = np.empty((rows, width))
    known = np.zeros(rows, np.bool_)
    same = np.arange(rows).astype(np.int32)
    dist = np.full(len(parent), np.inf)
    for lane in range(width):
        _climb(starts[lane], first, head, parent, climb, dist)
        _into_lane(starts[lane], lane, parent, local, same, dist, known, table, 0, width)
    _sweep_lanes(0, rows, own_first, own_head, own_descend, same, known, table, 0, width)
    for lane in range(width):
        for k in range(len(row)):
            found[lane, k] = table[row[k], lane]
