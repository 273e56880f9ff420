"""The fastest legal trip of two drivers in one vehicle: against all trips of small roads."""

import math
import random

import pytest
from drawn_roads import drawn_road
from legal_trips import fastest
from soak import chosen, soaked
from team_by_hand import WEEK, Case, best_of_all, legal

from platoon_osm.driving.eu561 import EU561_TEAM
from platoon_osm.driving.limits import Limits
from platoon_osm.driving.state import DriverState
from platoon_osm.planning.legal.driver.kernel import LABELS
from platoon_osm.planning.legal.driver.road import NO_LIMIT, road_of

MIN, H = 60, 3600
STEP = 600
LONGEST = 9
HAIR = 5
"""By so much a break of the drawn limits is less than whole steps."""


@pytest.fixture(autouse=True)
def uncompiled(monkeypatch):
    """Compile nothing: many small searches take less."""
    monkeypatch.setattr(LABELS, "_compiling_s", math.inf)


def drawn_limits(rng, step, weeks, tired):
    """Return limits under which days are short or, for drivers who are tired, breaks are long."""
    day, spell = rng.choice([8, 20]) if tired else rng.choice([3, 4, 5]), rng.choice([3, 4])
    given = {
        "spell_s": 5 if tired else spell, "day_s": 2 * day, "long_day_s": 2 * day + 2,
        "rest_s": 9 if tired else 5, "reduced_rest_s": 7 if tired else 4,
        "window_s": rng.choice([11, 14]) + (12 if tired else 0),
        "long_window_s": 27 if tired else 15, "change_s": 1,
    }  # fmt: skip
    if weeks:
        given |= {"week_s": rng.choice([8, 10, 14]), "fortnight_s": rng.choice([12, 16, 20])}
        if rng.random() < 0.3:
            given |= {"weekly_rest_s": 6, "weekly_after_s": rng.choice([12, 16])}
    return Limits(
        **{name: value * step for name, value in given.items()},
        break_s=step, beside_s=rng.choice([4, 5] if tired else [2, 3]) * step - HAIR,
        long_days=rng.choice([0, 1, 2]), reduced_rests=rng.choice([0, 0, 1]),
        calendar_weeks=not weeks or rng.random() < 0.8,
    )  # fmt: skip


def drawn_state(rng, step, weeks, tired):
    given, counts = {}, {}
    if tired or rng.random() < 0.7:
        driven = rng.randint(2, 4) if tired else rng.randint(0, 3)
        today = rng.randint(driven, max(3, driven))
        given = {
            "driven_since_break_s": driven, "driven_today_s": today,
            "duty_s": rng.randint(max(today, 1), 4 if weeks else 8),
        }  # fmt: skip
        counts = {
            "first_part_taken": driven > 0 and rng.random() < 0.4,
            "long_days_used": rng.randint(0, 1), "reduced_rests_used": rng.randint(0, 1),
        }  # fmt: skip
    if weeks:
        given["driven_this_week_s"] = max(rng.randint(0, 4), given.get("driven_today_s", 0))
        given["driven_last_week_s"] = rng.randint(0, 3)
        given["since_weekly_rest_s"] = max(rng.randint(0, 5), given.get("duty_s", 0))
    return DriverState(**{name: value * step for name, value in given.items()}, **counts, drivers=2)


def two_drivers_road(rng, step, begins, bans, appointments, relief, tired):
    """Return a road; for drivers who are tired one of more hops, each of them short."""
    shape = {"hops": (4, 5, 6), "drives": (1, 1, 2)} if tired else {}
    return drawn_road(rng, step, begins, bans, appointments, relief, places=0.8, **shape)


def check(seed, *, bans=0, appointments=0, relief=False, weeks=False, tired=False):
    """Compare a drawn trip with all trips; return whether there is one."""
    rng = random.Random(seed)
    step = WEEK // 24 if weeks else STEP
    limits = drawn_limits(rng, step, weeks, tired)
    state = drawn_state(rng, step, weeks, tired)
    state_at = None if rng.random() < (0.7 if tired else 0.3) else rng.randint(-2, 2) * step
    earliest = (state_at or 0) + rng.randint(0, 3) * step
    latest = earliest + rng.randint(0, 8) * step
    road = two_drivers_road(rng, step, earliest, bans, appointments, relief, tired)
    total = int(road.drive_s.sum())
    latest = earliest if tired and rng.random() < 0.5 else latest
    aim = "arrive" if weeks else rng.choice(["arrive", "leave"])
    arrival = None
    if aim == "leave" or rng.random() < 0.2:
        arrival = earliest + total + rng.randint(0, 10) * step
    monday = (rng.randint(0, 24) if weeks else 500) * step
    found = fastest(road, limits, state, state_at, earliest, latest, arrival, monday, aim)
    case = Case(road, limits, state, state_at, monday, strict=bool(bans or appointments))
    until = earliest + total + 14 * step if arrival is None else arrival
    if found is not None:
        assert legal(case, found), seed
        assert earliest <= found.departure_s <= latest
        assert arrival is None or found.arrival_s <= arrival
        if aim == "arrive":
            until = found.arrival_s
    best = best_of_all(case, step, earliest, latest, until, LONGEST * step, aim)
    if best is None:
        return found is not None
    assert found is not None, (seed, best)
    own = found.departure_s, found.arrival_s
    if aim == "arrive":
        assert own[1] <= best[1], (seed, own, best)
        assert weeks or own[1] < best[1] or own[0] >= best[0], (seed, own, best)
    else:
        assert own[0] > best[0] or (own[0] == best[0] and own[1] <= best[1]), (seed, own, best)
    return True


@soaked
@pytest.mark.parametrize(
    "given",
    [
        {}, {"tired": True}, {"relief": True}, {"tired": True, "relief": True}, {"weeks": True},
        {"bans": 1}, {"bans": 2, "tired": True}, {"appointments": 1, "bans": 1, "tired": True},
    ],
    ids=str,
)  # fmt: skip
def test_no_trip_of_two_is_better(given):
    found = [check(seed, **given) for seed in range(chosen(20, 400))]
    assert any(found)
    assert not all(found)


def test_labels_of_two_that_are_dropped_are_not_missed():
    for seed in range(12):
        rng = random.Random(seed)
        tired = seed % 2 == 0
        limits, state = drawn_limits(rng, STEP, False, tired), drawn_state(rng, STEP, False, tired)
        road = two_drivers_road(rng, STEP, 0, 0, 0, relief=False, tired=False)
        asked = (road, limits, state, 0, 0, None, None, 500 * STEP)
        kept, every = (fastest(*asked, dominance=one) for one in (True, False))
        assert (kept is None) == (every is None)
        if kept is not None:
            assert (kept.departure_s, kept.arrival_s) == (every.departure_s, every.arrival_s)


def test_two_drivers_who_both_have_driven_stand_until_one_is_rested():
    """Half an hour is left to each: one drives it, and both stand until the other sat 45 min."""
    state = DriverState(driven_since_break_s=4 * H, driven_today_s=4 * H, drivers=2)
    road = road_of([10 * MIN] * 12, [NO_LIMIT] * 13)
    trip = fastest(road, EU561_TEAM, state, None, 0)
    assert trip.duration_s == 2 * H + 15 * MIN + HAIR
    assert trip.pauses[-1].purposes == ("break", "change")
    nowhere = road_of([10 * MIN] * 12, [0] * 13)
    assert fastest(nowhere, EU561_TEAM, state, None, 0) is None


def test_two_drivers_change_seats_at_a_rest():
    """Only one long day is left to each, and both hops are one: each drives one of them."""
    limits = Limits(
        spell_s=4 * H, change_s=5 * MIN, beside_s=H, day_s=2 * H, long_day_s=6 * H, long_days=1,
        rest_s=9 * H, window_s=3 * H, long_window_s=3 * H,
    )  # fmt: skip
    trip = fastest(road_of([2 * H, 2 * H], [0, NO_LIMIT, 0]), limits, DriverState(drivers=2), 0, 0)
    assert trip.duration_s == 4 * H + 9 * H
    assert trip.drives == (0, 1)
    assert trip.pauses[0].purposes == ("daily_rest", "change")
