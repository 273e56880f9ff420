"""Members that choose for master and members together, against trying all combinations."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from oracles import all_pairs, system_optimum
from random_networks import network, problems, routes, tied_networks

from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import NoRouteError
from platoon_osm.planning.cases import choose_points, entry_exit_costs, route_nodes
from platoon_osm.planning.joint import plan_joint
from platoon_osm.planning.system import lower_bound
from platoon_osm.plans.trip import Trip
from platoon_osm.search.dijkstra import ReferenceEngine


def plan_and_optimum(data, most_members, members_at_least=1):
    net, weights = data.draw(tied_networks())
    assume(net.n >= 2)
    case = data.draw(st.sampled_from("ABC"))
    alone = all_pairs(net, weights.solo)
    ways = [(o, g) for o in range(net.n) for g in range(net.n) if o != g and alone[o][g] < np.inf]
    assume(ways)
    trips = data.draw(
        st.lists(st.sampled_from(ways), min_size=members_at_least + 1, max_size=most_members + 1)
    )
    named = [Trip("ABCD"[k], *trip) for k, trip in enumerate(trips)]
    plan = plan_joint(net, weights, named, case, objective="system", master="A", company="master")
    route = np.array(plan.vehicles[0].alone.edges)
    optimum = system_optimum(net, weights, route, trips[1:], case)
    return net, weights, named, case, plan, optimum


@settings(max_examples=120, deadline=None)
@given(st.data())
def test_one_member_is_exact(data):
    *_, plan, optimum = plan_and_optimum(data, most_members=1)
    assert plan.joint_cost == pytest.approx(optimum, abs=1e-9)
    assert plan.proof["kind"] == "exact"


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_bound_below_optimum_below_cost(data):
    *_, plan, optimum = plan_and_optimum(data, most_members=3, members_at_least=2)
    assert plan.joint_cost >= optimum - 1e-9
    if plan.proof["kind"] == "exact":
        assert plan.joint_cost == pytest.approx(optimum, abs=1e-6)
    else:
        assert plan.proof["bound"] <= optimum + 1e-9
        gap = (plan.joint_cost - plan.proof["bound"]) / plan.joint_cost
        assert plan.proof["gap"] == pytest.approx(gap)


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_any_price_proves_a_bound(data):
    # Tested apart, for a plan hides a bound above its own cost.
    net, weights = data.draw(tied_networks())
    route = data.draw(routes(net))
    node = st.integers(0, net.n - 1)
    trips = data.draw(st.lists(st.tuples(node, node), min_size=1, max_size=3))
    alone = all_pairs(net, weights.solo)
    assume(all(alone[o][g] < np.inf for o, g in trips))
    origins, destinations = np.transpose(trips)
    engine = ReferenceEngine(net, weights.solo)
    costs = entry_exit_costs(engine, route_nodes(net, route), origins, destinations)
    gain = (weights.solo - weights.master)[route]
    price = gain * [data.draw(st.sampled_from([0, 0.25, 0.5, 1])) for _ in route]
    relaxed = choose_points(
        net, weights, route, origins, destinations, "C", costs, gain=np.tile(price, (len(trips), 1))
    )
    optimum = system_optimum(net, weights, route, trips, "C") - float(weights.solo[route].sum())
    bound = lower_bound(relaxed, price, gain)
    assert bound <= optimum + 1e-9
    if len(trips) == 1 and (price == gain).all():
        assert bound == pytest.approx(optimum, abs=1e-6)


@settings(max_examples=50, deadline=None)
@given(problems(), st.sampled_from("ABC"))
def test_together_never_dearer_than_each_for_itself(problem, case):
    net, weights, trips = problem
    system = plan_joint(net, weights, trips, case, objective="system")
    member = plan_joint(net, weights, trips, case, objective="member")
    assert system.joint_cost <= member.joint_cost * (1 + 1e-9)
    assert system.solo_cost == pytest.approx(member.solo_cost)


def detour_network():
    """The road 0 - 1 - 2 of the master, and a place 3 off it, from where members go to 2.

    Directly a member pays 10; by the road 1 + 12 = 13, but there the master saves 5.
    """
    net = network([0, 1, 3, 3], [1, 2, 1, 2], [8, 12, 1, 10])
    solo = np.array([8.0, 12, 1, 10])
    weights = EdgeWeights(solo, solo, solo - [0, 5, 0, 0], "m", {})
    return net, weights


def test_a_member_goes_out_of_its_way_for_the_master():
    net, weights = detour_network()
    trips = [Trip("A", 0, 2), Trip("B", 3, 2)]
    selfish = plan_joint(net, weights, trips, "C", objective="member", master="A")
    assert selfish.vehicles[1].role == "alone"
    assert selfish.joint_cost == 20 + 10
    shared = plan_joint(net, weights, trips, "C", objective="system", master="A", company="master")
    # B pays 3 more than alone, A 5 less.
    assert [vehicle.joint_cost for vehicle in shared.vehicles] == [15, 13]
    assert shared.proof["kind"] == "exact"


def test_one_companion_is_enough_for_the_master():
    # With half of the gain each, neither B nor C would come; one of the two must, and only one.
    net, weights = detour_network()
    trips = [Trip("A", 0, 2), Trip("B", 3, 2), Trip("C", 3, 2)]
    plan = plan_joint(net, weights, trips, "C", objective="system", master="A", company="master")
    assert plan.joint_cost == 15 + 13 + 10
    assert sorted(vehicle.role for vehicle in plan.vehicles) == ["alone", "master", "member"]
    if plan.proof["kind"] == "bound":
        assert plan.proof["bound"] <= 38


def test_many_members_in_a_moment():
    # 60 members on a road of 200 edges; turns must not plan everybody each time.
    n = 201
    net = network(range(n - 1), range(1, n), np.ones(n - 1))
    weights = EdgeWeights(np.full(n - 1, 3.0), np.full(n - 1, 2.0), np.full(n - 1, 2.5), "m", {})
    trips = [Trip("master", 0, n - 1)]
    trips += [Trip(f"m{k}", k, n - 1 - k) for k in range(60)]
    plan = plan_joint(net, weights, trips, "C", objective="system", master="master")
    assert plan.proof["kind"] == "exact"
    assert plan.joint_cost == 2.5 * 200 + 2 * sum(200 - 2 * k for k in range(60))


@pytest.mark.parametrize(
    ("follows", "together"), [(1.0, False), (0.8, False), (0.4, True), (0.0, True)]
)
def test_a_master_pays_for_company_only_where_the_others_gain_more(follows, together):
    """On the second edge company costs the master half more; one member saves 1 - `follows`."""
    net = network([0, 1], [1, 2], [1, 1])
    weights = EdgeWeights(np.ones(2), np.full(2, follows), np.array([1.0, 1.5]), "m", {})
    trips = [Trip("A", 0, 2), Trip("B", 1, 2)]
    plan = plan_joint(net, weights, trips, "C", objective="system", master="A")
    assert any(stretch.together for stretch in plan.stretches) is together
    assert plan.joint_cost == pytest.approx(min(3.0, 2.5 + follows))
    assert plan.proof.kind == "exact"


def test_what_company_costs_the_master_counts_once():
    net = network([0, 1], [1, 2], [1, 1])
    weights = EdgeWeights(np.ones(2), np.full(2, 0.7), np.array([1.0, 1.5]), "m", {})
    trips = [Trip("A", 0, 2), Trip("B", 1, 2), Trip("C", 1, 2)]
    plan = plan_joint(net, weights, trips, "C", objective="system", master="A")
    assert plan.joint_cost == pytest.approx(2.5 + 1.4)
    assert plan.proof.cost * (1 - (plan.proof.gap or 0)) <= 3.9


def test_a_way_that_is_none():
    net, weights = detour_network()
    with pytest.raises(NoRouteError):
        plan_joint(net, weights, [Trip("A", 0, 2), Trip("B", 2, 3)], "C", objective="system")
