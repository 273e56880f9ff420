"""How steep roads are, by what the map says of heights and slopes.

An edge rises by `climb_m` and falls by `descent_m` in the direction of travel, on the `graded_m`
of its length where that is known; elsewhere nothing is known, and both are 0. Along a path they add
up: where all of it is known by the heights of its nodes, climb - descent is the height of its end
above its beginning.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .road_network import RoadNetwork

__all__ = ["grade", "graded_share"]

Floats = NDArray[np.float64]


def grade(net: RoadNetwork) -> Floats:
    """Return the mean grade of each edge.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    ndarray of float, (m,)
        Rise in the direction of travel over the length where it is known, 0.05 being 5 %; 0 where
        none of it is, which `graded_share` tells from level road.
    """
    rise = net.climb_m.astype(np.float64) - net.descent_m
    return np.divide(rise, net.graded_m, out=np.zeros(net.m), where=net.graded_m > 0)


def graded_share(net: RoadNetwork) -> Floats:
    """Return the share of each edge whose grade is known.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    ndarray of float, (m,)
        Between 0 and 1; 0 for an edge without length.
    """
    share = np.divide(net.graded_m, net.length_m, out=np.zeros(net.m), where=net.length_m > 0)
    return np.clip(share, 0.0, 1.0)
