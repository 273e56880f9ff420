"""A first plan: trucks are put in one after another in random order, then respond again.

With the bound's shares each lane is entered where platoons are likely to form. For large fleets the
lanes are prepared first: on each a largest set of disjoint windows is found (by closing time, which
is optimal for intervals), and somebody who costs nothing enters where each of them closes, for
every truck of the lane can be with one of these. They leave again after two rounds, and larger
companies are preferred at first, so that the rest gather.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance

__all__ = ["meeting_points"]

Ints = NDArray[np.int64]


def meeting_points(instance: Instance) -> tuple[Ints, Ints]:
    """Return instants of lanes such that each truck's window of its way alone holds one.

    Parameters
    ----------
    instance : Instance
        The problem.

    Returns
    -------
    lane, instant : ndarray of int64
        Where windows of a largest set of disjoint ones close, for lanes that ways alone share.
    """
    which = np.flatnonzero(instance.on_alone)
    lane = instance.pair_lane[which]
    order = which[np.lexsort((instance.closes[which], lane))]
    found: list[tuple[int, int]] = []
    last_lane, until = -1, 0
    for one, opens, closes in zip(
        instance.pair_lane[order].tolist(),
        instance.opens[order].tolist(),
        instance.closes[order].tolist(),
        strict=True,
    ):
        if one != last_lane or opens > until:
            last_lane, until = one, closes
            found.append((one, closes))
    points = np.array(found, np.int64).reshape(-1, 2)
    return points[:, 0].copy(), points[:, 1].copy()
