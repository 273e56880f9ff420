"""Lines beside roads: parallel curves that neither jag nor loop where a road bends tightly.

A line that lies `aside` of its road cannot follow a bend tighter than that. So the road is first
rounded for what lies beside it: each point becomes the mean of the road around it, with weights
that fall off evenly to nothing at `ROUNDING` times the reach of the outermost line. All lines of a
band go by the same rounded road, and so stay parallel. Where a line moves over, from one measure to
another, it does so along a gentle ramp. What is then left of loops on the inside of a bend is cut
where the line crosses itself. `assets/beside.js` does the same in the browser.

Where the weights reach `h` to either side, a point moves by `h / 3` at most.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..drawing.lines import Point
from .rounding import STEP, Ramps, arcs_of, rounded, samples

__all__ = ["TOLERANCE", "laid", "laid_beside", "shifted", "simplified"]

Floats = NDArray[np.float64]
Road = tuple[Sequence[Point], float]

TOLERANCE = 0.6
"""How far a line may move to be simpler, in pixels."""

ROUNDING = 2.0
"""How far to either side a road is rounded, in reaches of the outermost line beside it."""

LOOP, LEAST_LOOP = 10.0, 24.0
"""Longest loop that is cut off, in measures aside, and in pixels."""

SHARP = 0.6
"""Turn from which on a corner is rounded [rad]."""

FINE = 0.2
"""How far a line may move to be simpler in the end, in pixels."""


def simplified(points: Sequence[Point], tolerance: float = TOLERANCE) -> list[Point]:
    """Return a line without points that make no difference.

    Parameters
    ----------
    points : sequence of tuple of float
        Pixels.
    tolerance : float
        How far the line may move, in pixels.

    Returns
    -------
    list of tuple of float
        Its ends, and what is needed between them.
    """
    if len(points) < 3 or not tolerance:
        return list(points)
    return _points(_thinned(np.asarray(points, np.float64), tolerance))


def shifted(points: Sequence[Point], aside: float) -> list[Point]:
    """Return a line moved to its right.

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
    return laid([(points, aside)])


def laid(roads: Sequence[Road]) -> list[Point]:
    """Return one line along roads, each moved to its right by its own measure.

    Parameters
    ----------
    roads : sequence of tuple
        For each road its points in pixels, and how far aside the line lies.

    Returns
    -------
    list of tuple of float
        The line in pixels.
    """
    return laid_beside(roads, (0.0,))[0]


def laid_beside(roads: Sequence[Road], offsets: Sequence[float]) -> list[list[Point]]:
    """Return lines that run beside one another along the same roads.

    Parameters
    ----------
    roads : sequence of tuple
        For each road its points in pixels, and how far aside the middle of the lines lies.
    offsets : sequence of float
        How far right of that middle each line lies, in pixels.

    Returns
    -------
    list of list of tuple of float
        A line for each offset.
    """
    road, borders = _joined([points for points, _ in roads])
    asides = [aside for _, aside in roads]
    reaches = [max(abs(aside + offset) for offset in offsets) for aside in asides]
    if len(road) < 2 or not max(reaches, default=0.0):
        return [_points(road) for _ in offsets]
    arcs = arcs_of(road)
    ramps = Ramps(arcs[borders], asides)
    reach = min(ROUNDING, arcs[-1] / max(reaches))
    rounding = [reach * one for one in reaches]
    at = samples(arcs, ramps, rounding)
    half = ramps.along(at, rounding)
    middle, normals, owner = _with_normals(rounded(road, arcs, at, half))
    aside = ramps.along(at, asides)[owner]
    return [_points(_beside(middle, normals, aside + offset)) for offset in offsets]


def _joined(roads: Sequence[Sequence[Point]]) -> tuple[Floats, NDArray[np.int64]]:
    """Return roads as one line, each simplified, and which of its points are ends of a road."""
    parts: list[Floats] = []
    borders: list[int] = []
    count = 0
    for number, points in enumerate(roads):
        flat = np.asarray(points, np.float64).reshape(-1, 2)
        if len(flat) > 2:
            flat = _thinned(flat, TOLERANCE)
        parts.append(flat)
        count += len(flat)
        if number < len(roads) - 1:
            borders.append(max(count - 1, 0))
    flat = np.concatenate(parts) if parts else np.zeros((0, 2))
    moved = np.ones(len(flat), bool)
    moved[1:] = (flat[1:] != flat[:-1]).any(axis=1)
    place = np.maximum(np.cumsum(moved) - 1, 0)
    return flat[moved], place[borders] if len(flat) else np.zeros(0, np.int64)


def _with_normals(line: Floats) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """Return points, what is right of each, and which point each was: several at a sharp corner."""
    index = np.arange(len(line))
    step = np.diff(line, axis=0)
    length = np.hypot(*step.T)
    kept = np.concatenate([[True], length > 1e-9])
    line, index = line[kept], index[kept]
    if len(line) < 2:
        return line, np.zeros_like(line), index
    heading = np.unwrap(np.arctan2(*np.diff(line, axis=0).T[::-1]))
    before = np.concatenate([heading[:1], heading])
    turn = np.concatenate([heading, heading[-1:]]) - before
    fan = np.where(np.abs(turn) > SHARP, np.ceil(np.abs(turn) / (SHARP / 2)), 0).astype(np.int64)
    owner = np.repeat(np.arange(len(line)), fan + 1)
    place = np.arange(len(owner)) - np.repeat(np.cumsum(fan + 1) - fan - 1, fan + 1)
    share = np.where(fan[owner] > 0, place / np.maximum(fan[owner], 1), 0.5)
    angle = before[owner] + turn[owner] * share
    return line[owner], np.column_stack([-np.sin(angle), np.cos(angle)]), index[owner]


def _beside(middle: Floats, normals: Floats, aside: Floats) -> Floats:
    """Return the line beside a road, without the loops of bends tighter than it is aside."""
    line = middle + aside[:, None] * normals
    if len(line) < 3 or not aside.any():
        return _thinned(line, FINE)
    right = normals[1:] + normals[:-1]
    along = np.column_stack([right[:, 1], -right[:, 0]])
    forward = (np.diff(line, axis=0) * along).sum(axis=1) >= 0
    # Where it runs backwards it is on the far side of the bend's centre.
    kept = np.concatenate([[True], forward]) | np.concatenate([forward, [True]])
    most = max(LEAST_LOOP, LOOP * float(np.abs(aside).max()))
    line = _without_loops(line[kept], most)
    turns = _turns(line)
    if turns.max(initial=0.0) > SHARP:
        arcs = arcs_of(line)
        half = min(arcs[-1], 4 + float(np.abs(aside).max()) / 3)
        at = np.unique(np.concatenate([np.arange(0, arcs[-1], STEP), arcs[-1:]]))
        line = rounded(line, arcs, at, np.full(len(at), half))
    return _thinned(line, FINE)


def _without_loops(line: Floats, most: float) -> Floats:
    """Cut a line short where it crosses itself within some length."""
    import shapely

    moved = np.ones(len(line), bool)
    moved[1:] = np.hypot(*np.diff(line, axis=0).T) > 1e-9
    line = line[moved]
    if len(line) < 4 or shapely.is_simple(shapely.linestrings(line)):
        return line
    arcs = arcs_of(line)
    step = np.diff(line, axis=0)
    pieces = shapely.linestrings(np.stack([line[:-1], line[1:]], axis=1))
    i, j = shapely.STRtree(np.asarray(pieces)).query(pieces, predicate="intersects")
    near = (j > i + 1) & (arcs[j] - arcs[i + 1] <= most)
    # The longest loop that begins on a piece goes.
    ends: dict[int, int] = {}
    for first, last in zip(i[near].tolist(), j[near].tolist(), strict=True):
        ends[first] = max(last, ends.get(first, 0))
    out: list[Floats] = []
    at = 0
    while at < len(line):
        out.append(line[at])
        end = ends.get(at)
        if end is None:
            at += 1
            continue
        area = _cross(step[at], step[end])
        if area:
            share = _cross(line[end] - line[at], step[end]) / area
            out.append(line[at] + step[at] * min(max(share, 0.0), 1.0))
        at = end + 1
    return np.array(out)


def _cross(a: Floats, b: Floats) -> float:
    return float(a[0] * b[1] - a[1] * b[0])


def _turns(line: Floats) -> Floats:
    heading = np.arctan2(*np.diff(line, axis=0).T[::-1])
    turn = np.diff(heading)
    result: Floats = np.abs((turn + np.pi) % (2 * np.pi) - np.pi)
    return result


def _thinned(line: Floats, tolerance: float) -> Floats:
    import shapely

    if len(line) < 3:
        return line
    simple = shapely.simplify(shapely.linestrings(line), tolerance, preserve_topology=False)
    result: Floats = shapely.get_coordinates(simple)
    return result


def _points(line: Floats) -> list[Point]:
    return [(float(x), float(y)) for x, y in line]
