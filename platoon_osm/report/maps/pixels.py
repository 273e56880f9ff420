"""Lines in pixels, written as paths."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..drawing.lines import Point
from .beside import TOLERANCE, laid_beside, simplified

__all__ = [
    "DrawnLine",
    "lines_along",
    "network_data",
    "network_path",
    "path_data",
    "path_of",
]

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_NETWORK_DATA = 80_000
"""Characters of path data that the still map spends on the background."""


def path_data(points: Sequence[Point]) -> str:
    """Return a line to a tenth of a pixel, each step from the point before.

    Parameters
    ----------
    points : sequence of tuple of float
        Pixels.

    Returns
    -------
    str
        SVG path data; empty for a line shrunk to a point.
    """
    tenths = [(round(x * 10), round(y * 10)) for x, y in points]
    (x0, y0), *rest = tenths
    if not rest:
        return ""
    out = [f"M{x0 / 10:g} {y0 / 10:g}l"]
    for x, y in rest:
        out += [_number(x - x0), _number(y - y0)]
        x0, y0 = x, y
    # A minus parts two numbers as a blank does.
    return "".join(out).replace("l ", "l").replace(" -", "-")


def _number(tenths: int) -> str:
    """Return a number after a blank, without the zero before its point."""
    return f" {tenths / 10:g}".replace("0.", ".") if abs(tenths) < 10 else f" {tenths / 10:g}"


class DrawnLine(NamedTuple):
    """A line as it is drawn.

    Attributes
    ----------
    points : list of tuple of float
        Its pixels.
    path : str
        The same as SVG path data.
    """

    points: list[Point]
    path: str


def lines_along(
    roads: Sequence[list[Point]], asides: Sequence[float], offsets: Sequence[float] = (0.0,)
) -> list[DrawnLine]:
    """Return lines that run beside one another along the same roads.

    Parameters
    ----------
    roads : sequence of list
        The points of each road in pixels.
    asides : sequence of float
        How far right of each road the middle of the lines lies.
    offsets : sequence of float
        How far right of that middle each line lies.

    Returns
    -------
    list of DrawnLine
        One for each offset.
    """
    lines = laid_beside(list(zip(roads, asides, strict=True)), offsets)
    return [DrawnLine(points, path_data(points)) for points in lines]


def path_of(lines: Iterable[list[Point]], width: float, height: float) -> str:
    """Return those lines that come near the drawing.

    Parameters
    ----------
    lines : iterable of list
        Their points in pixels.
    width, height : float
        Of the drawing.

    Returns
    -------
    str
        SVG path data.
    """
    kept = (simplified(line) for line in lines)
    return "".join(path_data(points) for points in kept if _near(points, width, height))


def network_path(
    lines: Iterable[list[Point]],
    width: float,
    height: float,
    most: int = MOST_NETWORK_DATA,
    beyond: float = 0.0,
) -> str:
    """Return the background: to whole pixels, twin carriageways once.

    Parameters
    ----------
    lines : iterable of list
        Their points in pixels.
    width, height : float
        Of the drawing.
    most : int
        About how many characters it may take.
    beyond : float
        How far beyond the edges of the drawing it reaches, in pixels.

    Returns
    -------
    str
        SVG path data.
    """
    some = [line for line in lines if len(line) > 1]
    points = np.array([at for line in some for at in line], np.float64).reshape(-1, 2)
    return network_data(points, np.array([len(line) for line in some]), width, height, most, beyond)


def network_data(
    points: Floats, sizes: Ints, width: float, height: float, most: int, beyond: float = 0.0
) -> str:
    """Return the background of lines that stand one after another: see `network_path`.

    Parameters
    ----------
    points : ndarray of float, (P, 2)
        Pixels.
    sizes : ndarray of int64, (L,)
        Points of each line, two or more.
    width, height : float
        Of the drawing.
    most : int
        About how many characters it may take.
    beyond : float
        How far beyond the edges of the drawing it reaches, in pixels.

    Returns
    -------
    str
        SVG path data.
    """
    import shapely

    # Rounding moves a line by half a pixel at most, and a simpler one lies in the same frame.
    points, sizes = _drawn(points, sizes, (width, height), beyond + 1.0, 0.25)
    if not len(sizes):
        return ""
    owner = np.repeat(np.arange(len(sizes)), sizes)
    simple: Any = shapely.simplify(
        shapely.linestrings(points, indices=owner), TOLERANCE, preserve_topology=False
    )
    sizes = shapely.get_num_coordinates(simple)
    points = np.rint(shapely.get_coordinates(simple))
    points, sizes = _drawn(points, sizes[sizes > 0], (width, height), beyond, 1.5)
    kept: dict[tuple[Point, ...], list[Point]] = {}
    ends = np.cumsum(sizes)
    for end, size in zip(ends.tolist(), sizes.tolist(), strict=True):
        line = [(x, y) for x, y in points[end - size : end].tolist()]
        # The other carriageway has nearly the same ends, a pixel or two apart.
        key = tuple(sorted((round(x / 3), round(y / 3)) for x, y in (line[0], line[-1])))
        kept.setdefault(key, line)
    # A dense network would outweigh all the rest of the page: its shortest lines stay out.
    longest = sorted(kept.values(), key=lambda line: -float(np.ptp(line, axis=0).sum()))
    room = most
    parts: list[str] = []
    for line in longest:
        parts.append(path_data(line))
        room -= len(parts[-1])
        if room < 0:
            break
    return "".join(parts)


def _drawn(
    points: Floats, sizes: Ints, size: tuple[float, float], beyond: float, least: float
) -> tuple[Floats, Ints]:
    """Return lines that come near the drawing and are at least so long in x or y."""
    if not len(sizes):
        return points, sizes
    first = np.cumsum(sizes) - sizes
    low, high = np.minimum.reduceat(points, first), np.maximum.reduceat(points, first)
    kept = (high > -beyond).all(axis=1) & (low < np.array(size) + beyond).all(axis=1)
    kept &= (high - low).max(axis=1) >= least
    return points[np.repeat(kept, sizes)], sizes[kept]


def _near(points: Sequence[Point], width: float, height: float) -> bool:
    xs, ys = zip(*points, strict=True)
    return bool(max(xs) > 0 and min(xs) < width and max(ys) > 0 and min(ys) < height)
