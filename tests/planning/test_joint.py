"""What must hold for every joint plan, on random networks; and what is refused."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import all_pairs
from random_networks import network, problems, road_networks

from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import NetworkError, NoRouteError, PlatoonError, ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.plan import JointPlan
from platoon_osm.plans.trip import Trip

CASES = ("A", "B", "C")
MODERATE = settings(max_examples=40, deadline=None)
PAPER = {"master": "longest", "company": "master"}
"""The paper's own rule: the longest route leads, and only who drives with it is in company."""
RULES = st.sampled_from([{}, PAPER])


def applicable_cases(trips):
    return (*CASES, "D") if len(trips) == 2 else CASES


def costs_of(plan):
    return [vehicle.joint_cost for vehicle in plan.vehicles]


def check_legs(net, weights, plan, trips):
    """Legs lead from origin to destination; their numbers can be recomputed edge by edge."""
    for vehicle, trip in zip(plan.vehicles, trips, strict=True):
        assert vehicle.vehicle == trip.vehicle
        edges = list(vehicle.edges)
        assert net.tail[edges[0]] == trip.origin == vehicle.origin.node
        assert net.head[edges[-1]] == trip.destination == vehicle.destination.node
        assert np.array_equal(net.head[edges[:-1]], net.tail[edges[1:]])
        cost = 0.0
        for leg in vehicle.legs:
            assert leg.edges
            weight = weights.platoon if leg.role == "platoon" else weights.solo
            leg_cost = sum(float(weight[edge]) for edge in leg.edges)
            assert leg.cost == pytest.approx(leg_cost)
            assert leg.length_m == pytest.approx(sum(net.length_m[edge] for edge in leg.edges))
            assert leg.time_s == pytest.approx(leg.length_m / (80 / 3.6))
            litres_per_m = 32 / 100_000 * (0.82 if leg.role == "platoon" else 1)
            assert leg.fuel_l == pytest.approx(leg.length_m * litres_per_m)
            assert (leg.role == "platoon") == bool(leg.partners)
            cost += leg_cost
        assert vehicle.joint_cost == pytest.approx(cost)
        assert vehicle.solo_cost == pytest.approx(
            float(weights.solo[list(vehicle.alone.edges)].sum())
        )


def company_by_edge(vehicle):
    return {edge: set(leg.partners) for leg in vehicle.legs for edge in leg.edges}


def check_partners(plan):
    """Whoever I drive with drives with me, on the same edges, and in the same platoon."""
    company = {vehicle.vehicle: company_by_edge(vehicle) for vehicle in plan.vehicles}
    for name, edges in company.items():
        for edge, partners in edges.items():
            assert name not in partners
            for partner in partners:
                assert company[partner][edge] | {partner} == partners | {name}


def check_points(net, plan, in_one_piece):
    for vehicle in plan.vehicles:
        assert (vehicle.merge is None) == (vehicle.separation is None) == (vehicle.role != "member")
        assert (vehicle.role == "alone") == bool(vehicle.reason)
        if vehicle.merge is None:
            continue
        together = [leg for leg in vehicle.legs if leg.role == "platoon"]
        assert vehicle.merge.node == net.tail[together[0].edges[0]]
        assert vehicle.separation.node == net.head[together[-1].edges[-1]]
        from_first_to_last = vehicle.separation.km - vehicle.merge.km
        if in_one_piece:
            assert from_first_to_last == pytest.approx(vehicle.platoon_m / 1000)
        assert from_first_to_last >= vehicle.platoon_m / 1000 - 1e-6
        before = vehicle.legs[0].length_m if vehicle.legs[0].role == "solo" else 0.0
        assert vehicle.merge.km == pytest.approx(before / 1000)


@MODERATE
@given(problems(), st.sampled_from(["member", "system"]), RULES)
def test_plans_can_be_driven_and_add_up(problem, objective, rules):
    net, weights, trips = problem
    for case in applicable_cases(trips):
        plan = plan_joint(net, weights, trips, case, objective=objective, **rules)
        check_legs(net, weights, plan, trips)
        check_partners(plan)
        check_points(net, plan, in_one_piece=case != "C" or bool(rules))
        assert plan.joint_cost == pytest.approx(sum(costs_of(plan)))
        assert plan.solo_cost == pytest.approx(sum(v.solo_cost for v in plan.vehicles))
        # The routes alone are the shortest there are.
        alone = all_pairs(net, weights.solo)
        for vehicle, trip in zip(plan.vehicles, trips, strict=True):
            assert vehicle.solo_cost == pytest.approx(alone[trip.origin][trip.destination])


@MODERATE
@given(problems(), RULES)
def test_never_dearer_than_alone(problem, rules):
    net, weights, trips = problem
    for case in applicable_cases(trips):
        plan = plan_joint(net, weights, trips, case, **rules)
        assert plan.joint_cost <= plan.solo_cost * (1 + 1e-9)
        if case != "D":  # in D one of the two may pay for the other's gain
            for vehicle in plan.vehicles:
                assert vehicle.joint_cost <= vehicle.solo_cost * (1 + 1e-9)
        system = plan_joint(net, weights, trips, case, objective="system", **rules)
        assert system.joint_cost <= system.solo_cost * (1 + 1e-9)


@MODERATE
@given(problems(), st.randoms(use_true_random=False))
def test_renumbering_nodes_changes_nothing(problem, random):
    net, weights, trips = problem
    new = list(range(net.n))
    random.shuffle(new)
    new = np.array(new)
    old = np.argsort(new)
    other = RoadNetwork.from_edges(
        new[net.tail], new[net.head], net.length_m, lon=net.lon[old], lat=net.lat[old]
    )
    renamed = [Trip(t.vehicle, int(new[t.origin]), int(new[t.destination])) for t in trips]
    for case in applicable_cases(trips):
        before = plan_joint(net, weights, trips, case)
        after = plan_joint(other, paper_weights(other, **paper_only(weights)), renamed, case)
        assert costs_of(after) == pytest.approx(costs_of(before), rel=1e-12)
        for one, two in zip(before.vehicles, after.vehicles, strict=True):
            assert one.role == two.role
            assert one.platoon_m == pytest.approx(two.platoon_m)
            for point in ("merge", "separation"):
                first, second = getattr(one, point), getattr(two, point)
                assert (first and new[first.node]) == (second and second.node)


def paper_only(weights):
    return {key: value for key, value in weights.params.items() if key != "preset"}


@MODERATE
@given(problems())
def test_a_and_b_never_beat_c(problem):
    net, weights, trips = problem
    plans = {case: plan_joint(net, weights, trips, case, **PAPER) for case in CASES}
    for case in "AB":
        for restricted, free in zip(plans[case].vehicles, plans["C"].vehicles, strict=True):
            # Each member chooses for itself; the master pays what the members' choices leave it.
            if free.role != "master":
                assert free.joint_cost <= restricted.joint_cost * (1 + 1e-9)


@MODERATE
@given(problems(most_trips=2))
def test_for_one_member_c_never_beats_d(problem):
    net, weights, trips = problem
    free = plan_joint(net, weights, trips, "D")
    assert free.proof["kind"] == "exact"
    for objective in ("member", "system"):
        for case in CASES:
            plan = plan_joint(net, weights, trips, case, objective=objective)
            assert free.joint_cost <= plan.joint_cost * (1 + 1e-9)


@MODERATE
@given(problems())
def test_driving_backwards_swaps_a_and_b(problem):
    net, weights, trips = problem
    turned, old_edge = net.reversed()
    back = [Trip(trip.vehicle, trip.destination, trip.origin) for trip in trips]
    turned_weights = paper_weights(turned, **paper_only(weights))
    assert np.array_equal(turned_weights.solo, weights.solo[old_edge])
    for case, mirrored in (("A", "B"), ("B", "A"), ("C", "C")):
        there = plan_joint(net, weights, trips, case, master="A", company="master")
        home = plan_joint(turned, turned_weights, back, mirrored, master="A", company="master")
        assert costs_of(home) == pytest.approx(costs_of(there))
        for one, two in zip(there.vehicles, home.vehicles, strict=True):
            assert one.role == two.role
            assert (one.merge and one.merge.node) == (two.separation and two.separation.node)
            assert (one.separation and one.separation.node) == (two.merge and two.merge.node)


@MODERATE
@given(problems())
def test_the_longest_route_is_the_master(problem):
    net, weights, trips = problem
    plan = plan_joint(net, weights, trips, "C", **PAPER)
    far = all_pairs(net, net.length_m)  # under the paper's weights least cost is shortest
    lengths = [far[trip.origin][trip.destination] for trip in trips]
    masters = [vehicle.vehicle for vehicle in plan.vehicles if vehicle.role == "master"]
    assert masters == [trips[int(np.argmax(np.round(lengths, 3)))].vehicle]


@MODERATE
@given(problems(), st.data())
def test_the_master_by_name_keeps_its_route(problem, data):
    net, weights, trips = problem
    name = data.draw(st.sampled_from([trip.vehicle for trip in trips]))
    plan = plan_joint(net, weights, trips, "C", master=name)
    master = next(vehicle for vehicle in plan.vehicles if vehicle.vehicle == name)
    assert master.role == "master"
    assert master.edges == master.alone.edges


@MODERATE
@given(problems())
def test_best_is_the_cheapest(problem):
    net, weights, trips = problem
    best = plan_joint(net, weights, trips, **PAPER, objective="system")
    assert best.asked == "best"
    each = {
        case: plan_joint(net, weights, trips, case, **PAPER, objective="system")
        for case in applicable_cases(trips)
    }
    least = min(plan.joint_cost for plan in each.values())
    assert best.joint_cost == pytest.approx(least, rel=2e-9)
    # Of equally good cases the first; where nobody gains by any, the one that is free in both.
    first = next(c for c, plan in each.items() if plan.joint_cost <= least * (1 + 2e-9))
    assert best.case == (first if any(v.merge for v in best.vehicles) else "C")


@MODERATE
@given(problems(), st.sampled_from(["A", "B", "C", "D", "best"]))
def test_json_round_trip(problem, case):
    net, weights, trips = problem
    if case == "D":
        trips = trips[:2]
    plan = plan_joint(net, weights, trips, case, objective="system")
    text = json.dumps(plan.to_dict(), allow_nan=False)
    assert JointPlan.from_dict(json.loads(text)) == plan


@MODERATE
@given(problems(), st.sampled_from(CASES))
def test_inflated_astar_reports_its_excess(problem, case):
    net, weights, trips = problem
    exact = plan_joint(net, weights, trips, case, **PAPER)
    greedy = plan_joint(net, weights, trips, case, method="astar")
    check_legs(net, weights, greedy, trips)
    check_partners(greedy)
    assert greedy.method == "astar"
    assert greedy.proof["kind"] == "heuristic"
    # Alone, no route beats Dijkstra's. With company a plan may, for its master goes another way.
    for one, two in zip(greedy.vehicles, exact.vehicles, strict=True):
        assert one.solo_cost >= two.solo_cost * (1 - 1e-9)
    assert greedy.proof["solo_excess"] == pytest.approx(greedy.solo_cost / exact.solo_cost - 1)
    assert greedy.proof["solo_excess"] >= -1e-9
    assert greedy.proof["optimum"] == pytest.approx(exact.joint_cost)
    assert greedy.proof["excess"] == pytest.approx(greedy.joint_cost / exact.joint_cost - 1)
    masters = [[v.vehicle for v in p.vehicles if v.role == "master"] for p in (exact, greedy)]
    assert masters[0] == masters[1]
    same_way = all(
        one.alone.edges == two.alone.edges
        for one, two in zip(greedy.vehicles, exact.vehicles, strict=True)
        if one.role == "master"
    )
    if same_way:
        for one, two in zip(greedy.vehicles, exact.vehicles, strict=True):
            if one.role != "master":
                assert one.joint_cost >= two.joint_cost * (1 - 1e-9)


def test_inflated_astar_does_take_worse_routes():
    # F falls off again far from the goal, so the far node 1 looks better than the near node 2.
    # The way over node 1 is three times as long.
    net = network([0, 0, 1, 2], [1, 2, 3, 3], [6e5, 2e5, 6e5, 2e5],
                  lon=[9, 0, 10, 11], lat=[45, 45, 45, 45])  # fmt: skip
    weights = paper_weights(net)
    exact = plan_joint(net, weights, [Trip("A", 0, 3)], "C")
    greedy = plan_joint(net, weights, [Trip("A", 0, 3)], "C", method="astar")
    assert exact.vehicles[0].length_m == 4e5
    assert greedy.vehicles[0].length_m == 12e5
    assert greedy.proof["excess"] == pytest.approx(2.0)


@MODERATE
@given(problems(trips_at_least=1, most_trips=1), st.sampled_from([*CASES, "best"]))
def test_a_single_trip_is_planned_as_it_is(problem, case):
    net, weights, trips = problem
    for objective in ("member", "system"):
        plan = plan_joint(net, weights, trips, case, objective=objective)
        assert plan.joint_cost == plan.solo_cost
        assert plan.vehicles[0].role == "master"
        check_legs(net, weights, plan, trips)


# -- members left out ----------------------------------------------------------------------------


@pytest.fixture
def road():
    """A road 0 - 1 - 2 - 3 of 10 km edges; 4 joins at 1, and 5 leaves at 2."""
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    return net, paper_weights(net)


@pytest.mark.parametrize(
    ("case", "reason"),
    [
        ("A", "case A does not apply: its destination is not on the route of A"),
        ("B", "case B does not apply: its origin is not on the route of A"),
    ],
)
def test_a_case_that_cannot_apply_says_why(road, case, reason):
    trips = [Trip("A", 0, 3), Trip("B", 4, 5)]
    plan = plan_joint(*road, trips, case, master="A")
    assert (plan.vehicles[1].role, plan.vehicles[1].reason) == ("alone", reason)
    assert plan.joint_cost == plan.solo_cost
    assert plan_joint(*road, trips, "C", master="A").vehicles[1].role == "member"


def test_a_member_with_no_common_road_stays_alone(road):
    plan = plan_joint(*road, [Trip("A", 0, 3), Trip("B", 4, 1)], "C")
    assert plan.vehicles[1].reason == "driving alone costs less than any way with A"


def test_two_of_the_same_trip_drive_together_all_the_way(road):
    for case in "ABCD":
        plan = plan_joint(*road, [Trip("A", 0, 3), Trip("B", 0, 3)], case)
        assert [vehicle.platoon_m for vehicle in plan.vehicles] == [30e3, 30e3]


# -- what is refused -----------------------------------------------------------------------------

TWO = [Trip("A", 0, 3), Trip("B", 4, 5)]


@pytest.mark.parametrize(
    ("trips", "options", "kind", "message"),
    [
        ([], {}, ScenarioError, "no trips; give at least one"),
        (TWO, {"case": "E"}, ScenarioError, "case 'E' is unknown; use A, B, C, D, best"),
        (TWO, {"case": None}, ScenarioError, "case None is unknown"),
        (
            TWO,
            {"objective": "all"},
            ScenarioError,
            "objective 'all' is unknown; use member, system",
        ),
        (TWO, {"method": "bfs"}, ScenarioError, "method 'bfs' is unknown; use dijkstra, astar"),
        (TWO, {"master": "C"}, ScenarioError, "master 'C' has no trip; vehicles are A and B"),
        ([*TWO, Trip("C", 0, 2)], {"case": "D"}, ScenarioError, "two vehicles, not 3"),
        (TWO[:1], {"case": "D"}, ScenarioError, "two vehicles, not 1"),
        (TWO, {"case": "D", "method": "astar"}, ScenarioError, "beyond the paper's A"),
        ([*TWO, Trip("A", 0, 2)], {}, ScenarioError, "vehicle 'A' has 2 trips"),
        ([Trip("A", 2, 2)], {}, ScenarioError, "'A': origin and destination are the same place"),
        ([Trip("A", 0, 3), Trip("B", 3, 0)], {}, NoRouteError, "trip 'B': no route from"),
        ([Trip("A", 0, 6)], {}, NetworkError, "node 6: the network has nodes 0 to 5"),
    ],
)
def test_refused_in_one_line(road, trips, options, kind, message):
    with pytest.raises(PlatoonError, match=message) as error:
        plan_joint(*road, trips, **options)
    assert type(error.value) is kind
    assert "\n" not in str(error.value)


@settings(max_examples=10, deadline=None)
@given(road_networks())
def test_the_same_input_gives_the_same_plan(net):
    weights = paper_weights(net)
    trips = [Trip("A", 0, 2), Trip("B", 1, 3), Trip("C", 3, 0)]
    assert plan_joint(net, weights, trips) == plan_joint(net, weights, trips)


def test_inferred_road_is_remarked():
    net = RoadNetwork.from_edges(
        [0, 1], [1, 2], [10e3, 300], lon=[9, 9.1, 9.2], lat=[45] * 3, inferred=[False, True]
    )
    plan = plan_joint(net, paper_weights(net), [Trip("A", 0, 2)], "C")
    assert plan.remarks[0].startswith("A drives 0.3 km over 1 connectors that were inferred")
