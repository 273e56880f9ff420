"""The search's kernels, compiled before anybody waits for them."""

from __future__ import annotations

import numpy as np

from ..bound.bound import Bound
from ..instance import Instance
from .compiled import EXPLORE, SWEEP, THROUGH
from .search import FleetSearch

__all__ = ["warm_up"]


def warm_up() -> None:
    """Have all compiled from now on, by planning a fleet of two trucks with a choice of roads."""
    for kernel in (EXPLORE, SWEEP, THROUGH):
        kernel.now()
    road, truck = np.arange(3), np.arange(2)
    length, none = np.array([10, 10, 25]), np.zeros(2, np.int64)
    instance = Instance(
        nodes=3, tail=np.array([0, 1, 0]), head=np.array([1, 2, 2]), drive=length,
        alone=10 * length, member=9 * length, extra=length, lane_kind=0 * road, origin=none,
        destination=none + 2, earliest=truck, latest_departure=truck + 9, latest=truck + 40,
        kind=none, largest=0, given=False, waiting=0, first_pair=np.array([0, 3, 6]),
        pair_truck=np.repeat(truck, 3), pair_lane=np.array([0, 2, 1] * 2),
        opens=np.array([0, 0, 10, 1, 1, 11]), closes=np.array([9, 9, 30, 10, 10, 31]),
        on_alone=np.array([True, False, True] * 2), alone_cost=np.array([200, 200]),
    )  # fmt: skip
    bound = Bound(instance)
    search = FleetSearch(instance)
    search.construct(bound.shares, bound.guide)
    search.improve(bound.shares, bound.guide, 2, 0.0, lambda: False)
