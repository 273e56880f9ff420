"""A* against the paper's sentences, written down again with plain sets and dicts."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import network
from weighted_networks import assert_path, bellman_ford, only, weighted

from platoon_osm.errors import SearchError
from platoon_osm.search.astar import astar

MANY = settings(max_examples=300, deadline=None)


def plain_astar(net, weight, source, target, h, reopen):
    """The paper's text, sentence by sentence: (g of the target, its edges, nodes as explored)."""
    g, parent = {source: 0.0}, {}
    opened, closed, explored = {source}, set(), []
    while opened:
        u = min(opened, key=lambda v: (g[v] + h[v], v))
        opened.discard(u)
        closed.add(u)
        if u == target:
            edges = []
            while u != source:
                edges.insert(0, parent[u])
                u = int(net.tail[parent[u]])
            return g[target], edges, explored
        explored.append(u)
        for edge in np.flatnonzero(net.tail == u).tolist():
            v, via_u = int(net.head[edge]), g[u] + float(weight[edge])
            if not math.isfinite(via_u) or (not reopen and v in closed):
                continue
            if v not in opened | closed or via_u < g[v]:
                g[v], parent[v] = via_u, edge
                opened.add(v)
    return math.inf, [], explored


def costs_without_circles(net, weight, source):
    """For each node the different costs of all ways to it that pass no node twice."""
    found = [set() for _ in range(net.n)]

    def drive(node, cost, passed):
        found[node].add(cost)
        for edge in np.flatnonzero(net.tail == node).tolist():
            head = int(net.head[edge])
            if head not in passed and math.isfinite(weight[edge]):
                drive(head, cost + float(weight[edge]), passed | {head})

    drive(source, 0.0, {source})
    return found


@st.composite
def searches(draw):
    """A weighted network, two of its nodes, and whole numbers as a heuristic: so ties are exact."""
    net, weight = draw(weighted())
    source, target = (draw(st.integers(0, net.n - 1)) for _ in range(2))
    high = draw(st.sampled_from([0, 2, 9, 60]))
    heuristic = draw(st.lists(st.integers(0, high), min_size=net.n, max_size=net.n))
    return net, weight, source, target, np.array(heuristic, float)


@pytest.mark.parametrize("reopen", [True, False])
@MANY
@given(case=searches())
def test_both_rules_are_those_of_the_plain_text(case, reopen):
    net, weight, source, target, h = case
    cost, edges = astar(net, weight, source, target, h, reopen)
    g, expected, explored = plain_astar(net, weight, source, target, h, reopen)
    assert (cost, edges.tolist()) == (g, expected)
    if math.isfinite(cost):
        assert_path(net, weight, edges, source, target, cost)
        assert bellman_ford(net, weight, only(net, source))[target] <= cost
    # It ends, for no node is explored more often than it has costs; without reopening, than once.
    costs = costs_without_circles(net, weight, source)
    for node in set(explored):
        assert explored.count(node) <= (len(costs[node]) if reopen else 1)


@MANY
@given(searches())
def test_reopening_is_the_default(case):
    cost, edges = astar(*case)
    assert cost == astar(*case, reopen=True)[0]
    assert edges.tolist() == astar(*case, reopen=True)[1].tolist()


@MANY
@given(weighted(), st.data())
def test_it_is_optimal_with_a_consistent_heuristic_under_both_rules(case, data):
    net, weight = case
    source, target = (data.draw(st.integers(0, net.n - 1)) for _ in range(2))
    to_target = bellman_ford(net, weight, only(net, target), forward=False)
    best = bellman_ford(net, weight, only(net, source))[target]
    # Any share of the true remaining cost is admissible and consistent; 0 is plain Dijkstra.
    for share, reopen in itertools.product((0.0, 0.5, 1.0), (True, False)):
        known = np.where(np.isfinite(to_target), to_target, 1e6)
        cost, edges = astar(net, weight, source, target, share * known, reopen)
        assert cost == pytest.approx(best)
        if np.isfinite(best):
            assert_path(net, weight, edges, source, target, best)
        else:
            assert len(edges) == 0


@MANY
@given(weighted(), st.data())
def test_reopening_is_optimal_whenever_the_heuristic_never_exceeds_what_remains(case, data):
    net, weight = case
    source, target = (data.draw(st.integers(0, net.n - 1)) for _ in range(2))
    to_target = bellman_ford(net, weight, only(net, target), forward=False)
    below = np.array(data.draw(st.lists(st.floats(0, 1), min_size=net.n, max_size=net.n)))
    h = below * np.where(np.isfinite(to_target), to_target, 50.0)
    best = bellman_ford(net, weight, only(net, source))[target]
    assert astar(net, weight, source, target, h)[0] == pytest.approx(best)


def test_a_node_explored_once_keeps_the_dear_way():
    # Node 1 is explored at 9 before the way over 2, which the heuristic calls far, is found.
    net = network([(0, 0)] * 4, [(0, 1), (0, 2), (2, 1), (1, 3)], length_m=[9.0, 1.0, 1.0, 5.0])
    h = [0, 0, 10, 0]
    assert astar(net, net.length_m, 0, 3, h, reopen=False)[0] == 14
    assert astar(net, net.length_m, 0, 3, h)[0] == 7
    # Where the goal comes up before node 2, or no node comes up too early, the rules agree.
    for reopen in (True, False):
        assert astar(net, net.length_m, 0, 3, [0, 0, 20, 0], reopen)[0] == 14
        assert astar(net, net.length_m, 0, 3, [0, 0, 0, 0], reopen)[0] == 7


def doubling(count):
    """A chain of diamonds whose cheaper half is always found last: 2 ** count costs at its end.

    The heuristic calls each cheap half far, so that all below the dear one is explored before it.
    """
    ends, length, h = [], [], []
    for k in range(count):
        first, dear, cheap, last = 3 * k, 3 * k + 1, 3 * k + 2, 3 * k + 3
        saved = 2.0 ** (count - 1 - k)
        ends += [(first, dear), (first, cheap), (dear, last), (cheap, last)]
        length += [saved, 0.0, 0.0, 0.0]
        h += [0.0, 0.0, 2 * saved - 1 + (count - k) / (count + 1)]
    target = 3 * count + 1
    ends += [(3 * count, target)]
    return network([(0, 0)] * (target + 1), ends, length_m=[*length, 4.0**count]), [*h, 0.0, 0.0]


@pytest.mark.parametrize("count", [1, 2, 5, 8])
def test_it_ends_where_every_cheaper_way_is_found_late(count):
    net, h = doubling(count)
    target = net.n - 1
    _, _, explored = plain_astar(net, net.length_m, 0, target, h, True)
    assert explored.count(target - 1) == 2**count
    assert astar(net, net.length_m, 0, target, h)[0] == 4**count
    assert astar(net, net.length_m, 0, target, h, reopen=False)[0] == 4**count + 2**count - 1


@pytest.mark.parametrize("reopen", [1, 0, None, "yes"])
def test_what_is_neither_yes_nor_no_is_refused(reopen):
    net = network([(0, 0)] * 2, [(0, 1)], length_m=[1.0])
    with pytest.raises(SearchError, match=r"reopen = .* must be True or False"):
        astar(net, net.length_m, 0, 1, [0, 0], reopen)
