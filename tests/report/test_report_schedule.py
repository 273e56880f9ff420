"""Times in the report: the document, the schedule, the slider by the clock, and exports."""

from __future__ import annotations

import csv
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bundled import italy as italy_map
from hostile_names import HOSTILE
from plans_by_legs import with_vehicles
from po_valley import THREE, make_plan, po_valley
from soak import chosen, soaked
from test_report_budgets import contrast

from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.scenario import read_scenario
from platoon_osm.planning.timing.schedule import with_times
from platoon_osm.plans.clock import Clock
from platoon_osm.plans.plan import JointPlan
from platoon_osm.plans.trip import Trip
from platoon_osm.report import (
    report_document,
    to_geodataframe,
    write_comparison,
    write_csv,
    write_figures,
    write_flows,
    write_geopackage,
    write_gpx,
    write_html,
)
from platoon_osm.report.drawing.palette import LATE
from platoon_osm.report.drawing.ticks import hour_ticks
from platoon_osm.report.markup.fragments import asset, compact_asset

Visit = Callable[..., Any]

browser = pytest.mark.browser

SIX = datetime(2026, 3, 2, 6)


def hours(number: float) -> timedelta:
    return timedelta(hours=number)


def timed(plan: JointPlan, start: datetime = SIX, late: bool = False) -> JointPlan:
    """A leaves at six; B has to leave at half past four and waits; C leaves later than it could."""
    a, b, c = (vehicle.vehicle for vehicle in plan.vehicles)
    arrival = start + hours(6 if late else 8)
    return with_times(
        plan,
        [
            Trip(a, 0, 1, start, None, arrival),
            Trip(b, 0, 1, start - hours(2), start - hours(1.5)),
            Trip(c, 0, 1, start - hours(1)),
        ],
    )


@pytest.fixture(scope="module")
def day(plan: JointPlan) -> JointPlan:
    return timed(plan)


@pytest.fixture(scope="module")
def document(day: JointPlan, net: RoadNetwork) -> dict[str, Any]:
    return report_document(day, net)


@pytest.fixture(scope="module")
def page_file(day: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("schedule") / "plan.html"
    write_html(day, net, path)
    return path


@pytest.fixture(scope="module")
def crowd_file(many: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Fifty vehicles, each a few minutes after another, some of which have to leave by seven."""
    trips = [
        Trip(
            vehicle.vehicle, 0, 1, SIX + timedelta(minutes=7 * k % 60),
            None if k % 5 else SIX + hours(1),
        )
        for k, vehicle in enumerate(many.vehicles)
    ]  # fmt: skip
    path = tmp_path_factory.mktemp("crowd") / "crowd.html"
    write_html(with_times(many, trips), net, path)
    return path


# -- the document ----------------------------------------------------------------------------------


def test_spans_are_those_of_the_legs(day: JointPlan, document: dict[str, Any]) -> None:
    assert day.timetable is not None
    for vehicle, times, shown in zip(
        day.vehicles, day.timetable.vehicles, document["vehicles"], strict=True
    ):
        spans = shown["times"]["spans"]
        assert len(spans) == len(shown["way"])
        assert spans[0][0] == pytest.approx(times.legs[0][0], abs=0.1)
        assert spans[-1][1] == pytest.approx(times.arrival_s, abs=0.1)
        driving = sum(end - begin for begin, end in spans)
        assert driving == pytest.approx(vehicle.time_s, abs=1)
        assert times.waiting_s == pytest.approx(shown["times"]["waiting_s"], abs=0.1)


def test_vehicles_of_a_platoon_share_its_spans(document: dict[str, Any]) -> None:
    seen: dict[int, set[tuple[float, float]]] = {}
    for vehicle in document["vehicles"]:
        for (kind, piece), span in zip(vehicle["way"], vehicle["times"]["spans"], strict=True):
            if kind == "platoon":
                seen.setdefault(piece, set()).add(tuple(span))
    assert len(seen) == len(document["platoons"])
    assert all(len(spans) == 1 for spans in seen.values())


def test_spans_are_those_of_the_timetable(plan: JointPlan, net: RoadNetwork) -> None:
    day = timed(plan)
    assert day.timetable is not None
    for vehicle, times in zip(
        report_document(day, net)["vehicles"], day.timetable.vehicles, strict=True
    ):
        assert np.allclose(vehicle["times"]["spans"], times.legs, atol=0.06)


def test_figures_events_and_texts(document: dict[str, Any]) -> None:
    third = document["totals"]["figures"][2]
    assert third["figure"] == "1:41 h"
    assert third["label"].startswith("waiting on the road; ")
    merges = {event["text"]: event["detail"] for event in document["events"]}
    assert "07:32, C joins A" in merges
    assert merges["08:49, B joins A and C"].endswith("B waits 1 h 41 min")
    assert document["schedule"]["text"]["day"] == "Mon, 2 Mar 2026"
    assert document["schedule"]["zone"] == "local time"
    texts = [vehicle["times"]["text"] for vehicle in document["vehicles"]]
    assert [text["departure"] for text in texts] == ["06:00", "04:30", "07:04"]
    assert texts[2]["held"] == "2 h 04 min"


def test_without_times_there_is_no_schedule(plan: JointPlan, net: RoadNetwork) -> None:
    document = report_document(plan, net)
    assert document["schedule"] is None
    assert {vehicle["times"] for vehicle in document["vehicles"]} == {None}
    assert {event["at_s"] for event in document["events"]} == {None}


def test_fatigue_stands_while_a_vehicle_waits(day: JointPlan, document: dict[str, Any]) -> None:
    assert day.timetable is not None
    waiting_h = day.timetable.vehicles[1].waiting_s / 3600
    joint = document["vehicles"][1]["fatigue"]["joint"]
    assert joint["hours"][-1] == pytest.approx(day.vehicles[1].time_s / 3600 + waiting_h, abs=2e-3)
    before_h = day.vehicles[1].legs[0].time_s / 3600
    waited = [
        value
        for hour, value in zip(joint["hours"], joint["values"], strict=True)
        if before_h - 1e-3 <= hour <= before_h + waiting_h
    ]
    assert len(waited) > 3
    assert len(set(waited)) == 1


def test_a_timetable_of_other_vehicles_is_refused(day: JointPlan, net: RoadNetwork) -> None:
    with pytest.raises(ScenarioError, match="timetable is that of other vehicles"):
        report_document(with_vehicles(day, (*day.vehicles[1:], day.vehicles[0])), net)


@pytest.mark.parametrize(
    ("begin_h", "end_h", "expected"),
    [
        (5.33, 13, ["06:00", "08:00", "10:00", "12:00"]),
        (8, 8.5, ["08:00", "08:15", "08:30"]),
        (22, 27, ["22:00", "23:00", "00:00 +1 d", "01:00 +1 d", "02:00 +1 d", "03:00 +1 d"]),
        (6, 78, ["12:00", "00:00 +1 d", "12:00 +1 d", "00:00 +2 d", "12:00 +2 d", "00:00 +3 d"]),
    ],
)
def test_hours_of_an_axis(begin_h: float, end_h: float, expected: list[str]) -> None:
    clock = Clock.from_text("2026-03-02T04:00:00")
    ticks = hour_ticks(clock, (begin_h - 4) * 3600, (end_h - 4) * 3600)
    assert [text for _, text in ticks] == expected


def test_a_year_has_few_hours_on_its_axis() -> None:
    clock = Clock.from_text("2026-03-02T00:00:00")
    assert 3 < len(hour_ticks(clock, 0, 400 * 86400)) < 10
    assert clock.text(-60) == "23:59 -1 d"


# -- the page --------------------------------------------------------------------------------------


def test_same_plan_same_bytes(
    day: JointPlan, net: RoadNetwork, page_file: Path, tmp_path: Path
) -> None:
    write_html(timed(replace(day, timetable=None, proof=make_plan(net, THREE).proof)), net,
               tmp_path / "again.html")  # fmt: skip
    assert (tmp_path / "again.html").read_bytes() == page_file.read_bytes()


def test_the_demo_fits_its_budget(tmp_path: Path) -> None:
    net = italy_map()
    with as_file(files("platoon_osm.scenarios") / "po-valley-c.toml") as path:
        plan = read_scenario(path).plan(net)
    assert plan.timetable is not None
    assert plan.timetable.feasible
    assert plan.timetable.vehicles[1].waiting_s > 600
    write_html(plan, net, tmp_path / "demo.html", title="Torino to Trieste with company")
    assert (tmp_path / "demo.html").stat().st_size < 450_000


def test_lateness_is_said(plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    write_html(timed(plan, late=True), net, tmp_path / "late.html")
    text = (tmp_path / "late.html").read_text(encoding="utf-8")
    assert "1 of 3 late, by 57 min; late even alone" in text
    # Of the panel its own row says so, and no box above the schedule again.
    assert re.findall(r"<small class=\"?late-by\"?>([^<]*)</small>", text) == ["57 min late"]
    assert "Too late" not in text


@pytest.mark.parametrize("start", range(0, len(HOSTILE), 24))
def test_hostile_names_with_times(start: int, visit: Visit, tmp_path: Path) -> None:
    def spoilt(name: str) -> str:
        return f"{HOSTILE[(start + len(name)) % len(HOSTILE)]} {name}"

    net = po_valley(spoilt)
    write_html(timed(make_plan(net, THREE, spoilt), late=True), net, tmp_path / "hostile.html")
    opened = visit(tmp_path / "hostile.html")
    opened.page.evaluate(SLIDE, 100)
    opened.page.wait_for_timeout(50)
    opened.check(tmp_path / "hostile.html")


def test_pages_of_several_plans_take_plans_with_times(
    day: JointPlan, net: RoadNetwork, tmp_path: Path
) -> None:
    write_comparison([day, day], net, tmp_path / "compare.html", titles=["One", "Two"])
    write_flows(day, net, tmp_path / "flows.html")
    assert "waiting on the road" in (tmp_path / "compare.html").read_text(encoding="utf-8")


MOVED = """() => {
  const found = {};
  map_plan.eachLayer(layer => {
    if (layer.options.icon?.options.className !== 'mark moving') return;
    const { lng, lat } = layer.getLatLng();
    const disc = layer.getElement();
    found[disc.textContent] = [lng, lat, disc.getAttribute('aria-label')];
  });
  return found;
}"""

SLIDE = """minutes => {
  const slider = document.querySelector('.journey input');
  slider.value = minutes;
  slider.dispatchEvent(new Event('input'));
}"""


def minute(document: dict[str, Any], seconds: float) -> float:
    """Where on the slider a moment lies."""
    return (seconds - float(document["schedule"]["begin_s"])) / 60


@browser
def test_all_are_at_the_point_when_they_merge_or_part(
    page_file: Path, document: dict[str, Any], visit: Visit
) -> None:
    opened = visit(page_file)
    assert len(document["events"]) >= 4
    for event in document["events"]:
        opened.page.evaluate(SLIDE, minute(document, event["at_s"]))
        found = opened.page.evaluate(MOVED)
        for index in (*event["vehicles"], *event["others"]):
            letter = document["vehicles"][index]["letter"]
            # Times are kept to 0.1 s, drawn lines to 8 m.
            place = pytest.approx((event["lon"], event["lat"]), abs=2e-4)
            assert found[letter][:2] == place, (letter, event["text"])
    opened.check(page_file)


@browser
def test_who_waits_stands_still(page_file: Path, document: dict[str, Any], visit: Visit) -> None:
    page = visit(page_file).page
    merge = next(event for event in document["events"] if "B joins" in event["text"])
    at = minute(document, merge["at_s"])
    seen = []
    for before in (90, 60, 1):
        page.evaluate(SLIDE, at - before)
        seen.append(page.evaluate(MOVED))
        assert "B waiting" in page.locator(".journey .states").inner_text()
    assert {tuple(one["B"][:2]) for one in seen} == {tuple(seen[0]["B"][:2])}
    assert seen[0]["B"][:2] == pytest.approx((merge["lon"], merge["lat"]), abs=2e-4)
    assert "B waiting" in seen[0]["B"][2]
    # The others drive meanwhile.
    assert seen[1]["A"][:2] != seen[2]["A"][:2]
    page.evaluate(SLIDE, at + 0.1)
    assert "A, B, C in platoon" in page.locator(".journey .states").inner_text()


@browser
def test_before_and_after_the_drive(
    page_file: Path, document: dict[str, Any], visit: Visit
) -> None:
    page = visit(page_file).page
    assert page.locator(".mark.moving").count() == 0
    page.evaluate(SLIDE, 30)
    found = page.evaluate(MOVED)
    for letter, state in (("A", "not yet left"), ("C", "held back")):
        stop = next(v for v in document["vehicles"] if v["letter"] == letter)["origin"]
        assert found[letter][:2] == pytest.approx((stop["lon"], stop["lat"]), abs=2e-4)
        assert state in found[letter][2]
    states = page.locator(".journey .states").inner_text()
    assert states == "B alone; C held back; A not yet left"
    page.get_by_role("slider", name="Time of day").focus()
    page.keyboard.press("End")
    stop = document["vehicles"][1]["destination"]
    assert page.evaluate(MOVED)["B"][:2] == pytest.approx((stop["lon"], stop["lat"]), abs=2e-4)
    assert page.locator(".journey .states").inner_text() == "A, B, C arrived"


@browser
def test_the_slider_says_the_time_and_moves_the_cursor(page_file: Path, visit: Visit) -> None:
    from playwright.sync_api import expect

    opened = visit(page_file)
    page = opened.page
    slider = page.get_by_role("slider", name="Time of day")
    output = page.locator(".journey output")
    assert output.inner_text() == "04:30"
    page.evaluate(SLIDE, 100)
    assert output.inner_text() == "06:10"
    assert slider.get_attribute("aria-valuetext").startswith("06:10, A, B alone; C held back")
    cursor = page.locator(".schedule .cursor.on")
    assert cursor.count() == 1
    # A leaves at six: its disc and the cursor ten minutes later agree with the axis.
    start = page.locator(".schedule g circle[r='4']").first
    x0 = float(start.get_attribute("cx"))
    per_second = float(page.locator(".schedule").get_attribute("data-per-second"))
    assert float(cursor.get_attribute("x1")) == pytest.approx(x0 + 600 * per_second, abs=0.2)
    page.get_by_role("button", name="Play the journey").click()
    # Not with wait_for_function: the page's own policy forbids what that evaluates.
    expect(output).not_to_have_text("06:10")
    page.get_by_role("button", name="Pause the journey").click()
    opened.check(page_file)


@browser
def test_days_after_the_first_are_told(
    plan: JointPlan, net: RoadNetwork, visit: Visit, tmp_path: Path
) -> None:
    day = timed(plan, datetime(2026, 12, 31, 21))
    write_html(day, net, tmp_path / "night.html")
    page = visit(tmp_path / "night.html").page
    page.get_by_role("slider", name="Time of day").focus()
    page.keyboard.press("End")
    shown = " ".join(page.locator(".journey output").inner_text().split())
    assert shown == "03:57 +1 d"
    assert "03:57 +1 d" in " ".join(page.locator("main").inner_text().split())


@browser
def test_without_script_the_schedule_is_there(page_file: Path, visit: Visit) -> None:
    page = visit(page_file, java_script_enabled=False).page
    chart = page.get_by_role("img", name="When each vehicle drives")
    assert chart.is_visible()
    text = chart.text_content()
    for time in ("04:30", "06:00", "07:04", "08:49", "12:57"):
        assert time in text
    assert "B leaves 04:30, 30 min later than it could, waits 1 h 41 min, arrives" in text
    assert not page.locator(".journey").is_visible()


@browser
def test_prints_on_two_pages_with_the_schedule(page_file: Path, visit: Visit) -> None:
    page = visit(page_file).page
    page.emulate_media(media="print")
    assert page.locator(".schedule").is_visible()
    assert not page.locator(".journey").is_visible()
    pdf = page.pdf(prefer_css_page_size=True)
    assert len(re.findall(rb"/Type\s*/Page[^s]", pdf)) <= 2


@browser
def test_a_crowd_prints_its_times_in_the_table(crowd_file: Path, visit: Visit) -> None:
    page = visit(crowd_file).page
    page.emulate_media(media="print")
    assert not page.locator(".schedule").first.is_visible()
    assert "08:02\u2060\u2013\u206013:49, member" in page.locator("main").inner_text()
    pdf = page.pdf(prefer_css_page_size=True)
    assert len(re.findall(rb"/Type\s*/Page[^s]", pdf)) <= 2


EVERY = [(which, width) for which in ("page_file", "crowd_file") for width in (1440, 390)]


@browser
@soaked
@pytest.mark.parametrize(("which", "width"), chosen(EVERY[1:3], EVERY))
def test_axe_finds_no_serious_fault(
    which: str, width: int, visit: Visit, request: pytest.FixtureRequest
) -> None:
    pytest.importorskip("axe_playwright_python")
    page = visit(request.getfixturevalue(which), width, 900).page
    page.evaluate(SLIDE, 150)
    page.evaluate((files("axe_playwright_python") / "axe.min.js").read_text("utf-8"))
    found = page.evaluate("axe.run(document, {resultTypes: ['violations']})")
    faults = [
        (fault["id"], [node["html"][:120] for node in fault["nodes"][:3]])
        for fault in found["violations"]
        if fault["impact"] in ("serious", "critical")
    ]
    assert faults == []


OVERLAPS = """() => {
  const rows = [...document.querySelectorAll('.schedule > g')];
  return rows.flatMap(row => {
    const boxes = [...row.querySelectorAll(':scope > text')].map(t => t.getBoundingClientRect());
    const cross = (a, b) => a.left < b.right - 1 && b.left < a.right - 1
      && a.top < b.bottom - 1 && b.top < a.bottom - 1;
    return boxes.flatMap((a, i) => boxes.slice(i + 1).filter(b => cross(a, b)));
  }).length;
}"""


@browser
@soaked
@pytest.mark.parametrize("width", chosen([900], [1440, 900, 390]))
@pytest.mark.parametrize("which", ["page_file", "crowd_file"])
def test_labels_of_the_schedule_do_not_overlap(
    which: str, width: int, visit: Visit, request: pytest.FixtureRequest
) -> None:
    # Opened at one width, and resized to the others.
    page = visit(request.getfixturevalue(which), width, 900).page
    for other in (width, 390, 1440):
        page.set_viewport_size({"width": other, "height": 900})
        page.evaluate(
            "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
        )
        assert page.evaluate(OVERLAPS) == 0, other
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), other


@browser
def test_a_crowd_is_counted(crowd_file: Path, visit: Visit) -> None:
    opened = visit(crowd_file)
    opened.page.evaluate(SLIDE, 200)
    text = opened.page.locator(".journey .states").inner_text()
    counts = [int(part) for part in re.findall(r"\d+", text)]
    assert sum(counts) == 50
    assert "in platoon" in text
    rows = opened.page.locator(".schedule").first.locator(":scope > g")
    assert rows.count() == 36
    opened.check(crowd_file)


# -- exports ---------------------------------------------------------------------------------------

GPX = "{http://www.topografix.com/GPX/1/1}"


def test_gpx_has_times_in_utc_where_the_plan_has_a_zone(
    plan: JointPlan, net: RoadNetwork, tmp_path: Path
) -> None:
    rome = timedelta(hours=1)
    from datetime import timezone

    day = timed(plan, SIX.replace(tzinfo=timezone(rome)))
    write_gpx(day, net, tmp_path)
    root = ElementTree.parse(tmp_path / "b.gpx").getroot()
    moments = [
        datetime.fromisoformat(found.text or "")
        for found in root.iterfind(f"{GPX}trk/{GPX}trkseg/{GPX}trkpt/{GPX}time")
    ]
    assert len(moments) == len(root.findall(f".//{GPX}trkpt"))
    assert moments == sorted(moments)
    assert moments[0] == datetime(2026, 3, 2, 3, 30, tzinfo=UTC)
    stops = {
        (one.findtext(f"{GPX}type") or ""): one.findtext(f"{GPX}time")
        for one in root.iterfind(f"{GPX}wpt")
    }
    assert stops["start"] == "2026-03-02T03:30:00Z"
    assert (stops["merge"] or "").startswith("2026-03-02T07:48:")
    # Between two segments B waits.
    first, second = root.findall(f"{GPX}trk/{GPX}trkseg")[:2]
    ends = [one.findtext(f"{GPX}time") or "" for one in (first[-1], second[0])]
    gap = datetime.fromisoformat(ends[1]) - datetime.fromisoformat(ends[0])
    assert gap.total_seconds() == pytest.approx(day.times[1].waiting_s, abs=1.5)  # type: ignore[union-attr]
    # The schema wants the time before the name.
    waypoint = root.find(f"{GPX}wpt")
    assert waypoint is not None
    assert [child.tag.removeprefix(GPX) for child in waypoint] == ["time", "name", "type"]


def test_gpx_leaves_out_times_without_a_zone(
    day: JointPlan, net: RoadNetwork, tmp_path: Path
) -> None:
    write_gpx(day, net, tmp_path)
    text = (tmp_path / "b.gpx").read_text(encoding="utf-8")
    assert "<time>" not in text
    assert "times left out: those of the plan name no time zone" in text


def test_tables_have_times(day: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    write_csv(day, net, tmp_path / "legs.csv")
    with (tmp_path / "legs.csv").open(encoding="utf-8", newline="") as handle:
        rows = list(csv.DictReader(handle))
    first = [row for row in rows if row["vehicle"] == "B"][:2]
    assert first[0]["start_time"] == "2026-03-02T04:30:00"
    assert [float(row["waiting_s"]) > 0 for row in first] == [False, True]
    assert first[1]["start_time"] > first[0]["end_time"]


def test_tables_without_times_are_as_before(plan: JointPlan, net: RoadNetwork) -> None:
    assert "start_time" not in to_geodataframe(plan, net).columns


def test_geopackage_has_times(day: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    import pyogrio

    write_geopackage(day, net, tmp_path / "plan.gpkg")
    points = pyogrio.read_dataframe(tmp_path / "plan.gpkg", layer="points")
    merges = points[points["kind"] == "merge"]
    assert sorted(text[:16] for text in merges["time"]) == ["2026-03-02T07:32", "2026-03-02T08:48"]
    assert points["time"].notna().all()
    routes = pyogrio.read_dataframe(tmp_path / "plan.gpkg", layer="routes")
    assert {"start_time", "end_time", "waiting_s"} <= set(routes.columns)
    about = pyogrio.read_dataframe(tmp_path / "plan.gpkg", layer="about", read_geometry=False)
    assert dict(zip(about["item"], about["text"], strict=True))["feasible_in_time"] == "True"


def test_schedule_figure_and_its_numbers(day: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    written = write_figures(day, net, tmp_path, formats=("png", "svg"))
    names = [path.name for path in written]
    assert names[-5:] == [
        *("schedule.png", "schedule.svg"),
        *("time-distance.png", "time-distance.svg", "schedule.csv"),
    ]
    with (tmp_path / "schedule.csv").open(encoding="utf-8", newline="") as handle:
        rows = [row for row in csv.DictReader(handle) if row["vehicle"] == "B"]
    assert [row["does"] for row in rows][:4] == ["could have left", "alone", "waits", "in platoon"]
    assert rows[2]["begin"] == rows[1]["end"]
    assert rows[3]["with"] == "A C"
    assert rows[0]["begin"] == "2026-03-02T04:00:00"


# -- colours and code ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("ink", "ground", "least"),
    [
        ("#a3260a", "#fbf1ee", 4.5), ("#a3260a", "#ffffff", 4.5), ("#5a6675", "#ffffff", 4.5),
        ("#17202b", "#ffffff", 4.5), ("#8a6a00", "#ffffff", 3), ("#17202b", "#ffd54a", 3),
    ],
)  # fmt: skip
def test_contrast_of_the_schedule(ink: str, ground: str, least: float) -> None:
    assert contrast(ink, ground) >= least
    sources = "".join(asset(name) for name in ("schedule.css", "schedule.html", "theme.css"))
    assert ink in sources + LATE


def test_the_style_of_the_schedule_may_lose_its_indents() -> None:
    compact = compact_asset("schedule.css")
    assert 0 < len(compact) < len(asset("schedule.css"))
    assert "/*" not in compact
