"""Several plans of the same trips side by side on one page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from po_valley import THREE, make_plan
from rested_plans import corridor, corridor_with_breaks

from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.plans.standing import rested_s
from platoon_osm.report import comparison_document, report_document, write_comparison
from platoon_osm.report.markup.quantities import clock_span

Visit = Callable[..., Any]

browser = pytest.mark.browser


@pytest.fixture(scope="module")
def plans(net: RoadNetwork) -> list[JointPlan]:
    """Three vehicles together, two of them together, and all alone."""
    apart = [(name, origin, end, None, None) for name, origin, end, *_ in THREE]
    return [
        make_plan(net, THREE),
        make_plan(net, [*THREE[:2], apart[2]], case="A"),
        make_plan(net, apart, case="B"),
    ]


@pytest.fixture(scope="module")
def page_file(
    plans: Sequence[JointPlan], net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory
) -> Path:
    path = tmp_path_factory.mktemp("comparison") / "compare.html"
    write_comparison(plans, net, path)
    return path


def test_each_plan_is_the_document_of_its_own_page(
    plans: Sequence[JointPlan], net: RoadNetwork
) -> None:
    found = comparison_document(plans, net)
    assert [plan["title"] for plan in found["plans"]] == ["Case C", "Case A", "Case B"]
    for plan, shown in zip(plans, found["plans"], strict=True):
        assert shown["totals"] == report_document(plan, net)["totals"]


def test_a_vehicle_looks_the_same_in_all_plans(net: RoadNetwork) -> None:
    """Long names get letters; those must go with the vehicle, not with its place in a plan."""
    long = [(f"Truck {name}", *rest) for name, *rest in THREE]
    alone = [(name, origin, end, None, None) for name, origin, end, *_ in reversed(long)]
    found = comparison_document([make_plan(net, long), make_plan(net, alone)], net)
    looks = [
        {(v["name"], v["letter"], v["colour"], v["dash"]) for v in plan["vehicles"]}
        for plan in found["plans"]
    ]
    assert looks[0] == looks[1]


def test_other_parameters_are_told(plan: JointPlan, net: RoadNetwork) -> None:
    other = replace(plan, params=dict(paper_weights(net, tau=0.5).params))
    remarks = comparison_document([plan, other], net)["sets"][0]["remarks"]
    assert any("other cost parameters" in remark for remark in remarks)
    assert comparison_document([plan, plan], net)["sets"][0]["remarks"] == []
    euro = replace(plan, unit="EUR", params={})
    found = comparison_document([plan, euro], net)["sets"][0]
    assert "other units" in found["remarks"][0]
    assert found["differences"][1]["cost"] is None


def test_what_cannot_be_compared_is_refused(plan: JointPlan, net: RoadNetwork) -> None:
    shorter = RoadNetwork.from_edges([0], [1], lon=[9.0, 9.1], lat=[45.0, 45.0])
    with pytest.raises(ScenarioError, match="no plans"):
        comparison_document([], net)
    with pytest.raises(ScenarioError, match="1 titles for 2 plans"):
        comparison_document([plan, plan], net, titles=["one"])
    with pytest.raises(ScenarioError, match="load the network it was made on"):
        comparison_document([plan], shorter)


def test_same_plans_same_bytes_and_no_script(
    plans: Sequence[JointPlan], net: RoadNetwork, page_file: Path, tmp_path: Path
) -> None:
    write_comparison(plans, net, tmp_path / "again.html")
    text = page_file.read_text()
    assert (tmp_path / "again.html").read_text() == text
    assert "script-src 'none'" in text
    assert "<script" not in text
    assert len(text) < 150_000


@browser
@pytest.mark.parametrize("width", [1440, 900, 390])
@pytest.mark.parametrize("script", [True, False])
def test_page(page_file: Path, visit: Visit, width: int, script: bool) -> None:
    opened = visit(page_file, width, 900, java_script_enabled=script, wait_for=None)
    page = opened.page
    assert page.locator(".small-map").count() == 3
    assert page.locator(".card .figure").count() == 9
    texts = page.locator(".sums tbody tr").all_inner_texts()
    assert [text.split()[1] for text in texts] == ["C", "A", "B"]
    if script:
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.locator(".small-map").first.bounding_box()["width"] > 0.25 * width
        # No sum has to be scrolled to, and none runs into the next one.
        box = ".table-box:has(.sums)"
        assert page.locator(box).evaluate("e => e.scrollWidth <= e.clientWidth")
        assert page.locator(f"{box} td").evaluate_all(
            "all => all.every(e => e.scrollWidth <= e.clientWidth + 1)"
        )
        heads = page.get_by_role("columnheader", name="In platoon", include_hidden=False)
        assert heads.count() == 1
        assert page.get_by_role("row", name="C").get_by_role("cell").count() >= 6
    opened.check(page_file)


@browser
def test_the_network_shows_in_every_map(page_file: Path, visit: Visit) -> None:
    page = visit(page_file, wait_for=None).page
    widths = page.evaluate(
        "[...document.querySelectorAll('use[href=\"#small-network\"]')]"
        ".map(e => e.getBoundingClientRect().width)"
    )
    assert len(widths) == 6
    assert min(widths) > 100


@browser
def test_bars_add_up(page_file: Path, plans: Sequence[JointPlan], visit: Visit) -> None:
    """A bar's length, in pixels, is to another's as the savings are."""
    page = visit(page_file, wait_for=None).page
    lengths = page.evaluate(
        """[...document.querySelectorAll('.bars > g')].map(row =>
          [...row.querySelectorAll('rect')].reduce((s, e) => s + +e.getAttribute('width'), 0))"""
    )
    assert lengths[2] == 0
    assert lengths[0] / lengths[1] == pytest.approx(plans[0].saving / plans[1].saving, rel=0.01)


LEGIBLE = """() => [...document.querySelectorAll('svg text')]
  .filter(e => e.getBoundingClientRect().width)
  .map(e => [e.getScreenCTM().a * parseFloat(getComputedStyle(e).fontSize), e.textContent])"""


@browser
@pytest.mark.parametrize("width", [1440, 900, 600, 390])
def test_texts_of_drawings_are_legible(page_file: Path, visit: Visit, width: int) -> None:
    page = visit(page_file, width, 900, wait_for=None).page
    texts = page.evaluate(LEGIBLE)
    assert len(texts) > 30
    small = [text for size, text in texts if size < 9.4 and len(text) > 2]
    assert small == []
    assert page.locator(".small-map .names text:visible").count() >= 9


@browser
def test_tables_keep_their_first_column_on_a_small_screen(page_file: Path, visit: Visit) -> None:
    page = visit(page_file, 390, 844, wait_for=None).page
    for table in page.locator(".table-box table").all():
        head = table.locator("tbody th").first
        assert head.bounding_box()["width"] >= 120
        table.evaluate("e => { e.parentElement.scrollLeft = 500; }")
        assert head.bounding_box()["x"] >= 0


# -- plans under driving rules ---------------------------------------------------------------------


@pytest.fixture(scope="module")
def ruled() -> tuple[list[JointPlan], RoadNetwork]:
    """The same corridor without rules and with breaks, the latter twice."""
    (with_breaks, net) = corridor_with_breaks()
    return [corridor(), with_breaks, with_breaks], net


def test_breaks_and_hours_are_compared(ruled: tuple[list[JointPlan], RoadNetwork]) -> None:
    plans, net = ruled
    none, other, same = (
        comparison_document([plans[k], plans[1]], net)["sets"][0]["differences"][1]
        for k in (0, 0, 1)
    )
    assert (same["rests_s"], same["under_way_s"]) == (0, 0)
    assert none["rests_s"] is other["rests_s"] is None
    hours = [
        sum(times.arrival_s - times.departure_s for times in plan.timetable.vehicles)
        for plan in plans[:2]
    ]
    assert other["under_way_s"] == pytest.approx(hours[1] - hours[0])
    assert other["under_way_s"] > 45 * 60


@browser
@pytest.mark.parametrize("width", [1440, 390])
def test_the_table_tells_the_law(
    ruled: tuple[list[JointPlan], RoadNetwork], visit: Visit, tmp_path: Path, width: int
) -> None:
    plans, net = ruled
    path = tmp_path / "law.html"
    titles = ["Corridor, rules none", "Corridor, rules eu561", "Corridor, again"]
    write_comparison(plans, net, path, titles=titles)
    page = visit(path, width, 900, wait_for=None).page
    day = page.locator(".sums").nth(1)
    heads = day.locator("thead th").all_text_contents()
    at = [heads.index(one) - 1 for one in ("Breaks", "Door to door", "Law")]
    rows = [row.locator("td").all_text_contents() for row in day.locator("tbody tr").all()]
    stood = sum(map(rested_s, plans[1].timetable.vehicles))
    assert [rows[0][k] for k in (at[0], at[2])] == ["0", "\u2013"]
    assert clock_span(stood) in rows[1][at[0]]
    assert rows[1][at[2]] in ("kept", "not kept")
    assert "+" in rows[1][at[1]]
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.locator(".table-box").evaluate_all(
        "all => all.every(e => e.scrollWidth <= e.clientWidth)"
    )
    # What all titles begin with is told once: heads of narrow columns show what differs.
    own = page.locator("table.costs:not(.sums) thead th.number").all_inner_texts()
    assert [" ".join(one.split()) for one in own] == ["rules none", "rules eu561", "again"]
