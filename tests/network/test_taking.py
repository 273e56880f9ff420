"""Edges taken out of a network into another."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import random_networks, same_network, small_italy

from platoon_osm.errors import NetworkError
from platoon_osm.network.columns import columns_per


@settings(max_examples=100, deadline=None)
@given(random_networks(), st.data())
def test_taken_edges_are_those_edges(net, data):
    wanted = data.draw(st.lists(st.integers(0, net.m - 1), max_size=12)) if net.m else []
    taken = net.take(wanted)
    order = np.array(wanted, np.int64)[np.argsort(net.tail[wanted], kind="stable")]
    for column in columns_per("edge"):
        np.testing.assert_array_equal(getattr(taken, column.name), getattr(net, column.name)[order])
    for column in columns_per("node"):
        np.testing.assert_array_equal(getattr(taken, column.name), getattr(net, column.name))
    for new, old in enumerate(order.tolist()):
        np.testing.assert_array_equal(taken.shape(new), net.shape(old))


def test_all_edges_taken_are_the_same_network():
    net = small_italy()
    same_network(net.take(range(net.m)), net)
    same_network(net.take(np.arange(net.m)[::-1], ref=net.ref[::-1]).take(range(net.m)),
                 net.take(np.arange(net.m)[::-1]))  # fmt: skip


def test_columns_are_changed_before_the_edges_are_sorted():
    net = small_italy()
    taken = net.take([3, 0], length_m=[3.0, 1.0], toll=True)
    assert taken.tail.tolist() == sorted(net.tail[[3, 0]].tolist())
    assert taken.length_m.tolist() == [1.0, 3.0]
    assert taken.toll.tolist() == [True, True]
    assert taken.way_id.tolist() == net.way_id[[0, 3]].tolist()


def test_nothing_taken_leaves_the_nodes():
    empty = small_italy().take([])
    assert (empty.m, empty.n) == (0, 8)


@pytest.mark.parametrize(
    ("edges", "said"),
    [
        ([10], "edge 10: the network has edges 0 to 9"), ([-1], "edge -1"), (["a"], "edges ['a']"),
        (None, "edges None"), (3, "edges 3"), ([[0, 1]], "edges [[0, 1]]"), ([0.5], "edges [0.5]"),
        ([True], "edges [True]"), ({}, "edges {}"), ([[0], [0, 1]], "edges"),
    ],
)  # fmt: skip
def test_edges_that_are_none(edges, said):
    with pytest.raises(NetworkError) as caught:
        small_italy().take(edges)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
