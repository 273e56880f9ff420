"""Both engines give the same answers, or the same errors."""

import numpy as np
import pytest
from graphs import networks, planar, walk_cost
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.errors import NoRouteError
from platoon_osm.search import engine as engines
from platoon_osm.search import price
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.search.hierarchy import engine as fast
from platoon_osm.search.hierarchy.engine import HierarchyEngine
from platoon_osm.search.hierarchy.fused.shared_stretch import shared_stretch

EXAMPLES = settings(max_examples=150, deadline=None)


def both(net, weight):
    return ReferenceEngine(net, weight), HierarchyEngine(net, weight, threads=2)


def same(a, b):
    assert a.shape == b.shape
    np.testing.assert_allclose(a, b, rtol=1e-12, atol=0)


@EXAMPLES
@given(networks())
def test_distances_both_ways(case):
    net, weight = case
    slow, quick = both(net, weight)
    everywhere = np.arange(net.n)
    for forward in (True, False):
        same(slow.distances(everywhere, forward), quick.distances(everywhere, forward))
        same(slow.distances([0, 0], forward), quick.distances([0, 0], forward))
        same(slow.distances([], forward), quick.distances([], forward))
        same(slow.tree(0, forward).dist, quick.tree(0, forward).dist)
        ends = [0, net.n - 1]
        for one, other in zip(slow.trees(ends, forward), quick.trees(ends, forward), strict=True):
            same(one.dist, other.dist)


@EXAMPLES
@given(networks(), st.data())
def test_many_to_many(case, data):
    net, weight = case
    slow, quick = both(net, weight)
    nodes = st.lists(st.integers(0, net.n - 1), max_size=net.n)
    sources, targets = data.draw(nodes), data.draw(nodes)
    same(slow.many_to_many(sources, targets), quick.many_to_many(sources, targets))
    same(slow.one_to_many(0, targets), quick.one_to_many(0, targets))


@EXAMPLES
@given(networks())
def test_paths_are_drivable_and_cost_the_distance(case):
    net, weight = case
    slow, quick = both(net, weight)
    away = slow.distances(np.arange(net.n))
    for source in range(net.n):
        there, back = quick.tree(source), quick.tree(source, forward=False)
        for node in range(net.n):
            for path, ends in (
                (lambda s=source, x=node: quick.path(s, x), (source, node)),
                (lambda t=there, x=node: t.path(x), (source, node)),
                (lambda t=back, x=node: t.path(x), (node, source)),
            ):
                if np.isinf(away[ends]):
                    with pytest.raises(NoRouteError):
                        path()
                else:
                    cost = walk_cost(net, weight, path(), *ends)
                    assert cost == pytest.approx(away[ends], rel=1e-12, abs=0)


@EXAMPLES
@given(networks(), st.data())
def test_seeded(case, data):
    net, weight = case
    label = st.sampled_from([0.0, 0.5, 2.0, 7.0, float("inf")])
    labels = np.array(data.draw(st.lists(label, min_size=net.n, max_size=net.n)))
    slow, quick = (engine.seeded(labels) for engine in both(net, weight))
    same(slow.dist, quick.dist)
    for node in range(net.n):
        if np.isinf(slow.dist[node]):
            for tree in (slow, quick):
                with pytest.raises(NoRouteError):
                    tree.path(node)
            continue
        edges = quick.path(node)
        start = int(net.tail[edges[0]]) if len(edges) else node
        cost = labels[start] + walk_cost(net, weight, edges, start, node)
        assert cost == pytest.approx(slow.dist[node], rel=1e-12, abs=0)


def check_shared_stretch(net, weight, pair, origins, destinations):
    """Wherever a plan worth its cost parts, both engines agree; else the fast one says more."""
    slow, quick = both(net, weight)
    there, onward = list(slow.distances(origins)), list(slow.distances(destinations, False))
    limit = there[0][destinations[0]] + there[1][destinations[1]]
    if np.isinf(limit):
        return 0
    slack = 1e-9 * limit
    known = slow.shared_stretch(pair, there, onward, limit + slack, slack)
    found = quick.shared_stretch(pair, there, onward, limit + slack, slack)
    total = known.dist + onward[0] + onward[1]
    least = min(limit, total.min())
    best = total <= least + slack
    same(known.dist[best], found.dist[best])
    assert (found.dist + onward[0] + onward[1] >= least - slack).all()
    for node in np.flatnonzero(best).tolist():
        edges = found.path(node)
        start = int(net.tail[edges[0]]) if len(edges) else node
        cost = there[0][start] + there[1][start] + walk_cost(net, pair, edges, start, node)
        assert cost == pytest.approx(known.dist[node], rel=1e-12, abs=0)
    outside = np.flatnonzero(np.isinf(found.dist))
    if len(outside):
        with pytest.raises(NoRouteError):
            found.path(int(outside[0]))
    restricted = shared_stretch(net, weight, pair, there, onward, limit + slack, slack)
    return restricted is not None


@EXAMPLES
@given(networks(), st.data())
def test_shared_stretches(case, data):
    net, weight = case
    ends = st.tuples(*[st.integers(0, net.n - 1)] * 2)
    ratio = data.draw(st.lists(st.sampled_from([0.0, 1.0, 1.5, 1.9, 2.0, 2.5]),
                               min_size=net.m, max_size=net.m))  # fmt: skip
    with np.errstate(invalid="ignore"):
        pair = np.nan_to_num(weight * np.array(ratio), nan=0.0, posinf=np.inf)
    check_shared_stretch(net, weight, pair, data.draw(ends), data.draw(ends))


@pytest.mark.parametrize("share", [0.2, 0.7, 0.9, 0.99])
def test_shared_stretches_on_planar_networks(share):
    net, weight = planar(2000, 9)
    rng = np.random.default_rng(3)
    few = []
    for _ in range(12):
        pair = 2 * weight * rng.uniform(share, 1.0, net.m)
        near = int(rng.integers(net.n - 30))
        origins = [near, near + int(rng.integers(30))]
        destinations = rng.integers(0, net.n, 2) if rng.random() < 0.5 else [5, 5]
        few.append(check_shared_stretch(net, weight, pair, origins, list(destinations)))
    assert any(few) or share < 0.5


@st.composite
def routes(draw, net):
    """Draw a walk of some edges."""
    edges = [draw(st.integers(0, net.m - 1))]
    for _ in range(draw(st.integers(0, 6))):
        node = net.head[edges[-1]]
        out = range(net.first_out[node], net.first_out[node + 1])
        if not out:
            break
        edges.append(draw(st.sampled_from(out)))
    return np.array(edges)


@EXAMPLES
@given(networks(), st.data())
def test_members_of_a_route(case, data):
    net, weight = case
    if not net.m:
        return
    route = data.draw(routes(net))
    nodes = net.path_nodes(route)
    share = data.draw(st.sampled_from([0.0, 0.5, 1.0, 1.5]))
    finite = np.where(np.isfinite(weight), weight, 4.0)[route]
    platoon = np.concatenate([[0.0], np.cumsum(finite * share)])
    length_m = np.concatenate([[0.0], np.cumsum(net.length_m[route])])
    ends = st.lists(st.integers(0, net.n - 1), max_size=12)
    origins = np.array(data.draw(ends), np.int64)
    destinations = data.draw(st.permutations(origins.tolist()))
    destinations = np.array(destinations, np.int64)
    positions = [
        data.draw(st.lists(st.integers(0, len(route)), unique=True)) for _ in range(len(origins))
    ]
    some = (
        np.concatenate([[0], np.cumsum([len(at) for at in positions])]).astype(np.int64),
        np.array([k for at in positions for k in at], np.int64),
    )
    slow, quick = both(net, weight)
    for entries, exits in ((None, None), (some, None), (None, some)):
        arguments = (nodes, origins, destinations, platoon, length_m, entries, exits)
        i, j, cost, solo = slow.best_on_route(*arguments)
        merge, leave, price, alone = quick.best_on_route(*arguments)
        assert i.tolist() == merge.tolist()
        assert j.tolist() == leave.tolist()
        same(cost, price)
        same(solo, alone)


@pytest.mark.parametrize("seed", range(3))
def test_planar_networks_of_two_thousand_nodes(seed):
    net, weight = planar(2000, seed)
    slow, quick = both(net, weight)
    rng = np.random.default_rng(seed)
    some = rng.integers(0, net.n, 70)
    for forward in (True, False):
        same(slow.distances(some, forward), quick.distances(some, forward))
        same(slow.distances(some[:3], forward), quick.distances(some[:3], forward))
    labels = np.where(rng.random(net.n) < 0.1, rng.random(net.n), np.inf)
    tree = quick.seeded(labels)
    same(slow.seeded(labels).dist, tree.dist)
    away = slow.distances(some[:20])
    for row, source in zip(away, some[:20].tolist(), strict=True):
        for node in some[np.isfinite(row[some])].tolist():
            cost = walk_cost(net, weight, quick.path(source, node), source, node)
            assert cost == pytest.approx(row[node], rel=1e-12)


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 8, 63, 64, 65, 130])
def test_tables_of_any_width(count):
    net, weight = planar(1500, 8)
    slow, quick = both(net, weight)
    some = np.random.default_rng(count).integers(0, net.n, count)
    for forward in (True, False):
        same(slow.distances(some, forward), quick.distances(some, forward))


@pytest.mark.parametrize("real", [True, False])
def test_members_on_planar_networks(real):
    net, weight = planar(2000, 7, real)
    slow, quick = both(net, weight)
    tree = slow.tree(11)
    reached = np.flatnonzero(np.isfinite(tree.dist))
    route = tree.path(int(reached[np.argmax(tree.dist[reached])]))
    platoon = np.concatenate([[0.0], np.cumsum(weight[route] * 0.75)])
    length_m = np.concatenate([[0.0], np.cumsum(net.length_m[route])])
    origins, destinations = np.random.default_rng(1).integers(0, net.n, (2, 500))
    found = [
        engine.best_on_route(net.path_nodes(route), origins, destinations, platoon, length_m)
        for engine in (slow, quick)
    ]
    assert (found[0][0] >= 0).sum() > 20
    for mine, theirs in zip(*found, strict=True):
        np.testing.assert_allclose(mine, theirs, rtol=1e-12)


def test_closing_roads_reuses_the_hierarchy():
    net, weight = planar(400, 3)
    first = HierarchyEngine(net, weight)
    closed = weight.copy()
    closed[::3] = np.inf
    again = HierarchyEngine(net, closed)
    assert again.metric.topology is first.metric.topology
    same(ReferenceEngine(net, closed).distances([5]), again.distances([5]))


def test_a_weight_changed_in_place_is_noticed():
    net, weight = planar(300, 4)
    for name in ("reference", "hierarchy"):
        before = engines.distances(net, weight, [0], engine=name)
        assert engines.engine_for(net, weight, name) is engines.engine_for(net, weight, name)
        weight *= 2
        same(engines.distances(net, weight, [0], engine=name), 2 * before)


@pytest.mark.parametrize("name", ["reference", "hierarchy"])
@pytest.mark.parametrize(
    ("ask", "message"),
    [
        (lambda net, w, e: engines.distances(net, w, [net.n], engine=e), "nodes 0 to"),
        (lambda net, w, e: engines.tree(net, w, -1, engine=e), "nodes 0 to"),
        (lambda net, w, e: engines.path(net, w, 0, net.n, engine=e), "nodes 0 to"),
        (lambda net, w, e: engines.many_to_many(net, w, [0], [-1], engine=e), "nodes 0 to"),
        (lambda net, w, e: engines.one_to_many(net, w, -2, [0], engine=e), "nodes 0 to"),
        (lambda net, w, e: engines.tree(net, w[1:], 0, engine=e), "weight has shape"),
        (lambda net, w, e: engines.tree(net, -1 - w, 0, engine=e), "must be 0 or more"),
        (lambda net, w, e: engines.tree(net, w * np.nan, 0, engine=e), "must be 0 or more"),
        (lambda net, w, e: engines.seeded(net, w, [0.0], engine=e), "labels have shape"),
        (lambda net, w, e: engines.seeded(net, w, -np.ones(net.n), engine=e), "label of node 0"),
        (lambda net, w, e: engines.tree(net, w, 0, engine=e + "s"), "s' is unknown"),
    ],
)
def test_same_errors(ask, message, name):
    net, weight = planar(50, 1)
    with pytest.raises(ValueError, match=message):
        ask(net, weight, name)


def test_auto_takes_the_reference_for_little_and_the_hierarchy_for_much(monkeypatch):
    net, weight = planar(3000, 2)
    monkeypatch.setattr(price, "_loaded", lambda: False)
    monkeypatch.setattr(price, "_compiled", lambda: False)
    assert engines.engine_for(net, weight, "auto", 1).name == "reference"
    assert engines.engine_for(net, weight, "auto", 10**7).name == "hierarchy"
    monkeypatch.setattr(price, "_loaded", lambda: True)
    assert engines.engine_for(net, weight, "auto", 100).name == "hierarchy"


def test_one_core_and_many_agree_to_the_last_bit(monkeypatch):
    for module in (
        "customization", "sweeping.sweeps", "sweeping.two_sweeps", "sweeping.batches",
        "fused.selection", "fused.members",
    ):  # fmt: skip
        monkeypatch.setattr(f"{fast.__package__}.{module}.WORTH_A_THREAD", 0)
    net, weight = planar(3000, 5)
    one, many = (HierarchyEngine(net, weight, threads=threads) for threads in (1, 3))
    assert len(one.metric.topology.subtree) > 2
    assert np.array_equal(one.metric.up, many.metric.up)
    assert np.array_equal(one.metric.down, many.metric.down)
    rng = np.random.default_rng(0)
    some = rng.integers(0, net.n, 100)
    labels = np.where(rng.random(net.n) < 0.1, rng.random(net.n), np.inf)
    tree = one.tree(int(some[0]))
    path = tree.path(int(some[np.isfinite(tree.dist[some])][-1]))
    steps = np.arange(len(path) + 1.0)
    for ask in (
        lambda e: e.tree(17).dist,
        lambda e: e.tree(17, forward=False).dist,
        lambda e: e.distances(some),
        lambda e: e.distances(some[:4]),
        lambda e: e.distances(some[:2], forward=False),
        lambda e: e.seeded(labels).dist,
        lambda e: e.many_to_many(some, some[:9]),
        lambda e: np.array(
            e.best_on_route(net.path_nodes(path), some, some[::-1], steps * 0.1, steps)
        ),
    ):
        assert np.array_equal(ask(one), ask(many))
