"""Hostile names in every field: nothing runs, in Python or in the browser, and all is shown."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hostile_names import HOSTILE
from money_plans import in_money
from po_valley import THREE, make_plan, po_valley, two_platoons
from soak import chosen, soaked

from platoon_osm.network.load_report import Source
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import write_comparison, write_flows, write_html
from platoon_osm.report.markup.fragments import Piece, written
from platoon_osm.report.markup.security import json_for_html
from platoon_osm.report.markup.style_classes import COLOURS, STYLED
from platoon_osm.shown_text import fitted, shown


def hostile_case(name: str) -> tuple[JointPlan, RoadNetwork]:
    """A plan with one hostile name in every field that can carry text."""

    def spoiled(text: str) -> str:
        return f"{text} {name}"

    net = po_valley(spoiled, Source(name, name, name, name, name))
    plan = make_plan(
        net, [*THREE, ("D", "Parma", "La Spezia", None, None)], spoiled,
        case=name, asked=name, objective=name, method=name, version=name, remarks=(name,),
        proof={"kind": name, "conditions": [name], name: name},
    )  # fmt: skip
    # The weights' preset stays readable, or the detour would not be known.
    return in_money(replace(plan, params={**plan.params, name: name}), text=name), net


@cache
def plain_markup(kind: str) -> set[tuple[str, ...]]:
    """The kinds of element in a page with a harmless name."""
    plan, net = hostile_case("Name")
    with TemporaryDirectory() as folder:
        write_page(kind, plan, net, Path(folder) / "plain.html", "Name")
        return markup_of((Path(folder) / "plain.html").read_text())


def write_page(kind: str, plan: JointPlan, net: RoadNetwork, path: Path, name: str) -> None:
    if kind == "comparison":
        write_comparison([plan, plan], net, path, titles=[name] * 2, title=name)
    else:
        write = write_flows if kind == "flows" else write_html
        write(plan, net, path, title=f"Title {name}")


def test_the_corpus_is_large() -> None:
    assert len(set(HOSTILE)) == len(HOSTILE) >= 60


@soaked
@pytest.mark.parametrize("name", chosen(HOSTILE[::5], HOSTILE), ids=HOSTILE.index)
def test_markup_of_the_file_is_ours(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    plan, net = hostile_case(name)
    write_page("plan", plan, net, tmp_path / "hostile.html", name)
    assert [item.name for item in tmp_path.iterdir()] == ["hostile.html"]
    hostile = (tmp_path / "hostile.html").read_text()
    # Elements and attributes are those of a page with a harmless name, whatever is in the name.
    assert markup_of(hostile) <= plain_markup("plan")
    assert len(re.findall("<script[ >]", hostile)) >= 3
    assert "49" not in re.findall(r"<h1 [^>]*>(.*)</h1>", hostile)[0]
    data = re.search(r'id="plan-data">(.*?)</script>', hostile, re.S)
    assert data is not None
    assert json.loads(data.group(1))["towns"]["names"].startswith("Milano")


@soaked
@pytest.mark.parametrize("name", chosen(HOSTILE[::9], HOSTILE[::3]), ids=HOSTILE.index)
def test_markup_of_the_other_pages_is_ours(name: str, tmp_path: Path) -> None:
    plan, net = hostile_case(name)
    for kind in ("comparison", "flows"):
        write_page(kind, plan, net, tmp_path / kind, name)
        hostile = (tmp_path / kind).read_text()
        assert markup_of(hostile) <= plain_markup(kind)
        assert "<h1" in hostile


OTHER_PAGES = 2


@pytest.mark.browser
@pytest.mark.parametrize("page_number", range(OTHER_PAGES))
@pytest.mark.parametrize("kind", ["comparison", "flows"])
def test_nothing_runs_in_the_other_pages(
    kind: str, page_number: int, visit: Callable[..., Any], tmp_path: Path
) -> None:
    given: dict[str, str] = {}
    start = page_number * len(HOSTILE) // OTHER_PAGES

    def spoiled(text: str) -> str:
        return given.setdefault(text, f"{text} {HOSTILE[(start + len(given)) % len(HOSTILE)]}")

    one = HOSTILE[start]
    net = po_valley(spoiled, Source(one, one, one, one, one))
    plan = replace(
        two_platoons(net, spoiled), case=one, asked=one, objective=one, method=one, version=one,
        proof={"kind": one, "conditions": HOSTILE},
    )  # fmt: skip
    path = tmp_path / "hostile.html"
    if kind == "flows":
        write_flows(plan, net, path, title=f"Title {one}")
    else:
        titles = HOSTILE[start : start + 16]
        write_comparison([plan] * 16, net, path, titles=titles, title=f"Title {one}")
    opened = visit(path, wait_for="h1")
    page = opened.page
    assert page.locator("h1").text_content() == fitted(f"Title {one}")
    if kind == "flows":
        for row in page.locator(".list summary").all():
            row.click()
        ends = page.locator(".list summary small bdi").all_text_contents()
        first = plan.vehicles[0]
        assert ends[:2] == [fitted(first.origin.name), fitted(first.destination.name)]
        page.get_by_role("searchbox").fill(one)
    else:
        heads = page.locator(".card h3").all_text_contents()
        assert heads == [fitted(name) or "Plan" for name in titles]
    assert page.evaluate("window.hacked") is None
    assert page.evaluate("document.documentElement.scrollWidth") <= 1440
    opened.check(path)


DRAWN = {"text", "line", "path", "rect", "circle", "polyline", "polygon", "g", "use"}
LOOKS = {"class", "transform", *STYLED, *COLOURS}


def markup_of(text: str) -> set[tuple[str, ...]]:
    """The kinds of element in a page, each a tag with the names of its attributes."""
    found: set[tuple[str, ...]] = set()

    class Reader(HTMLParser):
        def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
            # Whether attributes or a class say how a drawing looks depends on how often they do.
            looks = LOOKS if tag in DRAWN else ()
            found.add((tag, *(name for name, _ in attrs if name not in looks)))

    reader = Reader()
    reader.feed(text)
    reader.close()
    return found


PAGES = 8


@pytest.mark.browser
@soaked
@pytest.mark.parametrize("page_number", chosen(range(0, PAGES, 2), range(PAGES)))
def test_nothing_runs_in_the_browser(
    page_number: int, visit: Callable[..., Any], tmp_path: Path
) -> None:
    """Each page holds all names, each in another field than on the page before."""
    given: dict[str, str] = {}
    start = page_number * len(HOSTILE) // PAGES

    def spoiled(text: str) -> str:
        return given.setdefault(text, f"{text} {HOSTILE[(start + len(given)) % len(HOSTILE)]}")

    one = HOSTILE[start]
    net = po_valley(spoiled, Source(one, one, one, one, one))
    plan = make_plan(
        net, [*THREE, ("D", "Parma", "La Spezia", None, None)], spoiled,
        case=one, asked=one, objective=one, method=one, version=one,
        remarks=tuple(HOSTILE), proof={"kind": one, "conditions": HOSTILE},
    )  # fmt: skip
    path = tmp_path / "hostile.html"
    write_html(plan, net, path, title=f"Title {one}")
    # Of all names together no more elements come than of a harmless one.
    assert markup_of(path.read_text()) <= plain_markup("plan")
    opened = visit(path, reduced_motion="reduce")
    page = opened.page
    assert page.locator("h1").text_content() == fitted(f"Title {one}")
    assert page.locator(".remarks li").all_text_contents() == [fitted(name) for name in HOSTILE]
    ends = page.locator(".costs tbody .ends bdi").all_text_contents()
    assert ends == [
        fitted(stop.name)
        for vehicle in plan.vehicles
        for stop in (vehicle.origin, vehicle.destination)
    ]
    # Point at things that carry names, so that tooltips are built too.
    for mark in page.locator(".mark").all()[:4]:
        mark.focus()
    page.locator("path.route").first.focus()
    # Close up, junctions show their names.
    page.locator('button[data-event="0"]').click()
    assert page.evaluate("map_plan.getZoom()") > 10
    assert page.evaluate("window.hacked") is None
    assert page.evaluate("document.documentElement.scrollWidth") <= 1440
    assert page.locator("#panel").evaluate("e => e.scrollWidth <= e.clientWidth")
    opened.check(path)


@pytest.mark.browser
def test_the_policy_itself_stops_a_script(
    plan: JointPlan, net: RoadNetwork, visit: Callable[..., Any], tmp_path: Path
) -> None:
    """Were a name to become markup, the policy would still keep it from running."""
    path = tmp_path / "plan.html"
    write_html(plan, net, path)
    text = path.read_text()
    attack = "<script>window.hacked=1</script><img src=x onerror=window.hacked=1>"
    path.write_text(text.replace("</h1>", f"</h1>{attack}"))
    opened = visit(path)
    assert opened.page.evaluate("window.hacked") is None
    assert any("Content Security Policy" in line for line in opened.complaints)


@pytest.mark.parametrize("name", HOSTILE, ids=range(len(HOSTILE)))
def test_json_cannot_leave_its_element(name: str) -> None:
    text = json_for_html({"name": shown(name)})
    assert not set(text) & set("<>&\u2028\u2029")
    assert json.loads(text) == {"name": shown(name)}


def test_filled_values_are_escaped_and_read_once() -> None:
    text = written(Piece("item", {"text": "$x <b> & \" '"}))
    assert text == "<li><bdi>$x &lt;b&gt; &amp; &quot; &#x27;</bdi></li>"
    # Written fragments are not escaped again; plain strings always are.
    assert written(Piece("item", {"text": text})).count("<li>") == 2
    assert written(Piece("item", {"text": str.__str__(text)})).count("<li>") == 1
    with pytest.raises(KeyError):
        written(Piece("item"))
    with pytest.raises(KeyError):
        written(Piece("no such fragment"))


def test_pieces_stand_one_a_line_and_texts_among_them_are_escaped() -> None:
    item = Piece("item", {"text": "a"})
    line = written(item)
    assert written((item, item)) == f"{line}\n{line}"
    assert written(((), item)) == f"\n{line}"
    assert written(()) == ""
    values: tuple[object, ...] = ("<b>", ["<i>", item], ("</p>",))
    text = written(Piece("item", {"text": values}))
    assert not {"<b>", "<i>", "</p>"} & set(re.findall(r"</?[bip]>", text))
