"""Road networks from OSMnx: its graphs, and the GraphML and GeoPackage files it saves."""

from __future__ import annotations

import ast
import io
import os
import warnings
from collections.abc import Hashable, Iterable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree.ElementTree import ParseError

import numpy as np

from ...errors import MapDataError, NetworkError
from ...network.load_report import Source
from ...network.road_network import RoadNetwork
from ..country.roads import countries_of
from ..file_identity import file_digest, osm_source, read_bytes
from ..road_choice import RoadChoice, class_code
from ..truck import TruckRules
from .edge_tags import edge_class, truck_tags
from .exchange import directed_edges, graph_source, way_id_of
from .freight_graph import REMARK, as_tagged, freight_source, is_freight_graph
from .grades import edge_rises
from .graph_arrays import Attributes, EdgeRow, check_degrees, graph_arrays
from .graph_values import flag, joined, number
from .node_barriers import behind_barriers

if TYPE_CHECKING:
    import geopandas
    import networkx

__all__ = ["network_from_osmnx", "read_geopackage", "read_graphml"]

JUNCTION = "motorway_junction"

TURNS = (
    "turn restrictions: not in this kind of file; it keeps no relations, so forbidden turns were "
    "taken as open"
)


def network_from_osmnx(
    graph: networkx.DiGraph[Any],
    classes: Sequence[str],
    rules: TruckRules,
    source: Source | None = None,
) -> RoadNetwork:
    """Read a graph with OpenStreetMap tags on its edges as a truck sees it.

    Edges are used in the directions the graph has them. Where simplification left several values
    on one edge, the choice is the careful one: the most important class, the lowest `maxspeed`,
    closed if a part is closed, toll if a part costs toll; each is counted in the report. Barriers
    are read where nodes have them. Such a graph has no turn restrictions, which the report says.

    Parameters
    ----------
    graph : DiGraph
        MultiDiGraph of OSMnx, or a DiGraph like it, in degrees.
    classes : sequence of str
        Values of `highway` to keep.
    rules : TruckRules
        The truck.
    source : Source or None
        Identity to note; by default that of the graph.

    Returns
    -------
    RoadNetwork
        The network.

    Raises
    ------
    NetworkError
        No graph, edges without direction, or coordinates that are missing or projected.
    MapDataError
        No road of these classes.
    """
    edges = directed_edges(graph)
    check_degrees(graph.graph.get("crs"))
    if source is None:
        noted = graph_source(graph)
        source = noted if noted.sha256 or noted.licence else osm_source(noted.name)
    return _network(graph.nodes(data=True), edges, classes, rules, source)


def _file_source(graph: Any, name: str, digest: str) -> Source:
    """Return whose data a file holds: what the graph says of itself; else OpenStreetMap's."""
    told = graph.graph.get("source")
    with suppress(ValueError, SyntaxError, RecursionError, MemoryError):
        # GraphML keeps the record of a source as text.
        noted = ast.literal_eval(told) if isinstance(told, str) else told
        if isinstance(noted, dict) and noted.get("attribution"):
            credit = (str(noted.get(key, "")) for key in ("extracted", "licence", "attribution"))
            return Source(name, digest, *credit)
    return osm_source(name, digest)


def read_graphml(
    path: str | os.PathLike[str], classes: Sequence[str], rules: TruckRules
) -> RoadNetwork:
    """Read a GraphML file saved by OSMnx, or one of the ETISplus long-distance network.

    Parameters
    ----------
    path : path-like
        The file.
    classes : sequence of str
        Values of `highway` to keep.
    rules : TruckRules
        The truck and the law.

    Returns
    -------
    RoadNetwork
        The network.

    Raises
    ------
    MapDataError
        Not XML, not GraphML, cut short, without coordinates, or without a road of these classes.
    """
    import networkx

    file = Path(path)
    content, digest = read_bytes(file)
    try:
        with warnings.catch_warnings(record=True) as noticed:
            warnings.simplefilter("always")
            graph = networkx.read_graphml(io.BytesIO(content), force_multigraph=True)
    except ParseError as error:
        raise MapDataError(
            f"{file}: not XML, or cut short (line {error.position[0]}); save it again with "
            "osmnx.io.save_graphml"
        ) from error
    except (networkx.NetworkXError, ValueError, LookupError, TypeError, AttributeError) as error:
        raise MapDataError(
            f"{file}: not a GraphML graph; save one with osmnx.io.save_graphml"
        ) from error
    source, remarks = _file_source(graph, file.name, digest), _remarks(noticed)
    try:
        if is_freight_graph(graph):
            as_tagged(graph)
            # These files are all called graph.graphml, in a folder for each country.
            name = f"{file.absolute().parent.name}/{file.name}"
            source, remarks = freight_source(name, digest), (REMARK, *remarks)
        edges = directed_edges(graph)
        check_degrees(graph.graph.get("crs"))
        names = _node_keys(graph.nodes)
        return _network(
            [(names[key], data) for key, data in graph.nodes(data=True)],
            [(names[str(u)], names[str(v)], data) for u, v, data in edges],
            classes,
            rules,
            source,
            str(file),
            remarks,
        )
    except NetworkError as error:
        raise MapDataError(f"{file}: {error}") from error


def _node_keys(nodes: Iterable[str]) -> dict[str, Hashable]:
    """Return OpenStreetMap ids as the integers they are; other names stay."""
    keys = list(nodes)
    if all(key.removeprefix("-").isdecimal() for key in keys):
        return {key: int(key) for key in keys}
    return {key: key for key in keys}


def read_geopackage(
    path: str | os.PathLike[str], classes: Sequence[str], rules: TruckRules
) -> RoadNetwork:
    """Read a GeoPackage saved by OSMnx, with the layers `nodes` and `edges`.

    By default OSMnx saves two-way roads as one line (`directed=False`); they get both directions.
    Of two one-way roads drawn on the very same line it then saves only one.

    Parameters
    ----------
    path : path-like
        The file.
    classes : sequence of str
        Values of `highway` to keep.
    rules : TruckRules
        The truck and the law.

    Returns
    -------
    RoadNetwork
        The network.

    Raises
    ------
    MapDataError
        Not a GeoPackage, layers or columns missing, or no road of these classes.
    """
    import geopandas
    import pyogrio

    file = Path(path)
    remedy = "save it with osmnx.io.save_graph_geopackage"
    digest = file_digest(file)
    try:
        with warnings.catch_warnings(record=True) as noticed:
            warnings.simplefilter("always")
            layers = [str(name) for name in pyogrio.list_layers(file)[:, 0]]
            if not {"nodes", "edges"} <= set(layers):
                raise MapDataError(
                    f"{file}: has the layers {', '.join(layers) or '(none)'}, needs nodes and "
                    f"edges; {remedy}"
                )
            nodes, edges = (geopandas.read_file(file, layer=layer) for layer in ("nodes", "edges"))
    except (RuntimeError, ValueError, OSError) as error:
        raise MapDataError(f"{file}: not a GeoPackage, or damaged; {remedy}") from error
    for layer, table, needed in (
        ("nodes", nodes, {"osmid", "geometry"}),
        ("edges", edges, {"u", "v", "highway", "geometry"}),
    ):
        if missing := needed - set(table.columns):
            raise MapDataError(
                f"{file}: layer {layer} has no column {', '.join(sorted(missing))}; {remedy}"
            )
    try:
        return _network(
            _node_rows(nodes), _edge_rows(edges), classes, rules,
            osm_source(file.name, digest), str(file), _remarks(noticed),
        )  # fmt: skip
    except NetworkError as error:
        raise MapDataError(f"{file}: {error}") from error


def _remarks(noticed: Iterable[warnings.WarningMessage]) -> tuple[str, ...]:
    """Return what the reader of a file warned of, for the report."""
    told = dict.fromkeys(" ".join(str(item.message).split())[:200] for item in noticed)
    return tuple(f"reading the file: {text}" for text in list(told)[:10])


def _degrees(table: geopandas.GeoDataFrame) -> geopandas.GeoDataFrame:
    return table if table.crs is None else table.to_crs(4326)


def _node_rows(table: geopandas.GeoDataFrame) -> list[tuple[Hashable, Attributes]]:
    rows = _degrees(table).to_dict("records")
    for row in rows:
        point = row.pop("geometry")
        if getattr(point, "geom_type", "") == "Point" and not point.is_empty:
            row["x"], row["y"] = point.x, point.y
    return [(row["osmid"], row) for row in rows]


def _edge_rows(table: geopandas.GeoDataFrame) -> list[EdgeRow]:
    rows = _degrees(table).to_dict("records")
    if not {"from", "to"} <= set(table.columns):
        return [(row["u"], row["v"], row) for row in rows]
    directed: list[EdgeRow] = []
    for row in rows:
        directed.append((row["from"], row["to"], row))
        if not flag(row.get("oneway")):
            # The line is drawn from "from" to "to"; `graph_arrays` turns it round.
            back = {**row, "reversed": not flag(row.get("reversed"))}
            directed.append((row["to"], row["from"], back))
    return directed


def _network(
    nodes: Iterable[tuple[Hashable, Attributes]],
    edges: Sequence[EdgeRow],
    classes: Sequence[str],
    rules: TruckRules,
    source: Source,
    what: str = "graph",
    remarks: Sequence[str] = (),
) -> RoadNetwork:
    choice = RoadChoice(classes, rules, "edges")
    kept: list[EdgeRow] = []
    readings = []
    kinds: list[int] = []
    nodes = list(nodes)
    where = _countries(nodes, edges, rules)
    countries: list[str] = []
    for edge, country in zip(edges, where, strict=True):
        kind = edge_class(edge[2], choice)
        # Most edges of a city are of other classes: their tags need not be looked at.
        tags = truck_tags(edge[2], kind, choice) if kind in classes else {"highway": kind}
        reading = choice.read(tags, country)
        if reading is not None:
            kept.append(edge)
            readings.append(reading.against if tags.get("oneway") == "-1" else reading.along)
            kinds.append(class_code(kind))
            countries.append(country)
    choice.check_any(what)
    arrays = graph_arrays(nodes, kept)
    signs = [data if data.get("highway") == JUNCTION else {} for _, data in nodes]
    data = [attributes for _, _, attributes in kept]
    geometry: dict[str, Any] = {name: getattr(arrays, name) for name in arrays.__slots__}
    free = [
        length * side.toll_free if (own := number(item.get("toll_free_m"))) is None else own
        for item, side, length in zip(data, readings, arrays.length_m.tolist(), strict=True)
    ]
    restrictions = [
        joined(item.get("restriction")) or side.restriction
        for item, side in zip(data, readings, strict=True)
    ]
    geometry |= edge_rises(nodes, kept, arrays.length_m, choice.counts)
    net = RoadNetwork.from_edges(
        **geometry,
        toll_free_m=np.array(free, np.float64),
        speed_mps=np.array([reading.speed_kmh for reading in readings]) / 3.6,
        posted_mps=np.array([reading.posted_kmh for reading in readings]) / 3.6,
        restriction=np.array(
            behind_barriers(nodes, arrays.tail, arrays.head, restrictions, choice.counts), object
        ),
        country=np.array(countries, object),
        node_name=np.array([joined(sign.get("name")) for sign in signs], object),
        node_ref=np.array([joined(sign.get("ref")) for sign in signs], object),
        road_class=np.array(kinds, np.uint8),
        ref=np.array([joined(item.get("ref")) for item in data], object),
        name=np.array(
            [joined(item.get("name")) or joined(item.get("destination")) for item in data], object
        ),
        toll=np.array([reading.toll for reading in readings], np.bool_),
        inferred=np.array([flag(item.get("inferred")) for item in data], np.bool_),
        way_id=np.array([way_id_of(item.get("osmid")) for item in data], np.int64),
        source=source,
    )
    if not all("edge_id" in item for item in data):
        # Graphs that `to_networkx` made of a network have its turns as nodes and edges.
        remarks = (*remarks, TURNS)
    return choice.finished(net, np.array([bool(sign) for sign in signs], np.bool_), *remarks)


def _countries(
    nodes: Sequence[tuple[Hashable, Attributes]], edges: Sequence[EdgeRow], rules: TruckRules
) -> list[str]:
    """Return the country of each edge, by the node where it begins."""
    at = {key: (number(data.get("x")), number(data.get("y"))) for key, data in nodes}
    places = np.array([at.get(u, (None, None)) for u, _, _ in edges], np.float64).reshape(-1, 2)
    return countries_of(rules, places[:, 0], places[:, 1])
