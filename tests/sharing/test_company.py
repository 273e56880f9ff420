"""The game of one company against its definition, all orders and all coalitions."""

import numpy as np
import pytest
from coalition_games import as_table, coalitions, saved_by_company, shapley_by_orders
from hypothesis import given, settings
from hypothesis import strategies as st
from soak import chosen, soaked

from platoon_osm.errors import ScenarioError
from platoon_osm.sharing.checked import checked
from platoon_osm.sharing.coalitions import members
from platoon_osm.sharing.company import CompanyGame
from platoon_osm.sharing.places_in_company import values_by_place
from platoon_osm.sharing.shapley import shapley_value

quarters = st.integers(0, 40).map(lambda k: k / 4)


def companies(most, loss=quarters, lead=quarters):
    """Draw what vehicles save as leader, and how much more they save as follower."""
    own = st.lists(st.tuples(lead, loss), min_size=1, max_size=most)
    return own.map(lambda told: ([one + more for one, more in told], [one for one, _ in told]))


@given(companies(6, loss=st.integers(-40, 40).map(float)))
@settings(max_examples=40)
def test_values_are_those_of_the_best_leader(told):
    follow, lead = told
    game = CompanyGame(*told)
    right = as_table(len(follow), lambda group: saved_by_company(follow, lead, group))
    assert game.values() == pytest.approx(right)
    assert [game.value(group) for group in coalitions(len(follow))] == pytest.approx(
        [saved_by_company(follow, lead, group) for group in coalitions(len(follow))]
    )


@given(companies(7))
@settings(max_examples=60)
def test_equal_parts_of_the_leaders_loss_are_in_the_core(told):
    game = CompanyGame(*told)
    shares = game.equal_parts()
    assert game.is_balanced
    assert shares.sum() == pytest.approx(game.value(range(len(game))))
    assert checked(shares, game.values()).worst <= 1e-9


def test_they_need_not_be_where_leading_saves_more_than_following():
    game = CompanyGame([1.0, 1.0, 1.0], [2.0, 1.0, 1.0])
    assert not game.is_balanced
    assert checked(game.equal_parts(), game.values()).worst > 0
    assert not CompanyGame([3.0, 1.0], [-1.0, -2.0]).is_balanced


def test_another_leader_costs_everybody_the_same():
    game = CompanyGame([4.0, 4.0, 5.0], [1.0, 1.0, 0.5])
    assert game.equal_parts(leader=2).tolist() == [2.5, 2.5, 3.5]
    assert game.equal_parts().tolist() == [3.0, 3.0, 4.0]


@soaked
@given(companies(chosen(5, 7), loss=st.integers(-40, 40).map(lambda k: k / 4)))
@settings(max_examples=chosen(25, 100))
def test_the_closed_form_of_the_shapley_value_is_the_mean_over_all_orders(told):
    follow, lead = told
    right = shapley_by_orders(len(follow), lambda group: saved_by_company(follow, lead, group))
    assert CompanyGame(*told).shapley() == pytest.approx(right)


def test_it_is_that_of_seven_vehicles_too():
    draw = np.random.default_rng(7)
    follow, lead = draw.uniform(2, 9, 7).round(2), draw.uniform(0, 2, 7).round(2)
    right = shapley_by_orders(7, lambda group: saved_by_company(follow, lead, group))
    game = CompanyGame(follow, lead)
    assert game.shapley() == pytest.approx(right)
    assert shapley_value(game.values()) == pytest.approx(right)


@given(st.lists(quarters, min_size=2, max_size=7))
def test_without_a_saving_for_leaders_it_is_the_published_formula(told):
    saved = np.sort(told)
    n = len(saved)
    right = [
        saved[i] * (1 - 1 / n)
        + sum((saved[k] - saved[k - 1]) * (n - k) / (n * k) for k in range(i + 1, n))
        for i in range(n)
    ]
    assert CompanyGame(saved, np.zeros(n)).shapley() == pytest.approx(right)


@given(quarters, quarters, st.integers(2, 7))
def test_among_vehicles_alike_it_is_in_the_core_and_equal(loss, lead, n):
    game = CompanyGame([lead + loss] * n, [lead] * n)
    assert game.shapley() == pytest.approx(game.equal_parts())
    assert checked(game.shapley(), game.values()).worst <= 1e-9


def test_of_many_vehicles_it_still_adds_up():
    draw = np.random.default_rng(1)
    game = CompanyGame(draw.uniform(1, 2, 500), draw.uniform(0, 1, 500))
    assert game.shapley().sum() == pytest.approx(game.value(range(500)))
    with pytest.raises(ScenarioError, match="500 players have too many coalitions"):
        game.values()


@pytest.mark.parametrize(
    ("follow", "lead", "message"),
    [
        ([1.0, 2.0], [1.0], "2 savings as follower and 1 as leader"),
        ([], [], "0 savings"),
        ([1.0, np.nan], [1.0, 1.0], "finite"),
    ],
)
def test_what_is_no_company_is_told_in_a_line(follow, lead, message):
    with pytest.raises(ScenarioError, match=message):
        CompanyGame(follow, lead)


def saved_in_order(gains, group):
    """Return what a group saves in its order, but for the leader, who is the best."""
    if len(group) < 2:
        return 0.0
    found = []
    for leader in group:
        order = [leader, *sorted(group - {leader})]
        found.append(sum(gains[len(group) - 1][place][one] for place, one in enumerate(order)))
    return max(found)


@given(st.integers(1, 5), st.integers(0, 2**31))
@settings(max_examples=30)
def test_savings_by_place_and_size_are_those_of_the_order(n, seed):
    gains = np.random.default_rng(seed).integers(0, 20, (n, n, n)).astype(float)
    right = as_table(n, lambda group: saved_in_order(gains, group))
    assert values_by_place(gains) == pytest.approx(right)


@given(companies(6))
@settings(max_examples=20)
def test_where_places_do_not_matter_both_games_are_one(told):
    n = len(told[0])
    gains = np.zeros((n, n, n)) + np.array(told[0])
    gains[:, 0] = told[1]
    assert values_by_place(gains) == pytest.approx(CompanyGame(*told).values())


def test_a_table_of_another_shape_is_told_in_a_line():
    with pytest.raises(ScenarioError, match=r"gains of shape \(2, 3\)"):
        values_by_place(np.zeros((2, 3)))


def test_members_are_marked_bit_by_bit():
    assert members(2).tolist() == [[False, False], [True, False], [False, True], [True, True]]
