"""Whatever is handed to a report: what comes back is a report, or one line of what is wrong."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from plans_by_legs import with_vehicles

from platoon_osm import PlatoonError, report
from platoon_osm.costs.paper import paper_weights
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report.exporters import EXPORTERS
from platoon_osm.report.pages.notebook import plan_table

Call = Callable[..., Any]

WITHOUT_PATH: dict[str, Call] = {
    "report_document": report.report_document,
    "flow_document": report.flow_document,
    "plan_map": report.plan_map,
    "explore": report.explore,
    "to_geodataframe": report.to_geodataframe,
    "comparison_document": lambda plan, net, **rest: report.comparison_document(
        [plan, plan], net, **rest
    ),
}
WITH_PATH: dict[str, Call] = {
    "write_html": report.write_html,
    "write_flows": report.write_flows,
    "write_csv": report.write_csv,
    "write_gpx": report.write_gpx,
    "write_geopackage": report.write_geopackage,
    "write_figures": report.write_figures,
    "write_sheets": report.write_sheets,
    "write_pages": report.write_pages,
    "write_comparison": lambda plan, net, path, **rest: report.write_comparison(
        [plan, plan], net, path, **rest
    ),
}
FOLDERS = ("write_gpx", "write_figures", "write_sheets", "write_pages")
EVERY = {**WITHOUT_PATH, **WITH_PATH}
TITLED = [
    "report_document", "flow_document", "plan_map", "explore", "comparison_document", "write_html",
    "write_flows", "write_comparison", "write_sheets", "write_pages",
]  # fmt: skip
WEIGHTED = ["report_document", "plan_map", "explore", "write_html", "write_figures", "write_pages"]


def refused(call: Call, *arguments: Any, **options: Any) -> str:
    with pytest.raises(PlatoonError) as caught:
        call(*arguments, **options)
    message = str(caught.value)
    assert message
    assert "\n" not in message
    return message


@pytest.fixture
def place(tmp_path: Path) -> Callable[[str], list[Path]]:
    """Return what a function takes as its path, as a list that may be empty."""

    def made(name: str) -> list[Path]:
        if name not in WITH_PATH:
            return []
        return [tmp_path if name in FOLDERS else tmp_path / "out.file"]

    return made


@pytest.mark.parametrize("name", EVERY)
def test_what_is_no_plan(
    name: str, plan: JointPlan, net: RoadNetwork, place: Callable[[str], list[Path]], tmp_path: Path
) -> None:
    call, at = EVERY[name], place(name)
    assert "None is no plan; hand in what plan_joint returned" in refused(call, None, net, *at)
    assert "from_dict makes one of it" in refused(call, plan.to_dict(), net, *at)
    assert "swapped" in refused(call, net, plan, *at)
    assert "no plan" in refused(call, "plan", net, *at)
    assert "no plan" in refused(call, [plan], net, *at)
    assert "no vehicles" in refused(call, with_vehicles(plan, ()), net, *at)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", EVERY)
def test_what_is_no_network(
    name: str, plan: JointPlan, place: Callable[[str], list[Path]], tmp_path: Path
) -> None:
    call, at = EVERY[name], place(name)
    other = RoadNetwork.from_edges([0], [1], lon=[9.0, 9.1], lat=[45.0, 45.0])
    assert "load the network it was made on" in refused(call, plan, other, *at)
    assert "None is no network" in refused(call, plan, None, *at)
    assert "no network" in refused(call, plan, "italy-motorways", *at)
    assert "no network" in refused(call, plan, plan, *at)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("path", [None, 3, b"out", "", "a\0b", ["out"], True])
@pytest.mark.parametrize("name", WITH_PATH)
def test_what_is_no_path(name: str, path: Any, plan: JointPlan, net: RoadNetwork) -> None:
    assert "names no file" in refused(WITH_PATH[name], plan, net, path)


@pytest.mark.parametrize("title", [3, ["Title"], b"Title"])
@pytest.mark.parametrize("name", TITLED)
def test_what_is_no_title(
    name: str, title: Any, plan: JointPlan, net: RoadNetwork, place: Callable[[str], list[Path]]
) -> None:
    assert "is no text" in refused(EVERY[name], plan, net, *place(name), title=title)


@pytest.mark.parametrize("titles", ["AB", 3, ["A"], ["A", 3], ["A", "B", "C"], {"A": 1, "B": 2}])
def test_titles_of_several_plans(titles: Any, plan: JointPlan, net: RoadNetwork) -> None:
    refused(report.comparison_document, [plan, plan], net, titles=titles)
    refused(report.write_comparison, [plan, plan], net, "out.html", titles=titles)


@pytest.mark.parametrize("plans", [None, [], (), 3, "plans", [None]])
def test_what_are_no_plans(plans: Any, plan: JointPlan, net: RoadNetwork) -> None:
    refused(report.comparison_document, plans, net)
    refused(report.comparison_document, plan, net)
    refused(report.write_comparison, plans, net, "out.html")


@pytest.mark.parametrize("name", WEIGHTED)
def test_weights_that_are_none_or_of_another_network(
    name: str, plan: JointPlan, net: RoadNetwork, place: Callable[[str], list[Path]]
) -> None:
    other = RoadNetwork.from_edges([0], [1], lon=[9.0, 9.1], lat=[45.0, 45.0])
    for weights in (paper_weights(other), 3, {}, "paper"):
        assert "weights" in refused(EVERY[name], plan, net, *place(name), weights=weights)


@pytest.mark.parametrize("formats", ["png", 3, None, ["jpg"], ["png", 3], [["png"]], [None]])
def test_formats_of_figures(
    formats: Any, plan: JointPlan, net: RoadNetwork, tmp_path: Path
) -> None:
    assert "png" in refused(report.write_figures, plan, net, tmp_path, formats=formats)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("height", ["x", None, 0, -5, float("nan"), True, [640]])
def test_height_in_a_notebook(height: Any, plan: JointPlan, net: RoadNetwork) -> None:
    assert "pixels" in refused(report.explore, plan, net, height=height)


@pytest.mark.parametrize("tiles", [3, "Nowhere", "https://[{z}/{x}/{y}", ["OpenStreetMap"], ""])
def test_tiles_and_leaflet(tiles: Any, plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    assert "tiles" in refused(report.plan_map, plan, net, tiles=tiles)
    assert "leaflet" in refused(report.plan_map, plan, net, leaflet_dir=tmp_path)
    refused(report.plan_map, plan, net, leaflet_dir=3)


@pytest.mark.parametrize("styles", [{}, 3, {"A": 1, "B": 2, "C": 3}, []])
def test_styles_of_other_vehicles(styles: Any, plan: JointPlan, net: RoadNetwork) -> None:
    assert "style" in refused(report.report_document, plan, net, styles=styles)


@pytest.mark.parametrize("name", EXPORTERS)
def test_every_exporter(name: str, plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    write = EXPORTERS[name].write
    for what in (None, plan.to_dict(), net):
        assert "plan" in refused(write, what, net, tmp_path / "out", title="Title")
    for path in (None, 3, ""):
        assert "names no file" in refused(write, plan, net, path, title="Title")


@pytest.mark.parametrize("what", [None, 3, {}, "plan"])
def test_the_table_of_a_notebook(what: Any) -> None:
    assert "no plan" in refused(plan_table, what)
