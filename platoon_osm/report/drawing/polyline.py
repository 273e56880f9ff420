"""Lines as short text: Google's encoded polyline algorithm, at a precision of our choice.

References
----------
.. [1] https://developers.google.com/maps/documentation/utilities/polylinealgorithm
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["decode_lines", "decode_polyline", "encode_polyline", "encode_steps", "rounded_steps"]

Ints = NDArray[np.int64]


def rounded_steps(lonlat: ArrayLike, steps_per_degree: int) -> Ints:
    """Return points as whole steps.

    Points that round to the one before are left out, but a line keeps two points at least.

    Parameters
    ----------
    lonlat : array_like of float, (k, 2)
        Longitude and latitude in degrees.
    steps_per_degree : int
        What they are rounded to.

    Returns
    -------
    array of int, (j, 2)
        Longitude and latitude in steps.
    """
    flat = np.asarray(lonlat, np.float64).reshape(-1, 2)
    points = np.rint(flat * steps_per_degree).astype(np.int64)
    if len(points) > 2:
        moved = np.ones(len(points), bool)
        moved[1:] = (points[1:] != points[:-1]).any(axis=1)
        points = points[moved] if moved.sum() > 1 else points[:2]
    return points


def encode_steps(points: Ints, origin: tuple[int, int] = (0, 0)) -> str:
    """Encode points that are whole steps; latitude comes first in the text, as in [1]_.

    Parameters
    ----------
    points : array of int, (k, 2)
        Longitude and latitude in steps.
    origin : tuple of int
        Longitude and latitude that the first point is counted from.

    Returns
    -------
    str
        The line; empty without points.
    """
    steps = np.diff(points, axis=0, prepend=[origin])[:, ::-1].ravel()
    # The sign moves to the lowest bit, then five bits a character, lowest first.
    numbers = np.where(steps < 0, ~(steps << 1), steps << 1).tolist()
    out: list[str] = []
    for number in numbers:
        while number >= 0x20:
            out.append(chr((0x20 | (number & 0x1F)) + 63))
            number >>= 5
        out.append(chr(number + 63))
    return "".join(out)


def encode_polyline(lonlat: ArrayLike, steps_per_degree: int) -> str:
    """Encode points, rounded to 1 / `steps_per_degree`.

    Parameters
    ----------
    lonlat : array_like of float, (k, 2)
        Longitude and latitude in degrees.
    steps_per_degree : int
        What they are rounded to.

    Returns
    -------
    str
        The line.
    """
    return encode_steps(rounded_steps(lonlat, steps_per_degree))


def decode_lines(text: str, steps_per_degree: int) -> list[list[tuple[float, float]]]:
    """Return the lines of a text, each counted from the first point of the one before.

    Parameters
    ----------
    text : str
        Lines with blanks between them, as a document holds them.
    steps_per_degree : int
        What they were rounded to.

    Returns
    -------
    list of list of tuple of float
        The (lon, lat) points of each line in degrees.
    """
    found: list[list[tuple[float, float]]] = []
    lon = lat = 0.0
    for line in text.split():
        points = decode_polyline(line, steps_per_degree)
        found.append([(x + lon, y + lat) for x, y in points])
        lon, lat = found[-1][0]
    return found


def decode_polyline(text: str, steps_per_degree: int) -> list[tuple[float, float]]:
    """Return the points of an encoded line; the reverse of `encode_polyline`.

    Parameters
    ----------
    text : str
        One line, as a document holds it.
    steps_per_degree : int
        What it was rounded to.

    Returns
    -------
    list of tuple of float
        Its (lon, lat) points in degrees.
    """
    numbers: list[int] = []
    value = shift = 0
    for character in text:
        bits = ord(character) - 63
        value |= (bits & 0x1F) << shift
        shift += 5
        if bits < 0x20:
            numbers.append(~(value >> 1) if value & 1 else value >> 1)
            value = shift = 0
    lats = np.cumsum(numbers[0::2]) / steps_per_degree
    lons = np.cumsum(numbers[1::2]) / steps_per_degree
    return list(zip(lons.tolist(), lats.tolist(), strict=True))
