"""Names, callouts and marks: off the routes, whole, and clear of one another."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import shapely
from paused_plans import day_with_breaks
from plan_kinds import plan_kind
from soak import chosen, soaked

from platoon_osm.report import write_html
from platoon_osm.report.document.document import document_of
from platoon_osm.report.document.model import Document
from platoon_osm.report.language.speech import speaking
from platoon_osm.report.maps.map_texts import placed_callouts, placed_names
from platoon_osm.report.maps.map_view import MapView
from platoon_osm.report.maps.placement import SOLID, Box, Cover, crosses
from platoon_osm.report.maps.static_map import static_map
from platoon_osm.report.maps.static_marks import placed_marks
from platoon_osm.report.markup.fragments import written

Visit = Callable[..., Any]

KINDS = (
    "three vehicles",
    "opposite directions",
    "fifty vehicles",
    "a tall country",
    "all are late",
)


def document(kind: str) -> Document:
    return document_of(*plan_kind(kind))


# -- still maps ------------------------------------------------------------------------------------


def test_ways_cross_or_not() -> None:
    assert crosses((0, 0), (10, 10), (0, 10), (10, 0))
    assert not crosses((0, 0), (10, 10), (0, 10), (4, 6))
    assert not crosses((0, 0), (10, 10), (20, 0), (20, 10))
    box = Box(10, 10, 20, 10)
    assert box.is_crossed((0, 15), (50, 15))
    assert box.is_crossed((15, 15), (50, 50))
    assert not box.is_crossed((0, 0), (50, 5))


def test_a_place_is_given_back() -> None:
    cover = Cover(100, 100)
    box = Box(10, 10, 20, 10)
    cover.add_box(box)
    assert cover.cost(box) >= SOLID
    cover.free_box(box)
    assert cover.cost(box) == 0


def test_leaders_go_round_other_callouts() -> None:
    found = document("three vehicles")
    cover = Cover(960, 690)
    # All events in a row, so that every callout wants the same room.
    places = [(400.0 + 14 * number, 300.0) for number in range(len(found.events))]
    for x, y in places:
        cover.add_box(Box(x - 7, y - 7, 14, 14))
    callouts = list(placed_callouts(found, places, cover))
    assert len(callouts) == len(places)
    for one, other in itertools.permutations(callouts, 2):
        if one.near:
            assert not other.box.is_crossed((one.x, one.y), one.near)
            if other.near:
                assert not crosses((one.x, one.y), one.near, (other.x, other.y), other.near)


@pytest.mark.parametrize("scale", [1.0, 2.1])
def test_names_of_still_maps_keep_off_the_routes(scale: float) -> None:
    found = document("opposite directions")
    view = MapView([found])
    cover = Cover(view.width, view.height)
    lines = [view.pixels(part.line) for one in found.platoons for part in one.parts]
    cover.add_lines(lines)
    names = list(placed_names(found, view.places(found).towns, cover, scale))
    assert len(names) > 8
    roads = shapely.union_all([shapely.linestrings(line) for line in lines])
    for _, box in names:
        assert not shapely.box(box.left, box.top, box.right, box.bottom).intersects(roads)
        assert 0 <= box.left <= box.right <= view.width
        assert 0 <= box.top <= box.bottom <= view.height


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scale", [1.0, 1.75])
def test_marks_of_small_maps_are_whole(kind: str, scale: float) -> None:
    found = document(kind)
    view = MapView([found], 640.0, (400.0, 400.0), margin=26.0)
    for mark in placed_marks(found, view, scale, counted=True):
        assert 0 <= mark.box.left <= mark.box.right <= view.width
        assert 0 <= mark.box.top <= mark.box.bottom <= view.height


def test_still_maps_tell_who_is_late() -> None:
    late = placed_marks(document("all are late"), MapView([document("all are late")]))
    assert [mark.is_late for mark in late if mark.kind == "end"] == [True, True, True]
    assert all("late" in mark.title for mark in late if mark.kind == "end")
    early = placed_marks(document("three vehicles"), MapView([document("three vehicles")]))
    assert not any(mark.is_late or "late" in mark.title for mark in early)
    assert ">!</text>" in written(static_map(document("all are late")))


def test_still_maps_speak_the_language() -> None:
    with speaking("de", None):
        text = written(static_map(document_of(*plan_kind("three vehicles"))))
    assert "Treffpunkt: " in text
    assert "Trennpunkt: " in text
    assert "Merge" not in text


# -- live maps -------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("labels")
    found = {}
    for kind in KINDS:
        found[kind] = folder / f"{kind.replace(' ', '-')}.html"
        plan, net = plan_kind(kind)
        write_html(plan, net, found[kind])
    return found


# What is wrong with the texts on a map; lines are looked at every four pixels.
FAULTS = """() => {
  const frame = map_plan.getContainer().getBoundingClientRect();
  const boxes = (what) => [...document.querySelectorAll(what)]
    .filter((e) => getComputedStyle(e).visibility !== "hidden")
    .map((e) => ({ e, text: e.textContent, r: e.getBoundingClientRect() }));
  const [names, callouts] = [boxes("#map_plan .name"), boxes("#map_plan .callout")];
  const tags = boxes("#map_plan .tag");
  const faults = [];
  const cut = ({ left, right, top, bottom }) =>
    right > frame.left && left < frame.right && bottom > frame.top && top < frame.bottom &&
    (left < frame.left || right > frame.right || top < frame.top || bottom > frame.bottom);
  const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 &&
    a.top < b.bottom - 1 && b.top < a.bottom - 1;
  const holds = (r, { x, y }, less) =>
    x > r.left + less && x < r.right - less && y > r.top + less && y < r.bottom - less;
  const texts = [...names, ...callouts, ...tags];
  for (const { text, r } of texts) if (cut(r)) faults.push(`${text} is cut`);
  const all = [...texts, ...boxes("#map_plan .mark:not(.moving)")];
  all.forEach((a, i) => all.slice(i + 1).forEach((b) => {
    const texts = [a, b].some(({ e }) => !e.matches(".mark"));
    if (texts && meet(a.r, b.r)) faults.push(`${a.text} covers ${b.text}`);
  }));
  for (const path of document.querySelectorAll("#map_plan path.route, #map_plan path.ribbon")) {
    const there = path.getScreenCTM();
    const length = path.getTotalLength();
    for (let s = 0; s < length; s += 4) {
      const p = path.getPointAtLength(s).matrixTransform(there);
      for (const { text, r } of names) if (holds(r, p, 2)) faults.push(`${text} lies on a route`);
    }
  }
  for (const line of document.querySelectorAll(".leaflet-callouts-pane .leader line")) {
    const there = line.getScreenCTM();
    const [a, b] = [[line.x1, line.y1], [line.x2, line.y2]].map(([x, y]) =>
      new DOMPoint(x.baseVal.value, y.baseVal.value).matrixTransform(there));
    const shares = Array.from({ length: 60 }, (_, k) => k / 59);
    const inside = callouts.filter(({ r }) => shares.some((t) =>
      holds(r, { x: a.x + (b.x - a.x) * t, y: a.y + (b.y - a.y) * t }, 3)));
    if (inside.length) faults.push(`a leader crosses ${inside[0].text}`);
  }
  // A number is that of the event beside it, in the list and in the mark's label.
  const marks = boxes("#map_plan .event-mark");
  const middle = (r) => [(r.left + r.right) / 2, (r.top + r.bottom) / 2];
  const apart = (a, b) => Math.hypot(middle(a)[0] - middle(b)[0], middle(a)[1] - middle(b)[1]);
  for (const { e, text, r } of tags) {
    const [mark] = marks.sort((a, b) => apart(r, a.r) - apart(r, b.r));
    const label = mark.e.getAttribute("aria-label");
    const order = [...document.querySelectorAll(".event")]
      .find((row) => row.querySelector(".order").textContent === text);
    const name = order.querySelector("bdi").textContent;
    const fits = label.includes(`\u2068${text}. `) && label.includes(name);
    if (!fits) faults.push(`${text} stands at ${label}`);
    if (!e.ariaHidden) faults.push(`${text} is said without its mark`);
  }
  return { faults: [...new Set(faults)], names: names.length, callouts: callouts.length,
    tags: tags.length, events: marks.length };
}"""


WINDOWS = [(1440, 900), (700, 900), (390, 844)]
EVERY = [(kind, *window) for kind in KINDS for window in WINDOWS]
SOME = EVERY[:3] + [EVERY[3 * k + k % 3] for k in range(1, len(KINDS))]


@pytest.mark.browser
@soaked
@pytest.mark.parametrize(("kind", "width", "height"), chosen(SOME, EVERY))
def test_texts_of_a_live_map_are_whole_and_in_nobodys_way(
    kind: str, width: int, height: int, pages: dict[str, Path], visit: Visit
) -> None:
    page = visit(pages[kind], width, height).page
    found = page.evaluate(FAULTS)
    assert found["faults"] == []
    assert found["names"] > 2
    # Where a callout finds no room, a number does; in a crowd marks may stand for several events.
    told = found["callouts"] + found["tags"]
    assert told >= (5 if kind == "fifty vehicles" else found["events"])
    assert width > 600 or not found["callouts"]
    # A small move of the map cuts no name either.
    page.evaluate("void map_plan.panBy([37, 21], {animate: false})")
    cut = [fault for fault in page.evaluate(FAULTS)["faults"] if "is cut" in fault]
    assert [fault for fault in cut if ":" not in fault] == []


@pytest.mark.browser
def test_callouts_of_what_is_seen_are_seen(visit: Visit, tmp_path: Path) -> None:
    """Of pauses near the edge of the view too, where there is more room outside it."""
    plan, net = day_with_breaks()
    write_html(plan, net, tmp_path / "day.html")
    page = visit(tmp_path / "day.html", 1440, 900).page
    frame = page.locator("#map_plan").bounding_box()
    boxes = [one.bounding_box() for one in page.locator("#map_plan .callout").all()]
    assert len(boxes) > 3
    for box in boxes:
        assert frame["x"] <= box["x"] <= frame["x"] + frame["width"] - box["width"]
        assert frame["y"] <= box["y"] <= frame["y"] + frame["height"] - box["height"]


@pytest.mark.browser
def test_late_arrivals_wear_a_badge(pages: dict[str, Path], visit: Visit) -> None:
    page = visit(pages["all are late"]).page
    marks = page.locator("#map_plan .mark.end:has(.late-badge)")
    assert marks.count() == 3
    for label in marks.evaluate_all("all => all.map((e) => e.getAttribute('aria-label'))"):
        assert " late" in label
    page = visit(pages["three vehicles"]).page
    assert page.locator(".late-badge").count() == 0
