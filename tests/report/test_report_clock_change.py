"""Nights of a clock change in pages, charts and files."""

from __future__ import annotations

import csv
import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any
from zoneinfo import ZoneInfo

import pytest

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.timing.schedule import with_times
from platoon_osm.plans.plan import JointPlan
from platoon_osm.plans.trip import Trip
from platoon_osm.plans.zones import clock_of
from platoon_osm.report import report_document, write_csv, write_figures, write_gpx, write_html
from platoon_osm.report.document.document import document_of
from platoon_osm.report.drawing.ticks import hour_ticks
from platoon_osm.report.markup.fragments import asset

Visit = Callable[..., Any]
ROME, ANGELES = ZoneInfo("Europe/Rome"), ZoneInfo("America/Los_Angeles")
NIGHTS = [
    datetime(2026, 3, 28, 22, tzinfo=ROME), datetime(2026, 10, 24, 22, tzinfo=ROME),
    datetime(2026, 3, 7, 22, tzinfo=ANGELES), datetime(2026, 10, 31, 22, tzinfo=ANGELES),
]  # fmt: skip
IDS = [f"{night:%Y-%m-%d}" for night in NIGHTS]
HOUR = 3600


def later(first: datetime, hours: float) -> datetime:
    return (first.astimezone(UTC) + timedelta(hours=hours)).astimezone(first.tzinfo)


def night(plan: JointPlan, first: datetime) -> JointPlan:
    trips = [
        Trip(vehicle.vehicle, 0, 1, later(first, 2 + k)) for k, vehicle in enumerate(plan.vehicles)
    ]
    return with_times(plan, trips)


@pytest.mark.parametrize("first", NIGHTS, ids=IDS)
@pytest.mark.parametrize("length", [5, 20, 90])
def test_ticks_are_whole_hours_of_the_clocks_that_hold(first: datetime, length: int) -> None:
    clock = clock_of(first, 0, [0, length * HOUR])
    ticks = hour_ticks(clock, 0, length * HOUR)
    moments = [moment for moment, _ in ticks]
    assert moments == sorted(set(moments))
    assert 2 <= len(ticks) <= 9
    for moment, text in ticks:
        shown = clock.moment(moment)
        assert shown.minute == 0
        assert text.startswith(f"{shown:%H:%M}")
    if length == 5:
        # Every hour that passes, that which comes twice too, and none that does not come.
        assert len(ticks) == 6


@pytest.mark.parametrize("first", NIGHTS, ids=IDS)
def test_files_say_when_it_is(
    plan: JointPlan, net: RoadNetwork, first: datetime, tmp_path: Path
) -> None:
    day = night(plan, first)
    table = day.timetable
    assert table is not None
    assert len(table.offsets) == 2
    write_csv(day, net, tmp_path / "legs.csv")
    with (tmp_path / "legs.csv").open(encoding="utf-8") as handle:
        rows = [row for row in csv.DictReader(handle) if row["start_time"]]
    offsets = set()
    for row in rows:
        for name in ("start_time", "end_time"):
            moment = datetime.fromisoformat(row[name])
            assert moment.utcoffset() == moment.astimezone(first.tzinfo).utcoffset()
            offsets.add(moment.utcoffset())
    assert len(offsets) == 2
    (tmp_path / "figures").mkdir()
    written = write_figures(day, net, tmp_path / "figures", formats=("svg",))
    (times,) = [path for path in written if path.name == "schedule.csv"]
    with times.open(encoding="utf-8") as handle:
        for row in csv.DictReader(handle):
            begin, end = (datetime.fromisoformat(row[name]) for name in ("begin", "end"))
            # Spans are differences of seconds, whatever clocks show.
            passed = float(row["end_s"]) - float(row["begin_s"])
            assert (end - begin).total_seconds() == pytest.approx(passed, abs=1)
            assert end.utcoffset() == end.astimezone(first.tzinfo).utcoffset()
    (tmp_path / "gpx").mkdir()
    for track in write_gpx(day, net, tmp_path / "gpx"):
        stamps = [
            datetime.fromisoformat(str(found.text))
            for found in ElementTree.parse(track).iter("{http://www.topografix.com/GPX/1/1}time")
        ]
        assert len(stamps) > 1
        assert all(stamp.utcoffset() == timedelta(0) for stamp in stamps)


@pytest.mark.parametrize("first", NIGHTS, ids=IDS)
def test_the_document_says_it_too(plan: JointPlan, net: RoadNetwork, first: datetime) -> None:
    day = night(plan, first)
    document = report_document(day, net)
    schedule = document["schedule"]
    assert day.timetable is not None
    assert schedule["zone"] == day.timetable.clock.zone
    assert [list(pair) for pair in schedule["offsets"]] == [list(p) for p in day.timetable.offsets]
    for vehicle, times in zip(document["vehicles"], day.timetable.vehicles, strict=True):
        assert vehicle["times"]["text"]["arrival"] == day.timetable.clock.text(times.arrival_s)


@pytest.mark.browser
@pytest.mark.parametrize("first", NIGHTS, ids=IDS)
def test_the_slider_reads_the_same_clock(
    plan: JointPlan, net: RoadNetwork, first: datetime, tmp_path: Path, visit: Visit
) -> None:
    day = night(plan, first)
    clock = day.timetable.clock  # type: ignore[union-attr]
    path = tmp_path / "night.html"
    write_html(day, net, path)
    page = visit(path).page
    moments = [*range(-3 * HOUR, 30 * HOUR, 613), 3599.9, 3570, 7169.96]
    schedule = report_document(day, net)["schedule"]
    script = f"(([schedule, moments]) => {{ {asset('clock.js')}\n" + (
        "const { text } = dayByClock({ schedule, vehicles: [] }); return moments.map(text); })"
    )
    found = page.evaluate(script, [json.loads(json.dumps(schedule)), moments])
    assert found == [clock.text(moment) for moment in moments]
    assert clock.zone in page.content()


@pytest.mark.parametrize("first", NIGHTS, ids=IDS)
def test_a_chart_names_the_offset_by_which_its_times_are_told(
    plan: JointPlan, net: RoadNetwork, first: datetime
) -> None:
    schedule = document_of(night(plan, first), net).schedule
    assert schedule is not None
    change = schedule.offsets[1][0]
    before, after = (first.tzinfo.utcoffset(later(first, k)) for k in (0, 24))  # type: ignore[union-attr]
    assert before != after

    def named(offset: timedelta | None) -> str:
        hours = int((offset or timedelta()).total_seconds() // 3600)
        return f"UTC{hours:+03d}:00"

    name = schedule.zone_name
    assert schedule.zone_of(change - 7200, change - 60) == f"{name} ({named(before)})"
    assert schedule.zone_of(change + 60, change + 7200) == f"{name} ({named(after)})"
    assert schedule.zone_of(change - 60, change + 60) == schedule.zone
    assert named(before) in schedule.zone
    assert named(after) in schedule.zone
