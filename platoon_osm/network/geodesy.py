"""Distances and directions on the WGS84 ellipsoid, for whole arrays at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .antimeridian import wrapped_deg

__all__ = ["bearing_deg", "distance_m", "east_north_m", "metres_per_degree"]

SEMI_MAJOR_AXIS_M = 6_378_137.0
FLATTENING = 1 / 298.257_223_563
ECCENTRICITY_SQUARED = FLATTENING * (2 - FLATTENING)


def metres_per_degree(lat: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return metres in one degree of longitude and of latitude at the given latitude [deg].

    From the ellipsoid's radii of curvature: a prime-vertical one across, a meridional one along.

    Parameters
    ----------
    lat : array_like
        Degrees.

    Returns
    -------
    tuple[NDArray[np.float64], NDArray[np.float64]]
        Metres in one degree of longitude, and of latitude.
    """
    phi = np.radians(np.asarray(lat, np.float64))
    w = 1 - ECCENTRICITY_SQUARED * np.sin(phi) ** 2
    prime_vertical = SEMI_MAJOR_AXIS_M / np.sqrt(w)
    meridional = prime_vertical * (1 - ECCENTRICITY_SQUARED) / w
    return np.radians(prime_vertical * np.cos(phi)), np.radians(meridional)


def distance_m(
    lon1: ArrayLike, lat1: ArrayLike, lon2: ArrayLike, lat2: ArrayLike
) -> NDArray[np.float64]:
    """Distance between points [m], lon and lat in degrees, broadcast like numpy.

    Haversine on a sphere whose radius is the ellipsoid's in the direction of travel at the middle
    latitude. Against the geodesic the relative error is below 1e-6 up to 150 km, far beyond any
    map segment, and about 1e-4 at 3,000 km.

    Parameters
    ----------
    lon1 : array_like
        Longitude of the first points [deg].
    lat1 : array_like
        Latitude of the first points [deg].
    lon2 : array_like
        Longitude of the second points [deg].
    lat2 : array_like
        Latitude of the second points [deg].

    Returns
    -------
    ndarray of float
        Metres.
    """
    lam1, phi1, lam2, phi2 = (
        np.radians(np.asarray(value, np.float64)) for value in (lon1, lat1, lon2, lat2)
    )
    mid = (phi1 + phi2) / 2
    w = 1 - ECCENTRICITY_SQUARED * np.sin(mid) ** 2
    prime_vertical = SEMI_MAJOR_AXIS_M / np.sqrt(w)
    meridional = prime_vertical * (1 - ECCENTRICITY_SQUARED) / w
    north_part = np.sin((phi2 - phi1) / 2) ** 2
    east_part = np.cos(phi1) * np.cos(phi2) * np.sin((lam2 - lam1) / 2) ** 2
    half_chord = np.minimum(north_part + east_part, 1.0)
    share_north = np.divide(
        north_part, half_chord, out=np.ones_like(half_chord), where=half_chord > 0
    )
    # d^2 = (M dphi)^2 + (N cos(phi) dlam)^2 for a short segment, so radii are averaged as squares.
    radius = np.sqrt(share_north * meridional**2 + (1 - share_north) * prime_vertical**2)
    result: NDArray[np.float64] = 2 * radius * np.arcsin(np.sqrt(half_chord))
    return result


def east_north_m(
    lon: ArrayLike, lat: ArrayLike, origin_lat: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Flat coordinates [m] true to scale at `origin_lat` [deg]; for neighbourhoods only.

    Parameters
    ----------
    lon : array_like
        Degrees.
    lat : array_like
        Degrees.
    origin_lat : float
        Latitude where it is true to scale [deg].

    Returns
    -------
    tuple[NDArray[np.float64], NDArray[np.float64]]
        Metres to the east, and to the north.
    """
    per_lon, per_lat = metres_per_degree(origin_lat)
    return np.asarray(lon, np.float64) * per_lon, np.asarray(lat, np.float64) * per_lat


def bearing_deg(
    lon1: ArrayLike, lat1: ArrayLike, lon2: ArrayLike, lat2: ArrayLike
) -> NDArray[np.float64]:
    """Direction of a short segment, degrees clockwise from north in [0, 360).

    Parameters
    ----------
    lon1 : array_like
        Longitude of the first points [deg].
    lat1 : array_like
        Latitude of the first points [deg].
    lon2 : array_like
        Longitude of the second points [deg].
    lat2 : array_like
        Latitude of the second points [deg].

    Returns
    -------
    ndarray of float
        Degrees.
    """
    lon1, lat1, lon2, lat2 = (np.asarray(v, np.float64) for v in (lon1, lat1, lon2, lat2))
    per_lon, per_lat = metres_per_degree((lat1 + lat2) / 2)
    east, north = wrapped_deg(lon2 - lon1) * per_lon, (lat2 - lat1) * per_lat
    result: NDArray[np.float64] = np.degrees(np.arctan2(east, north)) % 360
    return result
