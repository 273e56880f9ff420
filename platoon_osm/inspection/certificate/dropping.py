"""Pairs that no best plan needs, dropped round by round.

A pair costs at least max(0, member - h) where the window of another pair of its lane overlaps its
own, h being what a leader saves, and else alone. If a truck's cheapest way through a pair costs no
less than its way alone, it may as well drive alone: whoever it leaves loses no more than was
counted.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .compiling import compiled
from .heap import drop_least, put
from .told import Told
from .windows import Pairs

__all__ = ["needed_pairs", "overlapping"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]


def needed_pairs(told: Told, pairs: Pairs, alone_cost: Ints) -> Pairs:
    """Return the pairs that are left after all rounds.

    Parameters
    ----------
    told : Told
        What the file says.
    pairs : Pairs
        All that are in time.
    alone_cost : ndarray of int64, (N,)
        What the ways alone cost [grains].

    Returns
    -------
    Pairs
        Those that are left.
    """
    least = np.maximum(0, told.member - told.leader_saves)
    for _ in range(told.rounds):
        meets = overlapping(pairs)
        price = np.where(meets, least[pairs.lane], told.alone[pairs.lane])
        keep = pairs.on_alone.copy()
        _mark_cheaper(
            told.nodes, told.tail, told.head, told.origin, told.destination, pairs.first,
            pairs.lane, price, alone_cost, keep,
        )  # fmt: skip
        if keep.all():
            break
        pairs = pairs.only(keep)
    return pairs


def overlapping(pairs: Pairs) -> Marks:
    """Mark pairs whose window overlaps another one's of the same lane.

    Parameters
    ----------
    pairs : Pairs
        The pairs.

    Returns
    -------
    ndarray of bool, (P,)
        True where another truck could come at the same instant.
    """
    order = np.lexsort((pairs.opens, pairs.lane))
    meets = np.zeros(len(order), np.bool_)
    _mark_overlaps(pairs.lane[order], pairs.opens[order], pairs.closes[order], meets)
    found = np.zeros(len(order), np.bool_)
    found[order] = meets
    return found


@compiled
def _mark_overlaps(lane: Ints, opens: Ints, closes: Ints, meets: Marks) -> None:
    """Mark windows that overlap the latest end before them, or the next opening after them."""
    until = np.int64(0)
    for i in range(len(lane)):
        again = i > 0 and lane[i] == lane[i - 1]
        if again and opens[i] <= until:
            meets[i] = True
        until = max(until, closes[i]) if again else closes[i]
        if i + 1 < len(lane) and lane[i + 1] == lane[i] and opens[i + 1] <= closes[i]:
            meets[i] = True


@compiled
def _mark_cheaper(
    nodes: int,
    tail: Ints,
    head: Ints,
    origin: Ints,
    destination: Ints,
    first: Ints,
    lane: Ints,
    price: Ints,
    alone_cost: Ints,
    keep: Marks,
) -> None:
    """Mark pairs through which some way costs less than the way alone."""
    far = np.int64(2**60)
    there = np.full(nodes, far, np.int64)
    onward = np.full(nodes, far, np.int64)
    most = 1
    for k in range(len(origin)):
        most = max(most, first[k + 1] - first[k])
    keys = np.empty(most + 2, np.int64)
    items = np.empty(most + 2, np.int64)
    after = np.empty(most, np.int64)
    out = np.full(nodes, -1, np.int64)
    for k in range(len(origin)):
        low, high = first[k], first[k + 1]
        limit = alone_cost[k]
        for side in range(2):
            # Chains of the pairs that leave a node, or end there.
            cost = there if side == 0 else onward
            for p in range(low, high):
                node = tail[lane[p]] if side == 0 else head[lane[p]]
                after[p - low] = out[node]
                out[node] = p
            start = origin[k] if side == 0 else destination[k]
            cost[start] = 0
            size = put(keys, items, 0, 0, start)
            while size > 0:
                now, node = keys[0], items[0]
                size = drop_least(keys, items, size)
                if now > cost[node]:
                    continue
                p = out[node]
                while p >= 0:
                    other = head[lane[p]] if side == 0 else tail[lane[p]]
                    then = now + price[p]
                    # What costs as much as the way alone is of no use.
                    if then < limit and then < cost[other]:
                        cost[other] = then
                        size = put(keys, items, size, then, other)
                    p = after[p - low]
            for p in range(low, high):
                out[tail[lane[p]]] = -1
                out[head[lane[p]]] = -1
        for p in range(low, high):
            if there[tail[lane[p]]] + price[p] + onward[head[lane[p]]] < limit:
                keep[p] = True
        there[origin[k]] = onward[destination[k]] = far
        for p in range(low, high):
            there[tail[lane[p]]] = there[head[lane[p]]] = far
            onward[tail[lane[p]]] = onward[head[lane[p]]] = far
