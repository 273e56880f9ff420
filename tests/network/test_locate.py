"""From names and coordinates to nodes, and what is said when there is none or more than one."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import (
    PER_LAT,
    PER_LON,
    both_ways,
    degrees,
    network,
    random_networks,
    small_italy,
)

from platoon_osm.errors import NetworkError
from platoon_osm.network.geodesy import distance_m
from platoon_osm.network.locate import locate
from platoon_osm.network.place_index import fold
from platoon_osm.network.road_network import POINT_KINDS, NamedPoints
from platoon_osm.network.texts import TextTable


def at(east, north):
    return tuple(float(value) for value in degrees(east, north))


def refused(net, place, *said, role="any"):
    with pytest.raises(NetworkError) as caught:
        locate(net, place, role)
    message = str(caught.value)
    assert "\n" not in message
    for part in said:
        assert part in message
    return message


# -- nodes and coordinates -------------------------------------------------------------------------


def test_a_node_is_itself_even_off_the_main_network():
    net = small_italy()
    for node in (0, np.int64(4), 7):
        found = net.locate(node)
        assert (found.node, found.candidates, found.distance_m) == (node, ((node, 0.0),), 0.0)
        assert (found.lon, found.lat) == (net.lon[node], net.lat[node])


@pytest.mark.parametrize("node", [-1, 8, 10**12])
def test_a_node_that_is_none(node):
    refused(small_italy(), node, f"node {node}", "nodes 0 to 7")


def test_a_location_stays_what_it_is():
    net = small_italy()
    found = net.locate("Bréscia Ovest")
    assert net.locate(found) is found


def test_coordinates_find_the_nearest_node_and_both_carriageways():
    # Two carriageways 30 m apart, linked at both ends; the place lies beside the northern one.
    nodes = [(0, 0), (10_000, 0), (10_000, 30), (0, 30)]
    net = network(nodes, [(0, 1), (1, 2), (2, 3), (3, 0)])
    found = net.locate(at(100, 130))
    assert found.node == 3
    assert [node for node, _ in found.candidates] == [3, 0]
    assert found.candidates[0][1] == pytest.approx(np.hypot(100, 100), rel=1e-3)
    assert found.distance_m == pytest.approx(100, rel=1e-3)
    assert (found.lon, found.lat) == at(100, 130)


def test_nodes_much_farther_than_the_nearest_are_no_candidates():
    net = small_italy()
    assert [node for node, _ in net.locate(at(0, 100)).candidates] == [0]


@settings(max_examples=80, deadline=None)
@given(random_networks(), st.floats(-20_000, 20_000), st.floats(-20_000, 20_000))
def test_distance_to_the_road_is_that_of_shapely(net, east, north):
    lon, lat = at(east, north)
    if net.m == 0:
        refused(net, (lon, lat), "has no road to start or end on")
        return
    found = net.locate((lon, lat))
    main = net.strong_component() == 0
    inside = net.length_m[main[net.tail] & main[net.head]].sum()
    mostly = inside > 0 and inside >= 0.5 * net.length_m.sum()
    edges = [e for e in range(net.m) if not mostly or main[net.tail[e]] or main[net.head[e]]]
    # Both on a plane true to scale at the place's latitude.
    scale = np.array([PER_LON * np.cos(np.radians(lat)) / np.cos(np.radians(45.0)), PER_LAT])
    lines = shapely.MultiLineString([net.shape(e) * scale for e in edges])
    expected = lines.distance(shapely.Point(np.array([lon, lat]) * scale))
    assert found.distance_m == pytest.approx(expected, rel=2e-3, abs=0.5)


def test_distance_is_to_the_road_not_to_the_node():
    found = small_italy().locate(at(10_000, 250))
    assert found.distance_m == pytest.approx(250, rel=1e-3)
    assert found.candidates[0][1] > 9_000


def test_distance_is_to_the_road_that_is_taken():
    # The island 6 - 7 is near, but no trip can leave it: the road meant is 80 km away.
    message = refused(small_italy(), at(50_500, 80_100), "80 km from the nearest road", "50 km")
    assert "allow more by access=Access(limit_km=...)" in message


@pytest.mark.parametrize(
    ("role", "expected"), [("origin", 5), ("destination", 1), ("any", 1)]
)  # fmt: skip
def test_roles_beside_the_road_that_leads_in(role, expected):
    # 5 leads to the main road and is reached from nowhere.
    assert small_italy().locate(at(20_000, -2_900), role).node == expected


@pytest.mark.parametrize(
    ("role", "expected"), [("origin", 1), ("destination", 4), ("any", 1)]
)  # fmt: skip
def test_roles_beside_the_dead_end(role, expected):
    assert small_italy().locate(at(20_000, 2_900), role).node == expected


@settings(max_examples=200, deadline=None)
@given(random_networks(max_nodes=8), st.floats(0, 9_000), st.floats(0, 9_000))
def test_never_a_dead_end(net, east, north):
    """An origin must lead on, a destination must be reached: whatever the network is like."""
    if net.m == 0:
        return
    out = np.diff(net.first_out) > 0
    into = np.bincount(net.head, minlength=net.n) > 0
    for role, fits in (("origin", out), ("destination", into), ("any", out | into)):
        for node, _ in net.locate(at(east, north), role).candidates:
            assert fits[node]


def test_a_single_motorway_without_a_way_back():
    """Where nothing is strongly connected, a place is still found where it is."""
    net = network([(0, 0), (10_000, 0), (20_000, 0), (30_000, 0)], [(0, 1), (1, 2), (2, 3)])
    for node, east in enumerate((0, 10_000, 20_000)):
        assert net.locate(at(east, 50), "origin").node == node
        assert net.locate(at(east + 10_000, 50), "destination").node == node + 1
    # Nobody can leave from the end, nor arrive at the beginning.
    assert net.locate(at(30_000, 50), "origin").node == 2
    assert net.locate(at(0, 50), "destination").node == 1


@pytest.mark.parametrize(
    "place",
    [(181.0, 45.0), (10.0, 91.0), (float("nan"), 45.0), (10.0, float("nan")), (45.0, -118.0),
     (float("inf"), 0)],
)  # fmt: skip
def test_coordinates_off_the_globe(place):
    refused(small_italy(), place, "longitude comes first", "[-180, 180]")


@pytest.mark.parametrize("place", [None, 4.5, (1, 2, 3), ("a", "b"), {}, object, (None, 1)])
def test_things_that_are_no_place(place):
    refused(small_italy(), place, "give a node, a (lon, lat) pair in degrees or a name")


def test_an_unknown_role():
    with pytest.raises(ValueError, match="role 'start' is unknown; use origin, destination, any"):
        small_italy().locate("Milano", "start")


# -- names -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    ["Bréscia Ovest", "bréscia ovest", "BRESCIA OVEST", "Brescia-Ovest", "  brescia   ovest ",
     "Bre\u0301scia Ovest", "brescia", "Bréscia Ovest (A4)", "Bréscia Ovest (A 22)",
     "Bréscia Ovest (e45)", "Bréscia Ovest (junction)"],
)  # fmt: skip
def test_names_in_any_case_and_without_accents(text):
    found = small_italy().locate(text)
    assert (found.node, found.name, found.distance_m) == (1, "Bréscia Ovest", 0.0)


def test_brackets_that_belong_to_the_name():
    net = small_italy()
    found = net.locate("Frankfurt (Oder)", "any")
    # Node 6 is an island, so the nearest node of the main network stands for it.
    assert (found.name, found.node) == ("Frankfurt (Oder)", 2)


def test_letters_that_are_no_accents_but_are_left_out_all_the_same():
    assert small_italy().locate("Lodz").name == "Łódź"
    assert [fold(text) for text in ("Straße", "Ærø", "Sankt  Pölten/Süd", "Đakovo")] == [
        "strasse", "aero", "sankt polten sud", "dakovo",
    ]  # fmt: skip


def test_two_places_of_one_name_are_both_listed():
    message = refused(small_italy(), "verona", "place 'verona' is ambiguous", "give (lon, lat)")
    assert "Verona (A4) at 45.000 N 10.000 E" in message
    assert "Verona (A 22;E 45) at 45.000 N 10.761 E" in message


def test_the_road_in_brackets_decides():
    net = small_italy()
    assert net.locate("Verona (A4)").node == 0
    assert net.locate("verona (a22)").node == 2
    refused(net, "Verona (A99)", "not on that road; there is Verona (A4)", "Verona (A 22;E 45)")
    refused(net, "Nowhere (A4)", "no junction or town of that name")


def test_a_place_far_from_every_road_is_refused():
    net = small_italy()
    assert net.locate((10.5, 45.4)).distance_m > 40_000
    refused(
        net, (11.0, 46.5), "km from the nearest road", "more than 50 km", "Access(limit_km=...)"
    )
    refused(net, (45.0, 10.0), "km from the nearest road", "give longitude first")
    refused(net, (0.0, 0.0), "km from the nearest road", "load a map of that region")
    refused(net, (13.4, 52.5), "load a map of that region")


def test_a_truth_value_is_no_node():
    refused(small_italy(), True, "give a node")


def test_a_name_as_long_as_a_book_makes_a_short_message():
    with pytest.raises(NetworkError) as caught:
        small_italy().locate("a" * 5_000)
    assert len(str(caught.value)) < 250


def test_a_junction_stands_for_the_town_beside_it():
    # A junction Agrate at 3, a town Agrate 2 km away: one place. Part of a name is enough.
    found = small_italy().locate("agrate")
    assert (found.node, found.name) == (3, "Agrate")


def test_a_city_without_a_junction_of_its_name_is_found_by_its_place():
    net = small_italy()
    found = net.locate("milano")
    assert (found.node, found.name) == (3, "Milano")
    assert found.distance_m == pytest.approx(1_000, rel=1e-3)
    assert found.candidates[0][1] == pytest.approx(np.hypot(2_000, 1_000), rel=1e-3)


def city_and_junctions(kinds, places, junction_at=200_000):
    lon, lat = degrees(*np.array(places, float).T)
    codes = np.ones(len(kinds), np.int32)
    points = NamedPoints(
        lon, lat, np.array([POINT_KINDS.index(kind) for kind in kinds], np.uint8), codes,
        np.zeros(len(kinds), np.int64),
    )  # fmt: skip
    nodes = [(0, 0), (junction_at, 0)]
    return network(
        nodes, both_ways([(0, 1)]), node_name=[0, 1], points=points,
        texts=TextTable.from_strings(["", "Torino"]), ref=[0, 0], name=[0, 0], node_ref=[0, 0],
    )  # fmt: skip


def test_a_city_comes_before_a_far_junction_of_its_name():
    assert city_and_junctions(["city"], [(0, 2_000)]).locate("Torino").node == 0


def test_a_far_junction_and_a_town_of_one_name_are_ambiguous():
    net = city_and_junctions(["town"], [(0, 2_000)])
    message = refused(net, "Torino", "ambiguous")
    assert "Torino (town)" in message
    assert net.locate("Torino (town)").node == 0


def test_two_cities_of_one_name_are_ambiguous():
    refused(city_and_junctions(["city", "city"], [(0, 0), (90_000, 0)]), "Torino", "ambiguous")


def test_services_are_no_destination_by_name():
    net = city_and_junctions(["services"], [(0, 0)])
    assert net.locate("Torino").node == 1


@pytest.mark.parametrize(
    ("text", "hint"),
    [("Bresica Ovest", "did you mean Bréscia Ovest"), ("Milanno", "did you mean Milano")],
)
def test_misspelt_names_get_the_nearest_ones(text, hint):
    refused(small_italy(), text, f"place {text!r}: no junction or town", hint)


def test_a_name_like_no_other():
    refused(small_italy(), "Xqz", "give (lon, lat) instead")


@pytest.mark.parametrize("text", ["", "   ", "()", "...", "\n"])
def test_an_empty_name(text):
    refused(small_italy(), text, "give a junction, a town or (lon, lat)")


def test_many_places_of_one_name_are_not_all_listed():
    nodes = [(20_000 * i, 0) for i in range(9)]
    net = network(nodes, both_ways([(i, i + 1) for i in range(8)]), node_name=["Ovest"] * 9)
    message = refused(net, "ovest", "and 3 more")
    assert message.count("Ovest (") == 7  # six places and the example


def test_nodes_of_one_name_near_each_other_are_one_place():
    # Both carriageways and the gate between the ramps: six nodes, one junction.
    nodes = [(0, 0), (1_000, 0), (2_000, 0), (2_000, 40), (1_000, 40), (0, 40), (1_000, 500)]
    edges = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 6), (6, 1), (4, 6), (6, 4)]
    kinds = [0] * 6 + [1] * 4
    net = network(
        nodes, edges, road_class=kinds, node_name=["", "Novara", "", "", "Novara", "", "Novara"]
    )
    found = net.locate("novara", "origin")
    assert {node for node, _ in found.candidates} == {1, 4, 6}
    # The gate, which only ramps touch, serves both directions and comes first.
    assert found.node == 6
    assert all(away == 0 for _, away in found.candidates)
    assert distance_m(found.lon, found.lat, net.lon[1], net.lat[1]) < 300


def test_a_named_junction_in_a_dead_end_is_left_out_of_the_candidates():
    nodes = [(0, 0), (1_000, 0), (1_100, 0)]
    net = network(nodes, [(0, 1), (1, 0), (1, 2)], node_name=["", "Novara", "Novara"])
    assert net.locate("novara", "origin").candidates == ((1, 0.0),)
    assert {node for node, _ in net.locate("novara", "destination").candidates} == {1, 2}
