"""Who leads when in the page, the schedule, figures and drivers' sheets of a rotated plan."""

from __future__ import annotations

import html
import re
from dataclasses import replace
from datetime import datetime
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from random_networks import network

import platoon_osm as po
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.positions import positions_of
from platoon_osm.report.charts.schedule_figure import draw_schedule
from platoon_osm.report.document.document import document_of
from platoon_osm.report.document.findings import find
from platoon_osm.report.sheets.steps import steps_of

SIX = datetime(2026, 3, 2, 6)


@cache
def planned(lead: str = "rotated", timed: bool = True) -> tuple[Plan, RoadNetwork]:
    """A and B drive 400 km together; C joins for the last 200 km."""
    lon = np.append(np.linspace(9, 13, 41), 11.0)
    net = network([*range(40), 41], [*range(1, 41), 20], [10e3] * 40 + [5e3],
                  lon, np.append(np.full(41, 45.0), 45.1))  # fmt: skip
    trips = [
        po.Trip(name, origin, 40, SIX if timed else None)
        for name, origin in (("A", 0), ("B", 0), ("C", 41))
    ]
    costs = po.PaperCosts(positions="plafosim")
    options = {"master": "A", "patience_min": 600}
    return po.plan_joint(net, costs, trips, lead=lead, **options), net


def text_of(source: str) -> str:
    bare = re.sub(r"<(style|script)[^>]*>.*?</\1>", "", source, flags=re.DOTALL)
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]+>", "", bare)))


def written(plan: Plan, net: RoadNetwork, folder: Path, **options: str) -> str:
    path = folder / "page.html"
    po.write_html(plan, net, path, **options)
    return path.read_text("utf-8")


def test_the_page_tells_who_leads_from_where_on(tmp_path):
    plan, net = planned()
    page = written(plan, net, tmp_path)
    told = text_of(page)
    assert "Who leads" in told
    assert "Number: position in the platoon; 1 leads." in told
    changes = plan.rotation.changes
    assert len(changes) >= 3
    for change in changes:
        leader = plan.stretches[change.stretch].vehicles[0]
        at = plan.times[leader].legs[plan.ways[leader].index(change.stretch)][0]
        clock = plan.timetable.clock.text(at)
        who = plan.trips[leader].vehicle
        assert f"{change.point.name}: {clock}, {who} leads" in told
    # Merges and separations are told as ever, each once.
    before, _ = planned("master")
    rows = [re.findall(r'<li><button type="button" class="event".*?</li>', some)
            for some in (page, written(before, net, tmp_path))]  # fmt: skip
    assert rows[0] == rows[1]


def test_numbers_in_the_schedule_are_the_positions(tmp_path):
    plan, net = planned()
    page = written(plan, net, tmp_path)
    schedule = page[page.index('id="h-schedule') :]
    schedule = schedule[: schedule.index("</svg>")]
    rows = schedule.split('data-vehicle="')[1:]
    assert len(rows) == 3
    spans = positions_of(plan)
    for index, row in enumerate(rows):
        numbers = re.findall(r'<text class=\w+ y="4">(\d)</text>', row)
        own = [str(one.position) for one in spans if one.vehicle == index and one.size > 1]
        # The road is long enough for all of them.
        assert numbers == own
    document = document_of(plan, net)
    for index, marks in enumerate(document.positions):
        legs = plan.times[index].legs
        for mark in marks:
            assert any(begin - 0.1 <= mark.begin_s < end for begin, end in legs)


@pytest.mark.parametrize("timed", [True, False])
def test_nothing_is_told_where_leaders_stay_in_front(tmp_path, timed):
    plan, net = planned("master", timed)
    page = written(plan, net, tmp_path)
    assert "h-leads" not in page
    assert "position in the platoon" not in page
    document = document_of(plan, net)
    assert not document.leads
    assert not any(document.positions)


@pytest.mark.parametrize(
    ("language", "heading"), [("de", "Wer führt"), ("it", "Chi è in testa"), ("en", "Who leads")]
)
def test_without_times_and_in_other_languages(tmp_path, language, heading):
    plan, net = planned(timed=False)
    assert heading in text_of(written(plan, net, tmp_path, language=language))


def test_sheets_tell_when_to_take_the_lead_and_when_to_hand_it_on(tmp_path):
    plan, net = planned()
    po.write_sheets(plan, net, tmp_path)
    for index, trip in enumerate(plan.trips):
        told = text_of((tmp_path / f"{trip.vehicle.lower()}.html").read_text("utf-8"))
        takes = sum(plan.stretches[one.stretch].vehicles[0] == index
                    for one in plan.rotation.changes)  # fmt: skip
        gives = [one for one in plan.rotation.changes if one.former == index]
        assert told.count("Take the lead.") == takes
        assert told.count("Hand on the lead to ") == len(gives)
        last = [one for one in gives if plan.stretches[one.stretch].vehicles[-1] == index]
        assert told.count("fall back to the end.") == len(last)
        steps = steps_of(find(plan, net).plan, net, index)
        for change in plan.rotation.changes:
            if change.stretch in plan.ways[index]:
                place = plan.ways[index].index(change.stretch)
                at_m = sum(plan.stretches[k].length_m for k in plan.ways[index][:place])
                (step,) = (one for one in steps if one.at_m == pytest.approx(at_m))
                assert step.place.name == change.point.name
                assert step.lead == (plan.stretches[change.stretch].vehicles[0], change.former)


def test_who_does_not_fall_back_to_the_end_is_not_told_so(tmp_path):
    plan, net = planned()
    change = next(one for one in plan.rotation.changes
                  if len(plan.stretches[one.stretch].vehicles) > 2)  # fmt: skip
    stretches = list(plan.stretches)
    leader, *others = stretches[change.stretch].vehicles
    order = (leader, *sorted(others, key=lambda one: one != change.former))
    stretches[change.stretch] = replace(stretches[change.stretch], vehicles=order)
    po.write_sheets(replace(plan, stretches=tuple(stretches)), net, tmp_path)
    former, leads = (plan.trips[one].vehicle for one in (change.former, leader))
    told = text_of((tmp_path / f"{former.lower()}.html").read_text("utf-8"))
    assert f"Hand on the lead to {leads}. " in told


def test_figures_show_positions():
    from matplotlib.figure import Figure

    plan, net = planned()
    document = document_of(plan, net)
    axes = Figure(figsize=(7, 3)).subplots()
    draw_schedule(axes, document, document.schedule, [{}] * 3)
    numbers = [(round(text.get_position()[1]), text.get_text()) for text in axes.texts
               if text.get_text().isdigit()]  # fmt: skip
    assert numbers == [(one.vehicle, str(one.position)) for one in positions_of(plan)
                       if one.size > 1]  # fmt: skip
    assert "1 leads" in axes.get_xlabel().replace("\n", " ")
