"""Who enters which lane when: the instants of each lane in their order, and how many enter at each.

The instants of a lane lie in a row of their own, long enough for all that may use it; a truck comes
and goes by a binary search. What it changes in cost is known at once:

    f(n + 1) - f(n),   f the company cost of `instance.py`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["HELPERS", "Costs", "Occupancy", "enter", "first_at", "leave", "one_more", "times_at"]

Ints = NDArray[np.int64]


class Occupancy(NamedTuple):
    """The instants of lanes.

    Attributes
    ----------
    first : ndarray of int64, (L + 1,)
        Where the row of each lane begins.
    size : ndarray of int64, (L,)
        How many instants it has.
    at, trucks : ndarray of int64
        Instants [ticks], ascending in each row, and trucks that enter then.
    """

    first: Ints
    size: Ints
    at: Ints
    trucks: Ints


class Costs(NamedTuple):
    """What lanes cost, see `Instance`.

    Attributes
    ----------
    alone, member, extra : ndarray of int64, (L,)
        Of each lane [grains].
    largest : int
        Vehicles of the largest platoon; 0 for any.
    waiting : int
        Price of waiting on the road [grains a tick].
    """

    alone: Ints
    member: Ints
    extra: Ints
    largest: int
    waiting: int


def first_at(at: Ints, low: int, high: int, instant: int) -> int:
    """Return the first place of a sorted stretch whose value is an instant or later.

    Parameters
    ----------
    at : ndarray of int64
        Values.
    low, high : int
        The stretch, without `high`.
    instant : int
        What is sought.

    Returns
    -------
    int
        `high` if all are earlier.
    """
    while low < high:
        middle = (low + high) >> 1
        if at[middle] < instant:
            low = middle + 1
        else:
            high = middle
    return low


def times_at(occupancy: Occupancy, lane: int, instant: int) -> int:
    """Return how many trucks enter a lane at an instant.

    Parameters
    ----------
    occupancy : Occupancy
        Of all.
    lane, instant : int
        Where and when.

    Returns
    -------
    int
        The count.
    """
    begin = occupancy.first[lane]
    end = begin + occupancy.size[lane]
    i = first_at(occupancy.at, begin, end, instant)
    if i < end and occupancy.at[i] == instant:
        return int(occupancy.trucks[i])
    return 0


def one_more(count: int, alone: int, member: int, extra: int, largest: int) -> int:
    """Return what a company costs more with one more truck.

    Parameters
    ----------
    count : int
        Trucks without it.
    alone, member, extra : int
        Of the lane [grains].
    largest : int
        Vehicles of the largest platoon; 0 for any.

    Returns
    -------
    int
        The difference [grains].
    """
    if count == 0:
        return alone
    if largest == 2:
        # Two by two; the odd one drives alone.
        return 2 * member + extra - alone if count % 2 == 1 else alone
    if count == 1:
        return 2 * member + extra - alone
    if largest > 0 and count % largest == 0:
        return member + extra
    return member


def enter(occupancy: Occupancy, costs: Costs, lane: int, instant: int) -> int:
    """Let a truck enter a lane at an instant; return what all pay more.

    Parameters
    ----------
    occupancy : Occupancy
        Is changed.
    costs : Costs
        Of lanes.
    lane, instant : int
        Where and when.

    Returns
    -------
    int
        The difference [grains].
    """
    at, count = occupancy.at, occupancy.trucks
    begin = occupancy.first[lane]
    end = begin + occupancy.size[lane]
    i = first_at(at, begin, end, instant)
    before = 0
    if i < end and at[i] == instant:
        before = count[i]
        count[i] += 1
    else:
        for j in range(end, i, -1):
            at[j] = at[j - 1]
            count[j] = count[j - 1]
        at[i] = instant
        count[i] = 1
        occupancy.size[lane] += 1
    return one_more(
        before, costs.alone[lane], costs.member[lane], costs.extra[lane], costs.largest
    )  # fmt: skip


def leave(occupancy: Occupancy, costs: Costs, lane: int, instant: int) -> int:
    """Let a truck that enters a lane at an instant do so no more; return what all pay less.

    Parameters
    ----------
    occupancy : Occupancy
        Is changed.
    costs : Costs
        Of lanes.
    lane, instant : int
        Where and when.

    Returns
    -------
    int
        The difference [grains].
    """
    at, count = occupancy.at, occupancy.trucks
    begin = occupancy.first[lane]
    end = begin + occupancy.size[lane]
    i = first_at(at, begin, end, instant)
    count[i] -= 1
    left = count[i]
    if left == 0:
        for j in range(i, end - 1):
            at[j] = at[j + 1]
            count[j] = count[j + 1]
        occupancy.size[lane] -= 1
    return one_more(left, costs.alone[lane], costs.member[lane], costs.extra[lane], costs.largest)


HELPERS = (first_at, times_at, one_more, enter, leave)
