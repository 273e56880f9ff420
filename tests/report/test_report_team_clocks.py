"""The law's clocks of two drivers in one vehicle: each has its own, on the page and in the data."""

from __future__ import annotations

import re
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest
from bundled import italy
from paused_plans import night

import platoon_osm as po
from platoon_osm import Plan, RoadNetwork
from platoon_osm.plans.pauses import DriverDay
from platoon_osm.report import report_document

MIN, H = 60.0, 3600.0
STEP = 10.0
EITHER = {"driven_since_break_h": 2, "driven_today_h": 3, "duty_h": 4, "drivers": 2}


@pytest.fixture(scope="module")
def planned() -> tuple[Plan, RoadNetwork]:
    """A team with a day behind it, all the way south, and one driver alone."""
    net, six = italy(), datetime(2026, 3, 3, 6)
    trips = [
        po.Trip("A", "Torino", "Reggio Calabria", six, driver=EITHER),
        po.Trip("B", "Verona", "Napoli", six),
    ]
    return po.plan_joint(net, po.paper_weights(net), trips, rules="eu561"), net


def walked(plan: Plan, index: int, day: DriverDay) -> tuple[float, float, float, float]:
    """What one of two drives, and the most of its clocks, walked through the trip in steps."""
    times = plan.times[index]
    assert times is not None
    spell, today = day.state.driven_since_break_s, day.state.driven_today_s
    duty, asleep = day.state.duty_s or 0.0, day.state.duty_s is None
    most, driven, idle, stood = [0.0, 0.0, 0.0], 0.0, 0.0, 0.0
    at = min(day.state_at_s, times.legs[0][0])
    while at < times.arrival_s:
        middle = at + STEP / 2
        leg = next((k for k, (a, b) in enumerate(times.legs) if a <= middle < b), None)
        stood = stood + STEP if leg is None else 0.0
        if leg is not None and (day.drives is None or leg in day.drives):
            spell = 0.0 if idle >= 45 * MIN else spell
            driven, spell, today, idle = driven + STEP, spell + STEP, today + STEP, 0.0
        else:
            idle += STEP
        if stood >= 9 * H:
            spell = today = duty = 0.0
            asleep = True
        elif leg is not None:
            asleep = False
        duty += 0.0 if asleep else STEP
        if leg is not None:  # what is stood may turn out to be a rest
            most = [max(pair) for pair in zip(most, (spell, today, duty), strict=True)]
        at += STEP
    return driven, *most  # type: ignore[return-value]


@pytest.mark.parametrize("made", ["planned", "at night"])
def test_each_driver_has_clocks_of_its_own(made: str, planned: tuple[Plan, RoadNetwork]) -> None:
    plan, net = planned if made == "planned" else night()
    assert plan.timetable is not None
    named = replace(plan, timetable=replace(plan.timetable, rules="eu561"))
    for index, clocks in enumerate(report_document(named, net)["law"]["vehicles"]):
        times = named.times[index]
        assert times is not None
        assert len(clocks["each"]) == len(times.drivers) == clocks["drivers"]
        for own, day in zip(clocks["each"], times.drivers, strict=True):
            found = own["driving_s"], own["spell_s"], own["day_s"], own["duty_s"]
            assert found == pytest.approx(walked(named, index, day), abs=60)
        for clock in ("spell", "day", "duty"):
            assert clocks[f"{clock}_s"] == max(own[f"{clock}_s"] for own in clocks["each"])


def test_what_each_of_two_may_is_what_one_may(planned: tuple[Plan, RoadNetwork]) -> None:
    team, alone = report_document(*planned)["law"]["vehicles"]
    assert [own["allowed"]["spell"] for own in team["each"]] == [4.5 * H] * 2
    assert {own["allowed"]["day"] for own in team["each"]} <= {9 * H, 10 * H}
    assert [own["allowed"]["duty"] for own in team["each"]] == [21 * H] * 2
    assert sum(own["driving_s"] for own in team["each"]) == pytest.approx(team["driving_s"])
    assert not team["excess"]
    (own,) = alone["each"]
    assert {key: alone[key] for key in own} == own


def test_who_of_two_drives_too_long_is_found(planned: tuple[Plan, RoadNetwork]) -> None:
    """One who drives all the way goes beyond everything; the other beyond nothing."""
    plan, net = planned
    assert plan.timetable is not None
    first, *others = plan.timetable.vehicles
    one, other = first.drivers
    days = replace(one, drives=tuple(range(len(first.legs)))), replace(other, drives=())
    table = replace(plan.timetable, vehicles=(replace(first, drivers=days), *others))
    team = report_document(replace(plan, timetable=table), net)["law"]["vehicles"][0]
    assert [len(own["excess"]) for own in team["each"]] == [2, 0]
    assert [own["clock"] for own in team["excess"]] == ["spell", "day"]


@pytest.mark.parametrize(
    ("language", "called"), [("en", "driver"), ("de", "Fahrer"), ("it", "conducente")]
)
def test_each_has_a_row_of_the_chart_and_of_the_table(
    language: str, called: str, planned: tuple[Plan, RoadNetwork], tmp_path: Path
) -> None:
    plan, net = planned
    page = tmp_path / "team.html"
    po.write_html(plan, net, page, language=language)
    text = page.read_text(encoding="utf-8")
    law = text[text.index('<section class="law"') :]
    law = law[: law.index("</section>")]
    assert re.findall(r'<text [^>]*\bx="?29"?[ >][^>]*>(\d)</text>', law) == ["1", "2"]
    spoken = re.search('aria-label="([^"]*)"', law)
    assert spoken is not None
    assert [f"A, {called} {number}: " in spoken[1] for number in (1, 2)] == [True, True]
    assert law.count("<polyline") == 9  # three clocks of three drivers
    assert re.findall(rf"<small>{called} (\d), ", law) == ["1", "2"]
    assert law.count("<tr data-vehicle=") == 3
