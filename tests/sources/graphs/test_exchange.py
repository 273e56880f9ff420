"""The network as an OSMnx graph, as GeoDataFrames, and back without loss."""

import math

import geopandas
import networkx as nx
import numpy as np
import osmnx
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.errors import NetworkError
from platoon_osm.network.load_report import Source
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.sources.graphs.exchange import from_networkx, to_networkx
from platoon_osm.sources.graphs.geodataframes import to_geodataframes
from platoon_osm.sources.graphs.graph_values import flag, joined, number, parts

PER_EDGE = ("tail", "head", "length_m", "speed_mps", "road_class", "toll", "inferred", "way_id")
SHAPES = ("shape_first", "shape_lon", "shape_lat")
PER_NODE = ("lon", "lat", "node_id")


def a_network():
    """Two edges from node 10 to 20 with another between them, a ring, a curve, and names."""
    return RoadNetwork.from_edges(
        [0, 0, 0, 1, 2, 2],
        [1, 2, 1, 2, 2, 0],
        [1000.0, 2000.25, 1500.125, 0.0, 800.0, 2000.3],
        lon=[11.0, 11.1, 11.2],
        lat=[45.0, 45.1, 45.0],
        node_id=[10, 30, 20],
        node_name=["", "None", "Tarvisio / Arnoldstein"],
        node_ref=["", "", "12;13"],
        speed_mps=[22.2, 80 / 3.6, 1 / 3, 25.0, 13.1, 1.1],
        road_class=[0, 1, 2, 0, 10, 0],
        ref=["A 4", "", "A 4;E 70", "", "", "A 4"],
        name=["", "[via] Ponte", "Serenissima", "", "", ""],
        toll=[True, False, True, False, False, False],
        inferred=[False, False, True, False, False, True],
        way_id=[5, 6, 7, 0, 9, 2**40],
        shape_first=[0, 2, 5, 8, 10, 14, 16],
        shape_lon=[
            *(11.0, 11.1), *(11.0, 11.05, 11.2), *(11.0, 11.0, 11.1), *(11.1, 11.2),
            *(11.2, 11.3, 11.3, 11.2), *(11.2, 11.0),
        ],
        shape_lat=[
            *(45.0, 45.1), *(45.0, 44.9, 45.0), *(45.0, 45.1, 45.1), *(45.1, 45.0),
            *(45.0, 45.0, 45.1, 45.0), *(45.0, 45.0),
        ],
        source=Source("made up", "ab", "2020", "ODbL 1.0", "somebody"),
    )  # fmt: skip


def assert_same(one, other):
    for label in (*PER_EDGE, *SHAPES, *PER_NODE):
        np.testing.assert_array_equal(getattr(one, label), getattr(other, label), label)
    for label in ("ref", "name", "node_name", "node_ref"):
        texts = [[net.texts[c] for c in getattr(net, label)] for net in (one, other)]
        assert texts[0] == texts[1]


def test_round_trip_is_exact():
    net = a_network()
    back = from_networkx(to_networkx(net))
    assert_same(net, back)
    assert back.source == net.source
    assert back.identity() == net.identity()


def test_round_trip_through_graphml_is_exact(tmp_path):
    net = a_network()
    osmnx.io.save_graphml(to_networkx(net), tmp_path / "net.graphml")
    back = from_networkx(osmnx.io.load_graphml(tmp_path / "net.graphml"))
    assert_same(net, back)
    assert back.source == net.source


def test_repeated_node_ids_become_positions_and_come_back():
    net = RoadNetwork.from_edges(
        [0, 1], [1, 2], lon=[0, 1, 2], lat=[0, 0, 0], node_id=[7, 7, 8], speed_mps=[20, 21]
    )
    graph = to_networkx(net)
    assert list(graph) == [0, 1, 2]
    assert_same(net, from_networkx(graph))


def test_large_ids_are_not_rounded(tmp_path):
    large = 2**53 + 1  # the first whole number that a float cannot hold
    net = RoadNetwork.from_edges(
        [0], [1], lon=[0, 1, 2], lat=[0, 0, 0], node_id=[0, 0, large], way_id=[large]
    )
    assert_same(net, from_networkx(to_networkx(net)))
    graph = to_networkx(net)
    for _, attributes in graph.nodes(data=True):
        attributes["node_id"] = str(attributes["node_id"])
    assert from_networkx(graph).node_id.tolist() == [0, 0, large]


def test_network_methods_lead_here():
    net = a_network()
    assert_same(net, RoadNetwork.from_networkx(net.to_networkx()))
    assert len(net.to_geodataframes()[1]) == net.m


@st.composite
def networks(draw):
    n = draw(st.integers(1, 6))
    node = st.integers(0, n - 1)
    ends = draw(st.lists(st.tuples(node, node), max_size=12))
    m = len(ends)
    degree = st.floats(-80, 80)
    text = st.text(max_size=4)
    some = lambda values, size: draw(st.lists(values, min_size=size, max_size=size))  # noqa: E731 (short beside its use)
    lon, lat = some(degree, n), some(degree, n)
    first, shape = [0], []
    for u, v in ends:
        via = draw(st.lists(st.tuples(degree, degree), max_size=3))
        shape += [(lon[u], lat[u]), *via, (lon[v], lat[v])]
        first.append(len(shape))
    return RoadNetwork.from_edges(
        np.array([u for u, _ in ends], int),
        np.array([v for _, v in ends], int),
        some(st.floats(0, 1e6), m),
        lon=lon,
        lat=lat,
        node_id=some(st.integers(-(2**62), 2**62), n),
        node_name=some(text, n),
        speed_mps=some(st.floats(0.1, 50), m),
        road_class=some(st.integers(0, 10), m),
        ref=some(text, m),
        toll=some(st.booleans(), m),
        inferred=some(st.booleans(), m),
        shape_first=first,
        shape_lon=[x for x, _ in shape],
        shape_lat=[y for _, y in shape],
    )


@settings(max_examples=60, deadline=None)
@given(networks())
def test_any_network_comes_back_the_same(net):
    assert_same(net, from_networkx(to_networkx(net)))


def test_graph_pleases_osmnx(tmp_path):
    net = a_network()
    graph = to_networkx(net)
    assert graph.graph["crs"] == "epsg:4326"
    with pytest.warns(UserWarning, match="street_count"):  # not a property of this network
        osmnx.convert.validate_graph(graph, strict=False)
    assert osmnx.routing.shortest_path(graph, 10, 20, weight="length") == [10, 30, 20]
    assert osmnx.routing.shortest_path(graph, 10, 20, weight="travel_time") == [10, 30, 20]
    nodes, edges = osmnx.convert.graph_to_gdfs(graph)
    assert len(nodes) == net.n
    assert len(edges) == net.m
    assert_same(net, from_networkx(osmnx.convert.graph_from_gdfs(nodes, edges)))
    osmnx.io.save_graph_geopackage(graph, tmp_path / "net.gpkg", directed=True)
    curve = graph.edges[10, 20, 0]
    assert list(curve["geometry"].coords) == [(11.0, 45.0), (11.05, 44.9), (11.2, 45.0)]
    assert "geometry" not in graph.edges[10, 30, 0]
    assert graph.edges[10, 30, 1]["maxspeed"] == "1.2"
    assert curve["speed_kph"] == pytest.approx(80)
    assert curve["travel_time"] == pytest.approx(2000.25 / 80 * 3.6)
    assert graph.nodes[20] == {
        "x": 11.2, "y": 45.0, "highway": "motorway_junction",
        "name": "Tarvisio / Arnoldstein", "ref": "12;13",
    }  # fmt: skip
    assert all(data["oneway"] is True for *_, data in graph.edges(data=True))


def test_plain_digraph_and_lists():
    graph = nx.DiGraph()
    graph.add_node("Torino", x=7.7, y=45.0, name="Torino")
    graph.add_node("Genova", x=8.9, y=44.4, name="stop", highway="bus_stop")
    graph.add_edge(
        "Torino", "Genova", maxspeed=["100", "80"], ref=["A 7", "A 21"], toll=[False, True],
        highway=["trunk", "motorway"], osmid=[12, 11],
        geometry=shapely.LineString([(8.9, 44.4), (8.5, 44.9), (7.7, 45.0)]),
    )  # fmt: skip
    graph.add_edge("Genova", "Torino", length=1.0)
    net = from_networkx(graph)
    assert net.node_id.tolist() == [0, 1]
    assert [net.junction_name(v) for v in range(2)] == ["Torino", ""]
    assert net.speed_mps.tolist() == [80 / 3.6, 80 / 3.6]
    assert net.edge_ref(0) == "A 21;A 7"
    assert (net.toll.tolist(), net.road_class.tolist()) == ([True, False], [0, 10])
    assert net.way_id.tolist() == [11, 0]
    assert net.shape(0)[:, 0].tolist() == [7.7, 8.5, 8.9]
    assert 110_000 < net.length_m[0] < 150_000
    assert net.load_report["speed defaulted to 80 km/h"] == 1


def test_composed_networks_keep_the_graphs_order():
    one = to_networkx(RoadNetwork.from_edges([0], [1], lon=[0, 1], lat=[0, 0]))
    other = nx.relabel_nodes(one, {0: 5, 1: 6})
    net = from_networkx(nx.compose(one, other))
    assert net.node_id.tolist() == [0, 1, 5, 6]
    assert net.m == 2


def good_graph():
    graph = nx.MultiDiGraph(crs="epsg:4326")
    graph.add_node(1, x=11.0, y=45.0)
    graph.add_node(2, x=11.1, y=45.0)
    graph.add_edge(1, 2, length=10.0)
    return graph


def changed_node(**values):
    graph = good_graph()
    graph.nodes[2].update(values)
    return graph


def changed_edge(**values):
    graph = good_graph()
    graph.edges[1, 2, 0].update(values)
    return graph


def unplaced():
    graph = good_graph()
    graph.add_edge(2, 3)
    return graph


@pytest.mark.parametrize(
    ("graph", "said"),
    [
        (unplaced(), "node 3 lies at x None"),
        (changed_node(x=math.nan), "node 2 lies at x nan"),
        (changed_node(y="north"), "node 2 lies at"),
        (changed_node(x=650_000.0), "node 2 lies at x 650000"),
        (changed_edge(length=-1), "1 -> 2 has length -1"),
        (changed_edge(length=math.inf), "1 -> 2 has length inf"),
        (changed_edge(speed_kph=0), "1 -> 2 has speed_kph 0"),
        (changed_edge(geometry=shapely.Point(0, 0)), "1 -> 2 has a Point"),
        (changed_edge(geometry="LINESTRING (0"), "1 -> 2 has a geometry that is no"),
        (
            changed_edge(geometry=shapely.LineString([(11, 45), (11, 450), (11.1, 45)])),
            "1 -> 2 leaves the globe",
        ),
        (nx.MultiGraph(good_graph()), "no direction"),
        ("a graph", "str is not a networkx graph"),
        (osmnx.projection.project_graph(good_graph()), "not in degrees"),
    ],
)
def test_unfit_graphs_are_refused_in_one_line(graph, said):
    with pytest.raises(NetworkError, match=said) as caught:
        from_networkx(graph)
    assert "\n" not in str(caught.value)


def test_geodataframes():
    net = a_network()
    nodes, edges = to_geodataframes(net)
    assert isinstance(nodes, geopandas.GeoDataFrame)
    assert nodes.crs == edges.crs == "EPSG:4326"
    assert (nodes.index.name, edges.index.name) == ("node", "edge_id")
    for e in range(net.m):
        np.testing.assert_array_equal(np.array(edges.geometry[e].coords), net.shape(e))
    assert edges["tail_id"].tolist() == net.node_id[net.tail].tolist()
    assert edges["highway"].tolist()[:2] == ["motorway", "motorway_link"]
    assert nodes["name"].tolist() == ["", "None", "Tarvisio / Arnoldstein"]


def test_nothing_at_all():
    net = RoadNetwork.from_edges([], [], lon=[], lat=[])
    assert from_networkx(to_networkx(net)).n == 0
    assert [len(table) for table in to_geodataframes(net)] == [0, 0]


@pytest.mark.parametrize(
    ("value", "values"),
    [
        ("['100', '80']", ["100", "80"]),
        ([80, None, 100, 80], [100, 80]),
        ("[unclosed", ["[unclosed"]),
        ("[A] road", ["[A] road"]),
        (math.nan, []),
        ("", []),
        (False, [False]),
    ],
)
def test_parts(value, values):
    assert parts(value) == values


def test_single_values():
    assert number(["90", 80]) == 80
    assert number("80 mph") is None
    assert number("nan") is None
    assert joined(["E 70", "A 4"]) == "A 4;E 70"
    assert joined(None) == ""
    assert [flag(value) for value in ("True", "no", ["no", "yes"], True, None, np.True_)] == [
        True, False, True, True, False, True,
    ]  # fmt: skip
