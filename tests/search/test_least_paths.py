"""Which of equally good paths is taken: the rule, tried on every path there is."""

import numpy as np
import pytest
from graphs import networks, road_like_networks, tied_grids, walk_cost
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import NoRouteError, SearchError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.pair import plan_pair
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.search.hierarchy.engine import HierarchyEngine
from platoon_osm.search.least_paths import LeastCosts
from platoon_osm.search.tie_rule import TIE

EXAMPLES = settings(max_examples=150, deadline=None)
ANY = st.one_of(networks(most_nodes=6, most_edges=14), tied_grids(), road_like_networks())


def engines(net, weight):
    return (
        ReferenceEngine(net, weight),
        HierarchyEngine(net, weight, threads=1),
        HierarchyEngine(net, weight, threads=3),
    )


def simple_paths(net, weight, start, end):
    """All paths without a circle over open edges, as tuples of edge ids."""
    stack = [(start, (), frozenset([start]))]
    while stack:
        node, path, seen = stack.pop()
        if node == end:
            yield path
            continue
        for edge in range(net.first_out[node], net.first_out[node + 1]):
            head = int(net.head[edge])
            if head not in seen and np.isfinite(weight[edge]):
                stack.append((head, (*path, edge), seen | {head}))


def by_the_rule(net, weight, starts, end):
    """Choose among all paths from all starts; `starts` maps nodes to what starting costs."""
    found = [
        (label + sum(weight[edge] for edge in path), len(path), start, path)
        for start, label in starts.items()
        for path in simple_paths(net, weight, start, end)
    ]
    least = min((item[0] for item in found), default=np.inf)
    good = [item for item in found if item[0] <= least * (1 + TIE)]
    return min(good, key=lambda item: item[1:])[3] if np.isfinite(least) else None


def check_all_ways(net, weight, start, end):
    """Both engines, from either end, take the path of the rule, and it costs the distance."""
    expected = by_the_rule(net, weight, {start: 0.0}, end)
    for engine in engines(net, weight):
        there, back = engine.tree(start), engine.tree(end, forward=False)
        for ask in (
            lambda tree=there: tree.path(end),
            lambda tree=back: tree.path(start),
            lambda one=engine: one.path(start, end),
        ):
            if expected is None:
                with pytest.raises(NoRouteError):
                    ask()
                continue
            path = ask()
            assert path.dtype == np.int64
            assert tuple(path.tolist()) == expected
            cost = walk_cost(net, weight, path, start, end)
            assert cost == pytest.approx(there.dist[end], rel=TIE + 1e-12, abs=0)


@EXAMPLES
@given(ANY, st.data())
def test_the_path_is_that_of_the_rule(case, data):
    net, weight = case
    node = st.integers(0, net.n - 1)
    check_all_ways(net, weight, data.draw(node), data.draw(node))


@EXAMPLES
@given(ANY, st.data())
def test_paths_from_many_starts(case, data):
    net, weight = case
    label = st.sampled_from([0.0, 1.0, 2.0, 3.5, float("inf"), float("inf")])
    labels = np.array(data.draw(st.lists(label, min_size=net.n, max_size=net.n)))
    end = data.draw(st.integers(0, net.n - 1))
    starts = {node: labels[node] for node in np.flatnonzero(np.isfinite(labels)).tolist()}
    expected = by_the_rule(net, weight, starts, end)
    for engine in engines(net, weight):
        tree = engine.seeded(labels)
        if expected is None:
            with pytest.raises(NoRouteError):
                tree.path(end)
        else:
            assert tuple(tree.path(end).tolist()) == expected


@EXAMPLES
@given(ANY, st.data())
def test_the_edges_to_many_nodes_are_those_of_their_paths(case, data):
    net, weight = case
    root = data.draw(st.integers(0, net.n - 1))
    engine = ReferenceEngine(net, weight)
    for forward in (True, False):
        tree = engine.tree(root, forward)
        reached = np.flatnonzero(np.isfinite(tree.dist)).tolist()
        ends = data.draw(st.lists(st.sampled_from(reached), unique=True))
        found = tree.edges_to(ends)
        assert len(set(found)) == len(found)
        assert set(found) >= {edge for end in ends for edge in tree.path(end).tolist()}
        hair = 3 * TIE * max((tree.dist[end] for end in ends), default=0.0)
        for edge in found:
            near, far = int(net.tail[edge]), int(net.head[edge])
            if not forward:
                near, far = far, near
            onward = engine.tree(far, forward).dist
            least = tree.dist[near] + weight[edge] + onward[ends] - tree.dist[ends]
            assert least.min() <= hair


@EXAMPLES
@given(ANY, st.data())
def test_shared_stretches(case, data):
    net, weight = case
    node = st.integers(0, net.n - 1)
    origins, destinations = data.draw(st.tuples(node, node)), data.draw(st.tuples(node, node))
    share = data.draw(st.sampled_from([1.0, 1.5, 1.75, 2.0]))
    pair = weight * share
    found = []
    for engine in engines(net, weight):
        there = list(engine.distances(origins))
        onward = list(engine.distances(destinations, forward=False))
        limit = there[0][destinations[0]] + there[1][destinations[1]]
        assume(np.isfinite(limit))
        slack = TIE * limit
        tree = engine.shared_stretch(pair, there, onward, limit + slack, slack)
        total = tree.dist + onward[0] + onward[1]
        good = np.flatnonzero(total <= min(limit, total.min()) + slack)
        found.append({end: tuple(tree.path(end).tolist()) for end in good.tolist()})
    assert found[0] == found[1] == found[2]
    labels = there[0] + there[1]
    starts = {v: labels[v] for v in np.flatnonzero(np.isfinite(labels)).tolist()}
    for end, path in found[0].items():
        assert path == by_the_rule(net, pair, starts, end)


@EXAMPLES
@given(ANY, st.data())
def test_plans_of_two_do_not_depend_on_the_engine(case, data):
    net, weight = case
    node = st.integers(0, net.n - 1)
    origins, destinations = data.draw(st.tuples(node, node)), data.draw(st.tuples(node, node))
    share = data.draw(st.sampled_from([0.0, 0.5, 0.75, 1.0]))
    weight = np.where(np.isfinite(weight), weight, 7.0)
    weights = EdgeWeights(weight, weight * share, weight, "m", {})
    plans = []
    for engine in ("reference", "hierarchy"):
        try:
            plans.append(plan_pair(net, weights, origins, destinations, engine))
        except NoRouteError as error:
            plans.append(str(error))
    one, other = plans
    if isinstance(one, str):
        assert one == other
        return
    assert one.cost == pytest.approx(other.cost, rel=TIE, abs=0)
    assert (one.merge, one.separation) == (other.merge, other.separation)
    assert one.shared.tolist() == other.shared.tolist()
    for part in ("before", "after"):
        for mine, theirs in zip(getattr(one, part), getattr(other, part), strict=True):
            assert mine.tolist() == theirs.tolist()


@pytest.mark.parametrize("side", [12, 40])
def test_large_grids_full_of_ties(side):
    # Weights of 0.1 are no sums that floats hold exactly, so costs differ in their last digits.
    net = grid(side, side)
    weight = np.full(net.m, 0.1)
    start, end = 0, net.n - 1
    paths = set()
    for engine in engines(net, weight):
        for path in (
            engine.tree(start).path(end), engine.tree(end, forward=False).path(start),
        ):  # fmt: skip
            walk_cost(net, weight, path, start, end)
            paths.add(tuple(path.tolist()))
    assert len(paths) == 1
    path = list(paths.pop())
    assert len(path) == 2 * side - 2
    # The smallest edge ids lead to the smallest nodes: first along the first row, then up.
    assert net.path_nodes(np.array(path)).tolist() == [
        *range(side), *range(2 * side - 1, side * side, side),
    ]  # fmt: skip


def grid(width, height):
    node = np.arange(width * height).reshape(height, width)
    a = np.concatenate([node[:, :-1].ravel(), node[:-1].ravel()])
    b = np.concatenate([node[:, 1:].ravel(), node[1:].ravel()])
    return RoadNetwork.from_edges(
        np.concatenate([a, b]), np.concatenate([b, a]), np.ones(2 * len(a)),
        lon=node.ravel() % width / 100, lat=node.ravel() // width / 100,
    )  # fmt: skip


def test_fewest_edges_come_before_the_smallest_ids():
    net = chain([(0, 1), (1, 3), (0, 2), (2, 3), (0, 3)])
    weight = np.array([1.0, 1.0, 3.0, 2.0, 2.0])  # edges sorted by tail: 01, 02, 03, 13, 23
    assert net.head.tolist() == [1, 2, 3, 3, 3]
    check_all_ways(net, weight, 0, 3)
    assert ReferenceEngine(net, weight).path(0, 3).tolist() == [2]
    assert ReferenceEngine(net, weight * [1, 1, 2, 1, 1]).path(0, 3).tolist() == [0, 3]


def test_of_parallel_edges_the_smallest_id_that_is_good_enough():
    net = chain([(0, 1)] * 4)
    for weight, expected in (
        ([3.0, 3.0, 3.0, 3.0], 0),
        ([np.inf, 3.0 * (1 + 1e-13), 3.0, 3.0], 1),
        ([3.1, 3.0 + 1e-9, 3.0, 3.0], 2),
    ):
        check_all_ways(net, np.array(weight), 0, 1)
        assert ReferenceEngine(net, weight).path(0, 1).tolist() == [expected]


@pytest.mark.parametrize("stages", [3, 30])
def test_slack_does_not_add_up(stages):
    # Each stage offers a dear edge of smaller id; only one of them is within the budget.
    excess = 0.7 * TIE * stages
    pairs = [(k, k + 1) for k in range(stages) for _ in range(2)]
    net = chain(pairs)
    weight = np.tile([1.0 + excess, 1.0], stages)
    expected = [0, *range(3, 2 * stages, 2)]
    for engine in engines(net, weight):
        for path in (
            engine.tree(0).path(stages), engine.tree(stages, forward=False).path(0),
        ):  # fmt: skip
            assert path.tolist() == expected
            assert weight[path].sum() <= stages * (1 + TIE)


def test_slack_does_not_add_up_over_shortcuts_either():
    # Two edges at once save one edge at 0.7 of the slack: only the first such stage may be taken.
    stages = 5
    pairs, costs = [], {}
    for k in range(stages):
        a, b, c = 2 * k, 2 * k + 1, 2 * k + 2
        pairs += [(a, b), (b, c), (a, c)]
        costs |= {(a, b): 1.0, (b, c): 1.0, (a, c): 2.0 + 0.7 * TIE * 2 * stages}
    net = chain(pairs)
    ends = zip(net.tail.tolist(), net.head.tolist(), strict=True)
    weight = np.array([costs[pair] for pair in ends])
    check_all_ways(net, weight, 0, 2 * stages)
    assert len(ReferenceEngine(net, weight).path(0, 2 * stages)) == 2 * stages - 1


def test_circles_of_no_cost_are_not_driven():
    net = chain([(0, 1), (1, 0), (1, 2), (2, 1), (2, 2), (2, 3), (3, 0)])
    for weight in (np.zeros(net.m), np.where(net.head == 3, 1.0, 0.0)):
        for end in range(4):
            check_all_ways(net, weight, 0, end)
        for engine in engines(net, weight):
            assert engine.seeded(np.zeros(net.n)).path(2).tolist() == []


def test_a_path_is_asked_of_a_node_of_the_network():
    net = chain([(0, 1)])
    tree = ReferenceEngine(net, [1.0]).tree(0)
    assert isinstance(tree, LeastCosts)
    for wrong in (-1, 2, None, "1", 0.5, [0, 1], True):
        with pytest.raises(SearchError):
            tree.path(wrong)


def chain(pairs):
    n = max(max(pair) for pair in pairs) + 1
    tails, heads = zip(*pairs, strict=True)
    lon, lat = np.arange(n) / 10, np.zeros(n)
    return RoadNetwork.from_edges(tails, heads, np.ones(len(pairs)), lon=lon, lat=lat)
