"""Large neighbourhoods: which trucks are taken out and put back together.

The first is drawn, seven times in ten, by its part of the gap: what it pays, with the price of each
of its platoons shared by the members, less what its cheapest schedule costs by the bound's shares.
The others overlap one that is drawn already: their windows do, for a lane that it drives or might.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import moves
from .desk import Plan
from .draws import below, uniform
from .moves import Crew
from .occupancy import Costs, Occupancy, first_at, times_at
from .pairs_used import Prices, Used
from .waiting import waits

__all__ = ["HELPERS", "drawn_seed", "gathered", "parts_of_gap"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]


def parts_of_gap(
    active: Ints, used: Used, prices: Prices, costs: Costs, lanes: Occupancy, plan: Plan,
    sums: Floats,
) -> None:  # fmt: skip
    """Fill running sums of the trucks' parts of the gap, each a bit above zero.

    Parameters
    ----------
    active : ndarray of int64, (n,)
        Trucks.
    used, prices, costs, lanes, plan : Used, Prices, Costs, Occupancy, Plan
        The problem, and what they do.
    sums : ndarray of float64, (n,)
        Is filled [grains].
    """
    total, least = 0.0, 0.0
    for x in range(len(active)):
        k = active[x]
        part = -prices.cost[k]
        if costs.waiting > 0:
            part += costs.waiting * waits(plan.legs[k], plan.departs[k], plan.lengths[k], used)
        for q in range(plan.lengths[k]):
            p = plan.legs[k, q]
            lane = used.lane[p]
            there = times_at(lanes, lane, plan.departs[k, q])
            if there < 2:
                part += used.alone[p]
            else:
                platoons = 1
                if costs.largest > 0:
                    platoons = (there + costs.largest - 1) // costs.largest
                part += used.member[p] + costs.extra[lane] * platoons / there
        sums[x] = max(part, 0.0)
        total += sums[x]
    # Even trucks without a gap are drawn now and then.
    least = 0.02 * total / max(len(active), 1) + 1e-9
    total = 0.0
    for x in range(len(active)):
        total += sums[x] + least
        sums[x] = total


def drawn_seed(active: Ints, sums: Floats, state: Ints) -> int:
    """Return a truck, drawn by its part of the gap.

    Parameters
    ----------
    active, sums : ndarray of int64, ndarray of float64
        As of `parts_of_gap`.
    state : ndarray of int64
        Of the random numbers.

    Returns
    -------
    int
        The truck.
    """
    if uniform(state) >= 0.7:
        return int(active[below(state, len(active))])
    wanted = uniform(state) * sums[len(sums) - 1]
    low, high = 0, len(active) - 1
    while low < high:
        middle = (low + high) >> 1
        if sums[middle] < wanted:
            low = middle + 1
        else:
            high = middle
    return int(active[low])


def gathered(
    k: int, size: int, is_active: Marks, guide: NDArray[np.int32], guide_count: Ints, used: Used,
    plan: Plan, state: Ints, some: Crew,
) -> int:  # fmt: skip
    """Gather trucks around a first one; return how many they are.

    Parameters
    ----------
    k, size : int
        The first, and how many are wanted.
    is_active : ndarray of bool, (N,)
        Trucks that may be moved.
    guide, guide_count : ndarray
        Pairs of each truck's cheapest schedule by the bound's shares.
    used, plan, state : Used, Plan, ndarray of int64
        The problem, what they do, and random numbers.
    some : Crew
        Gets them.

    Returns
    -------
    int
        At least 1.
    """
    some.truck[0] = k
    some.inside[k] = True
    found = 1
    for _ in range(4 * size):
        if found >= size:
            break
        one = some.truck[below(state, found)] if uniform(state) < 0.7 else k
        pairs = used.first[one + 1] - used.first[one]
        if pairs == 0:
            continue
        way = uniform(state)
        if way < 0.35 and guide_count[one] > 0:
            p = int(guide[one, below(state, guide_count[one])])
        elif way < 0.85:
            p = int(plan.legs[one, below(state, plan.lengths[one])])
        else:
            p = int(used.first[one] + below(state, pairs))
        if p < 0:
            continue
        lane = used.lane[p]
        begin, end = used.lane_first[lane], used.lane_first[lane + 1]
        low = first_at(used.by_opens, begin, end, used.opens[p] - used.lane_wide[lane])
        high = first_at(used.by_opens, low, end, used.closes[p] + 1)
        if high <= low:
            continue
        for _ in range(3):
            other = used.by_lane[low + below(state, high - low)]
            mate = used.truck[other]
            if used.closes[other] < used.opens[p] or some.inside[mate] or not is_active[mate]:
                continue
            some.truck[found] = mate
            some.inside[mate] = True
            found += 1
            break
    return found


HELPERS = (*moves.HELPERS, parts_of_gap, drawn_seed, gathered)
