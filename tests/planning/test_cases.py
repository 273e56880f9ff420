"""The kernel of cases A, B and C against trying every pair of points."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import all_pairs, best_choice, member_choices
from random_networks import network, road_networks, routes, tied_networks

from platoon_osm.costs.paper import paper_weights
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.cases import (
    best_pairs,
    choose_points,
    entry_exit_costs,
    plan_members,
    route_nodes,
)
from platoon_osm.planning.member_plans import MemberPlans
from platoon_osm.search.dijkstra import ReferenceEngine


def choice_of(plans, k, net, route):
    """What a plan says of one member, in the oracle's terms."""
    i, j = int(plans.merge_index[k]), int(plans.separation_index[k])
    metres = float(net.length_m[route[i:j]].sum()) if i >= 0 else 0.0
    return float(plans.cost[k]), metres, i, j


@settings(max_examples=150, deadline=None)
@given(st.data())
@pytest.mark.parametrize("case", ["A", "B", "C"])
def test_every_pair_of_points_tried(case, data):
    net, weights = data.draw(tied_networks(company_never_dearer=False))
    route = data.draw(routes(net))
    origins, destinations = np.divmod(np.arange(net.n**2), net.n)
    plans = plan_members(net, weights, route, origins, destinations, case)
    nodes, alone = net.path_nodes(route), all_pairs(net, weights.solo)
    for k, (origin, destination) in enumerate(zip(origins, destinations, strict=True)):
        choices = member_choices(net, weights, route, origin, destination, case, alone)
        wanted, found = best_choice(choices), choice_of(plans, k, net, route)
        # Cost, metres and merging point are fixed by the rule; where edges of no length make two
        # separation points equal, either will do as long as it is a choice of that cost.
        assert found[:3] == wanted[:3]
        assert found in choices
        assert plans.solo_cost[k] == choices[0][0]
        on_route = {"A": destination in nodes, "B": origin in nodes, "C": True}[case]
        assert plans.applicable[k] == on_route
        if found[2] >= 0:
            assert plans.merge[k] == nodes[found[2]]
            assert plans.separation[k] == nodes[found[3]]
        else:
            assert plans.merge[k] == plans.separation[k] == -1


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_costs_of_real_numbers(data):
    # With lengths such as 48127.31 equal costs come with different last digits.
    net = data.draw(road_networks())
    weights = paper_weights(net)
    route, alone = data.draw(routes(net)), all_pairs(net, weights.solo)
    origins, destinations = np.divmod(np.arange(net.n**2), net.n)
    for case in "ABC":
        plans = plan_members(net, weights, route, origins, destinations, case)
        wanted = [
            best_choice(member_choices(net, weights, route, o, g, case, alone))[0]
            for o, g in zip(origins, destinations, strict=True)
        ]
        assert plans.cost == pytest.approx(np.array(wanted), rel=1e-9)


@settings(max_examples=50, deadline=None)
@given(st.data())
def test_all_at_once_equals_one_at_a_time(data):
    net, weights = data.draw(tied_networks())
    route = data.draw(routes(net))
    case = data.draw(st.sampled_from("ABC"))
    node = st.integers(0, net.n - 1)
    trips = data.draw(st.lists(st.tuples(node, node), min_size=1, max_size=12))
    together = plan_members(net, weights, route, *np.transpose(trips), case)
    for k, (origin, destination) in enumerate(trips):
        single = plan_members(net, weights, route, origin, destination, case)
        for name in MemberPlans.__slots__:
            assert getattr(single, name)[0] == getattr(together, name)[k], name


@settings(max_examples=50, deadline=None)
@given(st.data())
def test_search_from_the_route_equals_search_from_members(data):
    net, weights = data.draw(tied_networks())
    nodes = net.path_nodes(data.draw(routes(net)))
    engine = ReferenceEngine(net, weights.solo)
    # All nodes are more origins than a short route has nodes, and one is fewer: both branches.
    everywhere = np.arange(net.n)
    for goal in range(net.n):
        many = entry_exit_costs(engine, nodes[:1], everywhere, np.full(net.n, goal))
        back = entry_exit_costs(engine, nodes[:1], np.full(net.n, goal), everywhere)
        for k in everywhere:
            one = entry_exit_costs(engine, nodes[:1], everywhere[[k]], np.array([goal]))
            other = entry_exit_costs(engine, nodes[:1], np.array([goal]), everywhere[[k]])
            for group, single in zip(many, one, strict=True):
                assert np.array_equal(group[k], single[0])
            for group, single in zip(back, other, strict=True):
                assert np.array_equal(group[k], single[0])


class Counting:
    """An engine that says how many searches were asked of it."""

    def __init__(self, engine):
        self.engine, self.searches = engine, 0

    def distances(self, nodes, forward=True):
        self.searches += len(np.unique(nodes))
        return self.engine.distances(nodes, forward)


def test_searches_start_from_the_smaller_side():
    n = 40
    net = network(range(n - 1), range(1, n), np.ones(n - 1))
    weights = paper_weights(net)
    nodes = np.array([3, 4])
    engine = Counting(ReferenceEngine(net, weights.solo))
    # 30 members, all to one place: two searches to the route, one from the place, one for alone.
    entry_exit_costs(engine, nodes, np.arange(30), np.full(30, n - 1))
    assert engine.searches == 4


# -- the tie rule, each step by hand --------------------------------------------------------------


def line(platoon, entry=0.0, leave=0.0, solo=10.0, length=None):
    """Run the kernel for one member on a route of given platoon weights."""
    at = np.concatenate([[0.0], np.cumsum(platoon)])
    metres = at if length is None else np.concatenate([[0.0], np.cumsum(length)])
    size = len(at)
    i, j, cost = best_pairs(
        np.broadcast_to(np.asarray(entry, float), (1, size)),
        np.broadcast_to(np.asarray(leave, float), (1, size)),
        at, metres, np.array([float(solo)]),
    )  # fmt: skip
    return int(i[0]), int(j[0]), float(cost[0])


INF = np.inf


def test_least_cost_comes_first():
    # Along the route alone costs 2 an edge, in the platoon 1: the whole route is best.
    assert line([1, 1, 1], entry=[0, 2, 4, 6], leave=[6, 4, 2, 0], solo=6) == (0, 3, 3.0)


def test_of_equal_costs_the_longest_platoon():
    # Platoon and alone cost the same, so every pair of points costs 3.
    assert line([1, 1, 1], entry=[0, 1, 2, 3], leave=[3, 2, 1, 0], solo=3) == (0, 3, 3.0)


def test_longest_is_in_metres_not_in_edges():
    # Ends at node 1 or merges at node 1: one edge of 5 m beats two edges of 2 m in all.
    found = line(
        [1, 1, 1], entry=[0, 1, INF, INF], leave=[INF, 2, INF, 1], solo=9, length=[5, 1, 1]
    )
    assert found == (0, 1, 3.0)


def test_of_equal_lengths_the_earlier_merging_point():
    # 0 to 1 and 2 to 3 cost 5 and have 1 m each; 1 to 2 is dear.
    found = line([1, 9, 1], entry=[2, INF, 2, INF], leave=[INF, 2, INF, 2], solo=9)
    assert found == (0, 1, 5.0)


def test_as_dear_as_alone_still_joins():
    assert line([1], entry=[0, INF], leave=[INF, 0], solo=1) == (0, 1, 1.0)


def test_dearer_than_alone_stays_alone():
    assert line([1], entry=[0, INF], leave=[INF, 0], solo=0.99) == (-1, -1, 0.99)


def test_a_platoon_of_no_length_is_none():
    assert line([0], entry=[0, 0], leave=[1, 1], solo=1, length=[0]) == (-1, -1, 1.0)


def test_never_backwards():
    # Merging at the end and separating at the start would cost nothing, but roads are one-way.
    assert line([1, 1], entry=[INF, INF, 0], leave=[0, INF, INF], solo=5) == (-1, -1, 5.0)


def test_merging_and_separating_at_one_node_is_staying_alone():
    assert line([1], entry=[2, INF], leave=[3, INF], solo=5) == (-1, -1, 5.0)


def test_nowhere_to_go_stays_alone_at_infinite_cost():
    assert line([1, 1], entry=INF, leave=INF, solo=INF) == (-1, -1, INF)


def test_only_the_platoon_leads_there():
    assert line([1, 1], entry=[1, INF, INF], leave=[INF, INF, 1], solo=INF) == (0, 2, 4.0)


def test_last_digits_do_not_decide():
    # 0.1 + 0.2 is not 0.3 in binary, but the costs are meant to be equal.
    assert line([0.1, 0.2], entry=[0, INF, INF], leave=[INF, INF, 0], solo=0.3)[:2] == (0, 2)


# -- gains for others ----------------------------------------------------------------------------


def test_gain_counts_in_the_choice_but_not_in_the_cost():
    net = network([0, 1, 2], [1, 2, 3], [1, 1, 1])
    weights = EdgeWeights(np.full(3, 2.0), np.full(3, 2.5), np.full(3, 2.5), "m", {})
    origins, destinations = np.array([0]), np.array([3])
    costs = entry_exit_costs(
        ReferenceEngine(net, weights.solo), route_nodes(net, [0, 1, 2]), origins, destinations
    )

    def choose(gain):
        return choose_points(
            net, weights, [0, 1, 2], origins, destinations, "C", costs, gain=[gain]
        )

    assert choose([0, 0, 0]).merge_index[0] == -1
    # On the middle edge others gain 1, more than the half it costs the member.
    middle = choose([0, 1, 0])
    assert (middle.merge_index[0], middle.separation_index[0]) == (1, 2)
    assert middle.cost[0] == 2 + 2.5 + 2


# -- places with several nodes -------------------------------------------------------------------


def test_case_a_accepts_any_node_of_the_destination():
    # The member goes to node 4, the ramp of the place that node 2 on the route belongs to.
    net = network([0, 1, 2, 2], [1, 2, 3, 4], [10, 10, 10, 1])
    weights = paper_weights(net)
    strict = plan_members(net, weights, [0, 1, 2], [0], [4], "A")
    assert not strict.applicable[0]
    wide = plan_members(net, weights, [0, 1, 2], [0], [4], "A", exits=[{2, 4}])
    assert wide.applicable[0]
    assert (wide.merge[0], wide.separation[0]) == (0, 2)


def test_case_b_accepts_any_node_of_the_origin():
    net = network([0, 1, 2, 4], [1, 2, 3, 1], [10, 10, 10, 1])
    weights = paper_weights(net)
    assert not plan_members(net, weights, [0, 1, 2], [4], [3], "B").applicable[0]
    wide = plan_members(net, weights, [0, 1, 2], [4], [3], "B", entries=[{1, 4}])
    assert (wide.merge[0], wide.separation[0]) == (1, 3)


# -- bad input -----------------------------------------------------------------------------------


@pytest.fixture
def road():
    net = network([0, 1, 2], [1, 2, 3], [10, 10, 10])
    return net, paper_weights(net)


@pytest.mark.parametrize(
    ("route", "origins", "destinations", "case", "message"),
    [
        ([0, 1], [0], [2], "D", "case 'D'"),
        ([0, 1], [0], [2], "c", "case 'c'"),
        ([0, 1], [9], [2], "C", "origin 9: the network has nodes 0 to 3"),
        ([0, 1], [0], [-1], "C", "destination -1: the network has nodes 0 to 3"),
        ([], [0], [2], "C", "route: it has no edges"),
        ([0, 2], [0], [2], "C", "do not follow each other"),
        ([2, 3], [0], [2], "C", "edge 3: the network has edges 0 to 2"),
        ([-1], [0], [2], "C", "edge -1: the network has edges 0 to 2"),
        ([0, 1], [0, 1], [2], "C", "2 origins and 1 destinations"),
    ],
)
def test_bad_input_in_one_line(road, route, origins, destinations, case, message):
    with pytest.raises(ScenarioError, match=message) as error:
        plan_members(*road, route, origins, destinations, case)
    assert "\n" not in str(error.value)


def test_no_members(road):
    plans = plan_members(*road, [0, 1], [], [], "C")
    assert plans.cost.shape == (0,)
