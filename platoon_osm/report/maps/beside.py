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

__all__ = ["TOLERANCE", "laid", "laid_beside", "shifted", "simplified"]

Floats = NDArray[np.float64]
Road = tuple[Sequence[Point], float]

TOLERANCE = 0.6
"""How far a line may move to be simpler, in pixels."""

ROUNDING = 2.0
"""How far to either side a road is rounded, in reaches of the outermost line beside it."""

STEP = 2.0
"""Between points of a rounded road, in pixels."""

RAMP, LEAST_RAMP = 2.5, 12.0
"""Half the length of a move aside, in widths of the move, and in pixels."""

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
    arcs = _arcs(road)
    ramps = _Ramps(arcs[borders], asides)
    reach = min(ROUNDING, arcs[-1] / max(reaches))
    rounding = [reach * one for one in reaches]
    at = _samples(arcs, ramps, rounding)
    half = ramps.along(at, rounding)
    middle, normals, owner = _with_normals(_rounded(road, arcs, at, half))
    aside = ramps.along(at, asides)[owner]
    return [_points(_beside(middle, normals, aside + offset)) for offset in offsets]


class _Ramps:
    """What changes from road to road, with gentle ramps between.

    Parameters
    ----------
    borders : array of float, (k - 1,)
        Where one road ends and the next begins, in pixels from the start.
    asides : sequence of float, k
        How far aside each road's line lies.
    """

    def __init__(self, borders: Floats, asides: Sequence[float]) -> None:
        moves = np.abs(np.diff(asides))
        self.borders = borders
        self.halves: Floats = np.maximum(LEAST_RAMP, RAMP * moves)
        self.moves = moves > 0

    def along(self, at: Floats, values: Sequence[float]) -> Floats:
        """Return a value of the roads at each place."""
        found = np.full(len(at), float(values[0]))
        for border, half, step in zip(self.borders, self.halves, np.diff(values), strict=True):
            if step:
                t = np.clip((at - border) / half, -1, 1)
                found += step * np.where(t < 0, (1 + t) ** 2 / 2, 1 - (1 - t) ** 2 / 2)
        return found


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


def _samples(arcs: Floats, ramps: _Ramps, rounding: Sequence[float]) -> Floats:
    """Return where points of the rounded road are needed: near its bends, and on ramps."""
    length = arcs[-1]
    grid = np.arange(STEP, length, STEP)
    half = ramps.along(grid, rounding)
    after = np.searchsorted(arcs, grid).clip(1, len(arcs) - 1)
    nearest = np.minimum(grid - arcs[after - 1], arcs[after] - grid)
    # The ends of a line are no bends.
    wanted = (nearest < half + STEP) & (half >= STEP / 2)
    for border, width, moves in zip(ramps.borders, ramps.halves, ramps.moves, strict=True):
        if moves:
            wanted |= np.abs(grid - border) < width + STEP
    sharp = arcs[ramps.along(arcs, rounding) < STEP / 2]
    return np.unique(np.concatenate([[0.0, length], grid[wanted], sharp]))


def _rounded(road: Floats, arcs: Floats, at: Floats, half: Floats) -> Floats:
    """Return the mean of a road around each place, with weights that fall off evenly to `half`."""
    # Mirrored in its ends, so that these stay where they are.
    reach = float(half.max(initial=0.0)) + STEP
    before = slice(1, int(np.searchsorted(arcs, reach)) + 1)
    behind = slice(int(np.searchsorted(arcs, arcs[-1] - reach)) - 1, -1)
    if behind.start < 0:
        behind = slice(0, -1)
    points = np.concatenate(
        [2 * road[0] - road[before][::-1], road, 2 * road[-1] - road[behind][::-1]]
    )
    places = np.concatenate([-arcs[before][::-1], arcs, 2 * arcs[-1] - arcs[behind][::-1]])
    # The mean is a second difference of the twofold integral of a piecewise linear line.
    origin = points.mean(axis=0)
    value = points - origin
    step = np.diff(places)[:, None]
    slope = np.diff(value, axis=0) / step
    zero = np.zeros((1, 2))
    once = np.concatenate([zero, np.cumsum(value[:-1] * step + slope * step**2 / 2, axis=0)])
    parts = once[:-1] * step + value[:-1] * step**2 / 2 + slope * step**3 / 6
    twice = np.concatenate([zero, np.cumsum(parts, axis=0)])

    def integral(where: Floats) -> Floats:
        k = (np.searchsorted(places, where, side="right") - 1).clip(0, len(step) - 1)
        u = (where - places[k])[:, None]
        found: Floats = twice[k] + once[k] * u + value[k] * u**2 / 2 + slope[k] * u**3 / 6
        return found

    h = np.maximum(half, 1.0)
    mean = (integral(at + h) - 2 * integral(at) + integral(at - h)) / h[:, None] ** 2
    k = (np.searchsorted(places, at, side="right") - 1).clip(0, len(step) - 1)
    exact = value[k] + slope[k] * (at - places[k])[:, None]
    result: Floats = np.where((half >= STEP / 2)[:, None], mean, exact) + origin
    return result


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
        arcs = _arcs(line)
        half = min(arcs[-1], 4 + float(np.abs(aside).max()) / 3)
        at = np.unique(np.concatenate([np.arange(0, arcs[-1], STEP), arcs[-1:]]))
        line = _rounded(line, arcs, at, np.full(len(at), half))
    return _thinned(line, FINE)


def _without_loops(line: Floats, most: float) -> Floats:
    """Cut a line short where it crosses itself within some length."""
    import shapely

    moved = np.ones(len(line), bool)
    moved[1:] = np.hypot(*np.diff(line, axis=0).T) > 1e-9
    line = line[moved]
    if len(line) < 4 or shapely.is_simple(shapely.linestrings(line)):
        return line
    arcs = _arcs(line)
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


def _arcs(line: Floats) -> Floats:
    """Return how far along a line each of its points lies."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])


def _thinned(line: Floats, tolerance: float) -> Floats:
    import shapely

    if len(line) < 3:
        return line
    simple = shapely.simplify(shapely.linestrings(line), tolerance, preserve_topology=False)
    result: Floats = shapely.get_coordinates(simple)
    return result


def _points(line: Floats) -> list[Point]:
    return [(float(x), float(y)) for x, y in line]
