"""The best schedule of one truck against what all others do, where waiting has a price.

Waiting before leaving is free, so a truck that has met nobody yet may still shift all it did. A
label is a span of instants at which it may be at a place at one cost; after the span each tick
costs w, so that being there by t costs f(t) = cost + w max(0, t - until). Entering a lane alone
cuts the span at the ends of the lane's window, or of the bucket whose share is guessed to be paid,
and at instants at which somebody enters whom it must keep apart from. Entering where others do
leaves one instant.

Labels are taken from a heap in order of cost and the least that the way onward could cost, so the
first at the destination is the best. A label is needless if one that was taken at its place begins
as early and costs no more at the end of the needless one's span, and so for ever after.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import responses
from .desk import Desk, Plan, Taste
from .entering import join_price, kept_apart, least_prices, open_price
from .entries import TIE
from .heap import popped, pushed
from .occupancy import Costs, Occupancy, first_at
from .onward import UNREACHED, least_onward
from .pairs_used import Prices, Used

__all__ = ["HELPERS", "respond_waiting", "waits"]

Ints = NDArray[np.int64]


def waits(
    legs: NDArray[np.int32] | Ints, departs: Ints, count: int, used: Used
) -> int:  # fmt: skip
    """Return how long a schedule waits on the road.

    Parameters
    ----------
    legs, departs, count : ndarray of int32, ndarray of int64, int
        Its pairs, and when each is entered [ticks].
    used : Used
        The pairs.

    Returns
    -------
    int
        The time [ticks].
    """
    total = 0
    for q in range(1, count):
        total += departs[q] - departs[q - 1] - used.drive[legs[q - 1]]
    return int(total)


def _there_by(x: int, instant: int, w: int, work: Desk) -> float:
    """Return what being there by an instant costs."""
    return float(work.cost[x] + w * max(0, instant - work.until[x]))


def _needless(x: int, newest: int, w: int, work: Desk) -> bool:
    """Tell whether a label taken at the same place before makes another needless."""
    while newest >= 0:
        if (
            work.time[newest] <= work.time[x]
            and _there_by(newest, work.until[x], w, work) <= work.cost[x] + TIE
        ):
            return True
        newest = work.older[newest]
    return False


def _labelled(
    x: int, p: int, begin: int, end: int, price: float, rest: float, upper: float, made: int,
    spot: int, w: int, used: Used, work: Desk,
) -> int:  # fmt: skip
    """Make a label of entering a pair's lane between two instants; return the end of labels."""
    enters = max(begin, work.time[x])
    if enters > end or made >= len(work.time):
        return made
    cost = _there_by(x, enters, w, work) + price
    if cost + rest >= upper:
        return made
    drive = used.drive[p]
    work.time[made] = enters + drive
    work.until[made] = max(enters, min(end, work.until[x])) + drive
    work.cost[made], work.parent[made], work.leg[made], work.spot[made] = cost, x, p, spot
    if _needless(made, work.newest[spot], w, work):
        return made
    return made + 1


def _entries(
    k: int, x: int, p: int, rest: float, upper: float, made: int, spot: int, used: Used,
    prices: Prices, costs: Costs, lanes: Occupancy, plan: Plan, taste: Taste, work: Desk,
) -> int:  # fmt: skip
    """Make labels behind a pair out of one before it; return their end."""
    z, w = p - used.first[k], costs.waiting
    lane, opens, closes = used.lane[p], max(used.opens[p], work.time[x]), used.closes[p]
    row_end = lanes.first[lane] + lanes.size[lane]
    there = first_at(lanes.at, lanes.first[lane], row_end, opens)
    apart = plan.first_apart[k] < plan.first_apart[k + 1]
    guessed = taste.trust > 0.0
    bucket, buckets = prices.bucket[p], 1
    if guessed:
        buckets = prices.buckets[p]
    bonus_at = taste.instant if lane == taste.lane else -1
    for i in range(buckets):
        begin, end, price = opens, closes, used.alone[p]
        if guessed:
            price = open_price(
                p, prices.share[prices.place[p] + i], work.spread[z], used, taste
            )  # fmt: skip
            if i > 0:
                begin = max(begin, prices.starts[bucket + i])
            if i + 1 < buckets:
                end = min(end, prices.starts[bucket + i + 1] - 1)
            if end < begin:
                continue
        price *= work.blur[z]
        if apart:
            q = first_at(lanes.at, there, row_end, begin)
            while q < row_end and lanes.at[q] <= end:
                instant = lanes.at[q]
                if kept_apart(k, lane, instant, used, plan):
                    made = _labelled(
                        x, p, begin, instant - 1, price, rest, upper, made, spot, w, used, work
                    )
                    begin = instant + 1
                q += 1
        made = _labelled(x, p, begin, end, price, rest, upper, made, spot, w, used, work)
        if begin <= bonus_at <= end:
            free = not (apart and kept_apart(k, lane, bonus_at, used, plan))
            if free:
                made = _labelled(
                    x, p, bonus_at, bonus_at, price - taste.bonus, rest, upper, made, spot, w, used,
                    work,
                )  # fmt: skip
    bucket_end = bucket + buckets
    share = bucket
    while there < row_end and lanes.at[there] <= closes:
        instant, count = lanes.at[there], lanes.trucks[there]
        there += 1
        if _there_by(x, instant, w, work) + work.low[z] + rest >= upper:
            # Being there only grows dearer.
            break
        if apart and kept_apart(k, lane, instant, used, plan):
            continue
        price = used.alone[p]
        if guessed:
            while share + 1 < bucket_end and prices.starts[share + 1] <= instant:
                share += 1
            price = open_price(
                p, prices.share[prices.place[p] + share - bucket], work.spread[z], used, taste
            )  # fmt: skip
        price = join_price(p, count, price, used, costs, taste) * work.blur[z]
        if instant == bonus_at:
            price -= taste.bonus
        made = _labelled(x, p, instant, instant, price, rest, upper, made, spot, w, used, work)
    return made


def _traced(label: int, used: Used, work: Desk) -> int:
    """Write the schedule of a label, each lane as late as costs nothing; -1 if it is too long."""
    count, x = 0, label
    while work.parent[x] >= 0:
        count += 1
        x = work.parent[x]
    if count > len(work.legs):
        return -1
    x, arrives = label, work.time[label]
    for q in range(count - 1, -1, -1):
        work.legs[q] = work.leg[x]
        work.departs[q] = arrives - used.drive[work.leg[x]]
        x = work.parent[x]
        arrives = min(work.departs[q], work.until[x])
    return count


def respond_waiting(
    k: int,
    upper: float,
    used: Used,
    prices: Prices,
    costs: Costs,
    lanes: Occupancy,
    plan: Plan,
    taste: Taste,
    work: Desk,
) -> int:
    """Write the cheapest schedule of a truck against what others do; waiting has a price.

    Parameters
    ----------
    k : int
        The truck, which is taken out.
    upper : float
        Only what costs less counts [grains].
    used, prices, costs, lanes, plan : Used, Prices, Costs, Occupancy, Plan
        The problem, and what others do.
    taste : Taste
        How it guesses.
    work : Desk
        With the factors of `flavoured`; gets the answer.

    Returns
    -------
    int
        How many lanes it has; -1 if nothing costs less.
    """
    least_prices(k, used, prices, lanes, taste, work)
    first, spot0 = used.first[k], used.first_spot[k]
    rest = work.rest
    least_onward(k, used, work)
    for s in range(used.first_spot[k + 1] - spot0):
        work.newest[s] = -1
    goal, start = used.to_spot[k] - spot0, used.from_spot[k] - spot0
    if rest[start] >= upper:
        return -1
    # Windows of lanes out of the origin end with the latest departure.
    work.time[0], work.until[0], work.cost[0], work.parent[0] = used.earliest[k], 1 << 60, 0.0, -1
    work.spot[0] = start
    made = 1
    size = pushed(work.heap_cost, work.heap, 0, rest[start], 0)
    while size > 0:
        x = work.heap[0]
        size = popped(work.heap_cost, work.heap, size)
        s = work.spot[x]
        if s == goal:
            return _traced(x, used, work)
        if _needless(x, work.newest[s], costs.waiting, work):
            continue
        work.older[x] = work.newest[s]
        work.newest[s] = x
        for p in range(used.spot_first[s + spot0], used.spot_first[s + spot0 + 1]):
            v = used.head[p] - spot0
            if rest[v] >= UNREACHED or work.cost[x] + work.low[p - first] + rest[v] >= upper:
                continue
            end = _entries(
                k, x, p, rest[v], upper, made, v, used, prices, costs, lanes, plan, taste, work
            )
            for y in range(made, end):
                size = pushed(work.heap_cost, work.heap, size, work.cost[y] + rest[v], y)
            made = end
    return -1


HELPERS = (
    *responses.HELPERS,
    waits, _there_by, _needless, _labelled, _entries, _traced, respond_waiting,
)  # fmt: skip
