"""Several platoons at once, and more vehicles than one table can hold."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.plans import JointPlan
from platoon_osm.report import report_document, write_html
from platoon_osm.report.map_view import bands_width
from platoon_osm.report.sections import platoon_groups, platoon_parts, platoon_sections

Visit = Callable[..., Any]

browser = pytest.mark.browser


@pytest.fixture(scope="module")
def two_file(two: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("groups") / "two.html"
    write_html(two, net, path)
    return path


def test_groups_are_vehicles_linked_by_company(two: JointPlan) -> None:
    assert platoon_groups(platoon_sections(two), len(two.vehicles)) == [(0, 1, 2), (3, 4, 5)]


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


def test_bands_on_one_road_lie_side_by_side(two: JointPlan) -> None:
    """On every edge the bands' lanes are those of all sections there, each once."""
    lanes: dict[int, list[tuple[int, tuple[int, ...]]]] = {}
    sections = platoon_sections(two)
    for section, parts in zip(sections, platoon_parts(sections), strict=True):
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
