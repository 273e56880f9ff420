"""The page for many vehicles: flows, the list of platoons, the histogram."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from po_valley import make_plan

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import flow_document, write_flows
from platoon_osm.report.pages.flows import CLASSES, flow_class

Visit = Callable[..., Any]

browser = pytest.mark.browser


@pytest.fixture(scope="module")
def page_file(two: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("flows") / "flows.html"
    write_flows(two, net, path)
    return path


@pytest.mark.parametrize("which", ["plan", "two", "many"])
def test_flows_count_every_vehicle_on_every_edge(
    which: str, net: RoadNetwork, request: pytest.FixtureRequest
) -> None:
    plan: JointPlan = request.getfixturevalue(which)
    document = flow_document(plan, net)
    driven = sum(flow["vehicles"] * flow["length_m"] for flow in document["flows"])
    assert driven == pytest.approx(sum(vehicle.length_m for vehicle in plan.vehicles))
    used = Counter(edge for vehicle in plan.vehicles for edge in set(vehicle.edges))
    assert document["most"] == max(used.values())
    assert {flow["vehicles"] for flow in document["flows"]} == set(used.values())


@pytest.mark.parametrize("which", ["plan", "two", "many"])
def test_histogram_holds_every_vehicle_in_its_bin(
    which: str, net: RoadNetwork, request: pytest.FixtureRequest
) -> None:
    plan: JointPlan = request.getfixturevalue(which)
    found = flow_document(plan, net)["histogram"]
    assert sum(found["counts"]) == len(plan.vehicles)
    for place, count in enumerate(found["counts"]):
        low = (found["first"] + place) * found["step"] - 1e-8
        inside = [v for v in plan.vehicles if low <= v.saving < low + found["step"]]
        assert len(inside) == count


def test_nobody_saves_anything(net: RoadNetwork, tmp_path: Path) -> None:
    plan = make_plan(net, [("A", "Torino", "Trieste", None, None)])
    write_flows(plan, net, tmp_path / "alone.html")
    assert flow_document(plan, net)["histogram"]["counts"] == [1]


def test_classes_grow_with_flow() -> None:
    for most in (1, 2, 7, 50, 4000):
        classes = [flow_class(vehicles, most) for vehicles in range(1, most + 1)]
        assert classes == sorted(classes)
        assert classes[-1] == CLASSES - 1


def test_same_plan_same_bytes(
    two: JointPlan, net: RoadNetwork, page_file: Path, tmp_path: Path
) -> None:
    write_flows(two, net, tmp_path / "again.html")
    assert (tmp_path / "again.html").read_bytes() == page_file.read_bytes()


def shown_names(page: Any) -> list[str]:
    names: list[str] = page.locator(".list tbody tr:visible summary b").all_inner_texts()
    return names


@browser
def test_the_list_sorts_and_filters_by_keyboard(page_file: Path, visit: Visit) -> None:
    opened = visit(page_file, wait_for="html[data-ready]")
    page = opened.page
    assert shown_names(page) == ["Platoon 1", "Platoon 2"]
    page.get_by_role("button", name="Saved").focus()
    page.keyboard.press("Enter")
    assert shown_names(page) == ["Platoon 2", "Platoon 1"]
    head = page.get_by_role("columnheader", name="Saved")
    assert head.get_attribute("aria-sort") == "descending"
    page.keyboard.press("Enter")
    assert head.get_attribute("aria-sort") == "ascending"
    assert shown_names(page) == ["Platoon 1", "Platoon 2"]
    page.get_by_role("searchbox").fill("chiasso")
    assert shown_names(page) == ["Platoon 1"]
    assert page.locator(".filter output").inner_text() == "1 of 2 platoons"
    page.get_by_role("searchbox").fill("")
    page.get_by_role("spinbutton").fill("4")
    assert shown_names(page) == []
    opened.check(page_file)


@browser
def test_a_platoon_shows_its_road(page_file: Path, visit: Visit) -> None:
    page = visit(page_file, wait_for="html[data-ready]").page
    roads = page.locator(".platoon-road")
    assert [roads.nth(i).is_visible() for i in range(2)] == [False, False]
    page.locator(".list summary").nth(1).focus()
    assert [roads.nth(i).is_visible() for i in range(2)] == [False, True]
    page.keyboard.press("Enter")
    assert page.locator(".members:visible li").count() == 3


MAP = """() => {
  const svg = document.querySelector('.static-map svg');
  const frame = svg.getBoundingClientRect();
  const ground = svg.querySelector('.ground');
  const b = ground.getBoundingClientRect();
  const [left, top] = [b.left - frame.left, b.top - frame.top];
  const map = document.querySelector('.map').getBoundingClientRect();
  return {
    ground: [left, top, frame.right - b.right, frame.bottom - b.bottom],
    scale: svg.getScreenCTM().a,
    empty: map.height - frame.height,
  };
}"""
"""How far the ground lies inside each edge of its frame, and the scale of its texts."""


@browser
@pytest.mark.parametrize("width", [1440, 1100, 900, 390])
def test_layout(page_file: Path, visit: Visit, width: int) -> None:
    opened = visit(page_file, width, 900, wait_for="html[data-ready]")
    for size in ((width, 900), (width, 1300), (width, 500)):
        opened.page.set_viewport_size({"width": size[0], "height": size[1]})
        shown = opened.page.evaluate(MAP)
        assert max(shown["ground"]) <= 0, size
        assert width < 600 or (shown["scale"] > 0.7 and shown["empty"] < 1), size
    assert opened.page.evaluate("document.documentElement.scrollWidth") <= width
    assert opened.page.locator("#panel").evaluate("e => e.scrollWidth <= e.clientWidth")
    opened.check(page_file)


@browser
def test_without_javascript_all_is_listed(page_file: Path, visit: Visit) -> None:
    opened = visit(page_file, java_script_enabled=False)
    assert shown_names(opened.page) == ["Platoon 1", "Platoon 2"]
    assert not opened.page.locator(".filter").is_visible()
    opened.check(page_file)


@browser
@pytest.mark.parametrize("width", [1440, 390])
def test_names_are_legible(page_file: Path, visit: Visit, width: int) -> None:
    page = visit(page_file, width, 900, wait_for="html[data-ready]").page
    sizes = page.evaluate(
        """[...document.querySelectorAll('.names text')]
          .filter(e => e.getBoundingClientRect().width)
          .map(e => e.getScreenCTM().a * parseFloat(getComputedStyle(e).fontSize))"""
    )
    assert len(sizes) > 8
    assert min(sizes) > 9.4
