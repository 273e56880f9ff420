"""Verdicts on plans: what is found in a timetable, in whose words, and what `check` says of it."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import datetime, timedelta, timezone
from pathlib import Path
from typing import Any

import pytest
from command_line import refused, run
from plan_kinds import KINDS, plan_kind

import platoon_osm as po
from platoon_osm.driving.state import DriverState
from platoon_osm.inspection.agreement import ARTICLE, WINDOW
from platoon_osm.inspection.plan_records import driver_records
from platoon_osm.plans.pauses import DriverDay, Pause, PausePlace
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.timetable import Timetable, VehicleTimes

HOUR = 3600.0
CAFE = PausePlace("Café", "services", 11.0, 45.0)


def with_vehicle(plan: Plan, vehicle: int = 0, **changed: Any) -> Plan:
    """Return a plan with other times of one vehicle."""
    assert plan.timetable is not None
    vehicles = list(plan.timetable.vehicles)
    vehicles[vehicle] = replace(vehicles[vehicle], **changed)
    late = any(times.late_s for times in vehicles)
    timetable = replace(plan.timetable, vehicles=tuple(vehicles), feasible=not late)
    return replace(plan, timetable=timetable)


def with_table(plan: Plan, **changed: Any) -> Plan:
    assert plan.timetable is not None
    return replace(plan, timetable=replace(plan.timetable, **changed))


@pytest.fixture(scope="module")
def together() -> Plan:
    """Return three vehicles in the valley: A drives 6 h 57 without a break, others less."""
    return plan_kind("three vehicles")[0]


@pytest.fixture(scope="module")
def alone() -> Plan:
    """Return A alone, driving from 6:00 for 8 h 30 in three legs, with two pauses of 15 and 30."""
    plan = plan_kind("one vehicle")[0]
    stretch = replace(plan.stretches[0], drive_s=1.0)
    plan = replace(plan, stretches=(stretch,) * 3, ways=((0, 1, 2),), timetable=None, events=())
    legs = ((0.0, 2 * HOUR), (2.25 * HOUR, 4.75 * HOUR), (5.25 * HOUR, 9.25 * HOUR))
    pauses = (
        Pause(1, ("first_part",), 2 * HOUR, 2.25 * HOUR, CAFE),
        Pause(2, ("second_part",), 4.75 * HOUR, 5.25 * HOUR, CAFE),
    )
    drivers = (DriverDay(DriverState(), 0.0),)
    times = VehicleTimes("A", 0.0, legs, pauses=pauses, drivers=drivers)
    return replace(plan, timetable=Timetable("2026-03-02T06:00:00", True, (times,), rules="eu561"))


def articles(plan: Plan, rules: str | None = None) -> list[str]:
    return [one.violation.article for one in po.inspect_plan(plan, rules)]


@pytest.mark.parametrize("name", [name for name in KINDS if name != "real california"])
def test_plans_without_rules_keep_their_word(name: str) -> None:
    plan = plan_kind(name)[0]
    late = sum(times is not None and times.late_s > 0 for times in plan.times)
    assert articles(plan) == [WINDOW] * late


def test_a_legal_day_has_no_violation(alone: Plan) -> None:
    assert po.inspect_plan(alone) == []


def test_legs_are_driving_and_gaps_are_rest(together: Plan) -> None:
    found = po.inspect_plan(together, "eu561")
    assert {one.vehicle for one in found} <= {"A", "B", "C"}
    first = found[0]
    assert (first.vehicle, first.driver) == ("A", 1)
    assert first.violation.article == "561/2006 Art. 7"
    times = together.times[0]
    assert times is not None
    assert first.violation.at_s == pytest.approx(times.departure_s + 4.5 * HOUR, abs=1)
    assert first.violation.over_s == pytest.approx(together.vehicles[0].time_s - 4.5 * HOUR, abs=1)


def test_a_follower_who_is_relieved_drives_less(together: Plan) -> None:
    relieved = with_table(together, task_relief=1.0)
    for one, vehicle in zip(driver_records(relieved), relieved.vehicles, strict=True):
        index = relieved.vehicles.index(vehicle)
        own = [relieved.stretches[k] for k in relieved.ways[index]]
        leads = sum(stretch.drive_s for stretch in own if stretch.vehicles[0] == index)
        assert sum(activity.driven_s for activity in one.record) == pytest.approx(leads, abs=9)
    assert len(po.inspect_plan(relieved, "eu561")) < len(po.inspect_plan(together, "eu561"))


@pytest.mark.parametrize(
    ("start", "clock_s", "week"),
    [
        ("2026-03-02T06:00:00", 0, 6 * HOUR),
        ("2026-03-02T06:00:00+01:00", 3600, 5 * HOUR),
        ("2026-03-02T00:30:00+01:00", 3600, 6 * 24 * HOUR + 23.5 * HOUR),
        ("2026-03-08T22:00:00-08:00", -28800, 6 * HOUR),
    ],
)
def test_weeks_are_those_of_utc(alone: Plan, start: str, clock_s: int, week: float) -> None:
    (record,) = driver_records(with_table(alone, start=start))
    assert record.clock_s == clock_s
    assert record.record[0].start_s == week == -record.monday_s


def test_the_state_is_part_of_the_verdict(alone: Plan) -> None:
    for state, article in (
        (DriverState(driven_since_break_s=HOUR, driven_today_s=HOUR, duty_s=HOUR), "Art. 7"),
        (DriverState(driven_today_s=2 * HOUR, duty_s=2 * HOUR, long_days_used=2), "Art. 6(1)"),
        (DriverState(driven_this_week_s=50 * HOUR), "Art. 6(2)"),
        (DriverState(driven_last_week_s=82 * HOUR), "Art. 6(3)"),
        (DriverState(since_weekly_rest_s=140 * HOUR), "Art. 8(6)"),
        (DriverState(duty_s=6 * HOUR), "Art. 8(2)"),
        (DriverState(duty_s=4 * HOUR, reduced_rests_used=3), "Art. 8(4)"),
    ):
        driver = DriverDay(state, 0.0)
        assert articles(with_vehicle(alone, drivers=(driver,))) == [f"561/2006 {article}"]


def test_who_leaves_later_has_rested_meanwhile(alone: Plan) -> None:
    state = DriverState(driven_since_break_s=HOUR, driven_today_s=HOUR, duty_s=HOUR)
    early = DriverDay(state, -0.75 * HOUR)
    assert articles(with_vehicle(alone, drivers=(early,))) == []
    assert articles(with_vehicle(alone, drivers=(replace(early, state_at_s=-0.74 * HOUR),))) != []


def test_two_drivers_take_turns(alone: Plan) -> None:
    legs = ((0.0, 4.5 * HOUR), (4.6 * HOUR, 9.0 * HOUR), (9.1 * HOUR, 13.5 * HOUR))
    pauses = tuple(Pause(k, ("change",), legs[k - 1][1], legs[k][0], CAFE) for k in (1, 2))
    two = DriverState(drivers=2)
    drivers = (DriverDay(two, 0.0, (0, 2)), DriverDay(two, 0.0, (1,)))
    plan = with_vehicle(alone, legs=legs, pauses=pauses, drivers=drivers)
    assert po.inspect_plan(plan) == []
    assert articles(with_vehicle(plan, drivers=(replace(drivers[0], drives=(0, 1, 2)),))) != []
    both = (replace(drivers[0], drives=(0, 1, 2)), drivers[1])
    assert ARTICLE in articles(with_vehicle(plan, drivers=both))
    nobody = (replace(drivers[0], drives=(0,)), drivers[1])
    assert ARTICLE in articles(with_vehicle(plan, drivers=nobody))


def test_company_is_at_the_same_time(together: Plan) -> None:
    vehicle = next(k for k in range(3) if together.vehicles[k].role == "member")
    times = together.times[vehicle]
    assert times is not None
    later = tuple((start + 60, end + 60) for start, end in times.legs)
    plan = with_vehicle(together, vehicle, legs=later)
    assert ARTICLE in articles(plan)


def test_nobody_is_faster_than_the_road(together: Plan) -> None:
    vehicle = len(together.trips) - 1
    times = together.times[vehicle]
    assert times is not None
    last = (times.legs[-1][0], times.legs[-1][1] - 5)
    assert ARTICLE in articles(with_vehicle(together, vehicle, legs=(*times.legs[:-1], last)))


@pytest.mark.parametrize(
    ("window", "text"),
    [
        ({"earliest_departure_s": 60.0}, "leaves before"),
        ({"latest_departure_s": -60.0}, "leaves after"),
        ({"latest_arrival_s": 9 * HOUR}, "arrives after"),
    ],
)
def test_windows_hold(alone: Plan, window: dict[str, float], text: str) -> None:
    (found,) = po.inspect_plan(with_vehicle(alone, **window))
    assert found.violation.article == WINDOW
    assert found.violation.text.startswith(text)
    assert found.driver == 0


@pytest.mark.parametrize(
    ("number", "changed", "text"),
    [
        (1, {"purposes": ("break",)}, "pauses 30 min for a break of 45 min"),
        (1, {"purposes": ("daily_rest",)}, "pauses 30 min for a daily rest of 11 h"),
        (0, {"end_s": 2.2 * HOUR}, "pauses 12 min for a first part of 15 min"),
        (0, {"place": None}, "takes a break or rest at no stated place"),
        (0, {"purposes": ("company",)}, "takes the second part of a break before the first"),
    ],
)
def test_pauses_are_what_they_claim(
    alone: Plan, number: int, changed: dict[str, Any], text: str
) -> None:
    times = alone.times[0]
    assert times is not None
    pauses = list(times.pauses)
    pauses[number] = replace(pauses[number], **changed)
    found = po.inspect_plan(with_vehicle(alone, pauses=tuple(pauses)))
    assert text in [one.violation.text for one in found]
    assert all(one.violation.article == ARTICLE for one in found)


def test_the_first_part_may_be_taken_at_the_origin(alone: Plan) -> None:
    times = alone.times[0]
    assert times is not None
    state = DriverState(driven_since_break_s=HOUR / 4, driven_today_s=HOUR / 4, duty_s=HOUR)
    for waited_s, found in ((900.0, []), (890.0, [ARTICLE, "561/2006 Art. 7"])):
        legs = ((0.0, 4.25 * HOUR), (4.75 * HOUR, 9.0 * HOUR))
        pause = Pause(1, ("second_part",), 4.25 * HOUR, 4.75 * HOUR, CAFE)
        plan = replace(alone, ways=((0, 1),), timetable=None, stretches=alone.stretches[:2])
        driver = DriverDay(state, -waited_s)
        own = replace(times, legs=legs, pauses=(pause,), drivers=(driver,))
        assert alone.timetable is not None
        plan = replace(plan, timetable=replace(alone.timetable, vehicles=(own,)))
        assert sorted(articles(plan), reverse=True) == found


def test_pauses_do_not_overlap(alone: Plan) -> None:
    times = alone.times[0]
    assert times is not None
    twice = (times.pauses[0], *times.pauses)
    assert articles(with_vehicle(alone, pauses=twice)) == [ARTICLE]


def test_fractions_of_a_second_are_no_violation(alone: Plan) -> None:
    times = alone.times[0]
    assert times is not None
    for over_s, found in ((0.0, []), (0.9, []), (1.0, ["561/2006 Art. 7"])):
        legs = (*times.legs[:2], (5.25 * HOUR, 9.75 * HOUR + over_s))
        assert articles(with_vehicle(alone, legs=legs)) == found
    for short_s, found in ((0.5, []), (0.9, []), (1.0, ["561/2006 Art. 7"])):
        legs = (times.legs[0], (2.25 * HOUR, 4.75 * HOUR + short_s), times.legs[2])
        pauses = (times.pauses[0], replace(times.pauses[1], start_s=legs[1][1]))
        said = articles(with_vehicle(alone, legs=legs, pauses=pauses))
        assert [article for article in said if article != ARTICLE] == found


def test_rules_without_a_checker_are_named(alone: Plan) -> None:
    with pytest.raises(po.ScenarioError, match="'ours' have no checker"):
        po.inspect_plan(with_table(alone, rules="ours"))
    assert po.inspect_plan(with_table(alone, rules="ours"), "none") == []


# -- the command -----------------------------------------------------------------------------------


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_check_says_that_a_plan_is_legal(alone: Plan, capsys: pytest.CaptureFixture[str]) -> None:
    alone.write_json("plan.json")
    assert run("check", "plan.json") == 0
    said = "no violation of (EC) 561/2006 and 2002/15/EC by 1 driver over 8 h 30 of driving\n"
    assert capsys.readouterr().out == said


def test_check_prints_a_line_for_each_violation(
    together: Plan, capsys: pytest.CaptureFixture[str]
) -> None:
    zone = timezone(timedelta(hours=1))
    start = datetime(2026, 3, 2, 6, tzinfo=zone).isoformat()
    with_table(together, start=start).write_json("plan.json")
    assert run("check", "plan.json", "--rules", "eu561") == 1
    out, err = capsys.readouterr()
    assert err == ""
    assert out.count("\n") == len(po.inspect_plan(together, "eu561"))
    first = out.splitlines()[0]
    assert first.startswith("A, driver 1: 561/2006 Art. 7, 2026-03-02 10:30, 147 min: 6 h 57 min")
    assert run("check", "plan.json") == 0
    assert "no driving rules were looked at" in capsys.readouterr().out


def test_check_shows_hostile_names_safely(
    together: Plan, capsys: pytest.CaptureFixture[str]
) -> None:
    data = together.to_dict()
    text = json.dumps(data).replace('"vehicle": "A"', '"vehicle": "A\\u001b[31m\\n\\u202eB"')
    Path("plan.json").write_text(text, encoding="utf-8")
    assert run("check", "plan.json", "--rules", "eu561") == 1
    out = capsys.readouterr().out
    assert out.count("\n") == len(po.inspect_plan(together, "eu561"))
    assert "\x1b" not in out
    assert "\u202e" not in out


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "is no JSON file"),
        (b"[]", "plan.json: "),
        (b"{}", "plan.json: "),
        (b"\xff\xfe\x00", "is no JSON file"),
        (b'{"plan_version": 99}', "plan.json: "),
    ],
)
def test_check_refuses_what_is_no_plan(
    content: bytes, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("plan.json").write_bytes(content)
    refused(capsys, ["check", "plan.json"], said)


def test_check_refuses_what_it_cannot_look_at(
    alone: Plan, capsys: pytest.CaptureFixture[str]
) -> None:
    refused(capsys, ["check", "gone.json"], "gone.json: cannot be read")
    refused(capsys, ["check"], "'PLAN' is required")
    replace(alone, timetable=None).write_json("plan.json")
    refused(capsys, ["check", "plan.json"], "plan.json: names no times")
    alone.write_json("plan.json")
    refused(capsys, ["check", "plan.json", "--rules", "ours"], "'ours' is not one of")
    with_table(alone, rules="ours").write_json("plan.json")
    refused(capsys, ["check", "plan.json"], "'ours' have no checker")


@pytest.mark.parametrize("moment", [float("nan"), float("inf"), -1e300, None, "six"])
def test_a_driver_whose_state_holds_at_no_moment_is_no_driver(moment: Any) -> None:
    with pytest.raises(po.ScenarioError, match="a driver's state at"):
        DriverDay(DriverState(), moment)
