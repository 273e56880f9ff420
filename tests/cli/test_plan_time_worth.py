"""`platoon-osm plan --html` tells what the hour is worth, where that is known."""

from __future__ import annotations

from dataclasses import replace
from importlib import resources
from pathlib import Path

from bundled import italy

from platoon_osm.cli.time_worth import time_worth
from platoon_osm.planning.scenario import read_scenario


def test_it_is_known_of_a_plan_by_the_clock_and_not_under_driving_rules(tmp_path: Path) -> None:
    with resources.as_file(resources.files("platoon_osm.scenarios") / "po-valley-c.toml") as file:
        asked = read_scenario(file)
    plan = asked.plan(italy())
    found = time_worth(asked, italy(), plan)
    assert found["frontier"].saving_share[-1] > 0.1  # type: ignore[union-attr]
    assert plan.timetable is not None
    ruled = replace(plan, timetable=replace(plan.timetable, rules="eu561"))
    assert time_worth(asked, italy(), ruled) == {}
    assert time_worth(asked, italy(), replace(plan, timetable=None)) == {}
