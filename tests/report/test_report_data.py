"""Files that the page of a plan makes by itself: they say what the exports of Python say."""

from __future__ import annotations

import csv
import io
import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from dataclasses import replace
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

import geopandas
import pytest
from hostile_names import HOSTILE
from icalendar import Calendar
from paused_plans import day_with_breaks, night
from plan_kinds import plan_kind, timed
from po_valley import THREE, make_plan, po_valley
from shapely import hausdorff_distance

import platoon_osm as po
from platoon_osm.csv_tables import safe_cell
from platoon_osm.planning.timing.schedule import with_times
from platoon_osm.plans.plan import Plan
from platoon_osm.report.exports.file_names import file_stems

Visit = Callable[..., Any]

SECOND = timedelta(seconds=1)

GPX = "{http://www.topografix.com/GPX/1/1}"

TEXTS = (
    "vehicle", "vehicle_role", "leg", "role", "origin", "destination", "roads", "cost_unit",
)  # fmt: skip
NUMBERS = ("length_m", "time_s", "fuel_l", "cost", "inferred_m")


def zoned(plan: Plan) -> Plan:
    """The same plan, by clocks that go an hour ahead of UTC."""
    assert plan.timetable is not None
    table = replace(plan.timetable, start=f"{plan.timetable.start}+01:00")
    return replace(plan, timetable=table)


def saved(opened: Any, kind: str, vehicle: int | None = None) -> tuple[str, bytes]:
    """Press a button; return the name of the file and what it holds."""
    page = opened.page
    page.select_option("#data-of", "" if vehicle is None else str(vehicle))
    with page.expect_download() as waiting:
        page.click(f"[data-file='{kind}']")
    download = waiting.value
    assert download.suggested_filename in page.inner_text(".data [role='status']")
    return download.suggested_filename, Path(download.path()).read_bytes()


@pytest.fixture
def shown_plan(visit: Visit, tmp_path: Path) -> Callable[[Plan, Any], Any]:
    def shown(plan: Plan, net: Any, **options: Any) -> Any:
        path = tmp_path / "page.html"
        po.write_html(plan, net, path, title="Torino: Monday")
        opened = visit(path, accept_downloads=True, **options)
        opened.path = path
        return opened

    return shown


def compared(plan: Plan, net: Any, opened: Any, folder: Path) -> None:
    """Compare what the page saves with the exports of Python, leg by leg."""
    frame = po.to_geodataframe(plan, net)
    name, data = saved(opened, "geojson")
    assert name == "torino-monday.geojson"
    found = geopandas.GeoDataFrame.from_features(json.loads(data)["features"])
    assert len(found) == len(frame)
    assert list(found.columns.drop("geometry")) == list(frame.columns.drop("geometry"))
    for column in TEXTS:
        assert list(found[column]) == list(frame[column]), column
    for column in NUMBERS:
        assert list(found[column]) == pytest.approx(list(frame[column]), rel=1e-5, abs=0.06), column
    # The page names besides who made the towns and the ground that it draws.
    pairs = zip(found["attribution"], frame["attribution"], strict=True)
    assert all(ours.startswith(theirs) and theirs for ours, theirs in pairs)
    assert [set(text.split(", ")) for text in found["partners"]] == [
        set(text.split(", ")) for text in frame["partners"]
    ]
    if plan.timetable is not None:
        for column in ("start_time", "end_time"):
            for ours, theirs in zip(found[column], frame[column], strict=True):
                # The document rounds to tenths of a second before a file rounds to seconds.
                moments = [datetime.fromisoformat(str(text)) for text in (ours, theirs)]
                assert abs(moments[0] - moments[1]) <= SECOND
                assert moments[0].utcoffset() == moments[1].utcoffset()
        assert list(found["waiting_s"]) == pytest.approx(list(frame["waiting_s"]), abs=0.21)
        breaks = list(frame["break_before_min"])
        assert list(found["break_before_min"]) == pytest.approx(breaks, abs=0.01)
    for ours, theirs in zip(found.geometry, frame.geometry, strict=True):
        assert hausdorff_distance(ours, theirs) < 1e-4
    po.write_csv(plan, net, folder / "legs.csv")
    name, data = saved(opened, "csv")
    rows, others = (
        list(csv.DictReader(io.StringIO(text)))
        for text in (data.decode(), (folder / "legs.csv").read_text("utf-8"))
    )
    assert list(rows[0]) == list(others[0])
    for row, other in zip(rows, others, strict=True):
        assert [row[column] for column in TEXTS] == [other[column] for column in TEXTS]
        for column in NUMBERS:
            assert float(row[column]) == pytest.approx(float(other[column]), rel=2e-5, abs=0.06)


@pytest.mark.parametrize("name", ["three vehicles", "without times", "beside the road"])
def test_what_the_page_saves_is_what_python_exports(
    name: str, shown_plan: Callable[..., Any], tmp_path: Path
) -> None:
    plan, net = plan_kind(name)
    plan = zoned(plan) if plan.timetable is not None else plan
    opened = shown_plan(plan, net)
    compared(plan, net, opened, tmp_path)
    compare_tracks(plan, net, opened, tmp_path)
    opened.check(opened.path)


@pytest.mark.parametrize("make", [day_with_breaks, night])
def test_legs_know_the_break_before_them(
    make: Callable[[], Any], shown_plan: Callable[..., Any], tmp_path: Path
) -> None:
    plan, net = make()
    opened = shown_plan(plan, net)
    compared(plan, net, opened, tmp_path)
    assert po.to_geodataframe(plan, net)["break_before_min"].sum() > 0


def compare_tracks(plan: Plan, net: Any, opened: Any, folder: Path) -> None:
    (folder / "tracks").mkdir()
    for index, path in enumerate(po.write_gpx(plan, net, folder / "tracks")):
        name, data = saved(opened, "gpx", index)
        assert name == path.name
        ours, theirs = ElementTree.fromstring(data), ElementTree.parse(path).getroot()
        for root in (ours, theirs):
            assert root.get("version") == "1.1"
        for tag in ("trk", "trkseg"):
            assert len(list(ours.iter(GPX + tag))) == len(list(theirs.iter(GPX + tag)))
        credited = theirs.findtext(f"{GPX}metadata/{GPX}desc") or "nobody"
        assert (ours.findtext(f"{GPX}metadata/{GPX}desc") or "").startswith(credited)
        holder = ours.find(f"{GPX}metadata/{GPX}copyright")
        assert holder is not None
        assert (holder.get("author") or "").startswith(credited)
        for a, b in zip(ours.iter(GPX + "trkseg"), theirs.iter(GPX + "trkseg"), strict=True):
            for at in (0, -1):
                one, other = list(a)[at], list(b)[at]
                for axis in ("lat", "lon"):
                    mine, that = (float(point.get(axis) or "nan") for point in (one, other))
                    assert mine == pytest.approx(that, abs=2e-5)
                times = [point.findtext(GPX + "time") for point in (one, other)]
                assert times[0] == times[1] or plan.timetable is not None
                assert (times[0] is None) == (plan.timetable is None)
        places = [point.findtext(f"{GPX}name") for point in ours.iter(GPX + "wpt")]
        assert places[0] == f"Departure: {plan.trips[index].origin.name}"
        own = plan.vehicles[index]
        expected = 2 + (own.merge is not None) + (own.separation is not None)
        assert len(places) >= expected - 1


@pytest.mark.parametrize("kind", ["three vehicles", "fifty vehicles"])
def test_the_document_is_saved_but_for_what_charts_alone_show(
    kind: str, shown_plan: Callable[..., Any]
) -> None:
    plan, net = plan_kind(kind)
    opened = shown_plan(plan, net)
    name, data = saved(opened, "json")
    assert name == "torino-monday.json"
    document = json.loads(data)
    wanted = po.report.report_document(plan, net, title="Torino: Monday")
    for vehicle in wanted["vehicles"]:
        del vehicle["fatigue"]
    assert document == {**wanted, "tiles": None}
    assert document["format"] == "platoon_osm report"


def entries(data: bytes) -> list[tuple[str, datetime, datetime | None]]:
    """What a calendar knows its events by, and when they begin and end."""
    return [
        (
            str(event["uid"]),
            event.decoded("dtstart"),
            event.decoded("dtend") if "dtend" in event else None,
        )
        for event in Calendar.from_ical(data).walk("VEVENT")
    ]


def namesakes() -> Plan:
    """Vehicles of one name that go the same way, in a script of more bytes than characters."""
    plan, _ = plan_kind("the same trip thrice")
    assert plan.timetable is not None
    # The name is longer than what pages show of it.
    trips = tuple(replace(trip, vehicle="\u8d27\u8f66" * 250 + trip.vehicle) for trip in plan.trips)
    table = plan.timetable
    times = tuple(
        replace(one, vehicle=trip.vehicle) for one, trip in zip(table.vehicles, trips, strict=True)
    )
    return replace(plan, trips=trips, timetable=replace(table, vehicles=times))


def waits() -> Plan:
    """All leave at six, whatever the others do, and so wait on the road."""
    plan, _ = plan_kind("without times")
    six = datetime(2026, 3, 2, 6)
    trips = [po.Trip(one.vehicle, 0, 1, six, six, six + timedelta(hours=16)) for one in plan.trips]
    return with_times(plan, trips)


def test_the_calendar_of_the_page_is_that_of_the_sheets(
    shown_plan: Callable[..., Any], tmp_path: Path
) -> None:
    """Who takes both has every event once."""
    _, net = plan_kind("three vehicles")
    days, eight = plan_kind("over several days")[0], plan_kind("eight vehicles")[0]
    kinds = set()
    for number, made in enumerate(
        (days, zoned(days), eight, zoned(waits()), namesakes(), day_with_breaks()[0], night()[0])
    ):
        assert made.timetable is not None
        opened = shown_plan(made, net)
        folder = tmp_path / str(number)
        written = po.write_sheets(made, net, folder, language="de")
        sheets = [path.read_bytes() for path in written if path.suffix == ".ics"]
        uids: list[str] = []
        for index, (times, theirs) in enumerate(zip(made.timetable.vehicles, sheets, strict=True)):
            _, data = saved(opened, "ics", index)
            assert all(len(line) <= 75 for line in data.split(b"\r\n"))
            found = entries(data)
            assert found == entries(theirs)
            begins = [begin for _, begin, _ in found]
            clock = made.timetable.clock
            assert abs(begins[0] - clock.moment(times.departure_s)) <= SECOND
            assert abs(begins[-1] - clock.moment(times.arrival_s)) <= SECOND
            assert begins == sorted(begins)
            uids += [uid for uid, *_ in found]
        assert len(set(uids)) == len(uids)
        kinds |= {uid.split("-")[1] for uid in uids}
    assert kinds == {
        "start",
        "merge",
        "separation",
        "wait",
        "end",
        "break",
        "rest",
        "ban",
        "change",
    }
    assert opened.page.locator("[data-file='ics']").count() == 1


def test_without_times_there_is_no_calendar(shown_plan: Callable[..., Any]) -> None:
    opened = shown_plan(*plan_kind("without times"))
    assert opened.page.locator("[data-file='ics']").count() == 0
    assert opened.page.locator("[data-file]").count() == 4


def test_no_formula_leaves_the_page(shown_plan: Callable[..., Any], tmp_path: Path) -> None:
    tried = [name for name in HOSTILE if "\ud800" not in name and len(name) < 300]
    for begin in range(0, len(tried), 30):
        some = tried[begin : begin + 30]
        net = po_valley(lambda name, some=some: some[len(name) % len(some)] + name)
        plan = timed(
            make_plan(net, THREE, lambda name, some=some: some[len(name) % len(some)] + name)
        )
        opened = shown_plan(plan, net)
        _, data = saved(opened, "csv")
        po.write_csv(plan, net, tmp_path / "legs.csv")
        rows, others = (
            list(csv.DictReader(io.StringIO(text, newline="")))
            for text in (data.decode(), (tmp_path / "legs.csv").read_bytes().decode())
        )
        for row, other in zip(rows, others, strict=True):
            for column in ("vehicle", "origin", "destination"):
                assert row[column] == other[column]
                assert row[column] == safe_cell(row[column].replace("'", "")) or "'" in row[column]
        for kind in ("gpx", "geojson", "ics", "json"):
            name, data = saved(opened, kind, None if kind == "json" else 0)
            if kind == "gpx":
                assert name == f"{file_stems([plan.vehicles[0].vehicle])[0]}.gpx"
                ElementTree.fromstring(data)
            elif kind == "ics":
                assert Calendar.from_ical(data).walk("VEVENT")
            else:
                json.loads(data)
        assert opened.page.evaluate("window.hacked") is None
        opened.check(opened.path)


def test_buttons_are_reached_and_large_enough(shown_plan: Callable[..., Any]) -> None:
    plan, net = plan_kind("three vehicles")
    page = shown_plan(plan, net, width=390, height=844, has_touch=True, is_mobile=True).page
    for item in page.locator(".data select, .data button").all():
        box = item.bounding_box()
        assert box["height"] >= 44
        assert box["x"] + box["width"] <= 390
    page.focus("#data-of")
    for kind in ("csv", "geojson", "gpx", "ics", "json"):
        page.keyboard.press("Tab")
        assert page.evaluate("document.activeElement.dataset.file") == kind
    page.keyboard.press("Shift+Tab")
    with page.expect_download() as waiting:
        page.keyboard.press("Enter")
    assert waiting.value.suggested_filename == "torino-monday.ics"
    page.emulate_media(media="print")
    assert not page.is_visible(".data")
