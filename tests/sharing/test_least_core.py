"""The least core against its dual and other shares; nearest shares against their conditions."""

import numpy as np
import pytest
from coalition_games import as_table, games
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.errors import ScenarioError
from platoon_osm.sharing.checked import checked
from platoon_osm.sharing.coalitions import members
from platoon_osm.sharing.company import CompanyGame
from platoon_osm.sharing.least_core import least_core
from platoon_osm.sharing.nearest import nearest_meeting, none_worse_off
from platoon_osm.sharing.shapley import shapley_value

HAIR = 1e-5


def proves(values, found, worse_allowed):
    """Return what the prices prove: no shares leave every coalition with less to gain than this.

    For any shares x of the total t, the largest excess is at least the mean of the excesses, which
    is the mean of v(S) less sum_i x_i q_i, where q_i is the weight of the coalitions with i; and
    that is at least the mean of v(S) less max q t if no x_i is negative, or all q_i are the same.
    """
    weight = found.prices
    inside = members(len(found.shares))
    with_each = weight @ inside
    assert (weight >= -1e-9).all()
    assert weight.sum() == pytest.approx(1)
    if worse_allowed:
        assert with_each == pytest.approx(np.full(len(with_each), with_each[0]))
    return float(weight @ values) - with_each.max() * values[-1]


@given(games(2), st.booleans(), st.integers(0, 2**31))
@settings(max_examples=40)
def test_its_excess_is_proved_by_the_dual_and_below_that_of_all_other_shares(drawn, free, seed):
    n, game = drawn
    values = np.array(as_table(n, game.__getitem__))
    found = least_core(values, nobody_worse_off=not free)
    assert found.shares.sum() == pytest.approx(values[-1], abs=1e-9)
    assert proves(values, found, free) == pytest.approx(found.excess, abs=1e-7)
    assert checked(found.shares, values).worst <= found.excess + HAIR
    if not free:
        assert (found.shares >= 0).all()
    others = np.random.default_rng(seed).dirichlet(np.ones(n), 20) * values[-1]
    for other in [*others, none_worse_off(shapley_value(values))]:
        assert checked(other, values).worst >= found.excess - HAIR


@given(st.lists(st.integers(0, 40).map(float), min_size=2, max_size=6))
@settings(max_examples=20)
def test_players_alike_get_the_same(saved):
    values = CompanyGame([*saved, saved[0]], [0.0] * (len(saved) + 1)).values()
    shares = least_core(values).shares
    assert shares[0] == pytest.approx(shares[-1], abs=1e-3)


def test_of_equally_good_shares_those_nearest_to_a_wish_are_taken():
    # Two gain 10 together, the third adds nothing: however the two share, nobody has more to gain.
    values = [0.0, 0.0, 0.0, 10.0, 0.0, 0.0, 0.0, 10.0]
    assert least_core(values, near=[7.0, 3.0, 0.0]).shares == pytest.approx([7, 3, 0], abs=1e-4)
    assert least_core(values, near=[14.0, 6.0, 0.0]).shares == pytest.approx([9, 1, 0], abs=1e-4)
    assert least_core(values).shares == pytest.approx([5, 5, 0], abs=1e-4)


def test_twelve_players_are_the_most():
    draw = np.random.default_rng(3)
    game = CompanyGame(draw.uniform(2, 9, 12), draw.uniform(0, 2, 12))
    values = game.values()
    found = least_core(values, near=game.equal_parts())
    assert checked(found.shares, values).worst == pytest.approx(found.excess, abs=1e-4)
    assert found.excess <= checked(game.equal_parts(), values).worst + HAIR


def test_where_all_together_lose_somebody_is_worse_off():
    values = [0.0, 0.0, 0.0, -1.0]
    with pytest.raises(ScenarioError, match="everybody together has -1"):
        least_core(values)
    assert least_core(values, nobody_worse_off=False).shares == pytest.approx([-0.5, -0.5])
    assert least_core([0.0, 2.0]).shares.tolist() == [2.0]


@given(st.lists(st.floats(-50, 50), min_size=1, max_size=8), st.floats(0, 200))
def test_nobody_is_worse_off_and_nothing_nearer_is(drawn, more):
    shares = np.array(drawn)
    shares += max(0.0, more - shares.sum()) / len(shares)
    found = none_worse_off(shares)
    assert (found >= 0).all()
    assert found.sum() == pytest.approx(shares.sum(), abs=1e-9)
    # The conditions of the least square: all who keep something gave the same, the others less.
    gave = shares - found
    kept = found > 1e-9
    assert np.ptp(gave[kept]) < 1e-9 if kept.any() else True
    assert (gave[~kept] <= gave[kept].max(initial=-np.inf) + 1e-9).all() or not kept.any()


@given(st.lists(st.floats(-50, 50), min_size=2, max_size=6), st.floats(1, 200))
@settings(max_examples=40)
def test_both_ways_to_the_nearest_shares_agree(drawn, total):
    shares = np.array(drawn)
    shares += (total - shares.sum()) / len(shares)
    other = nearest_meeting(shares, np.eye(len(shares)), np.zeros(len(shares)))
    assert other == pytest.approx(none_worse_off(shares), abs=1e-6)


def test_conditions_that_cannot_be_met_are_told_in_a_line():
    with pytest.raises(ScenarioError, match="no shares of this sum"):
        nearest_meeting([1.0, 1.0], [[1.0, 0.0], [0.0, 1.0]], [2.0, 2.0])
    with pytest.raises(ScenarioError, match="the total is -1"):
        none_worse_off([1.0, -2.0])
