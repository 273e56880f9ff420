"""The fastest legal trip of one driver: against all trips of small roads, and by hand."""

import math
import random
from dataclasses import replace

import pytest
from drawn_roads import drawn_road
from legal_by_hand import WEEK, as_list, legal, trips
from legal_trips import fastest, least_late

from platoon_osm.driving.eu561 import EU561, EU561_TEAM
from platoon_osm.driving.limits import UNLIMITED, Limits
from platoon_osm.driving.state import RESTED, DriverState
from platoon_osm.driving.us395 import US395
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.legal.driver.kernel import LABELS
from platoon_osm.planning.legal.driver.label_search import search
from platoon_osm.planning.legal.driver.road import FREE, NO_LIMIT, road_of

MIN, H = 60, 3600
STEP = 600
LONGEST = 8


@pytest.fixture(autouse=True)
def uncompiled(monkeypatch):
    """Compile nothing: many small searches take less."""
    monkeypatch.setattr(LABELS, "_compiling_s", math.inf)


def drawn_limits(rng, step, weeks):
    given = {
        "spell_s": 4, "break_s": 3, "day_s": 6, "long_day_s": 7, "rest_s": 5, "reduced_rest_s": 4,
        "window_s": 9, "long_window_s": 10,
    }  # fmt: skip
    if rng.random() < 0.2:
        given |= {"work_spell_s": 3, "work_pause_s": 1}
    if weeks:
        given |= {"week_s": rng.choice([5, 7, 8]), "fortnight_s": rng.choice([8, 10, 12])}
        if rng.random() < 0.3:
            given |= {"weekly_rest_s": 7, "weekly_after_s": rng.choice([10, 14])}
    return Limits(
        **{name: value * step for name, value in given.items()},
        parts_s=None if rng.random() < 0.2 else (step, 2 * step),
        long_days=rng.choice([0, 1, 2]),
        reduced_rests=rng.choice([0, 1, 2]),
        calendar_weeks=not weeks or rng.random() < 0.8,
    )


def drawn_state(rng, step, weeks):
    given, counts = {}, {}
    if rng.random() < 0.6:
        driven = rng.randint(0, 3)
        today = rng.randint(driven, 3 if weeks else 5)
        given = {
            "driven_since_break_s": driven, "driven_today_s": today,
            "duty_s": rng.randint(max(today, 1), 4 if weeks else 8),
        }  # fmt: skip
        counts = {
            "first_part_taken": driven > 0 and rng.random() < 0.4,
            "long_days_used": rng.randint(0, 1), "reduced_rests_used": rng.randint(0, 1),
        }  # fmt: skip
    if weeks:
        given["driven_this_week_s"] = max(rng.randint(0, 5), given.get("driven_today_s", 0))
        given["driven_last_week_s"] = rng.randint(0, 3)
        given["since_weekly_rest_s"] = max(rng.randint(0, 5), given.get("duty_s", 0))
    return DriverState(**{name: value * step for name, value in given.items()}, **counts)


def check(seed, *, bans=0, appointments=0, relief=False, weeks=False, any_time=False):
    """Compare a drawn trip with all trips; return whether there is one."""
    rng = random.Random(seed)
    step = WEEK // 24 if weeks else STEP
    limits = drawn_limits(rng, step, weeks)
    state = drawn_state(rng, step, weeks)
    if any_time:
        # Nothing is driven after the window, but rests may begin whenever they will.
        limits = replace(limits, rest_in_window=False, long_window_s=limits.window_s)
        state = replace(state, duty_s=rng.randint(5, 14) * step + state.driven_today_s)
    state_at = None if rng.random() < 0.2 else rng.randint(-2, 2) * step
    earliest = (state_at or 0) + rng.randint(0, 3) * step
    latest = None if rng.random() < 0.6 else earliest + rng.randint(0, 6) * step
    road = drawn_road(rng, step, earliest, bans, appointments, relief)
    total = int(road.drive_s.sum())
    # Who leaves as late as possible is not compared where a week's driving can be too much.
    aim = "arrive" if weeks else rng.choice(["arrive", "leave"])
    arrival = None
    if aim == "leave" or rng.random() < 0.2:
        arrival = earliest + total + rng.randint(0, 10) * step
    monday = (rng.randint(0, 24) if weeks else 500) * step
    found = fastest(road, limits, state, state_at, earliest, latest, arrival, monday, aim)

    def worth(leaves, arrives):
        if weeks:
            return arrives
        return (arrives, -leaves) if aim == "arrive" else (-leaves, arrives)

    until = earliest + total + 9 * step if arrival is None else arrival
    best = None
    if found is not None:
        assert legal(road, limits, state, state_at, monday, as_list(road, found)), seed
        assert earliest <= found.departure_s
        assert latest is None or found.departure_s <= latest
        assert arrival is None or found.arrival_s <= arrival
        best = worth(found.departure_s, found.arrival_s)
        if aim == "arrive":
            until = found.arrival_s
    last = until if latest is None else latest
    for number, trip in enumerate(trips(road, step, earliest, last, until, LONGEST * step)):
        if number > (2_000 if weeks else 20_000):
            break
        arrives = trip[-1][1] + int(road.drive_s[-1])
        if best is None or worth(trip[0][1], arrives) < best:
            assert not legal(road, limits, state, state_at, monday, trip), (seed, trip)
    return found is not None


DRAWS = 50


@pytest.mark.parametrize(
    "given",
    [
        {}, {"bans": 1}, {"bans": 3}, {"appointments": 1}, {"appointments": 2, "bans": 1},
        {"relief": True, "bans": 1}, {"weeks": True}, {"any_time": True},
        {"any_time": True, "bans": 1},
    ],
    ids=str,
)  # fmt: skip
def test_no_trip_is_better(given):
    found = [check(seed, **given) for seed in range(20 if "weeks" in given else DRAWS)]
    assert any(found)
    assert not all(found)


@pytest.mark.parametrize("given", [{}, {"bans": 1}, {"weeks": True}], ids=str)
def test_labels_that_are_dropped_are_not_missed(given):
    for seed in range(30):
        rng = random.Random(seed)
        weeks = "weeks" in given
        step = WEEK // 24 if weeks else STEP
        limits, state = drawn_limits(rng, step, weeks), drawn_state(rng, step, weeks)
        road = drawn_road(rng, step, 0, given.get("bans", 0), 0, relief=False)
        asked = (road, limits, state, 0, 0, None, None, 12 * step)
        kept, every = (fastest(*asked, dominance=one) for one in (True, False))
        assert (kept is None) == (every is None)
        if kept is not None:
            assert kept.arrival_s == every.arrival_s
            assert weeks or kept.departure_s == every.departure_s


def parked(drive_s):
    return road_of(drive_s, [NO_LIMIT] * (len(drive_s) + 1))


def told(trip):
    return [
        (pause.point, pause.start_s / H, (pause.end_s - pause.start_s) / H, pause.purposes)
        for pause in trip.pauses
    ]


def test_milano_to_napoli_is_a_long_day_with_two_breaks():
    """9 h 33 of driving in hops of 19 min 6 s: 45 min after 14 hops and after 14 more."""
    hop = 19 * MIN + 6
    trip = fastest(parked([hop] * 30), EU561, RESTED, 0, 0)
    assert trip.departure_s == 0
    assert trip.arrival_s == 9 * H + 33 * MIN + 2 * 45 * MIN
    breaks = [(pause.point, pause.start_s, pause.end_s) for pause in trip.pauses]
    first = 14 * hop
    second = first + 45 * MIN + 14 * hop
    assert breaks == [(14, first, first + 45 * MIN), (28, second, second + 45 * MIN)]
    assert {pause.purposes for pause in trip.pauses} == {("break",)}


def test_without_long_days_left_the_driver_rests():
    trip = fastest(parked([30 * MIN] * 20), EU561, DriverState(long_days_used=2), 0, 0)
    assert [one for pause in told(trip) for one in pause[3]] == ["break", "reduced_daily_rest"]
    assert trip.duration_s == 10 * H + 45 * MIN + 9 * H


def test_a_long_day_that_is_over_is_behind_one_that_has_begun():
    """Rest after 3 h 30, then 6 h: one long day. Rest after 5 h is one too, and 4 h 30 another."""
    limits = Limits(day_s=4 * H, long_day_s=6 * H, long_days=1, rest_s=3 * H)
    trip = fastest(parked([210 * MIN, 90 * MIN, 3 * H, 90 * MIN]), limits, RESTED, 0, 0)
    assert told(trip) == [(1, 3.5, 3.0, ("daily_rest",))]
    assert trip.arrival_s == 12.5 * H


def test_a_wait_before_the_trip_is_a_break():
    """Four hours driven: to leave at once means a break on the way; 45 min later means none."""
    state = DriverState(driven_since_break_s=4 * H, driven_today_s=4 * H, duty_s=5 * H)
    trip = fastest(parked([30 * MIN] * 4), EU561, state, 0, 0)
    assert (trip.departure_s, trip.arrival_s, trip.pauses) == (45 * MIN, 2 * H + 45 * MIN, ())


def test_a_pause_before_any_driving_is_no_part_of_a_break():
    trip = fastest(parked([30 * MIN] * 12), EU561, RESTED, 0, 0)
    assert trip.arrival_s == 6 * H + 45 * MIN


def test_a_break_may_be_taken_in_two_parts_in_order():
    """Places where only 20 min are allowed, then 40: no whole break, but 15 and 30 min."""
    stays = [0, 0, 0, 0, 20 * MIN, 0, 40 * MIN, 0, 0, 0]
    trip = fastest(road_of([40 * MIN] * 9, stays), EU561, RESTED, 0, 0)
    assert [pause.purposes for pause in trip.pauses] == [("first_part",), ("second_part",)]
    assert trip.duration_s == 6 * H + 45 * MIN
    backwards = [0, 0, 0, 0, 40 * MIN, 0, 20 * MIN, 0, 0, 0]
    assert fastest(road_of([40 * MIN] * 9, backwards), EU561, RESTED, 0, 0) is None


def test_an_appointment_that_lasts_is_a_break_only_where_one_may_stand():
    leave = [FREE] * 13
    leave[8] = 5 * H
    drive = [30 * MIN] * 12
    stays = [NO_LIMIT] * 13
    there = fastest(road_of(drive, stays, leave_s=leave), EU561, RESTED, 0, 0)
    assert there.arrival_s == 7 * H
    assert [pause.purposes[0] for pause in there.pauses] == ["break"]
    stays[8] = 0
    nowhere = fastest(road_of(drive, stays, leave_s=leave), EU561, RESTED, 0, 0)
    assert [pause.point for pause in nowhere.pauses if "break" in pause.purposes] != [8]


def test_a_forced_wait_is_moved_to_the_origin_so_that_the_duty_period_begins_later():
    """Leaving at 0 would end driving after 15 h on duty; so the driver leaves later."""
    leave = [FREE] * 5
    leave[3] = 16 * H
    road = road_of([H] * 4, [0, 0, 0, 0, 0], leave_s=leave)
    trip = fastest(road, EU561, RESTED, 0, 0)
    assert (trip.departure_s, trip.arrival_s) == (13 * H, 17 * H)
    fixed = fastest(road, EU561, RESTED, 0, 0, latest_s=0)
    assert fixed is None


def test_leaving_as_late_as_possible_is_in_time():
    trip = fastest(parked([30 * MIN] * 12), EU561, RESTED, None, None, None, 100 * H, aim="leave")
    assert (trip.departure_s, trip.arrival_s) == (100 * H - 6 * H - 45 * MIN, 100 * H)
    assert trip.paused_s == 45 * MIN


def test_two_drivers_take_turns():
    state = DriverState(drivers=2)
    trip = fastest(parked([30 * MIN] * 30), EU561_TEAM, state, 0, 0)
    assert trip.duration_s == 15 * H + 3 * 5 * MIN
    assert all(pause.purposes == ("change",) for pause in trip.pauses)
    hours = [trip.drives.count(driver) / 2 for driver in (0, 1)]
    assert sum(hours) == 15
    assert max(hours) <= 9


def test_two_drivers_rest_after_eighteen_hours_in_which_each_drove_nine():
    trip = fastest(
        parked([30 * MIN] * 40), replace(EU561_TEAM, long_days=0), DriverState(drivers=2), 0, 0
    )
    rests = [pause for pause in trip.pauses if "daily_rest" in pause.purposes]
    assert len(rests) == 1
    before = trip.drives[: rests[0].point]
    assert max(before.count(driver) for driver in (0, 1)) <= 18


def test_the_united_states_ask_for_half_an_hour_after_eight():
    trip = fastest(parked([30 * MIN] * 22), US395, RESTED, 0, 0)
    assert trip.duration_s == 11 * H + 30 * MIN
    night = fastest(parked([30 * MIN] * 23), US395, RESTED, 0, 0)
    assert night.duration_s == 11 * H + 30 * MIN + 10 * H


def test_a_week_ends_on_sunday_at_midnight():
    """55 h driven: one hour more before Monday, at 10 h here, and the rest after it."""
    state = DriverState(driven_this_week_s=55 * H)
    road = parked([30 * MIN] * 8)
    trip = fastest(road, EU561, state, 0, 0, monday_s=10 * H)
    assert trip.arrival_s == 10 * H + 3 * H
    assert fastest(road, EU561, replace(state, driven_this_week_s=52 * H), 0, 0).arrival_s == 4 * H


def test_a_weekly_rest_comes_in_time():
    state = DriverState(since_weekly_rest_s=140 * H, duty_s=0)
    trip = fastest(parked([30 * MIN] * 12), EU561, state, 0, 0)
    assert [pause.purposes for pause in trip.pauses] == [("weekly_rest",)]
    assert trip.pauses[0].start_s == 4 * H
    assert trip.arrival_s == 51 * H


def test_without_limits_nobody_stops():
    trip = fastest(parked([H] * 30), UNLIMITED, RESTED, 0, 0)
    assert (trip.departure_s, trip.arrival_s, trip.pauses) == (0, 30 * H, ())


def test_nowhere_to_stop_is_against_the_law():
    road = road_of([H] * 6, [0] * 7)
    assert fastest(road, EU561, RESTED, 0, 0) is None
    assert least_late(road, EU561, RESTED, 0, 0) is None


def test_who_is_late_is_told_by_how_much():
    road = parked([30 * MIN] * 12)
    assert fastest(road, EU561, RESTED, 0, 0, arrival_s=6 * H) is None
    assert least_late(road, EU561, RESTED, 0, 0) == 6 * H + 45 * MIN


def test_a_road_without_hops_is_left_and_reached_at_once():
    trip = fastest(road_of([], [0]), EU561, RESTED, 0, 60)
    assert (trip.departure_s, trip.arrival_s) == (60, 60)


def test_some_time_has_to_be_given():
    with pytest.raises(ScenarioError, match="no time is given"):
        fastest(parked([H]), EU561, RESTED, None, None)


def test_compiled_and_plain_searches_agree(monkeypatch):
    if not LABELS.is_kept():
        pytest.skip("the search has not been compiled here")
    rng = random.Random(3)
    for _ in range(5):
        road = parked([rng.randint(600, 2400) for _ in range(30)])
        asked = (road, EU561, DriverState(driven_since_break_s=H, driven_today_s=H), 0, 0)
        found = fastest(*asked)
        used = "platoon_osm.planning.legal.driver.trip_search.label_search"
        monkeypatch.setattr(used, lambda _: search)
        assert fastest(*asked) == found
        monkeypatch.undo()
