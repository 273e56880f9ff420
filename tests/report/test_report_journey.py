"""The journey by distance: the common scale, the slider that plays it, and fatigue along it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from plans_by_legs import with_vehicles

from platoon_osm.costs.fatigue import FITTED_RANGE_S, FatigueModel
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import report_document, write_html
from platoon_osm.report.document.driver_fatigue import fatigue_along
from platoon_osm.report.document.findings import find

Visit = Callable[..., Any]

browser = pytest.mark.browser


@pytest.fixture(scope="module")
def page_file(plan: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("journey") / "plan.html"
    write_html(plan, net, path)
    return path


@pytest.mark.parametrize("which", ["plan", "two", "many"])
def test_vehicles_are_level_where_they_drive_together(
    which: str, net: RoadNetwork, request: pytest.FixtureRequest
) -> None:
    plan: JointPlan = request.getfixturevalue(which)
    found = find(plan, net)
    scale = found.scale
    assert scale is not None
    assert min(scale.starts_m) == 0
    for section in found.platoons:
        levels = []
        for index in section.vehicles:
            edges = plan.vehicles[index].edges
            before = edges[: edges.index(section.edges[0])]
            levels.append(scale.starts_m[index] + sum(net.length_m[edge] for edge in before))
        assert max(levels) - min(levels) < 1


@pytest.mark.parametrize("which", ["plan", "two", "many"])
def test_ways_hold_every_metre(
    which: str, net: RoadNetwork, request: pytest.FixtureRequest
) -> None:
    plan: JointPlan = request.getfixturevalue(which)
    document = report_document(plan, net)
    for vehicle in document["vehicles"]:
        pieces = [
            document["platoons" if kind == "platoon" else "solos"][at]
            for kind, at in vehicle["way"]
        ]
        assert sum(piece["length_m"] for piece in pieces) == pytest.approx(vehicle["length_m"])
    assert [kind for kind, _ in find(plan, net).ways[0]].count("solo") <= 2


def test_no_scale_where_ways_between_two_meetings_differ(plan: JointPlan, net: RoadNetwork) -> None:
    """Were B's two sections apart by another length than A's, no scale would be true of both."""
    member = plan.vehicles[1]
    edges = member.legs[0].edges[:3]
    length_m = float(net.length_m[list(edges)].sum())
    detour = replace(member.legs[0], edges=edges, length_m=length_m)
    first, second = (leg for leg in member.legs if leg.role == "platoon")
    broken = replace(member, legs=(first, detour, second))
    other = with_vehicles(plan, (plan.vehicles[0], broken, *plan.vehicles[2:]))
    assert find(other, net).scale is None


def test_no_times_are_invented(page_file: Path) -> None:
    text = page_file.read_text()
    body = re.sub(r"<(script|style).*?</\1>|<!--.*?-->", "", text, flags=re.S)
    shown = re.sub("<[^>]+>", " ", body)
    assert not re.findall(r"\b\d?\d:\d\d\b", shown)
    assert "sets no times" in shown


# -- in the browser --------------------------------------------------------------------------------

MOVED = """() => {
  const found = {};
  map_plan.eachLayer(layer => {
    if (layer.options.icon?.options.className !== 'mark moving') return;
    found[layer.getElement().textContent] = [layer.getLatLng().lng, layer.getLatLng().lat];
  });
  return found;
}"""

SLIDE = """metres => {
  const slider = document.querySelector('.journey input');
  slider.value = metres / 1000;
  slider.dispatchEvent(new Event('input'));
}"""


@browser
def test_vehicles_stand_at_the_point_where_they_merge_or_part(
    page_file: Path, plan: JointPlan, net: RoadNetwork, visit: Visit
) -> None:
    opened = visit(page_file)
    page = opened.page
    events = report_document(plan, net)["events"]
    assert len(events) >= 4
    for event in events:
        page.evaluate(SLIDE, event["at_m"])
        found = page.evaluate(MOVED)
        letters = [plan.vehicles[i].vehicle for i in (*event["vehicles"], *event["others"])]
        for letter in letters:
            # The scale is kept to 0.1 m, drawn lines to 8 m.
            place = pytest.approx((event["lon"], event["lat"]), abs=2e-4)
            assert found[letter] == place, (letter, event["at_m"])
    opened.check(page_file)


@browser
def test_half_way_along_its_route(page_file: Path, plan: JointPlan, visit: Visit) -> None:
    """Far from any junction of lines a vehicle is where its length says, within 1 km."""
    page = visit(page_file).page
    master = plan.vehicles[0]
    page.evaluate(SLIDE, page.evaluate(
        "JSON.parse(document.getElementById('plan-data').textContent).journey.starts_m[0]"
    ) + master.length_m / 2)  # fmt: skip
    lon, lat = page.evaluate(MOVED)[master.vehicle]
    assert 10.3 < lon < 11.2
    assert 45.3 < lat < 45.7


@browser
def test_slider_by_keyboard_and_play(page_file: Path, visit: Visit) -> None:
    opened = visit(page_file)
    page = opened.page
    slider = page.get_by_role("slider", name="Distance driven")
    assert page.locator(".mark.moving").count() == 0
    slider.focus()
    for _ in range(40):
        page.keyboard.press("ArrowRight")
    assert page.locator(".mark.moving").count() == 3
    text = page.locator(".journey output").inner_text()
    assert text.startswith("A at km ")
    assert slider.get_attribute("aria-valuetext") == text
    assert page.locator(".along .cursor.on").count() == 1
    page.keyboard.press("End")
    assert page.locator(".mark.moving").count() == 0
    play = page.get_by_role("button", name="Play the journey")
    play.focus()
    page.keyboard.press("Enter")
    page.locator(".mark.moving").first.wait_for()
    page.get_by_role("button", name="Pause the journey").click()
    at = slider.input_value()
    page.wait_for_timeout(100)
    assert slider.input_value() == at
    opened.check(page_file)


@browser
def test_a_hidden_vehicle_does_not_move(page_file: Path, visit: Visit) -> None:
    page = visit(page_file).page
    page.evaluate(SLIDE, 250_000)
    assert set(page.evaluate(MOVED)) == {"A", "B", "C"}
    page.locator('[data-layer="vehicle-1"]').uncheck()
    assert set(page.evaluate(MOVED)) == {"A", "C"}


# -- fatigue ---------------------------------------------------------------------------------------


def test_fatigue_is_that_of_the_model(plan: JointPlan) -> None:
    vehicle = plan.vehicles[1]
    found = fatigue_along(vehicle)
    solo_s = sum(leg.time_s for leg in vehicle.legs if leg.role == "solo")
    model = FatigueModel("monotone", task_relief=1.0)
    assert found.joint_peak == pytest.approx(
        float(model.along([min(solo_s, FITTED_RANGE_S[1])])[0]), abs=0.01
    )
    assert found.joint_peak <= found.alone_peak
    assert found.joint.hours[-1] == pytest.approx(vehicle.time_s / 3600, abs=1e-3)
    assert found.alone.beyond == (vehicle.alone.time_s > FITTED_RANGE_S[1])


@browser
def test_fatigue_chart_notes_its_range(page_file: Path, visit: Visit) -> None:
    page = visit(page_file).page
    chart = page.get_by_role("img", name="Highest fatigue")
    assert chart.locator("polyline").count() == 6
    assert "Beyond 4 h 30 of driving the last value is kept." in page.locator("#panel").inner_text()
