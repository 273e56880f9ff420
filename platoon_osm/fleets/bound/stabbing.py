"""Shares to start from: those of largest sets of disjoint windows.

On each lane the trucks whose cheapest routes alone lead over it have a largest set of disjoint
windows, found by taking the first that closes again and again. At least so many platoons or trucks
alone pass the lane, so that its trucks can carry the whole price of a platoon. They carry most of
it here, and all trucks of the bucket the rest, those on their routes alone more than others.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled
from ..instance import Instance
from .buckets import Buckets
from .projecting import projected

__all__ = ["first_shares"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]

ALL = 0.05
"""The part of the price that all trucks of a bucket carry."""

ASIDE = 0.2
"""What a truck off its route alone carries of it, against one on it."""


def first_shares(instance: Instance, buckets: Buckets) -> Floats:
    """Return valid shares to start from.

    Parameters
    ----------
    instance : Instance
        The fleet's problem.
    buckets : Buckets
        The buckets.

    Returns
    -------
    ndarray of float64, (S,)
        Of the listed pairs [grains].
    """
    pairs = buckets.pairs
    alone = instance.on_alone[pairs]
    lane, opens, closes = (
        column[pairs] for column in (instance.pair_lane, instance.opens, instance.closes)
    )
    marked = np.zeros(len(pairs), np.bool_)
    _mark_disjoint(np.lexsort((closes, lane)), lane, opens, closes, alone, marked)
    member = buckets.entry
    of = buckets.pair_of[member]
    bucket = np.repeat(np.arange(len(buckets.starts)), np.diff(buckets.first_member))
    weight = np.where(alone[of], 1.0, ASIDE)
    count = len(buckets.starts)
    stabbed = np.bincount(bucket, marked[of], count)[bucket]
    part = weight / np.bincount(bucket, weight, count)[bucket]
    amount = np.where(
        stabbed > 0, (1.0 - ALL) * marked[of] / np.maximum(stabbed, 1.0) + ALL * part, part
    )
    share = np.empty(buckets.shares)
    share[member] = amount * buckets.extra[bucket]
    projected(
        share, buckets.first_member, buckets.entry, buckets.extra, buckets.leader, instance.largest
    )
    return share


@compiled
def _mark_disjoint(
    order: Ints, lane: Ints, opens: Ints, closes: Ints, allowed: Marks, marked: Marks
) -> None:
    """Mark a largest set of disjoint windows of each lane; sorted by lane and closing."""
    last, until = np.int64(-1), np.int64(0)
    for p in order:
        if allowed[p] and (lane[p] != last or opens[p] > until):
            last, until = lane[p], closes[p]
            marked[p] = True
