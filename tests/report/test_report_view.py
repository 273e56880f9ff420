"""What is looked at: fitted anew until the reader moves the map, and kept in the address."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hostile_names import HOSTILE
from page_boxes import MAP_FAULTS, Pages
from plan_kinds import plan_kind
from soak import chosen, soaked

from platoon_osm.report import explore

pytestmark = pytest.mark.browser

VIEW = "() => [map_plan.getZoom(), map_plan.getCenter().lat, map_plan.getCenter().lng]"


@pytest.fixture(scope="module")
def pages(chromium: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Pages]:
    context = chromium.new_context(offline=True)
    context.set_default_timeout(20_000)
    yield Pages(context.new_page(), tmp_path_factory.mktemp("view"))
    context.close()


# -- the fit ---------------------------------------------------------------------------------------


def test_a_plan_is_as_large_as_its_frame_allows(pages: Pages) -> None:
    """It touches the room it has on two sides, or could not grow for what covers it."""
    for kind, size in (("three vehicles", (1440, 900)), ("a tall country", (390, 844))):
        page = pages.open(kind, size)
        shares = page.evaluate(
            """() => {
              const view = map_plan.getSize();
              const boxes = [...document.querySelectorAll('.mark.end')]
                .map(e => e.getBoundingClientRect());
              const span = (low, high) => Math.max(...boxes.map(b => b[high]))
                - Math.min(...boxes.map(b => b[low]));
              return [span('left', 'right') / view.x, span('top', 'bottom') / view.y];
            }"""
        )
        assert max(shares) > 0.75, kind


def test_a_moved_map_keeps_its_middle_when_the_frame_changes(pages: Pages) -> None:
    page = pages.open("three vehicles", (1440, 900))
    page.evaluate("() => { map_plan.setView([45.2, 9.5], 9, { animate: false }); }")
    for size in ((1100, 700), (700, 900), (390, 844), (1440, 900)):
        pages.resize(size)
        zoom, lat, lon = page.evaluate(VIEW)
        assert zoom == 9
        assert lat == pytest.approx(45.2, abs=0.01)
        assert lon == pytest.approx(9.5, abs=0.01)
        assert page.evaluate("map_plan.getSize().x") == page.evaluate(
            "map_plan.getContainer().clientWidth"
        )
    page.locator(".whole").click()
    assert page.evaluate(MAP_FAULTS) == []
    pages.resize((390, 844))
    assert page.evaluate(MAP_FAULTS) == []


@pytest.mark.parametrize("kind", ["three vehicles", "fifty vehicles", "one platoon of fifty"])
def test_the_legend_opens_and_closes_without_covering_the_plan(pages: Pages, kind: str) -> None:
    """It starts closed where the plan would be small beside it; who opens it moves the plan."""
    page = pages.open(kind, (1440, 900))
    for _ in range(2):
        page.locator(".legend-button").click()
        assert page.evaluate(MAP_FAULTS) == []
        expanded = page.locator(".legend-button").get_attribute("aria-expanded") == "true"
        assert page.locator(".legend").is_visible() == expanded


@soaked
@pytest.mark.parametrize("kind", ["three vehicles", "fifty vehicles"])
def test_a_plan_fits_the_frame_of_a_notebook(pages: Pages, kind: str, tmp_path: Path) -> None:
    page = pages.page
    path = tmp_path / "notebook.html"
    shown = explore(*plan_kind(kind), title="Title & <b>names</b>")._repr_html_()
    path.write_text(f'<!DOCTYPE html><html lang="en"><body>{shown}</body></html>')
    few = (420, 1000) if kind == "three vehicles" else (760,)
    for width in chosen(few, (420, 760, 1000)):
        page.set_viewport_size({"width": width, "height": 800})
        page.goto(path.as_uri())
        frame = page.frames[1]
        frame.wait_for_selector("#map_plan[data-ready]")
        assert frame.evaluate("innerHeight") == 640
        assert frame.evaluate(MAP_FAULTS) == []
    assert page.locator("iframe").get_attribute("title") == "Title & <b>names</b>"
    # An address cannot be kept there, and nothing is said of it.
    frame.evaluate("() => { map_plan.panBy([40, 0], { animate: false }); }")
    page.wait_for_timeout(700)
    assert pages.complaints == []


# -- lines as the map moves ------------------------------------------------------------------------

PHASES = """() => {
  const routes = [];
  map_plan.eachLayer((layer) => {
    if (layer.options.dashArray && layer.getElement?.()) routes.push(layer);
  });
  // The longest of them is followed, a quarter of a view at a time.
  const long = (layer) => layer.getElement().getTotalLength();
  const way = routes.sort((a, b) => long(b) - long(a))[0].getLatLngs();
  const apart = (a, b) => Math.hypot(b.x - a.x, b.y - a.y);
  const sums = (texts) => texts.reduce((sum, one) => sum + parseFloat(one), 0);
  const phases = (at) => routes.map((layer) => {
    const path = layer.getElement();
    const style = getComputedStyle(path);
    const period = sums(style.strokeDasharray.split(","));
    const points = path.getAttribute("d").match(/-?[\\d.]+ -?[\\d.]+/g)
      .map((text) => L.point(text.split(" ").map(Number)));
    let [arc, found, least] = [0, null, 60];
    for (let i = 1; i < points.length; i++) {
      const near = L.LineUtil.closestPointOnSegment(at, points[i - 1], points[i]);
      const away = apart(near, at);
      if (away < least) [least, found] = [away, arc + apart(points[i - 1], near)];
      arc += apart(points[i - 1], points[i]);
    }
    return found === null ? null : [found + parseFloat(style.strokeDashoffset), period];
  });
  map_plan.setView(way[0], 13, { animate: false });
  const jumps = [];
  let at = map_plan.getCenter();
  for (const next of way.slice(1)) {
    const far = apart(map_plan.latLngToLayerPoint(at), map_plan.latLngToLayerPoint(next));
    const steps = Math.ceil(far / (map_plan.getSize().x / 4));
    const from = at;
    for (let step = 1; step <= steps && jumps.length < 120; step++) {
      const before = phases(map_plan.latLngToLayerPoint(at));
      const old = map_plan.latLngToLayerPoint(at);
      at = L.latLng(from.lat + (next.lat - from.lat) * step / steps,
        from.lng + (next.lng - from.lng) * step / steps);
      map_plan.panTo(at, { animate: false });
      phases(old).forEach((now, i) => {
        if (!now || !before[i]) return;
        const moved = (now[0] - before[i][0]) / now[1];
        jumps.push(Math.abs(moved - Math.round(moved)) * now[1]);
      });
    }
  }
  return jumps;
}"""
"""By how many pixels dashes move along a road near the middle of the view, each time it pans."""


def test_dashes_keep_their_place_when_the_map_is_moved(pages: Pages) -> None:
    jumps = pages.open("three vehicles", (390, 844)).evaluate(PHASES)
    assert len(jumps) >= 100
    # Points are drawn in whole pixels, so the length of a bend is not quite the same every time.
    assert max(jumps) < 2


# -- the address -----------------------------------------------------------------------------------


def test_the_address_tells_what_is_looked_at(pages: Pages) -> None:
    page = pages.open("three vehicles", (1440, 900))
    page.evaluate("() => { map_plan.setView([45.25, 9.5], 9.5, { animate: false }); }")
    page.evaluate(
        """() => {
          const slider = document.querySelector('.journey input');
          slider.value = 100;
          slider.dispatchEvent(new Event('input'));
        }"""
    )
    page.wait_for_function("() => location.hash.includes('moment')")
    fragment = page.evaluate("location.hash")
    assert fragment.startswith("#map=9.5/45.2")
    assert "moment=6000" in fragment
    said = page.locator(".journey output").inner_text()
    page = pages.open("three vehicles", (900, 700), fragment)
    zoom, lat, lon = page.evaluate(VIEW)
    assert (zoom, lat, lon) == (9.5, pytest.approx(45.25, abs=1e-3), pytest.approx(9.5, abs=1e-3))
    assert page.locator(".journey output").inner_text() == said
    # The whole plan at the beginning is not worth an address.
    page.locator(".whole").click()
    page.evaluate("location.hash = '#moment=0'")
    page.evaluate("() => { map_plan.fire('viewchange'); }")
    page.wait_for_function("() => location.hash === ''")


def test_the_page_follows_its_address(pages: Pages) -> None:
    page = pages.open("three vehicles", (1440, 900))
    page.evaluate("location.hash = '#map=10/45.4/9.2&moment=7200'")
    page.wait_for_function("() => map_plan.getZoom() === 10")
    assert page.evaluate(VIEW)[1:] == [pytest.approx(45.4, abs=1e-3), pytest.approx(9.2, abs=1e-3)]
    assert page.evaluate("document.querySelector('.journey input').value") == "120"


def test_an_address_that_names_no_view_is_ignored(pages: Pages) -> None:
    page = pages.open("three vehicles", (1440, 900))
    before = page.evaluate(VIEW)
    said = page.locator(".journey output").inner_text()
    # A browser hears no more than 200 changes of an address in ten seconds.
    draw = random.Random(4)
    hostile = [name.encode("utf-8", "replace").decode() for name in HOSTILE]
    letters = "map=moment&/.-0123456789eE+#%<>'\"()\u202e\u00e9 "
    made = ["".join(draw.choices(letters, k=draw.randint(1, 40))) for _ in range(40)]
    near = [
        "map=", "map=8", "map=8/45", "map=8/45/9/1", "map=99/45/9", "map=-1/45/9", "map=8/95/9",
        "map=8/45/181",
        "map=18.5/45/9", "map=NaN/NaN/NaN", "map=8/1e1/9", "map=Infinity/0/0", "map=8/45/9x",
        "map=0x8/45/9", "map= 8/45/9", "moment=-5", "moment=1e3", "moment=0.5", "moment=x",
        "moment=99999999999", "__proto__=1", "constructor=1", "toString=1", "map[]=8/45/9",
        "map=8/45/9" + "0" * 400, "panel", "map=8%2F45%2F9",
    ]  # fmt: skip
    found = page.evaluate(
        """async fragments => {
          const odd = [];
          const before = JSON.stringify([map_plan.getZoom(), map_plan.getCenter()]);
          for (const fragment of fragments) {
            const heard = new Promise(done => addEventListener('hashchange', done, { once: true }));
            const old = location.href;
            location.hash = fragment;
            if (location.href !== old) await heard;
            if (JSON.stringify([map_plan.getZoom(), map_plan.getCenter()]) !== before) {
              odd.push(fragment);
            }
          }
          return odd;
        }""",
        [*near, *made, *hostile],
    )
    assert found == []
    assert page.evaluate(VIEW) == before
    assert page.locator(".journey output").inner_text() == said
    assert page.evaluate("window.hacked") is None
    assert pages.complaints == []
