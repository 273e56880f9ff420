"""New ranks for the nodes of a hierarchy, such as sweeps like them.

Any order will do in which arcs lead up. This one has every subtree of the elimination tree in one
piece, in three steps:

1. Subtrees of at most a share of all arcs are swept by different threads; the ranks of the top,
   the nodes above them, come last.
2. Within these, subtrees small enough for a core's cache form blocks. Nothing outside a block has
   an arc to its nodes, and what its nodes have arcs to outside, its root has too. So a block can be
   worked off in a small buffer. A node above all blocks is one of its own.
3. Within a block, nodes with equally many arcs follow each other as far as can be. Long runs of
   them are worked off without a branch that the processor could guess wrong: a sweep takes a third
   of the time.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..runtime.jit import compiled

__all__ = ["MANY", "Ranks", "block_rows", "runs", "sweep_ranks"]

Ints = NDArray[np.int32]

SHARE = 4
"""A subtree swept by one thread holds at most one part in this many of all arcs."""
BLOCK = 512
"""Nodes at most in a block: with 64 distances each they fill a quarter of a megabyte."""
MANY = 4
"""Nodes with so many arcs or more are of one class: there are few."""


@dataclass(frozen=True, slots=True, eq=False)
class Ranks:
    """The new ranks, and the arcs under them.

    Attributes
    ----------
    old : ndarray of int, (n,)
        The former rank of each new one.
    first : ndarray of int, (n + 1,)
        As in `Topology`.
    head : ndarray of int, (a,)
        As in `Topology`.
    parent : ndarray of int, (n,)
        As in `Topology`.
    subtree : ndarray of int, (s + 1,)
        Ranks where the subtrees for threads begin, and where the top begins.
    block : ndarray of int, (b + 1,)
        Ranks where the blocks begin, and n.
    """

    old: Ints
    first: Ints
    head: Ints
    parent: Ints
    subtree: Ints
    block: Ints


def sweep_ranks(first: Ints, head: Ints, parent: Ints) -> Ranks:
    """Give ranks anew.

    Parameters
    ----------
    first : ndarray of int, (n + 1,)
        Where the arcs of each former rank begin.
    head : ndarray of int, (a,)
        Former rank of each arc's upper end.
    parent : ndarray of int, (n,)
        Former rank of the lowest upper neighbour; -1 for roots.

    Returns
    -------
    Ranks
        The new ranks, and the arcs under them.
    """
    n = len(parent)
    new, subtree = _subtrees_together(first, parent, SHARE)
    first, head, parent = _renumber(first, head, parent, new)
    old = np.empty(n, np.int32)
    old[new] = np.arange(n, dtype=np.int32)
    block = _block_bounds(parent, subtree, BLOCK)
    by_class = _alike_together(first, parent, block, MANY)
    new = np.empty(n, np.int32)
    new[by_class] = np.arange(n, dtype=np.int32)
    return Ranks(old[by_class], *_renumber(first, head, parent, new), subtree, block)


def runs(first: Ints) -> Ints:
    """Return where the class of nodes changes, and the number of nodes at the end.

    Parameters
    ----------
    first : ndarray of int, (n + 1,)
        Where the arcs of each rank begin.

    Returns
    -------
    ndarray of int, (r + 1,)
        Ranks.
    """
    arcs = np.minimum(np.diff(first), MANY)
    changes = np.flatnonzero(arcs[1:] != arcs[:-1]) + 1
    return np.concatenate([np.zeros(min(len(arcs), 1)), changes, [len(arcs)]]).astype(np.int32)


@compiled
def _subtrees_together(first: Ints, parent: Ints, share: int) -> tuple[Ints, Ints]:
    """Return new ranks: subtrees of at most 1/share of the arcs one by one, then the top."""
    n = len(parent)
    size, arcs = np.ones(n, np.int32), np.empty(n, np.int64)
    for v in range(n):
        arcs[v] = first[v + 1] - first[v] + 1
    for v in range(n):
        if parent[v] >= 0:
            size[parent[v]] += size[v]
            arcs[parent[v]] += arcs[v]
    most = (first[n] + n) // share + 1
    top = 0
    for v in range(n):
        if arcs[v] > most:
            top += 1
    renumbered = np.empty(n, np.int32)
    free = np.empty(n, np.int32)
    starts, arcs_between = [0], [arcs[:0].sum()]
    at, last = n - top, n
    # Parents before children; each node's subtree takes the ranks just below its own.
    for v in range(n - 1, -1, -1):
        if arcs[v] > most:
            last -= 1
            renumbered[v] = last
        elif parent[v] < 0 or arcs[parent[v]] > most:
            renumbered[v] = at - 1
            free[v] = at - 1
            at -= size[v]
            starts.append(at)
            arcs_between.append(arcs[v])
        else:
            p = parent[v]
            renumbered[v] = free[p] - 1
            free[v] = free[p] - 1
            free[p] -= size[v]
    # Small neighbouring subtrees are joined, for a disconnected network has very many.
    subtree = [n - top]
    load = 0
    low = n - top
    for k in range(1, len(starts)):
        load += arcs_between[k]
        low = starts[k]
        if load + (arcs_between[k + 1] if k + 1 < len(starts) else most) > most:
            subtree.append(low)
            load = 0
    if subtree[-1] != 0:
        subtree.append(0)
    return renumbered, np.array(subtree[::-1], np.int32)


@compiled
def _block_bounds(parent: Ints, subtree: Ints, most: int) -> Ints:
    n = len(parent)
    size = np.ones(n, np.int32)
    for v in range(n):
        if parent[v] >= 0:
            size[parent[v]] += size[v]
    bounds = np.empty(n + 1, np.int32)
    low = count = n
    bounds[n] = n
    top = subtree[-1]
    while low > 0:
        # The highest rank left is the root of the subtree below it.
        root = low - 1
        low = root + 1 - size[root] if root < top and size[root] <= most else root
        count -= 1
        bounds[count] = low
    return bounds[count:].copy()


@compiled
def _alike_together(first: Ints, parent: Ints, block: Ints, many: int) -> Ints:
    """Return the ranks in their new order: in each block, from its root down, alike after alike.

    A node may follow as soon as its parent has been: all its upper neighbours are the parent's or
    the parent itself.
    """
    n = len(parent)
    order = np.empty(n, np.int32)
    child, sibling = np.full(n, -1, np.int32), np.full(n, -1, np.int32)
    for v in range(n):
        if parent[v] >= 0:
            sibling[v] = child[parent[v]]
            child[parent[v]] = v
    ready = np.empty((many + 1, np.diff(block).max() if n else 0), np.int32)
    for k in range(len(block) - 1):
        taken, waiting = np.zeros(many + 1, np.int32), np.zeros(many + 1, np.int32)
        at = block[k + 1]
        kind = min(first[at] - first[at - 1], many)
        ready[kind, 0] = at - 1
        waiting[kind] = 1
        while at > block[k]:
            kind = np.argmax(waiting - taken)
            while taken[kind] < waiting[kind]:
                v = ready[kind, taken[kind]]
                taken[kind] += 1
                at -= 1
                order[at] = v
                c = child[v]
                # What hangs below a block of one node is in other blocks.
                while c >= block[k]:
                    own = min(first[c + 1] - first[c], many)
                    ready[own, waiting[own]] = c
                    waiting[own] += 1
                    c = sibling[c]
    return order


def block_rows(first: Ints, head: Ints, block: Ints) -> Ints:
    """Return the row of each arc's upper end in its block's buffer, as `Topology.local`.

    Parameters
    ----------
    first : ndarray of int, (n + 1,)
        Where the arcs of each rank begin.
    head : ndarray of int, (a,)
        Rank of each arc's upper end.
    block : ndarray of int, (b + 1,)
        Ranks where the blocks begin, and n.

    Returns
    -------
    ndarray of int, (a,)
        Rows.

    Raises
    ------
    ValueError
        Blocks that are none: an arc leads to a node that their root has no arc to.
    """
    rows = _block_rows(first, head, block)
    if len(rows) and rows.min() < 0:
        raise ValueError("blocks do not fit the arcs")
    return rows


@compiled
def _block_rows(first: Ints, head: Ints, block: Ints) -> Ints:
    rows = np.full(len(head), -1, np.int32)
    for k in range(len(block) - 1):
        low, high = block[k], block[k + 1]
        outside, end = first[high - 1], first[high]
        for v in range(low, high):
            slot = outside
            for a in range(first[v], first[v + 1]):
                if head[a] < high:
                    rows[a] = head[a] - low
                    continue
                while slot < end and head[slot] < head[a]:
                    slot += 1
                if slot < end and head[slot] == head[a]:
                    rows[a] = high - low + slot - outside
    return rows


@compiled
def _renumber(first: Ints, up: Ints, parent: Ints, renumbered: Ints) -> tuple[Ints, Ints, Ints]:
    n = len(parent)
    # Filing arcs under their upper ends in order of the lower, and back again, sorts them.
    new_first, below = np.zeros(n + 1, np.int32), np.zeros(n + 1, np.int32)
    old = np.empty(n, np.int32)
    new_parent = np.full(n, -1, np.int32)
    for v in range(n):
        old[renumbered[v]] = v
        if parent[v] >= 0:
            new_parent[renumbered[v]] = renumbered[parent[v]]
    for v in range(n):
        for a in range(first[old[v]], first[old[v] + 1]):
            below[renumbered[up[a]] + 1] += 1
        new_first[v + 1] = new_first[v] + first[old[v] + 1] - first[old[v]]
    for v in range(n):
        below[v + 1] += below[v]
    lower = np.empty(len(up), np.int32)
    at = below[:-1].copy()
    for v in range(n):
        for a in range(first[old[v]], first[old[v] + 1]):
            u = renumbered[up[a]]
            lower[at[u]] = v
            at[u] += 1
    new_up = np.empty(len(up), np.int32)
    at = new_first[:-1].copy()
    for u in range(n):
        for k in range(below[u], below[u + 1]):
            v = lower[k]
            new_up[at[v]] = u
            at[v] += 1
    return new_first, new_up, new_parent
