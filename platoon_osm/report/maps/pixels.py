"""Lines in pixels: simplified, moved aside, written as paths."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ..drawing.lines import Point

__all__ = [
    "DrawnLine",
    "laid",
    "lines_along",
    "network_path",
    "path_data",
    "path_of",
    "shifted",
    "simplified",
]

TOLERANCE = 0.6
"""How far a line may move to be simpler, in pixels."""

MOST_NETWORK_DATA = 80_000
"""Characters of path data that the still map spends on the background."""

SHORT = 12.0
"""Pixels of road that are too short for a place of their own."""


def path_data(points: Sequence[Point]) -> str:
    """Return a line to a tenth of a pixel, each step from the point before.

    Parameters
    ----------
    points : sequence of tuple of float
        Pixels.

    Returns
    -------
    str
        SVG path data.
    """
    tenths = [(round(x * 10), round(y * 10)) for x, y in points]
    (x0, y0), *rest = tenths
    out = [f"M{x0 / 10:g} {y0 / 10:g}l"]
    for x, y in rest:
        out.append(f"{(x - x0) / 10:g} {(y - y0) / 10:g} ")
        x0, y0 = x, y
    return "".join(out).rstrip()


def simplified(points: list[Point], tolerance: float = TOLERANCE) -> list[Point]:
    """Return a line without points that make no difference.

    Parameters
    ----------
    points : list of tuple of float
        Pixels.
    tolerance : float
        How far the line may move, in pixels.

    Returns
    -------
    list of tuple of float
        Its ends, and what is needed between them.
    """
    import shapely

    if len(points) < 3 or not tolerance:
        return points
    simple = shapely.simplify(shapely.linestrings(points), tolerance)
    return [(float(x), float(y)) for x, y in shapely.get_coordinates(simple)]


def shifted(points: Sequence[Point], aside: float) -> list[Point]:
    """Return a line moved to its right, corners mitred within limits.

    Parameters
    ----------
    points : sequence of tuple of float
        Pixels.
    aside : float
        How far, in pixels.

    Returns
    -------
    list of tuple of float
        The line moved.
    """
    if not aside or len(points) < 2:
        return list(points)
    flat = np.asarray(points)
    step = np.diff(flat, axis=0)
    step = step[np.hypot(*step.T) > 0]
    if not len(step):
        return list(points)
    keep = np.concatenate([[True], np.hypot(*np.diff(flat, axis=0).T) > 0])
    flat = flat[keep]
    normal = np.column_stack([-step[:, 1], step[:, 0]]) / np.hypot(*step.T)[:, None]
    before, after = np.vstack([normal[:1], normal]), np.vstack([normal, normal[-1:]])
    mitre = before + after
    # |mitre| = 2 cos(half the turn); beyond 120 degrees a mitre would run away.
    length = np.maximum((mitre**2).sum(axis=1), 1.0)
    moved = flat + aside * 2 * mitre / length[:, None]
    return [(float(x), float(y)) for x, y in moved]


def laid(roads: Sequence[tuple[Sequence[Point], float]]) -> list[Point]:
    """Return one line along roads, each moved to its right by its own measure.

    Roads too short to be seen follow their neighbour, or the line would start aside and back
    within a few pixels.

    Parameters
    ----------
    roads : sequence of tuple
        For each road its points in pixels, and how far aside the line lies.

    Returns
    -------
    list of tuple of float
        The line in pixels.
    """
    runs: list[tuple[list[Point], float, float]] = []
    for points, aside in roads:
        length = sum(math.dist(a, b) for a, b in pairwise(points))
        if runs:
            before, old, known = runs[-1]
            if aside == old or length < SHORT or known < SHORT:
                wider = aside if length > known else old
                runs[-1] = [*before, *points], wider, known + length
                continue
        runs.append((list(points), aside, length))
    # Loops of a ramp, tighter than the line is aside, would become stars.
    return [
        point
        for points, aside, _ in runs
        for point in shifted(simplified(points, abs(aside) / 5), aside)
    ]


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
    simple = [simplified(road) for road in roads]
    lines = (
        laid([(road, aside + offset) for road, aside in zip(simple, asides, strict=True)])
        for offset in offsets
    )
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
    lines: Iterable[list[Point]], width: float, height: float, most: int = MOST_NETWORK_DATA
) -> str:
    """Return the background: to half a pixel, twin carriageways once.

    Parameters
    ----------
    lines : iterable of list
        Their points in pixels.
    width, height : float
        Of the drawing.
    most : int
        About how many characters it may take.

    Returns
    -------
    str
        SVG path data.
    """
    kept: dict[tuple[Point, ...], list[Point]] = {}
    for line in lines:
        points = [(round(x * 2) / 2, round(y * 2) / 2) for x, y in simplified(line)]
        if not _near(points, width, height) or max(np.ptp(np.asarray(points), axis=0)) < 1.5:
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


def _near(points: Sequence[Point], width: float, height: float) -> bool:
    xs, ys = zip(*points, strict=True)
    return bool(max(xs) > 0 and min(xs) < width and max(ys) > 0 and min(ys) < height)
