"""The points of roads nearest to a place, for all edges near it at once.

Distances are those on a plane true to scale at the place, which is exact enough as far as a truck
may be from a road. Longitudes are counted from the place, so that roads meet across the date line.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .antimeridian import wrapped_deg
from .geodesy import metres_per_degree
from .road_network import RoadNetwork
from .shapes import ragged_order

__all__ = ["DEGREE_M", "RoadPoints", "points_along", "road_points"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

NEAR_DEG = 0.05
"""Roads are looked for within so much latitude first, 5.5 km, and only then everywhere."""

DEGREE_M = 110_000.0
"""A degree of latitude is longer than this everywhere."""


@dataclass(frozen=True, slots=True, eq=False)
class RoadPoints:
    """The nearest point of each of some edges to one place.

    Attributes
    ----------
    edges : ndarray of int64, (k,)
        Edge ids, ascending.
    share : ndarray of float, (k,)
        How much of the edge, by length, lies before the point.
    away_m : ndarray of float, (k,)
        How far the point is [m].
    """

    edges: Index
    share: Floats
    away_m: Floats


class _Latitudes:
    """How far south and north each edge reaches; kept with the network by `net.attached`."""

    def __init__(self, net: RoadNetwork) -> None:
        first = net.shape_first[:-1]
        empty = np.zeros(0)
        self.south = np.minimum.reduceat(net.shape_lat, first) if net.m else empty
        self.north = np.maximum.reduceat(net.shape_lat, first) if net.m else empty


def road_points(net: RoadNetwork, usable: NDArray[np.bool_], lon: float, lat: float) -> RoadPoints:
    """Return the nearest points of the roads near a place.

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    usable : ndarray of bool, (m,)
        Edges that are meant.
    lon, lat : float
        The place [deg].

    Returns
    -------
    RoadPoints
        Of all usable edges that come near the place; where none does, of all. So the nearest edge
        is always among them, with every other that is less than some kilometres away.
    """
    reach = net.attached(_Latitudes)
    near = usable & (reach.south <= lat + NEAR_DEG) & (reach.north >= lat - NEAR_DEG)
    found = _nearest(net, np.flatnonzero(near), lon, lat)
    if len(found.edges) and found.away_m.min() <= NEAR_DEG * DEGREE_M:
        return found
    return _nearest(net, np.flatnonzero(usable), lon, lat)


def _nearest(net: RoadNetwork, edges: Index, lon: float, lat: float) -> RoadPoints:
    if not len(edges):
        return RoadPoints(edges, np.zeros(0), np.zeros(0))
    points, first = ragged_order(net.shape_first, edges)
    per_lon, per_lat = metres_per_degree(lat)
    x = wrapped_deg(net.shape_lon[points] - lon) * per_lon
    y = (net.shape_lat[points] - lat) * per_lat
    dx, dy = wrapped_deg(np.diff(net.shape_lon[points])) * per_lon, np.diff(y)
    joint = first[1:-1] - 1
    dx[joint] = dy[joint] = 0.0
    square = dx**2 + dy**2
    part = np.divide(-(x[:-1] * dx + y[:-1] * dy), square, out=np.zeros_like(dx), where=square > 0)
    part = np.clip(part, 0.0, 1.0)
    away = np.hypot(x[:-1] + part * dx, y[:-1] + part * dy)
    # An edge has one point more than straight pieces: the last "piece" is its last point alone.
    away = np.append(away, np.hypot(x[-1], y[-1]))
    least = np.minimum.reduceat(away, first[:-1])
    # The first piece that is as near as the nearest one.
    owner = np.repeat(np.arange(len(edges)), np.diff(first))
    hit = np.flatnonzero(away == least[owner])
    _, place = np.unique(owner[hit], return_index=True)
    piece = hit[place]
    step = np.append(np.sqrt(square), 0.0)
    before = np.concatenate([[0.0], np.cumsum(step)])
    begin, total = before[first[:-1]], before[first[1:]] - before[first[:-1]]
    along = before[piece] - begin + np.append(part, 0.0)[piece] * step[piece]
    share = np.divide(along, total, out=np.zeros_like(total), where=total > 0)
    return RoadPoints(edges, np.clip(share, 0.0, 1.0), least)


def points_along(shape: Floats, shares: Floats) -> tuple[Floats, Floats]:
    """Return points of a line by the share of its length before them.

    Parameters
    ----------
    shape : ndarray of float, (k, 2)
        Longitude and latitude [deg].
    shares : ndarray of float, (c,)
        Between 0 and 1.

    Returns
    -------
    points : ndarray of float, (c, 2)
        Longitude and latitude [deg].
    position : ndarray of float, (c,)
        Where in the line they lie: 2.25 is a quarter of the way from point 2 to point 3.
    """
    per_lon, _ = metres_per_degree(shape[:, 1])
    _, per_lat = metres_per_degree(shape[:, 1])
    east = wrapped_deg(np.diff(shape[:, 0])) * (per_lon[1:] + per_lon[:-1]) / 2
    north = np.diff(shape[:, 1]) * (per_lat[1:] + per_lat[:-1]) / 2
    before = np.concatenate([[0.0], np.cumsum(np.hypot(east, north))])
    position = np.interp(shares * before[-1], before, np.arange(len(shape), dtype=np.float64))
    piece = np.clip(position.astype(np.int64), 0, len(shape) - 2)
    part = (position - piece)[:, None]
    step = np.diff(shape, axis=0)
    step[:, 0] = wrapped_deg(step[:, 0])
    points = shape[piece] + part * step[piece]
    points[:, 0] = wrapped_deg(points[:, 0])
    return points, position
