"""What coalitions of many could gain, against all coalitions of a few."""

import numpy as np
import pytest
from coalition_games import coalitions, saved_by_company
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.sharing.company import CompanyGame
from platoon_osm.sharing.many import most_to_gain


def drawn(seed, alike):
    """Draw companies of some of six vehicles, what their ways cost, and shares."""
    draw = np.random.default_rng(seed)
    companies = []
    for _ in range(draw.integers(1, 5)):
        players = draw.permutation(6)[: draw.integers(1, 6)].tolist()
        loss = np.full(len(players), 2.0) if alike else draw.uniform(-1, 4, len(players))
        lead = np.full(len(players), alike - 1.0) if alike else draw.uniform(0, 2, len(players))
        companies.append((players, CompanyGame(lead + loss, lead)))
    return companies, draw.uniform(0, 2, 6), draw.uniform(0, 3, 6)


def gained(companies, own, shares, group):
    """Return what a group saves by itself less its shares."""
    saved = 0.0
    for players, game in companies:
        there = frozenset(k for k, player in enumerate(players) if player in group)
        saved += saved_by_company(game.follow, game.lead, there)
    return saved - sum(own[k] + shares[k] for k in group)


@given(st.integers(0, 2**31))
@settings(max_examples=40)
def test_no_coalition_gains_more(seed):
    told = drawn(seed, alike=0)
    best = max(gained(*told, group) for group in coalitions(6))
    assert most_to_gain(*told) >= best - 1e-7


@given(st.integers(0, 2**31), st.sampled_from([1, 1.5, 2]))
@settings(max_examples=40)
def test_among_vehicles_alike_one_gains_as_much(seed, lead):
    told = drawn(seed, alike=lead)
    best = max(gained(*told, group) for group in coalitions(6))
    assert most_to_gain(*told) == pytest.approx(best, abs=1e-7)


def test_equal_parts_among_two_hundred_leave_nobody_a_gain():
    draw = np.random.default_rng(5)
    own, shares, companies = draw.uniform(0, 0.3, 200), np.zeros(200), []
    for _ in range(80):
        players = draw.permutation(200)[:20]
        game = CompanyGame(draw.uniform(2, 9, 20), np.zeros(20))
        shares[players] += game.equal_parts()
        companies.append((players.tolist(), game))
    assert most_to_gain(companies, own, shares - own) == pytest.approx(0, abs=1e-6)
    assert most_to_gain(companies, own, shares - own - 0.01) > 1


def test_without_companies_only_shares_below_nothing_count():
    assert most_to_gain([], [0.0, 1.0], [1.0, -3.0]) == 2.0
