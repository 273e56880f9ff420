"""Shares rounded down to whole numbers so that they stay valid.

Rounding each down keeps every sum at most as large. What sums in double precision may exceed the
price by is taken off the greatest shares of the bucket.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled
from ..instance import Instance
from .buckets import Buckets

__all__ = ["whole_shares"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


def whole_shares(buckets: Buckets, share: Floats | Ints, instance: Instance) -> Ints:
    """Return shares in whole numbers.

    Parameters
    ----------
    buckets : Buckets
        The buckets.
    share : ndarray of float64, (S,)
        Shares that are valid but for rounding [grains].
    instance : Instance
        The fleet's problem.

    Returns
    -------
    ndarray of int64, (S,)
        Valid shares [grains].
    """
    # What is whole but for rounding is meant to be whole.
    down = np.floor(share + 1e-6).astype(np.int64)
    extra, leader = instance.extra[buckets.lane], instance.leader_saves[buckets.lane]
    _made_valid(down, buckets.first_member, buckets.entry, extra, leader, instance.largest)
    return down


@compiled
def _made_valid(
    share: Ints, first_member: Ints, entry: Ints, extra: Ints, leader: Ints, largest: int
) -> None:
    """Lower shares until no company pays more than it costs."""
    for b in range(len(extra)):
        low, high = first_member[b], first_member[b + 1]
        for i in range(low, high):
            one = entry[i]
            share[one] = max(min(share[one], extra[b] + leader[b]), -leader[b])
        n = high - low
        if n < 2:
            continue
        most = n if largest == 0 else min(largest, n)
        while True:
            own = np.sort(share[entry[low:high]])
            total = own[n - 1] + own[n - 2]
            size = 2
            while size < most and own[n - 1 - size] > 0:
                total += own[n - 1 - size]
                size += 1
            if total <= extra[b]:
                break
            # The greatest gives what is too much, but at most down to the least of the company.
            over = total - extra[b]
            first = low
            for i in range(low, high):
                if share[entry[i]] > share[entry[first]]:
                    first = i
            room = max(own[n - 1] - own[n - size], np.int64(1))
            share[entry[first]] -= min(over, room)
