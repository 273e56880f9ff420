"""The road network as an OSMnx-style graph or as GeoDataFrames, and back from a graph."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...errors import NetworkError
from ...network.load_report import LoadReport, Source
from ...network.road_network import ROAD_CLASSES, RoadNetwork
from .graph_arrays import EdgeRow, check_degrees, graph_arrays
from .graph_values import flag, joined, number, parts, whole_number

if TYPE_CHECKING:
    import geopandas
    import networkx

__all__ = [
    "directed_edges",
    "from_networkx",
    "graph_source",
    "to_geodataframes",
    "to_networkx",
    "way_id_of",
]

DEFAULT_SPEED_MPS = 80 / 3.6
JUNCTION = "motorway_junction"


def to_networkx(net: RoadNetwork) -> networkx.MultiDiGraph[int]:
    """Return the network in OSMnx's conventions.

    Nodes are keyed by their OpenStreetMap ids; if ids repeat, by position, with the id as
    `node_id`. Nodes have `x`, `y` [deg] and, where a junction is signed, `highway`, `name`, `ref`.
    Edges have `osmid`, `highway`, `ref`, `name`, `oneway` (always True: both directions are edges
    of their own), `maxspeed` [km/h, text], `length` [m], `speed_kph`, `travel_time` [s], `toll`,
    `inferred`, `geometry` where the edge is not straight, and two that make the way back exact:
    `edge_id` and `speed_mps`. Service areas and towns (`net.points`) have no place in a graph.
    """
    import networkx

    graph: networkx.MultiDiGraph[int] = networkx.MultiDiGraph(
        crs="epsg:4326", source=net.source.to_dict()
    )
    texts = list(net.texts)
    ids = net.node_id.tolist()
    unique = len(set(ids)) == net.n
    keys = ids if unique else list(range(net.n))
    for v, (key, x, y, name, ref) in enumerate(
        zip(
            keys, net.lon.tolist(), net.lat.tolist(), net.node_name.tolist(),
            net.node_ref.tolist(), strict=True,
        )
    ):  # fmt: skip
        signs = {"name": texts[name], "ref": texts[ref]} if name or ref else {}
        known = {label: text for label, text in signs.items() if text}
        if known:
            known["highway"] = JUNCTION
        graph.add_node(key, x=x, y=y, **({} if unique else {"node_id": ids[v]}), **known)
    geometries = _lines(net)
    drawn = _drawn(net)
    columns = zip(
        net.tail.tolist(), net.head.tolist(), net.length_m.tolist(), net.speed_mps.tolist(),
        net.road_class.tolist(), net.ref.tolist(), net.name.tolist(), net.toll.tolist(),
        net.inferred.tolist(), net.way_id.tolist(), drawn, geometries, strict=True,
    )  # fmt: skip
    for e, (u, v, length, speed, kind, ref, name, toll, inferred, way, curved, line) in enumerate(
        columns
    ):
        known = {"ref": texts[ref], "name": texts[name]}
        graph.add_edge(
            keys[u],
            keys[v],
            osmid=way,
            highway=ROAD_CLASSES[kind],
            **{label: text for label, text in known.items() if text},
            oneway=True,
            maxspeed=f"{speed * 3.6:.10g}",
            length=length,
            speed_kph=speed * 3.6,
            speed_mps=speed,
            travel_time=length / speed,
            toll=toll,
            inferred=inferred,
            edge_id=e,
            **({"geometry": line} if curved else {}),
        )
    return graph


def _lines(net: RoadNetwork) -> NDArray[np.object_]:
    """Return the shapes of all edges, (m,) LineStrings."""
    import shapely

    lines: NDArray[np.object_] = np.asarray(
        shapely.linestrings(
            np.column_stack([net.shape_lon, net.shape_lat]),
            indices=np.repeat(np.arange(net.m), np.diff(net.shape_first)),
        ),
        dtype=object,
    )
    return lines


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
    signs = [node if node.get("highway", JUNCTION) == JUNCTION else {} for _, node in nodes]
    report = LoadReport({"nodes read": len(nodes), "edges read": len(edges)})
    if defaulted := speeds.count(None):
        report = report.extended({"speed defaulted to 80 km/h": defaulted})
    return RoadNetwork.from_edges(
        arrays.tail,
        arrays.head,
        arrays.length_m,
        lon=arrays.lon,
        lat=arrays.lat,
        speed_mps=np.array(
            [DEFAULT_SPEED_MPS if speed is None else speed for speed in speeds], np.float64
        ),
        node_id=arrays.node_id,
        node_name=_strings([joined(node.get("name")) for node in signs]),
        node_ref=_strings([joined(node.get("ref")) for node in signs]),
        road_class=np.array([_class_code(item.get("highway")) for item in data], np.uint8),
        ref=_strings([joined(item.get("ref")) for item in data]),
        name=_strings([joined(item.get("name")) for item in data]),
        toll=np.array([flag(item.get("toll")) for item in data], np.bool_),
        inferred=np.array([flag(item.get("inferred")) for item in data], np.bool_),
        way_id=np.array([way_id_of(item.get("osmid")) for item in data], np.int64),
        shape_first=arrays.shape_first,
        shape_lon=arrays.shape_lon,
        shape_lat=arrays.shape_lat,
        source=graph_source(graph),
        report=report,
    )


def graph_source(graph: Any) -> Source:
    """Return the source that `to_networkx` noted in a graph, also after a trip through a file."""
    noted = next(iter(parts(graph.graph.get("source"))), None)
    if not isinstance(noted, dict):
        return Source("graph in memory")
    return Source(**{key: str(noted[key]) for key in Source().to_dict() if key in noted})


def _strings(column: Sequence[str]) -> Any:
    # As objects: numpy's own text type drops what follows a null character.
    return np.array(column, object)


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


def _class_code(highway: Any) -> int:
    """Return the most important class among the values; anything unknown is "other"."""
    codes = [ROAD_CLASSES.index(kind) for kind in parts(highway) if kind in ROAD_CLASSES]
    return min(codes, default=ROAD_CLASSES.index("other"))


def way_id_of(osmid: Any) -> int:
    """Return the lowest way id of an edge: simplified ones are made of several; 0 if none."""
    return whole_number(osmid) or 0


def to_geodataframes(
    net: RoadNetwork,
) -> tuple[geopandas.GeoDataFrame, geopandas.GeoDataFrame]:
    """Return nodes and edges as GeoDataFrames in EPSG:4326.

    Returns
    -------
    nodes : index `node` (position), columns `node_id`, `name`, `ref`, points.
    edges : index `edge_id`, columns `tail`, `head` (node positions), `tail_id`, `head_id`
        (OpenStreetMap ids), `highway`, `ref`, `name`, `length_m`, `speed_mps`, `toll`, `inferred`,
        `way_id`, lines.
    """
    import geopandas
    import shapely

    texts = np.array(list(net.texts), object)
    nodes = geopandas.GeoDataFrame(
        {"node_id": net.node_id, "name": texts[net.node_name], "ref": texts[net.node_ref]},
        geometry=shapely.points(net.lon, net.lat),
        crs="EPSG:4326",
    )
    nodes.index.name = "node"
    edges = geopandas.GeoDataFrame(
        {
            "tail": net.tail,
            "head": net.head,
            "tail_id": net.node_id[net.tail],
            "head_id": net.node_id[net.head],
            "highway": np.array(ROAD_CLASSES, object)[net.road_class],
            "ref": texts[net.ref],
            "name": texts[net.name],
            "length_m": net.length_m,
            "speed_mps": net.speed_mps,
            "toll": net.toll,
            "inferred": net.inferred,
            "way_id": net.way_id,
        },
        geometry=_lines(net),
        crs="EPSG:4326",
    )
    edges.index.name = "edge_id"
    return nodes, edges
