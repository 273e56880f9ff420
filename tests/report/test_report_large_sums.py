"""Large sums and other units are neither cut nor covered, and every figure has one form."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from po_valley import THREE, make_plan
from soak import chosen, soaked

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.report import report_document, write_flows, write_html
from platoon_osm.report.markup.quantities import cost_unit

Visit = Callable[..., Any]

browser = pytest.mark.browser

UNITS = ("EUR", "JPY", "thousand-pounds-sterling")
EVERY = list(zip(UNITS * 2, (1440, 390) * 3, strict=True))
"""Each unit at each width; the first three have every unit, and both widths."""

OVERLAPS = """() => {
  const found = [];
  for (const row of document.querySelectorAll(".costs tr")) {
    const boxes = [...row.querySelectorAll(".ends, td.number, th.number, .trip > small")]
      .map(e => { const range = document.createRange(); range.selectNodeContents(e);
        return [e.textContent, range.getBoundingClientRect()]; })
      .filter(([, b]) => b.width);
    boxes.forEach(([a, p], i) => boxes.slice(i + 1).forEach(([b, q]) => {
      const beside = p.right <= q.left + 1 || q.right <= p.left + 1;
      if (!beside && p.top < q.bottom - 1 && q.top < p.bottom - 1)
        found.push(`${a} | ${b}`);
    }));
    for (const [text, box] of boxes) {
      const edge = row.closest(".table-box, .overview, .list").getBoundingClientRect();
      if (box.right > edge.right + 1 || box.left < edge.left - 1) found.push(`cut: ${text}`);
    }
  }
  for (const group of document.querySelectorAll(".bars > g")) {
    const texts = [...group.querySelectorAll(":scope > text")].slice(1)
      .map(e => [e.textContent, e.getBoundingClientRect()]).filter(([t, b]) => t && b.width);
    texts.forEach(([a, p], i) => texts.slice(i + 1).forEach(([b, q]) => {
      if (p.left < q.right && q.left < p.right) found.push(`bars: ${a} | ${b}`);
    }));
  }
  return found;
}"""


def plan_in(net: RoadNetwork, unit: str, times: float) -> Any:
    """Return a plan whose costs are so many times as large."""
    plan = make_plan(net, THREE, unit=unit)

    def grown(share: Any) -> Any:
        alone = share.alone_cost
        return replace(
            share, cost=share.cost * times, alone_cost=None if alone is None else alone * times
        )

    trips = tuple(
        replace(trip, alone=replace(trip.alone, cost=trip.alone.cost * times))
        for trip in plan.trips
    )
    stretches = tuple(replace(one, shares=tuple(map(grown, one.shares))) for one in plan.stretches)
    return replace(plan, trips=trips, stretches=stretches, params={})


def test_large_sums_have_no_decimals() -> None:
    assert cost_unit("EUR", 9_999).full(12.5) == "\u20ac12.50"
    assert cost_unit("EUR", 10_000).full(1234.5) == "\u20ac1,234"
    assert cost_unit("JPY", 10).bare(12.4) == "12"
    assert cost_unit("m", 1e7).bare(4_000_500) == "4,000"


def test_a_number_is_printed_alike_everywhere(net: RoadNetwork, tmp_path: Path) -> None:
    plan = plan_in(net, "EUR", 0.1)
    document = report_document(plan, net)
    saved = document["totals"]["text"]["saved"].lstrip("+")
    assert "." not in saved
    assert f"\u20ac{saved}" in document["totals"]["figures"][0]["label"]
    write_flows(plan, net, tmp_path / "flows.html")
    assert f"<b>+{saved}</b>" in (tmp_path / "flows.html").read_text("utf-8")


@browser
@soaked
@pytest.mark.parametrize(("unit", "width"), chosen(EVERY[:3], EVERY))
def test_sums_of_six_and_nine_digits(
    net: RoadNetwork, visit: Visit, tmp_path: Path, unit: str, width: int
) -> None:
    for times in (0.1, 300.0):
        plan = plan_in(net, unit, times)
        write_html(plan, net, tmp_path / "plan.html")
        page = visit(tmp_path / "plan.html", width, 900).page
        assert page.evaluate(OVERLAPS) == []
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.locator(".figure").evaluate_all(
            "all => all.every(e => e.scrollWidth <= e.clientWidth + 1)"
        )
