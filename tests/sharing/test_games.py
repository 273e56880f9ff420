"""Games of a few players: the Shapley value and its axioms, covers, and the check of coalitions."""

import numpy as np
import pytest
from coalition_games import as_table, coalitions, games, shapley_by_orders, split_best
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.errors import ScenarioError
from platoon_osm.sharing.checked import checked
from platoon_osm.sharing.coalitions import best_part, superadditive_cover
from platoon_osm.sharing.shapley import shapley_value


@given(games())
@settings(max_examples=40)
def test_the_shapley_value_is_the_mean_over_all_orders(drawn):
    n, game = drawn
    shares = shapley_value(as_table(n, game.__getitem__))
    assert shares == pytest.approx(shapley_by_orders(n, game.__getitem__))
    assert shares.sum() == pytest.approx(game[frozenset(range(n))])


@given(games(2), st.data())
@settings(max_examples=40)
def test_players_who_add_the_same_get_the_same(drawn, data):
    n, game = drawn
    one, other = data.draw(st.permutations(range(n)))[:2]

    def swapped(group):
        return frozenset({one: other, other: one}.get(player, player) for player in group)

    even = {group: game[group] + game[swapped(group)] for group in game}
    shares = shapley_value(as_table(n, even.__getitem__))
    assert shares[one] == pytest.approx(shares[other])


@given(games(2), st.data())
@settings(max_examples=40)
def test_who_adds_nothing_gets_nothing(drawn, data):
    n, game = drawn
    idle = data.draw(st.integers(0, n - 1))
    shares = shapley_value(as_table(n, lambda group: game[group - {idle}]))
    assert shares[idle] == pytest.approx(0, abs=1e-12)


@given(st.integers(1, 5), st.integers(0, 2**31))
@settings(max_examples=30)
def test_shares_of_two_games_add_up(n, seed):
    first, second = np.random.default_rng(seed).normal(0, 1, (2, 2**n))
    first[0] = second[0] = 0
    both = shapley_value(first) + shapley_value(second)
    assert shapley_value(first + second) == pytest.approx(both)


@given(games(most=4))
@settings(max_examples=40)
def test_the_cover_is_the_best_way_to_split(drawn):
    n, game = drawn
    right = as_table(n, lambda group: split_best(group, game.__getitem__))
    cover = superadditive_cover(as_table(n, game.__getitem__))
    assert cover == pytest.approx(right)
    assert superadditive_cover(cover) == pytest.approx(cover)


@given(games(most=5), st.floats(0, 9))
@settings(max_examples=40)
def test_who_may_stay_out_does_where_that_is_worth_more(drawn, less):
    n, game = drawn
    low = {group: game[group] - less * bool(group) for group in game}
    right = as_table(
        n, lambda group: max(low[part] for part in coalitions(n) if part <= group)
    )  # fmt: skip
    assert best_part(as_table(n, low.__getitem__)) == pytest.approx(right)


@given(games(2), st.integers(0, 2**31))
@settings(max_examples=40)
def test_the_worst_coalition_is_found_among_all(drawn, seed):
    n, game = drawn
    shares = np.random.default_rng(seed).uniform(0, 5, n)
    found = checked(shares, as_table(n, game.__getitem__))
    proper = [group for group in coalitions(n) if 0 < len(group) < n]
    excess = {group: game[group] - sum(shares[k] for k in group) for group in proper}
    assert found.coalitions == len(proper)
    assert found.worst == pytest.approx(max(excess.values()))
    assert excess[frozenset(found.who)] == pytest.approx(found.worst)


def test_one_player_has_nobody_to_leave():
    assert checked([3.0], [0.0, 3.0]).coalitions == 0
    assert shapley_value([0.0, 3.0]).tolist() == [3.0]


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ([0.0, 1.0, 2.0], "values of 3 coalitions"),
        ([1.0, 1.0], "nobody 0"),
        ([0.0, np.inf], "finite"),
        ([], "values of 0 coalitions"),
    ],
)
def test_what_is_no_game_is_told_in_a_line(values, message):
    with pytest.raises(ScenarioError, match=message):
        shapley_value(values)


def test_shares_of_others_are_told_in_a_line():
    with pytest.raises(ScenarioError, match="3 shares and values for 2 players"):
        checked([1, 2, 3], [0, 0, 0, 1])
