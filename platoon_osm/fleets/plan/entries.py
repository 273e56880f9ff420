"""The instants at which a truck may enter a lane, out of those at which it may be there.

A truck may enter as it arrives, or wait until others enter: waiting costs nothing here, so no other
instants matter, except where a bucket of shares begins, and the next that is free where the truck
must keep apart from somebody. Labels are (time, cost): of two at a node the later counts only if it
is cheaper.
"""

from __future__ import annotations

from .desk import Desk, Plan, Taste
from .entering import FAR, bucket_at, join_price, kept_apart, open_price
from .occupancy import Costs, Occupancy, first_at
from .pairs_used import Prices, Used

__all__ = ["TIE", "entries"]

NEVER = 1 << 62

TIE = 1e-7
"""Costs that differ by less are alike [grains]; grains are whole numbers."""


def entries(
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
    """Make labels behind a pair out of those before it, sorted by time.

    Parameters
    ----------
    k, p : int
        The truck, and one of its pairs.
    begin, end, made : int
        Labels before the pair, and where those behind it begin.
    rest, upper : float
        The least of the way onward, and what a whole schedule must cost less than [grains].
    used, prices, costs, lanes, plan : Used, Prices, Costs, Occupancy, Plan
        The problem, and what others do.
    taste : Taste
        How it guesses.
    work : Desk
        With the labels.

    Returns
    -------
    int
        Where the labels end.
    """
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
        bucket = bucket_at(p, now, prices)
    to_share = prices.place[p] - prices.bucket[p]
    before, parent, last = FAR, -1, FAR
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
        if cost < last - TIE and cost + rest < upper and made < len(work.time):
            work.time[made] = instant + used.drive[p]
            work.cost[made] = cost
            work.parent[made] = parent
            work.leg[made] = p
            made += 1
            last = cost
        moved = again < NEVER or instant < bonus_at or taste.crowd > 0.0
        if j >= end and not moved and price <= cheapest * blur + TIE:
            # Nobody waits for what cannot be cheaper.
            break
    return made
