"""Group moves: a whole platoon is taken to another instant of its lane.

On days when nearly all can platoon, what would have to change together is a platoon: its members
are taken out, some that are with them elsewhere too, and put back with a bonus for entering the
lane at an instant at which others enter it. Who cannot be there then, and who is left behind,
responds as ever.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import neighbourhoods
from .desk import Plan
from .draws import below, uniform
from .moves import Crew
from .occupancy import Occupancy, first_at
from .pairs_used import Used

__all__ = ["HELPERS", "banded", "other_instant"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]


def _joined(
    p: int, instant: int, found: int, size: int, is_active: Marks, used: Used, entered: Ints,
    some: Crew,
) -> int:  # fmt: skip
    """Add trucks that enter a pair's lane at an instant; return how many there are then."""
    lane = used.lane[p]
    begin, end = used.lane_first[lane], used.lane_first[lane + 1]
    i = first_at(used.by_opens, begin, end, instant - used.lane_wide[lane])
    while i < end and used.by_opens[i] <= instant and found < size:
        other = used.by_lane[i]
        mate = used.truck[other]
        if entered[other] == instant and is_active[mate] and not some.inside[mate]:
            some.truck[found] = mate
            some.inside[mate] = True
            found += 1
        i += 1
    return found


def banded(
    k: int, q: int, size: int, more: int, is_active: Marks, used: Used, plan: Plan, entered: Ints,
    state: Ints, some: Crew,
) -> int:  # fmt: skip
    """Gather a truck's platoon on one of its lanes, and some that are with its members elsewhere.

    Parameters
    ----------
    k, q : int
        The truck, and which of its lanes.
    size, more : int
        How many trucks at most, and how many lanes of members are looked at for others.
    is_active : ndarray of bool, (N,)
        Trucks that may be moved.
    used, plan, entered, state : Used, Plan, ndarray of int64
        The problem, what they do, and random numbers.
    some : Crew
        Gets them.

    Returns
    -------
    int
        How many they are.
    """
    some.truck[0] = k
    some.inside[k] = True
    found = _joined(
        plan.legs[k, q], plan.departs[k, q], 1, size, is_active, used, entered, some
    )  # fmt: skip
    for _ in range(more):
        one = some.truck[below(state, found)]
        r = below(state, plan.lengths[one])
        found = _joined(
            plan.legs[one, r], plan.departs[one, r], found, size, is_active, used, entered, some
        )  # fmt: skip
    return found


def other_instant(p: int, instant: int, lanes: Occupancy, used: Used, state: Ints) -> int:
    """Return an instant near another at which somebody else enters the lane of a pair.

    Parameters
    ----------
    p, instant : int
        The pair, and when it is entered.
    lanes : Occupancy
        Who enters which lane when.
    used : Used
        The pairs.
    state : ndarray of int64
        Of the random numbers.

    Returns
    -------
    int
        -1 if there is none in the pair's window.
    """
    lane = used.lane[p]
    begin = lanes.first[lane]
    end = begin + lanes.size[lane]
    low = first_at(lanes.at, begin, end, used.opens[p])
    high = first_at(lanes.at, low, end, used.closes[p] + 1)
    if high - low < 2:
        return -1
    i = first_at(lanes.at, low, high, instant)
    step = 1 + int(3.0 * uniform(state) * uniform(state))
    i = i + step if uniform(state) < 0.5 else i - step
    if low <= i < high:
        return int(lanes.at[i])
    return -1


HELPERS = (*neighbourhoods.HELPERS, _joined, banded, other_instant)
