"""The road network as an OSMnx-style graph, and back."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...errors import NetworkError
from ...network.columns import Column, columns_per
from ...network.load_report import LoadReport, Source
from ...network.road_network import RoadNetwork, checked_network
from .geodataframes import ENDS, LABELS, edge_lines
from .graph_arrays import Attributes, EdgeRow, check_degrees, graph_arrays
from .graph_values import flag, joined, number, parts, whole_number

if TYPE_CHECKING:
    import networkx

__all__ = [
    "directed_edges",
    "from_networkx",
    "graph_source",
    "to_networkx",
    "way_id_of",
]

DEFAULT_SPEED_MPS = 80 / 3.6
JUNCTION = "motorway_junction"
PLACE = ("lon", "lat", "node_id")

GRAPH_NAMES = {**LABELS, "way_id": "osmid", "length_m": "length"}
"""Columns that OSMnx calls otherwise."""


def to_networkx(net: RoadNetwork) -> networkx.MultiDiGraph[int]:
    """Return the network in OSMnx's conventions.

    Nodes are keyed by their OpenStreetMap ids; if ids repeat, by position, with the id as
    `node_id`. Nodes have `x`, `y` [deg] and, where a junction is signed, `highway`, `name`, `ref`.
    Edges have `osmid`, `highway`, `ref`, `name`, `oneway` (always True: both directions are edges
    of their own), `maxspeed` [km/h, text], `length` [m], `speed_kph`, `travel_time` [s], `toll`,
    `inferred`, `climb_m`, `descent_m` and their like, `geometry` where the edge is not straight,
    and two that make the way back exact: `edge_id` and `speed_mps`. Service areas and towns
    (`net.points`) have no place in a graph.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    MultiDiGraph[int]
        The graph.
    """
    import networkx

    checked_network(net)
    graph: networkx.MultiDiGraph[int] = networkx.MultiDiGraph(
        crs="epsg:4326", source=net.source.to_dict()
    )
    texts = list(net.texts)
    ids = net.node_id.tolist()
    unique = len(set(ids)) == net.n
    keys = ids if unique else list(range(net.n))
    signs = _node_attributes(net, texts)
    for v, (key, x, y) in enumerate(zip(keys, net.lon.tolist(), net.lat.tolist(), strict=True)):
        graph.add_node(key, x=x, y=y, **({} if unique else {"node_id": ids[v]}), **signs[v])
    told = {
        GRAPH_NAMES.get(column.name, column.name): _told(net, column, texts)
        for column in columns_per("edge")
        if column.name not in ENDS
    }
    rows = zip(*told.values(), strict=True)
    geometries, drawn = edge_lines(net), _drawn(net)
    for e, (u, v, row) in enumerate(zip(net.tail.tolist(), net.head.tolist(), rows, strict=True)):
        known = {label: value for label, value in zip(told, row, strict=True) if value != ""}
        speed = known["speed_mps"]
        graph.add_edge(
            keys[u],
            keys[v],
            **known,
            oneway=True,
            maxspeed=f"{speed * 3.6:.10g}",
            speed_kph=speed * 3.6,
            travel_time=known["length"] / speed,
            edge_id=e,
            **({"geometry": geometries[e]} if drawn[e] else {}),
        )
    return graph


def _node_attributes(net: RoadNetwork, texts: list[str]) -> list[dict[str, Any]]:
    """Return what each node tells besides its place: its signs, if it has any."""
    attributes: list[dict[str, Any]] = [{} for _ in range(net.n)]
    for column in columns_per("node"):
        if column.name in PLACE:
            continue
        label = GRAPH_NAMES.get(column.name, column.name)
        for own, value in zip(attributes, _told(net, column, texts), strict=True):
            if value != "":
                own[label] = value
    for own in attributes:
        if "name" in own or "ref" in own:
            own["highway"] = JUNCTION
    return attributes


def _told(net: RoadNetwork, column: Column, texts: list[str]) -> list[Any]:
    """Return the values of a column as a graph has them: codes as what they stand for."""
    values: list[Any] = getattr(net, column.name).tolist()
    if not column.codes:
        return values
    names = texts if column.codes == "texts" else column.codes
    return [names[code] for code in values]


def _drawn(net: RoadNetwork) -> list[bool]:
    """Tell which edges need a geometry: those that are more than a line between their nodes."""
    start, stop = net.shape_first[:-1], net.shape_first[1:] - 1
    elsewhere = (
        (net.shape_lon[start] != net.lon[net.tail])
        | (net.shape_lat[start] != net.lat[net.tail])
        | (net.shape_lon[stop] != net.lon[net.head])
        | (net.shape_lat[stop] != net.lat[net.head])
    )
    curved: list[bool] = ((stop - start > 1) | elsewhere).tolist()
    return curved


def directed_edges(graph: Any) -> list[EdgeRow]:
    """Return the edges of a directed graph, in the order of `edge_id` if they have one.

    Parameters
    ----------
    graph : object
        The graph.

    Returns
    -------
    list of EdgeRow
        Ends and attributes of each edge.

    Raises
    ------
    NetworkError
        The object is no graph, or its edges have no direction.
    """
    if not hasattr(graph, "is_directed") or not hasattr(graph, "edges"):
        raise NetworkError(
            f"graph: a {type(graph).__name__} is not a networkx graph; give a MultiDiGraph or "
            "DiGraph whose nodes have x and y"
        )
    if not graph.is_directed():
        raise NetworkError(
            "graph: its edges have no direction, so one-way roads cannot be told; give the "
            "MultiDiGraph it was made from"
        )
    edges: list[tuple[Hashable, Hashable, dict[str, Any]]] = list(graph.edges(data=True))
    order = [number(data.get("edge_id")) for _, _, data in edges]
    # Two networks composed into one graph share ids: then the graph's own order is as good.
    if None not in order and len(set(order)) == len(order):
        ranked = sorted(range(len(edges)), key=lambda i: order[i] or 0.0)
        return [edges[i] for i in ranked]
    return list(edges)


def from_networkx(graph: networkx.DiGraph[Any]) -> RoadNetwork:
    """Read a directed graph whose nodes have `x` and `y` in degrees.

    Values are taken as they are, without a truck's view of them; for a graph straight from
    OpenStreetMap tags use `platoon_osm.sources.osmnx_graph.network_from_osmnx`. The speed is
    `speed_mps`, else `speed_kph`, else a numeric `maxspeed` [km/h], else 80 km/h, which is counted
    in the report. Node ids are kept if all are integers, else they are positions.

    Parameters
    ----------
    graph : DiGraph
        The graph.

    Returns
    -------
    RoadNetwork
        The network.

    Raises
    ------
    NetworkError
        Nodes without coordinates, projected coordinates, edges without direction, or a length or
        speed that cannot be one; with the node or edge.
    """
    edges = directed_edges(graph)
    check_degrees(graph.graph.get("crs"))
    nodes = list(graph.nodes(data=True))
    arrays = graph_arrays(nodes, edges)
    data = [attributes for _, _, attributes in edges]
    speeds = [_speed_mps(edge) for edge in edges]
    # A name without a junction is not that of a sign on the road.
    signs = [node if node.get("highway", JUNCTION) == JUNCTION else {} for _, node in nodes]
    columns: dict[str, Any] = {name: getattr(arrays, name) for name in arrays.__slots__}
    columns |= {
        column.name: _read(column, signs if column.codes == "texts" else [row[1] for row in nodes])
        for column in columns_per("node")
        if column.name not in PLACE
    }
    columns |= {
        column.name: _read(column, data)
        for column in columns_per("edge")
        if column.name not in {*ENDS, "length_m", "speed_mps"}
    }
    if not any("posted_mps" in row for row in data):
        del columns["posted_mps"]
    report = LoadReport({"nodes read": len(nodes), "edges read": len(edges)})
    if defaulted := speeds.count(None):
        report = report.extended({"speed defaulted to 80 km/h": defaulted})
    return RoadNetwork.from_edges(
        **columns,
        speed_mps=np.array(
            [DEFAULT_SPEED_MPS if speed is None else speed for speed in speeds], np.float64
        ),
        source=graph_source(graph),
        report=report,
    )


def _read(column: Column, rows: Sequence[Attributes]) -> NDArray[Any]:
    """Return a column from the attributes of nodes or edges, the default where they have none."""
    label = GRAPH_NAMES.get(column.name, column.name)
    values = [row.get(label) for row in rows]
    if column.codes == "texts":
        # As objects: numpy's own text type drops what follows a null character.
        return np.array([joined(value) for value in values], object)
    if isinstance(column.codes, tuple):
        return np.array([_code(column.codes, value) for value in values], column.dtype)
    if column.dtype == "b1":
        return np.array([flag(value) for value in values], np.bool_)
    given = [(number if "f" in column.dtype else whole_number)(value) for value in values]
    read = column.filled(len(given))
    for i, value in enumerate(given):
        if value is not None:
            read[i] = value
    return read


def graph_source(graph: Any) -> Source:
    """Return the source that `to_networkx` noted in a graph, also after a trip through a file.

    Parameters
    ----------
    graph : object
        The graph.

    Returns
    -------
    Source
        The identity.
    """
    noted = next(iter(parts(graph.graph.get("source"))), None)
    if not isinstance(noted, dict):
        return Source("graph in memory")
    return Source(**{key: str(noted[key]) for key in Source().to_dict() if key in noted})


def _speed_mps(edge: EdgeRow) -> float | None:
    u, v, data = edge
    for label, factor in (("speed_mps", 1.0), ("speed_kph", 3.6), ("maxspeed", 3.6)):
        value = number(data.get(label))
        if value is None:
            continue
        if not 0 < value < float("inf"):
            raise NetworkError(
                f"graph: edge {u!r} -> {v!r} has {label} {value}; a speed must be finite and "
                "above 0"
            )
        return value / factor
    return None


def _code(names: tuple[str, ...], value: Any) -> int:
    """Return the first of the names among the values, as classes go from the most important.

    Anything unknown is "other", or the last where there is none.
    """
    unknown = names.index("other") if "other" in names else len(names) - 1
    return min((names.index(part) for part in parts(value) if part in names), default=unknown)


def way_id_of(osmid: Any) -> int:
    """Return the lowest way id of an edge: simplified ones are made of several; 0 if none.

    Parameters
    ----------
    osmid : object
        One id or several.

    Returns
    -------
    int
        A way id.
    """
    return whole_number(osmid) or 0
