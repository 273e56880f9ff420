"""Breaks, rests and the law in summaries, frames and exit statuses: plans added up by hand."""

from dataclasses import replace
from datetime import datetime, timedelta
from itertools import pairwise

import click
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import network

import platoon_osm as po
from platoon_osm.cli.exit_status import UNMET, end_if_unmet
from platoon_osm.driving.state import RESTED, DriverState
from platoon_osm.planning.timing.stops import cut_plan
from platoon_osm.plans.lateness import NOT_LAWFUL
from platoon_osm.plans.pauses import PURPOSES, DriverDay, Pause, PausePlace
from platoon_osm.plans.standing import rested_s, standing, waited_s
from platoon_osm.plans.timetable import LATE_S, Timetable, VehicleTimes

H, MIN = 3600.0, 60.0
CAFE = PausePlace("Secchia Ovest", "services", 10.8, 44.7, 150.0, 60)
NOWHERE = PausePlace("", "junction", 10.9, 44.6)


@pytest.fixture(scope="module")
def bare():
    """A, alone over 600 km at 80 km/h, cut in quarters: 1 h 52 min 30 s each."""
    net = network([0, 1], [1, 2], [300e3, 300e3])
    trips = [po.Trip("A", 0, 2, datetime(2026, 3, 2, 6))]
    plan = replace(po.plan_joint(net, po.paper_weights(net), trips, "C"), timetable=None)
    return cut_plan(net, plan, {0: [(0, 0.5), (1, 0.0), (1, 0.5)]})


def timed(plan, stands, rules="eu561", relief=0.0, drivers=()):
    """Return the plan with a timetable in which A stands so many pauses long before each leg."""
    at, legs, pauses = 0.0, [], []
    for leg, k in enumerate(plan.ways[0]):
        for purposes, lasts, place in stands.get(leg, ()):
            if purposes:
                pauses.append(Pause(leg, purposes, at, at + lasts, place))
            at += lasts
        legs.append((at, at + plan.stretches[k].drive_s))
        at = legs[-1][1]
    times = VehicleTimes("A", 0.0, tuple(legs), pauses=tuple(pauses), drivers=drivers)
    table = Timetable(
        "2026-03-02T06:00:00", True, (times,), rules=rules, task_relief=relief
    )  # fmt: skip
    return replace(plan, timetable=table)


DAY = {
    1: [(("first_part", "company"), 20 * MIN, CAFE)],
    2: [(("second_part",), 30 * MIN, NOWHERE), ((), 10 * MIN, None)],
    3: [(("daily_rest",), 11 * H, CAFE)],
}


def rows(plan):
    return plan.summary().splitlines()


def test_a_day_with_a_break_in_two_and_a_night(bare):
    lines = rows(timed(bare, DAY))
    law = lines.index("Driving rules: Regulation (EC) 561/2006 and Directive 2002/15/EC.")
    # 6:00, 7:52:30, 8:12:30, 10:05, 10:35, 10:45, 12:37:30, 23:37:30, 1:30
    assert lines[law + 1] == (
        "A drives 7 h 30 min until 12:38 and 01:30 +1 d; first part of a break and wait for "
        "company 07:53 to 08:13 at Secchia Ovest (services); second part of a break 10:05 to 10:35 "
        "at junction, no parking known; daily rest 12:38 to 23:38 at Secchia Ovest (services)"
    )
    header = next(line for line in lines if line.startswith("vehicle"))
    assert header.split()[-4:] == ["leaves", "arrives", "waits", "rests"]
    own, total = (next(line for line in lines if line.startswith(word)) for word in ("A ", "total"))
    for line in (own, total):
        assert line.endswith("10 min  11 h 50 min"), line


def test_who_stands_for_nothing_and_who_has_two_drivers(bare):
    assert "A drives 7 h 30 min until 13:30; no break" in rows(timed(bare, {}))
    days = tuple(DriverDay(RESTED, 0.0, legs) for legs in ((0, 1, 3), (2,)))
    plan = timed(bare, {2: [(("change",), 5 * MIN, CAFE)]}, relief=0.5, drivers=days)
    assert (
        "A drives 7 h 30 min until 13:35, its drivers 5 h 38 min and 1 h 53 min; "
        "change of drivers 09:45 to 09:50 at Secchia Ovest (services)"
    ) in rows(plan)
    assert any(line.endswith("/EC; a follower's clock slows by 50%.") for line in rows(plan))


def test_rest_before_leaving_is_told_of_who_drove_before(bare):
    half = {2: [(("second_part",), 30 * MIN, CAFE)]}
    drove = DriverState(driven_since_break_s=5400, driven_today_s=5400)
    told = rows(timed(bare, half, drivers=(DriverDay(drove, -15 * MIN),)))
    assert any(
        "until 14:00; at rest 05:45 to 06:00 before it leaves; second" in one for one in told
    )
    for driver in (DriverDay(drove, -10.0), DriverDay(RESTED, -15 * MIN)):
        assert "at rest" not in timed(bare, half, drivers=(driver,)).summary()


def test_without_rules_nothing_is_said_of_them(bare):
    text = timed(bare, {2: [((), 10 * MIN, None)]}, rules="").summary()
    assert "drives" not in text
    assert "Driving rules" not in text
    assert "rests" not in text
    assert "10 min" in text
    # A ban needs no rules.
    text = timed(bare, {2: [(("ban",), 10 * MIN, CAFE)]}, rules="").summary()
    assert "A drives 7 h 30 min until 13:40; driving ban 09:45 to 09:55 at Secchia Ovest" in text
    assert "no break" not in text


def test_many_pauses_are_counted(bare):
    stands = {2: [(("break",), 45 * MIN, CAFE) for _ in range(11)]}
    line = next(line for line in rows(timed(bare, stands)) if line.startswith("A drives"))
    assert line.count("break ") == 8
    assert line.endswith("; 3 more pauses")


def test_names_of_places_cannot_break_a_line(bare):
    place = PausePlace("a\nb\x1b[31m", "lay\nby", 1.0, 2.0)
    line = next(
        line for line in rows(timed(bare, {1: [(("break",), H, place)]})) if "A drives" in line
    )
    assert "\x1b" not in line


def test_pauses_as_a_frame(bare):
    plan = timed(bare, DAY)
    frame = plan.to_frame("pauses")
    assert frame["vehicle"].tolist() == ["A"] * 4
    assert frame["before_leg"].tolist() == [2, 3, 3, 4]
    assert frame["purpose"].tolist() == ["first_part", "second_part", "company", "daily_rest"]
    assert frame["purposes"].iloc[0] == "first_part, company"
    assert frame["lasts_min"].tolist() == pytest.approx([20, 30, 10, 660])
    assert frame["at_km"].tolist() == pytest.approx([150, 300, 300, 450])
    assert frame["start"].iloc[0] == datetime(2026, 3, 2, 7, 52, 30)
    assert (frame["end"] - frame["start"]).sum() == timedelta(hours=12)
    assert frame["place"].tolist() == ["Secchia Ovest", "", "", "Secchia Ovest"]
    assert frame["place_kind"].tolist() == ["services", "junction", "", "services"]
    assert frame["beside_km"].iloc[0] == pytest.approx(0.15)
    assert frame["capacity"].iloc[3] == 60
    none = timed(bare, {}).to_frame("pauses")
    assert len(none) == 0
    assert list(none.columns) == list(frame.columns)


def test_pauses_in_the_timetable(bare):
    frame = timed(bare, DAY).to_frame("timetable")
    assert frame["wait_before_min"].tolist() == pytest.approx([0, 20, 40, 660])
    assert frame["pause_purposes"].tolist() == [
        "", "first_part, company", "second_part, company", "daily_rest",
    ]  # fmt: skip
    assert frame["pause_place"].tolist() == [
        "", "Secchia Ovest (services)", "junction, no parking known", "Secchia Ovest (services)",
    ]  # fmt: skip


@settings(max_examples=60)
@given(
    st.lists(
        st.tuples(st.integers(0, 3), st.sampled_from([(), *((one,) for one in PURPOSES)]),
                  st.integers(0, 900)),
        max_size=8,
    )
)  # fmt: skip
def test_stands_are_the_gaps(drawn):
    at, legs, pauses, ruled = 0.0, [], [], 0.0
    for leg in range(4):
        for _, purposes, lasts in (one for one in drawn if one[0] == leg):
            if purposes:
                pauses.append(Pause(leg, purposes, at, at + lasts))
            ruled += lasts if purposes and purposes[0] not in ("company", "ban") else 0
            at += lasts
        legs.append((at, at + 100.0))
        at += 100.0
    times = VehicleTimes("A", 0.0, tuple(legs), pauses=tuple(pauses))
    stands = standing(times)
    assert rested_s(times) == pytest.approx(ruled)
    assert rested_s(times) + waited_s(times) == pytest.approx(at - 400)
    assert waited_s(times) + rested_s(times) == pytest.approx(times.waiting_s)
    ends = [0.0, *(end for _, end in legs)]
    for one in stands:
        assert one.duration_s > LATE_S
        assert ends[one.before] <= one.start_s <= one.end_s <= legs[one.before][0]
    assert all(a.end_s <= b.start_s for a, b in pairwise(stands))


def test_who_cannot_be_within_the_law(bare, capsys):
    plan = timed(bare, {})
    end_if_unmet([plan])
    remark = f"{NOT_LAWFUL}: A would have to rest for 9 h before it leaves; leave it more time"
    beyond = replace(plan, remarks=(*plan.remarks, remark, "another"))
    with pytest.raises(click.exceptions.Exit) as left:
        end_if_unmet([plan, beyond, beyond])
    assert left.value.exit_code == UNMET
    assert capsys.readouterr().err == f"platoon-osm: {remark}\n"
    lines = rows(beyond)
    assert lines.index(f"{remark}.") < next(
        k for k, line in enumerate(lines) if line.startswith("vehicle")
    )
    assert sum(remark in line for line in lines) == 1
    assert "Note: another" in lines
