"""Fuel by speed, against physics done by hand and against every speed tried."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.costs.speed_fuel import LEAST_KMH, SpeedFuel
from platoon_osm.errors import ScenarioError


def test_the_force_at_80_km_h_by_hand():
    """Air 0.6 x 0.63 x 10.2 m2 x 493.8, rolling 0.0068 x 392,266 N, auxiliaries 5,000 / 22.2."""
    force = float(SpeedFuel().force_n(80 / 3.6))
    assert force == pytest.approx(1904.0 + 2667.4 + 225.0, abs=0.5)
    alone, together = (
        SpeedFuel().force_n([80 / 3.6], air_saved=0.0),
        SpeedFuel().force_n([80 / 3.6], air_saved=0.5),
    )
    assert float((alone - together)[0]) == pytest.approx(952.0, abs=0.5)


def test_a_preset_holds_at_its_own_speed_and_slower_takes_less():
    fuel = SpeedFuel()
    assert fuel.ratio([25.0], [25.0]).tolist() == [1.0]
    # 70 instead of 80 km/h: about a tenth of the fuel of each kilometre.
    assert float(fuel.ratio(70 / 3.6, 80 / 3.6)) == pytest.approx(0.915, abs=0.005)
    assert float(SpeedFuel(auxiliary_kw=50).ratio(60 / 3.6, 80 / 3.6)) > 0.95


@settings(max_examples=60)
@given(
    edges=st.lists(
        st.tuples(st.integers(100, 50_000), st.integers(40, 90)), min_size=1, max_size=5
    ),
    spare=st.integers(0, 3000),
    auxiliary=st.sampled_from([0.0, 5.0, 40.0]),
)
def test_no_whole_speed_saves_more_in_time(edges, spare, auxiliary):
    fuel = SpeedFuel(auxiliary_kw=auxiliary)
    length = [m for m, _ in edges]
    usual = [kmh / 3.6 for _, kmh in edges]
    kmh, longer, saved = fuel.slowest_in_time(length, usual, float(spare))
    assert longer <= spare
    for cap in range(int(LEAST_KMH), max(speed for _, speed in edges) + 1):
        time_s = burnt = whole = 0.0
        for m, speed in zip(length, usual, strict=True):
            slow = min(speed, cap / 3.6)
            time_s += m / slow - m / speed
            burnt += m * float(fuel.force_n(slow)) / float(fuel.force_n(speed))
            whole += m
        if time_s <= spare:
            assert 1 - burnt / whole <= saved + 1e-12
        if cap == kmh:
            assert time_s == pytest.approx(longer)


def test_what_is_no_share_is_refused():
    with pytest.raises(ScenarioError, match="drag is -1; give 0 to 2"):
        SpeedFuel(drag=-1)


def test_without_time_to_spare_nothing_changes():
    assert SpeedFuel().slowest_in_time([1000.0], [25.0], 0.0) == (90.0, 0.0, 0.0)
    assert np.isfinite(SpeedFuel().slowest_in_time([], [], 10.0)).all()
