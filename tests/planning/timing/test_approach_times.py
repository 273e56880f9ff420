"""Times of all cheapest ways at once are those of the ways one by one."""

import numpy as np
import pytest
from random_networks import network

from platoon_osm import load_network, paper_weights
from platoon_osm.planning.timing.approach_times import times_along
from platoon_osm.search.searches import Searches


@pytest.mark.parametrize("seed", range(30))
def test_times_are_those_of_the_ways(seed):
    rng = np.random.default_rng(seed)
    n, m = int(rng.integers(2, 25)), int(rng.integers(1, 70))
    tails = rng.integers(0, n, m)
    heads = np.concatenate([[n - 1], (tails[1:] + rng.integers(1, n, m - 1)) % n])
    tails[0] = 0
    net = network(tails.tolist(), heads.tolist(), rng.uniform(1e3, 9e3, m).tolist())
    weight, drive_s = rng.uniform(1, 9, net.m), rng.uniform(10, 99, net.m)
    weight[rng.random(net.m) < 0.1] = np.inf
    engine = Searches(net).under(weight)
    for root in range(net.n):
        for forward in (True, False):
            tree = engine.tree(root, forward)
            found = times_along(tree, drive_s)
            for node in range(net.n):
                if np.isfinite(tree.dist[node]):
                    assert found[node] == pytest.approx(drive_s[tree.path(node)].sum())
                else:
                    assert np.isinf(found[node])


def test_on_a_real_map():
    net = load_network("italy-motorways")
    engine = Searches(net).under(paper_weights(net).solo)
    drive_s = net.length_m / net.speed_mps
    for forward in (True, False):
        tree = engine.tree(11, forward)
        found = times_along(tree, drive_s)
        for node in range(0, net.n, 97):
            if np.isfinite(tree.dist[node]):
                assert found[node] == pytest.approx(drive_s[tree.path(node)].sum())
