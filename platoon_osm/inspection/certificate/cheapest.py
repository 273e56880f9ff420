"""The cheapest schedule of each truck under shares, exactly, in whole numbers.

Entering a lane costs min(alone, member + share of the bucket), and min(alone, member - h) without
shares. A label is a node, the span of instants at which the truck may be there at one cost, and
that cost; later, each tick of waiting costs its price. Labels come out in the order of the first
instant. In a bucket the first instants are the best ones, but where waiting has a price and the
truck may still leave its origin later for nothing: that is what the span is for.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .compiling import compiled
from .heap import drop_least, put
from .sharing import Listed
from .told import Told
from .windows import Pairs

__all__ = ["cheapest_alone", "cheapest_under"]

Ints = NDArray[np.int64]


def cheapest_under(told: Told, pairs: Pairs, listed: Listed, alone_cost: Ints) -> Ints:
    """Return what the cheapest schedule of each truck costs under the shares.

    Parameters
    ----------
    told : Told
        What the file says.
    pairs : Pairs
        Those that a best plan may need.
    listed : Listed
        Which of them have shares.
    alone_cost : ndarray of int64, (N,)
        What the ways alone cost, which no cheapest schedule exceeds [grains].

    Returns
    -------
    ndarray of int64, (N,)
        Costs [grains].
    """
    base = np.minimum(told.alone, told.member - told.leader_saves)
    return _run(told, pairs, listed.row, base, alone_cost)


def cheapest_alone(told: Told, pairs: Pairs, alone_cost: Ints) -> Ints:
    """Return what each truck's cheapest way alone in its window costs.

    Parameters
    ----------
    told : Told
        What the file says.
    pairs : Pairs
        Those that are left; dropped ones cost no less.
    alone_cost : ndarray of int64, (N,)
        What the ways told cost [grains].

    Returns
    -------
    ndarray of int64, (N,)
        Costs [grains].
    """
    return _run(told, pairs, np.full(len(pairs.lane), -1, np.int64), told.alone, alone_cost)


def _run(told: Told, pairs: Pairs, row: Ints, base: Ints, alone_cost: Ints) -> Ints:
    cost = alone_cost.copy()
    _cheapest(
        told.nodes, told.tail, told.head, told.drive, told.alone, told.member, told.origin,
        told.destination, told.earliest, told.latest_departure, told.waiting, pairs.first,
        pairs.lane, pairs.opens, pairs.closes, row, base, told.starts,
        told.first_bucket, told.first_share, told.share, cost,
    )  # fmt: skip
    return cost


@compiled
def _cheapest(
    nodes: int,
    tail: Ints,
    head: Ints,
    drive: Ints,
    alone: Ints,
    member: Ints,
    origin: Ints,
    destination: Ints,
    earliest: Ints,
    departs: Ints,
    waiting: int,
    first: Ints,
    lane: Ints,
    opens: Ints,
    closes: Ints,
    row: Ints,
    base: Ints,
    starts: Ints,
    first_bucket: Ints,
    first_share: Ints,
    share: Ints,
    cost: Ints,
) -> None:
    """Lower each truck's cost to that of its cheapest schedule."""
    far = np.int64(2**60)
    room = 1024
    keys, items = np.empty(room, np.int64), np.empty(room, np.int64)
    # Labels: node, until when the cost holds, cost, and the label of the node before it.
    at_node, until, paid = (
        np.empty(room, np.int64), np.empty(room, np.int64), np.empty(room, np.int64),
    )  # fmt: skip
    older = np.empty(room, np.int64)
    begin, end = np.zeros(nodes, np.int64), np.zeros(nodes, np.int64)
    least, latest_label = np.full(nodes, far, np.int64), np.full(nodes, -1, np.int64)
    for k in range(len(origin)):
        best = cost[k]
        goal = destination[k]
        for p in range(first[k], first[k + 1]):
            u = tail[lane[p]]
            if begin[u] == end[u]:
                begin[u] = p
            end[u] = p + 1
        labels, size = 1, put(keys, items, 0, earliest[k], 0)
        at_node[0], until[0], paid[0] = origin[k], departs[k], 0
        while size > 0:
            now, i = keys[0], items[0]
            size = drop_least(keys, items, size)
            u, so_far, free = at_node[i], paid[i], until[i]
            if so_far >= best:
                continue
            if u == goal:
                best = so_far
                continue
            if waiting == 0:
                if so_far >= least[u]:
                    continue
                least[u] = so_far
            else:
                j = latest_label[u]
                while j >= 0 and paid[j] + waiting * max(0, free - until[j]) > so_far:
                    j = older[j]
                if j >= 0:
                    continue
                older[i] = latest_label[u]
                latest_label[u] = i
            for p in range(begin[u], end[u]):
                one = lane[p]
                low, high = max(now, opens[p]), closes[p]
                if low > high:
                    continue
                v, r = head[one], row[p]
                b = last = np.int64(0)
                if r >= 0:
                    b = first_bucket[r]
                    last = b + first_share[r + 1] - first_share[r] - 1
                    # The bucket in which `low` lies.
                    top = last
                    while b < top:
                        middle = (b + top + 1) // 2
                        if starts[middle] <= low:
                            b = middle
                        else:
                            top = middle - 1
                cheapest = far
                while True:
                    enter, leave, price = low, high, base[one]
                    if r >= 0:
                        enter = max(low, starts[b])
                        if b < last:
                            leave = starts[b + 1] - 1
                        own = member[one] + share[first_share[r] + b - first_bucket[r]]
                        price = min(alone[one], own)
                    # Where waiting is free, later is worth it only if it is cheaper.
                    if waiting > 0 or price < cheapest:
                        cheapest = price
                        then = so_far + price + waiting * max(0, enter - free)
                        if then < best and (waiting > 0 or then < least[v]):
                            if labels == room or size == room:
                                keys, items = _longer(keys), _longer(items)
                                at_node, until = _longer(at_node), _longer(until)
                                paid, older = _longer(paid), _longer(older)
                                room *= 2
                            at_node[labels], paid[labels] = v, then
                            until[labels] = max(enter, min(free, leave)) + drive[one]
                            size = put(keys, items, size, enter + drive[one], labels)
                            labels += 1
                    b += 1
                    if r < 0 or b > last:
                        break
        cost[k] = best
        for p in range(first[k], first[k + 1]):
            for node in (tail[lane[p]], head[lane[p]]):
                begin[node] = end[node] = 0
                least[node] = far
                latest_label[node] = -1
        least[origin[k]] = far
        latest_label[origin[k]] = -1


@compiled
def _longer(column: Ints) -> Ints:
    """Return a column with twice the room."""
    twice = np.empty(2 * len(column), np.int64)
    twice[: len(column)] = column
    return twice
