"""Which of equally good platoons is taken: the longest, then the one that begins first.

Costs that differ by less than `TIE`, relative to the cost alone, are equal. The rule stands here
once, in three forms: `preferred` chooses for one member and is compiled for the hierarchy's kernels
as it stands; `in_order_of_preference` sorts all pairs of positions at once; `is_platoon` says when
the best pair is better than staying alone.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["TIE", "in_order_of_preference", "is_platoon", "preferred", "slack_of"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]
Number = float | Floats

TIE = 1e-11
"""Costs that differ by less, relative to the cost alone, are equal: sums of the same edges in
another order differ in their last digits, and the answer must not depend on it."""


def slack_of(alone: float, least: float) -> float:
    """Return how far costs may differ and be equal.

    Parameters
    ----------
    alone : float
        Cost alone; inf if there is no way.
    least : float
        Least cost in company; inf likewise.

    Returns
    -------
    float
        `TIE` of the cost alone, or of the least cost where there is no way alone.
    """
    if math.isfinite(alone):
        return TIE * alone
    return TIE * least if math.isfinite(least) else 0.0


def preferred(
    ends: Index, limit: float, lead: Floats, leave: Floats, platoon: Floats, length_m: Floats
) -> tuple[int, int, float]:
    """Return the preferred positions i, j of one member on a route, and how long it is in company.

    Parameters
    ----------
    ends : ndarray of int, (E,)
        Positions j where leaving costs no more than the limit in all, ascending.
    limit : float
        Least cost, and what counts as equal to it.
    lead : ndarray of float, (K + 1,)
        Least D(o, r_i) - P_i over all i up to each position; it never rises.
    leave : ndarray of float, (K + 1,)
        Cost alone from each position to the destination.
    platoon, length_m : ndarray of float, (K + 1,)
        Platoon weight and metres along the route up to each position.

    Returns
    -------
    i : int
        Where it joins; -1 if there are no ends.
    j : int
        Where it leaves; -1 likewise.
    together_m : float
        Metres in company; -1 likewise.
    """
    found_i, found_j, longest = -1, -1, -1.0
    for j in ends:
        wanted = limit - platoon[j] - leave[j]
        # The first entry that is good enough, by bisection; it is also the one with the longest
        # platoon, for lengths only grow.
        low, high = 0, len(lead)
        while low < high:
            middle = (low + high) // 2
            if lead[middle] <= wanted:
                high = middle
            else:
                low = middle + 1
        together = length_m[j] - length_m[min(low, j)]
        if together > longest or (together == longest and low < found_i):
            found_i, found_j, longest = low, j, together
    return found_i, found_j, longest


def is_platoon(together_m: Number, least: Number, alone: Number, slack: Number) -> Any:
    """Tell whether the preferred positions are a platoon: one of no length only if it is cheaper.

    Parameters
    ----------
    together_m : float or ndarray of float
        Metres in company.
    least, alone : float or ndarray of float
        Least cost in company, and cost alone.
    slack : float or ndarray of float
        As `slack_of` tells.

    Returns
    -------
    bool or ndarray of bool
        Whether to join.
    """
    return (together_m > 0) | (least < alone - slack)


def in_order_of_preference(first: Index, last: Index, together_m: Floats) -> Index:
    """Return the order in which equally good pairs of positions are preferred.

    Parameters
    ----------
    first, last : ndarray of int, (P,)
        Positions of joining and leaving.
    together_m : ndarray of float, (P,)
        Metres in company.

    Returns
    -------
    ndarray of int, (P,)
        The longest first; of equals the one that begins, then the one that ends first.
    """
    return np.lexsort((last, first, -together_m))
