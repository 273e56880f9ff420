"""What a driver has behind it, and the rules there are: names, units, and what is refused."""

from dataclasses import replace

import pytest

from platoon_osm import Trip
from platoon_osm.driving.eu561 import EU561, EU561_TEAM
from platoon_osm.driving.limits import UNLIMITED, Limits
from platoon_osm.driving.rules import RULES, limits_of, rules_of, spread_of
from platoon_osm.driving.state import RESTED, DriverState, state_of
from platoon_osm.driving.us395 import US395
from platoon_osm.errors import ScenarioError


def test_units_are_in_the_names():
    given = {"driven_since_break_min": 90, "driven_today_h": 2.5, "duty_s": 10_000, "drivers": 1}
    assert state_of(given, "x") == DriverState(5400.0, False, 9000.0, 10_000.0)
    assert Trip("A", 0, 1, driver=given).driver == DriverState(5400.0, False, 9000.0, 10_000.0)
    assert Trip("A", 0, 1).driver is RESTED


def test_who_has_driven_was_on_duty():
    assert DriverState(driven_today_s=3600.0).duty_s == 3600.0
    assert repr(DriverState(driven_today_s=3600.0)) == (
        "DriverState(driven_today_s=3600.0, duty_s=3600.0)"
    )


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"colour": 1}, "driver has no 'colour'; known are driven_since_break_h, first_part"),
        ({"driven_toady_h": 1}, r"driver has no 'driven_toady_h'; did you mean 'driven_today_h'\?"),
        ({"driven_today_h": 25}, "driven_today_h is 25; give a number from 0 to 24"),
        ({"driven_today_min": 1441}, "driven_today_min is 1441; give a number from 0 to 1440"),
        ({"driven_today_s": float("nan")}, "driven_today_s is nan; give a number from 0 to 86400"),
        ({1: 1}, "driver has no 1"),
        ({"driven_today_h": "2"}, "driven_today_h is '2'; give a number"),
        ({"driven_today_h": 1, "driven_today_s": 1}, "names driven_today_s twice"),
        ({"drivers": 3}, "drivers is 3; give a whole number from 1 to 2"),
        ({"driven_since_break_h": 2, "driven_today_h": 1}, "is more than driven_today_s"),
        ({"driven_today_h": 3, "duty_h": 2}, "driven_today_s is more than duty_s"),
        ({"first_part_taken": 1}, "give true or false"),
        ([1], r"driver is \[1\]; give a table"),
    ],
)
def test_what_is_no_state_is_refused_in_one_line(given, said):
    with pytest.raises(ScenarioError, match=said) as error:
        Trip("A", 0, 1, driver=given)
    assert str(error.value).startswith("trip 'A': ")
    assert "\n" not in str(error.value)


def test_rules_are_found_by_name():
    assert list(RULES) == ["none", "eu561", "us395", "spread-rest"]
    assert limits_of(rules_of("eu561")) == EU561
    assert limits_of(rules_of("eu561"), 2) == EU561_TEAM
    assert limits_of(rules_of("none"), 2) == UNLIMITED
    assert spread_of(rules_of("spread-rest")) == pytest.approx(1 / 12)
    with pytest.raises(ScenarioError, match="did you mean 'eu561'"):
        rules_of("eu651")
    with pytest.raises(ScenarioError, match="'us395' are not planned for two drivers"):
        limits_of(rules_of("us395"), 2)


def test_limits_are_numbers():
    with pytest.raises(ScenarioError, match="spell_s is -1"):
        Limits(spell_s=-1)
    with pytest.raises(ScenarioError, match="parts_s"):
        Limits(parts_s=(1.0,))


def test_a_window_that_no_rest_has_to_keep_is_one():
    assert not US395.rest_in_window
    with pytest.raises(ScenarioError, match="window_s and long_window_s differ"):
        replace(EU561, rest_in_window=False)
