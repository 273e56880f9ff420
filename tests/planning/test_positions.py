"""Shares by place in a company: leader, middle and last, and what is proved of them."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import network, road_networks

from platoon_osm.costs.paper import PaperCosts, paper_weights
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.trip import Trip
from platoon_osm.search.dijkstra import ReferenceEngine

SAVED = {"leader": 0.055, "middle": 0.124, "last": 0.106}  # plafosim


def in_a_row(count):
    """A road of 100 km that so many drive together."""
    net = network([0], [1], [100e3])
    return net, [Trip("ABCDE"[k], 0, 1) for k in range(count)]


@pytest.mark.parametrize("count", [2, 3, 5])
def test_every_place_saves_its_own_share(count):
    net, trips = in_a_row(count)
    weights = paper_weights(net, tau=1.0, xi=1.0, positions="plafosim", fuel_l_per_100km=30)
    plan = plan_joint(net, weights, trips, case="C")
    (stretch,) = plan.stretches
    places = ["leader", *["middle"] * (count - 2), "last"]
    # 1 for distance, 1 for time, and fuel but for what is saved.
    for share, place in zip(stretch.shares, places, strict=True):
        assert share.cost == pytest.approx(100e3 * (3 - SAVED[place]))
        assert share.fuel_l == pytest.approx(30 * (1 - SAVED[place]))
    assert plan.joint_cost == pytest.approx(sum(share.cost for share in stretch.shares))
    assert plan.proof.cost == pytest.approx(plan.joint_cost)


def test_two_are_planned_exactly_and_three_up_to_a_bound():
    net, trips = in_a_row(3)
    weights = paper_weights(net, positions="plafosim")
    assert plan_joint(net, weights, trips[:2], case="C").proof.kind == "exact"
    three = plan_joint(net, weights, trips, case="C").proof
    # At xi = 0.18 the middle pays 2.1577 a metre and the last 2.1609, which is planned with.
    least = (2 + 0.18 * (1 - 0.124)) / (2 + 0.18 * (1 - 0.106))
    assert weights.least_by_position(3) == pytest.approx(least)
    assert weights.least_by_position(2) == 1
    assert three.kind == "bound"
    assert 0 < three.gap < 1 - least
    assert three.conditions[-1] == "whatever the places in a company"


@pytest.mark.parametrize("positions", [None, "nacfe", "nrel", "seed_18", "bhoopalam", "eddi"])
def test_tables_without_a_middle_of_their_own_change_nothing(positions):
    net, trips = in_a_row(4)
    weights = paper_weights(net, positions=positions)
    assert weights.middle is None
    assert weights.last is None
    assert plan_joint(net, weights, trips, case="C").proof.kind == "exact"


def test_a_member_is_planned_with_the_dearer_place():
    costs = PaperCosts(positions="plafosim", xi=1.0)
    assert costs.saving("follower") == 0.106
    assert costs.platoon_factor("middle") == pytest.approx(3 - 0.124)
    assert costs.platoon_factor("last") == costs.platoon_factor("follower")
    net, _ = in_a_row(2)
    solo = net.length_m
    with pytest.raises(ScenarioError, match=r"middle cost of edge 0 is .* above the"):
        EdgeWeights(solo, solo * 0.5, solo, "m", {}, middle=solo * 0.6)


@pytest.mark.parametrize("given", ["weights", "objective"])
def test_places_between_junctions_know_positions_too(given):
    net, _ = in_a_row(3)
    costs = PaperCosts(tau=1.0, xi=1.0, positions="plafosim")
    # A quarter along the road, and a place beside it.
    lon = [float(net.lon[0] + (net.lon[1] - net.lon[0]) * share) for share in (0.25, 0.5)]
    lat = [float(net.lat[0] + (net.lat[1] - net.lat[0]) * share) for share in (0.25, 0.5)]
    trips = [
        Trip("A", 0, 1), Trip("B", (lon[0], lat[0]), 1), Trip("C", (lon[1], lat[1] + 0.05), 1)
    ]  # fmt: skip
    plan = plan_joint(net, costs.weights(net) if given == "weights" else costs, trips, "C")
    (three,) = [stretch for stretch in plan.stretches if len(stretch.vehicles) == 3]
    for share, place in zip(three.shares, ("leader", "middle", "last"), strict=True):
        assert share.cost == pytest.approx(three.length_m * (3 - SAVED[place]))
    assert plan.proof.cost == pytest.approx(plan.joint_cost)


def paid(net, weights, route, members, points):
    """What all pay if members join the master's route at some points, by hand, edge by edge."""
    engine = ReferenceEngine(net, weights.solo)
    nodes = [*net.tail[route].tolist(), int(net.head[route[-1]])]
    total, there = 0.0, [[] for _ in route]
    for k, ((o, d), (i, j)) in enumerate(zip(members, points, strict=True)):
        if i == j:
            total += engine.distances([o])[0, d]
            continue
        total += engine.distances([o])[0, nodes[i]] + engine.distances([nodes[j]])[0, d]
        for at in range(i, j):
            there[at].append(k)
    for edge, company in zip(route.tolist(), there, strict=True):
        if not company:
            total += weights.solo[edge]
            continue
        total += weights.master[edge] + weights.last[edge]
        total += (len(company) - 1) * weights.middle[edge]
    return total


@settings(max_examples=40, deadline=None)
@given(road_networks(), st.data())
def test_no_plan_costs_less_than_the_bound(net, data):
    share = st.sampled_from([0.3, 0.5, 0.8, 0.9, 1.0])
    middle, last, lead = (net.length_m * data.draw(share) for _ in range(3))
    weights = EdgeWeights(
        net.length_m, np.maximum(middle, last), lead, "m", {}, middle=middle, last=last
    )
    ends = []
    for _ in range(3):
        origin, away = data.draw(st.integers(0, net.n - 1)), data.draw(st.integers(1, net.n - 1))
        ends.append((origin, (origin + away) % net.n))
    trips = [Trip("ABC"[k], *pair) for k, pair in enumerate(ends)]
    optimum = data.draw(st.sampled_from(["member", "system"]))
    plan = plan_joint(net, weights, trips, "C", objective=optimum, master="A")
    route = ReferenceEngine(net, weights.solo).tree(ends[0][0]).path(ends[0][1])
    choices = list(itertools.combinations_with_replacement(range(len(route) + 1), 2))
    least = min(
        paid(net, weights, route, ends[1:], points)
        for points in itertools.product(choices, repeat=2)
    )
    assert plan.proof.cost == pytest.approx(plan.joint_cost)
    if optimum == "system":
        assert plan.proof.cost * (1 - (plan.proof.gap or 0)) <= least * (1 + 1e-9)
        return
    for vehicle in plan.vehicles:
        if vehicle.role != "master":
            assert vehicle.joint_cost <= vehicle.solo_cost * (1 + 1e-9)
