"""The ground of one page: patches of the world, the coarse ones large and the fine ones small.

A reader may move and zoom a map anywhere, and a page must stay light. So the whole world lies
there coarsely, the surroundings of the network better, the network's own part better still, and
that of the plan once more if it is small. Each patch is as fine as its share of the weight allows.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from ..drawing.lines import Lines, Point
from .clipping import Frame, around_the_globe, cut_lines, cut_ring
from .model import Ground, GroundPatch
from .table import bundled_ground

__all__ = ["ground_under"]

Floats = NDArray[np.float64]

NORTHERNMOST = 85.0
"""Where the maps' projection ends [deg], north and south."""

MOST_POINTS = {"world": 450, "wide": 500, "near": 1_100, "plan": 700}
"""Points of land a patch may have, and half as many of borders, for the weight of a page."""

NEAR_MARGIN, WIDE_MARGIN, PLAN_MARGIN = 0.12, 0.75, 0.5
"""How far patches reach beyond network and plan, in shares of their larger side."""

LEAST_SIDE = 0.3
"""No patch but the world's is smaller [deg]."""

SMALL_PLAN = 0.4
"""A plan whose patch is smaller than this share of the network's has one of its own."""

WIDEST = 240.0
"""A network that reaches over more longitudes than this has the world alone [deg]."""

FINEST = 1 / 4_000
"""Lines leave their course by no less than this share of their patch's larger side."""

SMALLEST = 2.5
"""What is smaller than so many tolerances is left out whole."""

SAMPLE, LEAST_ON_LAND = 400, 0.6
"""Of so many of a network's nodes this share must lie on land, or its coordinates mean something
else than places on Earth, and a ground under it would be nonsense."""


def ground_under(net: RoadNetwork, stops: Sequence[Point]) -> Ground | None:
    """Return the ground under a network and a plan on it.

    Parameters
    ----------
    net : RoadNetwork
        Its nodes' coordinates are degrees on Earth, or made up.
    stops : sequence of tuple of float
        Longitude and latitude of the plan's starts and destinations.

    Returns
    -------
    Ground or None
        The patches; None for a network that does not lie on land.

    Raises
    ------
    NetworkError
        The table of coasts is damaged.
    """
    if not net.n:
        return None
    own = _box(np.column_stack([net.lon, net.lat]))
    near = _grown(own, NEAR_MARGIN)
    if own.east - own.west > WIDEST:
        patches = [_patch("world", _world(0.0))]
    else:
        centre = 30 * round((own.west + own.east) / 60)
        patches = [
            _patch("world", _world(float(centre))),
            _patch("wide", _grown(_square(own), WIDE_MARGIN)),
            _patch("near", near),
        ]
        if stops:
            plan = _grown(_box(np.array(stops)), PLAN_MARGIN)
            if _side(plan) < SMALL_PLAN * _side(near):
                patches.append(_patch("plan", plan))
    if _share_on_land(net, patches[-1] if len(patches) == 1 else patches[2]) < LEAST_ON_LAND:
        return None
    return Ground(tuple(patches))


# -- frames ----------------------------------------------------------------------------------------


def _box(points: Floats) -> Frame:
    west, south = points.min(axis=0).tolist()
    east, north = points.max(axis=0).tolist()
    return Frame(west, south, east, north)


def _wide_in_lat(frame: Frame) -> float:
    """Return how many degrees of longitude are as long as one of latitude."""
    middle = (abs(frame.south) + abs(frame.north)) / 2
    return 1 / max(math.cos(math.radians(min(middle, 80.0))), 0.1)


def _side(frame: Frame) -> float:
    """Return the larger side of a frame, in degrees of latitude."""
    return max((frame.east - frame.west) / _wide_in_lat(frame), frame.north - frame.south)


def _square(frame: Frame) -> Frame:
    half, wide = _side(frame) / 2, _wide_in_lat(frame)
    x, y = (frame.west + frame.east) / 2, (frame.south + frame.north) / 2
    return Frame(x - half * wide, y - half, x + half * wide, y + half)


def _grown(frame: Frame, share: float) -> Frame:
    """Return a frame with a margin, its sides on hundredths of a degree."""
    more, wide = max(share * _side(frame), LEAST_SIDE / 2), _wide_in_lat(frame)
    west, east = frame.west - more * wide, frame.east + more * wide
    if east - west > 360:
        west, east = (west + east) / 2 - 180, (west + east) / 2 + 180
    return Frame(
        math.floor(west * 100) / 100,
        max(math.floor((frame.south - more) * 100) / 100, -NORTHERNMOST),
        math.ceil(east * 100) / 100,
        min(math.ceil((frame.north + more) * 100) / 100, NORTHERNMOST),
    )


def _world(centre: float) -> Frame:
    return Frame(centre - 180, -NORTHERNMOST, centre + 180, NORTHERNMOST)


# -- patches ---------------------------------------------------------------------------------------


@cache
def _patch(kind: str, frame: Frame) -> GroundPatch:
    """Return what lies in a frame, as fine as its weight allows."""
    table = bundled_ground()
    finest = _side(frame) * FINEST
    least = finest * SMALLEST
    land = around_the_globe(table.land, table.land_boxes, frame, least)
    borders = around_the_globe(table.borders, table.border_boxes, frame, least)
    rings = [ring for line in land if len(ring := cut_ring(line, frame))]
    scale = np.array([1 / (1.0 if kind == "world" else _wide_in_lat(frame)), 1.0])
    most = MOST_POINTS[kind]
    tolerance, land = _within(most, rings, scale, finest)
    tolerance, lines = _within(most // 2, cut_lines(borders, frame), scale, tolerance)
    steps = max(math.ceil(2 / tolerance), 2)
    # A ring ends where it begins without being told.
    open_rings = [ring[:-1] for ring in land if len(ring) > 3]
    return GroundPatch(frame, steps, Lines.rounded(open_rings, steps), Lines.rounded(lines, steps))


def _within(
    most: int, lines: list[Floats], scale: Floats, finest: float
) -> tuple[float, list[Floats]]:
    """Return the finest tolerance at which lines have no more points, and the lines."""
    import shapely

    owner = np.repeat(np.arange(len(lines)), [len(line) for line in lines])
    kept: Any = shapely.linestrings(
        np.concatenate([*lines, np.zeros((0, 2))]) * scale, indices=owner
    )
    tolerance = finest
    while True:
        west, south, east, north = shapely.bounds(kept).reshape(-1, 4).T
        kept = kept[np.hypot(east - west, north - south) > SMALLEST * tolerance]
        kept = shapely.simplify(kept, tolerance, preserve_topology=False)
        if shapely.get_num_coordinates(kept).sum() <= most:
            return tolerance, [shapely.get_coordinates(line) / scale for line in kept]
        tolerance *= 1.25


def _share_on_land(net: RoadNetwork, patch: GroundPatch) -> float:
    """Return the share of a network's nodes that lie on land."""
    nodes = np.unique(np.linspace(0, net.n - 1, SAMPLE).astype(int))
    x, y = net.lon[nodes], net.lat[nodes]
    turns = np.zeros(len(nodes), int)
    for line in patch.land:
        ring = np.array(line.degrees())
        (x1, y1), (x2, y2) = ring.T, np.roll(ring, -1, axis=0).T
        with np.errstate(divide="ignore", invalid="ignore"):
            at = x1 + (y[:, None] - y1) / (y2 - y1) * (x2 - x1)
        right = at > x[:, None]
        up = (y1 <= y[:, None]) & (y[:, None] < y2) & right
        down = (y2 <= y[:, None]) & (y[:, None] < y1) & right
        turns += up.sum(axis=1) - down.sum(axis=1)
    return float((turns != 0).mean())
