"""What lanes cost a truck in each bucket, and the schedules that are cheapest by it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Prices", "Routes"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


class Prices(NamedTuple):
    """What pairs cost in each bucket.

    Attributes
    ----------
    member : ndarray of float64, (K,)
        What a member of a platoon pays on each pair's lane [grains].
    first_bucket : ndarray of int64, (K,)
        The bucket in which each pair's window opens.
    first_share : ndarray of int64, (K + 1,)
        Where its shares begin.
    starts : ndarray of int64, (B,)
        First instants of buckets [ticks].
    share : ndarray of float64, (S,)
        What is paid beyond `member` [grains].
    """

    member: Floats
    first_bucket: Ints
    first_share: Ints
    starts: Ints
    share: Floats


class Routes(NamedTuple):
    """The cheapest schedules found last.

    Attributes
    ----------
    pair, entry : ndarray of int64, (places,)
        Pairs and positions of shares, truck by truck where its places begin.
    length : ndarray of int64, (N,)
        How many lanes; -1 before the first search.
    cost : ndarray of float64, (N,)
        What each costs [grains].
    """

    pair: Ints
    entry: Ints
    length: Ints
    cost: Floats
