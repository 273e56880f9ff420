"""Charts in a real browser: no text is cut or covers another, on any kind of plan."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime, timedelta
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from plan_kinds import SIX, plan_kind, timed, valley, valley_plan
from po_valley import THREE, fifty
from soak import chosen, soaked

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.timing.schedule import with_times
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.trip import Trip
from platoon_osm.report import write_html
from platoon_osm.report.charts.fatigue_chart import fatigue_chart
from platoon_osm.report.document.document import document_of
from platoon_osm.report.markup.fragments import written

Visit = Callable[..., Any]
browser = pytest.mark.browser


def met(hours: tuple[float, ...], start: datetime = SIX) -> Plan:
    """Three who leave when they must, so that some of them wait."""
    plan = valley_plan(THREE)
    leave = [start + timedelta(hours=hour) for hour in hours]
    names = [vehicle.vehicle for vehicle in plan.vehicles]
    return with_times(plan, [Trip(n, 0, 1, at, at) for n, at in zip(names, leave, strict=True)])


OWN: dict[str, Callable[[], Plan]] = {
    "twenty in one": lambda: timed(valley_plan(fifty()[:20]), apart=0.1),
    "fifty in one": lambda: timed(valley_plan(fifty()), apart=0.1),
    "waits of minutes": lambda: met((0, 0.1, 1.0)),
    "waits of hours at night": lambda: met((0, -5, -3.5), SIX + timedelta(hours=17)),
    "days of waiting": lambda: met((0, -40, -30)),
    "eight who wait": lambda: with_times(
        plan := valley_plan(fifty()[:8]),
        [
            Trip(one.vehicle, 0, 1, at := SIX + timedelta(hours=0.4 * k), at)
            for k, one in enumerate(plan.vehicles)
        ],
    ),
}

KINDS = (
    "one vehicle", "two vehicles", "three vehicles", "eight vehicles", "twenty vehicles",
    "fifty vehicles", "without times", "all are late", "late even alone", "over several days",
    "all alone", "all end together", "the same trip thrice", "a short trip", "long names",
    "names in other scripts", *OWN,
)  # fmt: skip


QUICK = (
    "one vehicle", "fifty vehicles", "without times", "late even alone", "over several days",
    "long names", "names in other scripts", "waits of minutes", "days of waiting", "fifty in one",
)  # fmt: skip


@cache
def made(kind: str) -> tuple[Plan, RoadNetwork]:
    return (OWN[kind](), valley()) if kind in OWN else plan_kind(kind)


TEXTS = """() => {
  for (const one of document.querySelectorAll('details')) one.open = true;
  const found = [];
  const charts = 'svg.along, svg.fatigue, [aria-labelledby^="h-waiting"] svg';
  for (const chart of document.querySelectorAll(charts)) {
    const frame = chart.getBoundingClientRect();
    const scale = frame.width / chart.viewBox.baseVal.width;
    const boxes = [...chart.querySelectorAll('text')].map(one => {
      const { left, right, top, bottom } = one.getBoundingClientRect();
      const size = parseFloat(getComputedStyle(one).fontSize) * scale;
      return { text: one.textContent, left, right, top, bottom, size };
    });
    const box = chart.parentElement;
    found.push({ hidden: box.scrollWidth - box.clientWidth, boxes, width: frame.width,
      name: chart.getAttribute('class'),
      left: frame.left, right: frame.right, top: frame.top, bottom: frame.bottom });
  }
  return found;
}"""


def faults(chart: dict[str, Any]) -> list[str]:
    """What is cut or covered in a chart."""
    found = []
    boxes = chart["boxes"]
    for number, box in enumerate(boxes):
        name = f"{chart['name']}: {box['text']!r}"
        if box["left"] < chart["left"] - 0.5 or box["right"] > chart["right"] + 0.5:
            found.append(f"{name} is cut at a side")
        if box["top"] < chart["top"] - 1.5 or box["bottom"] > chart["bottom"] + 1.5:
            found.append(f"{name} is cut above or below")
        for other in boxes[number + 1 :]:
            across = min(box["right"], other["right"]) - max(box["left"], other["left"])
            down = min(box["bottom"], other["bottom"]) - max(box["top"], other["top"])
            # Lines of text may share the blank above capitals.
            if across > 0.5 and down > 3.5:
                found.append(f"{name} covers {other['text']!r}")
    return found


@browser
@soaked
@pytest.mark.parametrize("kind", chosen(QUICK, KINDS))
def test_no_text_of_a_chart_is_cut_or_covers_another(
    kind: str, visit: Visit, tmp_path: Path
) -> None:
    plan, net = made(kind)
    write_html(plan, net, tmp_path / "plan.html")
    page = visit(tmp_path / "plan.html", java_script_enabled=False).page
    for width in (1440, 390, 320):
        page.set_viewport_size({"width": width, "height": 900})
        charts = page.evaluate(TEXTS)
        assert charts
        for chart in charts:
            assert faults(chart) == [], width
            assert chart["boxes"]
            assert chart["hidden"] <= 0, "a part has to be scrolled to"
            for box in chart["boxes"]:
                # Wide letters in a disc are a little smaller.
                least = 9.3 if len(box["text"]) <= 2 else 10.4
                assert box["size"] > least, (width, chart["name"], box["text"])


SPOKEN = [
    (kind, *how)
    for kind in ("waits of hours at night", "eight who wait", "fifty in one")
    for how in (("de", None), ("it", 12))
]


@browser
@soaked
@pytest.mark.parametrize(("kind", "language", "clock"), chosen(SPOKEN[:4:3] + SPOKEN[4:5], SPOKEN))
def test_texts_fit_in_other_languages(
    kind: str, language: str, clock: int | None, visit: Visit, tmp_path: Path
) -> None:
    plan, net = made(kind)
    write_html(plan, net, tmp_path / "plan.html", language=language, clock=clock)
    page = visit(tmp_path / "plan.html", 390, java_script_enabled=False).page
    for chart in page.evaluate(TEXTS):
        assert faults(chart) == []


def test_the_test_of_boxes_can_fail() -> None:
    box = {"text": "a", "left": 0, "right": 10, "top": 0, "bottom": 10}
    chart = {"name": "x", "left": 0, "right": 20, "top": 0, "bottom": 20, "boxes": [box, box]}
    assert faults(chart) == ["x: 'a' covers 'a'"]
    chart["boxes"] = [{**box, "right": 22}]
    assert faults(chart) == ["x: 'a' is cut at a side"]


@pytest.mark.parametrize(("kind", "columns"), [("all alone", 1), ("three vehicles", 2)])
def test_fatigue_of_who_drive_alone_is_told_once(kind: str, columns: int) -> None:
    plan, net = made(kind)
    chart = written(fatigue_chart(document_of(plan, net)))
    assert chart.count(">alone<") == chart.count(">joint<") == columns - 1
    assert chart.count(">highest<") == 2 - columns
    assert chart.count("<polyline") == columns * len(plan.vehicles)
    assert ("Dashed" in chart) == (columns == 2)
    assert "at the right the highest of each" in chart
