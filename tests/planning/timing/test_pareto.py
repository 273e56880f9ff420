"""Cheap and quick ways against all simple paths there are."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import platoon_osm as po
from platoon_osm.planning.timing.pareto import Budget, Reach, is_cheap_quick, labels_of

LARGE = 1e9


@st.composite
def networks(draw):
    """A few nodes, edges in any direction, small whole costs and times; some edges closed."""
    n = draw(st.integers(3, 5))
    pairs = draw(
        st.lists(
            st.tuples(st.integers(0, n - 1), st.integers(0, n - 1)), min_size=9, max_size=14
        )
    )  # fmt: skip
    edges = [(a, b) for a, b in pairs if a != b] or [(0, 1)]
    numbers = st.lists(st.integers(1, 6), min_size=len(edges), max_size=len(edges))
    cost = np.array(draw(numbers), float)
    time_s = (
        cost.copy()
        if draw(st.sampled_from([True, False, False]))
        else np.array(draw(numbers), float)
    )
    shut = np.array(draw(st.lists(st.sampled_from([False, False, False, True]),
                                  min_size=len(edges), max_size=len(edges))))  # fmt: skip
    net = po.RoadNetwork.from_edges(
        [a for a, _ in edges], [b for _, b in edges], np.ones(len(edges)),
        lon=np.arange(n) / 100, lat=np.zeros(n),
    )  # fmt: skip
    # Edges are sorted by their tails when a network is made.
    return net, np.where(shut, np.inf, cost), time_s


def simple_paths(net, weight, start):
    """Every path that meets no node twice, as edges, by the node where it ends."""
    found = {start: [()]}

    def walk(node, seen, path):
        for edge in range(net.m):
            to = int(net.head[edge])
            if int(net.tail[edge]) == node and to not in seen and np.isfinite(weight[edge]):
                found.setdefault(to, []).append((*path, edge))
                walk(to, seen | {to}, (*path, edge))

    walk(start, {start}, ())
    return found


def pareto(paths, weight, drive_s):
    """The points of which none is both cheaper and quicker."""
    points = {(sum(weight[list(p)]), sum(drive_s[list(p)])) for p in paths}
    return sorted(
        (c, t) for c, t in points if not any(a <= c and b <= t and (a, b) != (c, t)
                                             for a, b in points)
    )  # fmt: skip


def least(net, weight, root, forward):
    paths = simple_paths(net if forward else Turned(net), weight, root)
    found = np.full(net.n, np.inf)
    for node, every in paths.items():
        found[node] = min(sum(weight[list(p)]) for p in every)
    return found


class Turned:
    def __init__(self, net):
        self.m, self.tail, self.head = net.m, net.head, net.tail


def reach_of(net, weight, drive_s, root, forward):
    barred = np.where(np.isfinite(weight), drive_s, np.inf)
    return Reach(root, least(net, weight, root, forward), least(net, barred, root, forward))


@given(problem=networks(), forward=st.booleans())
@settings(max_examples=80)
def test_labels_are_all_points_of_which_none_is_better(problem, forward):
    net, weight, drive_s = problem
    reach = reach_of(net, weight, drive_s, 0, forward)
    free = Budget(LARGE, LARGE, np.zeros(net.n), np.zeros(net.n))
    found = labels_of(net, weight, drive_s, reach, free, forward)
    paths = simple_paths(net if forward else Turned(net), weight, 0)
    position, cost, time_s = found.at(np.arange(net.n))
    assert found.complete
    for node in range(net.n):
        own = position == node
        points = list(zip(cost[own], time_s[own], strict=True))
        assert points == pareto(paths.get(node, []), weight, drive_s)
        for c, t in points:
            route = found.route(node, t)
            assert (weight[route].sum(), drive_s[route].sum()) == (c, t)
            ends = (0, node) if forward else (node, 0)
            if len(route):
                assert (net.tail[route[0]], net.head[route[-1]]) == ends
                assert (net.head[route[:-1]] == net.tail[route[1:]]).all()


@given(problem=networks(), forward=st.booleans(), data=st.data())
@settings(max_examples=80)
def test_what_a_budget_leaves_out_could_not_pay_or_be_in_time(problem, forward, data):
    net, weight, drive_s = problem
    end = data.draw(st.integers(0, net.n - 1))
    most, most_s = data.draw(st.integers(0, 20)), data.draw(st.integers(0, 20))
    share = data.draw(st.sampled_from([0.0, 0.5, 1.0]))
    reach = reach_of(net, weight, drive_s, 0, forward)
    rest = reach_of(net, weight, drive_s, end, not forward)
    budget = Budget.of(most, most_s, rest, share)
    found = labels_of(net, weight, drive_s, reach, budget, forward)
    got = set(zip(*(column.tolist() for column in (found.node, found.cost, found.time_s)),
                  strict=True))  # fmt: skip
    paths = simple_paths(net if forward else Turned(net), weight, 0)
    for node, every in paths.items():
        for c, t in pareto(every, weight, drive_s):
            fits = (
                c + share * rest.cost[node] <= most and t + rest.time_s[node] <= most_s
                if np.isfinite(rest.cost[node]) else False
            )  # fmt: skip
            if fits:
                assert (node, c, t) in got
            elif node and not budget.within(reach)[node]:
                assert (node, c, t) not in got


@given(problem=networks(), forward=st.booleans())
@settings(max_examples=80)
def test_one_way_is_enough_where_cheap_is_quick(problem, forward):
    net, weight, drive_s = problem
    reach = reach_of(net, weight, drive_s, 0, forward)
    paths = simple_paths(net if forward else Turned(net), weight, 0)
    some = np.isin(np.arange(net.n), list(paths))
    expected = all(len(pareto(every, weight, drive_s)) == 1 for every in paths.values())
    assert is_cheap_quick(net, weight, drive_s, reach, some, forward) == expected


def test_a_search_that_gives_up_says_so(monkeypatch):
    monkeypatch.setattr("platoon_osm.planning.timing.pareto.MOST_LABELS", 2)
    net = po.RoadNetwork.from_edges(
        [0, 1, 2], [1, 2, 3], np.ones(3), lon=np.arange(4) / 100, lat=np.zeros(4)
    )
    one = np.ones(3)
    free = Budget(LARGE, LARGE, np.zeros(4), np.zeros(4))
    found = labels_of(net, one, one, Reach(0, np.arange(4.0), np.arange(4.0)), free, True)
    assert (found.complete, found.node.tolist()) == (False, [0, 1])


@pytest.mark.parametrize("forward", [True, False])
def test_edges_without_length_leave_it_open(forward):
    net = po.RoadNetwork.from_edges([0, 1], [1, 0], np.ones(2), lon=[0.0, 0.01], lat=[0.0, 0.0])
    none = np.zeros(2)
    reach = Reach(0, np.zeros(2), np.zeros(2))
    assert not is_cheap_quick(net, none, none, reach, np.ones(2, bool), forward)
