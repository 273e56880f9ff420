"""The kernel of the grid: ties, blocks, and the reference it must equal."""

import numpy as np
import pytest

from platoon_osm.search.joining import best_pairs
from platoon_osm.study import grid
from platoon_osm.study.grid import best_on_grid, shared_metres


def random_case(rng, members=4, edges=7, whole=False):
    """Costs of a member are at least those along the route, as real searches give them."""
    length = np.concatenate([[0.0], np.cumsum(rng.integers(1, 4, edges).astype(float))])
    entry = rng.integers(0, 9, (members, edges + 1)).astype(float)
    leave = rng.integers(0, 9, (members, edges + 1)).astype(float)
    solo = (entry + leave).min(axis=1) + (0 if whole else rng.integers(0, 3, members))
    return entry, leave, np.minimum(solo, (entry + leave).min(axis=1)) + 0.0, length


@pytest.mark.parametrize("seed", range(30))
def test_equals_the_reference_with_many_ties(seed):
    entry, leave, solo, length = random_case(np.random.default_rng(seed))
    factors = np.array([0.0, 0.25, 0.5, 1.0, 2.0])
    i, j, cost = best_on_grid(entry, leave, solo, length, factors)
    for k, factor in enumerate(factors):
        at_i, at_j, at_cost = best_pairs(entry, leave, factor * length, length, solo)
        assert i[:, k].tolist() == at_i.tolist()
        assert j[:, k].tolist() == at_j.tolist()
        assert cost[:, k] == pytest.approx(at_cost)


def test_equal_costs_take_the_longest_platoon_then_the_earliest_merge():
    # Free platoons: any pair costs nothing; the whole route is the longest.
    length = np.array([0.0, 1.0, 2.0, 3.0])
    free = np.zeros((1, 4))
    i, j, _ = best_on_grid(free, free, np.array([5.0]), length, np.array([0.0]))
    assert (i[0, 0], j[0, 0]) == (0, 3)
    # Only pairs of one metre are free: the first of them.
    entry = np.array([[0.0, 0.0, 0.0, np.inf]])
    leave = np.array([[np.inf, 0.0, 3.0, 3.0]])
    i, j, _ = best_on_grid(entry, leave, np.array([5.0]), length, np.array([0.0]))
    assert (i[0, 0], j[0, 0]) == (0, 1)


def test_alone_where_no_way_together_exists():
    length = np.array([0.0, 1.0])
    nowhere = np.full((2, 2), np.inf)
    i, j, cost = best_on_grid(nowhere, nowhere, np.array([1.0, 2.0]), length, np.array([1.0, 2.0]))
    assert (i == -1).all()
    assert (j == -1).all()
    assert cost.tolist() == [[1.0, 1.0], [2.0, 2.0]]


def test_a_stretch_of_no_length_is_no_platoon():
    length = np.array([0.0, 0.0])
    zero = np.zeros((1, 2))
    i, _, cost = best_on_grid(zero, zero, np.array([0.0]), length, np.array([1.0]))
    assert i[0, 0] == -1
    assert cost[0, 0] == 0.0


def test_small_blocks_give_the_same(monkeypatch):
    entry, leave, solo, length = random_case(np.random.default_rng(1), members=6, edges=9)
    factors = np.linspace(0, 2, 13)
    whole = best_on_grid(entry, leave, solo, length, factors)
    monkeypatch.setattr(grid, "BLOCK", 50)
    parts = best_on_grid(entry, leave, solo, length, factors)
    assert all((a == b).all() for a, b in zip(whole, parts, strict=True))


def test_metres_with_company_count_once():
    length = np.array([0.0, 10.0, 30.0, 60.0])
    i, j = np.array([[0, -1], [1, -1]]), np.array([[2, -1], [3, -1]])
    assert shared_metres(i, j, length).tolist() == [60.0, 0.0]
