"""Members and master pay least in all under driving rules: beside the planner without any.

Where neither windows nor the law bind, both are asked the same; they share no search.
"""

import random
from datetime import datetime, timedelta

import numpy as np
import pytest

from platoon_osm import EdgeWeights, RoadNetwork, Trip, plan_joint

DAY = datetime(2026, 3, 3, 6)
LATE = DAY + timedelta(hours=20)


def network(pairs, lengths_km):
    n = 1 + max(max(pair) for pair in pairs)
    tail, head = zip(*pairs, strict=True)
    return RoadNetwork.from_edges(
        tail, head, 1000.0 * np.asarray(lengths_km, float), lon=9 + np.arange(n) / 10,
        lat=45 + (np.arange(n) % 3) / 10, speed_mps=20.0,
    )  # fmt: skip


def both(net, weights, places, **options):
    trips = [Trip(name, *ends, DAY, None, LATE) for name, ends in places.items()]
    asked = {"case": "C", "objective": "system", "master": "A", "company": "master", **options}
    return [plan_joint(net, weights, trips, rules=rules, **asked) for rules in ("none", "eu561")]


def detour():
    """The road 0 - 1 - 2 of the master, and a place 3 off it; there it saves 5 on the last piece.

    Directly a member pays 10; by the road 1 + 12 = 13.
    """
    net = network([(0, 1), (1, 2), (3, 1), (3, 2)], [8, 12, 1, 10])
    solo = np.array([8.0, 12, 1, 10])
    return net, EdgeWeights(solo, solo, solo - [0, 5, 0, 0], "m", {})


def test_a_member_goes_out_of_its_way_for_the_master():
    plans = both(*detour(), {"A": (0, 2), "B": (3, 2)})
    for plan in plans:
        assert [vehicle.joint_cost for vehicle in plan.vehicles] == [15, 13]
        assert plan.proof.kind == "exact"
    assert "members and master pay least in all" in plans[1].proof.conditions
    (_, selfish) = both(*detour(), {"A": (0, 2), "B": (3, 2)}, objective="member")
    assert selfish.joint_cost == 30


def test_one_companion_is_enough_for_the_master():
    # With half of the gain each, neither B nor C would come; one of the two must, and only one.
    for plan in both(*detour(), {"A": (0, 2), "B": (3, 2), "C": (3, 2)}):
        assert plan.joint_cost == 15 + 13 + 10
        assert sorted(one.role for one in plan.vehicles) == ["alone", "master", "member"]
        assert plan.proof.bound is None or plan.proof.bound <= 38


def drawn(rng, members):
    """Return a road of some junctions, places beside it, and weights in whole numbers."""
    length = rng.randint(2, 5)
    pairs = [(k, k + 1) for k in range(length)]
    places = {"A": (0, length)}
    node = length + 1
    for k in range(members):
        begin, end = node, node + 1
        node += 2
        i = rng.randint(0, length - 1)
        j = rng.randint(i + 1, length)
        pairs += [(begin, i), (j, end), (begin, end)]
        places["BCDE"[k]] = begin, end
    order = sorted(pairs)
    # Company is worth a little more, or less, than the way to it.
    direct = np.array([float(a > length and b > length) for a, b in order])
    beside = np.array([float(a > length or b > length) for a, b in order]) - direct
    net = network(order, [rng.randint(1, 20) for _ in order])
    road = np.array([float(rng.randint(8, 16)) for _ in order])
    solo = np.where(direct > 0, 3 * road, np.where(beside > 0, np.round(road / 2), road))
    platoon = solo - [rng.randint(0, 3) for _ in order]
    master = solo - [rng.randint(0, 4) for _ in order]
    return net, EdgeWeights(solo, platoon, master, "m", {}), places


@pytest.mark.parametrize("members", [1, 3])
def test_bounds_and_costs_agree_with_the_planner_without_rules(members):
    rng = random.Random(members)
    together = exact = 0
    for _ in range(25):
        free, legal = both(*drawn(rng, members))
        least = free.joint_cost if free.proof.bound is None else free.proof.bound
        assert legal.joint_cost >= least - 1e-9
        assert legal.joint_cost <= legal.solo_cost + 1e-9
        bound = legal.joint_cost if legal.proof.bound is None else legal.proof.bound
        assert bound <= free.joint_cost + 1e-9
        if members == 1:
            assert legal.proof.kind == "exact"
            assert legal.joint_cost == pytest.approx(free.joint_cost)
        together += legal.joint_cost < legal.solo_cost - 1e-9
        exact += legal.proof.kind == "exact"
        worst = (legal.joint_cost - free.joint_cost) / (legal.solo_cost or 1.0)
        assert worst <= 0.05
    assert together >= 12
    assert exact >= 8
