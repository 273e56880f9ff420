"""Many vehicles: traffic as ribbons, one vehicle lifted out, search, few stops of the Tab key."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable
from itertools import accumulate, pairwise
from pathlib import Path
from typing import Any

import pytest
from plan_kinds import plan_kind
from po_valley import THREE, make_plan, po_valley

from platoon_osm.report import report_document, write_html
from platoon_osm.report.drawing.polyline import decode_lines, decode_polyline

Visit = Callable[..., Any]

browser = pytest.mark.browser


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    folder = tmp_path_factory.mktemp("many")

    def page(name: str) -> Path:
        path = folder / f"{name}.html"
        if not path.exists():
            write_html(*plan_kind(name), path)
        return path

    return page


# -- traffic ---------------------------------------------------------------------------------------


def metres(a: tuple[float, float], b: tuple[float, float]) -> float:
    """Between two points of longitude and latitude, on Leaflet's sphere."""
    (lon, lat), (other_lon, other_lat) = ([math.radians(x) for x in point] for point in (a, b))
    half = math.sin((other_lat - lat) / 2) ** 2
    half += math.cos(lat) * math.cos(other_lat) * math.sin((other_lon - lon) / 2) ** 2
    return 2 * 6_371_000 * math.asin(math.sqrt(half))


@pytest.mark.parametrize("name", ["twenty vehicles", "fifty vehicles", "one platoon of fifty"])
def test_traffic_carries_every_vehicle(name: str) -> None:
    """Ribbons, as long as they are and as many as they carry, are all the vehicles drive."""
    plan, net = plan_kind(name)
    document = report_document(plan, net)
    alone = together = 0.0
    for roads in document["traffic"]["roads"]:
        lines = decode_lines(roads["lines"], 10_000)
        length = sum(metres(a, b) for line in lines for a, b in pairwise(line))
        alone += length * roads["alone"]
        together += length * sum(roads["bands"])
    assert alone == pytest.approx(sum(solo["length_m"] for solo in document["solos"]), rel=0.01)
    in_company = sum(one["length_m"] * len(one["vehicles"]) for one in document["platoons"])
    assert together == pytest.approx(in_company, rel=0.01)


def test_few_vehicles_have_a_line_each() -> None:
    assert report_document(*plan_kind("eight vehicles"))["traffic"] is None


@browser
@pytest.mark.parametrize("name", ["fifty vehicles", "one platoon of fifty"])
def test_a_line_is_drawn_for_who_is_lifted_out(
    name: str, pages: Callable[[str], Path], visit: Visit
) -> None:
    opened = visit(pages(name))
    page = opened.page
    lines = page.locator("#map_plan .leaflet-lifted-pane path")
    assert page.locator("#map_plan path.ribbon").count() > 0
    assert page.locator("#map_plan .leaflet-routes-pane path.route[data-vehicle]").count() == 0
    assert lines.count() == 0
    row = page.locator('tr[data-vehicle="1"] .who')
    row.click()
    assert lines.count() > 0
    # The vehicle's own ends stand out of the counts.
    assert page.locator('.mark.end.lifted[data-vehicle="1"]').count() == 2
    page.locator("h1").hover()
    page.keyboard.press("Escape")
    assert lines.count() == 0
    opened.check(pages(name))


# -- the selection ---------------------------------------------------------------------------------

LIFTED = """() => [...document.querySelectorAll('[data-vehicle]')].map(e => [
  e.dataset.vehicle.split(' ').map(Number), e.classList.contains('lifted'),
  e.classList.contains('faded'), e.tagName.toLowerCase()])"""


@browser
def test_one_selection_everywhere(pages: Callable[[str], Path], visit: Visit) -> None:
    opened = visit(pages("three vehicles"))
    page = opened.page
    marked = page.evaluate(LIFTED)
    # Rows, bars, marks on the map, lines on the map, and points of the list are all of it.
    assert {"tr", "g", "div", "path", "button"} <= {tag for *_, tag in marked}
    assert not any(lifted or faded for _, lifted, faded, _ in marked)
    ways_in = [
        lambda: page.locator('tr[data-vehicle="1"] .who').press("Enter"),
        lambda: page.locator('svg.schedule g[data-vehicle="1"] text').first.click(),
        lambda: page.locator('.mark.end[data-vehicle="1"]').first.press("Enter"),
        lambda: page.locator('path.route[aria-label][data-vehicle="1"]').first.press("Enter"),
    ]
    for way_in in ways_in:
        way_in()
        for who, lifted, faded, tag in page.evaluate(LIFTED):
            assert (lifted, faded) == (1 in who, 1 not in who), (who, tag)
        assert page.locator('tr[data-vehicle="1"] .who').get_attribute("aria-pressed") == "true"
        assert "Genova" in page.locator(".chosen").inner_text()
        way_in()
        assert not any(lifted or faded for _, lifted, faded, _ in page.evaluate(LIFTED))
        assert page.locator(".chosen").inner_text() == ""
    ways_in[0]()
    page.get_by_role("button", name="Let go").click()
    assert page.locator(".lifted, .faded").count() == 0
    opened.check(pages("three vehicles"))


@browser
def test_a_pointer_previews(pages: Callable[[str], Path], visit: Visit) -> None:
    page = visit(pages("one platoon of fifty")).page
    page.locator('tr[data-vehicle="3"]').hover()
    assert page.locator("#map_plan .leaflet-lifted-pane path").count() > 0
    assert page.locator(".faded").count() == 0
    page.locator("h1").hover()
    assert page.locator("#map_plan .leaflet-lifted-pane path").count() == 0


# -- the search ------------------------------------------------------------------------------------


HIDDEN_ENDS = """(index) => {
  const plan = unpacked(JSON.parse(document.getElementById('plan-data').textContent));
  const { origin, destination } = plan.vehicles[index];
  const frame = map_plan.getContainer().getBoundingClientRect();
  const over = [...document.querySelectorAll(
    '.map .legend-box, .map .leaflet-control, .map .credit, .map .journey, .map .chosen')]
    .map((one) => one.getBoundingClientRect());
  return [origin, destination].filter(({ lat, lon }) => {
    const at = map_plan.latLngToContainerPoint([lat, lon]);
    const x = at.x + frame.left;
    const y = at.y + frame.top;
    return x < frame.left + 12 || x > frame.right - 12
      || y < frame.top + 12 || y > frame.bottom - 12
      || over.some((box) =>
        x > box.left - 12 && x < box.right + 12 && y > box.top - 12 && y < box.bottom + 12);
  }).map(({ name }) => name);
}"""


@browser
def test_search_by_keyboard(pages: Callable[[str], Path], visit: Visit) -> None:
    # Who asks for calm is taken there at once.
    opened = visit(pages("fifty vehicles"), reduced_motion="reduce")
    page = opened.page
    field = page.get_by_role("combobox", name="Find")
    field.fill("truck 12")
    options = page.locator("#found").get_by_role("option")
    assert options.count() == 1
    field.press("ArrowDown")
    assert field.get_attribute("aria-activedescendant") == options.first.get_attribute("id")
    field.press("Enter")
    assert page.locator('tr.lifted[data-vehicle="11"]').is_visible()
    assert not page.get_by_role("listbox").is_visible()
    # A place is found without its accent, and shown.
    field.fill("santhia")
    assert "Santhi\u00e0" in options.first.inner_text()
    options.filter(has_text="Junction").first.click()
    at = page.evaluate("(() => { const c = map_plan.getCenter(); return [c.lng, c.lat]; })()")
    assert at == pytest.approx([8.17, 45.37], abs=0.02)
    assert page.locator(".found-ring").count() == 1
    # From so near, whole journeys come into view, and nothing that covers the map hides their ends.
    for number in (2, 12, 30, 50):
        field.fill(f"truck {number}")
        field.press("ArrowDown")
        field.press("Enter")
        assert page.evaluate(HIDDEN_ENDS, number - 1) == []
    field.fill("no such thing")
    assert options.count() == 0
    assert page.locator(".find [role=status]").inner_text() == "0 found"
    opened.check(pages("fifty vehicles"))


@browser
def test_what_is_found_is_text(visit: Visit, tmp_path: Path) -> None:
    def spoilt(name: str) -> str:
        return f"{name}<img src=x onerror=alert(1)>"

    path = tmp_path / "hostile.html"
    net = po_valley(spoilt)
    write_html(make_plan(net, THREE, spoilt), net, path)
    opened = visit(path)
    page = opened.page
    field = page.get_by_role("combobox", name="Find")
    for wanted in ("onerror", "A<img", "Genova"):
        field.fill(wanted)
        assert page.locator("#found").get_by_role("option").count() > 0
        field.press("Enter")
    assert page.locator("img[src='x']").count() == 0
    opened.check(path)


# -- by keyboard -----------------------------------------------------------------------------------


def tab_stops(page: Any, most: int) -> list[str]:
    """What the Tab key reaches, until it leaves the page."""
    found: list[str] = []
    while len(found) <= most:
        page.keyboard.press("Tab")
        now = page.evaluate(
            """() => { const e = document.activeElement; if (e === document.body) return null;
              return `${e.tagName} ${e.className.baseVal ?? e.className}`; }"""
        )
        if now is None:
            break
        found.append(now)
    return found


@browser
@pytest.mark.parametrize(
    ("name", "most"), [("three vehicles", 26), ("one platoon of fifty", 34), ("fifty vehicles", 59)]
)
def test_few_tab_stops(name: str, most: int, pages: Callable[[str], Path], visit: Visit) -> None:
    stops = tab_stops(visit(pages(name)).page, 80)
    assert 8 < len(stops) <= most, stops
    assert stops[0].startswith("A skip")


@browser
def test_five_hundred_vehicles(pages: Callable[[str], Path], visit: Visit) -> None:
    opened = visit(pages("five hundred vehicles"))
    page = opened.page
    tabbable = page.evaluate(
        """[...document.querySelectorAll('a[href], button, input, summary, [tabindex]')].filter(e =>
          e.tabIndex >= 0 && e.checkVisibility()).length"""
    )
    assert tabbable < 60
    # Marks count what lies near one another, and still say all names to a screen reader.
    assert page.locator("#map_plan .mark").count() < 200
    said = page.locator("#map_plan .mark.end").evaluate_all(
        "marks => marks.flatMap(e => e.dataset.vehicle.split(' '))"
    )
    assert sorted(map(int, said)) == sorted([*range(500), *range(500)])
    opened.check(pages("five hundred vehicles"))


@browser
def test_arrow_keys_go_on(pages: Callable[[str], Path], visit: Visit) -> None:
    page = visit(pages("three vehicles")).page
    rows = page.locator("tr[data-vehicle] .who")
    rows.first.focus()
    for key, at in (("ArrowDown", 1), ("End", 2), ("ArrowDown", 2), ("ArrowUp", 1), ("Home", 0)):
        page.keyboard.press(key)
        assert rows.nth(at).evaluate("e => e === document.activeElement"), key
    # Each mark and each line on the map is reached from the first.
    every = page.locator("#map_plan .leaflet-marker-pane .mark, #map_plan path.route[aria-label]")
    page.locator("#map_plan .mark[tabindex='0']").focus()
    seen = set()
    for _ in range(every.count()):
        seen.add(page.evaluate("document.activeElement.getAttribute('aria-label')"))
        page.keyboard.press("ArrowRight")
    assert len(seen) == len({one.get_attribute("aria-label") for one in every.all()})


# -- the slider, by position -----------------------------------------------------------------------


def whereabouts(document: Any, index: int, at: float) -> tuple[float, float]:
    """Where a vehicle is, worked out from the document alone; `at` is in seconds or metres."""
    vehicle = document["vehicles"][index]
    pieces = [
        document["solos" if kind == "solo" else "platoons"][number]
        for kind, number in vehicle["way"]
    ]
    ends = list(accumulate(piece["length_m"] for piece in pieces))
    if vehicle["times"] is not None:
        spans = vehicle["times"]["spans"]
        number = next((k for k, (_, end) in enumerate(spans) if at < end), len(spans) - 1)
        begin, end = spans[number]
        share = min(max((at - begin) / (end - begin), 0.0), 1.0)
    else:
        driven = at - document["journey"]["starts_m"][index]
        number = min(bisect_left(ends, driven), len(ends) - 1)
        share = 1 - (ends[number] - driven) / pieces[number]["length_m"]
    line = [
        point
        for part in pieces[number]["parts"]
        for point in decode_polyline(part["line"], 100_000)
    ]
    reached = list(accumulate((metres(a, b) for a, b in pairwise(line)), initial=0.0))
    far = share * reached[-1]
    k = min(max(bisect_left(reached, far), 1), len(line) - 1)
    part = (far - reached[k - 1]) / ((reached[k] - reached[k - 1]) or 1.0)
    (x0, y0), (x1, y1) = line[k - 1], line[k]
    return x0 + part * (x1 - x0), y0 + part * (y1 - y0)


DISCS = """(expected) => [...document.querySelectorAll('.mark.moving')].map(e => {
  const box = e.getBoundingClientRect(), frame = map_plan.getContainer().getBoundingClientRect();
  const who = Number(e.dataset.vehicle.split(' ')[0]);
  const p = map_plan.latLngToContainerPoint([expected[who][1], expected[who][0]]);
  return [e.dataset.vehicle, Math.hypot(box.left + box.width / 2 - frame.left - p.x,
    box.top + box.height / 2 - frame.top - p.y)];
})"""


@browser
@pytest.mark.parametrize("name", ["fifty vehicles", "one platoon of fifty"])
def test_discs_are_where_vehicles_are(
    name: str, pages: Callable[[str], Path], visit: Visit
) -> None:
    document = report_document(*plan_kind(name))
    page = visit(pages(name)).page
    schedule, journey = document["schedule"], document["journey"]
    begin, end = (
        (schedule["begin_s"], schedule["end_s"]) if schedule else (0.0, journey["length_m"])
    )
    shown: set[int] = set()
    for share in (0.13, 0.37, 0.52, 0.71, 0.9):
        at = begin + share * (end - begin)
        page.locator(".journey input").evaluate(
            "(e, at) => { e.value = at; e.dispatchEvent(new Event('input')); }",
            (at - begin) / (60 if schedule else 1000),
        )
        expected = [whereabouts(document, index, at) for index in range(50)]
        discs = page.evaluate(DISCS, expected)
        assert discs
        # Where a count stands, its first vehicle is: within a pixel of its icon's rounding.
        assert max(off for _, off in discs) < 2.5, (share, discs)
        there = [int(who) for text, _ in discs for who in text.split()]
        assert len(there) == len(set(there))
        shown |= set(there)
        if schedule:
            assert len(there) == 50
    assert len(shown) == 50


@browser
def test_who_is_lifted_out_has_its_disc_on_top(pages: Callable[[str], Path], visit: Visit) -> None:
    page = visit(pages("fifty vehicles")).page
    page.get_by_role("combobox", name="Find").fill("truck 5")
    page.keyboard.press("Enter")
    page.locator(".journey input").evaluate(
        "e => { e.value = e.max * 0.4; e.dispatchEvent(new Event('input')); }"
    )
    stacks = page.locator(".mark.moving").evaluate_all(
        "marks => marks.map(e => [e.dataset.vehicle, Number(e.style.zIndex)])"
    )
    highest = max(stacks, key=lambda one: one[1])
    assert highest[0] == "4"


@browser
def test_who_is_held_back_is_told(visit: Visit, tmp_path: Path) -> None:
    plan, net = plan_kind("three vehicles")
    document = report_document(plan, net)
    held = [
        (index, vehicle["times"]["earliest_departure_s"])
        for index, vehicle in enumerate(document["vehicles"])
        if vehicle["times"]["held_s"] > 60
    ]
    assert held
    path = tmp_path / "held.html"
    write_html(plan, net, path)
    page = visit(path).page
    index, ready = held[-1]
    page.locator(".journey input").evaluate(
        "(e, at) => { e.value = at; e.dispatchEvent(new Event('input')); }",
        (ready + 30 - document["schedule"]["begin_s"]) / 60,
    )
    letter = document["vehicles"][index]["letter"]
    assert f"{letter} held back" in page.locator(".states").inner_text()


# -- tables ----------------------------------------------------------------------------------------


@browser
def test_long_tables_sort_by_their_heads(pages: Callable[[str], Path], visit: Visit) -> None:
    opened = visit(pages("one platoon of fifty"))
    page = opened.page
    document = report_document(*plan_kind("one platoon of fifty"))
    saved = [vehicle["saved"] for vehicle in document["vehicles"]]
    table = page.locator(".group[open] .costs").first
    rows = "rows => rows.map(row => Number(row.dataset.vehicle))"
    before = table.locator("tbody tr").evaluate_all(rows)
    table.get_by_role("button", name="Saving").click()
    after = table.locator("tbody tr").evaluate_all(rows)
    assert sorted(after) == sorted(before)
    assert [saved[index] for index in after] == sorted((saved[i] for i in before), reverse=True)
    head = table.locator("th[data-sort=saved]")
    assert head.get_attribute("aria-sort") == "descending"
    head.get_by_role("button").press("Enter")
    assert head.get_attribute("aria-sort") == "ascending"
    opened.check(pages("one platoon of fifty"))


@browser
def test_the_overview_leads_to_a_group(pages: Callable[[str], Path], visit: Visit) -> None:
    page = visit(pages("five hundred vehicles")).page
    page.locator(".overview tbody tr[data-group='40'] [role=button]").click()
    assert page.locator(".group").nth(40).evaluate("e => e.open")
    assert page.locator(".overview").evaluate("e => e.parentElement.offsetHeight") < 450
