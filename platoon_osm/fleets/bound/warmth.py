"""The bound's kernels, compiled before anybody waits for them."""

from __future__ import annotations

import numpy as np

from ..instance import Instance
from .bound import Bound

__all__ = ["warm_up"]


def warm_up(waiting: int = 0) -> None:
    """Have all compiled from now on, by bounding a fleet of three trucks on two roads in a row.

    Parameters
    ----------
    waiting : int
        The price of waiting; another search is compiled where there is one.
    """
    road, truck = np.arange(2), np.arange(3)
    length, none = np.full(2, 10), 0 * truck
    instance = Instance(
        nodes=3, tail=road, head=road + 1, drive=length, alone=10 * length, member=9 * length,
        extra=length, lane_kind=0 * road, origin=none, destination=np.array([1, 1, 2]),
        earliest=truck, latest_departure=truck + 9, latest=np.array([19, 20, 31]), kind=none,
        largest=2, given=False, waiting=waiting, first_pair=np.array([0, 1, 2, 4]),
        pair_truck=np.array([0, 1, 2, 2]), pair_lane=np.array([0, 0, 0, 1]),
        opens=np.array([0, 1, 2, 12]), closes=np.array([9, 10, 11, 21]),
        on_alone=np.ones(4, np.bool_), alone_cost=np.array([100, 100, 200]),
    )  # fmt: skip
    bound = Bound(instance)
    bound.improve(float(instance.alone_cost.sum()), 200, lambda: False)
    bound.certified()
