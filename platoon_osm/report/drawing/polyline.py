"""Lines as short text: Google's encoded polyline algorithm, at a precision of our choice.

References
----------
.. [1] https://developers.google.com/maps/documentation/utilities/polylinealgorithm
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["decode_lines", "decode_polyline", "encode_lines", "encode_polyline"]


ROWS_PER_DEGREE = 8


def encode_polyline(
    lonlat: ArrayLike, steps_per_degree: int, origin: tuple[int, int] = (0, 0)
) -> str:
    """Encode points, (k, 2) lon and lat in degrees, rounded to 1 / `steps_per_degree`.

    Latitude comes first in the text, as in [1]_. Points that round to the one before are left
    out, but a line keeps two points at least. `origin`, (lat, lon) in steps, is where the line's
    first point is counted from.
    """
    points = np.rint(np.asarray(lonlat, np.float64)[:, ::-1] * steps_per_degree).astype(np.int64)
    if len(points) > 2:
        moved = np.ones(len(points), bool)
        moved[1:] = (points[1:] != points[:-1]).any(axis=1)
        points = points[moved] if moved.sum() > 1 else points[:2]
    return _text_of(np.diff(points, axis=0, prepend=[origin]).ravel())


def _text_of(steps: NDArray[np.int64]) -> str:
    # The sign moves to the lowest bit, then five bits a character, lowest first.
    numbers = np.where(steps < 0, ~(steps << 1), steps << 1).tolist()
    out: list[str] = []
    for number in numbers:
        while number >= 0x20:
            out.append(chr((0x20 | (number & 0x1F)) + 63))
            number >>= 5
        out.append(chr(number + 63))
    return "".join(out)


def encode_lines(lines: Iterable[ArrayLike], steps_per_degree: int) -> str:
    """Encode many lines as one text, with blanks between them.

    Each line is counted from the first point of the one before, and they come in rows from south
    to north, so that these steps are short.
    """
    rows: list[tuple[tuple[int, int, int], ArrayLike]] = []
    for line in lines:
        lon, lat = np.rint(np.asarray(line, np.float64)[0] * steps_per_degree).astype(int).tolist()
        rows.append(((lat * ROWS_PER_DEGREE // steps_per_degree, lon, lat), line))
    out: list[str] = []
    origin = (0, 0)
    for (_, lon, lat), line in sorted(rows, key=lambda row: (row[0], np.asarray(row[1]).tobytes())):
        out.append(encode_polyline(line, steps_per_degree, origin))
        origin = (lat, lon)
    return " ".join(out)


def decode_lines(text: str, steps_per_degree: int) -> list[list[tuple[float, float]]]:
    """Return the lines of a text, each as (lon, lat) points; the reverse of `encode_lines`."""
    found: list[list[tuple[float, float]]] = []
    lon = lat = 0.0
    for line in text.split():
        points = decode_polyline(line, steps_per_degree)
        found.append([(x + lon, y + lat) for x, y in points])
        lon, lat = found[-1][0]
    return found


def decode_polyline(text: str, steps_per_degree: int) -> list[tuple[float, float]]:
    """Return the (lon, lat) points of an encoded line; the reverse of `encode_polyline`."""
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
