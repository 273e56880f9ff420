"""The page in Firefox, where the system has one, with the network cut."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from marionette import FIREFOX, Firefox
from page_boxes import MAP_FAULTS
from plan_kinds import plan_kind

from platoon_osm.report import (
    report_document,
    write_comparison,
    write_flows,
    write_html,
    write_sheets,
)

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def firefox() -> Iterator[Firefox]:
    if not Path(FIREFOX).exists():
        pytest.skip(f"no Firefox at {FIREFOX}")
    with Firefox() as found:
        yield found


@pytest.mark.parametrize("kind", ["three vehicles", "fifty vehicles", "a tall country"])
def test_firefox_shows_a_plan(firefox: Firefox, kind: str, tmp_path: Path) -> None:
    plan, net = plan_kind(kind)
    path = tmp_path / "plan.html"
    write_html(plan, net, path)
    for width, height in ((1440, 900), (700, 900)):
        firefox.open(path.as_uri(), width, height)
        assert firefox.evaluate("() => document.querySelector('#map_plan').dataset.ready") == "true"
        assert firefox.evaluate(MAP_FAULTS) == []
        asked = firefox.evaluate("() => performance.getEntriesByType('resource').map(e => e.name)")
        assert asked == []
    # Marks of events stand where the plan says.
    events = report_document(plan, net)["events"]
    places = firefox.evaluate(
        """() => {
          const found = [];
          map_plan.eachLayer(layer => {
            if (layer.options.icon?.options.className !== 'mark event-mark') return;
            found.push([layer.getLatLng().lng, layer.getLatLng().lat]);
          });
          return found;
        }"""
    )
    wanted = [[event["lon"], event["lat"]] for event in events]
    if len(plan.vehicles) <= 8:
        assert sorted(places) == sorted(wanted)
    else:
        # Of a crowd, events near one another are one mark at the place of one of them.
        assert places
        assert all(place in wanted for place in places)


def test_firefox_allows_all_that_the_page_does(firefox: Firefox, tmp_path: Path) -> None:
    """Neither script nor style meets the policy, and nothing fails."""
    plan, net = plan_kind("three vehicles")
    page = tmp_path / "plan.html"
    write_html(plan, net, page)
    firefox.open(page.as_uri(), 1200, 800)
    # Scripts ran to their end, styles are in force, and the slider moves a vehicle.
    told = firefox.evaluate(
        """() => {
          const slider = document.querySelector('.journey input');
          slider.value = 200;
          slider.dispatchEvent(new Event('input'));
          return [
            document.querySelectorAll('.mark.moving').length > 0,
            getComputedStyle(document.querySelector('.figures')).display,
            getComputedStyle(document.querySelector('.leaflet-pane')).position,
          ];
        }"""
    )
    assert told == [True, "grid", "absolute"]


def test_firefox_shows_the_other_pages(firefox: Firefox, tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    write_flows(plan, net, tmp_path / "flows.html")
    write_comparison([plan, plan], net, tmp_path / "compare.html")
    write_sheets(plan, net, tmp_path / "sheets.html")
    for name in ("flows", "compare", "sheets"):
        firefox.open((tmp_path / f"{name}.html").as_uri(), 1200, 800)
        wide = firefox.evaluate(
            "() => document.documentElement.scrollWidth - document.documentElement.clientWidth"
        )
        assert wide <= 0
    # A driver's page each, with the map drawn, in a page that has no script at all.
    shown = firefox.evaluate(
        """() => [...document.querySelectorAll('.sheet')].map((sheet) => [
          sheet.getBoundingClientRect().height > 900,
          sheet.querySelector('h1').textContent,
          [...sheet.querySelectorAll('svg path')].some((path) => path.getTotalLength() > 100),
        ])"""
    )
    assert shown == [[True, vehicle.vehicle, True] for vehicle in plan.vehicles]
    assert firefox.evaluate("() => document.scripts.length") == 0
