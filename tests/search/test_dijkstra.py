"""Searches against a plain Bellman-Ford, on small networks of every shape."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import network
from weighted_networks import WEIGHTS, assert_path, bellman_ford, only, weighted

from platoon_osm.errors import NoRouteError
from platoon_osm.search.dijkstra import ReferenceEngine


@settings(max_examples=200, deadline=None)
@given(weighted())
def test_distances_and_paths_both_ways(case):
    net, weight = case
    engine = ReferenceEngine(net, weight)
    for forward in (True, False):
        table = engine.distances(range(net.n), forward)
        assert table.shape == (net.n, net.n)
        for source in range(net.n):
            expected = bellman_ford(net, weight, only(net, source), forward)
            np.testing.assert_allclose(table[source], expected)
            tree = engine.tree(source, forward)
            np.testing.assert_allclose(tree.dist, expected)
            assert tree.forward is forward
            for node in range(net.n):
                if np.isfinite(expected[node]):
                    ends = (source, node) if forward else (node, source)
                    assert_path(net, weight, tree.path(node), *ends, expected[node])
                else:
                    with pytest.raises(NoRouteError):
                        tree.path(node)


@settings(max_examples=100, deadline=None)
@given(weighted())
def test_distances_are_those_of_networkx(case):
    net, weight = case
    graph = nx.MultiDiGraph()
    graph.add_nodes_from(range(net.n))
    for e in np.flatnonzero(np.isfinite(weight)):
        graph.add_edge(int(net.tail[e]), int(net.head[e]), weight=weight[e])
    table = ReferenceEngine(net, weight).distances(range(net.n))
    for source in range(net.n):
        expected = nx.single_source_dijkstra_path_length(graph, source)
        assert {v: d for v, d in enumerate(table[source].tolist()) if d < np.inf} == expected


@settings(max_examples=200, deadline=None)
@given(weighted(), st.data())
def test_seeded(case, data):
    net, weight = case
    labels = np.array(data.draw(st.lists(WEIGHTS, min_size=net.n, max_size=net.n)), float)
    tree = ReferenceEngine(net, weight).seeded(labels)
    expected = bellman_ford(net, weight, labels)
    np.testing.assert_allclose(tree.dist, expected)
    for node in range(net.n):
        if np.isfinite(expected[node]):
            edges = tree.path(node)
            start = int(net.tail[edges[0]]) if len(edges) else node
            assert_path(net, weight, edges, start, node, expected[node] - labels[start])


def test_seeded_with_no_start_at_all():
    net = network([(0, 0), (1_000, 0)], [(0, 1)])
    tree = ReferenceEngine(net, [1.0]).seeded([np.inf, np.inf])
    assert np.isinf(tree.dist).all()
    for node in (0, 1):
        with pytest.raises(NoRouteError):
            tree.path(node)


@settings(max_examples=100, deadline=None)
@given(weighted(), st.data())
def test_many_to_many_from_either_side(case, data):
    net, weight = case
    node = st.integers(0, net.n - 1)
    sources, targets = data.draw(st.tuples(st.lists(node, max_size=5), st.lists(node, max_size=5)))
    table = ReferenceEngine(net, weight).many_to_many(sources, targets)
    assert table.shape == (len(sources), len(targets))
    for i, source in enumerate(sources):
        expected = bellman_ford(net, weight, only(net, source))
        np.testing.assert_allclose(table[i], expected[targets])


def test_of_parallel_edges_the_lightest_is_taken_and_of_equal_ones_the_first():
    net = network([(0, 0), (1_000, 0)], [(0, 1), (0, 1), (0, 1), (0, 1)])
    engine = ReferenceEngine(net, [5.0, 3.0, np.inf, 3.0])
    assert engine.tree(0).path(1).tolist() == [1]
    assert engine.tree(1, forward=False).path(0).tolist() == [1]


def test_infinite_weight_closes_an_edge():
    net = network([(0, 0), (1_000, 0)], [(0, 1)])
    assert np.isinf(ReferenceEngine(net, [np.inf]).distances(0)[0, 1])


def test_no_route_names_the_place_and_the_remedy():
    net = network([(0, 0), (1_000, 0)], [(0, 1)], node_name=["Torino", "Genova"])
    engine = ReferenceEngine(net, [1.0])
    with pytest.raises(NoRouteError, match=r"no route to Torino \(node 0\); choose another"):
        engine.tree(1).path(0)
    with pytest.raises(NoRouteError, match="no route from Genova"):
        engine.tree(0, forward=False).path(1)


@pytest.mark.parametrize(
    ("weight", "said"),
    [
        ([1.0], "weight has shape (1,); the network has 2 edges"),
        ([1.0, -2.0], "weight of edge 1 is -2.0; it must be 0 or more"),
        ([float("nan"), 1.0], "weight of edge 0 is nan"),
    ],
)
def test_weights_that_are_none(weight, said):
    net = network([(0, 0), (1_000, 0)], [(0, 1), (1, 0)])
    with pytest.raises(ValueError, match="weight") as caught:
        ReferenceEngine(net, weight)
    assert said in str(caught.value)


def test_distances_keep_the_order_and_the_repeats_of_the_question():
    net = network([(0, 0), (1_000, 0), (2_000, 0)], [(0, 1), (1, 2)], length_m=[1.0, 2.0])
    table = ReferenceEngine(net, net.length_m).distances([2, 0, 2])
    assert table[:, 2].tolist() == [0, 3, 0]
    assert ReferenceEngine(net, net.length_m).distances([]).shape == (0, 3)
