"""Contract chains: nodes that a road only passes through become points of an edge's shape."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Chains", "contract_chains"]

Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Chains:
    """Segments grouped into chains.

    Attributes
    ----------
    segments : ndarray of int64, (s,)
        Segment ids, chain after chain, in driving order.
    first : ndarray of int64, (c + 1,)
        Where each chain begins in `segments`.
    """

    segments: Index
    first: Index


def contract_chains(tail: Index, head: Index, node_count: int, keep: NDArray[np.bool_]) -> Chains:
    """Group directed segments into the longest chains that pass no node worth keeping.

    A node is passed through when it is not in `keep` and has either one segment in and one out,
    to different neighbours (a one-way road), or two neighbours with one segment to and from
    each (a two-way road). A ring without any other node keeps its lowest one.

    Parameters
    ----------
    tail, head : ndarray of int64, (s,)
        Node positions of directed segments.
    node_count : int
        Number of nodes.
    keep : ndarray of bool, (node_count,)
        Nodes that must stay.

    Returns
    -------
    Chains
        Every segment is in exactly one chain; chains are ordered by their first segment's id.
    """
    s = len(tail)
    following = _following_segment(tail, head, node_count, keep)
    leads = np.full(s, -1, np.int64)  # the segment before, or -1 at the start of a chain
    linked = np.flatnonzero(following >= 0)
    leads[following[linked]] = linked
    start, position = _rank(leads)
    ring = start < 0
    if ring.any():
        # Rings have no start: cut each at the segment that leaves its lowest node.
        leads[_ring_starts(following, tail, ring)] = -1
        start, position = _rank(leads)
    order = np.lexsort((position, start))
    sorted_start = start[order]
    is_first = np.ones(s, bool)
    is_first[1:] = sorted_start[1:] != sorted_start[:-1]
    return Chains(order, np.append(np.flatnonzero(is_first), s).astype(np.int64))


def _following_segment(tail: Index, head: Index, node_count: int, keep: NDArray[np.bool_]) -> Index:
    """Return for each segment the one that continues it through a passed node, or -1."""
    out_degree = np.bincount(tail, minlength=node_count)
    in_degree = np.bincount(head, minlength=node_count)
    # Sums over the segments of a node tell its two neighbours apart without listing them.
    out_sum = np.bincount(tail, head, node_count).astype(np.int64)
    in_sum = np.bincount(head, tail, node_count).astype(np.int64)
    out_least = _least(tail, head, node_count)
    in_least = _least(head, tail, node_count)
    one_way = (out_degree == 1) & (in_degree == 1) & (out_sum != in_sum)
    two_way = (
        (out_degree == 2) & (in_degree == 2) & (out_sum == in_sum)
        & (out_least == in_least) & (2 * out_least != out_sum)
    )  # fmt: skip
    itself = np.zeros(node_count, bool)
    itself[tail[tail == head]] = True
    passed = (one_way | two_way) & ~keep & ~itself
    # The segment from v towards w, for the at most two segments that leave a passed node.
    by_tail = np.argsort(tail, kind="stable")
    first_out = np.zeros(node_count + 1, np.int64)
    np.cumsum(out_degree, out=first_out[1:])
    following = np.full(len(tail), -1, np.int64)
    into = np.flatnonzero(passed[head])
    v = head[into]
    candidate = by_tail[first_out[v]]
    back = two_way[v] & (head[candidate] == tail[into])
    second = by_tail[np.minimum(first_out[v] + 1, len(tail) - 1)]
    following[into] = np.where(back, second, candidate)
    return following


def _least(key: Index, value: Index, size: int) -> Index:
    least = np.full(size, np.iinfo(np.int64).max // 4, np.int64)
    np.minimum.at(least, key, value)
    return least


def _rank(leads: Index) -> tuple[Index, Index]:
    """Find each segment's chain start and its position there, by doubling steps; -1 on rings."""
    s = len(leads)
    jump = np.where(leads < 0, np.arange(s), leads)
    position = (leads >= 0).astype(np.int64)
    for _ in range(max(1, int(s).bit_length())):
        onward = jump[jump]
        if np.array_equal(onward, jump):
            break
        position += position[jump]
        jump = onward
    at_start = leads[jump] < 0 if s else np.zeros(0, bool)
    return np.where(at_start, jump, -1), position


def _ring_starts(following: Index, tail: Index, ring: NDArray[np.bool_]) -> Index:
    """Return for each ring the segment that leaves its lowest node."""
    on_ring = np.flatnonzero(ring)
    lowest = np.full(len(following), np.iinfo(np.int64).max, np.int64)
    lowest[on_ring] = tail[on_ring]
    jump = np.where(ring, following, np.arange(len(following)))
    for _ in range(len(on_ring).bit_length()):
        lowest = np.minimum(lowest, lowest[jump])
        jump = jump[jump]
    starts: Index = on_ring[tail[on_ring] == lowest[on_ring]]
    # A two-way ring passes its lowest node once in each direction, on two separate rings.
    return starts
