"""What would have to give for a vehicle to be in time within the law."""

import pytest
from legal_trips import fastest

from platoon_osm.driving.eu561 import EU561, EU561_TEAM
from platoon_osm.driving.state import RESTED, DriverState
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.legal.driver.road import NO_LIMIT, road_of
from platoon_osm.planning.legal.driver.why_not import why_not

MIN, H = 60, 3600
HALF = 30 * MIN


def parked(halves):
    return road_of([HALF] * halves, [NO_LIMIT] * (halves + 1))


def test_nothing_has_to_give_for_who_is_in_time():
    road = parked(12)
    assert why_not(road, EU561, None, RESTED, 0, 0, None, 6 * H + 45 * MIN) is None


def test_a_break_makes_it_late_and_a_second_driver_would_do():
    """Six hours of driving and 45 min of break, in 6 h 10: two drivers change in 5 min."""
    found = why_not(parked(12), EU561, EU561_TEAM, RESTED, 0, 0, None, 6 * H + 10 * MIN)
    assert found.late_s == found.earlier_s == 35 * MIN
    assert found.remedies == ("second_driver",)
    assert (found.later_s, found.reached) == (None, 12)


def test_a_long_day_or_a_rested_driver_would_do():
    """Nine and a half hours with no long day left: a night on the road."""
    state = DriverState(long_days_used=2, reduced_rests_used=3)
    found = why_not(parked(19), EU561, None, state, 0, 0, None, 15 * H)
    assert found.remedies == ("rested", "long_day")
    assert found.late_s == 9 * H + 30 * MIN + 45 * MIN + 11 * H - 15 * H


def test_a_reduced_rest_would_do():
    state = DriverState(reduced_rests_used=3)
    found = why_not(parked(24), EU561, None, state, 0, 0, None, 12 * H + 90 * MIN + 9 * H)
    assert found.late_s == 2 * H - 45 * MIN
    assert "reduced_rest" in found.remedies


def test_a_later_departure_would_do():
    """Who has driven all day rests first, 11 h, or half-way if it has a long day left."""
    state = DriverState(driven_today_s=9 * H, duty_s=11 * H, long_days_used=2, reduced_rests_used=3)
    found = why_not(parked(4), EU561, None, state, 0, 0, 2 * H, None)
    assert (found.late_s, found.later_s) == (None, 9 * H)
    assert found.remedies == ("rested", "long_day")
    allowed = fastest(parked(4), EU561, state, 0, 0, 2 * H + found.later_s)
    assert allowed.departure_s == 11 * H


def test_a_road_without_places_is_told_by_how_far_one_comes():
    road = road_of([HALF] * 12, [0] * 13)
    found = why_not(road, EU561, None, RESTED, 0, 0)
    assert (found.late_s, found.earlier_s, found.reached) == (None, None, 9)


def test_some_time_has_to_be_given():
    with pytest.raises(ScenarioError, match="no time is given"):
        why_not(parked(2), EU561, None, RESTED, None, None)
