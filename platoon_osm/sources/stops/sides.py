"""Whether a road runs between two places: then they are not on the same side of it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["RoadSides"]

Floats = NDArray[np.float64]

CELL_DEG = 0.02
"""Side of the cells in which pieces of road are looked for; 300 m are less everywhere up to 80°."""


class RoadSides:
    """Pieces of road that have two sides.

    Parameters
    ----------
    ends : ndarray of float, (s, 4)
        Lon, lat, lon, lat of each piece [deg].
    """

    def __init__(self, ends: Floats) -> None:
        self._ends = ends

    def __call__(self, lines: Floats) -> NDArray[np.bool_]:
        """Tell which lines cross a road.

        Parameters
        ----------
        lines : ndarray of float, (k, 4)
            Lon, lat, lon, lat [deg], each a few hundred metres long.

        Returns
        -------
        ndarray of bool, (k,)
            Whether a piece of road crosses it.
        """
        near = self._near(lines)
        return np.array([_crosses(near, line) for line in lines], bool).reshape(len(lines))

    def _near(self, lines: Floats) -> Floats:
        """Return the pieces in cells beside those of the lines, and all that are long."""
        ends = self._ends
        cells = np.floor(lines / CELL_DEG).astype(np.int64)
        around = [
            _code(cells[:, i] + east, cells[:, j] + north)
            for i in (0, 2)
            for j in (1, 3)
            for east in (-1, 0, 1)
            for north in (-1, 0, 1)
        ]
        wanted = np.unique(np.concatenate(around)) if len(lines) else np.zeros(0, np.int64)
        own = np.floor(ends[:, :2] / CELL_DEG).astype(np.int64)
        long = np.abs(ends[:, 2:] - ends[:, :2]).max(1, initial=0.0) > CELL_DEG
        near: Floats = ends[long | np.isin(_code(own[:, 0], own[:, 1]), wanted)]
        return near


def _code(east: NDArray[np.int64], north: NDArray[np.int64]) -> NDArray[np.int64]:
    return east * 100_000 + north


def _crosses(ends: Floats, line: Floats) -> bool:
    ax, ay, bx, by = line
    low_x, high_x, low_y, high_y = min(ax, bx), max(ax, bx), min(ay, by), max(ay, by)
    cx, cy, dx, dy = ends.T
    near = (
        (np.minimum(cx, dx) <= high_x)
        & (np.maximum(cx, dx) >= low_x)
        & (np.minimum(cy, dy) <= high_y)
        & (np.maximum(cy, dy) >= low_y)
    )
    cx, cy, dx, dy = ends[near].T
    of_line = (_turn(ax, ay, bx, by, cx, cy) > 0) != (_turn(ax, ay, bx, by, dx, dy) > 0)
    of_piece = (_turn(cx, cy, dx, dy, ax, ay) > 0) != (_turn(cx, cy, dx, dy, bx, by) > 0)
    return bool((of_line & of_piece).any())


def _turn(px: Floats, py: Floats, qx: Floats, qy: Floats, rx: Floats, ry: Floats) -> Floats:
    turn: Floats = (qx - px) * (ry - py) - (qy - py) * (rx - px)
    return turn
