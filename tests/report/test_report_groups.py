"""Several platoons at once, and more vehicles than one table can hold."""

from __future__ import annotations

import re
from collections.abc import Callable
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from bundled import italy as italy_map
from po_valley import fifty, make_plan
from soak import chosen, soaked

import platoon_osm
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import report_document, write_html
from platoon_osm.report.document.document import document_of
from platoon_osm.report.document.findings import find
from platoon_osm.report.maps.lanes import bands_width
from platoon_osm.report.markup.fragments import NOTHING, written
from platoon_osm.report.pages.panel import page_body

Visit = Callable[..., Any]

browser = pytest.mark.browser


@pytest.fixture(scope="module")
def two_file(two: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("groups") / "two.html"
    write_html(two, net, path)
    return path


@pytest.fixture(scope="module")
def many_file(many: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("groups") / "many.html"
    write_html(many, net, path)
    return path


def test_groups_are_vehicles_linked_by_company(two: JointPlan, net: RoadNetwork) -> None:
    assert find(two, net).groups == ((0, 1, 2), (3, 4, 5))


def test_groups_add_up(two: JointPlan, net: RoadNetwork) -> None:
    document = report_document(two, net)
    groups = document["groups"]
    assert [(group["name"], group["vehicles"]) for group in groups] == [
        ("Platoon 1", [0, 1, 2]), ("Platoon 2", [3, 4, 5]), ("Driving alone", [6]),
    ]  # fmt: skip
    assert sum(group["saved"] for group in groups) == pytest.approx(two.solo_cost - two.joint_cost)
    assert sum(group["road_m"] for group in groups) == pytest.approx(
        document["totals"]["platoon_road_m"]
    )
    assert document["subtitle"].startswith("7 vehicles, 2 platoons, ")


def test_bands_on_one_road_lie_side_by_side(two: JointPlan, net: RoadNetwork) -> None:
    """On every edge the bands' lanes are those of all sections there, each once."""
    lanes: dict[int, list[tuple[int, tuple[int, ...]]]] = {}
    found = find(two, net)
    for section, parts in zip(found.platoons, found.platoon_parts, strict=True):
        assert tuple(edge for part in parts for edge in part.edges) == section.edges
        for part in parts:
            assert part.beside[part.place] == len(section.vehicles)
            for edge in part.edges:
                lanes.setdefault(edge, []).append((part.place, part.beside))
    assert max(len(found) for found in lanes.values()) == 2
    for found in lanes.values():
        assert sorted(place for place, _ in found) == list(range(len(found)))
        assert len({beside for _, beside in found}) == 1


@browser
def test_no_band_covers_another(two_file: Path, visit: Visit) -> None:
    """Where two platoons share a road, both bands show, at the distance of their widths."""
    page = visit(two_file).page
    gap = page.evaluate(
        """() => {
          const bands = [...document.querySelectorAll('#map_plan path[stroke="#ffd54a"]')];
          const boxes = bands.map(e => e.getBBox());
          const points = (path) => {
            const n = path.getTotalLength();
            return Array.from({ length: Math.floor(n) }, (_, s) => path.getPointAtLength(s));
          };
          // Halfway from Brescia to Verona both platoons are there, with three vehicles each.
          const x = map_plan.latLngToLayerPoint([45.5, 10.55]).x;
          const here = bands.filter((e, i) => boxes[i].x < x && boxes[i].x + boxes[i].width > x);
          const [a, b] = here.map(points);
          const from = a.reduce((best, p) => Math.abs(p.x - x) < Math.abs(best.x - x) ? p : best);
          const far = Math.min(...b.map(p => Math.hypot(p.x - from.x, p.y - from.y)));
          return [far, ...here.map(e => +e.getAttribute('stroke-width'))];
        }"""
    )
    assert gap[1:] == [24, 24]
    assert gap[0] == pytest.approx(bands_width([3]), abs=2)


@browser
@pytest.mark.parametrize("width", [1440, 390])
def test_no_mark_strays_from_its_place(two_file: Path, visit: Visit, width: int) -> None:
    """Marks that would cover one another are moved aside, but never far."""
    page = visit(two_file, width, 844).page
    moves = page.evaluate(
        """[...document.querySelectorAll('#map_plan .mark')].map(e => Math.hypot(
          parseFloat(e.style.marginLeft) + e.offsetWidth / 2,
          parseFloat(e.style.marginTop) + e.offsetHeight / 2))"""
    )
    assert len(moves) == 21
    assert max(moves) < 60 + (width < 600) * 20


@browser
@pytest.mark.parametrize(("width", "height"), [(1440, 900), (390, 844)])
def test_panel_is_grouped(two_file: Path, visit: Visit, width: int, height: int) -> None:
    opened = visit(two_file, width, height)
    page = opened.page
    heads = page.locator(".group > summary b").all_inner_texts()
    assert heads == ["Platoon 1", "Platoon 2", "Driving alone"]
    assert page.locator(".group[open]").count() == 2
    assert page.locator(".overview tbody tr").count() == 3
    assert page.locator(".group").nth(1).locator(".event").count() == 3
    page.locator(".group > summary").last.focus()
    page.keyboard.press("Enter")
    assert page.locator(".group[open]").count() == 3
    assert page.locator("#panel").evaluate("e => e.scrollWidth <= e.clientWidth")
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    opened.check(two_file)


@browser
def test_closed_groups_are_printed(two_file: Path, visit: Visit) -> None:
    page = visit(two_file).page
    page.locator(".group > summary").first.click()
    page.emulate_media(media="print")
    assert page.get_by_text("Torino").first.bounding_box()["height"] > 0
    assert page.locator(".group").first.locator(".costs").bounding_box()["height"] > 50


def test_ids_are_used_once(two_file: Path) -> None:
    text = re.sub(r"<script.*?</script>", "", two_file.read_text(), flags=re.S)
    ids = re.findall(r'\sid="([^"]+)"', text)
    assert len(ids) == len(set(ids))


# -- legend ----------------------------------------------------------------------------------------


@browser
def test_legend_hides_a_platoon_by_keyboard(two_file: Path, visit: Visit) -> None:
    opened = visit(two_file)
    page = opened.page
    count = "name => document.querySelectorAll(name).length"
    bands = page.evaluate(count, '#map_plan path[stroke="#ffd54a"]')
    head = page.get_by_role("checkbox", name="Platoon 2")
    head.focus()
    page.keyboard.press("Space")
    left = page.evaluate(count, '#map_plan path[stroke="#ffd54a"]')
    assert 0 < left < bands
    boxes = [page.locator(f'[data-layer="vehicle-{index}"]') for index in range(7)]
    assert [box.is_checked() for box in boxes] == [True, True, True, False, False, False, True]
    # One of its vehicles back: the head is undecided, and the bands it drives in are there.
    boxes[4].check()
    assert head.evaluate("e => [e.checked, e.indeterminate]") == [True, True]
    assert page.evaluate(count, '#map_plan path[stroke="#ffd54a"]') > left
    head.focus()
    page.keyboard.press("Space")
    page.keyboard.press("Space")
    assert head.evaluate("e => [e.checked, e.indeterminate]") == [True, False]
    assert page.evaluate(count, '#map_plan path[stroke="#ffd54a"]') == bands
    opened.check(two_file)


@browser
def test_bands_shown_again_lie_under_their_lines(two_file: Path, visit: Visit) -> None:
    page = visit(two_file).page
    drawn = """[...document.querySelectorAll('.leaflet-platoons-pane path')]
      .map(e => e.getAttribute('stroke') === '#ffd54a' ? 'band'
        : e.getAttribute('stroke') === '#8a6a00' ? 'casing' : 'line')"""
    before = page.evaluate(drawn)
    page.get_by_role("checkbox", name="Platoon 1").click()
    page.get_by_role("checkbox", name="Platoon 1").click()
    assert page.evaluate(drawn) == before


@browser
@pytest.mark.parametrize("width", [1440, 390])
def test_legend_of_a_crowd_is_grouped(many_file: Path, visit: Visit, width: int) -> None:
    opened = visit(many_file, width, 900)
    page = opened.page
    if width == 390:
        page.get_by_role("button", name="Legend").click()
    assert page.locator(".legend-group").count() == 2
    first = page.locator('[data-layer="vehicle-1"]')
    assert not first.is_visible()
    page.locator(".legend-crowd > summary").click()
    page.locator(".legend-vehicles > summary").first.focus()
    page.keyboard.press("Enter")
    assert first.is_visible()
    box = page.locator("#legend").bounding_box()
    assert box["y"] + box["height"] <= 900
    page.locator("[data-all-vehicles]").uncheck()
    assert page.locator("#map_plan .mark").count() == 0
    assert page.locator('#map_plan path[stroke="#ffd54a"]').count() == 0
    page.locator('[data-layer="vehicle-1"]').check()
    assert page.locator("#map_plan .mark.end").count() == 2
    page.keyboard.press("Escape")
    if width == 390:
        assert not page.locator("#legend").is_visible()
    opened.check(many_file)


# -- marks -----------------------------------------------------------------------------------------

MARKS = """() => [...document.querySelectorAll('#map_plan .mark')].map(e => {
  const b = e.getBoundingClientRect();
  return [b.left + b.width / 2, b.top + b.height / 2, b.width, e.getAttribute('aria-label')];
})"""


@browser
@pytest.mark.parametrize(("width", "most"), [(1440, 75), (390, 50)])
def test_a_crowd_is_counted_until_one_zooms_in(
    many_file: Path, visit: Visit, width: int, most: int
) -> None:
    page = visit(many_file, width, 844).page
    marks = page.evaluate(MARKS)
    assert 10 < len(marks) <= most
    # Every mark can be told from the others.
    for i, (x, y, size, label) in enumerate(marks):
        for other_x, other_y, _, other in marks[:i]:
            apart = max(abs(x - other_x), abs(y - other_y))
            assert apart > 0.6 * size, f"{label} covers {other}"
    # Every vehicle is in the label of one start and one destination.
    letters = [part for *_, label in marks for part in re.findall(r"\b[A-Z]{1,2}\b", label)]
    for index in range(50):
        letter = chr(65 + index) if index < 26 else "A" + chr(65 + index - 26)
        assert letters.count(letter) >= 2, letter
    few = page.locator("#map_plan .mark.end").count()
    page.evaluate("void map_plan.setZoom(10, {animate: false})")
    assert page.locator("#map_plan .mark.end").count() >= few


@browser
def test_merges_stand_where_they_are(two_file: Path, visit: Visit) -> None:
    """Starts and destinations make room for them, and are tied to their own places."""
    page = visit(two_file).page
    page.evaluate("void map_plan.setZoom(10, {animate: false})")
    moves = page.evaluate(
        """[...document.querySelectorAll('#map_plan .event-mark')].map(e => Math.hypot(
          parseFloat(e.style.marginLeft) + e.offsetWidth / 2,
          parseFloat(e.style.marginTop) + e.offsetHeight / 2))"""
    )
    # At Rho-Pero two merges share one spot: one of them stays.
    assert sum(move < 1 for move in moves) >= len(moves) - 2
    assert page.locator(".leaflet-ties-pane line").count() > 0


# -- print -----------------------------------------------------------------------------------------


def pages_of(page: Any) -> int:
    page.emulate_media(media="print")
    return len(re.findall(rb"/Type\s*/Page[^s]", page.pdf(prefer_css_page_size=True)))


def chart_type(page: Any) -> float:
    """The smallest type of the charts on A4, in points."""
    page.set_viewport_size({"width": round(184 / 25.4 * 96), "height": 1000})
    page.emulate_media(media="print")
    sizes = page.evaluate(
        """[...document.querySelectorAll('.panel svg:is(.bars, .along, .fatigue, .diagram) text')]
          .filter(e => e.checkVisibility())
          .map(e => parseFloat(getComputedStyle(e).fontSize) * e.getScreenCTM().a * 0.75)"""
    )
    # Credits are cut after some lines on a screen only.
    assert page.locator(".credit").evaluate("e => getComputedStyle(e).display") == "block"
    # A page wider than the paper is printed smaller, and all its type with it.
    assert page.evaluate("document.documentElement.scrollWidth") <= 696
    assert page.locator(".legend").evaluate("e => e.getBoundingClientRect().right") <= 696
    page.emulate_media(media="screen")
    return min(sizes, default=99.0)


@browser
@soaked
@pytest.mark.parametrize("vehicles", chosen([1, 9, 50], [1, 2, 8, 9, 20, 50]))
def test_any_plan_prints_on_two_pages(
    net: RoadNetwork, visit: Visit, tmp_path: Path, vehicles: int
) -> None:
    path = tmp_path / "plan.html"
    write_html(make_plan(net, fifty()[:vehicles]), net, path)
    page = visit(path).page
    assert pages_of(page) <= 2
    # Nothing is left out but charts that say what the tables say, and nothing is tiny.
    assert page.locator(".costs tbody tr:visible").count() >= vehicles
    assert page.locator(".legend label:visible").count() > vehicles
    assert page.locator(".event:visible").count() == page.locator(".event").count()
    sizes = page.evaluate(
        """[...document.querySelectorAll('.panel td, .panel th, .panel small, .panel li, .panel dd,'
          + '.legend .text')].filter(e => e.checkVisibility())
          .map(e => parseFloat(getComputedStyle(e).fontSize) * 0.75)"""
    )
    assert min(sizes) >= 6.4
    assert chart_type(page) >= 5.7
    assert page.evaluate("document.documentElement.scrollWidth") <= 1440


@browser
def test_several_platoons_print_on_two_pages(two_file: Path, visit: Visit) -> None:
    page = visit(two_file).page
    assert pages_of(page) <= 2
    assert page.locator(".along:visible").count() == 2


@browser
@soaked
@pytest.mark.parametrize("vehicles", chosen([3, 20], [3, 6, 8, 20]))
def test_a_plan_with_times_prints_on_two_pages(visit: Visit, tmp_path: Path, vehicles: int) -> None:
    net = italy_map()
    towns = ["Torino", "Trieste", "Milano", "Bologna", "Padova", "Verona", "Genova", "Brescia"]
    start = datetime(2026, 3, 2, 5, 0)
    trips = [
        platoon_osm.Trip(
            f"Truck {k + 1}",
            net.locate(towns[k % 8]),
            net.locate(towns[(k * 3 + 1) % 8]),
            earliest_departure=start + timedelta(minutes=7 * k),
        )
        for k in range(vehicles)
    ]
    plan = platoon_osm.plan_joint(net, platoon_osm.paper_weights(net), trips, case="C")
    path = tmp_path / "timed.html"
    write_html(plan, net, path)
    page = visit(path).page
    assert pages_of(page) <= 2
    assert chart_type(page) >= 5.7


def test_those_of_one_reason_share_a_note(many: JointPlan, net: RoadNetwork) -> None:
    alone = [v for v in report_document(many, net)["vehicles"] if v["role"] == "alone"]
    text = written(page_body(document_of(many, net), NOTHING))
    notes = re.findall(r"<span>([A-Z, ]+) stay alone: <bdi>", text)
    assert len(notes) == 1
    assert notes[0].split(", ") == [vehicle["letter"] for vehicle in alone]
