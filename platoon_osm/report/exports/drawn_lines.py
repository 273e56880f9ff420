"""Lines as other programs draw them: cut at the antimeridian, where they would cross the world."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...network.antimeridian import cut_at_antimeridian
from ...network.road_network import RoadNetwork
from .geopackage import Layer

__all__ = ["drawn_edges", "drawn_line", "line_layer"]


def drawn_line(points: ArrayLike) -> Any:
    """Return a line as a shapely geometry.

    Parameters
    ----------
    points : array_like of float, (k, 2)
        Longitude and latitude [deg].

    Returns
    -------
    shapely.LineString or shapely.MultiLineString
        The latter if it crosses the antimeridian.
    """
    import shapely

    pieces = [shapely.LineString(piece) for piece in cut_at_antimeridian(points)]
    return pieces[0] if len(pieces) == 1 else shapely.MultiLineString(pieces)


def drawn_edges(net: RoadNetwork) -> NDArray[Any]:
    """Return the lines of all edges of a network.

    Parameters
    ----------
    net : RoadNetwork
        Whose edges.

    Returns
    -------
    ndarray of object, (m,)
        As `drawn_line` makes them.
    """
    import shapely

    owner = np.repeat(np.arange(net.m), np.diff(net.shape_first))
    lines: Any = shapely.linestrings(net.shape_lon, net.shape_lat, indices=owner)
    jumps = np.flatnonzero(np.abs(np.diff(net.shape_lon)) > 180.0)
    for edge in np.unique(owner[jumps[owner[jumps] == owner[jumps + 1]]]).tolist():
        lines[edge] = drawn_line(net.shape(edge))
    return np.asarray(lines)


def line_layer(name: str, frame: Any) -> Layer:
    """Return a layer of lines, whole ones or, where one is cut, all as multiple lines.

    Parameters
    ----------
    name : str
        What it is called.
    frame : geopandas.GeoDataFrame
        Its rows.

    Returns
    -------
    Layer
        A layer holds one kind of shape.
    """
    import shapely

    if not (
        shapely.get_type_id(frame.geometry.values) == shapely.GeometryType.MULTILINESTRING
    ).any():
        return Layer(name, frame, "LineString")
    many = [shapely.MultiLineString(list(shapely.get_parts(shape))) for shape in frame.geometry]
    return Layer(name, frame.set_geometry(many, crs=frame.crs), "MultiLineString")
