"""The page of a whole fleet: what it says, what it weighs, and what names may do to it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hostile_names import HOSTILE
from line_fleets import ROAD_M, line_fleet, line_net

import platoon_osm as po
from platoon_osm.errors import ScenarioError
from platoon_osm.fleets.conditions import conditions_of
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.convoys import convoys_of
from platoon_osm.plans.plan import Plan
from platoon_osm.report import write_fleet_html
from platoon_osm.report.charts.fleet_charts import gap_percent
from platoon_osm.report.document.corridor import corridor_of
from platoon_osm.report.document.fleet import LISTED, fleet_document_of
from platoon_osm.report.language.plan_sentences import in_language
from platoon_osm.report.language.speech import speaking
from platoon_osm.report.maps.pixels import path_data
from platoon_osm.report.pages.notebook import MOST_OF_FLEET

Visit = Callable[..., Any]

browser = pytest.mark.browser


@pytest.fixture(scope="module")
def fleet() -> tuple[Plan, RoadNetwork]:
    plan, net, _ = line_fleet(1, 160, 8)
    return plan, net


@pytest.fixture(scope="module")
def page_file(fleet: tuple[Plan, RoadNetwork], tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("fleet") / "fleet.html"
    write_fleet_html(*fleet, path)
    return path


def test_the_head_tells_saving_bound_and_gap(page_file: Path) -> None:
    text = page_file.read_text("utf-8")
    figures = re.findall(r"<strong>(.*?)</strong> <span>(.*?)</span>", text)
    told = {label.split(",")[0]: figure for figure, label in figures}
    assert told["trucks planned"] == "160"
    assert told["trips not planned"] == "2"
    assert told["gap: what may be missing of that"] == "16.7\u202f%"
    saved, most = (float(told[key].split("\u202f")[0]) for key in ("saved", "can be saved at most"))
    assert most == pytest.approx(1.2 * saved, abs=0.02)
    assert "at its time limit" in text
    assert "no platoon has more than 3 vehicles" in text
    assert "U1" in text
    assert "no route" in text


def test_traffic_counts_every_vehicle_and_who_is_in_company(
    fleet: tuple[Plan, RoadNetwork],
) -> None:
    plan, net = fleet
    found = fleet_document_of(plan, net, None, None)
    every, together = np.zeros(net.m), np.zeros(net.m)
    for vehicle, way in enumerate(plan.ways):
        for k in way:
            stretch = plan.stretches[k]
            assert vehicle in stretch.vehicles
            every[list(stretch.edges)] += 1
            together[list(stretch.edges)] += len(stretch.vehicles) > 1
    assert found.most == every.max()
    assert sum(len(one.lines) for one in found.traffic) <= net.m
    for one in found.traffic:
        inside = (every >= one.low) & (every <= one.high)
        assert inside.any()
        assert 0 < one.low <= one.high
    assert max(one.high for one in found.traffic) == every.max()
    shares = {int(np.ceil(4 * share)) for share in together / every}
    assert {one.share for one in found.traffic} == shares


def test_a_corridor_is_driven_at_the_pace_of_its_stretches(
    fleet: tuple[Plan, RoadNetwork],
) -> None:
    plan, net = fleet
    found = corridor_of(plan, net, ("N2", "N5"))
    assert found is not None
    assert found.length_m == 3 * ROAD_M
    assert [name for _, name in found.places] == ["N2", "N3", "N4", "N5"]
    assert plan.timetable is not None
    wanted = sorted(
        (stretch.edges[0] - 2, len(stretch.vehicles), *plan.timetable.vehicles[who].legs[leg])
        for k, stretch in enumerate(plan.stretches)
        if 2 <= stretch.edges[0] < 5
        for who, leg in [(stretch.vehicles[0], plan.ways[stretch.vehicles[0]].index(k))]
    )
    drawn = sorted(
        (round(one.begin_m / ROAD_M), one.vehicles, one.begin_s, one.end_s) for one in found.runs
    )
    np.testing.assert_allclose(drawn, wanted)
    busiest = corridor_of(plan, net)
    assert busiest is not None
    assert busiest.length_m >= 3 * ROAD_M
    with pytest.raises(ScenarioError, match="nobody drives from 'N5' to 'N2'"):
        corridor_of(plan, net, ("N5", "N2"))


def test_a_long_stretch_is_cut_where_the_corridor_begins_and_ends() -> None:
    net = line_net(5)
    trip = po.Trip("A", 0, 5, earliest_departure=datetime(2026, 3, 2, 6))
    plan = po.plan_joint(net, po.FuelCosts(), [trip], "C")
    assert plan.timetable is not None
    begin, end = plan.timetable.vehicles[0].legs[0]
    found = corridor_of(plan, net, (1, "n3"))
    assert found is not None
    assert found.vehicles == 1
    [run] = found.runs
    assert (run.vehicles, run.begin_m, run.end_m) == (1, 0.0, 2 * ROAD_M)
    assert run.begin_s == pytest.approx(begin + (end - begin) * 0.2)
    assert run.end_s == pytest.approx(begin + (end - begin) * 0.6)


@pytest.mark.parametrize(
    ("given", "waiting", "costs"),
    [(True, 0, po.PaperCosts()), (False, 3, po.MoneyCosts()), (True, 0, po.MoneyCosts())],
)
def test_all_conditions_are_told_in_other_languages(given: bool, waiting: int, costs: Any) -> None:
    instance = SimpleNamespace(given=given, waiting=waiting, largest=4, kind=np.array([0, 1]))
    model: Any = SimpleNamespace(
        instance=instance, lanes=SimpleNamespace(grains=1000.0), legal=SimpleNamespace(),
        question=SimpleNamespace(problem=SimpleNamespace(objective=costs)),
    )  # fmt: skip
    limits: Any = SimpleNamespace(
        per_trip="one", apart=(("A", "B"),), together=(("A", "C"),), min_gain=1.0
    )
    for condition in conditions_of(model, limits):
        for language in ("de", "it"):
            with speaking(language):
                assert in_language(condition) != condition


def test_without_times_company_or_history(tmp_path: Path) -> None:
    plan, net, _ = line_fleet(1, 20, 4)
    assert plan.fleet is not None
    bare = replace(plan, timetable=None, fleet=replace(plan.fleet, history=(), unserved=()))
    write_fleet_html(bare, net, tmp_path / "bare.html", title="Bare")
    assert '<h1 title="Bare">' in (tmp_path / "bare.html").read_text("utf-8")
    with pytest.raises(ScenarioError, match="no fleet's plan"):
        write_fleet_html(replace(plan, fleet=None), net, tmp_path / "none.html")
    alone, net, _ = line_fleet(0, 1, 3)
    write_fleet_html(alone, net, tmp_path / "alone.html")
    text = (tmp_path / "alone.html").read_text("utf-8")
    assert "Nobody drives in a platoon." in text
    assert "<script" not in text


@pytest.mark.parametrize("language", ["de", "it"])
def test_nothing_is_left_in_english(
    language: str, fleet: tuple[Plan, RoadNetwork], tmp_path: Path
) -> None:
    write_fleet_html(*fleet, tmp_path / "page.html", language=language)
    text = re.sub(r"<style>.*?</style>|<script.*?</script>", "", (tmp_path / "page.html").read_text(
        "utf-8"), flags=re.DOTALL)  # fmt: skip
    for word in ("saved", "waiting", "platoon has", "trucks", "bound", "together", "missing"):
        assert not re.search(rf"\b{word}\b", text), word
    with speaking(language):
        assert f'lang="{language}"' in text


def elements(text: str) -> set[str]:
    return set(re.findall(r"<(/?[a-zA-Z][\w-]*)", text))


def test_names_stay_names(tmp_path: Path) -> None:
    plan, net, _ = line_fleet(1, 24, 4)
    write_fleet_html(plan, net, tmp_path / "plain.html")
    plain = elements((tmp_path / "plain.html").read_text("utf-8"))
    for name in HOSTILE[::6]:
        plan, net, _ = line_fleet(1, 24, 4, lambda text, name=name: f"{text} {name}")
        write_fleet_html(plan, net, tmp_path / "hostile.html", title=name)
        assert elements((tmp_path / "hostile.html").read_text("utf-8")) <= plain, name


@browser
def test_hostile_names_run_nowhere(visit: Visit, tmp_path: Path) -> None:
    plan, net, _ = line_fleet(
        1, 60, 4, lambda text: f"{text} {HOSTILE[len(text) * 7 % len(HOSTILE)]} {HOSTILE[0]}"
    )
    write_fleet_html(plan, net, tmp_path / "fleet.html", title=HOSTILE[3])
    opened = visit(tmp_path / "fleet.html", wait_for="html[data-ready]")
    opened.page.get_by_role("searchbox").fill("<script>")
    assert opened.page.evaluate("window.hacked") is None
    assert opened.page.locator("tbody tr:visible").count() > 3
    opened.check(tmp_path / "fleet.html")


@browser
def test_the_list_filters_sorts_and_grows_by_keyboard(
    fleet: tuple[Plan, RoadNetwork], page_file: Path, visit: Visit
) -> None:
    plan, _ = fleet
    convoys = convoys_of(plan)
    assert len(convoys) > LISTED
    opened = visit(page_file, wait_for="html[data-ready]")
    page = opened.page
    rows = page.locator(".fleet-list tbody tr")
    assert rows.count() == LISTED
    page.get_by_role("button", name="Show more platoons").focus()
    page.keyboard.press("Enter")
    assert rows.count() == min(2 * LISTED, len(convoys))
    page.get_by_role("button", name="Vehicles").focus()
    page.keyboard.press("Enter")
    assert rows.first.locator("b").first.inner_text() == str(
        max(len(one.vehicles) for one in convoys)
    )
    page.get_by_role("searchbox").fill("t77")
    own = sum(77 in one.vehicles for one in convoys)
    assert rows.count() == own
    assert page.locator(".filter output").inner_text() == f"{own} of {len(convoys)} platoons"
    page.get_by_role("searchbox").fill("")
    page.locator("body").evaluate("() => scrollTo(0, 0)")
    rows.first.hover()
    assert page.locator(".platoon-road.on").count() <= 1
    opened.check(page_file)


@browser
@pytest.mark.parametrize("width", [1440, 390])
def test_nothing_is_wider_than_the_page(page_file: Path, visit: Visit, width: int) -> None:
    opened = visit(page_file, width, 900, wait_for="html[data-ready]")
    assert opened.page.evaluate("document.documentElement.scrollWidth") <= width
    opened.check(page_file)


@browser
def test_without_javascript_and_in_print(page_file: Path, visit: Visit) -> None:
    opened = visit(page_file, java_script_enabled=False)
    assert opened.page.locator(".fleet-list tbody tr").count() == LISTED
    assert not opened.page.locator(".filter").is_visible()
    assert not opened.page.locator(".fleet-more").is_visible()
    opened.page.emulate_media(media="print")
    opened.page.set_viewport_size({"width": 700, "height": 1000})
    assert opened.page.evaluate("document.documentElement.scrollWidth") <= 700
    assert opened.page.locator(".fleet-map figure svg").is_visible()
    opened.check(page_file)


def test_same_plan_same_bytes(
    fleet: tuple[Plan, RoadNetwork], page_file: Path, tmp_path: Path
) -> None:
    write_fleet_html(*fleet, tmp_path / "again.html")
    assert (tmp_path / "again.html").read_bytes() == page_file.read_bytes()


def test_a_row_more_weighs_little(page_file: Path, tmp_path: Path) -> None:
    plan, net, _ = line_fleet(1, 1600, 8)
    write_fleet_html(plan, net, tmp_path / "ten.html")
    more = len((tmp_path / "ten.html").read_bytes()) - len(page_file.read_bytes())
    assert more / 1440 < 400


def test_a_gap_is_never_told_smaller_than_it_is() -> None:
    told = [gap_percent(gap) for gap in (0.0, 1e-6, 0.00932, 0.0101, 0.15, 0.1501)]
    assert [text.split("\u202f")[0] for text in told] == [
        "0.0", "0.001", "0.932", "1.1", "15.0", "15.1",
    ]  # fmt: skip


def test_a_line_shrunk_to_a_point_draws_nothing() -> None:
    assert path_data([(1.0, 2.0)]) == ""
    assert path_data([(1.0, 2.0), (3.0, 2.5)]) == "M1 2l2 .5"


def test_a_solver_bound_is_told_beside_what_the_certificate_proves(tmp_path: Path) -> None:
    plan, net, _ = line_fleet(1, 60, 4)
    assert plan.fleet is not None
    saving = plan.fleet.saving
    fleet = replace(plan.fleet, bound=1.2 * saving, exact_bound=1.0005 * saving)
    write_fleet_html(replace(plan, fleet=fleet), net, tmp_path / "exact.html")
    text = (tmp_path / "exact.html").read_text("utf-8")
    assert "<strong>0.050\u202f%</strong> <span>gap" in text
    assert "bound of the exact model" in text
    write_fleet_html(plan, net, tmp_path / "plain.html")
    assert "bound of the exact model" not in (tmp_path / "plain.html").read_text("utf-8")


def test_texts_of_thousands_stay_short(fleet: tuple[Plan, RoadNetwork]) -> None:
    plan, _ = fleet
    table = plan._repr_html_()
    assert table.count("<tr>") == MOST_OF_FLEET + 3
    assert "and 140 more" in table
    assert "Fleet of 160 trucks" in table
    assert repr(plan).startswith("<Plan of a fleet: 160 vehicles, ")
    assert "(gap 16.667% of that)" in repr(plan)
    lines = plan.summary().splitlines()
    assert len(lines) < 14
    longest = max(one.vehicle_m for one in convoys_of(plan))
    assert f"  {longest / 1000:,.0f} vehicle-km" in plan.summary()
