"""When a truck leaves for a schedule told as lanes and buckets, where waiting has a price.

Its buckets say from when to when it enters each lane. However early it leaves, it enters the last
one at some instant and no sooner; so it leaves as late as its buckets let it without being later
there, for waiting before leaving is free. What is left is waiting on the road.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import made_known
from .prices import Prices, Routes
from .ways import Ways

__all__ = ["leaves_at", "waited"]

Ints = NDArray[np.int64]


def leaves_at(k: int, ways: Ways, prices: Prices, routes: Routes) -> int:
    """Return when a truck enters the first lane of its schedule, to wait as little as it can.

    Parameters
    ----------
    k : int
        The truck; it has a schedule.
    ways, prices, routes : Ways, Prices, Routes
        As a search left them.

    Returns
    -------
    int
        The instant [ticks].
    """
    first = ways.first_place[k]
    last = first + routes.length[k]
    now = ways.earliest[k]
    until = np.int64(1) << 60
    driven = np.int64(0)
    leaves = now
    for at in range(first, last):
        p = routes.pair[at]
        within = routes.entry[at] - prices.first_share[p]
        now = max(now, ways.opens[p], prices.starts[prices.first_bucket[p] + within])
        if at == first:
            leaves = now
        closes = ways.closes[p]
        if routes.entry[at] + 1 < prices.first_share[p + 1]:
            closes = min(closes, prices.starts[prices.first_bucket[p] + within + 1] - 1)
        # Leaving by then enters this lane in its bucket, if nobody waits before.
        until = min(until, closes - driven)
        if at + 1 < last:
            now += ways.drive[p]
            driven += ways.drive[p]
    return int(max(leaves, min(until, now - driven)))


def waited(k: int, ways: Ways, prices: Prices, routes: Routes) -> int:
    """Return how long a truck waits on the road for its schedule, at least.

    Parameters
    ----------
    k : int
        The truck; it has a schedule.
    ways, prices, routes : Ways, Prices, Routes
        As a search left them.

    Returns
    -------
    int
        The time [ticks].
    """
    first = ways.first_place[k]
    now = leaves_at(k, ways, prices, routes)
    waits = np.int64(0)
    for at in range(first, first + routes.length[k]):
        p = routes.pair[at]
        bucket = prices.first_bucket[p] + routes.entry[at] - prices.first_share[p]
        enters = max(now, ways.opens[p], prices.starts[bucket])
        waits += enters - now
        now = enters + ways.drive[p]
    return int(waits)


for _helper in (leaves_at, waited):
    made_known(_helper)
