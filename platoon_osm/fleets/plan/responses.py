"""The best schedule of one truck against what all others do.

A truck may enter a lane as it arrives, or wait until others enter it: waiting costs nothing, so no
other instants matter, except the next that is free where it must keep apart from somebody. Entering
where others do costs what their company costs more with it. Entering alone costs what driving alone
does; or, where platoons are to form, a guess of what it will: a mix of member + share (the bound's
share of its bucket: new instants where buckets begin) and alone.

Labels are (time, cost): of two at a node the later counts only if it is cheaper. Where a truck's
pairs are one way, the labels of a node, sorted by time, are merged into those of the next; in a
network they are taken from a heap in order of time. Both leave out what cannot beat the truck's
present schedule, by a potential: the least that the way onward could cost.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import draws, occupancy
from .draws import uniform
from .occupancy import Costs, Occupancy, first_at, one_more, times_at
from .pairs_used import Prices, Used

__all__ = [
    "HELPERS", "Desk", "Plan", "Taste", "desk", "join_price", "kept_apart", "least_prices",
    "open_price", "price_now", "respond",
]  # fmt: skip

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

NEVER = 1 << 62
FAR = 1e300
TIE = 1e-7
"""Costs that differ by less are alike [grains]; grains are whole numbers."""

LABELS = 1 << 16
"""Labels of one search at most; further ones are left out."""


class Plan(NamedTuple):
    """What trucks drive: pairs of `Used`, and when.

    Attributes
    ----------
    legs : ndarray of int32, (N, w)
        Pairs of each truck in their order.
    departs : ndarray of int64, (N, w)
        When each is entered [ticks].
    lengths : ndarray of int64, (N,)
        How many; 0 for a truck that is taken out.
    first_apart, apart : ndarray of int64
        Trucks that each truck must not drive together with.
    """

    legs: NDArray[np.int32]
    departs: Ints
    lengths: Ints
    first_apart: Ints
    apart: Ints


class Taste(NamedTuple):
    """How a response guesses.

    Attributes
    ----------
    trust : float
        From 0, entering alone costs what driving alone does, to 1, member + share.
    blur : float
        Prices are multiplied by 1 - blur to 1 + blur.
    spread : float
        Shares are multiplied by 1 - spread to 1 + spread.
    crowd : float
        A company of m is joined at member + extra crowd / (m + crowd).
    lane, instant : int
        Where and when entering earns a bonus; lane -1 for nowhere.
    bonus : float
        The bonus [grains].
    """

    trust: float
    blur: float
    spread: float
    crowd: float
    lane: int
    instant: int
    bonus: float


class Desk(NamedTuple):
    """Space to work in, one for each thread.

    Attributes
    ----------
    blur, spread, low : ndarray of float64
        Of each pair of a truck: factors, and the least entering may cost.
    rest, popped : ndarray of float64
        Of each spot of a truck: the least of the way onward, and the cheapest label so far.
    time, parent, leg, spot : ndarray of int64, (LABELS,)
        Of labels.
    cost : ndarray of float64, (LABELS,)
        Of labels.
    heap_time, heap : ndarray of int64, (LABELS,)
        A heap of labels.
    until, older : ndarray of int64, (LABELS,)
        Of labels where waiting has a price, see `waiting.py`.
    newest : ndarray of int64
        The label taken last at each spot of a truck; then too.
    heap_cost : ndarray of float64, (LABELS,)
        What the heap is in order of then.
    legs, departs : ndarray of int64
        The answer.
    """

    blur: Floats
    spread: Floats
    low: Floats
    rest: Floats
    popped: Floats
    time: Ints
    parent: Ints
    leg: Ints
    spot: Ints
    cost: Floats
    heap_time: Ints
    heap: Ints
    until: Ints
    older: Ints
    newest: Ints
    heap_cost: Floats
    legs: Ints
    departs: Ints


def desk(used: Used, width: int) -> Desk:
    """Return space to work in.

    Parameters
    ----------
    used : Used
        The pairs.
    width : int
        Most lanes of a schedule.

    Returns
    -------
    Desk
        For one thread.
    """
    most = int(np.diff(used.first).max(initial=0)) + 1
    spots = int(np.diff(used.first_spot).max(initial=0)) + 1
    return Desk(
        blur=np.zeros(most), spread=np.zeros(most), low=np.zeros(most),
        rest=np.zeros(max(spots, most + 1)), popped=np.zeros(spots),
        time=np.zeros(LABELS, np.int64), parent=np.zeros(LABELS, np.int64),
        leg=np.zeros(LABELS, np.int64), spot=np.zeros(LABELS, np.int64), cost=np.zeros(LABELS),
        heap_time=np.zeros(LABELS, np.int64), heap=np.zeros(LABELS, np.int64),
        until=np.zeros(LABELS, np.int64), older=np.zeros(LABELS, np.int64),
        newest=np.zeros(spots, np.int64), heap_cost=np.zeros(LABELS),
        legs=np.zeros(width, np.int64), departs=np.zeros(width, np.int64),
    )  # fmt: skip


def kept_apart(k: int, lane: int, instant: int, used: Used, plan: Plan) -> bool:
    """Tell whether somebody enters a lane at an instant whom a truck must keep apart from.

    Parameters
    ----------
    k, lane, instant : int
        The truck, and where and when it would enter.
    used : Used
        The pairs.
    plan : Plan
        What others do.

    Returns
    -------
    bool
        Whether it must not.
    """
    for i in range(plan.first_apart[k], plan.first_apart[k + 1]):
        other = plan.apart[i]
        for q in range(plan.lengths[other]):
            if used.lane[plan.legs[other, q]] == lane and plan.departs[other, q] == instant:
                return True
    return False


def _share_now(p: int, instant: int, prices: Prices) -> float:
    """Return the share of a pair at an instant."""
    low = prices.bucket[p]
    high = low + prices.buckets[p]
    begin = low
    while high - low > 1:
        middle = (low + high) >> 1
        if prices.starts[middle] <= instant:
            low = middle
        else:
            high = middle
    return float(prices.share[prices.place[p] + low - begin])


def open_price(p: int, share: float, spread: float, used: Used, taste: Taste) -> float:
    """Return what entering where nobody does is guessed to cost.

    Parameters
    ----------
    p : int
        The pair.
    share, spread : float
        The bound's share [grains], and its factor.
    used, taste : Used, Taste
        The pairs, and how it guesses.

    Returns
    -------
    float
        A guess [grains].
    """
    alone, member = used.alone[p], used.member[p]
    guess = member + max(share * spread, -used.save[p])
    if guess < alone:
        return float(taste.trust * guess + (1.0 - taste.trust) * alone)
    return float(alone)


def join_price(
    p: int, count: int, open_price: float, used: Used, costs: Costs, taste: Taste
) -> float:
    """Return what entering where some trucks do is guessed to cost.

    Parameters
    ----------
    p, count : int
        The pair, and how many enter.
    open_price : float
        What entering where nobody does is guessed to cost [grains].
    used, costs, taste : Used, Costs, Taste
        The pairs, what lanes cost, and how it guesses.

    Returns
    -------
    float
        A guess [grains].
    """
    lane = used.lane[p]
    price = float(
        one_more(count, costs.alone[lane], costs.member[lane], costs.extra[lane], costs.largest)
    )
    if costs.largest > 0 and count % costs.largest == 0:
        return min(price, open_price)
    if taste.crowd > 0.0:
        last = count if costs.largest == 0 else count % costs.largest
        price += costs.extra[lane] * taste.crowd / (last + taste.crowd)
    return price


def price_now(
    k: int,
    legs: NDArray[np.int32],
    departs: Ints,
    count: int,
    used: Used,
    prices: Prices,
    costs: Costs,
    lanes: Occupancy,
    plan: Plan,
    taste: Taste,
    work: Desk,
) -> float:
    """Return what a truck's schedule is guessed to cost against what others do.

    Parameters
    ----------
    k : int
        The truck, which is taken out.
    legs, departs, count : ndarray of int32, ndarray of int64, int
        Its schedule.
    used, prices, costs, lanes, plan : Used, Prices, Costs, Occupancy, Plan
        The problem, and what others do.
    taste : Taste
        How it guesses.
    work : Desk
        With its factors.

    Returns
    -------
    float
        Very much if it must not drive it [grains].
    """
    total = 0.0
    apart = plan.first_apart[k] < plan.first_apart[k + 1]
    for q in range(count):
        p, instant = legs[q], departs[q]
        if q > 0:
            waited = instant - departs[q - 1] - used.drive[legs[q - 1]]
            total += costs.waiting * waited
        lane = used.lane[p]
        if apart and kept_apart(k, lane, instant, used, plan):
            return 1e300
        z = p - used.first[k]
        there = times_at(lanes, lane, instant)
        price = used.alone[p]
        if taste.trust > 0.0:
            price = open_price(p, _share_now(p, instant, prices), work.spread[z], used, taste)
        if there > 0:
            price = join_price(p, there, price, used, costs, taste)
        price *= work.blur[z]
        if lane == taste.lane and instant == taste.instant:
            price -= taste.bonus
        total += price
    return total


def least_prices(
    k: int, used: Used, prices: Prices, lanes: Occupancy, taste: Taste, work: Desk
) -> None:
    """Fill the least that entering each pair of a truck may cost.

    Parameters
    ----------
    k : int
        The truck.
    used, prices, lanes, taste : Used, Prices, Occupancy, Taste
        The problem, and what others do.
    work : Desk
        Its `low` is filled.
    """
    begin = used.first[k]
    for p in range(begin, used.first[k + 1]):
        z = p - begin
        lane, closes = used.lane[p], used.closes[p]
        row = lanes.first[lane]
        end = row + lanes.size[lane]
        i = first_at(lanes.at, row, end, used.opens[p])
        if i < end and lanes.at[i] <= closes:
            low = used.member[p] - used.save[p]
        elif taste.trust > 0.0:
            low = open_price(p, prices.least[p], work.spread[z], used, taste)
        else:
            low = used.alone[p]
        low *= work.blur[z]
        if lane == taste.lane and used.opens[p] <= taste.instant <= closes:
            low -= taste.bonus
        work.low[z] = low


def _entries(
    k: int,
    p: int,
    begin: int,
    end: int,
    made: int,
    rest: float,
    upper: float,
    used: Used,
    prices: Prices,
    costs: Costs,
    lanes: Occupancy,
    plan: Plan,
    taste: Taste,
    work: Desk,
) -> int:
    """Make labels behind a pair out of those before it, sorted by time; return their end."""
    z = p - used.first[k]
    lane, closes = used.lane[p], used.closes[p]
    row_end = lanes.first[lane] + lanes.size[lane]
    now = max(work.time[begin], used.opens[p])
    if now > closes:
        return made
    q = first_at(lanes.at, lanes.first[lane], row_end, now)
    blur, spread = work.blur[z], work.spread[z]
    cheapest = used.member[p] - used.save[p]
    bonus_at = taste.instant if lane == taste.lane else -1
    apart = plan.first_apart[k] < plan.first_apart[k + 1]
    guessed = taste.trust > 0.0
    bucket, bucket_end, share = 0, 0, 0.0
    if guessed:
        bucket, bucket_end = prices.bucket[p], prices.bucket[p] + prices.buckets[p]
        low, high = bucket, bucket_end
        while high - low > 1:
            middle = (low + high) >> 1
            if prices.starts[middle] <= now:
                low = middle
            else:
                high = middle
        bucket = low
    to_share = prices.place[p] - prices.bucket[p]
    before, parent, last = 1e300, -1, 1e300
    j, again, moved = begin, NEVER, False
    while True:
        arrives = max(work.time[j], now) if j < end else NEVER
        occupied = lanes.at[q] if q < row_end else NEVER
        starts = NEVER
        if guessed and bucket < bucket_end:
            starts = max(prices.starts[bucket], now)
        instant = min(min(arrives, occupied), min(starts, again))
        if instant > closes:
            break
        new = instant == again
        if new:
            again = NEVER
        if starts == instant:
            share = prices.share[to_share + bucket]
            bucket += 1
            new = True
        if arrives == instant:
            before, parent = work.cost[j], j
            j += 1
            new = True
        there = 0
        if occupied == instant:
            there = lanes.trucks[q]
            q += 1
        if parent < 0:
            continue
        if apart and kept_apart(k, lane, instant, used, plan):
            again = instant + 1
            continue
        price = used.alone[p]
        if guessed:
            price = open_price(p, share, spread, used, taste)
        if there > 0:
            price = join_price(p, there, price, used, costs, taste)
        elif not new:
            continue
        price *= blur
        if instant == bonus_at:
            price -= taste.bonus
        cost = before + price
        if cost < last - 1e-7 and cost + rest < upper and made < len(work.time):
            work.time[made] = instant + used.drive[p]
            work.cost[made] = cost
            work.parent[made] = parent
            work.leg[made] = p
            made += 1
            last = cost
        moved = again < NEVER or instant < bonus_at or taste.crowd > 0.0
        if j >= end and not moved and price <= cheapest * blur + 1e-7:
            # Nobody waits for what cannot be cheaper.
            break
    return made


def _traced(label: int, used: Used, work: Desk) -> int:
    """Write the schedule of a label; return how many lanes it has, -1 if too many."""
    count, x = 0, label
    while work.parent[x] >= 0:
        count += 1
        x = work.parent[x]
    if count > len(work.legs):
        return -1
    x = label
    for q in range(count - 1, -1, -1):
        work.legs[q] = work.leg[x]
        work.departs[q] = work.time[x] - used.drive[work.leg[x]]
        x = work.parent[x]
    return count


def _along(
    k: int, upper: float, used: Used, prices: Prices, costs: Costs, lanes: Occupancy, plan: Plan,
    taste: Taste, work: Desk,
) -> int:  # fmt: skip
    """Return the response of a truck whose pairs are one way."""
    first, count = used.first[k], used.first[k + 1] - used.first[k]
    rest = work.rest
    # Pairs lie in reverse order in `onward`: rest[i] is the least behind the i-th of them.
    rest[0] = 0.0
    for i in range(count):
        rest[i + 1] = rest[i] + work.low[used.onward[first + i] - first]
    if rest[count] >= upper:
        return -1
    work.time[0], work.cost[0], work.parent[0] = used.earliest[k], 0.0, -1
    begin, end = 0, 1
    for i in range(count - 1, -1, -1):
        made = _entries(
            k, used.onward[first + i], begin, end, end, rest[i], upper, used, prices, costs,
            lanes, plan, taste, work,
        )  # fmt: skip
        if made == end:
            return -1
        begin, end = end, made
    return _traced(end - 1, used, work)


def _pushed(work: Desk, size: int, instant: int, label: int) -> int:
    """Put a label on the heap; return how many there are."""
    i = size
    while i > 0:
        up = (i - 1) >> 1
        if work.heap_time[up] <= instant:
            break
        work.heap_time[i], work.heap[i] = work.heap_time[up], work.heap[up]
        i = up
    work.heap_time[i], work.heap[i] = instant, label
    return size + 1


def _popped(work: Desk, size: int) -> int:
    """Take the first label off the heap; return how many are left."""
    size -= 1
    instant, label = work.heap_time[size], work.heap[size]
    i = 0
    while True:
        low = 2 * i + 1
        if low >= size:
            break
        if low + 1 < size and work.heap_time[low + 1] < work.heap_time[low]:
            low += 1
        if work.heap_time[low] >= instant:
            break
        work.heap_time[i], work.heap[i] = work.heap_time[low], work.heap[low]
        i = low
    work.heap_time[i], work.heap[i] = instant, label
    return size


def _across(
    k: int, upper: float, used: Used, prices: Prices, costs: Costs, lanes: Occupancy, plan: Plan,
    taste: Taste, work: Desk,
) -> int:  # fmt: skip
    """Return the response of a truck with a choice of ways."""
    first, spot0 = used.first[k], used.first_spot[k]
    rest, popped = work.rest, work.popped
    for s in range(used.first_spot[k + 1] - spot0):
        rest[s] = popped[s] = 1e300
    goal, start = used.to_spot[k] - spot0, used.from_spot[k] - spot0
    rest[goal] = 0.0
    changed = True
    while changed:
        changed = False
        for i in range(first, used.first[k + 1]):
            p = used.onward[i]
            through = rest[used.head[p] - spot0] + work.low[p - first]
            if through < rest[used.tail_spot[p] - spot0] - 1e-9:
                rest[used.tail_spot[p] - spot0] = through
                changed = True
    if rest[start] >= upper:
        return -1
    work.time[0], work.cost[0], work.parent[0] = used.earliest[k], 0.0, -1
    work.spot[0] = start
    made, best = 1, -1
    size = _pushed(work, 0, work.time[0], 0)
    while size > 0:
        x = work.heap[0]
        size = _popped(work, size)
        s, cost = work.spot[x], work.cost[x]
        if cost >= popped[s] - 1e-7:
            continue
        popped[s] = cost
        if s == goal:
            if cost < upper:
                upper, best = cost, x
            continue
        if cost + rest[s] >= upper:
            continue
        for p in range(used.spot_first[s + spot0], used.spot_first[s + spot0 + 1]):
            v = used.head[p] - spot0
            if cost + work.low[p - first] + rest[v] >= upper or rest[v] >= 1e299:
                continue
            end = _entries(
                k, p, x, x + 1, made, rest[v], min(upper, popped[v] + rest[v]), used, prices,
                costs, lanes, plan, taste, work,
            )  # fmt: skip
            for y in range(made, end):
                work.spot[y] = v
                size = _pushed(work, size, work.time[y], y)
            made = end
    return _traced(best, used, work) if best >= 0 else -1


def respond(
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
    """Write the cheapest schedule of a truck against what others do.

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
    if used.chain[k]:
        return _along(k, upper, used, prices, costs, lanes, plan, taste, work)
    return _across(k, upper, used, prices, costs, lanes, plan, taste, work)


def flavoured(k: int, used: Used, taste: Taste, work: Desk, state: Ints) -> None:
    """Draw the factors of a truck's pairs.

    Parameters
    ----------
    k : int
        The truck.
    used : Used
        The pairs.
    taste : Taste
        How far the factors are from 1.
    work : Desk
        Gets them.
    state : ndarray of int64
        Of the random numbers.
    """
    for z in range(used.first[k + 1] - used.first[k]):
        work.blur[z] = 1.0
        work.spread[z] = 1.0
        if taste.blur > 0.0:
            work.blur[z] = 1.0 + taste.blur * (2.0 * uniform(state) - 1.0)
        if taste.spread > 0.0:
            work.spread[z] = 1.0 + taste.spread * (2.0 * uniform(state) - 1.0)


HELPERS = (
    *draws.HELPERS,
    *occupancy.HELPERS,
    kept_apart, _share_now, open_price, join_price, price_now, least_prices, _entries,
    _traced, _along, _pushed, _popped, _across, respond, flavoured,
)  # fmt: skip
