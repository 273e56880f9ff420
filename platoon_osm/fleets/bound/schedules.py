"""The cheapest schedule of each truck under shares, exact whatever instants it may leave at.

What a lane costs depends on the bucket it is entered in alone, so it is best to enter as soon as
the truck is there, or at the start of a later bucket if that is cheaper. At a place a truck has a
front: instants with the least cost of being there by then, later ones only where cheaper. Where
lanes close no circle, places are taken in order of the drive: the front of the tail is led over
each lane, and fronts that meet at a head are merged. Else labels are taken in order of time.

A label falls if its cost and the least that the rest may cost, each lane at its least share, reach
what the truck's schedule of before costs now: it stays the best then. What is told is lower than
that cost by a part in 10^12, which is far more than rounding makes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled, kept_with, made_known
from .leaving import leaves_at
from .prices import Prices, Routes
from .ways import Ways

__all__ = [
    "Prices",
    "Routes",
    "cheapest",
    "least_onward",
    "popped",
    "pushed",
    "told_schedules",
    "traced",
]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

FAR = 2.0**60
"""Beyond every cost in grains."""

TOLERANCE = 1e-12
"""Of costs: rounding in a sum of some hundred terms stays below a hundredth of it."""


def _over_lane(
    p: int, begin: int, end: int, at: int, ways: Ways, prices: Prices, least: float,
    onward: Floats, limit: float, time: Ints, cost: Floats, parent: Ints, entry: Ints,
) -> int:  # fmt: skip
    """Lead a front over a lane: its labels stand at begin to end, new ones from `at` on."""
    starts, share = prices.starts, prices.share
    low, high = prices.first_share[p], prices.first_share[p + 1]
    bucket = prices.first_bucket[p]
    opens, closes, drive = ways.opens[p], ways.closes[p], ways.drive[p]
    rest = onward[ways.head[p]] + prices.member[p]
    if cost[end - 1] + least + rest >= limit:
        return at
    first = 0
    if high - low > 1 and starts[bucket + 1] <= time[begin]:
        last = high - low
        while last - first > 1:
            middle = (first + last) >> 1
            if starts[bucket + middle] <= time[begin]:
                first = middle
            else:
                last = middle
    j = begin
    best = limit + limit
    source = -1
    lowest = best
    for i in range(first, high - low):
        start = max(starts[bucket + i], opens)
        until = closes if i + 1 == high - low else starts[bucket + i + 1] - 1
        price = share[low + i]
        while j < end and time[j] <= start:
            best = cost[j]
            source = j
            j += 1
        if source >= 0 and best + price < lowest:
            lowest = best + price
            if lowest + rest < limit:
                time[at] = start + drive
                cost[at] = lowest + prices.member[p]
                parent[at] = source
                entry[at] = low + i
                at += 1
        while j < end and time[j] <= until:
            best = cost[j]
            source = j
            if best + price < lowest:
                lowest = best + price
                if lowest + rest < limit:
                    time[at] = time[j] + drive
                    cost[at] = lowest + prices.member[p]
                    parent[at] = source
                    entry[at] = low + i
                    at += 1
            j += 1
        if j == end and lowest <= best + least:
            # No later bucket is cheaper.
            break
    return at


def _merged(
    a: int, a_end: int, b: int, b_end: int, time: Ints, cost: Floats, parent: Ints, entry: Ints,
    pair: Ints,
) -> int:  # fmt: skip
    """Merge two fronts into one that begins at b_end, and return its end."""
    at = b_end
    first = True
    lowest = cost[a]
    i, j = a, b
    while i < a_end or j < b_end:
        if j >= b_end or (i < a_end and time[i] <= time[j]):
            one = i
            i += 1
        else:
            one = j
            j += 1
        if first or cost[one] < lowest:
            # Of two at one instant the cheaper stays.
            if not first and time[at - 1] == time[one]:
                at -= 1
            first = False
            lowest = cost[one]
            time[at] = time[one]
            cost[at] = lowest
            parent[at] = parent[one]
            entry[at] = entry[one]
            pair[at] = pair[one]
            at += 1
    return at


def least_onward(k: int, ways: Ways, prices: Prices, least: Floats, onward: Floats) -> None:
    """Work out the least share of each pair, and what getting on from each place costs at least.

    Parameters
    ----------
    k : int
        The truck.
    ways, prices : Ways, Prices
        Its network, and what its pairs cost.
    least, onward : ndarray of float64
        Are filled: of its pairs, and of its places [grains].
    """
    begin, end = ways.first[k], ways.first[k + 1]
    for p in range(begin, end):
        lowest = prices.share[prices.first_share[p]]
        for s in range(prices.first_share[p] + 1, prices.first_share[p + 1]):
            if prices.share[s] < lowest:
                lowest = prices.share[s]
        least[p - begin] = lowest
    for u in range(ways.first_place[k + 1] - ways.first_place[k]):
        onward[u] = FAR
    onward[ways.sink[k]] = 0
    changed = True
    while changed:
        changed = False
        for i in range(end - 1, begin - 1, -1):
            p = ways.order[i]
            through = onward[ways.head[p]] + prices.member[p] + least[p - begin]
            if through < onward[ways.tail[p]]:
                onward[ways.tail[p]] = through
                changed = True
        if ways.in_order[k]:
            return


def traced(
    k: int,
    at: int,
    found: int,
    cost: Floats,
    parent: Ints,
    pair: Ints,
    entry: Ints,
    routes: Routes,
) -> None:
    """Write down the schedule that ends with a label.

    Parameters
    ----------
    k, at : int
        The truck, and where its schedule begins in `routes`.
    found : int
        The label at its destination.
    cost, parent, pair, entry : ndarray
        Of all labels: what they cost [grains], the label before, and the pair and bucket entered.
    routes : Routes
        Get pairs, buckets, number and cost.
    """
    count = 0
    one = found
    while parent[one] >= 0:
        count += 1
        one = parent[one]
    routes.length[k] = count
    routes.cost[k] = cost[found]
    one = found
    for i in range(at + count - 1, at - 1, -1):
        routes.pair[i] = pair[one]
        routes.entry[i] = entry[one]
        one = parent[one]


def pushed(heap: Ints, size: int, one: int, time: Ints) -> int:
    """Put a label on a heap in order of time.

    Parameters
    ----------
    heap : ndarray of int64
        Labels.
    size, one : int
        How many there are, and the new one.
    time : ndarray of int64
        Of all labels [ticks].

    Returns
    -------
    int
        How many there are now.
    """
    at = size
    while at > 0:
        above = (at - 1) >> 1
        if time[heap[above]] <= time[one]:
            break
        heap[at] = heap[above]
        at = above
    heap[at] = one
    return size + 1


def popped(heap: Ints, size: int, time: Ints) -> int:
    """Take the first label, heap[0], off a heap.

    Parameters
    ----------
    heap : ndarray of int64
        Labels.
    size : int
        How many there are.
    time : ndarray of int64
        Of all labels [ticks].

    Returns
    -------
    int
        How many are left.
    """
    size -= 1
    one = heap[size]
    at = 0
    while True:
        below = 2 * at + 1
        if below >= size:
            break
        if below + 1 < size and time[heap[below + 1]] < time[heap[below]]:
            below += 1
        if time[heap[below]] >= time[one]:
            break
        heap[at] = heap[below]
        at = below
    heap[at] = one
    return size


for _helper in (_over_lane, _merged, least_onward, traced, pushed, popped):
    made_known(_helper)


@compiled
def cheapest(
    begin: int, end: int, room: int, pruned: bool, ways: Ways, prices: Prices, routes: Routes
) -> int:
    """Find the cheapest schedules of some trucks.

    Parameters
    ----------
    begin, end : int
        The trucks.
    room : int
        For how many labels of a truck there is room.
    pruned : bool
        Whether labels fall by what remains and by the schedules of before.
    ways : Ways
        The networks of the trucks.
    prices : Prices
        What their pairs cost.
    routes : Routes
        The schedules of before, and then the new ones.

    Returns
    -------
    int
        -1, or the first truck whose labels found no room; those before it are done.
    """
    most = np.max(np.diff(ways.first_place)) + 1
    widest = np.max(np.diff(prices.first_share)) if len(prices.first_bucket) else 0
    onward = np.zeros(most, np.float64)
    low = np.zeros(most, np.int64)
    high = np.zeros(most, np.int64)
    reached = np.empty(most, np.float64)
    least = np.full(np.max(np.diff(ways.first)), -FAR)
    time = np.empty(room, np.int64)
    cost = np.empty(room, np.float64)
    parent = np.empty(room, np.int64)
    entry = np.empty(room, np.int64)
    pair = np.empty(room, np.int64)
    place = np.empty(room, np.int64)
    heap = np.empty(room, np.int64)
    for k in range(begin, end):
        if ways.source[k] < 0 or ways.source[k] == ways.sink[k]:
            routes.length[k] = 0
            routes.cost[k] = 0
            continue
        at = ways.first_place[k]
        limit = FAR
        if pruned and routes.length[k] >= 0:
            limit = 0.0
            for i in range(at, at + routes.length[k]):
                limit += prices.member[routes.pair[i]] + prices.share[routes.entry[i]]
            limit -= limit * TOLERANCE
        if pruned:
            least_onward(k, ways, prices, least, onward)
            if onward[ways.source[k]] >= limit:
                routes.cost[k] = limit
                continue
        time[0] = ways.earliest[k]
        cost[0] = 0
        parent[0] = -1
        top = 1
        found = -1
        if ways.in_order[k]:
            for u in range(ways.first_place[k + 1] - at):
                low[u] = high[u] = 0
            high[ways.source[k]] = 1
            for i in range(ways.first[k], ways.first[k + 1]):
                p = ways.order[i]
                u, v = ways.tail[p], ways.head[p]
                if low[u] == high[u] or v == ways.source[k] or u == ways.sink[k]:
                    continue
                own = high[v] - low[v]
                if top + 2 * (high[u] - low[u] + widest) + own > room - 1:
                    return k
                after = _over_lane(
                    p, low[u], high[u], top, ways, prices, least[p - ways.first[k]], onward, limit,
                    time, cost, parent, entry,
                )  # fmt: skip
                for x in range(top, after):
                    pair[x] = p
                if own == 0:
                    low[v], high[v], top = top, after, after
                elif after > top:
                    merged = _merged(low[v], high[v], top, after, time, cost, parent, entry, pair)
                    low[v], high[v], top = after, merged, merged
            if high[ways.sink[k]] > low[ways.sink[k]]:
                found = high[ways.sink[k]] - 1
        else:
            for u in range(ways.first_place[k + 1] - at):
                reached[u] = limit
            place[0] = ways.source[k]
            size = pushed(heap, 0, 0, time)
            while size > 0:
                one = heap[0]
                size = popped(heap, size, time)
                u = place[one]
                if cost[one] >= reached[u]:
                    continue
                reached[u] = cost[one]
                if u == ways.sink[k]:
                    found = one
                    limit = min(limit, cost[one])
                    continue
                if cost[one] + onward[u] >= limit:
                    continue
                p = ways.leaving[at + k + u]
                while p < ways.first[k + 1] and ways.tail[p] == u:
                    if top + widest + 1 > room - 1:
                        return k
                    if time[one] <= ways.closes[p]:
                        after = _over_lane(
                            p, one, one + 1, top, ways, prices, least[p - ways.first[k]], onward,
                            limit, time, cost, parent, entry,
                        )  # fmt: skip
                        for x in range(top, after):
                            if cost[x] < reached[ways.head[p]]:
                                time[top] = time[x]
                                cost[top] = cost[x]
                                parent[top] = one
                                entry[top] = entry[x]
                                pair[top] = p
                                place[top] = ways.head[p]
                                size = pushed(heap, size, top, time)
                                top += 1
                    p += 1
        if found < 0:
            routes.cost[k] = limit
            continue
        traced(k, at, found, cost, parent, pair, entry, routes)
    return -1


@compiled
def told_schedules(
    waits: bool, ways: Ways, prices: Prices, routes: Routes, lane: Ints, lanes: Ints, departs: Ints
) -> None:
    """Write down the lanes of schedules and when they are entered.

    Parameters
    ----------
    waits : bool
        Whether waiting on the road has a price, so that trucks leave late for it.
    ways, prices, routes : Ways, Prices, Routes
        As `cheapest` left them.
    lane : ndarray of int64, (K,)
        The lane of each pair.
    lanes, departs : ndarray of int64, (N, w)
        Are filled row by row.
    """
    for k in range(len(routes.length)):
        now = ways.earliest[k]
        if waits and routes.length[k] > 0:
            now = leaves_at(k, ways, prices, routes)
        for i in range(routes.length[k]):
            at = ways.first_place[k] + i
            p = routes.pair[at]
            bucket = prices.first_bucket[p] + routes.entry[at] - prices.first_share[p]
            now = max(now, ways.opens[p], prices.starts[bucket])
            lanes[k, i] = lane[p]
            departs[k, i] = now
            now += ways.drive[p]


kept_with(told_schedules, (leaves_at,))
