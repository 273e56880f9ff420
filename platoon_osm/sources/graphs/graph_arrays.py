"""Nodes and edges of an OSMnx-style graph as the arrays that a road network is made of."""

from __future__ import annotations

import ast
from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import NetworkError
from ...network.geodesy import distance_m
from ...network.shapes import ragged_order, shape_lengths_m
from .graph_values import number, parts, whole_number

__all__ = ["Attributes", "EdgeRow", "GraphArrays", "check_degrees", "graph_arrays"]

Attributes = Mapping[str, Any]
EdgeRow = tuple[Hashable, Hashable, Attributes]

IN_DEGREES = frozenset(
    {"epsg:4326", "ogc:crs84", "wgs84", "urn:ogc:def:crs:ogc:1.3:crs84",
     "urn:ogc:def:crs:epsg::4326"}
)  # fmt: skip

Floats = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class GraphArrays:
    """The geometry of a graph; attributes named as in `RoadNetwork`, edges in the given order."""

    node_id: Index
    lon: Floats
    lat: Floats
    tail: Index
    head: Index
    length_m: Floats
    shape_first: Index
    shape_lon: Floats
    shape_lat: Floats


def check_degrees(crs: Any) -> None:
    """Refuse a graph whose coordinates are metres of a projection.

    Parameters
    ----------
    crs : object
        Name of a coordinate system.

    Raises
    ------
    NetworkError
        With the name of the system and the way back to degrees.
    """
    crs = _plain_crs(crs)
    if crs is None or str(crs).lower() in IN_DEGREES:
        return
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    try:
        geographic = CRS.from_user_input(crs).is_geographic
    except CRSError:
        geographic = False
    if not geographic:
        raise NetworkError(
            f"graph: coordinates are in {str(crs)[:60]!r}, not in degrees; turn them back with "
            "osmnx.projection.project_graph(graph, to_latlong=True)"
        )


def _plain_crs(crs: Any) -> Any:
    """Return a coordinate system without the ways in which older programs wrote it.

    OSMnx before 0.15 kept {'init': 'epsg:4326'}, which is a text in a file.
    """
    if isinstance(crs, str) and crs.strip().startswith("{"):
        try:
            crs = ast.literal_eval(crs.strip())
        except (ValueError, SyntaxError):
            return crs
    if isinstance(crs, dict) and set(crs) == {"init"}:
        crs = crs["init"]
    if isinstance(crs, str):
        return crs.strip().removeprefix("+init=").removeprefix("init=")
    return crs


def graph_arrays(
    nodes: Iterable[tuple[Hashable, Attributes]], edges: Sequence[EdgeRow]
) -> GraphArrays:
    """Read `x` and `y` of nodes and `length` and `geometry` of directed edges.

    A missing length [m] is that of the shape, a missing geometry the straight line. A geometry
    drawn from the end of the edge to its start is turned round.

    Parameters
    ----------
    nodes : iterable of tuple[Hashable, Attributes]
        Key and attributes of each.
    edges : sequence of EdgeRow
        Ends and attributes of each.

    Returns
    -------
    GraphArrays
        The geometry.

    Raises
    ------
    NetworkError
        A node without coordinates, an edge that ends at no node, a geometry that is no line or
        leaves the globe; with the node or edge in question.
    """
    keys, lon, lat, ids = _nodes(nodes)
    position = {key: i for i, key in enumerate(keys)}
    try:
        tail = np.fromiter((position[u] for u, _, _ in edges), np.int64, len(edges))
        head = np.fromiter((position[v] for _, v, _ in edges), np.int64, len(edges))
    except KeyError as error:
        raise NetworkError(
            f"graph: an edge ends at node {error.args[0]!r}, which is not among the nodes; "
            "add the node with its x and y, or leave the edge out"
        ) from error
    first, shape_lon, shape_lat = _shapes(edges, tail, head, lon, lat)
    length = np.fromiter((_length_m(edge) for edge in edges), np.float64, len(edges))
    missing = np.isnan(length)
    length[missing] = shape_lengths_m(first, shape_lon, shape_lat)[missing]
    return GraphArrays(ids, lon, lat, tail, head, length, first, shape_lon, shape_lat)


def _nodes(
    nodes: Iterable[tuple[Hashable, Attributes]],
) -> tuple[list[Hashable], Floats, Floats, Index]:
    keys: list[Hashable] = []
    lon: list[float] = []
    lat: list[float] = []
    ids: list[Any] = []
    for key, attributes in nodes:
        x, y = number(attributes.get("x")), number(attributes.get("y"))
        if x is None or y is None or not (abs(x) <= 180 and abs(y) <= 90):
            raise NetworkError(
                f"graph: node {key!r} lies at x {attributes.get('x')}, y {attributes.get('y')}; "
                "x must be its longitude and y its latitude in degrees"
            )
        keys.append(key)
        lon.append(x)
        lat.append(y)
        own_id = whole_number(attributes.get("node_id"))
        ids.append(key if own_id is None else own_id)
    return keys, np.array(lon, np.float64), np.array(lat, np.float64), _node_ids(ids)


def _node_ids(ids: list[Any]) -> Index:
    """Return OpenStreetMap ids; positions where nodes are named otherwise ("Torino", (0, 1))."""
    try:
        numbers = np.array(ids)
    except ValueError:
        return np.arange(len(ids), dtype=np.int64)
    # Anything but plain integers that fit becomes positions: an id must never be rounded.
    if len(ids) and numbers.ndim == 1 and numbers.dtype.kind == "i":
        return numbers.astype(np.int64)
    return np.arange(len(ids), dtype=np.int64)


def _length_m(edge: EdgeRow) -> float:
    length = number(edge[2].get("length"))
    if length is None and not parts(edge[2].get("length")):
        return float("nan")
    if length is None or not 0 <= length < float("inf"):
        raise NetworkError(
            f"graph: edge {edge[0]!r} -> {edge[1]!r} has length {edge[2]['length']!r:.40}; a "
            "length must be metres, finite and not below 0"
        )
    return length


def _shapes(
    edges: Sequence[EdgeRow], tail: Index, head: Index, lon: Floats, lat: Floats
) -> tuple[Index, Floats, Floats]:
    import shapely

    geometries = np.empty(len(edges), object)
    for i, (u, v, attributes) in enumerate(edges):
        geometry = attributes.get("geometry")
        if isinstance(geometry, str):
            try:
                geometry = shapely.from_wkt(geometry) if geometry else None
            except shapely.errors.ShapelyError as error:
                raise NetworkError(
                    f"graph: edge {u!r} -> {v!r} has a geometry that is no well-known text; "
                    "store a LINESTRING or leave it out"
                ) from error
        if getattr(geometry, "geom_type", "") == "MultiLineString":
            # What QGIS and ArcGIS save for a line; parts that follow each other are one, too.
            geometry = shapely.line_merge(geometry, directed=True)
        if geometry is not None and getattr(geometry, "geom_type", "") != "LineString":
            raise NetworkError(
                f"graph: edge {u!r} -> {v!r} has a {getattr(geometry, 'geom_type', geometry)!s:.40}"
                " as geometry; it must be one LineString, or none for a straight edge"
            )
        geometries[i] = geometry
    drawn = shapely.get_num_coordinates(geometries) >= 2
    size = np.where(drawn, shapely.get_num_coordinates(geometries), 2)
    first = np.zeros(len(edges) + 1, np.int64)
    np.cumsum(size, out=first[1:])
    from_geometry = np.repeat(drawn, size)
    shape_lon, shape_lat = np.empty(first[-1]), np.empty(first[-1])
    points = shapely.get_coordinates(geometries[drawn])
    shape_lon[from_geometry], shape_lat[from_geometry] = points[:, 0], points[:, 1]
    ends = np.column_stack([tail[~drawn], head[~drawn]]).ravel()
    shape_lon[~from_geometry], shape_lat[~from_geometry] = lon[ends], lat[ends]
    off_globe = ~((np.abs(shape_lon) <= 180) & (np.abs(shape_lat) <= 90))
    if off_globe.any():
        row = int(np.searchsorted(first, np.argmax(off_globe), side="right")) - 1
        raise NetworkError(
            f"graph: the geometry of edge {edges[row][0]!r} -> {edges[row][1]!r} leaves the globe; "
            "its points must be lon, lat in degrees"
        )
    return _along_the_edge(
        first, shape_lon, shape_lat, (lon[tail], lat[tail], lon[head], lat[head])
    )


def _along_the_edge(
    first: Index, shape_lon: Floats, shape_lat: Floats, ends: tuple[Floats, Floats, Floats, Floats]
) -> tuple[Index, Floats, Floats]:
    """Turn the shapes round that start at the edge's head and end at its tail."""
    tail_lon, tail_lat, head_lon, head_lat = ends
    start_lon, start_lat = shape_lon[first[:-1]], shape_lat[first[:-1]]
    stop_lon, stop_lat = shape_lon[first[1:] - 1], shape_lat[first[1:] - 1]
    as_drawn = distance_m(start_lon, start_lat, tail_lon, tail_lat) + distance_m(
        stop_lon, stop_lat, head_lon, head_lat
    )
    turned = distance_m(start_lon, start_lat, head_lon, head_lat) + distance_m(
        stop_lon, stop_lat, tail_lon, tail_lat
    )
    backwards = turned < as_drawn
    if not backwards.any():
        return first, shape_lon, shape_lat
    rows = np.arange(len(backwards))
    onward, _ = ragged_order(first, rows)
    reverse, _ = ragged_order(first, rows, backwards=True)
    order = np.where(np.repeat(backwards, np.diff(first)), reverse, onward)
    return first, shape_lon[order], shape_lat[order]
