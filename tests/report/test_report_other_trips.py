"""Plans of the same trips are compared with one of them; plans of other trips stand apart."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest
from bundled import italy as italy_map
from plan_kinds import italy, plan_kind

import platoon_osm
from platoon_osm.cli import main
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.scenario import read_scenario
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.timetable import Timetable
from platoon_osm.report import comparison_document, write_comparison

Visit = Callable[..., Any]

browser = pytest.mark.browser

LETTERS = "abcd"


@pytest.fixture(scope="module")
def four(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of the bundled scenarios, each of other trips."""
    net = italy_map()
    scenarios = [
        read_scenario(Path(str(files("platoon_osm.scenarios") / f"po-valley-{letter}.toml")))
        for letter in LETTERS
    ]
    path = tmp_path_factory.mktemp("four") / "four.html"
    plans = [scenario.plan(net) for scenario in scenarios]
    write_comparison(plans, net, path, titles=[f"Scenario {letter}" for letter in LETTERS])
    return path


def test_differences_are_to_the_chosen_plan() -> None:
    first, net = plan_kind("three vehicles")
    second, _ = plan_kind("all alone")
    for baseline in (1, "Alone"):
        found = comparison_document(
            [first, second], net, titles=["Together", "Alone"], baseline=baseline
        )
        (one,) = found["sets"]
        assert one["baseline"] == 1
        assert one["differences"][1] is None
        other = one["differences"][0]
        assert other["cost"] == pytest.approx(first.joint_cost - second.joint_cost)
        assert other["saving"] == pytest.approx(first.saving - second.saving)
        assert other["waiting_s"] == pytest.approx(
            first.timetable.waiting_s - second.timetable.waiting_s, abs=0.2  # type: ignore[union-attr]
        )  # fmt: skip
        assert found["title"] == "Together and Alone"
        assert "other time windows" in " ".join(one["remarks"])


def test_a_baseline_that_is_no_plan_is_refused() -> None:
    plan, net = plan_kind("three vehicles")
    for baseline in (2, -1, True, 0.5, "Nobody"):
        with pytest.raises(ScenarioError, match="baseline"):
            comparison_document([plan, plan], net, baseline=baseline)  # type: ignore[arg-type]


def test_unlike_trips_are_grouped() -> None:
    together, net = plan_kind("three vehicles")
    late, _ = plan_kind("all are late")
    other, _ = plan_kind("all end together")
    found = comparison_document([together, other, late], net)
    assert [one["plans"] for one in found["sets"]] == [[0, 2], [1]]
    assert found["remarks"]
    assert comparison_document([together, late], net)["remarks"] == []


def test_a_town_that_is_reached_by_another_junction_is_the_same_place() -> None:
    plan, net = plan_kind("three vehicles")
    first, *rest = plan.trips
    elsewhere = replace(first.destination, lon=first.destination.lon + 0.05)
    moved = replace(plan, trips=(replace(first, destination=elsewhere), *rest))
    (one,) = comparison_document([plan, moved], net)["sets"]
    assert one["plans"] == [0, 1]
    renamed = replace(plan, trips=(replace(first, destination=replace(elsewhere, name="X")), *rest))
    assert len(comparison_document([plan, renamed], net)["sets"]) == 2


@pytest.mark.parametrize(
    "other", [("B", "Torino", "Trieste"), ("A", "Genova", "Trieste"), ("A", "Torino", "Belluno")]
)
def test_trips_are_alike_by_name_origin_and_destination(other: tuple[str, str, str]) -> None:
    net = italy()
    plans = [
        platoon_osm.plan_joint(net, platoon_osm.PaperCosts(), [platoon_osm.Trip(*trip)])
        for trip in (("A", "Torino", "Trieste"), other, ("A", "Torino", "Trieste"))
    ]
    found = comparison_document(plans, net)
    assert [one["plans"] for one in found["sets"]] == [[0, 2], [1]]


def test_differences_are_those_of_the_plans() -> None:
    first, net = plan_kind("three vehicles")
    second, _ = plan_kind("all alone")
    waits = replace(first, timetable=late_by_an_hour(first))
    (one,) = comparison_document([waits, second], net, baseline=1)["sets"]
    found = one["differences"][0]
    assert found["waiting_s"] == pytest.approx(
        waits.timetable.waiting_s - second.timetable.waiting_s, abs=0.2  # type: ignore[union-attr]
    )  # fmt: skip
    assert found["waiting_s"] > 3000
    fuel = [sum(vehicle.fuel_l for vehicle in plan.vehicles) for plan in (first, second)]
    assert found["fuel_l"] == pytest.approx(fuel[0] - fuel[1], abs=0.01)
    assert found["fuel_l"] < 0
    length = [sum(vehicle.length_m for vehicle in plan.vehicles) for plan in (first, second)]
    assert found["length_m"] == pytest.approx(length[0] - length[1], abs=1.0)


def test_costs_in_other_units_are_not_subtracted() -> None:
    plan, net = plan_kind("three vehicles")
    euros = replace(plan, unit="EUR")
    (one,) = comparison_document([plan, euros], net)["sets"]
    assert one["differences"][1]["cost"] is None
    assert "\u20ac" in one["remarks"][0]
    (one,) = comparison_document([plan, plan], net)["sets"]
    assert one["differences"][1]["cost"] == 0


def late_by_an_hour(plan: Plan) -> Timetable:
    """Return times at which the last leg of the first vehicle begins after an hour's wait."""
    table = plan.timetable
    assert table is not None
    first, *others = table.vehicles
    *legs, (begin, end) = first.legs
    waits = replace(first, legs=(*legs, (begin + 3600, end + 3600)))
    return replace(table, vehicles=(waits, *others))


@browser
@pytest.mark.parametrize("width", [1440, 390])
def test_unlike_trips_stand_apart(four: Path, visit: Visit, width: int) -> None:
    opened = visit(four, width, 900, wait_for=None)
    page = opened.page
    heading = page.locator("h1").inner_text()
    for letter in LETTERS:
        assert f"Scenario {letter}" in heading
    assert "These plans are of other trips" in page.locator("header .status").inner_text()
    sets = page.locator(".trips")
    assert sets.count() == 4
    # Each has its own vehicles; nothing sets their figures side by side.
    for number, ends in enumerate(("San Donà", "Torino → Brennero", "Chiasso", "Torino → Trieste")):
        assert ends in sets.nth(number).locator(".costs").inner_text()
    assert page.locator(".bars").count() == 0
    assert page.locator(".sums").count() == 0
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    ids = page.locator("[id]").evaluate_all("all => all.map(e => e.id)")
    assert len(ids) == len(set(ids))
    # Whole marks, within their card.
    cut = page.locator(".small-map").evaluate_all(
        """maps => maps.flatMap(map => {
          const box = map.getBoundingClientRect();
          return [...map.querySelectorAll(".wide-texts circle, .wide-texts rect")]
            .map(e => e.getBoundingClientRect()).filter(b => b.width)
            .filter(b => b.left < box.left - 1 || b.right > box.right + 1
              || b.top < box.top - 1 || b.bottom > box.bottom + 1);
        }).length"""
    )
    assert cut == 0
    opened.check(four)


@browser
def test_differences_stand_below_each_figure(visit: Visit, tmp_path: Path) -> None:
    first, net = plan_kind("three vehicles")
    second, _ = plan_kind("all alone")
    write_comparison([first, second], net, tmp_path / "c.html", titles=["Together", "Alone"])
    page = visit(tmp_path / "c.html", wait_for=None).page
    rows = page.locator(".sums tbody tr")
    assert "baseline" in rows.nth(0).inner_text()
    assert rows.nth(0).locator(".differs").count() == 0
    differs = rows.nth(1).locator(".differs").all_inner_texts()
    assert differs[0] == "+594.1"
    assert differs[1].endswith("13.5 pp")
    assert differs[1].startswith("\u2212")


def test_the_command_takes_a_baseline(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("s.toml").write_text(
        'title = "S"\nnetwork = "italy-motorways"\n'
        + "".join(
            f'[[trips]]\nvehicle = "{name}"\norigin = "{origin}"\ndestination = "{end}"\n'
            for name, origin, end in (("A", "Torino", "Trieste"), ("B", "Genova", "Belluno"))
        )
    )
    cases = ["compare", "s.toml", "--cases", "A,C", "-o", "c.html"]
    assert main([*cases, "--baseline", "2"]) == 0
    text = Path("c.html").read_text()
    assert "how it differs from S, case C" in text
    assert "<title>S, case A and S, case C</title>" in text
    assert main([*cases, "--baseline", "S, case C"]) == 0
    assert Path("c.html").read_text() == text
    capsys.readouterr()
    assert main([*cases, "--baseline", "9"]) == 2
    assert "--baseline" in capsys.readouterr().err
