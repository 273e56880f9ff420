"""The motorway network as a background: simplified, joined into long lines, encoded."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...network.geodesy import metres_per_degree
from ...network.road_network import RoadNetwork
from ...network.shapes import ragged_order
from .polyline import encode_lines, encode_polyline

__all__ = [
    "BASEMAP_STEPS", "ROUTE_STEPS", "basemap_lines", "encoded_basemap", "encoded_route",
    "metre_scale",
]  # fmt: skip

BASEMAP_STEPS = 10_000
"""Steps per degree of background lines: 11 m, finer than a screen shows of a country."""

ROUTE_STEPS = 100_000
"""Steps per degree of routes: 1 m, so that a reader may zoom in on a junction."""

BASEMAP_TOLERANCE_M = 20.0
ROUTE_TOLERANCE_M = 8.0


def encoded_basemap(net: RoadNetwork) -> dict[str, str]:
    """Return the network's lines, `known` from the map and `inferred` by the loader, encoded."""
    parts = {"known": ~net.inferred, "inferred": net.inferred}
    return {
        label: encode_lines(
            basemap_lines(net, np.flatnonzero(chosen), BASEMAP_TOLERANCE_M), BASEMAP_STEPS
        )
        for label, chosen in parts.items()
    }


def encoded_route(net: RoadNetwork, edges: tuple[int, ...]) -> str:
    """Return one encoded line along edges in driving order; empty text without edges."""
    if not edges:
        return ""
    points = net.path_shape(edges)
    import shapely

    scale = metre_scale(net)
    line = shapely.simplify(shapely.linestrings(points * scale), ROUTE_TOLERANCE_M)
    return encode_polyline(shapely.get_coordinates(line) / scale, ROUTE_STEPS)


def basemap_lines(
    net: RoadNetwork, edges: NDArray[np.int64], tolerance_m: float, directed: bool = False
) -> list[NDArray[np.float64]]:
    """Return the lines of some edges, each (k, 2) lon and lat.

    A road that carries two edges of one shape, there and back, is drawn once. Lines meeting where
    no third one does are joined, then simplified to within `tolerance_m` metres, ends kept. If
    `directed`, both ways are drawn, and lines run as they are driven.
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
    """Return metres per degree of longitude and latitude in the middle of the network."""
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
