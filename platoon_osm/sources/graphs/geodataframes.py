"""The road network as tables of points and lines, for GeoPandas and GIS."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...network.columns import Column, columns_per
from ...network.road_network import RoadNetwork, checked_network

if TYPE_CHECKING:
    import geopandas

__all__ = ["ENDS", "LABELS", "edge_lines", "to_geodataframes"]

ENDS = ("tail", "head")

LABELS = {"road_class": "highway", "node_name": "name", "node_ref": "ref"}
"""Columns that tables and graphs call otherwise than a network."""


def to_geodataframes(
    net: RoadNetwork,
) -> tuple[geopandas.GeoDataFrame, geopandas.GeoDataFrame]:
    """Return nodes and edges as GeoDataFrames in EPSG:4326.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    nodes : GeoDataFrame
        Index `node` (position), columns `node_id`, `name`, `ref`, points.
    edges : GeoDataFrame
        Index `edge_id`, columns `tail`, `head` (node positions), `tail_id`, `head_id`
        (OpenStreetMap ids), `highway`, `ref`, `name`, `length_m`, `speed_mps`, `toll`,
        `inferred`, `climb_m`, `descent_m` and their like, `way_id`, lines.
    """
    import geopandas
    import shapely

    texts = list(checked_network(net).texts)
    nodes = geopandas.GeoDataFrame(
        {
            LABELS.get(column.name, column.name): _table_values(net, column, texts)
            for column in columns_per("node")
            if column.name not in {"lon", "lat"}
        },
        geometry=shapely.points(net.lon, net.lat),
        crs="EPSG:4326",
    )
    nodes.index.name = "node"
    # First between which nodes an edge runs and what road it is, then all else.
    first = [column for column in columns_per("edge") if column.name in ENDS]
    road = [column for column in columns_per("edge") if column.codes and column not in first]
    rest = [column for column in columns_per("edge") if column not in (*first, *road)]
    values: dict[str, Any] = {column.name: getattr(net, column.name) for column in first}
    values |= {f"{column.name}_id": net.node_id[values[column.name]] for column in first}
    values |= {
        LABELS.get(column.name, column.name): _table_values(net, column, texts)
        for column in (*road, *rest)
    }
    edges = geopandas.GeoDataFrame(values, geometry=edge_lines(net), crs="EPSG:4326")
    edges.index.name = "edge_id"
    return nodes, edges


def _table_values(net: RoadNetwork, column: Column, texts: list[str]) -> NDArray[Any]:
    values: NDArray[Any] = getattr(net, column.name)
    if not column.codes:
        return values
    names = np.array(texts if column.codes == "texts" else column.codes, object)
    named: NDArray[Any] = names[values]
    return named


def edge_lines(net: RoadNetwork) -> NDArray[np.object_]:
    """Return the shapes of all edges.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    ndarray of shapely.LineString, (m,)
        Lines from tail to head [deg].
    """
    import shapely

    lines: NDArray[np.object_] = np.asarray(
        shapely.linestrings(
            np.column_stack([net.shape_lon, net.shape_lat]),
            indices=np.repeat(np.arange(net.m), np.diff(net.shape_first)),
        ),
        dtype=object,
    )
    return lines
