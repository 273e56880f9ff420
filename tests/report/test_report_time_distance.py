"""The time-distance diagram: its lines against the plan, the slider, and figures for papers."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from plan_kinds import plan_kind, timed, valley
from po_valley import make_plan
from test_report_charts import made

from platoon_osm.plans.plan import Plan
from platoon_osm.report import write_figures, write_html
from platoon_osm.report.charts.flags import Flagged, flags

Visit = Callable[..., Any]

Line = tuple[list[tuple[float, float]], tuple[float, float]]


def diagrams(path: Path) -> list[ElementTree.Element]:
    """The diagrams of a page."""
    text = path.read_text(encoding="utf-8")
    found = re.findall(r'<svg class="along diagram".*?</svg>', text, re.DOTALL)
    # XML has quotes; and classes that only stand for frequent attributes say nothing here.
    quoted = [re.sub(r"=([-\w.]+)(?=[ >])", r'="\1"', one) for one in found]
    own = [re.sub(r'class="(\w*?) ?_\w+"', r'class="\1"', one) for one in quoted]
    return [ElementTree.fromstring(one) for one in own]


def drawn(chart: ElementTree.Element) -> dict[int, list[Line]]:
    """The lines of each vehicle in metres and seconds, and how far each is moved in pixels."""
    (lines,) = chart.iterfind("g[@class='lines']")
    left, top, per_metre = (float(lines.attrib[f"data-{k}"]) for k in ("left", "top", "per-metre"))
    begin, per_second = float(chart.attrib["data-from"]), float(chart.attrib["data-per-second"])
    found: dict[int, list[Line]] = {}
    for course in lines.iterfind("g[@class='course']"):
        for one in course.iterfind("polyline"):
            if one.get("class") == "tie":
                continue
            spots = [tuple(map(float, spot.split(","))) for spot in one.attrib["points"].split()]
            points = [((x - left) / per_metre, begin + (y - top) / per_second) for x, y in spots]
            move = re.findall(r"-?[\d.]+", one.get("transform", "0 0"))
            by = float(move[0]), float(move[1])
            found.setdefault(int(course.attrib["data-vehicle"]), []).append((points, by))
    return found


def knots(plan: Plan, index: int) -> list[tuple[float, float]]:
    """When a vehicle has come how far, from the plan alone: at both ends of each stretch."""
    assert plan.timetable is not None
    found, driven = [], 0.0
    spans = plan.timetable.vehicles[index].legs
    for stretch, (begin, end) in zip(plan.ways[index], spans, strict=True):
        found.append((begin, driven))
        driven += plan.stretches[stretch].length_m
        found.append((end, driven))
    return found


def driven_at(known: list[tuple[float, float]], moment: float) -> float:
    for (t0, m0), (t1, m1) in pairwise(known):
        if moment <= t1:
            return m0 + (m1 - m0) * (moment - t0) / (t1 - t0) if t1 > t0 else m1
    return known[-1][1]


KINDS = [
    "two vehicles", "three vehicles", "eight vehicles", "over several days", "all are late",
    "twenty in one", "fifty in one", "waits of minutes", "waits of hours at night",
    "eight who wait", "opposite directions timed", "fifty vehicles",
]  # fmt: skip


def kind_of(name: str) -> Plan:
    if name.endswith(" timed"):
        return timed(plan_kind(name.removesuffix(" timed"))[0])
    return made(name)[0]


@pytest.mark.parametrize("name", KINDS)
def test_lines_are_where_the_plan_has_the_vehicles(name: str, tmp_path: Path) -> None:
    plan = kind_of(name)
    write_html(plan, valley(), tmp_path / "plan.html")
    charts = diagrams(tmp_path / "plan.html")
    groups = [one.vehicles for one in plan.platoons if len(one.vehicles) > 1]
    assert len(charts) == len(groups)
    for chart, group in zip(charts, groups, strict=True):
        lines = drawn(chart)
        assert sorted(lines) == sorted(group)
        pixel_m = 1 / float(chart.find("g[@class='lines']").attrib["data-per-metre"])  # type: ignore[union-attr]
        pixel_s = 1 / float(chart.attrib["data-per-second"])
        starts: dict[int, float] = {}
        for index, pieces in lines.items():
            known = knots(plan, index)
            start = pieces[0][0][0][0]
            starts[index] = start
            ends = [point for points, _ in pieces for point in (points[0], points[-1])]
            assert ends[0][1] == pytest.approx(known[0][0], abs=0.2 * pixel_s + 0.1)
            assert ends[-1][1] == pytest.approx(known[-1][0], abs=0.2 * pixel_s + 0.1)
            for points, _ in pieces:
                for (m0, s0), (m1, s1) in pairwise(points):
                    for share in (0.02, 0.4, 0.98):
                        moment, metres = s0 + share * (s1 - s0), m0 + share * (m1 - m0)
                        # Rounded pixels are seconds and metres: look a little earlier and later.
                        near = [driven_at(known, moment + d * pixel_s) for d in (-0.2, 0.2)]
                        low, high = min(near) - 0.3 * pixel_m, max(near) + 0.3 * pixel_m
                        assert low <= metres - start <= high, (index, moment)
        assert min(starts.values()) == pytest.approx(0, abs=0.2 * pixel_m)
        # Where two drive together both have come equally far on the scale.
        for stretch_id, stretch in enumerate(plan.stretches):
            if len(stretch.vehicles) > 1 and stretch.vehicles[0] in group:
                levels = {
                    round(starts[i] + knots(plan, i)[2 * plan.ways[i].index(stretch_id)][1])
                    for i in stretch.vehicles
                }
                assert max(levels) - min(levels) < 110 + pixel_m


@pytest.mark.parametrize("name", ["three vehicles", "eight vehicles", "eight who wait"])
def test_lines_that_would_coincide_lie_side_by_side(name: str, tmp_path: Path) -> None:
    write_html(kind_of(name), valley(), tmp_path / "plan.html")
    (chart,) = diagrams(tmp_path / "plan.html")
    moved = [by for pieces in drawn(chart).values() for _, by in pieces]
    assert any(by != (0, 0) for by in moved)
    assert all((x * x + y * y) ** 0.5 <= 60.1 for x, y in moved)
    # The line along whose road distance is told keeps its place where it is alone.
    assert (0.0, 0.0) in moved


def test_waits_are_there_and_as_long_as_they_last(tmp_path: Path) -> None:
    plan = kind_of("waits of hours at night")
    assert plan.timetable is not None
    write_html(plan, valley(), tmp_path / "plan.html")
    (chart,) = diagrams(tmp_path / "plan.html")
    per_second = float(chart.attrib["data-per-second"])
    heights = {
        one.attrib["data-vehicle"]: float(rect.attrib["height"])
        for one in chart.iterfind("g/g[@data-vehicle]")
        if (rect := one.find("rect")) is not None
    }
    for index, times in enumerate(plan.timetable.vehicles):
        if times.waiting_s > 60:
            assert heights[str(index)] == pytest.approx(times.waiting_s * per_second, abs=0.2)
    assert len(heights) == 2


def test_all_events_are_marked_and_named(tmp_path: Path) -> None:
    plan = kind_of("three vehicles")
    write_html(plan, valley(), tmp_path / "plan.html")
    (chart,) = diagrams(tmp_path / "plan.html")
    events = [one.attrib["data-event"] for one in chart.iterfind("g[@data-event]")]
    assert events == [str(number) for number in range(len(plan.events))]
    texts = {one.text for one in chart.iter("text")}
    assert {event.point.name for event in plan.events} <= texts
    assert {"Torino", "Trieste"} <= texts


@pytest.mark.parametrize("kind", ["without times", "all alone", "one vehicle"])
def test_without_times_or_company_there_is_no_diagram(kind: str, tmp_path: Path) -> None:
    plan, net = plan_kind(kind)
    write_html(plan, net, tmp_path / "plan.html")
    assert diagrams(tmp_path / "plan.html") == []


@pytest.mark.parametrize("kind", ["all alone", "one vehicle", "late even alone", "a short trip"])
def test_charts_without_a_platoon_do_not_speak_of_one(kind: str, tmp_path: Path) -> None:
    plan, net = plan_kind(kind)
    write_html(plan, net, tmp_path / "plan.html")
    text = (tmp_path / "plan.html").read_text(encoding="utf-8")
    notes = re.findall(r'<p class="note">(.*?)</p>', text)
    assert notes
    for note in notes:
        if "This plan sets no breaks" not in note:
            assert "platoon" not in note.lower(), note


SLIDE = """minutes => {
  const slider = document.querySelector('.journey input');
  slider.value = minutes;
  slider.dispatchEvent(new Event('input'));
}"""


@pytest.mark.browser
def test_the_slider_moves_the_cursor_of_the_diagram(visit: Visit, tmp_path: Path) -> None:
    plan = kind_of("three vehicles")
    assert plan.timetable is not None
    write_html(plan, valley(), tmp_path / "plan.html")
    opened = visit(tmp_path / "plan.html")
    page = opened.page
    begin = min(times.departure_s for times in plan.timetable.vehicles)
    page.evaluate(SLIDE, 200)
    chart = page.locator("svg.diagram")
    cursor = chart.locator(".cursor.on")
    assert cursor.count() == 1
    ends = {side: float(cursor.get_attribute(side)) for side in ("x1", "x2", "y1", "y2")}
    zero, start, per_second = (
        float(chart.get_attribute(f"data-{name}")) for name in ("zero", "from", "per-second")
    )
    assert ends["y1"] == ends["y2"]
    assert ends["y1"] == pytest.approx(zero + (begin + 200 * 60 - start) * per_second, abs=0.2)
    assert ends["x2"] - ends["x1"] > 250
    opened.check(tmp_path / "plan.html")


@pytest.mark.browser
def test_the_diagram_is_printed(visit: Visit, tmp_path: Path) -> None:
    write_html(kind_of("three vehicles"), valley(), tmp_path / "plan.html")
    page = visit(tmp_path / "plan.html", java_script_enabled=False).page
    page.emulate_media(media="print")
    assert page.locator("svg.diagram").is_visible()


def test_figures_of_diagrams(tmp_path: Path) -> None:
    plan = timed(plan_kind("two platoons on one road")[0])
    names = [path.name for path in write_figures(plan, valley(), tmp_path, formats=("svg",))]
    assert "time-distance.svg" in names
    assert "time-distance-2.svg" in names


def test_names_of_places_never_touch() -> None:
    names = ["Bergamo", "Brescia Centro", "Verona Nord", "Padova Est", "Mestre", "Trieste Ovest"]
    wanted = [Flagged(40 + 55 * k, name, 1) for k, name in enumerate(names)]
    hung = flags(wanted, 372, 12)
    assert [flag.text for flag in hung] == names
    for flag in hung:
        assert 0 <= flag.left < flag.right <= 372
        for other in hung:
            if other is not flag and other.row == flag.row:
                assert flag.right < other.left or other.right < flag.left
            if other.row > flag.row:
                assert not flag.left <= other.x <= flag.right


def test_long_drives_are_said_with_and_without_times(tmp_path: Path) -> None:
    net = valley()
    bare = make_plan(net, [("A", "Torino", "Trieste", None, None)])
    for plan, due in ((bare, ""), (timed(bare), "4 h 30 are reached at 10:30, ")):
        write_html(plan, net, tmp_path / "plan.html")
        text = (tmp_path / "plan.html").read_text(encoding="utf-8")
        assert "Driving beyond 4 h 30 without a break" in text
        assert f"at a stretch, {due}near " in text
        hours = plan.vehicles[0].time_s / 3600
        assert hours > 4.5
        assert f"drives {int(hours)} h" in text
    write_html(*plan_kind("a short trip"), tmp_path / "short.html")
    assert "without a break" not in re.sub(
        r"<script.*?</script>", "", (tmp_path / "short.html").read_text("utf-8"), flags=re.DOTALL
    ).replace("alone, without a break", "")
