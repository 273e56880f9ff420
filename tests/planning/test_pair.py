"""Case D against trying every pair of nodes to meet and to part at."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import all_pairs, pair_optimum
from random_networks import network, tied_networks

from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import NoRouteError
from platoon_osm.planning.pair import plan_pair


def check_plan(net, weights, origins, destinations, plan):
    """The plan's edges are drivable, and cost what the plan says."""
    both = weights.master + weights.platoon
    cost = float(both[plan.shared].sum())
    for k in (0, 1):
        cost += float(weights.solo[plan.before[k]].sum() + weights.solo[plan.after[k]].sum())
        path = np.concatenate([plan.before[k], plan.shared, plan.after[k]])
        nodes = net.path_nodes(path) if len(path) else [origins[k]]
        assert nodes[0] == origins[k]
        assert nodes[-1] == destinations[k]
        assert np.array_equal(net.head[path[:-1]], net.tail[path[1:]])
    assert cost == pytest.approx(plan.cost, abs=1e-9)


ENGINES = pytest.mark.parametrize("engine", ["reference", "hierarchy"])


@ENGINES
@settings(max_examples=250, deadline=None)
@given(data=st.data())
def test_every_pair_of_nodes_tried(engine, data):
    net, weights = data.draw(tied_networks(free_platoon=False))
    node = st.integers(0, net.n - 1)
    origins, destinations = (data.draw(st.tuples(node, node)) for _ in range(2))
    alone = all_pairs(net, weights.solo)
    if any(alone[o][g] == np.inf for o, g in zip(origins, destinations, strict=True)):
        with pytest.raises(NoRouteError, match="no route"):
            plan_pair(net, weights, origins, destinations, engine)
        return
    plan = plan_pair(net, weights, origins, destinations, engine)
    cost, metres = pair_optimum(net, weights, origins, destinations)
    assert plan.cost == cost
    # Of equally good plans the longest platoon, counted in metres.
    assert float(net.length_m[plan.shared].sum()) == -metres
    assert plan.solo_cost == alone[origins[0]][destinations[0]] + alone[origins[1]][destinations[1]]
    check_plan(net, weights, origins, destinations, plan)
    if len(plan.shared):
        assert plan.merge == net.tail[plan.shared[0]]
        assert plan.separation == net.head[plan.shared[-1]]
    else:
        assert plan.merge == plan.separation == -1


@ENGINES
@settings(max_examples=100, deadline=None)
@given(data=st.data())
def test_platoons_may_be_free(engine, data):
    # With costs of 0, ways of any length tie; the cost must still be the least.
    net, weights = data.draw(tied_networks())
    node = st.integers(0, net.n - 1)
    origins, destinations = (data.draw(st.tuples(node, node)) for _ in range(2))
    try:
        plan = plan_pair(net, weights, origins, destinations, engine)
    except NoRouteError:
        return
    assert plan.cost == pair_optimum(net, weights, origins, destinations)[0]
    check_plan(net, weights, origins, destinations, plan)


def line(platoon, length=None):
    """Two vehicles along 0 - 1 - 2 - 3; alone each edge costs 10."""
    net = network([0, 1, 2], [1, 2, 3], [1, 1, 1] if length is None else length)
    solo = np.full(3, 10.0)
    return net, EdgeWeights(solo, np.array(platoon, float), np.array(platoon, float), "m", {})


def test_both_gain_and_stay_together():
    plan = plan_pair(*line([8, 8, 8]), (0, 1), (3, 3))
    assert (plan.merge, plan.separation, plan.cost, plan.solo_cost) == (1, 3, 10 + 32, 50)


def test_without_any_gain_they_drive_together_all_the_same():
    # The paper maximises the platoon among plans of least cost; a tie is no reason to part.
    plan = plan_pair(*line([10, 10, 10]), (0, 0), (3, 3))
    assert (plan.merge, plan.separation, plan.cost) == (0, 3, 60)


def test_where_company_costs_more_they_stay_apart():
    plan = plan_pair(*line([11, 11, 11]), (0, 0), (3, 3))
    assert (plan.merge, plan.cost) == (-1, 60)
    assert plan.shared.tolist() == []


def test_they_take_the_middle_only_if_it_alone_gains():
    plan = plan_pair(*line([11, 5, 11]), (0, 0), (3, 3))
    assert (plan.merge, plan.separation, plan.cost) == (1, 2, 50)


def test_the_leader_may_pay_another_price():
    net, weights = line([8, 8, 8])
    weights = EdgeWeights(weights.solo, weights.platoon, np.full(3, 9.0), "m", {})
    assert plan_pair(net, weights, (0, 0), (3, 3)).cost == 3 * (8 + 9)


def test_a_platoon_of_no_length_is_none():
    plan = plan_pair(*line([10, 10, 10], length=[0, 0, 0]), (0, 0), (3, 3))
    assert plan.merge == -1
