"""The motorway network as a background, and routes on it: simplified, joined, rounded."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...network.antimeridian import continued_deg
from ...network.geodesy import metres_per_degree
from ...network.road_network import RoadNetwork
from ...network.shapes import ragged_order
from .lines import Line, Lines, Undirected

__all__ = [
    "BASEMAP_STEPS",
    "BASEMAP_TOLERANCE_M",
    "FAR_TOLERANCE_M",
    "NETWORK_STEPS",
    "ROUTE_STEPS",
    "ROUTE_TOLERANCE_M",
    "Frame",
    "basemap_lines",
    "metre_scale",
    "network_lines",
    "route_line",
]

BASEMAP_STEPS = 10_000
"""Steps per degree of places and of roads by traffic: 11 m."""

NETWORK_STEPS = 5_000
"""Steps per degree of the network in the background: 22 m, less than its lines are simplified."""

ROUTE_STEPS = 100_000
"""Steps per degree of routes: 1 m, so that a reader may zoom in on a junction."""

Frame = tuple[float, float, float, float]
"""West, south, east and north in degrees."""

BASEMAP_TOLERANCE_M = 45.0
FAR_TOLERANCE_M = 800.0
"""Of roads far from a plan, which are seen from afar only: half the text, and a pixel there."""

ROUTE_TOLERANCE_M = 8.0


def network_lines(net: RoadNetwork, near: Frame, *, inferred: bool) -> Lines:
    """Return the network as a background.

    Parameters
    ----------
    net : RoadNetwork
        What is drawn.
    near : Frame
        The part of it that is looked at closely; lines wholly outside follow their road coarsely.
    inferred : bool
        Whether the roads that the loader inferred are meant, or those known from the map.

    Returns
    -------
    Lines
        Simplified, joined and rounded.
    """
    import shapely

    chosen = np.flatnonzero(net.inferred if inferred else ~net.inferred)
    west, south, east, north = near
    scale = metre_scale(net)

    def drawn(line: NDArray[np.float64]) -> NDArray[np.float64]:
        (low_lon, low_lat), (high_lon, high_lat) = line.min(axis=0), line.max(axis=0)
        if low_lon <= east and high_lon >= west and low_lat <= north and high_lat >= south:
            return line
        coarse = shapely.simplify(shapely.linestrings(line * scale), FAR_TOLERANCE_M)
        return np.asarray(shapely.get_coordinates(coarse) / scale)

    lines = basemap_lines(net, chosen, BASEMAP_TOLERANCE_M)
    return Undirected.rounded(map(drawn, lines), NETWORK_STEPS)


def route_line(net: RoadNetwork, edges: tuple[int, ...]) -> Line:
    """Return one line along edges in driving order.

    Parameters
    ----------
    net : RoadNetwork
        Whose edges they are.
    edges : tuple of int
        Each begins where the one before ends.

    Returns
    -------
    Line
        Simplified and rounded; without points if there are no edges.
    """
    if not edges:
        return Line.rounded((), ROUTE_STEPS)
    points = net.path_shape(edges)
    points[:, 0] = continued_deg(points[:, 0])
    import shapely

    scale = metre_scale(net)
    line = shapely.simplify(shapely.linestrings(points * scale), ROUTE_TOLERANCE_M)
    return Line.rounded(shapely.get_coordinates(line) / scale, ROUTE_STEPS)


def basemap_lines(
    net: RoadNetwork, edges: NDArray[np.int64], tolerance_m: float, directed: bool = False
) -> list[NDArray[np.float64]]:
    """Return the lines of some edges, joined where no third one meets them, then simplified.

    A road that carries two edges of one shape, there and back, is drawn once, unless `directed`.

    Parameters
    ----------
    net : RoadNetwork
        Whose edges they are.
    edges : array of int, (k,)
        Edges to draw, each once.
    tolerance_m : float
        How far a line may leave its road [m]; its ends stay.
    directed : bool
        Whether both ways are drawn, and lines run as they are driven.

    Returns
    -------
    list of array of float, (k, 2)
        Longitude and latitude of each line in degrees.
    """
    import shapely

    single = edges if directed else _one_of_each_pair(net, edges)
    if not len(single):
        return []
    points, first = ragged_order(net.shape_first, single)
    scale = metre_scale(net)
    flat = np.column_stack([net.shape_lon[points], net.shape_lat[points]]) * scale
    owner = np.repeat(np.arange(len(single)), np.diff(first))
    lines: Any = shapely.linestrings(flat, indices=owner)
    merged = shapely.line_merge(shapely.multilinestrings(lines), directed=directed)
    simple = shapely.simplify(shapely.get_parts(merged), tolerance_m)
    return [shapely.get_coordinates(line) / scale for line in simple]


def metre_scale(net: RoadNetwork) -> NDArray[np.float64]:
    """Return metres per degree in the middle of a network.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    array of float, (2,)
        Along longitude and along latitude.
    """
    middle = float((net.lat.min() + net.lat.max()) / 2) if net.n else 0.0
    per_lon, per_lat = metres_per_degree(middle)
    return np.array([float(per_lon), float(per_lat)])


def _one_of_each_pair(net: RoadNetwork, edges: NDArray[np.int64]) -> NDArray[np.int64]:
    """Leave out edges whose shape another edge has too, in the same or the other direction."""
    # Two shapes are taken as one if they join the same nodes, have as many points and the same
    # middle: the sum of all coordinates is the same whichever way it is driven.
    if not len(edges):
        return edges
    low = np.minimum(net.tail[edges], net.head[edges])
    high = np.maximum(net.tail[edges], net.head[edges])
    points, first = ragged_order(net.shape_first, edges)
    sums = [
        np.rint(np.add.reduceat(values[points], first[:-1]) * 1e6).astype(np.int64)
        for values in (net.shape_lon, net.shape_lat)
    ]
    key = np.column_stack([low, high, np.diff(first), *sums])
    _, kept = np.unique(key, axis=0, return_index=True)
    result: NDArray[np.int64] = edges[np.sort(kept)]
    return result
