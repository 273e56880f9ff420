"""What entering a lane is guessed to cost a truck, alone or where others do.

Entering where others do costs what their company costs more with it. Entering alone costs what
driving alone does; or, where platoons are to form, a guess of what it will: a mix of member + share
(the bound's share of its bucket) and alone. A price may be blurred, and have a bonus.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import draws, occupancy
from .desk import Desk, Plan, Taste
from .draws import uniform
from .occupancy import Costs, Occupancy, first_at, one_more, times_at
from .pairs_used import Prices, Used

__all__ = [
    "FAR", "HELPERS", "bucket_at", "flavoured", "join_price", "kept_apart", "least_prices",
    "open_price", "price_now",
]  # fmt: skip

Ints = NDArray[np.int64]

FAR = 1e300
"""What no schedule costs [grains]."""


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


def bucket_at(p: int, instant: int, prices: Prices) -> int:
    """Return the bucket in which a pair's lane is entered at an instant.

    Parameters
    ----------
    p, instant : int
        The pair, and when [ticks].
    prices : Prices
        Where buckets begin.

    Returns
    -------
    int
        Its place in `starts`; the pair's first before all of them.
    """
    low = prices.bucket[p]
    high = low + prices.buckets[p]
    while high - low > 1:
        middle = (low + high) >> 1
        if prices.starts[middle] <= instant:
            low = middle
        else:
            high = middle
    return int(low)


def _share_at(p: int, instant: int, prices: Prices) -> float:
    """Return the share of a pair at an instant."""
    bucket = bucket_at(p, instant, prices) - prices.bucket[p]
    return float(prices.share[prices.place[p] + bucket])


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
            return FAR
        z = p - used.first[k]
        there = times_at(lanes, lane, instant)
        price = used.alone[p]
        if taste.trust > 0.0:
            price = open_price(p, _share_at(p, instant, prices), work.spread[z], used, taste)
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
    kept_apart, bucket_at, _share_at, open_price, join_price, price_now, least_prices, flavoured,
)  # fmt: skip
