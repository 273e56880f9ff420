"""Edges cut at points along them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import degrees, network, random_networks

from platoon_osm.network.geodesy import distance_m
from platoon_osm.network.preparing.split import SPLIT_NODE_IDS, split_edges


def bend():
    """One edge of 2 km with a right-angled bend in the middle, one beside it."""
    nodes = [(0, 0), (1_000, 1_000), (0, 5_000), (1_000, 5_000)]
    return network(
        nodes, [(0, 1, [(1_000, 0)]), (2, 3)], speed_mps=[20.0, 25.0], way_id=[7, 8],
        ref=["A1", "A2"], toll=[True, False],
    )  # fmt: skip


def pieces_from(net, node, stop):
    """Follow edges from a node until another one."""
    edges = []
    while node != stop:
        (edge,) = range(net.first_out[node], net.first_out[node + 1])
        edges.append(edge)
        node = int(net.head[edge])
    return edges


def test_one_cut():
    cut, nodes = split_edges(bend(), [0], [1_500.0])
    assert (cut.n, cut.m) == (5, 3)
    first, second = pieces_from(cut, 0, 1)
    assert cut.length_m[[first, second]] == pytest.approx([1_500, 500], rel=1e-3)
    assert nodes.tolist() == [cut.head[first]]
    assert (cut.lon[nodes[0]], cut.lat[nodes[0]]) == pytest.approx(degrees(1_000, 500), abs=1e-6)
    assert len(cut.shape(first)) == 3
    assert len(cut.shape(second)) == 2
    for edge in (first, second):
        assert (cut.way_id[edge], cut.edge_ref(edge), cut.toll[edge]) == (7, "A1", True)
        assert cut.speed_mps[edge] == 20
    assert cut.node_id.tolist() == [0, 1, 2, 3, SPLIT_NODE_IDS]


def test_a_cut_at_the_bend_keeps_the_bend_once():
    net = bend()
    at_bend = float(distance_m(*net.shape(0)[0], *net.shape(0)[1]))
    cut, _ = split_edges(net, [0], [at_bend])
    for edge in pieces_from(cut, 0, 1):
        assert len(cut.shape(edge)) == 2


@pytest.mark.parametrize(
    ("along", "node"),
    [(0.0, 0), (-5.0, 0), (0.9, 0), (1_999.5, 1), (1e9, 1)],
)
def test_cuts_at_the_ends_are_the_ends(along, node):
    cut, nodes = split_edges(bend(), [0], [along])
    assert nodes.tolist() == [node]
    assert (cut.n, cut.m) == (4, 2)


def test_cuts_at_one_place_share_their_node():
    cut, nodes = split_edges(bend(), [0, 1, 0, 0], [500.0, 500.0, 500.4, 500.0])
    assert nodes[0] == nodes[2] == nodes[3] != nodes[1]
    assert (cut.n, cut.m) == (6, 4)


def test_no_cuts():
    net = bend()
    cut, nodes = split_edges(net, [], [])
    assert len(nodes) == 0
    assert (cut.n, cut.m) == (net.n, net.m)
    np.testing.assert_array_equal(cut.shape_lon, net.shape_lon)


def test_length_of_the_map_is_kept_where_the_shape_measures_otherwise():
    net = network([(0, 0), (1_000, 0)], [(0, 1)], length_m=[1_100.0])
    cut, _ = split_edges(net, [0], [500.0])
    assert cut.length_m == pytest.approx([550, 550], rel=1e-3)


def test_an_edge_without_length_is_cut_at_its_tail():
    net = network([(0, 0), (0, 0)], [(0, 1)])
    cut, nodes = split_edges(net, [0, 0], [0.0, 3.0])
    assert nodes.tolist() == [0, 0]
    assert cut.m == 1


def test_cut_twice_every_node_has_its_own_id():
    once, _ = split_edges(bend(), [0], [500.0])
    twice, _ = split_edges(once, [1], [500.0])
    assert len(set(twice.node_id.tolist())) == twice.n == 6


@settings(max_examples=120, deadline=None)
@given(random_networks(), st.data())
def test_length_time_and_shape_survive(net, data):
    if not net.m:
        return
    cuts = data.draw(
        st.lists(st.tuples(st.integers(0, net.m - 1), st.floats(-10, 40_000)), max_size=8)
    )
    edges, along = [edge for edge, _ in cuts], [metres for _, metres in cuts]
    cut, nodes = split_edges(net, edges, along)
    assert cut.length_m.sum() == pytest.approx(net.length_m.sum())
    times = [(item.length_m / item.speed_mps).sum() for item in (net, cut)]
    assert times[0] == pytest.approx(times[1])
    assert cut.m - net.m == cut.n - net.n
    # Each old edge is the chain of its pieces: same points, with the cuts between them.
    new_edges = {int(e) for e in range(cut.m) if cut.tail[e] >= net.n}
    starts = [e for e in range(cut.m) if e not in new_edges]
    assert len(starts) == net.m
    for start in starts:
        chain = [start]
        while cut.head[chain[-1]] >= net.n:
            chain.append(int(cut.first_out[cut.head[chain[-1]]]))
        shape = cut.path_shape(chain)
        inside = {tuple(point) for point in shape.tolist()}
        whole = [
            e for e in range(net.m)
            if net.tail[e] == cut.tail[start] and net.way_id[e] == cut.way_id[start]
            and {tuple(point) for point in net.shape(e).tolist()} <= inside
        ]  # fmt: skip
        assert whole
        assert any(
            cut.length_m[chain].sum() == pytest.approx(net.length_m[e], abs=1e-6) for e in whole
        )
    # Each cut lies where it was asked for, on the road.
    for (edge, metres), node in zip(cuts, nodes.tolist(), strict=True):
        shape = net.shape(edge)
        steps = distance_m(shape[:-1, 0], shape[:-1, 1], shape[1:, 0], shape[1:, 1])
        measured = np.concatenate([[0], np.cumsum(steps)])
        wanted = [np.interp(metres, measured, shape[:, axis]) for axis in (0, 1)]
        assert distance_m(*wanted, cut.lon[node], cut.lat[node]) < 2.1
