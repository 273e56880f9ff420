"""Where buckets should be cut, from the schedules that are cheapest under their shares.

A schedule that enters a lane within a bucket, after its start, may pay for company that has left by
then: a cut at that instant lets earlier and later companies have shares of their own. Likewise it
may be too late for its next bucket already: a cut follows the last instant from which it is still
reached in time. Cuts of buckets with one member change nothing and are left out.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled
from .buckets import Buckets, Clock
from .leaving import leaves_at
from .prices import Prices, Routes
from .searching import Searching
from .ways import Ways

__all__ = ["cuts_of"]

Ints = NDArray[np.int64]


def cuts_of(clock: Clock, buckets: Buckets, searching: Searching) -> Ints:
    """Return where the schedules found last would cut buckets.

    Parameters
    ----------
    clock : Clock
        The clock of the instance.
    buckets : Buckets
        The buckets.
    searching : Searching
        Of the same listed pairs, after a search.

    Returns
    -------
    ndarray of int64
        As the clock numbers instants, each once, ascending.
    """
    routes = searching.routes
    room = 2 * int(np.maximum(routes.length, 0).sum())
    lane, instant = np.empty(room, np.int64), np.empty(room, np.int64)
    count = _cuts(
        searching.waiting > 0, searching.ways, searching.prices, routes, searching.lane,
        buckets.first_member, lane, instant,
    )  # fmt: skip
    return np.unique(clock.key(lane[:count], instant[:count]))


@compiled
def _cuts(
    waits: bool, ways: Ways, prices: Prices, routes: Routes, lane: Ints, first_member: Ints,
    cut_lane: Ints, cut: Ints,
) -> int:  # fmt: skip
    """Write down lanes and instants of cuts, and return how many."""
    found = 0
    for k in range(len(routes.length)):
        first = ways.first_place[k]
        last = first + routes.length[k]
        now = ways.earliest[k]
        if waits and last > first:
            now = leaves_at(k, ways, prices, routes)
        for at in range(first, last):
            p = routes.pair[at]
            bucket = prices.first_bucket[p] + routes.entry[at] - prices.first_share[p]
            now = max(now, ways.opens[p], prices.starts[bucket])
            shared = first_member[bucket + 1] - first_member[bucket] > 1
            if shared and now > prices.starts[bucket]:
                cut_lane[found] = lane[p]
                cut[found] = now
                found += 1
            now += ways.drive[p]
        latest = np.int64(1 << 60)
        for at in range(last - 1, first - 1, -1):
            p = routes.pair[at]
            within = routes.entry[at] - prices.first_share[p]
            bucket = prices.first_bucket[p] + within
            until = ways.closes[p]
            if routes.entry[at] + 1 < prices.first_share[p + 1]:
                until = min(until, prices.starts[bucket + 1] - 1)
            if latest - ways.drive[p] < until:
                until = latest - ways.drive[p]
                shared = first_member[bucket + 1] - first_member[bucket] > 1
                if shared and until + 1 > prices.starts[bucket]:
                    cut_lane[found] = lane[p]
                    cut[found] = until + 1
                    found += 1
            latest = until
    return found
