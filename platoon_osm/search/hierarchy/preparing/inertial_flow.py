"""Split a piece of the network by few edges: inertial flow.

Nodes are sorted along a direction; the first and the last quarter are source and sink, and a
maximum flow of unit capacities between them is a least cut. The best of four directions is kept.

References
----------
.. [1] Schild, Sommer, "On balanced separators in road networks", SEA 2015.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..runtime.jit import compiled

__all__ = ["bisect"]

Ints = NDArray[np.int32]
Floats = NDArray[np.float64]

QUARTER = 0.25
DIRECTIONS = np.array([[1.0, 0.0], [0.0, 1.0], [0.7071, 0.7071], [0.7071, -0.7071]])


@compiled
def _least_cut(
    first: Ints, head: Ints, back: Ints, kind: NDArray[np.int8], limit: int,
    flow: NDArray[np.int8], level: Ints, at: Ints, queue: Ints, path: Ints,
) -> int:  # fmt: skip
    """Send as much flow as fits from source to sink nodes (Dinic); stop above `limit`.

    `kind` is 1 for source and 2 for sink nodes. On return `level` is not below 0 for the nodes
    on the source's side of the cut, if the flow is not above the limit.
    """
    n = len(kind)
    rim = 0
    for v in range(n):
        if kind[v] == 1:
            for e in range(first[v], first[v + 1]):
                if kind[head[e]] != 1:
                    queue[rim] = v
                    rim += 1
                    break
    total = 0
    while True:
        for v in range(n):
            level[v] = 0 if kind[v] == 1 else -1
        begin, end, reached = 0, rim, -1
        while begin < end:
            v = queue[begin]
            begin += 1
            if reached >= 0 and level[v] >= reached:
                break
            for e in range(first[v], first[v + 1]):
                w = head[e]
                if level[w] < 0 and flow[e] < 1:
                    level[w] = level[v] + 1
                    if kind[w] == 2:
                        reached = level[w]
                    else:
                        queue[end] = w
                        end += 1
        if reached < 0:
            return total
        for v in range(n):
            at[v] = first[v]
        for k in range(rim):
            source = queue[k]
            while True:
                v, depth = source, 0
                while kind[v] != 2:
                    onward = False
                    while at[v] < first[v + 1]:
                        e = at[v]
                        if flow[e] < 1 and level[head[e]] == level[v] + 1:
                            onward = True
                            break
                        at[v] += 1
                    if onward:
                        path[depth] = at[v]
                        depth += 1
                        v = head[at[v]]
                    elif depth == 0:
                        break
                    else:
                        depth -= 1
                        v = head[back[path[depth]]]
                        at[v] += 1
                if kind[v] != 2:
                    break
                for i in range(depth):
                    flow[path[i]] += 1
                    flow[back[path[i]]] -= 1
                total += 1
                if total > limit:
                    return total


@compiled
def bisect(first: Ints, head: Ints, x: Floats, y: Floats, side: NDArray[np.int8]) -> int:
    """Split a graph into two sides and a set of nodes between them.

    Parameters
    ----------
    first : ndarray of int, (n + 1,)
        Where the neighbours of each node begin.
    head : ndarray of int, (2 m,)
        Undirected: every edge at both ends, neighbours ascending.
    x : ndarray of float, (n,)
        Positions in a plane.
    y : ndarray of float, (n,)
        Positions in a plane.
    side : ndarray of int, (n,)
        Result: 0 and 1 for the sides, 2 for the nodes between.

    Returns
    -------
    int
        Number of nodes between.
    """
    n = len(x)
    back = np.empty(len(head), np.int32)
    at = first[:-1].copy()
    for v in range(n):
        for e in range(first[v], first[v + 1]):
            # Neighbours ascend, so the counterparts of a node's slots are met in their order.
            w = head[e]
            back[e] = at[w]
            at[w] += 1
    kind = np.empty(n, np.int8)
    flow = np.empty(len(head), np.int8)
    level, queue, path = np.empty(n, np.int32), np.empty(n, np.int32), np.empty(n, np.int32)
    least, balance = len(head) + 1, 0
    along = np.empty(n)
    part = max(1, int(n * QUARTER))
    for direction in range(len(DIRECTIONS)):
        for v in range(n):
            along[v] = DIRECTIONS[direction, 0] * x[v] + DIRECTIONS[direction, 1] * y[v]
        order = np.argsort(along)
        kind[:] = 0
        for i in range(part):
            kind[order[i]] = 1
            kind[order[n - 1 - i]] = 2
        flow[:] = 0
        cut = _least_cut(first, head, back, kind, least, flow, level, at, queue, path)
        if cut > least:
            continue
        count = 0
        for v in range(n):
            if level[v] >= 0:
                count += 1
        even = min(count, n - count)
        if cut < least or even > balance:
            least, balance = cut, even
            for v in range(n):
                side[v] = 0 if level[v] >= 0 else 1
    ends = np.zeros(2, np.int64)
    for v in range(n):
        for e in range(first[v], first[v + 1]):
            if side[head[e]] != side[v]:
                ends[side[v]] += 1
                break
    smaller = 0 if ends[0] <= ends[1] else 1
    for v in range(n):
        if side[v] == smaller:
            for e in range(first[v], first[v + 1]):
                if side[head[e]] == 1 - smaller:
                    side[v] = 2
                    break
    return int(ends[smaller])
