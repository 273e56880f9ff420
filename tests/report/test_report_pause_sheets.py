"""Breaks, rests, bans and changes of drivers on drivers' sheets and in their calendars."""

from __future__ import annotations

import html
import re
from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from hostile_names import HOSTILE
from icalendar import Calendar
from paused_plans import day_with_breaks, night
from printed_sheets import FAULTS, PAGES

import platoon_osm as po
from platoon_osm.driving.state import DriverState
from platoon_osm.plans.pauses import DriverDay
from platoon_osm.plans.plan import Plan
from platoon_osm.report.document.findings import find
from platoon_osm.report.language.speech import speaking
from platoon_osm.report.sheets.steps import Step, driver_at, steps_of
from platoon_osm.report.sheets.words import StepWords, Teller

Visit = Callable[..., Any]
MADE = {"day": day_with_breaks, "night": night}


def told(plan: Plan, net: Any, index: int, language: str = "en") -> list[tuple[Step, StepWords]]:
    with speaking(language):
        found = find(plan, net)
        steps = steps_of(found.plan, found.net, index)
        teller = Teller(found, index)
        return [(step, teller.words(step, number)) for number, step in enumerate(steps)]


def texts(path: Path) -> list[str]:
    """What a browser shows of each sheet, without drawings."""
    sheets = path.read_text("utf-8").split('<section class="sheet ')[1:]
    bare = (re.sub(r"<svg.*?</svg>", "", one, flags=re.DOTALL) for one in sheets)
    return [html.unescape(re.sub(r"<[^>]+>|\s+", " ", one)) for one in bare]


@pytest.mark.parametrize("language", ["en", "de", "it"])
@pytest.mark.parametrize("name", MADE)
def test_a_sheet_with_pauses_is_one_page(
    name: str, language: str, visit: Visit, tmp_path: Path
) -> None:
    plan, net = MADE[name]()
    path = tmp_path / "sheets.html"
    po.write_sheets(plan, net, path, language=language)
    opened = visit(path, width=1000, wait_for=None)
    opened.page.emulate_media(media="print")
    assert opened.page.evaluate(FAULTS) == []
    assert len(re.findall(PAGES, opened.page.pdf(prefer_css_page_size=True))) == 3
    # Every icon that is used is there, so nothing is told by colour alone.
    used = opened.page.evaluate(
        "[...document.querySelectorAll('use')].map((one) => one.getAttribute('href'))"
    )
    assert all(opened.page.locator(href).count() == 1 for href in set(used))
    assert {"#icon-break", "#icon-ban"} <= set(used) or {"#icon-rest", "#icon-change"} <= set(used)
    opened.check(path)


def test_a_day_reads_as_it_is_driven() -> None:
    plan, net = day_with_breaks()
    said = [words for step, words in told(plan, net, 0) if step.is_pause]
    assert [(one.kind, one.time, one.until, one.what, one.place, one.wait) for one in said] == [
        (
            "break", "10:16", "11:01", "Break, 45 min, with B.", "Secchia Ovest",
            "Leave at 11:01. It is 1.2 km beside the road. 40 spaces for trucks. "
            "Others are waited for meanwhile.",
        ),
        (
            "break", "12:17", "12:32", "Break, 15 min.", "rest area",
            "Leave at 12:32. It is 1.2 km beside the road. Counts as the first part of the break.",
        ),
        (
            "break", "13:06", "13:36", "Break, 30 min.", "Uscita 7",
            "Leave at 13:36. No parking is known here. Counts as the second part of the break.",
        ),
        (
            "ban", "14:09", "15:39", "Driving ban, 1 h 30 min.", "A4 near Udine",
            "Leave at 15:39. No parking is known here.",
        ),
    ]  # fmt: skip
    # The sums of the steps are those of the plan.
    assert plan.timetable is not None
    for index, times in enumerate(plan.timetable.vehicles):
        steps = [step for step, _ in told(plan, net, index)]
        assert sum(halt.lasts_s for step in steps for halt in step.halts) == pytest.approx(
            times.waiting_s, abs=31 * len(steps)
        )
        driven = sum(step.way.drive_s for step in steps if step.way)
        assert driven == pytest.approx(plan.vehicles[index].time_s)
        assert all(step.wait_s == 0 for step in steps)


def test_a_rest_over_midnight_has_dates_and_a_change_says_whose_turn_it_is() -> None:
    plan, net = night()
    said = [words for _, words in told(plan, net, 0)]
    assert said[0].what == "Depart. Driver 1 drives."
    (change,) = (one for one in said if one.kind == "change")
    assert change.what == "Change of drivers, 5 min, with B. Driver 2 drives."
    (rest,) = (one for one in said if one.kind == "rest")
    assert (rest.time, rest.what) == ("23:06", "Daily rest, 11 h 00 min.")
    assert rest.wait == (
        "Leave at 10:06 +1 d. From Mon, 2 Mar 2026, 23:06 to Tue, 3 Mar 2026, 10:06."
    )
    # Where the plan does not say who drives which leg, each change is a turn.
    assert plan.timetable is not None
    times = plan.timetable.vehicles[0]
    legs = range(len(times.legs))
    turns = [driver_at(times, leg) for leg in legs]
    both = replace(times, drivers=(DriverDay(DriverState(drivers=2), 0.0),))
    assert [driver_at(both, leg) for leg in legs] == turns
    one = replace(times, drivers=(DriverDay(DriverState(), 0.0),))
    assert {driver_at(one, leg) for leg in legs} == {None}


def test_where_a_meeting_is_a_break_too_both_are_told() -> None:
    plan, net = day_with_breaks()
    assert plan.timetable is not None
    # The break is where B joins: move it to before the leg that B's first with A is.
    first, *others = plan.timetable.vehicles
    at = next(
        k for k, stretch in enumerate(plan.ways[0]) if len(plan.stretches[stretch].company) > 1
    )
    pause = replace(first.pauses[0], before=at)
    begin = first.legs[at][0]
    moved = tuple((b, e) if k < at else (b + 3600, e + 3600) for k, (b, e) in enumerate(first.legs))
    pause = replace(pause, start_s=begin + 900, end_s=begin + 3600, purposes=("break",))
    table = replace(plan.timetable, vehicles=(replace(first, legs=moved, pauses=(pause,)), *others))
    said = [one for one in told(replace(plan, timetable=table), net, 0) if one[0].pauses]
    ((step, words),) = said
    assert words.kind == "merge"
    assert words.what == "Meet C, who joins here."
    assert step.wait_s == pytest.approx(900)
    assert words.wait == (
        "Wait 15 min, from 07:37 to 07:52. Break, 45 min. At Secchia Ovest. "
        "From 07:52 to 08:37. It is 1.2 km beside the road. 40 spaces for trucks."
    )
    assert words.time == "08:37"


def test_the_laws_clocks_are_told_and_no_break_is_said_to_be_missing(tmp_path: Path) -> None:
    plan, net = day_with_breaks()
    path = tmp_path / "sheets.html"
    po.write_sheets(plan, net, path)
    first = texts(path)[0]
    assert "By Regulation (EC) 561/2006 and Directive 2002/15/EC:" in first
    # 06:04 to 10:16 without a break; 6 h 57 of driving, 45 + 15 + 30 of breaks, 90 of a ban.
    assert "at most 4 h 12 min without a break (4 h 30 min allowed)" in first
    assert "at most 9 h 57 min from rest to rest (13 h 00 min allowed)" in first
    assert "6 h 57 min of driving in all" in first
    assert "1 h 30 min of breaks" in first
    assert "No breaks are planned" not in first
    assert plan.timetable is not None
    for language, words in (
        ("de", ("Pause, 45 min, mit B.", "Hier ist kein Parkplatz bekannt.", "Weiterfahrt um")),
        ("it", ("Pausa, 45 min, con B.", "non è noto alcun parcheggio", "Ripartire alle")),
    ):
        po.write_sheets(plan, net, path, language=language)
        text = texts(path)[0]
        assert all(word in text for word in words)
        for english in ("Leave", "Break", "Driving", "Counts", "driver", "known here"):
            assert english not in text


def test_who_goes_on_alone_takes_the_breaks_too() -> None:
    plan, net = day_with_breaks()
    assert plan.timetable is not None
    table = plan.timetable
    latest = tuple(replace(one, latest_arrival_s=one.arrival_s + 1200) for one in table.vehicles)
    plan = replace(plan, timetable=replace(table, vehicles=latest))
    times = latest[0]
    met = [step for step, _ in told(plan, net, 0) if step.without is not None]
    assert met
    for step in met:
        going = step.without
        assert going is not None
        # Twenty minutes late at the ban, which waits for longer than that: in time all the same.
        assert going.until_s is not None
        late = going.until_s - (step.leaves_s or 0)
        # The ban ends at one moment, so of its 90 minutes all can be lost without being late.
        assert late == pytest.approx(1200 + 5400)
        assert going.arrives_s == pytest.approx(times.latest_arrival_s)


def events_of(path: Path) -> list[Any]:
    return list(Calendar.from_ical(path.read_bytes()).walk("VEVENT"))


@pytest.mark.parametrize("name", MADE)
def test_a_calendar_has_every_pause_with_its_place(name: str, tmp_path: Path) -> None:
    plan, net = MADE[name]()
    assert plan.timetable is not None
    clock = plan.timetable.clock
    written = [one for one in po.write_sheets(plan, net, tmp_path) if one.suffix == ".ics"]
    for path, times in zip(written, plan.timetable.vehicles, strict=True):
        events = events_of(path)
        begins = [event.decoded("dtstart") for event in events]
        assert begins == sorted(begins)
        assert len({str(event["uid"]) for event in events}) == len(events)
        spans = [event for event in events if "dtend" in event]
        for event, pause in zip(spans, times.pauses, strict=True):
            assert abs(event.decoded("dtstart") - clock.moment(pause.start_s)) <= timedelta(
                seconds=1
            )
            assert abs(event.decoded("dtend") - clock.moment(pause.end_s)) <= timedelta(seconds=1)
            if pause.place is not None:
                assert str(event["location"]) == (pause.place.name or "rest area")
                assert event["geo"].latitude == pytest.approx(pause.place.lat, abs=1e-6)
    first = [event for event in events_of(written[0]) if "dtend" in event]
    expected = "A: Break, 45 min" if name == "day" else "A: Change of drivers, 5 min"
    assert str(first[0]["summary"]) == expected


@pytest.mark.parametrize("start", range(0, len(HOSTILE), 24))
def test_hostile_places_stay_names(start: int, visit: Visit, tmp_path: Path) -> None:
    def spoiled(name: str) -> str:
        return name + HOSTILE[(start + len(name)) % len(HOSTILE)]

    plan, net = day_with_breaks(spoiled)
    path = tmp_path / "sheets.html"
    po.write_sheets(plan, net, path)
    opened = visit(path, width=1000, wait_for=None)
    opened.page.emulate_media(media="print")
    assert opened.page.evaluate("window.hacked") is None
    assert opened.page.evaluate(FAULTS) == []
    opened.check(path)
    for file in po.write_sheets(plan, net, tmp_path / "folder"):
        if file.suffix == ".ics":
            assert len(events_of(file)) >= 4
