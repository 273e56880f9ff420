"""Places by OpenStreetMap id and with labels of one's own, to `locate` and in trips."""

import numpy as np
import pytest
from made_networks import both_ways, network, small_italy

import platoon_osm as po
from platoon_osm.errors import NetworkError, ScenarioError


def refused(call, *said, kind=NetworkError):
    with pytest.raises(kind) as caught:
        call()
    message = str(caught.value)
    assert "\n" not in message
    for part in said:
        assert part in message, message


@pytest.mark.parametrize("osmid", [103, np.int64(103), np.uint8(103)])
def test_the_node_of_an_openstreetmap_id(osmid):
    net = small_italy()
    found = net.locate(osmid=osmid)
    assert found == net.locate(3) == net.locate(po.Place(osmid=osmid))
    assert (found.node, found.name) == (3, "Agrate")


def test_negative_ids_of_drafts_are_found():
    net = network([(0, 0), (9_000, 0)], both_ways([(0, 1)]), node_id=[-7, 5])
    assert net.locate(osmid=-7).node == 0


def test_nodes_that_share_an_id_are_one_place():
    net = network([(0, 0), (9_000, 0), (0, 50)], both_ways([(0, 1), (1, 2)]), node_id=[7, 5, 7])
    assert net.locate(osmid=7).candidates == ((0, 0.0), (2, 0.0))


@pytest.mark.parametrize("osmid", [99, 0, -1, 2**63, -(2**63) - 1, 10**30])
def test_an_id_that_is_not_on_the_network(osmid):
    net = small_italy()
    refused(lambda: net.locate(osmid=osmid), f"osmid {osmid}", "no node of", "give (lon, lat)")


def test_the_id_of_a_way_is_named_as_such():
    net = network([(0, 0), (9_000, 0)], both_ways([(0, 1)]), node_id=[1, 2], way_id=[44, 44])
    refused(lambda: net.locate(osmid=44), "osmid 44", "the id of a way; give one of its junctions")


def test_a_number_that_is_no_node_but_an_id_points_to_osmid():
    net = small_italy()
    refused(lambda: net.locate(103), "node 103: the network has nodes 0 to 7", "give osmid=103")
    with pytest.raises(NetworkError) as caught:
        net.locate(1_000)
    assert "osmid" not in str(caught.value)


@pytest.mark.parametrize(
    "at", ["brescia ovest", 1, (10.3, 45.0), small_italy().locate("Agrate")], ids=str
)
def test_a_label_is_the_name_and_nothing_else_changes(at):
    net = small_italy()
    plain, labelled = net.locate(at), net.locate(po.Place(at, label="Depot <1>"))
    assert labelled.name == "Depot <1>"
    assert labelled == net.locate(at, label="Depot <1>")
    for item in ("node", "lon", "lat", "distance_m", "candidates", "note"):
        assert getattr(labelled, item) == getattr(plain, item)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({}, "neither of at and osmid"),
        ({"at": "Torino", "osmid": 3}, "both of at and osmid"),
        ({"osmid": 3.0}, "osmid must be a whole number"),
        ({"osmid": "3"}, "osmid must be a whole number"),
        ({"osmid": True}, "osmid must be a whole number"),
        ({"at": "Torino", "label": " "}, "label ' ' must be a non-empty text"),
        ({"at": "Torino", "label": 7}, "label 7 must be a non-empty text"),
        ({"at": 1.5}, "1.5 must be a name"),
        ({"at": ""}, "'' must be a name"),
        ({"at": po.Place("Torino")}, "at is itself a Place"),
    ],
)
def test_what_is_no_place(given, said):
    refused(lambda: po.Place(**given), said)


def test_a_place_and_more_beside_it():
    net = small_italy()
    refused(lambda: net.locate(po.Place(1), osmid=3), "give no osmid or label beside it")
    refused(lambda: net.locate(po.Place(1), label="x"), "give no osmid or label beside it")


def test_only_by_name_for_else_a_second_place_would_be_an_id():
    with pytest.raises(TypeError):
        po.Place("Torino", 3)


def test_places_are_values():
    assert po.Place(np.int64(3)) == po.Place(3)
    assert len({po.Place(osmid=3), po.Place(osmid=3), po.Place(3)}) == 2


def test_labels_reach_the_plan_and_what_is_made_of_it():
    net = small_italy()
    trips = [
        po.Trip("A", po.Place("Verona (A4)", label="Mühle"), po.Place(osmid=103, label="Hafen")),
        po.Trip("B", po.Place(net.locate("brescia"), label="Lager"), 3),
    ]
    plan = po.plan_joint(net, po.paper_weights(net), trips)
    stops = [(v.origin.name, v.destination.name) for v in plan.vehicles]
    assert stops == [("Mühle", "Hafen"), ("Lager", "Agrate")]
    text = plan.summary()
    assert all(label in text for label in ("Mühle", "Hafen", "Lager"))
    assert po.Plan.from_dict(plan.to_dict()).vehicles[0].origin.name == "Mühle"


def test_what_is_wrong_with_a_place_names_trip_and_end():
    net = small_italy()
    trips = [po.Trip("A", po.Place(osmid=5), 1)]
    with pytest.raises(NetworkError, match=r"^trip 'A', origin: osmid 5: no node"):
        po.plan_joint(net, po.paper_weights(net), trips)
    elsewhere = po.Location(77, "x", 10.0, 45.0, 0.0, ((77, 0.0),))
    trips = [po.Trip("A", 0, po.Place(elsewhere, label="x"))]
    refused(
        lambda: po.plan_joint(net, po.paper_weights(net), trips),
        "trip 'A', destination", "locate it on this network", kind=ScenarioError,
    )  # fmt: skip
