"""The page in a real browser with the network cut."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from places import ROOT
from po_valley import THREE, make_plan

from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.towns.surroundings import GEONAMES_CREDIT
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import plan_map, write_html
from platoon_osm.report.markup.leaflet import SHA256

Visit = Callable[..., Any]

browser = pytest.mark.browser


@pytest.fixture(scope="module")
def page_file(plan: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("report") / "plan.html"
    write_html(plan, net, path, title="Platoon plan, Northern Italy")
    return path


@pytest.fixture(scope="module")
def many_file(many: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("report") / "many.html"
    write_html(many, net, path)
    return path


# -- the file --------------------------------------------------------------------------------------


def test_same_plan_same_bytes(
    plan: JointPlan, net: RoadNetwork, page_file: Path, tmp_path: Path
) -> None:
    write_html(plan, net, tmp_path / "a.html", title="Platoon plan, Northern Italy")
    assert (tmp_path / "a.html").read_bytes() == page_file.read_bytes()
    assert [item.name for item in tmp_path.iterdir()] == ["a.html"]


def test_page_asks_for_nothing_from_outside(page_file: Path) -> None:
    text = page_file.read_text()
    head = text[text.index("<head>") + 6 :].lstrip()
    assert head.startswith('<meta http-equiv="Content-Security-Policy" content="default-src')
    policy = re.search(r'content="([^"]*)"', head)
    assert policy is not None
    assert "unsafe" not in policy.group(1)
    assert "http" not in policy.group(1)
    assert not re.search(r"<(script|link|img|iframe)[^>]+(src|href)=", text)
    assert not re.search(r"\sstyle=\"", re.sub(r"<script.*?</script>", "", text, flags=re.S))
    assert "BSD 2-Clause License" in text


def test_size_budget(page_file: Path, many_file: Path) -> None:
    assert page_file.stat().st_size < 380_000
    assert many_file.stat().st_size < 680_000


def test_leaflet_from_elsewhere_is_checked(
    plan: JointPlan, net: RoadNetwork, tmp_path: Path, page_file: Path
) -> None:
    with pytest.raises(ScenarioError, match=r"leaflet\.js: cannot read"):
        write_html(plan, net, tmp_path / "x.html", leaflet_dir=tmp_path / "none")
    from importlib.resources import files

    source = files("xstatic.pkg.leaflet") / "data"
    copy = tmp_path / "leaflet"
    copy.mkdir()
    for name in SHA256:
        (copy / name).write_bytes((source / name).read_bytes())
    title = "Platoon plan, Northern Italy"
    write_html(plan, net, tmp_path / "x.html", leaflet_dir=copy, title=title)
    assert (tmp_path / "x.html").read_bytes() == page_file.read_bytes()
    (copy / "leaflet.js").write_text("alert(1)")
    with pytest.raises(ScenarioError, match="not the file of Leaflet"):
        write_html(plan, net, tmp_path / "y.html", leaflet_dir=copy)
    assert not (tmp_path / "y.html").exists()


def test_a_folder_in_its_place_leaves_no_rubbish(
    plan: JointPlan, net: RoadNetwork, tmp_path: Path
) -> None:
    (tmp_path / "plan.html").mkdir()
    with pytest.raises(ScenarioError, match="cannot be written"):
        write_html(plan, net, tmp_path / "plan.html")
    assert [item.name for item in tmp_path.iterdir()] == ["plan.html"]


def test_tiles_only_when_asked(plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    write_html(plan, net, tmp_path / "tiles.html", tiles="OpenStreetMap")
    text = (tmp_path / "tiles.html").read_text()
    assert "img-src data: https://tile.openstreetmap.org;" in text
    for wrong in ("No Such Map", "http://a/{z}/{x}/{y}.png", "https://a;b/{z}/{x}/{y}"):
        with pytest.raises(ScenarioError, match="tiles"):
            write_html(plan, net, tmp_path / "no.html", tiles=wrong)


def test_it_is_a_folium_map(plan: JointPlan, net: RoadNetwork, page_file: Path) -> None:
    import folium

    made = plan_map(plan, net, title="Platoon plan, Northern Italy")
    assert isinstance(made, folium.Map)
    assert made.get_root().render() == page_file.read_text()
    assert folium.Map.default_js, "other maps of the process keep their files"


# -- in the browser --------------------------------------------------------------------------------


@browser
@pytest.mark.parametrize(("width", "height"), [(1440, 900), (900, 1000), (899, 1000), (390, 844)])
def test_layout(page_file: Path, look: Visit, width: int, height: int) -> None:
    opened = look(page_file, width, height)
    page = opened.page
    box = page.locator("#map_plan").bounding_box()
    panel = page.locator("#panel").bounding_box()
    if width >= 900:
        assert panel["width"] == 430
        assert box["width"] == width - 430
        assert box["height"] == height
    else:
        assert box["width"] == panel["width"] == width
        assert box["height"] == pytest.approx(0.62 * height, abs=1)
        assert panel["y"] >= box["height"] - 1
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.locator(".legend").is_visible() == (width >= 900)
    opened.check(page_file)


@browser
@pytest.mark.parametrize(
    ("width", "height"), [(1440, 900), (900, 1000), (899, 1000), (600, 900), (390, 844)]
)
def test_who_made_the_map_is_told_in_full(
    page_file: Path, look: Visit, width: int, height: int
) -> None:
    page = look(page_file, width, height).page
    credit = page.locator(".credit")
    lines = credit.locator("bdi").all_inner_texts()
    assert lines == ["Made by hand for tests, CC0", GEONAMES_CREDIT]
    assert credit.evaluate(
        "e => e.scrollHeight <= e.clientHeight && e.scrollWidth <= e.clientWidth"
    )
    # Neither it nor the slider hides the scale.
    boxes = page.evaluate(
        """['.credit', '.journey', '.leaflet-control-scale']
          .map(name => document.querySelector(name).getBoundingClientRect().toJSON())"""
    )
    scale = boxes.pop()
    for box in boxes:
        assert (
            box["left"] >= scale["right"]
            or box["top"] >= scale["bottom"]
            or (box["bottom"] <= scale["top"])
        )


@browser
def test_a_callout_points_at_its_own_mark(page_file: Path, look: Visit) -> None:
    """A leader ends on the mark whose callout it comes from, moved aside or not."""
    page = look(page_file, 1440, 900).page
    far = page.evaluate(
        """() => {
          const at = (e) => { const b = e.getBoundingClientRect();
            return [b.left + b.width / 2, b.top + b.height / 2]; };
          const marks = [...document.querySelectorAll('.event-mark')].map(at);
          return [...document.querySelectorAll('.leaflet-callouts-pane line')].map(line => {
            const b = line.ownerSVGElement.getBoundingClientRect();
            const [x, y] = [b.left + +line.getAttribute('x1'), b.top + +line.getAttribute('y1')];
            return Math.min(...marks.map(m => Math.hypot(m[0] - x, m[1] - y)));
          });
        }"""
    )
    assert all(distance < 3 for distance in far)


BOXES = """() => [...document.querySelectorAll('.name, .callout')].map(e => {
  const b = e.getBoundingClientRect();
  return [b.left, b.top, b.right, b.bottom, e.textContent];
})"""


@browser
@pytest.mark.parametrize(("width", "height"), [(1440, 900), (900, 1000), (390, 844)])
def test_no_label_covers_another(page_file: Path, look: Visit, width: int, height: int) -> None:
    page = look(page_file, width, height).page
    boxes = page.evaluate(BOXES)
    assert len(boxes) > (20 if width == 1440 else 5)
    for i, a in enumerate(boxes):
        for b in boxes[:i]:
            apart = a[0] >= b[2] or b[0] >= a[2] or a[1] >= b[3] or b[1] >= a[3]
            assert apart, f"{a[4]!r} covers {b[4]!r}"


@browser
def test_callouts_say_who_joins_and_cover_no_mark(page_file: Path, look: Visit) -> None:
    page = look(page_file, 1440, 900).page
    texts = page.locator(".callout").all_inner_texts()
    assert "Merge: Brescia Centro\nB joins A and C" in texts
    assert len(texts) == 4
    covered = page.evaluate(
        """() => {
          const boxes = (name) => [...document.querySelectorAll(name)]
            .map(e => e.getBoundingClientRect());
          return boxes('.callout').some(c => boxes('.mark').some(m =>
            c.left < m.right - 3 && m.left + 3 < c.right &&
            c.top < m.bottom - 3 && m.top + 3 < c.bottom));
        }"""
    )
    assert not covered


@browser
def test_band_holds_one_line_per_vehicle(page_file: Path, look: Visit) -> None:
    page = look(page_file, 1440, 900).page
    widths = page.evaluate(
        """() => [...document.querySelectorAll('#map_plan path[stroke="#ffd54a"]')]
          .map(e => +e.getAttribute('stroke-width'))"""
    )
    assert widths == [18, 24, 18]
    lines = page.evaluate(
        """() => [...document.querySelectorAll('.leaflet-platoons-pane path')]
          .map(e => e.getAttribute('stroke'))"""
    )
    assert lines[:6].count("#ffd54a") == 3
    assert lines[6:].count("#0072b2") == 3
    assert lines[6:].count("#c14900") == 2
    assert lines[6:].count("#007a5a") == 2


COUNT = "name => document.querySelectorAll(name).length"


LAYERS = [
    ("platoon", '#map_plan path[stroke="#ffd54a"]', 0),
    ("vehicle-1", '#map_plan path[stroke="#c14900"]', 0),
    ("merge", '.event-mark use[href="#icon-merge"]', 0),
    ("separation", '.event-mark use[href="#icon-separation"]', 0),
    ("ends", ".mark.end", 0),
    ("names", ".name", 0),
    ("vehicle-2", ".mark.end", 4),
]


@browser
def test_legend_is_the_layer_control(page_file: Path, visit: Visit) -> None:
    opened = visit(page_file)
    page = opened.page
    for layer, selector, left in LAYERS:
        before = page.evaluate(COUNT, selector)
        assert before > left, layer
        box = page.locator(f'[data-layer="{layer}"]')
        box.focus()
        page.keyboard.press("Space")
        assert page.evaluate(COUNT, selector) == left, layer
        page.keyboard.press("Space")
        assert page.evaluate(COUNT, selector) == before, layer
    opened.check(page_file)


@browser
def test_network_and_junctions_hide(page_file: Path, visit: Visit) -> None:
    """They are drawn on canvas, on land and sea, so their white pixels are counted."""
    page = visit(page_file).page
    ink = """pane => {
      const canvas = document.querySelector(`.leaflet-${pane}-pane canvas`);
      if (!canvas) return 0;
      const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
      let sum = 0;
      for (let i = 0; i < data.length; i += 4) {
        if (data[i] + data[i + 1] + data[i + 2] + data[i + 3] === 1020) sum++;
      }
      return sum;
    }"""
    assert page.evaluate(ink, "network") > 1000
    assert page.evaluate(ink, "junctions") == 0
    page.evaluate("void map_plan.setZoom(10, {animate: false})")
    page.wait_for_timeout(100)
    assert page.evaluate(ink, "junctions") > 0
    page.locator('[data-layer="junctions"]').uncheck()
    page.locator('[data-layer="network"]').uncheck()
    page.locator('[data-layer="inferred"]').uncheck()
    page.wait_for_timeout(100)
    assert page.evaluate(ink, "junctions") == 0
    assert page.evaluate(ink, "network") == 0


@browser
@pytest.mark.parametrize("key", [None, "Enter"])
def test_an_event_moves_the_map_to_it(page_file: Path, visit: Visit, key: str | None) -> None:
    opened = visit(page_file, reduced_motion="reduce")
    page = opened.page
    button = page.get_by_role("button", name="Brescia Centro: B joins A and C").last
    if key:
        button.focus()
        page.keyboard.press(key)
    else:
        button.click()
    lon, lat, zoom = page.evaluate(
        "[map_plan.getCenter().lng, map_plan.getCenter().lat, map_plan.getZoom()]"
    )
    assert (lon, lat) == pytest.approx((10.18, 45.51), abs=0.01)
    assert zoom >= 10
    page.get_by_role("button", name="Show the whole plan").click()
    assert page.evaluate("map_plan.getZoom()") < 9
    opened.check(page_file)


@browser
def test_a_section_tells_its_costs(page_file: Path, visit: Visit) -> None:
    page = visit(page_file).page
    band = page.locator('path.route[stroke="#ffd54a"]').nth(1)
    band.focus()
    tip = page.locator(".leaflet-tooltip").inner_text()
    assert tip.startswith("Platoon of A, B and C\n")
    assert "Alone" in tip
    assert "In platoon" in tip
    solo = page.locator('path.route[stroke="#c14900"]').first
    solo.focus()
    assert page.locator(".leaflet-tooltip").last.inner_text().startswith("B alone\n")


@browser
def test_all_controls_are_reached_by_keyboard(page_file: Path, visit: Visit) -> None:
    page = visit(page_file).page
    reached = set()
    # Tab goes from group to group, arrow keys within one.
    for key in ["Tab", *["ArrowDown"] * 12] * 18:
        page.keyboard.press(key)
        reached.add(
            page.evaluate(
                """() => { const e = document.activeElement;
                  return e.dataset.layer || (e.dataset.event && 'event ' + e.dataset.event)
                    || e.getAttribute('aria-label') || e.className.baseVal || e.className; }"""
            )
        )
    assert {"platoon", "vehicle-0", "names", "event 0", "event 3", "Zoom in", "skip"} <= reached
    assert any("Brescia Centro" in str(name) for name in reached)


@browser
def test_legend_button_on_a_small_screen(page_file: Path, visit: Visit) -> None:
    page = visit(page_file, 390, 844).page
    button = page.get_by_role("button", name="Legend")
    button.click()
    assert page.locator(".legend").is_visible()
    assert button.get_attribute("aria-expanded") == "true"
    page.keyboard.press("Escape")
    assert not page.locator(".legend").is_visible()


@browser
def test_without_javascript_there_is_a_still_map(page_file: Path, visit: Visit) -> None:
    opened = visit(page_file, java_script_enabled=False)
    page = opened.page
    svg = page.locator(".static-map svg")
    assert svg.bounding_box()["width"] > 800
    assert "Merge: Brescia Centro" in svg.text_content()
    assert not page.locator("#map_plan").is_visible()
    assert page.locator(".costs tbody tr").count() == 3
    assert page.locator(".legend input").first.is_visible() is False
    opened.check(page_file)


@browser
@pytest.mark.parametrize("width", [1440, 900, 390])
def test_without_javascript_the_legend_covers_nothing(
    page_file: Path, visit: Visit, width: int
) -> None:
    page = visit(page_file, width, 900, java_script_enabled=False).page
    drawing = page.locator(".static-map").bounding_box()
    legend = page.locator(".legend-box").bounding_box()
    credit = page.locator(".credit").bounding_box()
    assert legend["y"] >= drawing["y"] + drawing["height"] - 1
    assert credit["y"] >= legend["y"] + legend["height"] - 1
    assert page.locator(".legend label").last.is_visible()


@browser
def test_prints_on_two_pages(page_file: Path, visit: Visit) -> None:
    page = visit(page_file).page
    page.emulate_media(media="print")
    assert page.locator(".static-map svg").is_visible()
    assert not page.locator("#map_plan").is_visible()
    pdf = page.pdf(prefer_css_page_size=True)
    assert len(re.findall(rb"/Type\s*/Page[^s]", pdf)) <= 2


@browser
@pytest.mark.parametrize(("width", "height"), [(1440, 900), (390, 844)])
def test_fifty_vehicles(many_file: Path, visit: Visit, width: int, height: int) -> None:
    opened = visit(many_file, width, height)
    page = opened.page
    assert page.locator(".group .costs tbody tr").count() == 50
    assert page.locator(".group[open] .table-box").bounding_box()["height"] <= 440
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    if width == 1440:
        page.locator(".legend-crowd > summary").click()
        page.locator("[data-all-vehicles]").uncheck()
        assert page.locator('#map_plan path[stroke="#c14900"]').count() == 0
        assert page.locator(".mark").count() == 0
    opened.check(many_file)


@browser
@pytest.mark.parametrize("vehicles", [1, 2])
def test_few_vehicles(net: RoadNetwork, visit: Visit, tmp_path: Path, vehicles: int) -> None:
    path = tmp_path / "few.html"
    write_html(make_plan(net, THREE[:vehicles]), net, path)
    opened = visit(path)
    assert opened.page.locator(".mark.end").count() == 2 * vehicles
    opened.check(path)


@browser
def test_those_who_stay_alone_say_why(net: RoadNetwork, visit: Visit, tmp_path: Path) -> None:
    path = tmp_path / "alone.html"
    write_html(make_plan(net, [*THREE, ("D", "Parma", "La Spezia", None, None)]), net, path)
    notes = " ".join(visit(path).page.locator(".notes").all_inner_texts())
    assert "D stays alone: no way of joining" in notes
    assert "inferred" in notes


@browser
def test_proof_and_provenance_are_told(
    plan: JointPlan, net: RoadNetwork, visit: Visit, tmp_path: Path
) -> None:
    path = tmp_path / "bound.html"
    write_html(replace(plan, proof={"kind": "bound", "bound": 3.7e6, "gap": 0.012}), net, path)
    panel = visit(path).page.locator("#panel").inner_text()
    for text in (
        "at most 1.2\u202f% above the optimum", "po-valley.osm", "3f9c3f9c\u202677a1",
        "2026-01-15", "platoon_osm 0.1.0", "xi = 0.18", "Made by hand for tests, CC0",
    ):  # fmt: skip
        assert text in panel


@browser
def test_plan_of_the_planner_on_the_bundled_map(visit: Visit, tmp_path: Path) -> None:
    import platoon_osm

    source = ROOT / "maps" / "italy-motorways.osm"
    if not source.exists() or not source.stat().st_size:
        pytest.skip("no bundled map")
    net = platoon_osm.load_network(source)
    trips = [
        platoon_osm.Trip(name, net.locate(origin), net.locate(destination))
        for name, origin, destination in (
            ("A", "Torino", "Trieste"), ("B", "Genova", "Belluno"), ("C", "Como", "Bolzano"),
        )
    ]  # fmt: skip
    plan = platoon_osm.plan_joint(net, platoon_osm.paper_weights(net), trips, case="C")
    path = tmp_path / "italy.html"
    write_html(plan, net, path)
    assert path.stat().st_size < 450_000
    opened = visit(path)
    assert opened.page.locator(".event-mark").count() >= 2
    opened.check(path)
