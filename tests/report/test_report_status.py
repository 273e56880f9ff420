"""A late plan does not look like a success, a plan without a platoon does not speak of one."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from plan_kinds import plan_kind

from platoon_osm.report import report_document, write_comparison, write_flows, write_html
from platoon_osm.report.pages.notebook import plan_table

Visit = Callable[..., Any]

browser = pytest.mark.browser


def status(kind: str) -> list[tuple[str, str]]:
    plan, net = plan_kind(kind)
    return [(one["kind"], one["text"]) for one in report_document(plan, net)["status"]]


def test_who_is_late_is_said_first() -> None:
    ((kind, text),) = status("all are late")
    assert kind == "bad"
    assert text.startswith("3 of 3 late, by up to ")
    assert status("one is late")[0][1].startswith("1 of 3 late, by ")
    late = status("late in company")
    assert late[0][0] == "bad"
    assert late[0][1].endswith("alone they would be in time")
    alone = status("late even alone")
    assert alone[0][1].endswith("all of them late even alone")
    assert alone[1] == ("plain", "No platoon: all vehicles drive alone")


def test_all_in_time_is_said_where_times_are_asked_for() -> None:
    assert status("three vehicles") == [("good", "All in time")]
    assert status("two vehicles") == []
    assert status("without times") == []


def test_a_late_plan_is_no_success() -> None:
    for kind, looks in (("all are late", "plain"), ("three vehicles", "good")):
        plan, net = plan_kind(kind)
        assert report_document(plan, net)["totals"]["figures"][0]["kind"] == looks


def test_vehicles_are_called_alike() -> None:
    plan, _ = plan_kind("long names")
    assert re.search(r"A \(\W*Cold chain", plan_table(plan))
    plan, _ = plan_kind("all are late")
    assert "3 of 3 late" in plan_table(plan)
    assert '<th scope="col">Late</th>' in plan_table(plan)
    plan, _ = plan_kind("three vehicles")
    assert '<th scope="col">Late</th>' not in plan_table(plan)


@browser
@pytest.mark.parametrize("width", [1440, 390])
def test_a_late_page(visit: Visit, tmp_path: Path, width: int) -> None:
    plan, net = plan_kind("all are late")
    write_html(plan, net, tmp_path / "late.html")
    opened = visit(tmp_path / "late.html", width, 900)
    page = opened.page
    status = page.locator(".panel > header .status.bad")
    assert status.inner_text().startswith("3 of 3 late, by up to ")
    good = page.evaluate("getComputedStyle(document.documentElement).getPropertyValue('--good')")
    colours = page.evaluate(
        """() => {
          const rgb = (e) => getComputedStyle(e).color;
          const probe = document.createElement("i");
          probe.style.color = "var(--good)";
          document.body.append(probe);
          return { good: rgb(probe), figures: [...document.querySelectorAll(".figure *")].map(rgb),
            proof: getComputedStyle(document.querySelector(".proof")).borderLeftColor };
        }"""
    )
    assert good.strip()
    assert colours["good"] not in colours["figures"]
    assert colours["proof"] != colours["good"]
    # Status, figures, table, and lateness in each row, in this order.
    tops = [
        page.locator(selector).first.bounding_box()["y"]
        for selector in (".status.bad", ".figures", ".costs", ".late")
    ]
    assert tops == sorted(tops)
    assert page.locator(".costs tbody .late-by").count() == 3
    # A badge beside each destination, and in words.
    assert page.locator(".mark .late-badge").count() == 3
    labels = page.locator(".mark.end").evaluate_all("m => m.map(e => e.ariaLabel)")
    assert sum(" late" in label for label in labels) == 3
    opened.check(tmp_path / "late.html")


@browser
def test_lateness_on_paper_and_without_script(visit: Visit, tmp_path: Path) -> None:
    plan, net = plan_kind("all are late")
    write_html(plan, net, tmp_path / "late.html")
    page = visit(tmp_path / "late.html", java_script_enabled=False).page
    assert page.locator(".static-map title").filter(has_text=" late").count() >= 3
    page.emulate_media(media="print")
    assert page.locator(".status.bad").is_visible()
    assert page.locator(".late-by").first.is_visible()


@browser
def test_lateness_on_flows_and_comparison(visit: Visit, tmp_path: Path) -> None:
    late, net = plan_kind("all are late")
    fine, _ = plan_kind("three vehicles")
    write_flows(late, net, tmp_path / "flows.html")
    page = visit(tmp_path / "flows.html", wait_for="html[data-ready]").page
    assert "3 of 3 late" in page.locator("header .status.bad").inner_text()
    assert page.locator(".list .late-by").first.inner_text() == "3 late"
    write_comparison([fine, late], net, tmp_path / "compare.html")
    page = visit(tmp_path / "compare.html", wait_for=None).page
    cards = page.locator(".card").all_inner_texts()
    assert "All in time" in cards[0]
    assert "3 of 3 late" in cards[1]
    assert page.locator(".card").nth(1).locator(".figure.good").count() == 0


@browser
@pytest.mark.parametrize("kind", ["all alone", "one vehicle"])
def test_without_a_platoon_none_is_spoken_of(kind: str, visit: Visit, tmp_path: Path) -> None:
    plan, net = plan_kind(kind)
    write_html(plan, net, tmp_path / "alone.html")
    write_flows(plan, net, tmp_path / "flows.html")
    for name, ready in (("alone.html", "#map_plan[data-ready]"), ("flows.html", None)):
        opened = visit(tmp_path / name, wait_for=ready)
        page = opened.page
        said = page.locator(".status").last
        assert said.inner_text().startswith("No platoon: ")
        said.evaluate("e => e.remove()")
        texts = page.locator("body").inner_text() + page.title()
        spoken = re.sub(r"platoon_osm|platoon = \S+|platoon-osm", "", texts)
        assert "platoon" not in spoken.lower()
        assert "merge" not in spoken.lower()
        opened.check(tmp_path / name)
