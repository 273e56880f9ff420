"""Lines and rings cut to a frame.

Rings are cut by Sutherland and Hodgman's algorithm [1]_, one side of the frame after the other.
What was outside comes back as pieces of the frame's sides, walked to and fro, which a fill does not
see.

References
----------
.. [1] I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping", CACM 17(1), 1974.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Frame", "around_the_globe", "cut_lines", "cut_ring"]

Floats = NDArray[np.float64]


class Frame(NamedTuple):
    """A part of a plane, or of the world in degrees.

    Attributes
    ----------
    west, south, east, north : float
        Its sides.
    """

    west: float
    south: float
    east: float
    north: float

    def holds(self, other: Frame) -> bool:
        """Return whether all of another frame lies in this one.

        Parameters
        ----------
        other : Frame
            The other.

        Returns
        -------
        bool
            True where their sides touch, too.
        """
        return bool(
            self.west <= other.west
            and self.south <= other.south
            and self.east >= other.east
            and self.north >= other.north
        )


def cut_ring(ring: Floats, frame: Frame) -> Floats:
    """Return what of a ring's inside lies in a frame, as one ring.

    Parameters
    ----------
    ring : ndarray of float, (k, 2)
        The last point as the first.
    frame : Frame
        What is kept.

    Returns
    -------
    ndarray of float, (j, 2)
        The ring, run in the same sense, the last point as the first; empty if nothing is left.
    """
    west, south = ring.min(axis=0)
    east, north = ring.max(axis=0)
    if frame.holds(Frame(west, south, east, north)):
        return ring
    points = ring[:-1]
    for axis, bound, sign in (
        (0, frame.west, 1), (0, frame.east, -1), (1, frame.south, 1), (1, frame.north, -1),
    ):  # fmt: skip
        points = _one_side(points, axis, bound, sign)
        if not len(points):
            return np.zeros((0, 2))
    return np.vstack([points, points[:1]])


def _one_side(points: Floats, axis: int, bound: float, sign: int) -> Floats:
    """Return a ring, without its last point, cut at one line."""
    depth = sign * (points[:, axis] - bound)
    inside = depth >= 0
    if inside.all():
        return points
    before, inside_before = np.roll(points, 1, axis=0), np.roll(inside, 1)
    crossing = inside != inside_before
    depth_before = np.roll(depth, 1)
    share = np.zeros(len(points))
    share[crossing] = depth_before[crossing] / (depth_before[crossing] - depth[crossing])
    cuts = before + share[:, None] * (points - before)
    cuts[:, axis] = bound
    # Each point follows the cut on its way from the one before, if there is one.
    both = np.stack([cuts, points], axis=1).reshape(-1, 2)
    kept: Floats = both[np.column_stack([crossing, inside]).ravel()]
    return kept


def cut_lines(lines: Iterable[Floats], frame: Frame) -> list[Floats]:
    """Return what of some lines lies in a frame.

    Parameters
    ----------
    lines : iterable of ndarray of float, (k, 2)
        Lines.
    frame : Frame
        What is kept.

    Returns
    -------
    list of ndarray of float, (j, 2)
        Their pieces.
    """
    import shapely

    whole: list[Any] = [shapely.linestrings(line) for line in lines]
    cut = shapely.clip_by_rect(whole, *frame)
    return [
        shapely.get_coordinates(part)
        for part in shapely.get_parts(cut)
        if part.geom_type == "LineString" and not part.is_empty
    ]


def around_the_globe(
    lines: Sequence[Floats], boxes: Floats, frame: Frame, least: float = 0.0
) -> list[Floats]:
    """Return lines that may have a part in a frame, which may reach over the date line.

    Parameters
    ----------
    lines : sequence of ndarray of float, (k, 2)
        Longitude and latitude; n lines.
    boxes : ndarray of float, (n, 4)
        West, south, east and north of each.
    frame : Frame
        In degrees; its longitudes may lie beyond 180 on either side.
    least : float
        Lines whose box is no higher and no wider than this are left out [deg].

    Returns
    -------
    list of ndarray of float, (k, 2)
        The lines, moved round the globe where that brings them into the frame.
    """
    west, south, east, north = boxes.T
    found: list[Floats] = []
    large = np.maximum(east - west, north - south) > least
    for turn in (-360.0, 0.0, 360.0):
        met = large & (east + turn > frame.west) & (west + turn < frame.east)
        met &= (north > frame.south) & (south < frame.north)
        found += [
            lines[k] + (turn, 0.0) if turn else lines[k] for k in np.flatnonzero(met).tolist()
        ]
    return found
