"""How fast a vehicle drives each road: as signs, the law and its own limiter allow."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork
from .profile import Vehicle

__all__ = ["drive_times"]

Floats = NDArray[np.float64]


def drive_times(net: RoadNetwork, vehicle: Vehicle | None = None) -> Floats:
    """Return how long a vehicle takes for every edge alone.

    A heavy vehicle drives `net.speed_mps`, in which the law and the limiter that the network was
    loaded with are; its own limiter may only make it slower. A light one drives `net.posted_mps`
    within its own limiter, if it has one.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    vehicle : Vehicle, optional
        Without it, whatever the network was loaded for.

    Returns
    -------
    ndarray of float, (m,)
        Seconds.

    Notes
    -----
    Where an edge joins roads of several speeds it keeps their mean, so a limiter below the highest
    of them is taken to hold for the mean: the time is then a little too short, never too long.
    """
    if vehicle is None:
        return net.length_m / net.speed_mps
    speed = net.speed_mps if vehicle.heavy else net.posted_mps
    if vehicle.limiter_kmh is not None:
        speed = np.minimum(speed, vehicle.limiter_kmh / 3.6)
    times: Floats = net.length_m / speed
    return times
