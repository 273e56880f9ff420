"""Plans by several driving rules side by side: breaks, rests, hours, and what the law says."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from paused_plans import MIN, Stop, night, paused, stops_of_a_day
from plan_kinds import plan_kind

from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import Plan
from platoon_osm.report import comparison_document, report_document, write_comparison

Visit = Callable[..., Any]

browser = pytest.mark.browser


@cache
def plans() -> tuple[list[Plan], RoadNetwork]:
    """Without rules; with breaks and a ban; with a night too long a way; and one that is late."""
    free, net = plan_kind("three vehicles")
    third = Stop(free.ways[2][-1], 0.4, 45 * MIN)
    day = paused(free, net, [*stops_of_a_day(free), third])
    return [free, day, night()[0], late(day, 0, 40 * MIN)], net


def late(plan: Plan, who: int, by_s: float) -> Plan:
    """Return a plan in which a vehicle was to arrive earlier."""
    assert plan.timetable is not None
    vehicles = list(plan.timetable.vehicles)
    vehicles[who] = replace(vehicles[who], latest_arrival_s=vehicles[who].arrival_s - by_s)
    remark = "not feasible in time within the law: late even alone: A by 40 min; give earlier"
    table = replace(plan.timetable, vehicles=tuple(vehicles), feasible=False)
    return replace(plan, timetable=table, remarks=(f"{remark} departures or later arrivals",))


def test_breaks_and_hours_are_those_of_the_tables_of_each_plan() -> None:
    made, net = plans()
    found = comparison_document(made, net)["sets"][0]
    for plan, sums, difference in zip(made, found["sums"], found["differences"], strict=True):
        pauses = plan.to_frame("pauses")
        kinds = [str(one) for one in pauses["purposes"]]
        rests = pauses.loc[["_rest" in kind for kind in kinds]]
        breaks = pauses.loc[
            [bool(re.search("break|part", kind)) and "_rest" not in kind for kind in kinds]
        ]
        assert (sums["breaks"], sums["rests"]) == (len(breaks), len(rests))
        assert sums["breaks_s"] == pytest.approx(60 * breaks["lasts_min"].sum())
        assert sums["rests_s"] == pytest.approx(60 * rests["lasts_min"].sum())
        days = plan.timetable.vehicles
        hours = sum(one.legs[-1][1] - one.departure_s for one in days)
        assert sums["under_way_s"] == pytest.approx(hours)
        if difference is not None:
            apart = hours - found["sums"][0]["under_way_s"]
            assert difference["under_way_s"] == pytest.approx(apart)
    assert [one["rules"] for one in found["sums"]] == ["", "eu561", "eu561", "eu561"]
    assert sum(one["breaks"] for one in found["sums"]) > 0
    assert sum(one["rests"] for one in found["sums"]) > 0


def test_what_the_law_says_of_a_plan() -> None:
    made, net = plans()
    free, day, *_ = made
    held = replace(
        day,
        timetable=replace(
            day.timetable,
            vehicles=tuple(
                replace(one, latest_departure_s=one.departure_s - 600.0 * number)
                for number, one in enumerate(day.timetable.vehicles)
            ),
        ),
    )
    unbroken = replace(free, timetable=replace(free.timetable, rules="eu561"))
    long = replace(
        unbroken,
        timetable=replace(
            unbroken.timetable,
            feasible=True,
            vehicles=tuple(
                replace(
                    one,
                    latest_arrival_s=None,
                    legs=tuple((3.0 * begin, 3.0 * end) for begin, end in one.legs),
                )
                for one in unbroken.timetable.vehicles
            ),
        ),
    )
    found = comparison_document([free, day, made[3], held, long], net)["sets"][0]["sums"]
    told = [(one["law"], one["by_s"]) for one in found]
    assert told[:3] == [("", 0.0), ("kept", 0.0), ("late", pytest.approx(2400.0))]
    assert told[3] == ("leaves late", pytest.approx(1200.0))
    assert told[4][0] == "beyond"
    excess = [
        one["counted_s"] - one["allowed_s"]
        for own in report_document(long, net)["law"]["vehicles"]
        for one in own["excess"]
    ]
    assert told[4][1] == pytest.approx(max(excess))


def test_what_is_proved_stands_beside_costs() -> None:
    (free, *_), net = plans()
    gaps = []
    for kind, bound in (("exact", 1.0), ("bound", 0.9), ("heuristic", None)):
        cost = free.proof.cost
        proof = replace(free.proof, kind=kind, bound=bound and bound * cost)
        gaps.append(replace(free, proof=proof))
    found = comparison_document(gaps, net)["sets"][0]["gaps"]
    assert found == [0.0, pytest.approx(0.1), None]


def test_who_is_late_is_told_once() -> None:
    made, net = plans()
    status = [one["text"] for one in report_document(made[3], net)["status"]]
    assert sum("late even alone" in text for text in status) == 1
    assert status[0].endswith("late even alone; give earlier departures or later arrivals")
    german = [one["text"] for one in report_document(made[3], net, language="de")["status"]]
    assert sum("allein" in text for text in german) == 1
    # A remark of who cannot be in time heads the page where the plan itself names nobody late.
    day = replace(made[1], remarks=made[3].remarks)
    assert any("A by 40 min" in one["text"] for one in report_document(day, net)["status"])


@browser
@pytest.mark.parametrize("language", ["en", "de", "it"])
@pytest.mark.parametrize("width", [1440, 900, 390])
def test_the_page(visit: Visit, tmp_path: Path, width: int, language: str) -> None:
    made, net = plans()
    path = tmp_path / "law.html"
    write_comparison(made, net, path, titles=["Free", "Day", "Night", "Late"], language=language)
    opened = visit(path, width, 900, wait_for=None)
    page = opened.page
    day = page.locator(".sums").nth(1)
    rows = day.locator("tbody tr")
    assert rows.count() == 4
    assert "561/2006" in rows.nth(1).inner_text()
    law = [rows.nth(number).locator("td").nth(1).inner_text() for number in range(4)]
    assert law[:2] == ["\u2013", {"en": "kept", "de": "eingehalten", "it": "rispettata"}[language]]
    assert "34 min" in law[2]
    assert "40 min" in law[3]
    assert rows.locator(".differs.loss").count() == 2
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.locator(".table-box").evaluate_all(
        "all => all.every(e => e.scrollWidth <= e.clientWidth)"
    )
    # No word of a table is cut or broken in two.
    assert page.locator(".sums td, .blocks th").evaluate_all(
        "all => all.every(e => e.scrollWidth <= e.clientWidth + 1)"
    )
    if width == 390:
        # Each figure with its name above, row by row of a block.
        labels = (
            rows.nth(1)
            .locator("td")
            .evaluate_all("all => all.map(e => getComputedStyle(e, '::before').content)")
        )
        assert all(len(label) > 4 for label in labels)
        assert len(labels) == len({*labels})
    opened.check(path)


@browser
def test_on_paper_no_column_is_cut(visit: Visit, tmp_path: Path) -> None:
    made, net = plans()
    write_comparison(made, net, tmp_path / "law.html", language="de")
    page = visit(tmp_path / "law.html", 680, 900, wait_for=None).page
    page.emulate_media(media="print")
    # 680 pixels are the width of a sheet between its margins.
    right = page.locator(".sums td, .blocks td").evaluate_all(
        "all => Math.max(...all.map(e => e.getBoundingClientRect().right))"
    )
    assert right <= 681
    assert page.locator(".sums").nth(1).locator("th").last.is_visible()


def test_plans_without_rules_say_nothing_of_them(tmp_path: Path) -> None:
    free, net = plan_kind("three vehicles")
    write_comparison([free, free], net, tmp_path / "free.html")
    text = (tmp_path / "free.html").read_text()
    assert "Door to door" in text
    assert "Rests" not in text
    untimed, net = plan_kind("without times")
    write_comparison([untimed, untimed], net, tmp_path / "untimed.html")
    assert "Door to door" not in (tmp_path / "untimed.html").read_text()
