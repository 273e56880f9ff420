"""Climb, descent and known grade of edges: kept, turned, joined and cut."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.errors import NetworkError
from platoon_osm.network.grades import grade, graded_share
from platoon_osm.network.preparing.placing import placing
from platoon_osm.network.preparing.simplify import merge_chains
from platoon_osm.network.preparing.split import split_edges
from platoon_osm.network.road_network import RoadNetwork

SUMS = ("length_m", "climb_m", "descent_m", "graded_m", "toll_free_m")


def road(heights, **columns):
    """Return a two-way road over some nodes, 100 m apart, whose heights are all known."""
    count = len(heights)
    rise = np.diff(np.asarray(heights, float))
    rises = np.concatenate([rise, -rise])
    onward = np.arange(count - 1)
    columns.setdefault("climb_m", np.maximum(rises, 0))
    columns.setdefault("descent_m", np.maximum(-rises, 0))
    columns.setdefault("graded_m", 100.0)
    return RoadNetwork.from_edges(
        np.concatenate([onward, onward + 1]), np.concatenate([onward + 1, onward]), 100.0 * np.ones(
            2 * count - 2), lon=9 + 0.001 * np.arange(count), lat=np.full(count, 45.0), **columns,
    )  # fmt: skip


def test_grade_is_rise_over_the_length_that_is_known():
    net = road([200, 205, 203], graded_m=[100, 50, 100, 0], climb_m=[5, 0, 0, 0],
               descent_m=[0, 2, 0, 0])  # fmt: skip
    edges = {(int(u), int(v)): e for e, (u, v) in enumerate(zip(net.tail, net.head, strict=True))}
    at = [edges[pair] for pair in ((0, 1), (1, 2), (1, 0), (2, 1))]
    assert grade(net)[at].tolist() == pytest.approx([0.05, -0.04, 0, 0])
    assert graded_share(net)[at].tolist() == pytest.approx([1, 0.5, 1, 0])


def test_a_network_that_knows_nothing_of_heights_is_level_and_says_so():
    net = RoadNetwork.from_edges([0], [1], lon=[9, 9.1], lat=[45, 45])
    assert (grade(net).tolist(), graded_share(net).tolist()) == ([0.0], [0.0])


def test_turned_round_a_climb_is_a_descent():
    net = road([200, 205, 203])
    turned, old = net.reversed()
    assert turned.climb_m.tolist() == net.descent_m[old].tolist()
    assert turned.descent_m.tolist() == net.climb_m[old].tolist()
    assert turned.graded_m.tolist() == net.graded_m[old].tolist()


@pytest.mark.parametrize("name", SUMS[1:])
@pytest.mark.parametrize("value", [-1.0, float("nan"), float("inf")])
def test_what_cannot_be_is_refused(name, value):
    with pytest.raises(NetworkError, match=f"edge 1 .* has {name} {value}"):
        road([200, 205], **{name: [1.0, value]})


heights_of_nodes = st.lists(st.integers(-4000, 9000), min_size=2, max_size=9)


@settings(max_examples=60, deadline=None)
@given(heights_of_nodes, st.data())
def test_joined_and_cut_roads_rise_as_their_parts_did(heights, data):
    net = road(heights, toll_free_m=data.draw(
        st.lists(st.floats(0, 100), min_size=2 * len(heights) - 2, max_size=2 * len(heights) - 2)
    ))  # fmt: skip
    joined = merge_chains(net)
    edges = data.draw(st.lists(st.integers(0, joined.m - 1), max_size=4))
    along = [data.draw(st.floats(0, float(joined.length_m[edge]))) for edge in edges]
    cut, _ = split_edges(joined, edges, along)
    placed = placing(joined, [(e, m / float(joined.length_m[e]))
                              for e, m in zip(edges, along, strict=True)]).net  # fmt: skip
    for other in (joined, cut, placed):
        for name in SUMS:
            values = getattr(other, name)
            assert values.sum() == pytest.approx(getattr(net, name).sum(), rel=1e-5, abs=1e-3)
    for other in (joined, cut, placed):
        assert total_rise(other, 0, len(heights) - 1, net) == pytest.approx(
            heights[-1] - heights[0], abs=1e-2
        )
        assert total_rise(other, len(heights) - 1, 0, net) == pytest.approx(
            heights[0] - heights[-1], abs=1e-2
        )


def total_rise(other, start, stop, net):
    """Return climb - descent along the only way from one end of the road to the other."""
    node_of = {int(node): position for position, node in enumerate(other.node_id)}
    node, goal = node_of[int(net.node_id[start])], node_of[int(net.node_id[stop])]
    rise, before = 0.0, -1
    while node != goal:
        out = range(other.first_out[node], other.first_out[node + 1])
        edge = next(e for e in out if int(other.head[e]) != before)
        rise += float(other.climb_m[edge]) - float(other.descent_m[edge])
        before, node = node, int(other.head[edge])
    return rise
