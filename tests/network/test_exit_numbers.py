"""Exits by their numbers, in all the ways people write them."""

import pytest
from bundled import italy as italy_map
from hostile_names import HOSTILE
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import both_ways, network

from platoon_osm.errors import NetworkError
from platoon_osm.network.exit_numbers import exit_readings, has_exit_word, number_key
from platoon_osm.network.naming import node_name
from platoon_osm.network.place_index import SAME_PLACE_M, gap_m
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.towns.surroundings import TownsAround


def numbered():
    """The A 1 eastward with exits 1, 12A;12B, 4 and another 4 far on; the A 2 northward with a 7.

    Exit 4 has its other carriageway 60 m off. The town nearest to node 5 is not that of node 2.
    """
    nodes = [
        (0, 0), (10_000, 0), (20_000, 0), (20_000, 60), (40_000, 0), (70_000, 0), (10_000, 30_000),
    ]  # fmt: skip
    edges = both_ways([(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (1, 6)])
    return network(
        nodes, edges, node_name=["", "", "", "", "Mitte", "", ""],
        node_id=[11, 12, 13, 14, 15, 16, 17],
        node_ref=["1", "12A;12B", "4", "4", "5", "4", "7"],
        ref=["A 1"] * 10 + ["A 2;E 45"] * 2,
    )  # fmt: skip


NET = numbered()


def refused(place, *said, net=NET):
    with pytest.raises(NetworkError) as caught:
        net.locate(place)
    message = str(caught.value)
    assert "\n" not in message
    assert len(message) < 450
    for part in said:
        assert part in message, message
    return message


@pytest.mark.parametrize(
    "text",
    ["A 1 exit 1", "A1 exit 1", "a1 EXIT 1", "A-1 Exit 1", "A 1, exit 1", "A 1 - exit 1", "exit 1",
     "Exit 1", "exit 01", "exit no. 1", "exit #1", "Exit No 1", "exit1", "exit: 1", "exit 1 (A 1)",
     "exit 1 (A1)", "exit 1, A 1", "exit 1 A 1", "1 (A 1)", "1", " 1 ", "(A 1) exit 1",
     "A 1 Ausfahrt 1", "Ausfahrt 1", "AS 1", "Anschlussstelle 1 (A 1)", "sortie 1",
     "Sortie n\u00b0 1",
     "uscita 1", "salida 1", "saída 1", "avkjørsel 1", "liittymä 1", "węzeł 1", "A 1 J1",
     "Junction 1", "J1 (A 1)", "A\u00a01 exit\u00a01", "\uff21 1 exit \uff11"],
)  # fmt: skip
def test_one_exit_in_many_spellings(text):
    found = NET.locate(text)
    assert (found.node, found.distance_m) == (0, 0.0)
    assert found.name == NET.place_name(0)


@pytest.mark.parametrize(
    "text",
    ["12A", "12a", "12 A", "12-A", "exit 12A", "12B", "exit 12b (A 1)", "A 1 exit 12A;12B",
     "12B;12A", "A 1 exit 12a; 12b", "A 2 exit 12A", "E 45 exit 12A", "A 1 / A 2 exit 12A"],
)  # fmt: skip
def test_a_sign_with_two_numbers_has_both(text):
    assert NET.locate(text).node == 1


@pytest.mark.parametrize("text", ["12", "A", "12AB", "12C", "12A;12C"])
def test_a_part_of_a_number_is_none(text):
    refused(text, "no junction or town of that name")


def test_points_and_hyphens_between_digits_count():
    assert number_key("12.1") != number_key("121")
    assert number_key("12-13") != number_key("1213")
    assert number_key("12 - a") == number_key("12A") == number_key("012a")
    assert number_key("0") == "0"


def test_both_carriageways_are_one_place_and_far_ones_are_two():
    message = refused("A 1 exit 4", "is ambiguous", "add road and town", "or give (lon, lat)")
    for node in (2, 5):
        assert f"{NET.place_name(node)} at" in message
    two = NET.locate(NET.place_name(2))
    assert {node for node, _ in two.candidates} == {2, 3}
    assert NET.locate(NET.place_name(5)).candidates == ((5, 0.0),)


def test_an_exit_on_a_road_that_does_not_have_it():
    refused("A 99 exit 1", "no such exit there; there is A 1 exit 1")
    refused("exit 7 (A 1)", "no such exit there; there is A 2;E 45 exit 7")
    refused("A 1 exit 99", "no exit of that number, nor junction or town")


def test_a_town_that_is_far_from_the_exit_is_not_its_town():
    refused("A 1 exit 1, Napoli", "no such exit there; there is A 1 exit 1")


def test_any_town_in_reach_will_do_where_there_is_one_exit():
    assert NET.locate("A 1 exit 1, Parma").node == 0
    assert NET.locate("Parma exit 1").node == 0


def test_a_junction_with_a_name_is_found_by_its_number_too():
    found = NET.locate("A 1 exit 5")
    assert (found.node, found.name) == (4, "Mitte")


def test_a_name_comes_before_a_number():
    net = network(
        [(0, 0), (9_000, 0), (30_000, 0)], both_ways([(0, 1), (1, 2)]), node_name=["", "", "12"],
        node_ref=["12", "", ""], ref=["A 1"] * 4,
    )  # fmt: skip
    assert net.locate("12").node == 2
    assert net.locate("exit 12").node == 0


def test_a_bare_number_that_is_an_id_points_to_osmid():
    refused("13", "for the OpenStreetMap id, give osmid=13")
    assert "osmid" not in refused("99", "no junction or town")
    assert "osmid" not in refused("9" * 30, "no junction or town")


def test_gates_without_a_road_belong_to_the_exit_beside_them():
    net = network(
        [(0, 0), (9_000, 0), (9_100, 300)], both_ways([(0, 1), (1, 2)]), node_name=[""] * 3,
        node_ref=["", "3", "3"], ref=["A 1", "A 1", "", ""],
    )  # fmt: skip
    assert {node for node, _ in net.locate("A 1 exit 3").candidates} == {1}
    assert {node for node, _ in net.locate("exit 3").candidates} == {1, 2}


def test_one_number_on_two_roads_side_by_side_is_two_exits():
    net = network(
        [(0, 0), (9_000, 0), (0, 2_000), (9_000, 2_000)], both_ways([(0, 1), (1, 3), (3, 2)]),
        node_ref=["4", "", "4", ""], ref=["A 1", "A 1", "A 1", "A 1", "A 2", "A 2"],
    )  # fmt: skip
    refused("exit 4", "ambiguous", "A 1 exit 4", "A 2 exit 4", net=net)
    assert net.locate("A 2 exit 4").node == 2


@pytest.mark.parametrize("text", ["as", "j", "Asti", "Jena", "Exeter", "Exit", "exit ", "Sortie"])
def test_words_that_only_begin_like_an_exit(text):
    refused(text)


def test_which_texts_say_that_they_are_exits():
    assert all(has_exit_word(text) for text in ("A 1 exit 4", "AS 4", "J10", "EXIT 3", "Saída 2"))
    assert not any(has_exit_word(text) for text in ("4", "Asti 4", "Jena", "Exiting 4", "AS", ""))


@settings(max_examples=300)
@given(st.text(max_size=60) | st.sampled_from(HOSTILE))
def test_no_text_breaks_the_reading(text):
    for reading in exit_readings(f"A 1 exit {text}, (x) {text}"):
        assert all(isinstance(part, str) for part in reading)


def test_a_text_of_many_commas_is_read_in_a_moment():
    assert sum(1 for _ in exit_readings("exit 1, " * 200)) < 1_000
    for text in ("exit 1, " * 2_000, "exit " * 9_000, "(" * 20_000, "exit 1 (" * 2_000,
                 " 1" * 9_000, " near" * 4_000):  # fmt: skip
        with pytest.raises(NetworkError):
            NET.locate(text)


# -- whatever is printed is found again ------------------------------------------------------------

ROADS = st.sampled_from(
    ["", "A 1", "A 2;E 45", "I 5", "SS 36/SS 38", "exit 4", "A, B", "near", *HOSTILE[::6]]
)
NUMBERS = st.sampled_from(["", "", "4", "12A;12B", "12A", "4, 5", " ", "exit", *HOSTILE[::9]])
NAMES = st.sampled_from(["", "", "", "Novara Est", "A 1 exit 9", "   ", *HOSTILE[::7]])


def one_or_several(net, text):
    """Return what a text means; None if it may mean several places, and nothing else goes."""
    try:
        return net.locate(text)
    except NetworkError as error:
        if "is ambiguous" not in str(error):
            raise
    return None


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_every_printed_name_is_found_again_or_is_ambiguous(data):
    n = data.draw(st.integers(2, 7))
    at = st.tuples(st.floats(0, 90_000), st.floats(0, 20_000))
    nodes = data.draw(st.lists(at, min_size=n, max_size=n))
    edges = both_ways([(k, k + 1) for k in range(n - 1)])

    def drawn(texts, count):
        return [text.encode("utf-8", "replace").decode() for text in
                data.draw(st.lists(texts, min_size=count, max_size=count))]  # fmt: skip

    net = network(
        nodes, edges, node_name=drawn(NAMES, n), node_ref=drawn(NUMBERS, n),
        ref=drawn(ROADS, len(edges)),
    )  # fmt: skip
    for node in range(n):
        if (found := one_or_several(net, net.place_name(node))) is not None:
            assert node in {own for own, _ in found.candidates}, (net.place_name(node), found)


def test_every_name_of_the_bundled_map_is_found_again():
    net = italy_map()
    lost = []
    for node in range(0, net.n, 7):
        found = one_or_several(net, net.place_name(node))
        if found is not None and gap_m(net, node, found.node) > 2 * SAME_PLACE_M:
            lost.append((net.place_name(node), found.name))
    assert lost == []


def test_at_sea_there_is_no_town_and_names_still_lead_back():
    net = RoadNetwork.from_edges(
        [0, 1, 1, 2], [1, 0, 2, 1], lon=[-30.0, -30.4, -30.9], lat=[-0.01, 0.0, 0.01],
        node_ref=["", "4", ""], ref=["A 1"] * 4,
    )  # fmt: skip
    names = [net.place_name(node) for node in range(3)]
    assert names == ["A 1 at 0.010 S 30.000 W", "A 1 exit 4", "A 1 at 0.010 N 30.900 W"]
    assert [net.locate(name).node for name in names] == [0, 1, 2]


def test_where_a_name_is_from():
    assert node_name(NET, 4) == ("Mitte", False)
    assert node_name(NET, 0).from_geonames
    assert net_towns(NET) == {"GeoNames"}


def net_towns(net):
    around = net.attached(TownsAround)
    return {around.nearest(lon, lat).source for lon, lat in zip(net.lon, net.lat, strict=True)}
