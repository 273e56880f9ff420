"""The cheapest schedule of each truck under shares, where waiting on the road has a price.

A label is a span of instants at which a truck may be at a place at one cost: it may still leave
its origin later, for nothing. After the span each tick costs the price w, so that being there by t
costs

    f(t) = cost + w max(0, t - until),    t >= time.

A truck that enters a lane in a bucket has left behind what its bucket does not hold: its span is
cut at the bucket's ends. A label is needless if another one that is there as early has f as low for
all t, that is if cost + w max(0, until of the needless one - until) is no more than its cost. Those
that nothing has beaten by t, sorted by `until`, have rising costs, and each is the best for a while
in turn: a profile. Places are taken in order of the drive, or labels in order of time where lanes
close circles, as without the price.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled, kept_with, made_known
from .leaving import waited
from .prices import Prices, Routes
from .schedules import FAR, TOLERANCE, least_onward, popped, pushed, traced
from .ways import Ways

__all__ = ["cheapest_waiting"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


def _by(x: int, t: int, w: int, until: Ints, cost: Floats) -> float:
    """Return what it costs to be there by an instant with a label."""
    return float(cost[x] + w * max(0, t - until[x]))


def _begun(
    profile: Ints, begin: int, end: int, t: int, w: int, until: Ints, cost: Floats
) -> int:  # fmt: skip
    """Return where a profile begins from an instant on: its first label is the best then."""
    while begin + 1 < end and _by(profile[begin + 1], t, w, until, cost) <= _by(
        profile[begin], t, w, until, cost
    ):
        begin += 1
    return begin


def _received(
    profile: Ints, begin: int, end: int, x: int, t: int, w: int, until: Ints, cost: Floats
) -> int:  # fmt: skip
    """Put a label that begins at t into a profile that begins then; return its end, -1 if needless.

    Labels that it makes needless leave the profile, but for the room before `begin`.
    """
    at = end
    while at > begin and until[profile[at - 1]] >= until[x]:
        at -= 1
    if at < end and cost[profile[at]] <= cost[x]:
        return -1
    if at > begin and _by(profile[at - 1], until[x], w, until, cost) <= cost[x]:
        return -1
    high = at
    while high < end and _by(x, until[profile[high]], w, until, cost) <= cost[profile[high]]:
        high += 1
    low = at
    while low > begin and cost[x] <= _by(profile[low - 1], t, w, until, cost):
        low -= 1
    gone = high - low
    if gone == 0:
        for i in range(end, at, -1):
            profile[i] = profile[i - 1]
        profile[at] = x
        return end + 1
    profile[low] = x
    for i in range(high, end):
        profile[i - gone + 1] = profile[i]
    return end - gone + 1


def _over_lane(
    p: int, begin: int, end: int, at: int, w: int, ways: Ways, prices: Prices, least: float,
    onward: Floats, limit: float, time: Ints, until: Ints, cost: Floats, parent: Ints, entry: Ints,
    profile: Ints, made: Ints,
) -> int:  # fmt: skip
    """Lead labels in order of time, which stand at begin to end, over a lane; new ones from `at`.

    Returns the end of the new ones, -1 if there was no room.
    """
    starts, share = prices.starts, prices.share
    low, high = prices.first_share[p], prices.first_share[p + 1]
    bucket = prices.first_bucket[p]
    opens, closes, drive = ways.opens[p], ways.closes[p], ways.drive[p]
    member, rest = prices.member[p], onward[ways.head[p]]
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
    a, b = 0, 0
    c, d = 0, 0
    for i in range(first, high - low):
        start = max(starts[bucket + i], opens)
        close = closes if i + 1 == high - low else starts[bucket + i + 1] - 1
        price = member + share[low + i]
        while j < end and time[j] <= start:
            a = _begun(profile, a, b, time[j], w, until, cost)
            after = _received(profile, a, b, j, time[j], w, until, cost)
            b = b if after < 0 else after
            j += 1
        a = _begun(profile, a, b, start, w, until, cost)
        if j == end and _by(profile[a], start, w, until, cost) + member + least + rest >= limit:
            # Being there only grows dearer, and no later bucket is worth it.
            break
        q = a
        spent = q == b
        while not spent or (j < end and time[j] <= close):
            if not spent:
                x, now = profile[q], start
                spent = until[x] >= close or q + 1 == b
                q += 1
            else:
                x, now = j, time[j]
                a = _begun(profile, a, b, now, w, until, cost)
                after = _received(profile, a, b, j, now, w, until, cost)
                j += 1
                if after < 0:
                    continue
                b = after
            paid = _by(x, now, w, until, cost) + price
            if paid + rest >= limit:
                continue
            if at >= len(time):
                return -1
            time[at] = now + drive
            until[at] = max(now, min(until[x], close)) + drive
            cost[at] = paid
            c = _begun(made, c, d, time[at], w, until, cost)
            after = _received(made, c, d, at, time[at], w, until, cost)
            if after >= 0:
                d = after
                parent[at] = x
                entry[at] = low + i
                at += 1
    return at


def _merged(
    a: int, a_end: int, b: int, b_end: int, w: int, time: Ints, until: Ints, cost: Floats,
    parent: Ints, entry: Ints, pair: Ints, profile: Ints,
) -> int:  # fmt: skip
    """Merge labels of two lanes from b_end on; return their end, -1 if there is no room."""
    at = b_end
    if at + a_end - a + b_end - b > len(time):
        return -1
    begin, end = 0, 0
    while a < a_end or b < b_end:
        if b >= b_end or (a < a_end and time[a] <= time[b]):
            one = a
            a += 1
        else:
            one = b
            b += 1
        begin = _begun(profile, begin, end, time[one], w, until, cost)
        after = _received(profile, begin, end, one, time[one], w, until, cost)
        if after < 0:
            continue
        end = after
        time[at], until[at], cost[at] = time[one], until[one], cost[one]
        parent[at], entry[at], pair[at] = parent[one], entry[one], pair[one]
        at += 1
    return at


def _needless(
    x: int, newest: int, w: int, until: Ints, cost: Floats, older: Ints
) -> bool:  # fmt: skip
    """Tell whether one of the labels taken at a place before makes another needless."""
    while newest >= 0:
        if _by(newest, until[x], w, until, cost) <= cost[x]:
            return True
        newest = older[newest]
    return False


for _helper in (_by, _begun, _received, _over_lane, _merged, _needless):
    made_known(_helper)


@compiled
def cheapest_waiting(
    begin: int, end: int, room: int, pruned: bool, w: int, ways: Ways, prices: Prices,
    routes: Routes,
) -> int:  # fmt: skip
    """Find the cheapest schedules of some trucks.

    Parameters
    ----------
    begin, end : int
        The trucks.
    room : int
        For how many labels of a truck there is room.
    pruned : bool
        Whether labels fall by what remains and by the schedules of before.
    w : int
        Price of waiting on the road [grains a tick].
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
    onward = np.zeros(most, np.float64)
    low, high = np.zeros(most, np.int64), np.zeros(most, np.int64)
    least = np.full(np.max(np.diff(ways.first)), -FAR)
    time, until = np.empty(room, np.int64), np.empty(room, np.int64)
    cost = np.empty(room, np.float64)
    parent, entry, pair = (
        np.empty(room, np.int64),
        np.empty(room, np.int64),
        np.empty(room, np.int64),
    )
    place, heap, older = (
        np.empty(room, np.int64), np.empty(room, np.int64), np.empty(room, np.int64),
    )  # fmt: skip
    profile, made = np.empty(room + 1, np.int64), np.empty(room + 1, np.int64)
    for k in range(begin, end):
        if ways.source[k] < 0 or ways.source[k] == ways.sink[k]:
            routes.length[k] = 0
            routes.cost[k] = 0
            continue
        at = ways.first_place[k]
        limit = FAR
        if pruned and routes.length[k] >= 0:
            limit = float(w * waited(k, ways, prices, routes))
            for i in range(at, at + routes.length[k]):
                limit += prices.member[routes.pair[i]] + prices.share[routes.entry[i]]
            limit -= limit * TOLERANCE
        if pruned:
            least_onward(k, ways, prices, least, onward)
            if onward[ways.source[k]] >= limit:
                routes.cost[k] = limit
                continue
        # Windows of lanes out of the origin end with the latest departure.
        time[0], until[0], cost[0], parent[0] = ways.earliest[k], np.int64(1) << 60, 0.0, -1
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
                after = _over_lane(
                    p, low[u], high[u], top, w, ways, prices, least[p - ways.first[k]], onward,
                    limit, time, until, cost, parent, entry, profile, made,
                )  # fmt: skip
                if after < 0:
                    return k
                for x in range(top, after):
                    pair[x] = p
                if low[v] == high[v]:
                    low[v], high[v], top = top, after, after
                elif after > top:
                    merged = _merged(
                        low[v], high[v], top, after, w, time, until, cost, parent, entry, pair,
                        profile,
                    )  # fmt: skip
                    if merged < 0:
                        return k
                    low[v], high[v], top = after, merged, merged
            for x in range(low[ways.sink[k]], high[ways.sink[k]]):
                if found < 0 or cost[x] < cost[found]:
                    found = x
        else:
            # `low` tells the label taken last at each place, `older` the one before each.
            for u in range(ways.first_place[k + 1] - at):
                low[u] = -1
            place[0] = ways.source[k]
            size = pushed(heap, 0, 0, time)
            while size > 0:
                one = heap[0]
                size = popped(heap, size, time)
                u = place[one]
                if cost[one] + onward[u] >= limit or _needless(one, low[u], w, until, cost, older):
                    continue
                older[one] = low[u]
                low[u] = one
                if u == ways.sink[k]:
                    found = one
                    limit = cost[one]
                    continue
                p = ways.leaving[at + k + u]
                while p < ways.first[k + 1] and ways.tail[p] == u:
                    if time[one] <= ways.closes[p]:
                        after = _over_lane(
                            p, one, one + 1, top, w, ways, prices, least[p - ways.first[k]],
                            onward, limit, time, until, cost, parent, entry, profile, made,
                        )  # fmt: skip
                        if after < 0:
                            return k
                        v = ways.head[p]
                        for x in range(top, after):
                            if _needless(x, low[v], w, until, cost, older):
                                continue
                            time[top], until[top], cost[top] = time[x], until[x], cost[x]
                            parent[top], entry[top], pair[top], place[top] = one, entry[x], p, v
                            size = pushed(heap, size, top, time)
                            top += 1
                    p += 1
        if found < 0:
            routes.cost[k] = limit
            continue
        traced(k, at, found, cost, parent, pair, entry, routes)
    return -1


kept_with(cheapest_waiting, (waited, least_onward, popped, pushed, traced))
