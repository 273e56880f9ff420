"""A network with places on it is the same road: cut, and with ways to places beside it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import both_ways, network, random_networks

from platoon_osm.costs.paper import PaperCosts, paper_weights
from platoon_osm.costs.placed_weights import placed_weights
from platoon_osm.network.placed import whole_edges
from platoon_osm.network.preparing.placing import BesideRoad, placing
from platoon_osm.search.hierarchy.engine import HierarchyEngine
from platoon_osm.search.hierarchy.preparing import storage
from platoon_osm.search.hierarchy.preparing.storage import order_with_places, topology_of


@st.composite
def placings(draw):
    net = draw(random_networks())
    if net.m == 0:
        return net, [], []
    cut = st.tuples(st.integers(0, net.m - 1), st.floats(0.001, 0.999))
    cuts = draw(st.lists(cut, max_size=6))
    ways = st.lists(
        st.tuples(st.one_of(st.integers(0, net.n - 1), cut), st.floats(10, 9_000)),
        min_size=1, max_size=4, unique_by=lambda way: way[0],
    )  # fmt: skip
    beside = [
        BesideRoad(10.0 + k / 100, 45.3, draw(st.booleans()), tuple(draw(ways)), 14.0)
        for k in range(draw(st.integers(0, 3)))
    ]
    return net, cuts, beside


@settings(max_examples=120, deadline=None)
@given(placings())
def test_the_road_is_the_same(drawn):
    net, cuts, beside = drawn
    made = placing(net, cuts, beside)
    new = made.net
    new.validate()
    if new is net:
        return
    road = new.below_edge >= 0
    assert np.bincount(new.below_edge[road], new.length_m[road], net.m) == pytest.approx(
        net.length_m
    )
    assert np.array_equal(new.lon[: net.n], net.lon)
    assert np.array_equal(new.node_id[: net.n], net.node_id)
    assert len(set(new.node_id.tolist())) == len(set(net.node_id.tolist())) + new.n - net.n
    # Every shape begins and ends at its nodes.
    first, last = new.shape_first[:-1], new.shape_first[1:] - 1
    for ends, nodes in ((first, new.tail), (last, new.head)):
        assert new.shape_lon[ends] == pytest.approx(new.lon[nodes])
        assert new.shape_lat[ends] == pytest.approx(new.lat[nodes])
    for column in ("speed_mps", "road_class", "ref", "toll", "inferred", "way_id"):
        assert np.array_equal(
            getattr(new, column)[road], getattr(net, column)[new.below_edge[road]]
        )
    for edge in range(net.m):
        pieces = np.flatnonzero(new.below_edge == edge)
        pieces = pieces[np.argsort(new.begins[pieces])]
        assert (new.tail[pieces[0]], new.head[pieces[-1]]) == (net.tail[edge], net.head[edge])
        assert np.array_equal(new.head[pieces[:-1]], new.tail[pieces[1:]])
        assert whole_edges(new, pieces) == ((edge,), (0.0, 1.0))
    for place, node in zip(beside, made.beside, strict=True):
        leaving, arriving = (new.tail == node).sum(), (new.head == node).sum()
        ways = len(place.ways)
        assert (leaving, arriving) == ((ways, 0) if place.leaves else (0, ways))


def test_pieces_that_follow_each_other_are_one_edge_again():
    net = network([(0, 0), (10_000, 0), (20_000, 0)], [(0, 1), (1, 2), (2, 0)])
    new = placing(net, [(0, 0.25), (0, 0.5), (1, 0.5)]).net
    path = [
        int(np.flatnonzero((new.below_edge == edge) & (new.begins == begin))[0])
        for edge, begin in ((0, 0.25), (0, 0.5), (1, 0.0))
    ]
    assert whole_edges(new, np.array(path)) == ((0, 1), (0.25, 0.5))


def test_a_cut_within_a_metre_of_a_node_is_the_node():
    net = network([(0, 0), (10_000, 0)], both_ways([(0, 1)]))
    made = placing(net, [(0, 0.00005), (1, 0.99995)])
    assert made.net is net
    assert made.node_of == {(0, 0.00005): 0, (1, 0.99995): 0}


def test_the_order_of_the_network_below_serves():
    """A place inside an edge goes first, one beside the road last; all else stays as it was."""
    rng = np.random.default_rng(5)
    side = 12
    nodes = [(4_000 * x, 4_000 * y) for x in range(side) for y in range(side)]
    pairs = [(k, k + 1) for k in range(side * side) if (k + 1) % side]
    pairs += [(k, k + side) for k in range(side * (side - 1))]
    net = network(nodes, both_ways(pairs))
    beside = BesideRoad(10.2, 45.2, True, ((3, 900.0), (17, 700.0), ((8, 0.3), 80.0)), 14.0)
    made = placing(net, [(int(e), 0.4) for e in rng.choice(net.m, 9)], [beside]).net
    below = topology_of(net).node
    order = order_with_places(made, below)
    assert sorted(order.tolist()) == list(range(made.n))
    assert order[-1] == made.n - 1
    assert np.array_equal(order[(order < net.n)], below)
    engine = HierarchyEngine(made, made.length_m)
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import dijkstra

    graph = csr_array((made.length_m, (made.tail, made.head)), shape=(made.n, made.n))
    sources = [0, made.n - 1, made.n - 3]
    assert engine.distances(sources) == pytest.approx(dijkstra(graph, indices=sources))


@pytest.mark.parametrize("most_last", [0, 1_000])
def test_many_places_beside_the_road_go_first(monkeypatch, most_last):
    monkeypatch.setattr(storage, "MOST_LAST", most_last)
    rng = np.random.default_rng(6)
    side = 6
    nodes = [(4_000 * x, 4_000 * y) for x in range(side) for y in range(side)]
    pairs = [(k, k + 1) for k in range(side * side) if (k + 1) % side]
    pairs += [(k, k + side) for k in range(side * (side - 1))]
    net = network(nodes, both_ways(pairs))
    beside = []
    for k in range(12):
        near = rng.choice(net.n, 4, replace=False).tolist()
        ways = tuple((node, float(rng.integers(100, 3000))) for node in near)
        beside.append(BesideRoad(10.0 + k / 100, 45.1, k % 2 == 0, ways, 14.0))
    made = placing(net, [], beside).net
    order = order_with_places(made, topology_of(net).node)
    assert sorted(order.tolist()) == list(range(made.n))
    assert (order[:12] >= net.n).all() == (most_last == 0)
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import dijkstra

    graph = csr_array((made.length_m, (made.tail, made.head)), shape=(made.n, made.n))
    sources = list(range(made.n))
    engine = HierarchyEngine(made, made.length_m)
    assert engine.distances(sources) == pytest.approx(dijkstra(graph, indices=sources))


def test_weights_of_a_way_beside_the_road():
    net = network([(0, 0), (10_000, 0), (20_000, 0)], both_ways([(0, 1), (1, 2)]))
    place = BesideRoad(10.1, 45.1, True, ((1, 1_000.0), ((0, 0.5), 500.0)), 14.0)
    new = placing(net, [], [place]).net
    way = new.below_edge < 0
    costs = PaperCosts(tau=1.0, xi=0.18)
    for given_weights in (costs, paper_weights(net, costs)):
        weights = placed_weights(given_weights, new, "test")
        assert weights.solo[way] == pytest.approx(costs.solo_factor() * new.length_m[way])
        assert np.array_equal(weights.platoon[way], weights.solo[way])
        assert np.array_equal(weights.master[way], weights.solo[way])
        assert weights.weights(new) is weights
        assert weights.solo[~way].sum() == pytest.approx(paper_weights(net, costs).solo.sum())
