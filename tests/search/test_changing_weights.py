"""Searches under weights that change, against the engine that is made for one weight."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import tied_networks

from platoon_osm.search.changing_weights import ChangingWeights
from platoon_osm.search.dijkstra import ReferenceEngine


@settings(max_examples=150, deadline=None)
@given(tied_networks(), st.booleans(), st.data())
def test_costs_and_paths_are_those_of_an_engine(problem, forward, data):
    net, weights = problem
    search = net.attached(ChangingWeights).search
    for weight in (weights.solo, weights.platoon, weights.solo):
        closed = np.where(data.draw(st.booleans()), np.inf, weight)
        node = data.draw(st.integers(0, net.n - 1))
        found = search(closed, node, forward)
        expected = ReferenceEngine(net, closed).tree(node, forward)
        assert np.array_equal(found.dist, expected.dist)
        for other in np.flatnonzero(np.isfinite(found.dist)).tolist():
            assert np.array_equal(found.path(other), expected.path(other))
        limit = data.draw(st.floats(0, 10))
        short = search(closed, node, forward, limit)
        near = found.dist <= limit
        assert np.array_equal(short.dist[near], found.dist[near])
        assert not np.isfinite(short.dist[~near]).any()
