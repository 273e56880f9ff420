"""The summary that is printed: what a reader must find in it."""

from datetime import datetime, timedelta

import numpy as np
import pytest
from random_networks import network

from platoon_osm.costs.paper import paper_weights
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.network.towns.surroundings import GEONAMES_CREDIT
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.trip import Trip


@pytest.fixture
def road():
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    return net, paper_weights(net)


TRIPS = [Trip("A", 0, 3), Trip("B", 4, 5)]


def test_table_points_and_proof(road):
    plan = plan_joint(*road, TRIPS, "C", master="A")
    lines = plan.summary().splitlines()
    assert lines[0] == "Case C: merge and separate on the way; costs in km-equivalents"
    assert lines[1].startswith("(weighted cost: distance, time and fuel")
    header, rule, first, second, rule_again, total = lines[3:9]
    assert header.split() == [
        "vehicle",
        "from",
        "to",
        "role",
        "alone",
        "joint",
        "saving",
        "km",
        "litres",
        "hours",
        "platoon",
    ]
    assert set(rule) == set(rule_again) == {"-"}
    # 30 km alone cost 92.5 equivalents; 10 of them in a platoon save 9.357.
    assert first.split()[-8:] == ["92.5", "83.1", "10.1%", "30", "9", "0.4", "10", "km"]
    assert second.split()[-8:] == ["92.5", "83.1", "10.1%", "30", "9", "0.4", "10", "km"]
    assert total.split() == ["total", "185.0", "166.3", "10.1%", "60", "18", "0.8", "20", "km"]
    assert "Alone all would drive 60 km with 19 litres of fuel in 0.8 hours." in lines
    where = [road[0].place_name(node) for node in (1, 2)]
    assert (
        f"B merges with A at {where[0]} (its km 10), separates at {where[1]} (its km 20)" in lines
    )
    assert lines[-3] == "A leads."
    assert lines[-2].startswith("Proved optimal for: master A on its own route; waiting at merging")
    credits = ["map: its source was not told", GEONAMES_CREDIT]
    assert lines[-1] == f"Credits: {'; '.join(credits)}."


def test_who_stays_alone_and_why(road):
    lines = plan_joint(*road, TRIPS, "A", master="A").summary().splitlines()
    reason = "B stays alone: case A does not apply: its destination is not on the route of A"
    assert reason in lines


def test_merging_names_those_who_are_there_already():
    # B joins at 1, C at 2: at 1 there is nobody but A.
    net = network([0, 1, 2, 4, 5], [1, 2, 3, 1, 2], [10e3] * 5)
    trips = [Trip("A", 0, 3), Trip("B", 4, 3), Trip("C", 5, 3)]
    text = plan_joint(net, paper_weights(net), trips, "C", master="A").summary()
    assert "B merges with A at" in text
    assert "C merges with A and B at" in text


def test_money_is_printed_as_money():
    net = network([0], [1], [10e3])
    weights = EdgeWeights(np.array([12.5]), np.array([11.0]), np.array([11.0]), "EUR", {})
    text = plan_joint(net, weights, [Trip("A", 0, 1), Trip("B", 0, 1)], "C").summary()
    assert "costs in EUR" in text
    assert "12.50" in text
    assert "22.00" in text


def test_astar_says_how_far_off_it_is(road):
    text = plan_joint(*road, TRIPS, "C", method="astar").summary()
    assert "Found by the paper's inflated A*: 0.00% above the optimum" in text
    assert "its routes alone cost 0.00% above the least" in text


def test_times_are_printed_where_a_plan_has_them(road):
    six = datetime(2026, 3, 2, 6)
    trips = [Trip("A", 0, 3, six), Trip("B", 4, 5, None, six - timedelta(minutes=5))]
    text = plan_joint(*road, trips, "C", master="A").summary()
    lines = text.splitlines()
    assert lines[3].split()[-3:] == ["leaves", "arrives", "waits"]
    # Each 10 km take 7 min 30 s.
    assert lines[5].split()[-4:] == ["06:00", "06:23", "0", "min"]
    assert lines[6].split()[-4:] == ["05:55", "06:23", "5", "min"]
    assert "Times are of 2026-03-02, local time." in lines
    assert "(its km 10, 06:08 after waiting 5 min), separates" in text
    assert "(its km 20, 06:15)" in text


def test_the_runner_up_is_told():
    # B and C share 40 km that A never sees; with A in front less is saved.
    net = network([0, 1, 1, 3, 4], [1, 2, 3, 4, 1], [10e3, 60e3, 20e3, 20e3, 5e3])
    trips = [Trip("A", 0, 2), Trip("B", 0, 4), Trip("C", 1, 4)]
    plan = plan_joint(net, paper_weights(net), trips, "C", company="master")
    text = plan.summary()
    chosen = next(v.vehicle for v in plan.vehicles if v.role == "master")
    assert f"{chosen} leads; with " in text
    assert "in front it would be" in text
    assert "3 of 3 masters tried" in text


def test_a_bound_says_what_could_be_saved_at_most():
    net = network([0, 1, 2, 2, 4, 5], [1, 2, 3, 5, 1, 6], [90e3, 90e3, 90e3, 40e3, 5e3, 20e3])
    trips = [Trip("A", 0, 3), Trip("B", 0, 6), Trip("C", 4, 6)]
    plan = plan_joint(net, paper_weights(net), trips, "C", master="A")
    assert plan.proof.kind in ("bound", "exact")
    most = 1 - plan.proof.any_plan / plan.solo_cost
    assert plan.saving <= most + 1e-9
    assert "optimal (" not in plan.summary()
