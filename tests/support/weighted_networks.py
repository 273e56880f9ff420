"""Small networks with weights of every kind, and what searches on them must give."""

import numpy as np
import pytest
from hypothesis import strategies as st
from made_networks import random_networks

WEIGHTS = st.one_of(st.just(0.0), st.just(float("inf")), st.integers(0, 9).map(float))


@st.composite
def weighted(draw):
    """Networks with weights that are often equal, zero or infinite."""
    net = draw(random_networks())
    return net, np.array(draw(st.lists(WEIGHTS, min_size=net.m, max_size=net.m)), float)


def bellman_ford(net, weight, labels, forward=True):
    dist = np.array(labels, float)
    ends = (net.tail, net.head) if forward else (net.head, net.tail)
    for _ in range(net.n):
        for e in range(net.m):
            dist[ends[1][e]] = min(dist[ends[1][e]], dist[ends[0][e]] + weight[e])
    return dist


def only(net, node):
    labels = np.full(net.n, np.inf)
    labels[node] = 0.0
    return labels


def assert_path(net, weight, edges, start, end, cost):
    """A path must be connected, go from start to end, and cost what was said."""
    nodes = [start, *net.head[edges].tolist()]
    assert net.tail[edges].tolist() == nodes[:-1]
    assert nodes[-1] == end
    assert weight[edges].sum() == pytest.approx(cost)
    assert len(set(nodes)) == len(nodes)
