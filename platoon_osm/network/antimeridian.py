"""Longitudes on both sides of the antimeridian, where 180 degrees east are 180 degrees west.

Networks hold longitudes between -180 and 180. A road that crosses the antimeridian jumps by nearly
360 degrees there, so differences are taken the short way round, and whatever lays roads on a plane
counts longitudes on: 179.9, 180.1. Away from the antimeridian all of this gives back the numbers it
was given.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "continued_deg",
    "cut_at_antimeridian",
    "mean_longitude_deg",
    "middle_longitude_deg",
    "near_deg",
    "wrapped_deg",
]

Floats = NDArray[np.float64]

HALF = 180.0
TURN = 360.0


def wrapped_deg(degrees: ArrayLike) -> Floats:
    """Return longitudes, or differences of longitude the short way round, in [-180, 180].

    Parameters
    ----------
    degrees : array_like of float
        Any number of turns away.

    Returns
    -------
    ndarray of float
        The same directions; what lies within these bounds is not touched.
    """
    given = np.asarray(degrees, np.float64)
    result: Floats = np.where(np.abs(given) > HALF, (given + HALF) % TURN - HALF, given)
    return result


def middle_longitude_deg(lon: ArrayLike) -> float:
    """Return the middle of the narrowest band of longitudes that holds some points.

    The band leaves out the widest empty gap between neighbouring meridians; of two equal ones that
    over the antimeridian.

    Parameters
    ----------
    lon : array_like of float, (k,)
        Longitudes in [-180, 180] [deg].

    Returns
    -------
    float
        In [-180, 180]; 0 without points.
    """
    points = np.asarray(lon, np.float64)
    if not len(points):
        return 0.0
    west, east = float(points.min()), float(points.max())
    if east - west >= HALF:
        meridians = np.unique(points)
        gaps = np.diff(meridians)
        widest = int(gaps.argmax())
        if gaps[widest] > TURN - (east - west):
            west, east = float(meridians[widest + 1]), float(meridians[widest]) + TURN
    return float(wrapped_deg((west + east) / 2))


def near_deg(lon: ArrayLike, middle: float) -> Floats:
    """Return longitudes counted so that they lie within half a turn of a meridian.

    Parameters
    ----------
    lon : array_like of float
        Longitudes in [-180, 180] [deg].
    middle : float
        The meridian [deg].

    Returns
    -------
    ndarray of float
        They may lie beyond 180 on either side.
    """
    given = np.asarray(lon, np.float64)
    result: Floats = given + TURN * np.round((middle - given) / TURN)
    return result


def continued_deg(lon: ArrayLike, first: NDArray[np.int64] | None = None) -> Floats:
    """Return the longitudes of lines, each counted on from its first point.

    Parameters
    ----------
    lon : array_like of float, (k,)
        Longitudes of the points [deg].
    first : ndarray of int64, (l + 1,), optional
        Where each of several lines begins among them, and the end; by default they are one line.

    Returns
    -------
    ndarray of float, (k,)
        No step of a line is longer than half a turn.
    """
    given = np.asarray(lon, np.float64)
    steps = np.diff(given)
    jumps = (steps < -HALF).astype(np.int64) - (steps > HALF)
    if not jumps.any():
        return given
    turns = np.concatenate([[0], np.cumsum(jumps)])
    if first is not None:
        turns -= np.repeat(turns[first[:-1]], np.diff(first))
    return given + TURN * turns


def mean_longitude_deg(lon: ArrayLike) -> float:
    """Return the mean longitude of points near each other.

    Parameters
    ----------
    lon : array_like of float, (k,)
        Longitudes in [-180, 180] [deg].

    Returns
    -------
    float
        In [-180, 180].
    """
    return float(wrapped_deg(near_deg(lon, middle_longitude_deg(lon)).mean()))


def cut_at_antimeridian(line: ArrayLike) -> list[Floats]:
    """Cut a line where it crosses the antimeridian, as RFC 7946 (GeoJSON), section 3.1.9, asks for.

    Parameters
    ----------
    line : array_like of float, (k, 2)
        Longitude and latitude [deg]; longitudes may lie beyond 180 on either side.

    Returns
    -------
    list of ndarray of float, (j, 2)
        The line as it is if it does not cross; else its pieces, all longitudes in [-180, 180],
        each ending at 180 or -180 where the next begins.
    """
    points = np.asarray(line, np.float64)
    lon = continued_deg(points[:, 0])
    if not len(lon) or np.abs(lon).max() <= HALF:
        return [points]
    turns = np.floor((lon + HALF) / TURN).tolist()
    turn = turns[0]
    pieces: list[list[tuple[float, float]]] = [[]]
    before = lon[0], points[0, 1]
    for x, y, goal in zip(lon.tolist(), points[:, 1].tolist(), turns, strict=True):
        while turn != goal:
            side = 1.0 if goal > turn else -1.0
            share = (TURN * turn + HALF * side - before[0]) / (x - before[0])
            crossing = float(before[1] + share * (y - before[1]))
            pieces[-1].append((HALF * side, crossing))
            turn += side
            pieces.append([(-HALF * side, crossing)])
        pieces[-1].append((x - TURN * turn, y))
        before = x, y
    # A line that touches the antimeridian in a point leaves nothing of itself on the other side.
    return [np.array(piece) for piece in pieces if len(set(piece)) > 1]
