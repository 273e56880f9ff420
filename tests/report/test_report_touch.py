"""A phone: taps on marks, tips that stay in the frame, one finger and two on the map."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from page_boxes import MAP_FAULTS, Pages
from soak import chosen, soaked

pytestmark = pytest.mark.browser

PHONES = ((390, 844), (320, 640), (844, 390))


@pytest.fixture(scope="module")
def pages(chromium: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Pages]:
    context = chromium.new_context(offline=True, has_touch=True, is_mobile=True)
    context.set_default_timeout(20_000)
    yield Pages(context.new_page(), tmp_path_factory.mktemp("touch"))
    context.close()


MARKS = """() => [...document.querySelectorAll('.mark.end, .mark.event-mark')].map((e) => {
  const b = e.getBoundingClientRect();
  return [b.left + b.width / 2, b.top + b.height / 2, e.getAttribute('aria-label')];
})"""

# A tip that is closed fades for a moment.
TIPS = """() => {
  const view = document.querySelector('#map_plan').getBoundingClientRect();
  return [...document.querySelectorAll('.leaflet-tooltip')]
    .filter((e) => e.style.opacity !== '0')
    .map((e) => {
      const b = e.getBoundingClientRect();
      const first = e.querySelector('.head') ?? e;
      return [first.textContent, b.left >= view.left && b.right <= view.right
        && b.top >= view.top && b.bottom <= view.bottom
        && [...e.querySelectorAll('*')].every((part) => {
          const c = part.getBoundingClientRect();
          return c.left >= b.left && c.right <= b.right && c.bottom <= b.bottom;
        })];
    });
}"""


def plain(text: str) -> str:
    return text.replace("\u2068", "").replace("\u2069", "")


@pytest.mark.parametrize("size", PHONES)
def test_a_tap_shows_the_tip_of_its_mark_and_scrolls_nothing(
    pages: Pages, size: tuple[int, int]
) -> None:
    """On the mark, or beside it as far as a finger misses; the tip lies in the frame."""
    page = pages.open("three vehicles", size)
    # Two taps in a row would be one double tap, which zooms.
    page.evaluate("() => { map_plan.doubleClickZoom.disable(); }")
    # What is chosen is said on the map, from under which the plan may move: ask for each mark anew.
    for number in range(len(page.evaluate(MARKS))):
        x, y, label = page.evaluate(MARKS)[number]
        page.touchscreen.tap(x, y)
        ((head, inside),) = page.evaluate(TIPS)
        assert plain(label).startswith(plain(head))
        assert inside, head
        assert page.evaluate("[scrollX, scrollY]") == [0, 0]
    assert page.evaluate(MAP_FAULTS) == []
    for number in range(len(page.evaluate(MARKS))):
        marks = page.evaluate(MARKS)
        x, y, label = marks[number]
        # A direction in which no other mark is nearer.
        dx, dy = max(
            ((dx, dy) for dx in (-19, 19) for dy in (-19, 19)),
            key=lambda d: sorted(max(abs(x + d[0] - a), abs(y + d[1] - b)) for a, b, _ in marks)[1],
        )
        # A browser gives a finger to a button that it nearly hits.
        if page.evaluate(
            """([x, y]) => [[0, 0], [9, 9], [9, -9], [-9, 9], [-9, -9], [0, 9], [0, -9]]
              .some(([right, down]) => document.elementFromPoint(x + right, y + down)
                ?.closest('.foot, .legend-box, .leaflet-control'))
              || Boolean(document.elementFromPoint(x, y).closest('.mark'))""",
            [x + dx, y + dy],
        ):
            continue
        page.touchscreen.tap(x + dx, y + dy)
        ((head, inside),) = page.evaluate(TIPS)
        assert plain(label).startswith(plain(head))
        assert inside, head


FULL = [
    (kind, width)
    for kind in ("long names", "names without a break", "eight vehicles")
    for width in (320, 1440)
]


@soaked
@pytest.mark.parametrize(("kind", "width"), chosen([FULL[0], FULL[3], FULL[4]], FULL))
def test_every_tip_lies_in_the_frame(pages: Pages, kind: str, width: int) -> None:
    """Also where it has no good place: lines by keyboard, marks at the edge of a moved map."""
    page = pages.open(kind, (width, 700))
    for moved in ("[0, 0]", "[-90, 140]"):
        page.evaluate(f"() => {{ map_plan.panBy({moved}, {{ animate: false }}); }}")
        count = page.locator(".mark.end, .mark.event-mark, path.route").count()
        for number in range(count):
            page.evaluate(
                """number => {
                  map_plan.eachLayer(l => { if (l instanceof L.Tooltip) l.close(); });
                  document.querySelectorAll('.mark.end, .mark.event-mark, path.route')[number]
                    .focus({ preventScroll: true });
                }""",
                number,
            )
            for head, inside in page.evaluate(TIPS):
                assert inside, head
    assert page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("kind", ["three vehicles", "fifty vehicles"])
def test_what_is_tapped_is_as_large_as_a_finger(pages: Pages, kind: str) -> None:
    page = pages.open(kind, (390, 844))
    page.locator(".legend-button").tap()
    small = page.evaluate(
        """() => [...document.querySelectorAll('.leaflet-bar a, .legend-button, .journey button, '
            + '.journey input, .legend label, .legend summary, .event, .group > summary')]
          .filter((e) => e.getClientRects().length)
          .map((e) => [e.className || e.textContent, e.getBoundingClientRect()])
          .filter(([, b]) => b.height < 44 || b.width < 44)
          .map(([name, b]) => `${name} ${b.width}x${b.height}`)"""
    )
    assert small == []


VIEW = "() => [map_plan.getZoom(), map_plan.getCenter().lat, map_plan.getCenter().lng, scrollY]"


def fingers(page: Any, *moves: list[tuple[float, float]]) -> None:
    """Put fingers down, move them from place to place, and take them away."""
    session = page.context.new_cdp_session(page)
    kinds = ["touchStart"] + ["touchMove"] * (len(moves) - 1)
    for kind, places in zip(kinds, moves, strict=True):
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(places)]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    session.detach()


def test_one_finger_scrolls_the_page_and_is_told_of_two(pages: Pages) -> None:
    page = pages.open("three vehicles", (390, 844))
    zoom, lat, lon, _ = page.evaluate(VIEW)
    fingers(page, *[[(200, 340 - 20 * step)] for step in range(9)])
    page.wait_for_function("() => scrollY > 100")
    assert page.evaluate(VIEW)[:3] == [zoom, lat, lon]
    page = pages.open("three vehicles", (390, 844))
    fingers(page, [(100, 330)], [(130, 332)], [(200, 335)], [(260, 335)])
    assert page.locator(".touch-hint.on").inner_text() == "Two fingers move the map"
    assert page.evaluate(VIEW) == [zoom, lat, lon, 0]
    page.wait_for_function("() => !document.querySelector('.touch-hint.on')")


def test_two_fingers_move_and_zoom_the_map_and_not_the_page(pages: Pages) -> None:
    page = pages.open("three vehicles", (390, 844))
    zoom, _lat, lon, _ = page.evaluate(VIEW)
    steps = [[(150 + s, 330), (250 + s, 330)] for s in range(0, 61, 15)]
    fingers(page, *steps)
    page.wait_for_function("lon => map_plan.getCenter().lng < lon - 0.1", arg=lon)
    assert page.evaluate(VIEW)[3] == 0
    # While the map settles on a level it hears no fingers.
    page.wait_for_function("() => !map_plan._animatingZoom")
    steps = [[(195 - s, 330), (205 + s, 330)] for s in range(10, 91, 20)]
    fingers(page, *steps)
    page.wait_for_function("zoom => map_plan.getZoom() > zoom + 0.5", arg=zoom)
    assert page.evaluate("visualViewport.scale") == 1
    assert page.evaluate(VIEW)[3] == 0


def test_beside_a_panel_one_finger_moves_the_map(pages: Pages) -> None:
    page = pages.open("three vehicles", (1180, 820))
    _, _, lon, _ = page.evaluate(VIEW)
    fingers(page, [(300, 600)], [(330, 600)], [(380, 600)], [(420, 600)])
    page.wait_for_function("lon => map_plan.getCenter().lng < lon - 0.1", arg=lon)
    assert page.locator(".touch-hint.on").count() == 0


def test_a_mark_chooses_its_row_without_scrolling_a_page(pages: Pages, tmp_path: Path) -> None:
    """Beside the map the panel scrolls to the row; below it the page stays."""
    page = pages.open("three vehicles", (1180, 500))
    page.locator(".event-mark").last.dispatch_event("click")
    row = page.locator(".event[aria-current]").bounding_box()
    assert row["y"] >= 0
    assert row["y"] + row["height"] <= 500 + 1
    page = pages.open("three vehicles", (390, 844))
    page.locator(".event-mark").last.dispatch_event("click")
    assert page.locator(".event[aria-current]").count() == 1
    assert page.evaluate("scrollY") == 0
