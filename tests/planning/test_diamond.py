"""Four places, four roads, solved by hand: the whole planner on one page.

            north
           /     \\
     10  /         \\ 10
       /             \\
    west              east          all roads are one-way, from west to east,
       \\             /              and 1 km from south up to north
     12  \\    1     /  9
           \\  |   /
            south

Alone a kilometre costs 3, in a platoon 2.

A drives west to east: over north 10 + 10 = 20 km, over south 12 + 9 = 21 km. So over north, for 60.
B drives south to east: directly 9 km, for 27; over north 1 + 10 = 11 km, for 33.
"""

import numpy as np
import pytest
from random_networks import network

from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.trip import Trip

WEST, NORTH, SOUTH, EAST = range(4)
A, B = Trip("A", WEST, EAST), Trip("B", SOUTH, EAST)


@pytest.fixture
def diamond():
    roads = [
        (WEST, NORTH, 10), (WEST, SOUTH, 12), (NORTH, EAST, 10), (SOUTH, NORTH, 1), (SOUTH, EAST, 9)
    ]  # fmt: skip
    tails, heads, km = (np.array(column) for column in zip(*roads, strict=True))
    net = network(tails, heads, km * 1000.0)
    return net, EdgeWeights(km * 3.0, km * 2.0, km * 2.0, "EUR", {})


def test_alone(diamond):
    plan = plan_joint(*diamond, [A, B], "C")
    assert [vehicle.solo_cost for vehicle in plan.vehicles] == [60, 27]


def test_case_c_b_drives_up_to_north_and_joins_a(diamond):
    plan = plan_joint(*diamond, [A, B], "C", master="longest")
    a, b = plan.vehicles
    assert (a.role, b.role) == ("master", "member")
    # B: 1 km alone for 3, then 10 km together for 20: 23 instead of 27.
    assert (b.merge.node, b.separation.node) == (NORTH, EAST)
    assert (b.merge.km, b.separation.km) == (1, 11)
    assert b.joint_cost == 23
    # A: 10 km alone for 30, then 10 km together for 20.
    assert a.joint_cost == 50
    assert plan.joint_cost == 73


def test_case_a_is_the_same_for_b_ends_where_a_does(diamond):
    plan = plan_joint(*diamond, [A, B], "A", master="longest")
    assert plan.joint_cost == 73
    assert plan.vehicles[1].merge.node == NORTH


def test_case_b_does_not_apply_for_b_starts_off_the_route_of_a(diamond):
    plan = plan_joint(*diamond, [A, B], "B")
    assert plan.joint_cost == 60 + 27
    assert plan.vehicles[1].role == "alone"


def test_case_d_a_comes_by_the_longer_way_to_pick_b_up(diamond):
    plan = plan_joint(*diamond, [A, B], "D")
    a, b = plan.vehicles
    # A: 12 km alone for 36 and 9 km together for 18; B: 9 km together for 18.
    assert (a.joint_cost, b.joint_cost) == (54, 18)
    assert plan.joint_cost == 72
    assert (b.merge.node, b.separation.node) == (SOUTH, EAST)
    assert b.merge.km == 0
    assert a.merge.km == 12


def test_best_is_that_a_comes_to_b(diamond):
    # With A as master 73. That A joins B costs what D does, and is simpler: A stays to the end.
    plan = plan_joint(*diamond, [A, B])
    assert (plan.case, plan.asked, plan.joint_cost) == ("A", "best", 72)
    assert [(one.vehicle, one.case, one.cost) for one in plan.masters] == [
        (1, "A", 72),
        (0, "A", 73),
    ]


def test_best_with_the_longest_as_master_is_case_d(diamond):
    plan = plan_joint(*diamond, [A, B], master="longest", company="master")
    assert (plan.case, plan.asked, plan.joint_cost) == ("D", "best", 72)


def test_with_b_as_master_a_joins_it(diamond):
    # B keeps its 9 km. A pays 36 + 18 = 54 to join it at south, less than its 60.
    a, b = plan_joint(*diamond, [A, B], "C", master="B").vehicles
    assert (b.role, b.joint_cost) == ("master", 18)
    assert (a.role, a.joint_cost, a.merge.node) == ("member", 54, SOUTH)


def test_a_third_vehicle_shares_what_is_there(diamond):
    # C drives west to north and so has A's company all the way: 20 instead of 30.
    a, b, c = plan_joint(*diamond, [A, B, Trip("C", WEST, NORTH)], "C").vehicles
    assert (a.joint_cost, b.joint_cost, c.joint_cost) == (40, 23, 20)
    assert [leg.partners for leg in a.legs] == [("C",), ("B",)]
