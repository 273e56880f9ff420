"""What a company pays on each edge, as a line in the number of its vehicles.

With C(n) what n vehicles alike pay on an edge in one platoon, all places counted, the line

    member = min over n >= 3 of (C(n) - C(2)) / (n - 2),    extra = C(2) - 2 member

has n member + extra <= C(n) for every n, with equality for two, and for all n where each further
vehicle costs the same: for weights by position (master, middle, last) it is exact, member being
what one between first and last pays and extra = master + last - 2 middle. So a bound on costs by
the line is one on real costs. Where extra would be negative, half of C(2) is the slope instead.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..costs.weights import EdgeWeights

__all__ = ["company_line"]

Floats = NDArray[np.float64]


def company_line(weights: EdgeWeights, largest: int) -> tuple[Floats, Floats]:
    """Return what a platoon costs on each edge: for each vehicle, and once more.

    Parameters
    ----------
    weights : EdgeWeights
        Of vehicles that are alike.
    largest : int
        Vehicles of the largest platoon; 0 for any.

    Returns
    -------
    member, extra : ndarray of float, (m,)
        In the unit of the weights; 0 <= extra.
    """
    pair = _company(weights, 2)
    slopes = [
        (_company(weights, size) - pair) / (size - 2)
        for size in _sizes(weights)
        if size > 2 and (not largest or size <= largest)
    ]
    member = np.minimum.reduce([*slopes, pair / 2])
    return member, pair - 2 * member


def _sizes(weights: EdgeWeights) -> tuple[int, ...]:
    """Return sizes among which is one for every way in which a further vehicle may cost."""
    if weights.by_place is None:
        return (3,)
    # One beyond the told sizes tells what the rest cost; the one after it, what each more costs.
    told = weights.by_place.told_sizes
    return (*range(3, max((3, *told)) + 2),)


def _company(weights: EdgeWeights, size: int) -> Floats:
    """Return what all vehicles of a company pay on each edge."""
    if weights.by_place is not None:
        places = [weights.by_place.in_place(place, size, None) for place in range(size)]
        total: Floats = np.sum(places, axis=0)
        return total
    last = weights.platoon if weights.last is None else weights.last
    middle = weights.platoon if weights.middle is None else weights.middle
    return weights.master + last + (size - 2) * middle
