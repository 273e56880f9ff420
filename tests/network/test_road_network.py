"""The network's arrays: how they are made, refused, looked at and turned round."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from made_networks import network, random_networks, same_network, small_italy

from platoon_osm.errors import NetworkError
from platoon_osm.network.geodesy import distance_m
from platoon_osm.network.load_report import LoadReport
from platoon_osm.network.road_network import RoadNetwork, format_position
from platoon_osm.network.shapes import ragged_order


def two_edges(**changes):
    """0 -> 1 -> 2, each edge with a bend; a test changes one thing."""
    columns = {
        "tail": [1, 0],
        "head": [2, 1],
        "length_m": [2_000.0, 1_000.0],
        "lon": [10.0, 10.1, 10.2],
        "lat": [45.0, 45.0, 45.0],
        "speed_mps": [20.0, 25.0],
        "shape_first": [0, 3, 6],
        "shape_lon": [10.1, 10.15, 10.2, 10.0, 10.05, 10.1],
        "shape_lat": [45.0, 45.01, 45.0, 45.0, 44.99, 45.0],
        "way_id": [7, 8],
    }
    columns |= changes
    return RoadNetwork.from_edges(
        columns.pop("tail"), columns.pop("head"), columns.pop("length_m"), **columns
    )


def test_edges_are_sorted_by_tail_with_all_their_columns():
    net = two_edges(ref=["B", "A"], name=["beta", "alpha"], toll=[True, False], road_class=[1, 0])
    assert net.tail.tolist() == [0, 1]
    assert net.head.tolist() == [1, 2]
    assert net.first_out.tolist() == [0, 1, 2, 2]
    assert net.length_m.tolist() == [1_000, 2_000]
    assert net.speed_mps.tolist() == [25, 20]
    assert net.way_id.tolist() == [8, 7]
    assert (net.edge_ref(0), net.edge_name(0), net.edge_ref(1)) == ("A", "alpha", "B")
    assert net.toll.tolist() == [False, True]
    assert net.road_class.tolist() == [0, 1]
    assert net.shape(0).tolist() == [[10.0, 45.0], [10.05, 44.99], [10.1, 45.0]]
    assert net.shape(1).tolist() == [[10.1, 45.0], [10.15, 45.01], [10.2, 45.0]]


def test_what_is_not_given_is_filled_in():
    net = RoadNetwork.from_edges([0], [1], lon=[10.0, 10.1], lat=[45.0, 45.1])
    assert net.length_m[0] == pytest.approx(distance_m(10.0, 45.0, 10.1, 45.1))
    assert net.speed_mps[0] == pytest.approx(80 / 3.6)
    assert net.shape(0).tolist() == [[10.0, 45.0], [10.1, 45.1]]
    assert net.node_id.tolist() == [0, 1]
    assert not net.toll.any()
    assert not net.inferred.any()
    assert net.edge_ref(0) == net.junction_name(0) == ""
    assert len(net.points) == 0


def test_a_length_not_given_is_that_of_the_bent_shape():
    net = two_edges(length_m=None)
    bent = distance_m(10.0, 45.0, 10.05, 44.99) + distance_m(10.05, 44.99, 10.1, 45.0)
    assert net.length_m[0] == pytest.approx(bent)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"head": [3, 1]}, "1 of 2 edges end at no node (first: edge 0)"),
        ({"tail": [1, -1]}, "1 of 2 edges end at no node (first: edge 1)"),
        ({"head": [2]}, "head has shape (1,)"),
        ({"lat": [45.0, 45.0]}, "lat has shape (2,); 3 nodes and 2 edges need (3,)"),
        ({"length_m": [1.0, 2.0, 3.0]}, "length_m has shape (3,)"),
        ({"speed_mps": [1.0, 2.0, 3.0]}, "speed_mps has shape (3,)"),
        ({"node_id": [1, 2]}, "node_id has shape (2,)"),
        ({"way_id": [1]}, "way_id has shape (1,)"),
        ({"ref": ["A4"]}, "ref has shape (1,)"),
        ({"node_name": ["x"] * 4}, "node_name has shape (4,)"),
        ({"shape_first": [0, 3]}, "shape_first has shape (2,)"),
        ({"shape_first": [0, 3, 5]}, "shape_first must run from 0"),
        ({"shape_lon": [10.0] * 5}, "shape_first must run from 0"),
        ({"shape_first": [0, 5, 6]}, "a shape of two points or more"),
        ({"lon": [10.0, 10.1, 180.5]}, "node 2 lies at lon 180.5"),
        ({"lat": [45.0, float("nan"), 45.0]}, "node 1 lies at lon 10.1, lat nan"),
        ({"lat": [-91.0, 45.0, 45.0]}, "node 0 lies at lon 10.0, lat -91.0"),
        ({"length_m": [2.0, -1.0]}, "edge 0 (way 8) has length -1.0"),
        ({"length_m": [float("nan"), 1.0]}, "edge 1 (way 7) has length nan"),
        ({"length_m": [float("inf"), 1.0]}, "edge 1 (way 7) has length inf"),
        ({"speed_mps": [20.0, 0.0]}, "edge 0 (way 8) has speed 0.0; a speed must be finite and"),
        ({"speed_mps": [20.0, float("inf")]}, "edge 0 (way 8) has speed inf"),
        ({"shape_lon": [10.1, 999, 10.2, 10.0, 10.05, 10.1]}, "edge 1 (way 7) passes lon 999"),
        ({"shape_lat": [45.0, 45, 45.0, 45.0, float("nan"), 45.0]}, "edge 0 (way 8) passes lon"),
    ],
)  # fmt: skip
def test_wrong_values_are_refused_by_name(changes, said):
    with pytest.raises(NetworkError) as caught:
        two_edges(**changes)
    message = str(caught.value)
    assert said in message
    assert message.startswith("network: ")
    assert "\n" not in message


def test_zero_length_edges_are_welcome():
    assert two_edges(length_m=[0.0, 1.0]).length_m.tolist() == [1.0, 0.0]


def test_all_arrays_are_read_only():
    net = small_italy()
    for name in ("tail", "head", "length_m", "lon", "ref", "shape_lon", "first_out", "toll"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(net, name)[0] = 0
    with pytest.raises(ValueError, match="read-only"):
        net.points.lon[0] = 0


def test_the_callers_arrays_stay_the_callers_own():
    lon = np.array([10.0, 10.1])
    net = RoadNetwork.from_edges([0], [1], lon=lon, lat=[45.0, 45.0])
    lon[0] = 11.0
    assert net.lon[0] == 10.0


def test_a_path_is_drawn_without_doubled_joints():
    net = two_edges()
    assert net.path_shape([0, 1]).tolist() == [
        [10.0, 45.0], [10.05, 44.99], [10.1, 45.0], [10.15, 45.01], [10.2, 45.0],
    ]  # fmt: skip
    assert net.path_shape([1]).tolist() == net.shape(1).tolist()
    assert net.path_shape([]).shape == (0, 2)
    assert net.path_nodes([0, 1]).tolist() == [0, 1, 2]
    assert net.path_nodes([]).tolist() == []


@settings(max_examples=100, deadline=None)
@given(random_networks())
def test_incoming_lists_every_edge_at_its_head(net):
    edges, first = net.incoming()
    assert sorted(edges.tolist()) == list(range(net.m))
    for v in range(net.n):
        assert set(edges[first[v] : first[v + 1]]) == {e for e in range(net.m) if net.head[e] == v}


@settings(max_examples=150, deadline=None)
@given(random_networks())
def test_strong_parts_are_those_of_networkx_and_part_0_has_the_most_road(net):
    part = net.strong_component()
    graph = nx.MultiDiGraph()
    graph.add_nodes_from(range(net.n))
    graph.add_edges_from(zip(net.tail.tolist(), net.head.tolist(), strict=True))
    expected = {frozenset(nodes) for nodes in nx.strongly_connected_components(graph)}
    assert {frozenset(np.flatnonzero(part == k).tolist()) for k in set(part.tolist())} == expected
    km = [
        net.length_m[(part[net.tail] == k) & (part[net.head] == k)].sum()
        for k in range(len(expected))
    ]
    assert km == sorted(km, reverse=True)


def test_strong_part_of_edges_between_parts_counts_for_neither():
    # 0 <-> 1 is 2 km of road; 1 -> 2 is 50 km, but leads out of the part.
    net = network([(0, 0), (1_000, 0), (51_000, 0)], [(0, 1), (1, 0), (1, 2)])
    assert net.strong_component().tolist() == [0, 0, 1]


@settings(max_examples=100, deadline=None)
@given(random_networks())
def test_reversing_turns_every_edge_and_its_shape(net):
    turned, old = net.reversed()
    assert sorted(old.tolist()) == list(range(net.m))
    np.testing.assert_array_equal(turned.tail, net.head[old])
    np.testing.assert_array_equal(turned.head, net.tail[old])
    for name in ("length_m", "speed_mps", "ref", "name", "toll", "way_id", "road_class"):
        np.testing.assert_array_equal(getattr(turned, name), getattr(net, name)[old])
    for e in range(net.m):
        np.testing.assert_array_equal(turned.shape(e), net.shape(int(old[e]))[::-1])


@settings(max_examples=100, deadline=None)
@given(random_networks())
def test_reversed_twice_is_the_same_network(net):
    turned, first = net.reversed()
    again, second = turned.reversed()
    origin = first[second]
    # Parallel ways out of one node may have changed places; put them back by their old ids.
    np.testing.assert_array_equal(again.first_out, net.first_out)
    for name in ("tail", "head", "length_m", "speed_mps", "ref", "way_id", "toll", "inferred"):
        np.testing.assert_array_equal(getattr(again, name), getattr(net, name)[origin])
    for e in range(net.m):
        np.testing.assert_array_equal(again.shape(e), net.shape(int(origin[e])))
    for name in ("lon", "lat", "node_id", "node_name", "node_ref"):
        np.testing.assert_array_equal(getattr(again, name), getattr(net, name))


def test_place_names_from_best_to_worst():
    base = small_italy()
    assert base.place_name(0) == "Verona"
    # 4 has no name, but a road, and Milano is 68 km off: Łódź, a town 30 km away, is near.
    assert base.place_name(4) == "A4 near Łódź"
    numbered = network(
        [(0, 0), (9_000, 0)], [(0, 1)], node_ref=["12", ""], ref=["A4"], node_name=["", ""]
    )
    # The map names no town, so GeoNames does.
    assert numbered.place_name(0) == "A4 exit 12, Cremona"
    assert numbered.place_name(1) == "A4 near Fidenza"
    assert network([(0, 0), (9_000, 0)], [(0, 1)]).place_name(0) == "road near Cremona"
    at_sea = {"tail": [0], "head": [1], "lon": [-30.0, -30.1], "lat": [45.0, 45.0]}
    lonely = RoadNetwork.from_edges(**at_sea, node_ref=["12", ""], ref=["A4"])
    assert lonely.place_name(0) == "A4 exit 12"
    assert lonely.place_name(1) == "A4 at 45.000 N 30.100 W"
    assert RoadNetwork.from_edges(**at_sea).place_name(0) == "at 45.000 N 30.000 W"


def test_a_name_or_number_of_blanks_is_none():
    at_sea = {"tail": [0], "head": [1], "lon": [-30.0, -30.1], "lat": [45.0, 45.0]}
    net = RoadNetwork.from_edges(**at_sea, node_name=["  ", "x"], node_ref=[" ", ""], ref=["A4"])
    assert net.place_name(0) == "A4 at 45.000 N 30.000 W"


def test_a_services_area_is_no_town():
    net = small_italy()
    # The nearest point to 5 is the services "Verona", which gives no orientation.
    assert net.place_name(5) == "A4 near Łódź"


def test_road_numbers_at_a_node():
    assert small_italy().incident_refs(1) == ("A 22;E 45", "A4")
    assert small_italy().incident_refs(6) == ()


def test_positions_are_written_for_people():
    assert format_position(7.69, 45.07) == "45.070 N 7.690 E"
    assert format_position(-118.2434, -33.9) == "33.900 S 118.243 W"


def test_identity_follows_what_routes_depend_on():
    net = two_edges()
    assert net.identity() == two_edges().identity()
    assert net.identity() == net.with_report(LoadReport({"x": 1})).identity()
    assert net.identity() != two_edges(length_m=[2_000.0, 1_001.0]).identity()
    assert net.identity() != two_edges(speed_mps=[20.0, 24.0]).identity()


def test_with_report_changes_only_the_report():
    net = small_italy()
    changed = net.with_report(LoadReport({"x": 1}))
    assert changed.report()["x"] == 1
    assert changed.report()["y"] == 0
    same_network(changed.with_report(net.load_report), net)


def test_ragged_rows_in_another_order():
    first = np.array([0, 2, 5])
    assert [part.tolist() for part in ragged_order(first, np.array([1, 0, 1]))] == [
        [2, 3, 4, 0, 1, 2, 3, 4],
        [0, 3, 5, 8],
    ]
    assert ragged_order(first, np.array([1, 0]), backwards=True)[0].tolist() == [4, 3, 2, 1, 0]


def test_report_adds_counts_and_prints_remarks():
    report = LoadReport({"a": 1}, ("look",)).extended({"a": 1_999, "b": 3}, "and see")
    assert report.to_dict() == {"counts": {"a": 2_000, "b": 3}, "remarks": ["look", "and see"]}
    assert str(report) == "2,000  a\n    3  b\nnote: look\nnote: and see"


def test_repr_tells_size():
    assert repr(two_edges()) == "<RoadNetwork in memory: 3 nodes, 2 edges, 3 km>"


def test_a_report_can_be_asked_for_what_it_counted():
    report = LoadReport({"a": 1, "b": 0})
    assert list(report) == ["a", "b"]
    assert "b" in report
    assert "c" not in report
    assert report["c"] == 0
