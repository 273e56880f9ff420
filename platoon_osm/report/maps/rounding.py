"""A road rounded for what lies beside it: the mean of the road around each place."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

__all__ = ["STEP", "Ramps", "arcs_of", "rounded", "samples"]

Floats = NDArray[np.float64]

STEP = 2.0
"""Between points of a rounded road, in pixels."""

RAMP, LEAST_RAMP = 2.5, 12.0
"""Half the length of a move aside, in widths of the move, and in pixels."""


class Ramps:
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
        """Return a value of the roads at each place.

        Parameters
        ----------
        at : array of float, (n,)
            Pixels from the start.
        values : sequence of float, k
            Of each road.

        Returns
        -------
        array of float, (n,)
            That of the road, or between two near their border.
        """
        found = np.full(len(at), float(values[0]))
        for border, half, step in zip(self.borders, self.halves, np.diff(values), strict=True):
            if step:
                t = np.clip((at - border) / half, -1, 1)
                found += step * np.where(t < 0, (1 + t) ** 2 / 2, 1 - (1 - t) ** 2 / 2)
        return found


def samples(arcs: Floats, ramps: Ramps, rounding: Sequence[float]) -> Floats:
    """Return where points of the rounded road are needed: near its bends, and on ramps.

    Parameters
    ----------
    arcs : array of float, (n,)
        How far along the road each of its points lies, in pixels.
    ramps : Ramps
        Where lines beside it move over.
    rounding : sequence of float
        How far to either side each road is rounded, in pixels.

    Returns
    -------
    array of float, (m,)
        Pixels from the start, the ends among them.
    """
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


def rounded(road: Floats, arcs: Floats, at: Floats, half: Floats) -> Floats:
    """Return the mean of a road around each place, with weights that fall off evenly.

    Parameters
    ----------
    road : array of float, (n, 2)
        Its points in pixels.
    arcs : array of float, (n,)
        How far along the road each lies.
    at, half : array of float, (m,)
        Each place, and how far to either side the road counts there.

    Returns
    -------
    array of float, (m, 2)
        Its ends stay where they are.
    """
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


def arcs_of(line: Floats) -> Floats:
    """Return how far along a line each of its points lies.

    Parameters
    ----------
    line : array of float, (n, 2)
        Pixels.

    Returns
    -------
    array of float, (n,)
        From 0 on.
    """
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
