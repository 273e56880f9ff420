"""A company's costs as a line in its vehicles: never above what it really pays."""

import numpy as np
import pytest
from bundled import italy

from platoon_osm.costs.presets import PRESETS
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.fleets.company_costs import company_line

SIZES = range(2, 12)


def really(weights, size, edges):
    """What all of a company pay, edge by edge, as the record of a plan says it."""
    return np.array(
        [
            sum(weights.share([edge], 1.0, place, size).cost for place in range(size))
            for edge in edges
        ]
    )


@pytest.mark.parametrize("largest", [0, 2, 3, 5])
@pytest.mark.parametrize("name", sorted(PRESETS))
def test_it_is_never_above_what_is_paid(name, largest):
    net = italy()
    weights = PRESETS[name].make().weights(net)
    edges = np.arange(0, net.m, 997)
    member, extra = company_line(weights, largest)
    assert (extra >= 0).all()
    for size in SIZES:
        if largest and size > largest:
            break
        paid = really(weights, size, edges)
        told = size * member[edges] + extra[edges]
        assert (told <= paid * (1 + 1e-9)).all()
        if size == 2:
            np.testing.assert_allclose(told, paid)


@pytest.mark.parametrize("seed", range(8))
def test_by_position_it_is_exact(seed):
    rng = np.random.default_rng(seed)
    solo = rng.uniform(1, 2, 7)
    master, last = solo * rng.uniform(0.9, 1, 7), solo * rng.uniform(0.85, 0.9, 7)
    middle = solo * rng.uniform(0.7, 0.85, 7)
    weights = EdgeWeights(solo, last, master, "m", {}, middle=middle, last=last)
    member, extra = company_line(weights, 0)
    for size in SIZES:
        paid = really(weights, size, range(7))
        np.testing.assert_allclose(size * member + extra, paid)


def test_a_leader_that_saves_nothing_leaves_the_whole_price():
    solo = np.ones(3)
    weights = EdgeWeights(solo, 0.9 * solo, solo, "m", {})
    member, extra = company_line(weights, 0)
    np.testing.assert_allclose(member, 0.9)
    np.testing.assert_allclose(extra, 0.1)
