"""Breaks, rests, bans and the law's clocks: on page, map and charts, in every language."""

from __future__ import annotations

import re
from dataclasses import replace
from html.parser import HTMLParser
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hostile_names import HOSTILE
from rested_plans import MIN, H, corridor, corridor_with_breaks, two_days

from platoon_osm.driving.state import DriverState
from platoon_osm.plans.curves import DelayFrontier, DepartureCurve
from platoon_osm.plans.pauses import Pause, PausePlace
from platoon_osm.plans.plan import Plan
from platoon_osm.report import report_document, write_html
from platoon_osm.report.charts.time_worth import time_worth
from platoon_osm.report.document.document import document_of
from platoon_osm.report.document.stands import stands_of, waited_s
from platoon_osm.report.language.speech import speaking
from platoon_osm.report.markup.fragments import written


def events_of(plan: Plan, language: str = "en") -> list[dict[str, Any]]:
    return report_document(plan, corridor_with_breaks()[1], language=language)["events"]


# -- what is told ----------------------------------------------------------------------------------


def test_pauses_are_events_in_order_of_time() -> None:
    events = events_of(corridor_with_breaks()[0])
    assert [one["at_s"] for one in events] == sorted(one["at_s"] for one in events)
    told = [(one["kind"], one["name"], one["text"]) for one in events if one["until_s"]]
    assert told == [
        ("break", "Autoparco Brescia Est", "08:52, A, B and C: break, 45 min"),
        ("break", "Nogaredo", "11:05, C: break, 30 min"),
        ("ban", "Laimburg", "12:25, C: driving ban, 1 h 30 min"),
        ("break", "San Giorgio di Nogaro - Porpetto", "12:48, A: first part of a break, 15 min"),
    ]
    shared, own, ban, bare = (one for one in events if one["until_s"])
    assert shared["vehicles"] == [0, 1, 2]
    assert shared["detail"] == "until 09:37, rest area, truck spaces: 400"
    assert own["detail"] == "until 11:35, service area, also waiting for others"
    assert [one["has_parking"] for one in (shared, own, ban, bare)] == [True, True, True, False]
    assert bare["detail"] == "until 13:03, no known parking"


@pytest.mark.parametrize(
    ("language", "text"),
    [
        ("de", "08:52, A, B und C: Pause, 45 min"),
        ("it", "08:52, A, B e C: pausa, 45 min"),
    ],
)
def test_pauses_in_other_languages(language: str, text: str) -> None:
    assert text in [one["text"] for one in events_of(corridor_with_breaks()[0], language)]


def test_a_gap_is_told_by_its_pause_and_the_rest_of_it_is_waiting() -> None:
    plan, _ = corridor_with_breaks()
    for times in plan.times:
        assert times is not None
        stands = stands_of(times)
        assert sum(one.lasts_s for one in stands) == pytest.approx(times.waiting_s)
        own = sum(pause.duration_s for pause in times.pauses)
        assert waited_s(times) == pytest.approx(times.waiting_s - own)
    b = plan.times[1]
    assert b is not None
    assert [one.kind for one in stands_of(b)] == ["wait", "break"]
    # A pause within a longer gap leaves waiting before and after it.
    leg = b.pauses[0].before
    begin, end = b.legs[leg - 1][1], b.legs[leg][0]
    part = Pause(leg, ("second_part",), begin + 300, end - 600)
    stands = stands_of(replace(b, pauses=(part,)))[1:]
    assert [(one.kind, one.restarts) for one in stands] == [
        ("wait", False), ("break", True), ("wait", False),
    ]  # fmt: skip
    assert [one.lasts_s for one in stands] == pytest.approx([300, 1800, 600])


# -- the law's clocks ------------------------------------------------------------------------------


def walked(plan: Plan, index: int) -> tuple[float, float, float]:
    """The most of each clock, walked through the day minute by minute."""
    times = plan.times[index]
    assert times is not None
    driver = times.drivers[0]
    spell, day = driver.state.driven_since_break_s, driver.state.driven_today_s
    duty = driver.state.duty_s or 0.0
    asleep = driver.state.duty_s is None
    most = [0.0, 0.0, 0.0]
    at = min(driver.state_at_s, times.legs[0][0])
    stood, step = 0.0, 10.0
    while at < times.arrival_s:
        middle = at + step / 2
        if any(begin <= middle < end for begin, end in times.legs):
            if stood >= 45 * MIN:
                spell = 0.0
            if stood >= 9 * H:
                day = duty = 0.0
            stood, asleep = 0.0, False
            spell, day, duty = spell + step, day + step, duty + step
            most = [max(pair) for pair in zip(most, (spell, day, duty), strict=True)]
        else:
            stood += step
            duty += 0.0 if asleep else step
        at += step
    return most[0], most[1], most[2]


STATE = DriverState(driven_since_break_s=H, driven_today_s=3 * H, duty_s=5 * H)


@pytest.mark.parametrize("state", [DriverState(), STATE])
def test_clocks_are_those_of_a_walk_through_the_day(state: DriverState) -> None:
    plan, net = two_days()
    assert plan.timetable is not None
    table = replace(plan.timetable, vehicles=tuple(
        replace(one, drivers=(replace(one.drivers[0], state=state),))
        for one in plan.timetable.vehicles
    ))  # fmt: skip
    given = replace(plan, timetable=table)
    law = report_document(given, net)["law"]
    for index, clocks in enumerate(law["vehicles"]):
        found = clocks["spell_s"], clocks["day_s"], clocks["duty_s"]
        assert found == pytest.approx(walked(given, index), abs=40)


def test_who_goes_beyond_the_law_is_told_first() -> None:
    plan, net = two_days()
    document = report_document(plan, net)
    (bad,) = (one["text"] for one in document["status"] if one["kind"] == "bad")
    assert bad.startswith("A drives 5 h 53 min without a break (4 h 30 min are allowed); B drives ")
    spell, _ = (one["excess"] for one in document["law"]["vehicles"])
    assert [one["clock"] for one in spell] == ["spell"]
    # Half past four hours after it leaves.
    assert spell[0]["at_s"] == pytest.approx(4.5 * H, abs=60)
    # 9 h 21 are driven on the first day, which a long day allows.
    assert document["law"]["vehicles"][0]["allowed"] == {
        "spell": 4.5 * H, "day": 10 * H, "duty": 13 * H,
    }  # fmt: skip


def test_a_legal_plan_says_so_and_what_cannot_be_is_told_first() -> None:
    plan, net = corridor_with_breaks()
    status = report_document(plan, net)["status"]
    assert {"kind": "good", "text": "Legal under Regulation (EC) 561/2006 and Directive 2002/15/EC"
            } in status  # fmt: skip
    remark = "not feasible under eu561: A needs 30 min more; give a later arrival"
    told = report_document(replace(plan, remarks=(remark,)), net)
    assert {"kind": "bad", "text": remark.replace("not", "Not", 1)} in told["status"]
    assert remark not in told["provenance"]["remarks"]


def test_a_followers_clock_is_slowed_where_its_task_is_relieved() -> None:
    plan, net = corridor_with_breaks()
    assert plan.timetable is not None
    relieved = replace(plan, timetable=replace(plan.timetable, task_relief=1.0))
    alone, none = (report_document(one, net)["law"]["vehicles"] for one in (relieved, plan))
    # A leads, so its clock runs on; B drives alone on its own roads only.
    assert alone[0]["day_s"] == none[0]["day_s"]
    together = sum(leg.time_s for leg in plan.vehicles[1].legs if leg.role == "platoon")
    assert alone[1]["day_s"] == pytest.approx(none[1]["day_s"] - together, abs=1)


def test_fatigue_falls_at_a_break_and_not_at_a_first_part() -> None:
    plan, net = corridor_with_breaks()
    a, _, c = (one.fatigue.joint.values for one in document_of(plan, net).vehicles)
    falls = [sum(after < before for before, after in pairwise(one))
             for one in (a, c)]  # fmt: skip
    assert falls == [1, 2]
    without = document_of(corridor(), net).vehicles[0].fatigue.joint.values
    assert list(without) == sorted(without)


def test_who_rests_over_night_is_fresh_after_as_much_as_a_break() -> None:
    plan, net = two_days()
    assert plan.timetable is not None
    times = plan.timetable.vehicles[0]
    (rest,) = (one for one in times.pauses if one.is_rest)
    curve = document_of(plan, net).vehicles[0].fatigue.joint
    begin, end = ((at - times.departure_s) / H for at in (rest.start_s, rest.end_s))
    asleep = [
        value
        for hour, value in zip(curve.hours, curve.values, strict=True)
        if begin + 0.76 < hour <= end
    ]
    assert len(asleep) > 30
    assert set(asleep) == {curve.values[0]}


# -- how it is drawn -------------------------------------------------------------------------------


def test_each_kind_has_its_own_shape_and_only_what_is_there_is_explained(tmp_path: Path) -> None:
    plan, net = corridor_with_breaks()
    path = tmp_path / "page.html"
    write_html(plan, net, path)
    text = path.read_text("utf-8")
    assert "Outlined box: break" in text
    assert "Red stripes: driving ban." in text
    assert "Dark bar: rest." not in text
    assert 'id="icon-break"' in text
    assert 'id="icon-rest"' not in text
    assert 'data-layer="break"' in text
    assert "No known parking" in text
    # The schedule tells the minutes, and the bar of waiting leaves breaks out.
    schedule = text[text.index('id="t-schedule"') :].partition("</svg>")[0]
    assert len(re.findall(">45</text>", schedule)) == 3
    assert "url(#stripes)" in schedule
    assert "39 min" in text
    assert path.stat().st_size < 450_000
    write_html(corridor(), net, path)
    text = path.read_text("utf-8")
    assert "icon-break" not in text
    assert "stripes" not in text


def spoiled(plan: Plan, names: list[str]) -> Plan:
    """The same plan with hostile names where somebody stands, one after another."""
    assert plan.timetable is not None
    given: dict[str, str] = {}

    def hostile(place: PausePlace | None) -> PausePlace | None:
        if place is None:
            return None
        return replace(place, name=given.setdefault(place.name, names[len(given)]))

    vehicles = tuple(
        replace(
            one,
            pauses=tuple(replace(pause, place=hostile(pause.place)) for pause in one.pauses),
        )
        for one in plan.timetable.vehicles
    )
    return replace(plan, timetable=replace(plan.timetable, vehicles=vehicles))


def elements(path: Path) -> set[str]:
    """The kinds of element in a page, each with the names of its attributes."""
    found: set[str] = set()

    class Reader(HTMLParser):
        def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
            found.add(" ".join((tag, *sorted(name for name, _ in attrs))))

    reader = Reader()
    reader.feed(path.read_text("utf-8"))
    reader.close()
    return found


def test_hostile_names_of_stops_are_shown_as_they_are(tmp_path: Path) -> None:
    plan, net = corridor_with_breaks()
    path = tmp_path / "page.html"
    write_html(spoiled(plan, ["One", "Two", "Three", "Four"]), net, path)
    plain = elements(path)
    for names in (HOSTILE[:4], HOSTILE[20:24], HOSTILE[-4:]):
        write_html(spoiled(plan, names), net, path)
        assert elements(path) <= plain


@pytest.mark.browser
def test_pauses_in_the_browser(visit: Any, tmp_path: Path) -> None:
    plan, net = corridor_with_breaks()
    path = tmp_path / "hostile.html"
    write_html(spoiled(plan, HOSTILE[2:6]), net, path)
    opened = visit(path, reduced_motion="reduce")
    page = opened.page
    assert page.locator(".event-mark").count() == 8
    page.locator(".events .event").nth(2).focus()
    page.keyboard.press("Enter")
    assert page.evaluate("map_plan.getZoom()") > 10
    assert page.evaluate("window.hacked") is None
    # The slider tells who is on a break, and who stands for a ban.
    slider = page.locator(".journey input")
    slider.evaluate("e => { e.value = 250; e.dispatchEvent(new Event('input')); }")
    assert page.locator(".states").text_content() == "A, B, C on a break"
    slider.evaluate("e => { e.value = 480; e.dispatchEvent(new Event('input')); }")
    assert "C held by a driving ban" in page.locator(".states").text_content()
    # Switched off in the legend, breaks are gone from the map.
    page.locator('[data-layer="break"]').uncheck()
    assert page.locator(".event-mark").count() == 5
    assert page.evaluate("document.documentElement.scrollWidth") <= 1440
    opened.check(path)


# -- what the hour is worth ------------------------------------------------------------------------


CURVE = DepartureCurve(
    "A", ("B", "C"), "m", 100.0, "2026-03-02T06:00:00", "", (),
    begin_s=np.array([0.0, 1200.0, 2400.0]), end_s=np.array([1200.0, 2400.0, 3600.0]),
    cost=np.array([100.0, 90.0, 80.0]), end_cost=np.array([100.0, 90.0, 85.0]),
    company=np.array([0, 1, 2]), joins=(np.array([[1200.0, 3600.0]]), np.array([[2400.0, 3600.0]])),
    best_s=2400.0, best_cost=80.0, conditions=("waiting at merging points is free",),
)  # fmt: skip


def frontier(bound: list[float]) -> DelayFrontier:
    return DelayFrontier(
        ("A", "B", "C"), "m", 100.0, np.array([0.0, 30.0, 60.0]), np.array([100.0, 90.0, 80.0]),
        np.array(bound), ("", "A", "A"), np.array([0, 1, 2]),
    )  # fmt: skip


def test_curve_and_frontier_are_drawn_with_tables_of_their_numbers() -> None:
    with speaking("en"):
        text = written(time_worth(CURVE, frontier([100.0, 90.0, 80.0])))
        assert "Most is saved if A leaves at 06:40: 20.0" in text
        assert "Holds for: waiting at merging points is free." in text
        rows = re.findall("<tr>(.*?)</tr>", text, re.S)
        told = [re.findall("<td>(.*?)</td>", row, re.S) for row in rows]
        assert [one[0] for one in told if one] == [
            "06:00 \u2013 06:20", "06:20 \u2013 06:40", "06:40 \u2013 07:00",
            "0 min", "30 min", "1 h 00 min",
        ]  # fmt: skip
        assert [one[-1] for one in told if one] == ["0", "1", "2", "0", "1", "2"]
        # The curve's line: each step from its begin to its end, falling from 20 to 15 % at last.
        (line, stairs) = re.findall(r'<polyline points="([^"]*)"', text)
        ys = [float(point.split(",")[1]) for point in line.split(" ")]
        assert ys == pytest.approx([138, 138, 78, 78, 18, 48])
        assert stairs.count(" ") == 4
        assert "Dashed" not in text
        open_ = written(time_worth(None, frontier([100.0, 85.0, 70.0])))
        assert "Dashed: no plan saves more." in open_
        assert open_.count("<polyline") == 2
        assert written(time_worth(None, None)) == ""


def test_a_curve_under_rules_says_so_and_its_line_ends_where_nobody_can_leave() -> None:
    curve = replace(
        CURVE, rules="eu561", end_s=np.array([1199.0, 1799.0, 3600.0]), end_cost=CURVE.cost
    )
    with speaking("en"):
        text = written(time_worth(curve, None))
        assert "All keep their breaks and rests: Regulation (EC) 561/2006" in text
        assert "Most is saved if A leaves between 06:40 and 07:00: 20.0" in text
        assert "Where there is no line, A cannot leave." in text
        one, other = re.findall(r'<polyline points="([^"]*)"', text)
        assert (one.count(" "), other.count(" ")) == (3, 1)
        unknown = written(time_worth(replace(curve, is_exact=False), None))
        assert "More may be possible." in unknown
        assert "no line" not in unknown
        some = replace(curve, is_exact=False, bound=np.array([100.0, 85.0, 75.0]))
        bounded = written(time_worth(some, None))
        assert "Dashed: no plan saves more." in bounded
        dashed = re.findall('<polyline points="([^"]*)"[^>]*dasharray', bounded)
        assert [one.count(" ") for one in dashed] == [3, 1]


def test_names_in_a_curve_are_shown_as_they_are() -> None:
    with speaking("de"):
        plain = set(re.findall(r"<(\w+)", written(time_worth(CURVE, None))))
        for name in HOSTILE:
            text = written(time_worth(replace(CURVE, master=name, conditions=(name,)), None))
            assert set(re.findall(r"<(\w+)", text)) <= plain
