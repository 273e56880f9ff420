"""Colours of all pages, light, dark and the reader's own; and every page by axe's rules."""

from __future__ import annotations

import re
from collections.abc import Callable
from importlib.resources import files
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from plan_kinds import plan_kind
from soak import chosen, soaked

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import write_comparison, write_flows, write_html, write_sheets
from platoon_osm.report.drawing import palette
from platoon_osm.report.markup.fragments import asset

Visit = Callable[..., Any]

browser = pytest.mark.browser

HEX = re.compile(r"#[0-9a-fA-F]{3,6}\b")
ASSETS = [path.name for path in files("platoon_osm.report").joinpath("assets").iterdir()]
THEME = asset("theme.css")
BLOCKS = dict(re.findall(r"(?m)^(:root|@media [^{]*?) \{\n(.*?)^\}", THEME, re.DOTALL))
LIGHT, DARK = (
    dict(re.findall(r"--([\w-]+): ([^;]+);", BLOCKS[name]))
    for name in (":root", "@media screen and (prefers-color-scheme: dark)")
)
FILLS, STROKES = (
    dict(re.findall(rf'\[{name}="(#\w+)"\] {{ {name}: ([^;]+); }}', THEME))
    for name in ("fill", "stroke")
)


def hexes(value: str, theme: dict[str, str]) -> str:
    """Return a colour as six digits, looked up if it is one of the theme's."""
    found = re.fullmatch(r"var\(--([\w-]+)\)", value)
    text = theme[found[1]] if found else value
    return "#" + "".join(2 * c for c in text[1:]) if len(text) == 4 else text


def luminance(colour: str) -> float:
    channels = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return sum(k * c for k, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def contrast(one: str, other: str) -> float:
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


# -- one place for colours -------------------------------------------------------------------------


# A driver's sheet is paper, white in any theme.
PAPER = ("theme.css", "sheets.css")


@pytest.mark.parametrize("name", [n for n in ASSETS if n.endswith(".css") and n not in PAPER])
def test_style_sheets_take_their_colours_from_the_theme(name: str) -> None:
    assert re.findall(r"#[0-9a-fA-F]{3,6}\b|rgba?\([^)]*\)|: white\b|: black\b", asset(name)) == []


def test_dark_has_every_colour_that_light_has() -> None:
    assert set(DARK) == set(LIGHT)
    assert not set(FILLS) ^ set(STROKES)


@pytest.mark.parametrize("name", [n for n in ASSETS if n.endswith((".html", ".js"))])
def test_every_colour_of_a_drawing_has_one_for_the_dark(name: str) -> None:
    assert set(HEX.findall(asset(name))) <= set(FILLS)


def test_every_colour_of_the_palette_has_one_for_the_dark() -> None:
    colours = {
        colour for name in palette.__all__ for colour in HEX.findall(repr(getattr(palette, name)))
    }
    assert colours <= set(FILLS)


# -- contrast --------------------------------------------------------------------------------------

TEXTS = [
    ("ink", "paper", 7), ("ink", "hover", 7), ("ink", "chosen", 7), ("muted", "paper", 4.5),
    ("muted", "ground", 4.5), ("muted", "hover", 4.5), ("muted", "chosen", 4.5),
    ("muted", "sea", 4.5), ("name", "land", 4.5), ("name", "sea", 4.5), ("good", "paper", 4.5),
    ("good", "good-ground", 4.5), ("good-muted", "good-ground", 4.5), ("bad", "paper", 4.5),
    ("bad", "bad-ground", 4.5), ("ink", "proof-ground", 7), ("ink", "band", 4.5),
    ("focus", "paper", 3), ("focus", "land", 3), ("field", "paper", 3), ("band-edge", "land", 3),
    ("inferred", "land", 3), ("cursor", "paper", 3), ("pick", "land", 3),
]  # fmt: skip


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
@pytest.mark.parametrize(("ink", "ground", "least"), TEXTS)
def test_contrast(theme: dict[str, str], ink: str, ground: str, least: float) -> None:
    assert contrast(hexes(theme[ink], theme), hexes(theme[ground], theme)) >= least


@pytest.mark.parametrize("colour", palette.VEHICLES)
def test_vehicles_stand_out_in_the_dark(colour: str) -> None:
    """A letter reads on its disc, and lines on land, sea and the band of a platoon."""
    dark = FILLS[colour]
    assert contrast(dark, DARK["paper"]) >= 4.5
    assert min(contrast(dark, DARK[name]) for name in ("land", "sea")) >= 4.5
    assert contrast(dark, DARK["band"]) >= 3


def test_flows_are_told_apart_in_grey_in_the_dark_too() -> None:
    colours = [FILLS[colour] for colour in palette.FLOWS]
    assert contrast(colours[0], DARK["land"]) > 1.9
    assert all(luminance(b) > luminance(a) for a, b in pairwise(colours))
    assert all(contrast(a, b) > 1.35 for a, b in pairwise(colours))


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
def test_the_ground_is_quiet(theme: dict[str, str]) -> None:
    assert 1.05 < contrast(theme["land"], theme["sea"]) < 1.4
    assert contrast(theme["border"], theme["land"]) < 3


# -- pages -----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def pages(
    plan: JointPlan, two: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory
) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("pages")
    names = ("late", "two", "comparison", "flows", "sheets")
    made = {name: folder / f"{name}.html" for name in names}
    write_html(*plan_kind("all are late"), made["late"])
    write_html(two, net, made["two"])
    write_comparison([plan, plan], net, made["comparison"], titles=["One", "Two"])
    write_flows(two, net, made["flows"])
    write_sheets(*plan_kind("all are late"), made["sheets"])
    return made


VIEWS = [
    (1440, "light"),
    (900, "light"),
    (390, "light"),
    (1440, "dark"),
    (900, "dark"),
    (390, "dark"),
]


AUDITED = ["late", "two", "comparison", "flows", "sheets"]


@browser
@soaked
@pytest.mark.parametrize("name", AUDITED)
def test_axe_finds_no_serious_or_moderate_fault(
    name: str, pages: dict[str, Path], visit: Visit
) -> None:
    pytest.importorskip("axe_playwright_python")
    page = visit(pages[name], 1440, 900, wait_for="h1", reduced_motion="reduce").page
    page.evaluate((files("axe_playwright_python") / "axe.min.js").read_text("utf-8"))
    faults = []
    # On usual days two views of each page, and every view of some page.
    turn = 2 * AUDITED.index(name)
    views = chosen([VIEWS[turn % 6], VIEWS[(turn + 1) % 6]], VIEWS)
    # A sheet is paper, the same by day and by night.
    for width, scheme in [VIEWS[0], VIEWS[2]] if name == "sheets" else views:
        page.set_viewport_size({"width": width, "height": 900})
        page.emulate_media(color_scheme=scheme)
        found = page.evaluate("axe.run(document, {resultTypes: ['violations']})")
        faults += [
            (width, scheme, fault["id"], [node["html"][:160] for node in fault["nodes"][:3]])
            for fault in found["violations"]
            if fault["impact"] != "minor"
        ]
    assert faults == []


NAMES = """() => {
  const named = (e) => e.getAttribute('aria-label')
    || (e.getAttribute('aria-labelledby') || '').split(' ').map(
      (id) => document.getElementById(id)?.textContent.trim()).join(' ');
  const marks = [...document.querySelectorAll('nav, aside, [role=region], [role=search], section')];
  // A section without a name is no landmark.
  return marks.filter((e) => e.tagName !== 'SECTION' || named(e))
    .map((e) => [e.tagName + (e.getAttribute('role') || ''), named(e)]);
}"""

HEADS = "[...document.querySelectorAll('h1, h2, h3, h4, h5, h6')].map((e) => Number(e.tagName[1]))"


@browser
@pytest.mark.parametrize("name", ["late", "two", "comparison", "flows"])
def test_landmarks_have_names_of_their_own_and_headings_run_in_order(
    name: str, pages: dict[str, Path], visit: Visit
) -> None:
    page = visit(pages[name], wait_for="h1").page
    names = page.evaluate(NAMES)
    assert all(text.strip() for _, text in names)
    assert sorted(names) == sorted(map(list, {tuple(one) for one in names}))
    ids = page.evaluate("[...document.querySelectorAll('[id]')].map((e) => e.id)")
    assert len(set(ids)) == len(ids)
    heads = page.evaluate(HEADS)
    assert heads[0] == 1
    assert heads.count(1) == 1
    assert all(b - a <= 1 for a, b in pairwise(heads))


INKS = """() => {
  const style = (e) => getComputedStyle(document.querySelector(e));
  return {
    paper: style('html').backgroundColor, ink: style('h1').color,
    line: style('.leaflet-platoons-pane path[stroke="#0072b2"]').stroke,
    badge: style('.badge circle').fill,
  };
}"""

GROUND = """() => {
  const canvas = document.querySelector('.leaflet-network-pane canvas');
  const { width, height } = canvas;
  const data = canvas.getContext('2d').getImageData(0, 0, width, height).data;
  const seen = {};
  for (let i = 0; i < data.length; i += 4 * 97) {
    const key = [...data.slice(i, i + 3)].map((v) => v.toString(16).padStart(2, '0')).join('');
    seen[key] = (seen[key] || 0) + 1;
  }
  return Object.entries(seen).sort((a, b) => b[1] - a[1]).slice(0, 2).map(([key]) => '#' + key);
}"""


def rgb(colour: str) -> str:
    return f"rgb({', '.join(str(int(colour[i : i + 2], 16)) for i in (1, 3, 5))})"


@browser
def test_dark_on_the_screen_at_once_and_light_on_paper(
    pages: dict[str, Path], visit: Visit
) -> None:
    page = visit(pages["two"]).page
    assert page.evaluate(INKS)["paper"] == rgb("#ffffff")
    assert set(page.evaluate(GROUND)) == {LIGHT["land"], LIGHT["sea"]}
    page.emulate_media(color_scheme="dark")
    dark = {
        "paper": rgb(DARK["paper"]), "ink": rgb(DARK["ink"]), "line": rgb(FILLS["#0072b2"]),
        "badge": rgb(FILLS["#0072b2"]),
    }  # fmt: skip
    assert page.evaluate(INKS) == dark
    page.wait_for_function(f"() => ({GROUND})().includes({DARK['sea']!r})")
    assert set(page.evaluate(GROUND)) == {DARK["land"], DARK["sea"]}
    page.emulate_media(color_scheme="dark", media="print")
    paper = page.evaluate(INKS)
    assert (paper["paper"], paper["ink"]) == (rgb("#ffffff"), rgb("#17202b"))
    assert paper["badge"] == rgb("#0072b2")


@browser
def test_forced_colours_leave_everything_to_be_seen(pages: dict[str, Path], visit: Visit) -> None:
    page = visit(pages["two"], forced_colors="active", color_scheme="dark").page
    seen = page.evaluate(INKS)
    assert (seen["line"], seen["badge"]) == (rgb(FILLS["#0072b2"]), rgb(FILLS["#0072b2"]))
    for box in (".legend", ".journey", ".leaflet-bar"):
        style = f"getComputedStyle(document.querySelector('{box}'))"
        assert page.evaluate(f"{style}.borderTopStyle") == "solid", box
        assert page.evaluate(f"{style}.borderTopColor") == seen["ink"], box
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    outline = page.evaluate(
        "(({outlineStyle: a, outlineWidth: b}) => [a, b])(getComputedStyle(document.activeElement))"
    )
    assert outline == ["solid", "3px"]


@browser
def test_nothing_moves_by_itself_for_those_who_want_it_so(
    pages: dict[str, Path], visit: Visit
) -> None:
    page = visit(pages["two"], reduced_motion="reduce").page
    moving = page.evaluate(
        """[...document.querySelectorAll('*')].filter((e) => {
          const style = getComputedStyle(e);
          return style.animationName !== 'none'
            || style.transitionDuration.split(', ').some((time) => parseFloat(time) > 0);
        }).map((e) => e.outerHTML.slice(0, 80))"""
    )
    assert moving == []
    assert page.evaluate("document.getAnimations().length") == 0
