"""Roads driven both ways: the two directions are drawn beside each other, right of the middle."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from plans_by_legs import with_vehicles
from po_valley import THREE, Journey, make_plan

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import report_document, write_html
from platoon_osm.report.document.document import document_of
from platoon_osm.report.document.model_map import LanePart
from platoon_osm.report.document.opposite import opposite_gaps
from platoon_osm.report.drawing.lines import Line
from platoon_osm.report.maps.lanes import bands_width, solo_aside
from platoon_osm.report.maps.map_view import MapView

Visit = Callable[..., Any]

browser = pytest.mark.browser

DEGREE_M = 111_195.0

WEST: list[Journey] = [
    ("D", "Trieste", "Torino", None, None),
    ("E", "Udine Sud", "Bergamo", "Palmanova", "Bergamo"),
    ("F", "Belluno", "Savona", "Mestre", "Rho-Pero"),
]


@pytest.fixture(scope="module")
def both_ways(net: RoadNetwork) -> JointPlan:
    """Three vehicles eastward on a motorway, three westward, each a platoon."""
    east, west = make_plan(net, THREE), make_plan(net, WEST)
    return with_vehicles(east, (*east.vehicles, *west.vehicles))


@pytest.fixture(scope="module")
def page_file(
    both_ways: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory
) -> Path:
    path = tmp_path_factory.mktemp("opposite") / "both.html"
    write_html(both_ways, net, path)
    return path


def straight_roads(*ends: tuple[float, float, float, float]) -> RoadNetwork:
    """One edge for each (x, y) to (x, y), in metres near the equator."""
    flat = np.array(ends).reshape(-1, 2) / DEGREE_M
    tail = np.arange(0, len(flat), 2)
    return RoadNetwork.from_edges(tail, tail + 1, lon=flat[:, 0], lat=flat[:, 1])


def test_carriageways_find_each_other() -> None:
    net = straight_roads(
        (0, 0, 20_000, 0),  # 0: eastward
        (9_000, 40, 0, 40),  # 1: westward in two pieces, 40 m north of it
        (20_000, 40, 9_000, 40),  # 2
        (0, -60, 20_000, -60),  # 3: eastward too
        (10_000, 5_000, 10_000, -5_000),  # 4: across all of them
        (20_000, 900, 0, 900),  # 5: westward, but another road
    )
    assert opposite_gaps(net, range(6)) == {0: 0, 1: 0, 2: 0, 3: 100}
    # Only what is driven counts.
    assert opposite_gaps(net, [0, 3, 4, 5]) == {}
    assert opposite_gaps(net, [0, 1]) == {0: 0, 1: 0}
    assert opposite_gaps(net, [0]) == {}
    assert opposite_gaps(net, []) == {}


def test_the_document_tells_who_is_met(both_ways: JointPlan, net: RoadNetwork) -> None:
    document = report_document(both_ways, net)
    pieces = [*document["platoons"], *document["solos"]]
    met = [part["opposite_m"] for piece in pieces for part in piece["parts"]]
    assert 0 in met
    assert None in met
    alone = report_document(make_plan(net, THREE), net)
    assert {p["opposite_m"] for piece in alone["platoons"] for p in piece["parts"]} == {None}


def test_the_gap_of_the_map_counts(both_ways: JointPlan, net: RoadNetwork) -> None:
    view = MapView([document_of(both_ways, net)])
    part = LanePart(Line.rounded((), 1), slot=0, slots=1, bands=(), opposite_m=0)
    assert solo_aside(part, view) == pytest.approx(4.0)
    assert solo_aside(replace(part, opposite_m=None), view) == 0
    # A pixel is some 600 m here, so 300 m are half a pixel, a quarter on either side.
    assert 3.6 < solo_aside(replace(part, opposite_m=300), view) < 4.0


# Half the widths of two bands, and the distance of their middles, halfway along the motorway.
BANDS = """([selector, x]) => {
  const bands = [...document.querySelectorAll(selector)];
  const points = (path) => {
    const n = path.getTotalLength();
    return Array.from({ length: Math.floor(n) }, (_, s) => path.getPointAtLength(s));
  };
  const here = bands.filter(e => {
    const b = e.getBBox();
    return b.x < x && b.x + b.width > x;
  });
  const [a, b] = here.map(points);
  const from = a.reduce((best, p) => Math.abs(p.x - x) < Math.abs(best.x - x) ? p : best);
  const away = (p) => Math.hypot(p.x - from.x, p.y - from.y);
  const nearest = b.reduce((best, p) => away(p) < away(best) ? p : best);
  return {
    count: here.length, far: away(nearest),
    widths: here.map(e => +e.getAttribute('stroke-width')), below: from.y - nearest.y,
  };
}"""


@browser
@pytest.mark.parametrize("width", [1440, 390])
def test_bands_of_both_ways_lie_apart(page_file: Path, visit: Visit, width: int) -> None:
    opened = visit(page_file, width, 900)
    page = opened.page
    whole = page.evaluate("map_plan.getZoom()")
    for closer in (0, 2, 4):
        # Between Verona and Vicenza there is one platoon each way.
        page.evaluate(
            f"void map_plan.setView([45.47, 11.27], {whole} + {closer}, {{animate: false}})"
        )
        x = page.evaluate("map_plan.latLngToLayerPoint([45.47, 11.27]).x")
        found = page.evaluate(BANDS, ['#map_plan path[stroke="#ffd54a"]', x])
        assert found["count"] == 2, closer
        # Right of travel: the eastward band, drawn first, lies south of the westward one.
        assert found["below"] > 0, closer
        assert found["far"] >= sum(found["widths"]) / 2, closer
        assert found["far"] <= sum(found["widths"]) / 2 + 6, closer
    opened.check(page_file)


@browser
def test_bands_lie_apart_on_the_still_map(
    page_file: Path, both_ways: JointPlan, net: RoadNetwork, visit: Visit
) -> None:
    page = visit(page_file).page
    page.emulate_media(media="print")
    x, _ = MapView([document_of(both_ways, net)]).at(11.27, 45.47)
    # What frequent attributes say a class may say (markup/style_classes.py).
    page.evaluate(
        """() => {
          for (const path of document.querySelectorAll('.static-map path')) {
            const { stroke, strokeWidth } = getComputedStyle(path);
            if (stroke !== 'rgb(255, 213, 74)') continue;
            path.setAttribute('class', 'yellow');
            path.setAttribute('stroke-width', parseFloat(strokeWidth));
          }
        }"""
    )
    found = page.evaluate(BANDS, [".static-map .yellow", x])
    assert found["count"] == 2
    assert found["below"] > 0
    assert found["far"] == pytest.approx(bands_width([2, 2]) / 2, abs=7)
    assert found["far"] >= sum(found["widths"]) / 2
