"""Lines as short text: Google's encoded polyline algorithm, at a precision of our choice.

References
----------
.. [1] https://developers.google.com/maps/documentation/utilities/polylinealgorithm
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

__all__ = ["decode_polyline", "encode_polyline"]


def encode_polyline(lonlat: ArrayLike, steps_per_degree: int) -> str:
    """Encode points, (k, 2) lon and lat in degrees, rounded to 1 / `steps_per_degree`.

    Latitude comes first in the text, as in [1]_. Points that round to the one before are left
    out, but a line keeps two points at least.
    """
    points = np.rint(np.asarray(lonlat, np.float64)[:, ::-1] * steps_per_degree).astype(np.int64)
    if len(points) > 2:
        moved = np.ones(len(points), bool)
        moved[1:] = (points[1:] != points[:-1]).any(axis=1)
        points = points[moved] if moved.sum() > 1 else points[:2]
    steps = np.diff(points, axis=0, prepend=np.zeros((1, 2), np.int64)).ravel()
    # The sign moves to the lowest bit, then five bits a character, lowest first.
    numbers = np.where(steps < 0, ~(steps << 1), steps << 1).tolist()
    out: list[str] = []
    for number in numbers:
        while number >= 0x20:
            out.append(chr((0x20 | (number & 0x1F)) + 63))
            number >>= 5
        out.append(chr(number + 63))
    return "".join(out)


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
