"""Tables of costs from many nodes to all.

All sources are swept together, block by block: a block's rows fit a core's cache, are worked off
there and then written to the table once. Only rows of nodes above all blocks are read again, and
of the nodes that a block's root has arcs to.

References
----------
.. [1] Delling, Goldberg, Nowatzyk, Werneck, "PHAST: hardware-accelerated shortest path trees",
   IPDPS 2011.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..customization import Metric
from ..runtime.jit import compiled
from ..runtime.lent import lent
from ..runtime.streaming import LINE, aligned_rows, stream_line
from ..runtime.threads import run_all
from .rows import sweep_rows
from .sweeps import ancestors, climb, from_one
from .two_sweeps import from_two

__all__ = ["from_many"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]
Blocks = tuple[int, int]

LANES = 64
"""Sources swept together."""
FEW = 4
"""Up to so many sources are swept one by one: lanes left empty cost as much as full ones."""
WORTH_A_THREAD = 500_000
"""Arcs times sources from which on threads share the work."""


def from_many(metric: Metric, nodes: Longs, forward: bool = True, threads: int = 1) -> Floats:
    """Return costs (k, n) from each of k nodes to all, or from all to each.

    The result is the transpose of an array in which all distances of one node lie side by side.

    Parameters
    ----------
    metric : Metric
        The hierarchy under one weight.
    nodes : ndarray of int, (k,)
        Nodes searched from.
    forward : bool
        Whether paths start at the nodes; else they end there.
    threads : int
        Cores to use; results do not depend on it.

    Returns
    -------
    ndarray of float, (k, n)
        Costs; inf where there is no way.
    """
    t, count = metric.topology, len(nodes)
    workers = 1 if len(t.head) * count < WORTH_A_THREAD else threads
    if count == 2:
        return from_two(metric, nodes, forward, threads)
    if count <= FEW:
        found = lent(count, t.n)
        run_all(
            lambda k: from_one(metric, int(nodes[k]), forward, 1, found[k]), range(count), workers
        )
        return found
    ascend, descend = metric.towards(forward)
    width = -(-count // LINE) * LINE
    table = aligned_rows(t.n, width)
    top = int(np.searchsorted(t.block, t.top))
    parts = [(int(low), int(high)) for low, high in np.searchsorted(t.block, t.parts())]
    known = np.zeros(t.n, np.bool_)
    for begin in range(0, count, LANES):
        lanes = t.rank[nodes[begin : begin + LANES]]
        size = min(LANES, width - begin)
        known[:] = False
        _climb_lanes(lanes, t.first, t.upper, t.parent, ascend, t.node, known, table, begin, size)

        def sweep(blocks: Blocks, begin: int = begin, size: int = size) -> None:
            _sweep_blocks(
                blocks[0], blocks[1], t.block, t.first, t.upper, t.local, descend, t.node, known,
                table, table.ravel(), begin, size,
            )  # fmt: skip

        sweep((top, len(t.block) - 1))
        # Threads share the subtrees, not the lanes: long rows are faster, arcs are read once.
        run_all(sweep, parts, workers)
    return table[:, :count].T


@compiled
def _climb_lanes(
    starts: Ints, first: Ints, upper: Ints, parent: Ints, ascend: Floats, node: Ints,
    known: NDArray[np.bool_], table: Floats, begin: int, width: int,
) -> None:  # fmt: skip
    """Climb from each start in a lane of its own; the rows of all that are climbed are `known`."""
    for lane in range(len(starts)):
        v = starts[lane]
        while v >= 0 and not known[v]:
            known[v] = True
            table[node[v], begin : begin + width] = np.inf
            v = parent[v]
    for lane in range(len(starts)):
        climbed = ancestors(starts[lane], parent)
        climb(climbed, first, upper, ascend, node, table[:, begin + lane])


@compiled
def _sweep_blocks(
    low: int, high: int, block: Ints, first: Ints, upper: Ints, local: Ints, descend: Floats,
    node: Ints, known: NDArray[np.bool_], table: Floats, flat: Floats, begin: int, width: int,
) -> None:  # fmt: skip
    """Sweep the blocks from `high` down to `low`, each in a buffer of its own.

    The buffer's rows are the block's nodes, then the nodes outside that its root has arcs to.
    """
    most = 0
    for b in range(low, high):
        root = block[b + 1] - 1
        most = max(most, block[b + 1] - block[b] + first[root + 1] - first[root])
    buffer = np.empty((most, width))
    cells, columns = buffer.ravel(), table.shape[1]
    for b in range(high - 1, low - 1, -1):
        start, end = block[b], block[b + 1]
        size = end - start
        outside = first[end - 1]
        for k in range(first[end] - outside):
            buffer[size + k] = table[upper[outside + k], begin : begin + width]
        for v in range(start, end):
            if known[v]:
                buffer[v - start] = table[node[v], begin : begin + width]
        sweep_rows(start, end, first, local, descend, known, buffer)
        if size == 1:
            # Lower blocks will read it.
            table[node[start], begin : begin + width] = buffer[0]
            continue
        for k in range(size):
            to = np.int64(node[start + k]) * columns + begin
            for cell in range(0, width, LINE):
                stream_line(flat, to + cell, cells, k * width + cell)
