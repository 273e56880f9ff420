"""Symbolic contraction: which arcs a hierarchy needs under any weight.

Contracting a node joins all its later neighbours. The arcs that arise depend on the order alone,
so this is done once a network. Ranks are then given anew as sweeps like them (`ranks`).

References
----------
.. [1] Dibbelt, Strasser, Wagner, "Customizable contraction hierarchies", JEA 21 (2016), sections
   4 and 5.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..runtime.jit import compiled
from .order import contraction_order, neighbours
from .ranks import block_rows, runs, sweep_ranks

__all__ = ["Topology", "build_topology"]

Ints = NDArray[np.int32]
Floats = NDArray[np.float64]
Longs = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Topology:
    """The hierarchy without weights: n nodes by rank, a arcs from lower to higher rank.

    Attributes
    ----------
    node : ndarray of int, (n,)
        The network's node of each rank.
    rank : ndarray of int, (n,)
        The rank of each of the network's nodes.
    first : ndarray of int, (n + 1,)
        Where the arcs of each rank begin.
    head : ndarray of int, (a,)
        Rank of the upper end; ascending within each node's arcs.
    upper : ndarray of int, (a,)
        The network's node at the upper end.
    run : ndarray of int, (r + 1,)
        Ranks where the class of nodes changes, by number of arcs, and n.
    block : ndarray of int, (b + 1,)
        Ranks where the blocks begin, and n.
    local : ndarray of int, (a,)
        Row of the upper end in the buffer of the block: nodes of the block by rank, then those
        above it that its root has arcs to.
    parent : ndarray of int, (n,)
        Rank of the lowest upper neighbour; -1 for roots.
    triangle : ndarray of int, (t,)
        For each node, for each pair i < j of its arcs, the arc between their heads.
    triangle_first : ndarray of int, (n + 1,)
        Where the triangles of each rank begin.
    forth : ndarray of int, (a,)
        The edge up each arc; m, which is no edge, if there is none.
    back : ndarray of int, (a,)
        The edge down each arc; m likewise.
    spare : ndarray of int, (k,)
        Edges parallel to those.
    spare_place : ndarray of int, (k,)
        Where each belongs: 2 * arc, plus 1 if it leads down; ascending.
    subtree : ndarray of int, (s + 1,)
        Ranks where the subtrees for threads begin; the last is where the top begins.
    """

    node: Ints
    rank: Ints
    first: Ints
    head: Ints
    upper: Ints
    run: Ints
    block: Ints
    local: Ints
    parent: Ints
    triangle: Ints
    triangle_first: Longs
    forth: Ints
    back: Ints
    spare: Ints
    spare_place: Ints
    subtree: Ints

    @property
    def n(self) -> int:
        """Number of nodes."""
        return len(self.node)

    @property
    def top(self) -> int:
        """First rank above all subtrees."""
        return int(self.subtree[-1])

    def parts(self) -> list[tuple[int, int]]:
        """Return the ranks of each subtree, the one with most arcs first.

        Returns
        -------
        list of tuple of int
            First rank and the one after the last.
        """
        pairs = list(zip(self.subtree[:-1].tolist(), self.subtree[1:].tolist(), strict=True))
        return sorted(pairs, key=lambda pair: int(self.first[pair[0]] - self.first[pair[1]]))


def build_topology(
    tail: Ints,
    head: Ints,
    lon: Floats,
    lat: Floats,
    threads: int = 1,
    order: Ints | None = None,
) -> Topology:
    """Order and contract a network.

    Parameters
    ----------
    tail : ndarray of int, (m,)
        Nodes where its edges start.
    head : ndarray of int, (m,)
        Nodes where they end.
    lon : ndarray of float, (n,)
        Longitudes [degrees].
    lat : ndarray of float, (n,)
        Latitudes [degrees].
    threads : int
        Cores to use.
    order : ndarray of int, (n,), optional
        The nodes in the order in which they are to be contracted, if it is known already.

    Returns
    -------
    Topology
        The hierarchy without weights.
    """
    n = len(lon)
    near_first, near = neighbours(n, tail, head)
    if order is None:
        order = contraction_order(near_first, near, lon, lat, threads)
    rank = np.empty(n, np.int32)
    rank[order] = np.arange(n, dtype=np.int32)
    first, up, parent = _contract(near_first, near, order, rank)
    found = sweep_ranks(first, up, parent)
    node = order[found.old]
    rank[node] = np.arange(n, dtype=np.int32)
    first, up, parent = found.first, found.head, found.parent
    triangle, triangle_first = _triangles(first, up)
    place = _places(rank[tail], rank[head], first, up)
    forth, back, spare = _edges_of_arcs(place, len(up))
    spare = spare[np.argsort(place[spare], kind="stable")]
    return Topology(
        node, rank, first, up, node[up], runs(first), found.block,
        block_rows(first, up, found.block), parent, triangle, triangle_first, forth, back, spare,
        place[spare], found.subtree,
    )  # fmt: skip


@compiled
def _contract(near_first: Ints, near: Ints, order: Ints, rank: Ints) -> tuple[Ints, Ints, Ints]:
    n = len(order)
    first = np.zeros(n + 1, np.int32)
    parent = np.full(n, -1, np.int32)
    # Children form linked lists; a node's later neighbours are its own and its children's.
    child, sibling = np.full(n, -1, np.int32), np.full(n, -1, np.int32)
    seen = np.full(n, -1, np.int32)
    up = np.empty(2 * len(near) + 16, np.int32)
    count = 0
    for v in range(n):
        seen[v] = v
        if count + n - v > len(up):
            larger = np.empty(2 * len(up) + n, np.int32)
            larger[:count] = up[:count]
            up = larger
        least = n
        x = order[v]
        for slot in range(near_first[x], near_first[x + 1]):
            u = rank[near[slot]]
            if u > v and seen[u] != v:
                seen[u] = v
                up[count] = u
                count += 1
                least = min(least, u)
        c = child[v]
        while c >= 0:
            for a in range(first[c], first[c + 1]):
                u = up[a]
                if seen[u] != v:
                    seen[u] = v
                    up[count] = u
                    count += 1
                    least = min(least, u)
            c = sibling[c]
        first[v + 1] = count
        if least < n:
            parent[v] = least
            sibling[v] = child[least]
            child[least] = v
    return first, up[:count].copy(), parent


@compiled
def _triangles(first: Ints, up: Ints) -> tuple[Ints, Longs]:
    n = len(first) - 1
    begin = np.zeros(n + 1, np.int64)
    for v in range(n):
        k = first[v + 1] - first[v]
        begin[v + 1] = begin[v] + k * (k - 1) // 2
    found = np.empty(begin[n], np.int32)
    t = 0
    for v in range(n):
        last = first[v + 1]
        for i in range(first[v], last):
            # The later neighbours of v are all neighbours of the i-th: one merge finds them.
            a = first[up[i]]
            for j in range(i + 1, last):
                while up[a] != up[j]:
                    a += 1
                found[t] = a
                t += 1
    return found, begin


@compiled
def _places(tail: Ints, head: Ints, first: Ints, up: Ints) -> Ints:
    place = np.empty(len(tail), np.int32)
    for e in range(len(tail)):
        low, high = min(tail[e], head[e]), max(tail[e], head[e])
        if low == high:
            place[e] = -1
            continue
        a, b = first[low], first[low + 1] - 1
        while a < b:
            middle = (a + b) // 2
            if up[middle] < high:
                a = middle + 1
            else:
                b = middle
        place[e] = 2 * a + (tail[e] > head[e])
    return place


@compiled
def _edges_of_arcs(place: Ints, arcs: int) -> tuple[Ints, Ints, Ints]:
    none = np.int32(len(place))
    forth, back = np.full(arcs, none), np.full(arcs, none)
    spare = np.empty(len(place), np.int32)
    count = 0
    for e in range(len(place)):
        if place[e] < 0:
            continue
        of_arc = back if place[e] & 1 else forth
        if of_arc[place[e] >> 1] == none:
            of_arc[place[e] >> 1] = e
        else:
            spare[count] = e
            count += 1
    return forth, back, spare[:count].copy()
