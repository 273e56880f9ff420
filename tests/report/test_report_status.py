"""A late plan does not look like a success, a plan without a platoon does not speak of one."""

from __future__ import annotations

import re
from collections.abc import Callable
from datetime import datetime, timedelta
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from bundled import italy
from plan_kinds import KINDS, plan_kind

from platoon_osm.costs.paper import paper_weights
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.lateness import NOT_IN_TIME, status_lines, who_is_late
from platoon_osm.plans.trip import Trip
from platoon_osm.report import report_document, write_comparison, write_flows, write_html
from platoon_osm.report.document.status import lateness
from platoon_osm.report.document.status import status as page_status
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
    assert "; alone they would be in time; give earlier departures, " in late[0][1]
    alone = status("late even alone")
    given = "; give earlier departures or later arrivals"
    assert alone[0][1].endswith(f"all of them late even alone{given}")
    assert alone[1] == ("plain", "No platoon: all vehicles drive alone")


def test_all_in_time_is_said_where_times_are_asked_for() -> None:
    assert status("three vehicles") == [("good", "All in time")]
    assert status("two vehicles") == []
    assert status("without times") == []


@pytest.mark.parametrize("kind", [kind for kind in KINDS if "hundred" not in kind])
def test_a_summary_says_the_same(kind: str) -> None:
    plan, _ = plan_kind(kind)
    told = [text for _, text in status(kind)]
    if "long" not in kind and "script" not in kind:
        head = plan.summary().partition("\n\n")[0]
        # The page adds what would have to give.
        short = [text.partition("; give ")[0] for text in told]
        assert head.splitlines()[-len(told) or 99 :] == [f"{text}." for text in short]
    assert len(told) == len(list(status_lines(plan)))


def test_who_is_late_even_alone() -> None:
    late = [day(3600.0, 60.0), day(0.0, 0.0), day(7200.0, 0.0), None, day(0.5, None)]
    found = who_is_late(late)
    assert (found.late, found.even_alone, found.most_s) == ((0, 2, 4), (0,), 7200.0)
    assert not found.in_time_alone
    assert who_is_late([day(60.0, 0.0), day(60.0, 0.0)]).in_time_alone
    assert not who_is_late([day(60.0, 0.0), day(60.0, None)]).in_time_alone
    assert not who_is_late([day(0.0, 0.0)]).in_time_alone
    assert who_is_late([None, day(0.0, None)]).asked
    assert not who_is_late([None, SimpleNamespace(late_s=0.0, latest_arrival_s=None)]).asked


def day(late_s: float, late_alone_s: float | None) -> Any:
    return SimpleNamespace(late_s=late_s, late_alone_s=late_alone_s, latest_arrival_s=0.0)


@pytest.mark.parametrize(
    ("late_s", "alone_s", "text"),
    [
        ((60, 60, 60), (60, 60, 60), "3 of 3 late, by up to 1 min; all of them late even alone"),
        ((60, 21420, 60), (60, 0, 0), "3 of 3 late, by up to 5 h 57 min; A is late even alone"),
        ((60, 0, 60), (60, 0, 0), "2 of 3 late, by up to 1 min; A is late even alone"),
        ((60, 60, 60), (60, 9, 0), "3 of 3 late, by up to 1 min; A and B are late even alone"),
        ((60, 0, 0), (60, 0, 0), "1 of 3 late, by 1 min; late even alone"),
        ((60, 0, 0), (0, 0, 0), "1 of 3 late, by 1 min; alone it would be in time"),
        ((60, 0, 1), (0, 0, 0), "2 of 3 late, by up to 1 min; alone they would be in time"),
        ((60, 0, 1), (0, 0, None), "2 of 3 late, by up to 1 min"),
    ],
)
def test_the_words_of_lateness(
    late_s: tuple[int, ...],
    alone_s: tuple[int | None, ...],
    text: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    days = [day(late, alone) for late, alone in zip(late_s, alone_s, strict=True)]
    assert [one.text for one in page_status("ABC", days, True)] == [text]
    plan, _ = plan_kind("three vehicles")
    monkeypatch.setattr("platoon_osm.plans.lateness._days", lambda _: days)
    assert list(status_lines(plan)) == [text]


def test_who_ends_late_at_one_place_is_named() -> None:
    def vehicle(called: str, minutes: int) -> Any:
        text = SimpleNamespace(late=f"{minutes} min" if minutes else "")
        return SimpleNamespace(called=called, is_late=minutes > 0, day=SimpleNamespace(text=text))

    assert list(lateness([vehicle("A", 5)])) == ["5 min late"]
    assert list(lateness([vehicle("A", 0)])) == []
    assert list(lateness([vehicle("A", 5), vehicle("B", 0)])) == ["A: 5 min late"]
    many = list(lateness([vehicle(name, 1) for name in "ABCDEFGH"]))
    assert many[:5] == [f"{name}: 1 min late" for name in "ABCDE"]
    assert many[5:] == ["and 3 more late"]
    assert len(list(lateness([vehicle(name, 1) for name in "ABCDE"]))) == 5


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
        for selector in (".status.bad", ".figures", ".costs", ".late-by")
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


def test_who_is_late_within_the_law_is_told_once() -> None:
    start = datetime(2026, 3, 2, 6)
    trips = [Trip("A", "Milano", "Napoli", start, None, start + timedelta(hours=10))]
    net = italy()
    plan = plan_joint(net, paper_weights(net), trips, rules="eu561")
    assert any(remark.startswith(NOT_IN_TIME) for remark in plan.remarks)
    told = [(one["kind"], one["text"]) for one in report_document(plan, net)["status"]]
    late = [text for kind, text in told if kind == "bad"]
    assert len(late) == 1
    assert late[0].count("late even alone") == 1
    assert late[0].endswith("late even alone; give earlier departures or later arrivals")
    # What would do stands right below, and nowhere else.
    ways = [remark for remark in plan.remarks if remark.startswith("A would be in time ")]
    assert ways
    assert told[1 : 1 + len(ways)] == [("plain", way) for way in ways]
    assert not {*ways} & {*report_document(plan, net)["provenance"]["remarks"]}
