"""Drivers' sheets: a page of A4 each, true to the plan; calendars that other programs read."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hostile_names import HOSTILE
from icalendar import Calendar
from plan_kinds import SIX, hours, plan_kind, timed
from po_valley import THREE, make_plan, po_valley
from printed_sheets import FAULTS, PAGES
from soak import chosen, soaked

import platoon_osm as po
from platoon_osm.planning.timing.schedule import with_times
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.timetable import Timetable
from platoon_osm.plans.trip import Trip
from platoon_osm.report.document.findings import find
from platoon_osm.report.sheets.going_on import GoingOn
from platoon_osm.report.sheets.steps import Step, steps_of

Visit = Callable[..., Any]

KINDS = (
    "one vehicle", "three vehicles", "eight vehicles", "one platoon of fifty", "without times",
    "all are late", "over several days", "all start together", "all end together",
    "beside the road", "a tall country", "long names", "names without a break",
    "names in other scripts", "the same trip thrice",
)  # fmt: skip
USUAL = (
    "one vehicle", "three vehicles", "without times", "all end together", "beside the road",
    "long names", "names without a break", "names in other scripts", "the same trip thrice",
)  # fmt: skip


def all_steps(plan: Plan, net: Any, patience_s: float | None = None) -> list[tuple[Step, ...]]:
    found = find(plan, net)
    return [steps_of(found.plan, found.net, k, patience_s) for k in range(len(plan.trips))]


@soaked
@pytest.mark.parametrize("name", chosen(USUAL, KINDS))
def test_each_sheet_is_one_page_of_which_nothing_is_cut(
    name: str, visit: Visit, tmp_path: Path
) -> None:
    plan, net = plan_kind(name)
    path = tmp_path / "sheets.html"
    po.write_sheets(plan, net, path)
    opened = visit(path, width=1000, wait_for=None)
    opened.page.emulate_media(media="print")
    assert opened.page.evaluate(FAULTS) == []
    pages = re.findall(PAGES, opened.page.pdf(prefer_css_page_size=True))
    assert len(pages) == len(plan.vehicles)
    opened.check(path)


def test_fifty_vehicles_are_fifty_pages(visit: Visit, tmp_path: Path) -> None:
    plan, net = plan_kind("fifty vehicles")
    path = tmp_path / "sheets.html"
    po.write_sheets(plan, net, path, language="de")
    opened = visit(path, width=1000, wait_for=None)
    opened.page.emulate_media(media="print")
    assert opened.page.evaluate(FAULTS) == []
    assert len(re.findall(PAGES, opened.page.pdf(prefer_css_page_size=True))) == 50
    assert path.stat().st_size < 1_200_000


@pytest.mark.parametrize("width", [390, 900])
def test_on_a_screen_no_sheet_is_wider_than_it(width: int, visit: Visit, tmp_path: Path) -> None:
    plan, net = plan_kind("long names")
    path = tmp_path / "sheets.html"
    po.write_sheets(plan, net, path)
    page = visit(path, width=width, wait_for=None).page
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.get_by_role("link").count() == 3


@pytest.mark.parametrize(
    "name", ["three vehicles", "eight vehicles", "opposite directions", "beside the road"]
)
def test_steps_are_those_of_the_plan(name: str) -> None:
    plan, net = plan_kind(name)
    for index, steps in enumerate(all_steps(plan, net)):
        own, times = plan.vehicles[index], plan.times[index]
        assert steps[0].place == plan.trips[index].origin
        assert steps[-1].place.name == plan.trips[index].destination.name
        assert steps[-1].at_m == pytest.approx(own.length_m)
        assert sum(step.way.drive_s for step in steps if step.way) == pytest.approx(own.time_s)
        for step, after in pairwise(steps):
            assert step.way is not None
            assert after.at_m - step.at_m == pytest.approx(step.way.length_m)
            # Who drives there is who joined and has not left.
            assert index in step.way.order
            if after.way is not None:
                gone = set(step.way.order) - set(after.left) | set(after.joined)
                assert gone == set(after.way.order)
        met = sum(step.way.length_m for step in steps if step.way and step.way.together)
        assert met == pytest.approx(own.platoon_m)
        if times is not None:
            waited = sum(step.wait_s for step in steps)
            assert waited == pytest.approx(times.waiting_s, abs=60 * len(steps))
            assert steps[-1].reached_s == times.arrival_s


def test_the_order_of_driving_is_that_of_the_stretch() -> None:
    plan, net = plan_kind("three vehicles")
    orders = {one.vehicles for one in plan.stretches if one.together}
    told = {
        step.way.order
        for steps in all_steps(plan, net)
        for step in steps
        if step.way and step.way.together
    }
    assert told == orders


def test_who_waits_is_told_how_long_and_who_is_waited_for_when_to_be_there(tmp_path: Path) -> None:
    plan, net = waiting()
    path = tmp_path / "sheets.html"
    po.write_sheets(plan, net, path)
    sheets = path.read_text("utf-8").split('<section class="sheet ')[1:]
    for steps, text in zip(all_steps(plan, net), sheets, strict=True):
        assert text.count("<span>Wait ") == sum(step.wait_s > 0 for step in steps)
        expected = sum(step.waited_for and not step.wait_s for step in steps)
        assert text.count("You are expected: be there by") == expected
    assert any(step.waited_for for steps in all_steps(plan, net) for step in steps)


def goings(plan: Plan, net: Any, patience_s: float | None = None) -> list[tuple[Step, GoingOn]]:
    return [
        (step, step.without)
        for steps in all_steps(plan, net, patience_s)
        for step in steps
        if step.without is not None
    ]


def test_who_does_not_come_is_waited_for_as_long_as_that_is_in_time() -> None:
    plan, net = plan_kind("three vehicles")
    found = goings(plan, net)
    assert found
    for step, going in found:
        assert step.leaves_s is not None
        assert going.until_s is not None
        assert going.until_s >= step.leaves_s
        assert not going.by_patience
        assert going.arrives_s in {
            times.latest_arrival_s for times in plan.times if times is not None
        }
        assert going.arrives_s == pytest.approx(going.until_s + going.drive_s)
    patient = goings(plan, net, 600.0)
    assert [going.until_s for _, going in patient] == [
        pytest.approx((step.leaves_s or 0) + 600) for step, _ in patient
    ]


def test_no_moment_is_made_up() -> None:
    for name in ("without times", "two vehicles"):
        for _, going in goings(*plan_kind(name)):
            assert going.until_s is None


def test_a_saved_plan_knows_the_patience_it_was_planned_with(tmp_path: Path) -> None:
    made, net = plan_kind("without times")
    trips = [Trip(one.vehicle, 0, 1, SIX) for one in made.trips]
    plan = with_times(made, trips, hours(2).total_seconds())
    found = goings(plan, net)
    assert found
    for index, steps in enumerate(all_steps(plan, net)):
        latest = plan.trips[index].alone.time_s + 7200
        for step in steps:
            if step.without is not None:
                assert step.without.by_patience
                assert step.without.until_s == pytest.approx(latest - step.without.drive_s)
                assert step.without.arrives_s == pytest.approx(latest)
    # What the caller says counts if it is less.
    short = [going.until_s for _, going in goings(plan, net, 60.0)]
    assert short == [pytest.approx((step.leaves_s or 0) + 60) for step, _ in found]
    again = Plan.from_dict(json.loads(json.dumps(plan.to_dict())))
    assert again == plan
    one, other = (
        po.write_sheets(which, net, tmp_path / name)
        for which, name in ((plan, "fresh"), (again, "saved"))
    )
    for a, b in zip(one, other, strict=True):
        assert a.read_bytes() == b.read_bytes()
    assert "Ask how long to wait" not in one[0].read_text("utf-8")
    # Who may be moved for ever is told to ask, and a patience that cannot be is refused.
    for patience_s in (None, 1e300):
        for _, going in goings(with_times(made, trips, patience_s), net):
            assert going.until_s is None
    assert plan.timetable is not None
    with pytest.raises(po.ScenarioError, match="patience_s"):
        replace(plan.timetable, patience_s=-1.0)


def test_who_is_late_is_told_first(tmp_path: Path) -> None:
    plan, net = plan_kind("one is late")
    path = tmp_path / "sheets.html"
    po.write_sheets(plan, net, path)
    sheets = path.read_text("utf-8").split('<section class="sheet ')[1:]
    late = [times is not None and times.late_s > 0 for times in plan.times]
    assert any(late)
    assert [">Late: by this plan" in one.split('<dl class="facts">')[0] for one in sheets] == late


def test_without_times_there_is_no_clock(tmp_path: Path) -> None:
    plan, net = plan_kind("without times")
    written = po.write_sheets(plan, net, tmp_path)
    assert [path.name for path in written] == ["a.html", "b.html", "c.html"]
    for path in written:
        text = re.sub(
            r"<style>.*?</style>|<svg.*?</svg>", "", path.read_text("utf-8"), flags=re.DOTALL
        )
        assert not re.search(r"\b\d\d:\d\d\b", text)


def test_languages_and_clocks(tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    for language, word in (("en", "Departure"), ("de", "Abfahrt"), ("it", "Partenza")):
        (path,) = po.write_sheets(plan, net, tmp_path / f"{language}.html", language=language)
        text = path.read_text("utf-8")
        assert f"<dt>{word}</dt>" in text
        assert f'<html lang="{language}"' in text
    (path,) = po.write_sheets(plan, net, tmp_path / "us.html", language="en", clock=12)
    assert "pm" in path.read_text("utf-8")


def test_same_plan_same_bytes(tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    one, other = tmp_path / "one", tmp_path / "other"
    made = [po.write_sheets(plan, net, folder) for folder in (one, other)]
    assert [path.name for path in made[0]] == [
        f"{name}.{suffix}" for name in "abc" for suffix in ("html", "ics")
    ]
    for a, b in zip(*made, strict=True):
        assert a.read_bytes() == b.read_bytes()


def hostile(some: list[str]) -> tuple[Plan, Any]:
    """A plan in which every name of a place, a road or a vehicle is hostile."""
    net = po_valley(lambda name: name + some[len(name) % len(some)])
    plan = timed(make_plan(net, THREE, lambda name: name + some[len(name) % len(some)]))
    return plan, net


def test_hostile_names_stay_names(visit: Visit, tmp_path: Path) -> None:
    for begin in range(0, len(HOSTILE), 24):
        plan, net = hostile(HOSTILE[begin : begin + 24])
        path = tmp_path / f"{begin}.html"
        po.write_sheets(plan, net, path)
        opened = visit(path, width=1000, wait_for=None)
        opened.page.emulate_media(media="print")
        assert opened.page.evaluate("window.hacked") is None
        assert opened.page.evaluate(FAULTS) == []
        opened.check(path)
        for file in po.write_sheets(plan, net, tmp_path / str(begin)):
            if file.suffix == ".ics":
                read_back(file)


# -- calendars -------------------------------------------------------------------------------------


def read_back(path: Path) -> list[Any]:
    """Events of a calendar, after a look at what the standard asks of its lines."""
    data = path.read_bytes()
    lines = data.split(b"\r\n")
    assert lines[-1] == b""
    assert all(b"\n" not in line and b"\r" not in line and len(line) <= 75 for line in lines)
    (calendar,) = Calendar.from_ical(data, multiple=True)
    events = calendar.walk("VEVENT")
    assert not calendar.errors
    assert len({str(event["uid"]) for event in events}) == len(events)
    return list(events)


def zoned(plan: Plan, zone: str) -> Plan:
    assert plan.timetable is not None
    table: Timetable = plan.timetable
    return replace(plan, timetable=replace(table, start=f"{table.start}{zone}"))


def waiting() -> tuple[Plan, Any]:
    """All leave at six, whatever the others do, and so wait on the road."""
    plan, net = plan_kind("without times")
    trips = [Trip(one.vehicle, 0, 1, SIX, SIX, SIX + hours(16)) for one in plan.trips]
    return with_times(plan, trips), net


def test_a_calendar_has_the_moments_of_the_plan(tmp_path: Path) -> None:
    plan, net = waiting()
    for zone in ("", "+01:00"):
        made = zoned(plan, zone)
        written = [
            path
            for path in po.write_sheets(made, net, tmp_path / f"z{zone[:1]}")
            if path.suffix == ".ics"
        ]
        waits = 0
        for path, times, trip in zip(written, made.times, made.trips, strict=True):
            assert times is not None
            assert made.timetable is not None
            clock = made.timetable.clock
            events = read_back(path)
            begins = [event.decoded("dtstart") for event in events]
            for at, moment in ((begins[0], times.departure_s), (begins[-1], times.arrival_s)):
                expected = clock.moment(round(moment))
                assert at == (expected.astimezone(UTC) if zone else expected)
                assert (at.tzinfo is None) == (not zone)
            assert begins == sorted(begins)
            assert str(events[0]["location"]) == trip.origin.name
            assert events[0]["geo"].latitude == pytest.approx(trip.origin.lat, abs=1e-6)
            spans = [event for event in events if "dtend" in event]
            waits += len(spans)
            assert sum(
                (event.decoded("dtend") - event.decoded("dtstart")).total_seconds()
                for event in spans
            ) == pytest.approx(times.waiting_s, abs=2 * len(spans))
        assert waits


def test_an_event_is_known_again_when_the_plan_is_made_anew(tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    assert plan.timetable is not None
    later = replace(plan.timetable, start=f"{datetime(2026, 3, 2, 7, 4):%Y-%m-%dT%H:%M:%S}")
    made = [
        [
            str(event["uid"])
            for path in po.write_sheets(one, net, tmp_path / name)
            if path.suffix == ".ics"
            for event in read_back(path)
        ]
        for name, one in (("now", plan), ("later", replace(plan, timetable=later)))
    ]
    assert made[0] == made[1]
    assert len(set(made[0])) == len(made[0])


def test_the_command_writes_both(tmp_path: Path) -> None:
    from platoon_osm.report.exporters import EXPORTERS

    plan, net = plan_kind("three vehicles")
    EXPORTERS["sheets"].write(plan, net, tmp_path / "all.html", title="Monday")
    assert "<title>Drivers&#x27; sheets: Monday</title>" in (tmp_path / "all.html").read_text(
        "utf-8"
    )
    EXPORTERS["drivers"].write(plan, net, tmp_path, title=None)
    assert (tmp_path / "c.ics").exists()
