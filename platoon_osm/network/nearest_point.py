"""Which of many points is nearest to a place, where only near ones matter."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .geodesy import distance_m, metres_per_degree

__all__ = ["NearestPoint"]

Floats = NDArray[np.float64]


class NearestPoint:
    """Points in the order of their latitudes, so that a question looks at a strip of them.

    Parameters
    ----------
    lon, lat : ndarray of float, (p,)
        The points [deg].
    reach_m : float
        How far away a point may be at most [m].
    """

    def __init__(self, lon: Floats, lat: Floats, reach_m: float) -> None:
        self._order = np.argsort(lat, kind="stable")
        self._lon, self._lat = lon[self._order], lat[self._order]
        self._reach_m = reach_m
        # A degree of latitude is shortest at the equator.
        self._strip = reach_m / float(metres_per_degree(0.0)[1])

    def to(self, lon: float, lat: float) -> int | None:
        """Return the point nearest to a place.

        Parameters
        ----------
        lon, lat : float
            The place [deg].

        Returns
        -------
        int or None
            Its position among the points, of equally near ones the first; None if all are too far.
        """
        first, last = np.searchsorted(self._lat, (lat - self._strip, lat + self._strip))
        if first == last:
            return None
        away = distance_m(self._lon[first:last], self._lat[first:last], lon, lat)
        least = float(away.min())
        if least > self._reach_m:
            return None
        return int(self._order[first:last][away == least].min())
