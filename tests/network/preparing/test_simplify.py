"""Chains merged into single edges: nothing a route depends on may change."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import both_ways, network, random_networks

from platoon_osm.network.preparing.simplify import merge_chains
from platoon_osm.search.engine import many_to_many

LINE = [(0, 0), (1_000, 0), (2_000, 500), (3_000, 0)]


def line(edges=((0, 1), (1, 2), (2, 3)), **columns):
    columns = {"length_m": [1_000.0, 1_200.0, 1_100.0], **columns}
    return network(LINE, edges, **columns)


def test_a_one_way_chain_becomes_one_edge():
    net = line(speed_mps=[10.0, 20.0, 10.0], node_id=[5, 6, 7, 8])
    merged = merge_chains(net)
    assert (merged.n, merged.m) == (2, 1)
    assert merged.node_id.tolist() == [5, 8]
    assert merged.length_m[0] == pytest.approx(3_300)
    assert (merged.length_m / merged.speed_mps)[0] == pytest.approx(100 + 60 + 110)
    np.testing.assert_array_equal(merged.shape(0), net.path_shape([0, 1, 2]))


def test_a_two_way_chain_becomes_two_edges():
    net = network(LINE, both_ways([(0, 1), (1, 2), (2, 3)]))
    merged = merge_chains(net)
    assert (merged.n, merged.m) == (2, 2)
    np.testing.assert_array_equal(merged.shape(0), merged.shape(1)[::-1])


def test_nodes_worth_keeping_stay():
    net = line()
    merged = merge_chains(net, np.array([False, False, True, False]))
    assert merged.node_id.tolist() == [0, 2, 3]
    assert merged.length_m == pytest.approx([2_200, 1_100])


def test_a_toll_boundary_stays():
    merged = merge_chains(line(toll=[False, True, True]))
    assert merged.node_id.tolist() == [0, 1, 3]
    assert merged.toll.tolist() == [False, True]


def test_where_inferred_road_begins_stays():
    merged = merge_chains(line(inferred=[False, False, True]))
    assert merged.node_id.tolist() == [0, 2, 3]
    assert merged.inferred.tolist() == [False, True]


def test_names_are_those_of_the_longest_part():
    net = line(
        ref=["A1", "A2", "A1"], name=["short", "longest of all", ""], way_id=[1, 2, 3],
        road_class=[0, 1, 0], length_m=[1_000.0, 1_200.0, 900.0],
    )  # fmt: skip
    merged = merge_chains(net)
    # A1 holds on two parts, 1.9 km together; the class likewise; way and name on 1.2 km.
    assert merged.edge_ref(0) == "A1"
    assert merged.road_class[0] == 0
    assert merged.edge_name(0) == "longest of all"
    assert merged.way_id[0] == 2


def test_an_edge_without_length_keeps_a_speed():
    net = network([(0, 0)] * 3, [(0, 1), (1, 2)], length_m=[0.0, 0.0], speed_mps=[12.0, 13.0])
    merged = merge_chains(net)
    assert merged.speed_mps.tolist() == [12.0]


def test_nodes_without_roads_are_left_out():
    merged = merge_chains(network([(0, 0), (1_000, 0), (5_000, 0)], [(0, 1)]))
    assert merged.node_id.tolist() == [0, 1]


def test_a_network_without_roads():
    merged = merge_chains(network([(0, 0)], []))
    assert (merged.n, merged.m) == (0, 0)


@settings(max_examples=200, deadline=None)
@given(random_networks(max_nodes=9, max_edges=14), st.data())
def test_routes_between_the_nodes_that_stay_are_the_same(net, data):
    keep = np.array(data.draw(st.lists(st.booleans(), min_size=net.n, max_size=net.n)))
    merged = merge_chains(net, keep)
    stays = np.flatnonzero(np.isin(net.node_id, merged.node_id))
    position = {int(node): i for i, node in enumerate(merged.node_id)}
    there = [position[int(net.node_id[v])] for v in stays]
    for weight in ("length", "time"):
        before, after = (
            item.length_m if weight == "length" else item.length_m / item.speed_mps
            for item in (net, merged)
        )
        np.testing.assert_allclose(
            many_to_many(merged, after, there, there),
            many_to_many(net, before, stays, stays),
            rtol=1e-9,
        )
    # Kept nodes on a road are there, with their coordinates and names.
    on_road = np.zeros(net.n, bool)
    on_road[net.tail] = on_road[net.head] = True
    assert set(net.node_id[keep & on_road]) <= set(merged.node_id)
    np.testing.assert_array_equal(net.lon[stays], merged.lon[there])
    np.testing.assert_array_equal(net.node_name[stays], merged.node_name[there])


@settings(max_examples=150, deadline=None)
@given(random_networks(max_nodes=9, max_edges=14))
def test_shapes_are_whole_and_nothing_is_lost(net):
    merged = merge_chains(net)
    assert merged.length_m.sum() == pytest.approx(net.length_m.sum())
    times = [(item.length_m / item.speed_mps).sum() for item in (net, merged)]
    assert times[0] == pytest.approx(times[1])
    for e in range(merged.m):
        shape = merged.shape(e)
        assert tuple(shape[0]) == (merged.lon[merged.tail[e]], merged.lat[merged.tail[e]])
        assert tuple(shape[-1]) == (merged.lon[merged.head[e]], merged.lat[merged.head[e]])

    def segments(network):
        found = []
        for e in range(network.m):
            points = [tuple(point) for point in network.shape(e).tolist()]
            found += itertools.pairwise(points)
        return sorted(found)

    assert segments(merged) == segments(net)


@settings(max_examples=100, deadline=None)
@given(random_networks(max_nodes=9, max_edges=14))
def test_merging_twice_changes_nothing_more(net):
    once = merge_chains(net)
    twice = merge_chains(once)
    assert (twice.n, twice.m) == (once.n, once.m)
