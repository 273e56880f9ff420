"""Lines in pixels, written as paths."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from ..drawing.lines import Point
from .beside import laid_beside, simplified

__all__ = [
    "DrawnLine",
    "lines_along",
    "network_path",
    "path_data",
    "path_of",
]

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
    kept: dict[tuple[Point, ...], list[Point]] = {}
    for line in lines:
        points = [(float(round(x)), float(round(y))) for x, y in simplified(line)]
        if (
            not _near(points, width, height, beyond)
            or max(np.ptp(np.asarray(points), axis=0)) < 1.5
        ):
            continue
        # The other carriageway has nearly the same ends, a pixel or two apart.
        ends = tuple(sorted((round(x / 3), round(y / 3)) for x, y in (points[0], points[-1])))
        kept.setdefault(ends, points)
    # A dense network would outweigh all the rest of the page: its shortest lines stay out.
    longest = sorted(kept.values(), key=lambda line: -float(np.ptp(line, axis=0).sum()))
    room = most
    parts: list[str] = []
    for points in longest:
        parts.append(path_data(points))
        room -= len(parts[-1])
        if room < 0:
            break
    return "".join(parts)


def _near(points: Sequence[Point], width: float, height: float, beyond: float = 0.0) -> bool:
    xs, ys = zip(*points, strict=True)
    return bool(
        max(xs) > -beyond
        and min(xs) < width + beyond
        and max(ys) > -beyond
        and min(ys) < height + beyond
    )
