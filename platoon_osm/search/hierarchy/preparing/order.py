"""The order of contraction: nested dissection over coordinates.

Nodes with one or two neighbours go first (chains and dead ends need no separator); what is left
is split again and again, and the nodes between two sides come after both.

References
----------
.. [1] Dibbelt, Strasser, Wagner, "Customizable contraction hierarchies", JEA 21 (2016).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ....network.antimeridian import middle_longitude_deg, near_deg
from ..runtime.jit import compiled
from ..runtime.threads import run_all
from .inertial_flow import bisect

__all__ = ["contraction_order", "neighbours"]

Ints = NDArray[np.int32]
Floats = NDArray[np.float64]


def neighbours(n: int, tail: Ints, head: Ints) -> tuple[Ints, Ints]:
    """Return the undirected simple graph under directed edges as first (n + 1,) and head.

    Parameters
    ----------
    n : int
        Number of nodes.
    tail : ndarray of int, (m,)
        Nodes where edges start.
    head : ndarray of int, (m,)
        Nodes where they end.

    Returns
    -------
    first : ndarray of int, (n + 1,)
        Where the neighbours of each node begin.
    head : ndarray of int, (2 k,)
        Neighbours, ascending.
    """
    low = np.minimum(tail, head).astype(np.int64)
    high = np.maximum(tail, head)
    key = np.unique((low * n + high)[low != high])
    low, high = key // max(n, 1), key % max(n, 1)
    first = np.zeros(n + 1, np.int32)
    np.cumsum(np.bincount(low, minlength=n) + np.bincount(high, minlength=n), out=first[1:])
    return first, _fill_neighbours(first, low.astype(np.int32), high.astype(np.int32))


@compiled
def _fill_neighbours(first: Ints, low: Ints, high: Ints) -> Ints:
    # Pairs ascend by (low, high): each node's lower neighbours come first, both lists ascending.
    head = np.empty(2 * len(low), np.int32)
    at = first[:-1].copy()
    for k in range(len(low)):
        head[at[high[k]]] = low[k]
        at[high[k]] += 1
    for k in range(len(low)):
        head[at[low[k]]] = high[k]
        at[low[k]] += 1
    return head


def contraction_order(first: Ints, head: Ints, lon: Floats, lat: Floats, threads: int = 1) -> Ints:
    """Return the nodes (n,) in the order in which they are contracted.

    Parameters
    ----------
    first : ndarray of int, (n + 1,)
        Where the neighbours of each node begin, as from `neighbours`.
    head : ndarray of int, (2 k,)
        Neighbours.
    lon : ndarray of float, (n,)
        Longitudes [degrees]; they decide how good the order is, never whether it is right.
    lat : ndarray of float, (n,)
        Latitudes [degrees].
    threads : int
        Cores to use.

    Returns
    -------
    ndarray of int, (n,)
        Nodes.
    """
    n = len(lon)
    order = np.empty(n, np.int32)
    x = near_deg(lon, middle_longitude_deg(lon)) * np.cos(np.radians(lat.mean() if n else 0.0))
    y = np.ascontiguousarray(lat)
    slots, degree = head.copy(), np.diff(first).astype(np.int32)
    done = _contract_thin(first, slots, degree, order)
    core = np.ones(n, bool)
    core[order[:done]] = False
    order[done:] = np.flatnonzero(core)
    part = np.full(n, -1, np.int32)
    part[order[done:]] = done
    local = np.zeros(n, np.int32)
    graph = (first, slots, degree, x, y, order, part, local)
    pieces = [(done, n)]
    whole = max(2000, (n - done) // (8 * threads))
    small: list[tuple[int, int]] = []
    while pieces:
        small += [piece for piece in pieces if piece[1] - piece[0] <= whole]
        large = [piece for piece in pieces if piece[1] - piece[0] > whole]
        splits = run_all(lambda piece: _split(*graph, *piece), large, threads)
        pieces = []
        for (low, _), (left, right) in zip(large, splits, strict=True):
            pieces += [(low, left), (left, right)]
    # Largest first, so that no thread starts a long piece when the others are about to end.
    small.sort(key=lambda piece: piece[0] - piece[1])
    run_all(lambda piece: _dissect(*graph, *piece), small, threads)
    return order


@compiled
def _contract_thin(first: Ints, head: Ints, degree: Ints, order: Ints) -> int:
    """Contract nodes with at most two neighbours, again and again; return how many.

    A contracted node joins its two neighbours, so no list of neighbours ever grows. Neighbours of
    a contracted node wait a round: chains then shrink by halves and the hierarchy stays shallow.
    """
    n = len(first) - 1
    queue, later = np.empty(n, np.int32), np.empty(n, np.int32)
    gone = np.zeros(n, np.bool_)
    waits, listed = np.full(n, -1, np.int32), np.full(n, -1, np.int32)
    count = done = turn = 0
    for v in range(n):
        if degree[v] <= 2:
            queue[count] = v
            count += 1
    while count:
        kept = 0
        for k in range(count):
            v = queue[k]
            if gone[v] or waits[v] == turn:
                continue
            gone[v] = True
            order[done] = v
            done += 1
            for i in range(degree[v]):
                u = head[first[v] + i]
                other = head[first[v] + 1 - i] if degree[v] == 2 else np.int32(-1)
                place = known = -1
                for slot in range(first[u], first[u] + degree[u]):
                    if head[slot] == v:
                        place = slot
                    elif head[slot] == other:
                        known = slot
                if other >= 0 and known < 0:
                    head[place] = other
                else:
                    degree[u] -= 1
                    head[place] = head[first[u] + degree[u]]
                waits[u] = turn
                if degree[u] <= 2 and listed[u] != turn:
                    later[kept] = u
                    kept += 1
                    listed[u] = turn
        queue, later = later, queue
        count = kept
        turn += 1
    return done


@compiled
def _split(
    first: Ints, head: Ints, degree: Ints, x: Floats, y: Floats, order: Ints, part: Ints,
    local: Ints, low: int, high: int,
) -> tuple[int, int]:  # fmt: skip
    """Rearrange order[low:high] into side, side, nodes between; return where the sides end."""
    size = high - low
    nodes = order[low:high].copy()
    begin = np.zeros(size + 1, np.int32)
    for i in range(size):
        local[nodes[i]] = i
    for i in range(size):
        v = nodes[i]
        for slot in range(first[v], first[v] + degree[v]):
            if part[head[slot]] == low:
                begin[i + 1] += 1
    for i in range(size):
        begin[i + 1] += begin[i]
    near = np.empty(begin[size], np.int32)
    at = begin[:-1].copy()
    for i in range(size):
        v = nodes[i]
        for slot in range(first[v], first[v] + degree[v]):
            if part[head[slot]] == low:
                # Filing each node with its neighbours keeps every list ascending.
                other = local[head[slot]]
                near[at[other]] = i
                at[other] += 1
    side = np.zeros(size, np.int8)
    px, py = np.empty(size), np.empty(size)
    for i in range(size):
        px[i], py[i] = x[nodes[i]], y[nodes[i]]
    bisect(begin, near, px, py, side)
    place = low
    left = right = low
    for wanted in range(3):
        start = place
        for i in range(size):
            if side[i] == wanted:
                order[place] = nodes[i]
                part[nodes[i]] = start if wanted < 2 else -1
                place += 1
        if wanted == 0:
            left = place
        elif wanted == 1:
            right = place
    return left, right


@compiled
def _dissect(
    first: Ints, head: Ints, degree: Ints, x: Floats, y: Floats, order: Ints, part: Ints,
    local: Ints, low: int, high: int,
) -> None:  # fmt: skip
    """Split order[low:high] until nothing is left to split."""
    stack = [(low, high)]
    while stack:
        low, high = stack.pop()
        if high - low <= 2:
            continue
        left, right = _split(first, head, degree, x, y, order, part, local, low, high)
        stack.append((low, left))
        stack.append((left, right))
