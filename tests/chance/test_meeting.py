"""Chances of meeting against quadrature, grids, and draws counted with a seed."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import integrate, stats
from soak import chosen, soaked

from platoon_osm.chance.delays import Delays, factor
from platoon_osm.chance.gaps import LognormalGap, NormalGap, gap_of
from platoon_osm.chance.giving_up import (
    buffer_ahead_s,
    early_start_s,
    last_to_come_s,
    value_of_waiting,
    wait_up_to_s,
)
from platoon_osm.chance.simulated import simulated
from platoon_osm.errors import ScenarioError

MIN = 60.0
means = st.floats(-40 * MIN, 60 * MIN)
spreads = st.floats(1.0, 30 * MIN)


def in_errors(found, expected, error):
    """Tell whether a count lies where 1 of 30,000 would not."""
    return abs(found - expected) <= 4 * error + 1e-4


@pytest.mark.parametrize("kind", ["normal", "lognormal"])
@pytest.mark.parametrize("correlation", [-0.6, 0.0, 0.5, 1.0])
@pytest.mark.parametrize("planned_s", [-300.0, 0.0, 240.0])
def test_closed_forms_are_what_counting_gives(kind, correlation, planned_s):
    delays = Delays(8, {"late": 11}, correlation, kind=kind)
    gap = gap_of(delays, "late", "there", planned_s)
    for wait_s in (120.0, 900.0):
        drawn = simulated(
            delays, "late", "there", planned_s, wait_s, runs=chosen(40_000, 400_000), seed=7
        )
        assert in_errors(drawn.chance, gap.by(wait_s), drawn.chance_error)
        assert in_errors(drawn.expected_wait_s, gap.expected_wait_s(wait_s), drawn.wait_error_s)
        value = value_of_waiting(gap, wait_s, 20.0, 0.01)
        assert abs(drawn.value(20.0, 0.01) - value) < chosen(0.6, 0.2)
    assert gap.mean_s == pytest.approx(np.mean(drawn.gaps_s), abs=chosen(20, 6))
    assert gap.spread_s == pytest.approx(np.std(drawn.gaps_s), rel=chosen(0.08, 0.04), abs=1e-6)
    assert gap.expected_wait_s() == pytest.approx(gap.expected_wait_s(1e7), rel=1e-6, abs=1e-4)


@soaked
@given(means, spreads, st.floats(0.0, 90 * MIN))
def test_a_normal_gap_is_that_of_scipy(mean, spread, wait):
    gap, same = NormalGap(mean, spread), stats.norm(mean, spread)
    assert gap.by(wait) == pytest.approx(same.cdf(wait), rel=1e-9, abs=1e-300)
    assert gap.density(wait) == pytest.approx(same.pdf(wait), rel=1e-9)
    points = sorted({min(max(mean + k * spread, 0.0), wait) for k in range(-6, 7)} | {0.0, wait})
    waited = sum(
        integrate.fixed_quad(same.sf, low, high, n=20)[0] for low, high in pairwise(points)
    )
    assert gap.expected_wait_s(wait) == pytest.approx(waited, rel=1e-6, abs=1e-6)
    whole = spread * stats.norm.pdf(mean / spread) + mean * stats.norm.cdf(mean / spread)
    assert gap.expected_wait_s() == pytest.approx(whole, rel=1e-9, abs=1e-9 * spread)
    turned = gap.turned()
    assert turned.by(-wait) == pytest.approx(1 - gap.by(wait), abs=1e-12)


def test_nobody_waits_longer_than_anybody_comes():
    gap = NormalGap(60.0, 300.0)
    last = last_to_come_s(gap, 7200.0)
    assert 60 + 5 * 300 < last < 60 + 7 * 300
    assert gap.by(7200.0) - gap.by(last) <= 1.1e-10
    assert last_to_come_s(gap, 120.0) == pytest.approx(120.0)
    assert last_to_come_s(NormalGap(-4000.0, 300.0), 7200.0) == 0.0
    # Waiting on would be worth nothing, and cost little.
    kept = value_of_waiting(gap, last, 10.0, 1e-4) - value_of_waiting(gap, 7200.0, 10.0, 1e-4)
    assert kept >= -1e-8


def test_a_gap_without_spread_is_what_is_planned():
    for gap in (NormalGap(300.0, 0.0), LognormalGap(300.0, 0.0, 0.0)):
        assert (gap.by(299.0), gap.by(300.0)) == (0.0, 1.0)
        assert gap.expected_wait_s() == 300.0
        assert gap.expected_wait_s(100.0) == 100.0
        assert wait_up_to_s(gap, 400.0, 10.0, 0.01) == 400.0
        assert wait_up_to_s(gap, 400.0, 2.0, 0.01) == 0.0


@pytest.mark.parametrize("correlation", [-1.0, -0.5, 0.0, 0.9, 0.999])
def test_a_lognormal_gap_is_that_of_a_double_integral(correlation):
    gap = LognormalGap(60.0, 400.0, 250.0, correlation, 0.8)
    z = np.linspace(-9, 9, 3001)
    inner = stats.norm.ppf((np.arange(2000) + 0.5) / 2000)
    weight = stats.norm.pdf(z) * (z[1] - z[0])
    other = correlation * z[:, None] + math.sqrt(1 - correlation**2) * inner
    drawn = 60 + 400 * np.exp(0.8 * other) - 250 * np.exp(0.8 * z)[:, None]
    for at in (-400.0, 0.0, 150.0, 900.0):
        assert gap.by(at) == pytest.approx((weight @ (drawn <= at)).mean(), abs=2e-3)
    for at in (150.0, 900.0):
        waits = (weight @ np.clip(drawn, 0, at)).mean()
        assert gap.expected_wait_s(at) == pytest.approx(waits, rel=3e-3)
        step = 1.0
        slope = (gap.by(at + step) - gap.by(at - step)) / (2 * step)
        if abs(correlation) < 0.99:
            assert gap.density(at) == pytest.approx(slope, rel=1e-3)
    assert gap.turned().by(-150.0) == pytest.approx(1 - gap.by(150.0), abs=2e-3)


def test_one_lognormal_delay_is_that_of_scipy():
    gap, same = LognormalGap(0.0, 600.0, 0.0), stats.lognorm(1.0, scale=600.0)
    for at in (1.0, 200.0, 600.0, 5000.0):
        assert gap.by(at) == pytest.approx(same.cdf(at), rel=1e-9)
        assert gap.density(at) == pytest.approx(same.pdf(at), rel=1e-9)
    assert gap.expected_wait_s() == pytest.approx(same.mean(), rel=1e-9)
    assert gap.spread_s == pytest.approx(same.std(), rel=1e-9)
    assert LognormalGap(0.0, 0.0, 600.0).by(0.0) == 1.0


# -- giving up -------------------------------------------------------------------------------------


@soaked
@given(means, spreads, st.floats(1.0, 90 * MIN), st.floats(0.5, 90 * MIN))
def test_under_a_normal_delay_one_waits_for_nothing_or_for_all(mean, spread, window, worth):
    gap = NormalGap(mean, spread)
    best = wait_up_to_s(gap, window, worth, 1.0)
    assert best in (0.0, window)
    values = [value_of_waiting(gap, w, worth, 1.0) for w in np.linspace(0, window, 101)]
    assert value_of_waiting(gap, best, worth, 1.0) >= max(values) - 1e-7 * worth


@soaked
@pytest.mark.parametrize("seed", range(chosen(6, 60)))
def test_under_a_lognormal_delay_one_waits_up_to_the_falling_hazard(seed):
    rng = np.random.default_rng(seed)
    worth, window = float(rng.uniform(2, 60)) * MIN, float(rng.uniform(5, 240)) * MIN
    there = float(rng.choice([0.0, 150.0, 300.0]))
    gap = LognormalGap(
        float(rng.uniform(-600, 600)), float(rng.uniform(60, 900)), there,
        float(rng.uniform(-0.5, 0.9)), float(rng.uniform(0.5, 1.4)),
    )  # fmt: skip
    best = wait_up_to_s(gap, window, worth, 1.0)
    values = [value_of_waiting(gap, w, worth, 1.0) for w in np.linspace(0, window, 301)]
    assert value_of_waiting(gap, best, worth, 1.0) >= max(values) - 1e-6 * worth
    if 0 < best < window:
        hazard = gap.density(best) / (1 - gap.by(best))
        assert worth * hazard == pytest.approx(1.0, rel=1e-4)


def test_a_lognormal_delay_has_waits_between_nothing_and_all():
    gap = LognormalGap(0.0, 600.0, 0.0)
    best = wait_up_to_s(gap, 240 * MIN, 20 * MIN, 1.0)
    assert 15 * MIN < best < 60 * MIN


def test_where_waiting_is_free_all_of_the_window_is_waited():
    gap = NormalGap(0.0, 600.0)
    assert wait_up_to_s(gap, 900.0, 1.0, 0.0) == 900.0
    assert wait_up_to_s(gap, 900.0, 0.0, 0.0) == 0.0
    assert wait_up_to_s(gap, -5.0, 1.0, 0.0) == 0.0


@soaked
@given(spreads, st.floats(0.5, 200 * MIN))
def test_a_buffer_ahead_is_that_of_a_grid(spread, worth):
    best = buffer_ahead_s(spread, worth, 1.0)

    def value(b):
        return worth * stats.norm.cdf(b / spread) - b

    grid = np.linspace(0, 6 * spread, 601)
    assert value(best) >= value(grid).max() - 1e-9 * worth
    assert best >= 0


@soaked
@given(spreads, st.floats(1.0, 200 * MIN))
def test_an_early_start_is_that_of_a_grid(spread, worth):
    best = early_start_s(spread, worth, 1.0, math.inf)
    own = NormalGap(0.0, spread)

    def value(y):  # worth if in time, less what it waits for the others
        return worth * own.by(y) - (y + NormalGap(y, spread).turned().expected_wait_s())

    grid = max(value(y) for y in np.linspace(-6 * spread, 6 * spread, 301))
    assert value(best) >= grid - 1e-6 * worth
    assert early_start_s(spread, worth, 1.0, 5.0) <= 5.0


# -- delays ----------------------------------------------------------------------------------------


@soaked
@given(st.integers(1, 6), st.integers(0, 10_000))
def test_a_factor_gives_the_correlations_back(size, seed):
    rng = np.random.default_rng(seed)
    drawn = rng.standard_normal((size, int(rng.integers(1, size + 2))))  # often singular
    drawn /= np.linalg.norm(drawn, axis=1)[:, None]
    lower = factor(drawn @ drawn.T)
    assert np.allclose(lower @ lower.T, drawn @ drawn.T, atol=1e-7)
    assert np.array_equal(lower, np.tril(lower))


def test_draws_have_the_spreads_and_correlations_asked_for():
    delays = Delays(10, {"b": 4}, 0.5, {("c", "a"): -0.25})
    drawn = delays.draws("abc", 60_000, 3)
    assert np.allclose(drawn.std(axis=0), [600, 240, 600], rtol=0.02)
    found = np.corrcoef(drawn.T)
    assert np.allclose(found, [[1, 0.5, -0.25], [0.5, 1, 0.5], [-0.25, 0.5, 1]], atol=0.02)
    assert np.array_equal(drawn, delays.draws("abc", 60_000, 3))
    assert not np.array_equal(drawn, delays.draws("abc", 60_000, 4))
    late = Delays(10, kind="lognormal").draws("a", 60_000, 3)
    assert late.min() > 0


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"spread_min": -1}, "spread_min is -1; give minutes from 0 to 1440"),
        ({"spread_min": math.nan}, "spread_min is nan"),
        ({"spread_min": True}, "spread_min is True"),
        ({"correlation": 1.2}, "correlation is 1.2; give a number from -1 to 1"),
        ({"kind": "gamma"}, "kind 'gamma' is unknown; use normal, lognormal"),
        ({"own": {"A": "8"}}, "spread of 'A' is '8'"),
        ({"own": [8]}, "own is a list; give a mapping"),
        ({"own": {1: 8}}, "own names 1; give names of vehicles"),
        ({"pairs": {"AB": 0.5}}, "pairs names 'AB'; give two names"),
        ({"pairs": {("A", "A"): 0.5}}, "give two names"),
        ({"pairs": {("A", "B"): 2}}, "correlation of 'A' and 'B' is 2"),
        ({"pairs": {("A", "B"): 0.5, ("B", "A"): 0.4}}, "two values for"),
        ({"shape": 0}, "shape is 0"),
    ],
)  # fmt: skip
def test_delays_that_cannot_be_are_told_in_one_line(given, told):
    with pytest.raises(ScenarioError) as caught:
        Delays(**{"spread_min": 8, **given})
    assert told in str(caught.value)
    assert str(caught.value).startswith("delays: ")


def test_correlations_that_cannot_be_together_are_refused():
    with pytest.raises(ScenarioError, match="not positive semidefinite"):
        Delays(8, correlation=-0.6).draws("abc", 10, 0)
    assert Delays(8, correlation=-0.5).draws("abc", 10, 0).shape == (10, 3)
    assert Delays(8, correlation=1).draws("ab", 10, 0).std(axis=1).max() < 1e-9


@pytest.mark.parametrize("wrong", [{"runs": 0}, {"runs": 2.5}, {"seed": -1}, {"seed": None}])
def test_runs_and_seeds_that_are_none_are_refused(wrong):
    with pytest.raises(ScenarioError, match="give a whole number"):
        simulated(Delays(8), "a", "b", **wrong)
