"""`platoon-osm plan --html` tells what the hour is worth, where that is known."""

from __future__ import annotations

from dataclasses import replace
from importlib import resources

import pytest
from bundled import italy

from platoon_osm.cli.time_worth import time_worth
from platoon_osm.planning.scenario import read_scenario
from platoon_osm.planning.scenario.record import Scenario
from platoon_osm.plans.curves import DelayFrontier, DepartureCurve


def asked_of(name: str, rules: str) -> Scenario:
    with resources.as_file(resources.files("platoon_osm.scenarios") / f"{name}.toml") as file:
        asked = read_scenario(file)
    return replace(asked, options={**asked.options, "rules": rules})


def test_it_is_known_of_a_plan_by_the_clock() -> None:
    asked = asked_of("po-valley-c", "none")
    plan = asked.plan(italy())
    found = time_worth(asked, italy(), plan)
    assert found["frontier"].saving_share[-1] > 0.1  # type: ignore[union-attr]  # the frontier has that name
    assert plan.timetable is not None
    assert time_worth(asked, italy(), replace(plan, timetable=None)) == {}


def test_it_is_known_under_the_driving_rules_of_the_plan() -> None:
    asked = asked_of("po-valley-c", "eu561")
    plan = asked.plan(italy())
    found = time_worth(asked, italy(), plan)
    assert {one.rules for one in found.values()} == {"eu561"}
    curve = found["curve"]
    assert isinstance(curve, DepartureCurve)
    assert curve.is_exact
    # A may leave at its earliest with a stop more, or twelve minutes later with one alone.
    assert curve.best_cost == pytest.approx(plan.joint_cost)
    assert curve.cost_at([curve.begin_s[0], curve.best_s]) == pytest.approx(plan.joint_cost)
    assert curve.clock.moment(curve.best_s).isoformat() == "2026-03-02T06:12:30"
    assert len(set(curve.cost.round(3))) == 2
    frontier = found["frontier"]
    assert isinstance(frontier, DelayFrontier)
    assert (frontier.gap == 0).all()
    assert "the search ended before all was compared" not in frontier.conditions


def test_many_vehicles_under_rules_are_more_than_a_page_is_worth(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked = asked_of("po-valley-c", "eu561")
    plan = asked.plan(italy())
    monkeypatch.setattr("platoon_osm.cli.time_worth.MOST_UNDER_RULES", 2)
    assert time_worth(asked, italy(), plan) == {}
