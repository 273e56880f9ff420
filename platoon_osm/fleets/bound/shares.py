"""Shares of each platoon's price, and when they are valid.

A bucket is a lane over a span of instants. A truck that enters the lane in a bucket pays there

    min(alone, member + share),    and  member - h  where it has no share,

h being what a leader saves. Shares are valid if no company that may form pays more than it costs:
any 2 to `largest` trucks of a bucket have shares of at most `extra` together, and one of at most
alone - member. Then the trucks' cheapest schedules cost together at most what any plan costs.
Two regimes hold all shares of a bucket of which none could be raised:

    (i)  all are at least 0, and the `largest` greatest make `extra`;
    (ii) one is extra + x and all others -x, with 0 <= x <= h.

For let -x be the greatest share but one. If x < 0, shares below 0 may be raised to 0, for with them
no company is charged more than its others are; if x >= 0, the greatest share is at most extra + x,
and all others may be raised to -x. A truck alone in its bucket has alone - member.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Shares"]

Ints = NDArray[np.int64]
Amounts = NDArray[np.float64] | NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Shares:
    """Shares of listed pairs in the buckets of their windows.

    Attributes
    ----------
    lane_first : ndarray of int64, (L + 1,)
        Where the buckets of each lane begin in `starts`.
    starts : ndarray of int64, (B,)
        First instant of each bucket, ascending in a lane [ticks]; each lasts until the next, and
        the last for ever.
    pairs : ndarray of int64, (K,)
        Pairs of the instance that have shares, ascending.
    first_bucket : ndarray of int64, (K,)
        The bucket in which the window of each listed pair opens.
    first_share : ndarray of int64, (K + 1,)
        Where the shares of each listed pair begin: one for each bucket of its window, in order.
    share : ndarray of float64 or int64, (S,)
        What the truck pays beyond `member` [grains].
    """

    lane_first: Ints
    starts: Ints
    pairs: Ints
    first_bucket: Ints
    first_share: Ints
    share: Amounts
