"""Shares in whole cents."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.errors import ScenarioError
from platoon_osm.sharing.cents import in_cents


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=12))
def test_cents_add_up_and_nobody_becomes_worse_off(drawn):
    total = round(sum(drawn))
    shares = [share + (total - sum(drawn)) / len(drawn) for share in drawn]
    cents = in_cents(shares, total)
    assert sum(cents) == total
    for share, own in zip(shares, cents, strict=True):
        assert abs(own - share) < 1 + 1e-6
        assert own >= 0 or share < 0


@given(st.integers(0, 1000), st.integers(1, 12))
def test_the_first_of_equal_shares_get_what_is_left(total, n):
    cents = in_cents([total / n] * n, total)
    assert sorted(cents, reverse=True) == list(cents)
    assert cents[0] - cents[-1] in (0, 1)


def test_last_digits_are_not_cents():
    assert in_cents([0.9999999, 1.0000001], 2) == (1, 1)
    assert in_cents([-1e-9, 1e-9], 0) == (0, 0)


@pytest.mark.parametrize("shares", [[1.0, 2.0], [float("nan"), 1.0]])
def test_what_is_not_the_total_is_told_in_a_line(shares):
    with pytest.raises(ScenarioError, match="not to 4"):
        in_cents(shares, 4)
