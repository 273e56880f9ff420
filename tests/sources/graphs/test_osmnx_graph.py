"""Graphs, GraphML and GeoPackages of OSMnx and answers of Overpass, as a truck sees them."""

import gzip
import hashlib
import json
import math

import networkx as nx
import osmnx
import pytest
import shapely
from places import SHARED as BESIDE
from small_osm import ROADS, as_overpass, as_xml, edge_between

from platoon_osm.errors import MapDataError, NetworkError, PlatoonError
from platoon_osm.sources.graphs.exchange import to_networkx
from platoon_osm.sources.graphs.graph_arrays import check_degrees, graph_arrays
from platoon_osm.sources.graphs.osmnx_graph import (
    network_from_osmnx,
    read_geopackage,
    read_graphml,
)
from platoon_osm.sources.overpass.answers import read_overpass_cache
from platoon_osm.sources.overpass.download import osmnx_settings
from platoon_osm.sources.truck import TruckRules

RULES = TruckRules("IT")
SHARED = BESIDE / "data" / "osm"


def make_graph(folder, simplify):
    file = folder / "small.osm"
    file.write_text(as_xml(), encoding="utf-8")
    with osmnx_settings(folder / "cache", 0, {}):
        return osmnx.graph_from_xml(file, simplify=simplify, retain_all=True)


@pytest.fixture
def raw(tmp_path):
    return make_graph(tmp_path, simplify=False)


@pytest.fixture
def simplified(tmp_path):
    return make_graph(tmp_path, simplify=True)


def assert_small_network(net):
    """Check what every way of reading the small map without simplification must give."""
    kmh = lambda u, v: net.speed_mps[edge_between(net, u, v)] * 3.6  # noqa: E731 (short beside its use)
    assert set(net.node_id.tolist()) == {1, 3, 5, 6, 7, 8, 9}
    assert net.m == 7
    assert kmh(1, 3) == pytest.approx(80)
    assert 60 < kmh(3, 5) < 70
    assert kmh(8, 7) == pytest.approx(80)
    assert (kmh(6, 9), kmh(9, 6)) == (pytest.approx(40), pytest.approx(50))
    v = net.node_id.tolist().index(3)
    assert (net.junction_name(v), net.texts[net.node_ref[v]]) == ("Verona Est", "12")
    assert net.junction_name(net.node_id.tolist().index(6)) == ""
    east = edge_between(net, 3, 5)
    assert (net.edge_ref(east), net.edge_name(east)) == ("A 4", "Serenissima")
    assert net.edge_name(edge_between(net, 3, 6)) == "Verona"
    assert net.toll[east]
    assert not net.toll[edge_between(net, 8, 7)]
    assert net.shape(east)[:, 0].tolist() == [11.02, 11.03, 11.04]
    assert net.way_id[edge_between(net, 1, 3)] == 101
    report = net.report()
    merged = report["nodes read"] - report["nodes after contracting chains"]
    assert (report["nodes contracted"] or merged) == 2
    assert report["speed capped for trucks"] >= 2
    assert report["speed defaulted from road class"] == 2
    assert net.source.licence == "ODbL 1.0"
    assert net.source.attribution == "© OpenStreetMap contributors"


def test_graph_in_memory(raw):
    net = network_from_osmnx(raw, ROADS, RULES)
    assert_small_network(net)
    report = net.report()
    assert report["edges dropped: closed to all by motor_vehicle"] == 2
    assert report["edges dropped: other road class"] == 2
    assert report["edges read"] == report["edges kept"] + 4
    assert net.source.name == "graph in memory"


def test_graphml(raw, tmp_path):
    file = tmp_path / "small.graphml"
    osmnx.io.save_graphml(raw, file)
    net = read_graphml(file, ROADS, RULES)
    assert_small_network(net)
    assert net.identity() == network_from_osmnx(raw, ROADS, RULES).identity()
    assert net.source.name == "small.graphml"
    assert net.source.sha256 == hashlib.sha256(file.read_bytes()).hexdigest()
    packed = tmp_path / "small.graphml.gz"
    packed.write_bytes(gzip.compress(file.read_bytes()))
    assert read_graphml(packed, ROADS, RULES).identity() == net.identity()


@pytest.mark.parametrize("directed", [True, False])
def test_geopackage(raw, tmp_path, directed):
    file = tmp_path / "small.gpkg"
    osmnx.io.save_graph_geopackage(raw, file, directed=directed)
    net = read_geopackage(file, ROADS, RULES)
    assert_small_network(net)
    assert len(net.source.sha256) == 64


def test_projected_geopackage_is_turned_back(raw, tmp_path):
    osmnx.io.save_graph_geopackage(
        osmnx.projection.project_graph(raw), tmp_path / "utm.gpkg", directed=True
    )
    net = read_geopackage(tmp_path / "utm.gpkg", ROADS, RULES)
    assert net.lon.min() == pytest.approx(11.0)
    assert net.length_m.sum() == pytest.approx(network_from_osmnx(raw, ROADS, RULES).length_m.sum())


def test_overpass_answer(tmp_path):
    file = tmp_path / "answer.json"
    file.write_text(json.dumps(as_overpass()), encoding="utf-8")
    net = read_overpass_cache(file, ROADS, RULES)
    assert_small_network(net)
    assert net.source.extracted == "2024-05-01T12:00:00Z"
    report = net.report()
    assert (report["ways of these classes"], report["ways kept"]) == (8, 7)
    assert report["ways dropped: closed to all by motor_vehicle"] == 1
    assert report["ways left out: other road class"] == 1


def test_all_forms_give_one_network(raw, tmp_path):
    file = tmp_path / "answer.json"
    file.write_text(json.dumps(as_overpass()), encoding="utf-8")
    overpass, graph = (
        {
            (int(net.node_id[u]), int(net.node_id[v])): (round(s, 9), round(x, 1))
            for u, v, s, x in zip(net.tail, net.head, net.speed_mps, net.length_m, strict=True)
        }
        for net in (read_overpass_cache(file, ROADS, RULES), network_from_osmnx(raw, ROADS, RULES))
    )
    assert overpass.keys() == graph.keys()
    for ends, (speed, length) in overpass.items():
        assert graph[ends][0] == pytest.approx(speed, rel=0.001)
        # OSMnx measures on a sphere, this package on the ellipsoid.
        assert graph[ends][1] == pytest.approx(length, rel=0.005)


def test_simplified_graph_takes_the_careful_value(simplified, tmp_path):
    assert any(isinstance(data["maxspeed"], list) for *_, data in simplified.edges(data=True)
               if "maxspeed" in data)  # fmt: skip
    net = network_from_osmnx(simplified, ROADS, RULES)
    # OSMnx has merged 1-2-3 with nothing, for 3 has a link, and 3-4-5 of 60 and 70 km/h.
    east = edge_between(net, 3, 5)
    assert net.speed_mps[east] * 3.6 == pytest.approx(60)
    assert net.shape(east)[:, 0].tolist() == [11.02, 11.03, 11.04]
    assert net.report()["edges with several speed limits, the lowest taken"] >= 1
    assert net.way_id[east] == 102
    file = tmp_path / "simplified.graphml"
    osmnx.io.save_graphml(simplified, file)
    assert read_graphml(file, ROADS, RULES).identity() == net.identity()


def test_lists_of_every_kind():
    graph = nx.MultiDiGraph(crs="epsg:4326")
    for node in range(3):
        graph.add_node(node, x=11.0 + node, y=45.0)
    common = {"oneway": True, "length": 10.0, "osmid": [9, 7]}
    graph.add_edge(
        0, 1, highway=["trunk", "motorway_link", "motorway"], ref=["E 70", "A 4"],
        toll=["no", "yes"], maxspeed=["signals", "70", "IT:motorway"], reversed=[True, False],
        **common,
    )  # fmt: skip
    graph.add_edge(1, 2, highway="motorway", motor_vehicle=["designated", "no"], **common)
    graph.add_edge(2, 1, highway="motorway", maxspeed="70|100;90", **common)
    graph.add_edge(1, 0, highway="motorway", toll=False, maxspeed="nan", **common)
    net = network_from_osmnx(graph, ("motorway_link", "motorway"), RULES)
    first, second, third = (edge_between(net, *ends) for ends in ((0, 1), (2, 1), (1, 0)))
    assert net.m == 3
    assert net.road_class[first] == 0
    assert (net.edge_ref(first), bool(net.toll[first])) == ("A 4;E 70", True)
    assert net.way_id[first] == 7
    assert [round(net.speed_mps[e] * 3.6) for e in (first, second, third)] == [70, 70, 80]
    assert not net.toll[third]
    report = net.report()
    assert report["edges of several classes, the most important taken"] == 1
    assert report["edges with several restrictions, the strictest taken"] == 1
    assert report["edges with toll on a part, taken for the whole"] == 1
    assert report["edges dropped: closed to all by motor_vehicle"] == 1


def test_two_way_motorway_of_osmnx_is_counted(raw):
    for u, v in ((1, 2), (2, 3)):
        raw.edges[u, v, 0]["oneway"] = False
        raw.add_edge(v, u, **raw.edges[u, v, 0])
    net = network_from_osmnx(raw, ROADS, RULES)
    edge_between(net, 3, 1)
    assert net.report()["motorway edges in both directions, as OSMnx has them"] == 4


def test_own_network_through_graphml(raw, tmp_path):
    net = network_from_osmnx(raw, ROADS, RULES)
    file = tmp_path / "own.graphml"
    osmnx.io.save_graphml(to_networkx(net), file)
    again = read_graphml(file, ROADS, RULES)
    assert again.length_m.tolist() == net.length_m.tolist()
    assert again.speed_mps.tolist() == pytest.approx(net.speed_mps.tolist(), rel=1e-9)
    assert again.toll.tolist() == net.toll.tolist()


def write(content):
    return lambda file: file.write_bytes(content)


def good_graphml():
    graph = nx.MultiDiGraph(crs="epsg:4326")
    graph.add_node(1, x="11.0", y="45.0")
    graph.add_node(2, x="11.1", y="45.0")
    graph.add_edge(1, 2, highway="motorway")
    return graph


def graphml(change):
    graph = good_graphml()
    change(graph)
    return "\n".join(nx.generate_graphml(graph)).encode()


def answer(**changes):
    return json.dumps({**as_overpass(), **changes}).encode()


BROKEN = [
    (read_graphml, b"", "not XML"),
    (read_graphml, b"\x00\x01 no xml", "not XML"),
    (read_graphml, as_xml().encode(), "not a GraphML graph"),
    (read_graphml, graphml(lambda _: None)[:-40], "not XML, or cut short"),
    (read_graphml, gzip.compress(b"<graphml>" * 50, mtime=0)[:-9], "gzip is cut short"),
    (read_graphml, graphml(lambda graph: graph.nodes[2].update(x="nan")), "node 2 lies at x nan"),
    (read_graphml, graphml(lambda graph: graph.nodes[2].pop("x")), "node 2 lies at x None"),
    (read_graphml, graphml(lambda graph: graph.graph.update(crs="epsg:32632")), "not in degrees"),
    (
        read_graphml,
        graphml(lambda graph: graph.edges[1, 2, 0].update(geometry="LINESTRING (x")),
        "no well-known text",
    ),
    (
        read_graphml,
        graphml(lambda graph: graph.edges[1, 2, 0].update(highway="path")),
        r"no road of class motorway.*found: path \(1\)",
    ),
    (read_graphml, graphml(lambda graph: graph.remove_edge(1, 2)), "found: no road at all"),
    (read_graphml, "\n".join(nx.generate_graphml(nx.path_graph(3))).encode(), "no direction"),
    (read_geopackage, b"", "not a GeoPackage"),
    (read_geopackage, b"SQLite format 3\x00 but no more", "not a GeoPackage"),
    (read_overpass_cache, b"", "not JSON"),
    (read_overpass_cache, answer()[:-30], "not JSON, or cut short"),
    (read_overpass_cache, b"\xff\xfe{", "not JSON"),
    (read_overpass_cache, b'[{"lat": "45", "lon": "11"}]', "not an Overpass answer"),
    (read_overpass_cache, b'{"elements": {}}', "not an Overpass answer"),
    (read_overpass_cache, answer(elements=[]), "found: no road at all"),
    (
        read_overpass_cache,
        answer(elements=[], remark="runtime error:\nQuery timed out"),
        "Overpass gave no data: runtime error: Query timed out",
    ),
    (
        read_overpass_cache,
        answer(elements=[{"type": "node", "id": 4, "lon": math.nan, "lat": 4.0}]),
        "node 4 lies at lon nan",
    ),
    (
        read_overpass_cache,
        answer(elements=[{"type": "way", "id": 4, "tags": {"highway": "motorway"}}]),
        "an element lacks its id",
    ),
    (
        read_overpass_cache,
        answer(
            elements=[{"type": "way", "id": 4, "nodes": [1, 2], "tags": {"highway": "motorway"}}]
        ),
        "nodes of its ways are missing",
    ),
]


@pytest.mark.parametrize(("read", "content", "said"), BROKEN)
def test_broken_files_say_what_and_where_in_one_line(tmp_path, read, content, said):
    file = tmp_path / "broken.file"
    file.write_bytes(content)
    with pytest.raises(MapDataError, match=said) as caught:
        read(file, ("motorway",), RULES)
    assert str(caught.value).startswith(str(file))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("read", [read_graphml, read_geopackage, read_overpass_cache])
def test_missing_file(tmp_path, read):
    with pytest.raises(MapDataError, match="cannot be read"):
        read(tmp_path / "nowhere", ROADS, RULES)


def test_geopackage_of_something_else(raw, tmp_path):
    nodes, edges = osmnx.convert.graph_to_gdfs(raw)
    nodes.to_file(tmp_path / "one.gpkg", layer="places")
    with pytest.raises(MapDataError, match="has the layers places, needs nodes and edges"):
        read_geopackage(tmp_path / "one.gpkg", ROADS, RULES)
    nodes.to_file(tmp_path / "two.gpkg", layer="nodes")
    edges[["geometry"]].reset_index().to_file(tmp_path / "two.gpkg", layer="edges")
    with pytest.raises(MapDataError, match="layer edges has no column highway"):
        read_geopackage(tmp_path / "two.gpkg", ROADS, RULES)


def test_closed_roads_only(raw):
    with pytest.raises(MapDataError, match=r"trucks may use \(1 are closed to them\)"):
        network_from_osmnx(raw.edge_subgraph([(5, 11, 0)]), ("motorway_link",), RULES)


def test_undirected_graph_is_refused(raw):
    with pytest.raises(NetworkError, match="no direction"):
        network_from_osmnx(osmnx.convert.to_undirected(raw), ROADS, RULES)


def test_cut_answer_still_loads_and_says_so(tmp_path):
    content = as_overpass()
    content["elements"] = [item for item in content["elements"] if item["id"] != 2]
    content["remark"] = "runtime error: out of memory"
    file = tmp_path / "answer.json"
    file.write_text(json.dumps(content), encoding="utf-8")
    net = read_overpass_cache(file, ROADS, RULES)
    assert net.report()["nodes missing from ways"] == 1
    assert net.report().remarks == ("Overpass remarked: runtime error: out of memory",)


def test_errors_are_the_packages_own():
    assert issubclass(MapDataError, PlatoonError)


def test_real_extract_against_osmnx(tmp_path):
    packed = SHARED / "north-bayreuth.osm.gz"
    if not packed.exists():
        pytest.skip(f"{packed.name} is not here")
    file = tmp_path / "north-bayreuth.osm"
    file.write_bytes(gzip.decompress(packed.read_bytes()))
    with osmnx_settings(tmp_path / "cache", 0, {}):
        graph = osmnx.graph_from_xml(file, simplify=False, retain_all=True)
    expected = sum(
        data["length"] for *_, data in graph.edges(data=True) if data.get("highway") == "motorway"
    )
    net = network_from_osmnx(graph, ("motorway",), TruckRules("DE"))
    assert expected > 5000
    assert net.length_m.sum() == pytest.approx(expected, rel=1e-9)
    assert net.m < net.report()["edges kept"] / 5
    assert net.speed_mps.max() * 3.6 == pytest.approx(80)
    assert "A 9" in {net.edge_ref(e) for e in range(net.m)}
    # The rest of the town would take OSMnx long to write and to simplify.
    graph = graph.edge_subgraph(
        [
            (u, v, k)
            for u, v, k, data in graph.edges(keys=True, data=True)
            if "motorway" in str(data.get("highway"))
        ]
    ).copy()
    osmnx.io.save_graphml(graph, tmp_path / "bayreuth.graphml")
    from_file = read_graphml(tmp_path / "bayreuth.graphml", ("motorway",), TruckRules("DE"))
    assert sorted(from_file.length_m) == pytest.approx(sorted(net.length_m), rel=1e-12)
    assert set(from_file.node_id) == set(net.node_id)
    simplified = network_from_osmnx(
        osmnx.simplification.simplify_graph(graph), ("motorway",), TruckRules("DE")
    )
    assert simplified.length_m.sum() == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize(
    "crs",
    [
        "{'init': 'epsg:4326'}", {"init": "epsg:4326"}, "+init=epsg:4326",
        "+proj=longlat +datum=WGS84 +no_defs", "urn:ogc:def:crs:OGC:1.3:CRS84", "OGC:CRS84",
    ],
)  # fmt: skip
def test_degrees_in_the_words_of_older_programs(crs):
    check_degrees(crs)


@pytest.mark.parametrize("crs", ["{'init': 'epsg:32632'}", "{broken", "+init=epsg:32632"])
def test_metres_stay_refused(crs):
    with pytest.raises(NetworkError, match="not in degrees"):
        check_degrees(crs)


def test_lines_that_other_programs_saved_as_several_parts():
    def drawn(geometry):
        nodes = [("a", {"x": 11.0, "y": 45.0}), ("b", {"x": 11.2, "y": 45.0})]
        return graph_arrays(nodes, [("a", "b", {"geometry": geometry})])

    one = shapely.MultiLineString([[(11.0, 45.0), (11.1, 45.1), (11.2, 45.0)]])
    two = shapely.MultiLineString([[(11.0, 45.0), (11.1, 45.1)], [(11.1, 45.1), (11.2, 45.0)]])
    for geometry in (one, two, two.wkt):
        assert drawn(geometry).shape_lon.tolist() == [11.0, 11.1, 11.2]
    apart = shapely.MultiLineString([[(11.0, 45.0), (11.1, 45.1)], [(11.15, 45.1), (11.2, 45.0)]])
    with pytest.raises(NetworkError, match="a MultiLineString as geometry"):
        drawn(apart)
