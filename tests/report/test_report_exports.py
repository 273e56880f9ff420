"""Figures, GPX, CSV and the notebook's map: opened again, and with names that try to escape."""

from __future__ import annotations

import csv
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import pandas as pd
import pytest
from hostile_names import HOSTILE
from po_valley import THREE, make_plan, po_valley

from platoon_osm.csv_tables import safe_cell
from platoon_osm.errors import ScenarioError
from platoon_osm.network.load_report import Source
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.offers import offered
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import explore, write_csv, write_figures, write_gpx
from platoon_osm.shown_text import shown

SVG = "{http://www.w3.org/2000/svg}"


def spoiler(start: int) -> Callable[[str], str]:
    return lambda name: f"{HOSTILE[(start + len(name)) % len(HOSTILE)]} {name}"


# -- figures ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def figures(
    plan: JointPlan, net: RoadNetwork, tmp_path_factory: pytest.TempPathFactory
) -> list[Path]:
    return write_figures(plan, net, tmp_path_factory.mktemp("figures"))


def test_figures_are_what_their_names_say(figures: list[Path]) -> None:
    written, folder = figures, figures[0].parent
    assert [path.name for path in written] == [
        f"{name}.{kind}" for name in ("corridor", "costs", "way") for kind in ("png", "svg", "pdf")
    ]
    assert sorted(folder.iterdir()) == sorted(written)
    for path in written:
        head = path.read_bytes()[:8]
        assert head.startswith({".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}[path.suffix])
    picture = _pixels(folder / "corridor.png")
    # The platoon's yellow and the master's blue are there, and most of the paper is white.
    for colour, least in (((255, 213, 74), 2_000), ((0, 114, 178), 2_000)):
        assert (np.abs(picture - colour).max(axis=2) < 12).sum() > least
    assert (picture > 250).all(axis=2).mean() > 0.6


def _pixels(path: Path) -> Any:
    import matplotlib.image

    return (matplotlib.image.imread(path)[:, :, :3] * 255).astype(int)


def test_same_plan_same_figures(
    figures: list[Path], plan: JointPlan, net: RoadNetwork, tmp_path: Path
) -> None:
    again = write_figures(plan, net, tmp_path, formats=("svg", "pdf"))
    assert len(again) == 6
    for path in again:
        assert path.read_bytes() == (figures[0].parent / path.name).read_bytes(), path.name


@pytest.mark.parametrize("start", range(0, len(HOSTILE), 12))
def test_names_in_figures_are_drawn_as_they_stand(start: int, tmp_path: Path) -> None:
    net = po_valley(spoiler(start))
    plan = make_plan(net, THREE, spoiler(start))
    for path in write_figures(plan, net, tmp_path, formats=("svg",)):
        elements = list(ElementTree.parse(path).iter())
        tags = {element.tag for element in elements}
        assert not any(key.startswith("on") for element in elements for key in element.attrib)
        assert not tags & {f"{SVG}script", f"{SVG}image", f"{SVG}foreignObject", f"{SVG}a"}


def test_wrong_format_is_named(plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match="format 'gif' is unknown"):
        write_figures(plan, net, tmp_path, formats=("gif",))


# -- tracks ----------------------------------------------------------------------------------------


def test_gpx_opens_again(plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    written = write_gpx(plan, net, tmp_path)
    assert [path.name for path in written] == ["a.gpx", "b.gpx", "c.gpx"]
    for path, vehicle in zip(written, plan.vehicles, strict=True):
        tracks = geopandas.read_file(path, layer="tracks")
        assert len(tracks) == 1
        legs = [leg for leg in vehicle.legs if leg.edges]
        assert len(tracks.geometry[0].geoms) == len(legs)
        for segment, leg in zip(tracks.geometry[0].geoms, legs, strict=True):
            np.testing.assert_allclose(
                np.asarray(segment.coords)[:, :2], net.path_shape(leg.edges), atol=6e-7
            )
        points = geopandas.read_file(path, layer="waypoints")
        kinds = ["start", "merge", "separation", "destination"]
        assert list(points["type"]) == (kinds if vehicle.merge else ["start", "destination"])
        text = path.read_text()
        assert "Made by hand for tests, CC0" in text
        assert "OpenStreetMap" not in text
        assert "<time>" not in path.read_text()


def test_csv_opens_again(plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    write_csv(plan, net, tmp_path / "legs.csv")
    frame = pd.read_csv(tmp_path / "legs.csv")
    assert len(frame) == sum(len(vehicle.legs) for vehicle in plan.vehicles)
    costs = frame.groupby("vehicle")["cost"].sum()
    for vehicle in plan.vehicles:
        assert costs[vehicle.vehicle] == pytest.approx(vehicle.joint_cost, rel=1e-4)


@pytest.mark.parametrize("start", range(len(HOSTILE)))
def test_hostile_names_in_tracks(start: int, tmp_path: Path) -> None:
    one = HOSTILE[start]
    net = po_valley(lambda name: f"{one}{name}", Source(one, one, one, one, one))
    plan = make_plan(net, THREE, lambda name: f"{one} {name}", unit=one, version=one)
    for path, vehicle in zip(write_gpx(plan, net, tmp_path), plan.vehicles, strict=True):
        assert path.parent == tmp_path
        names = [element.text for element in ElementTree.parse(path).iter() if element.text]
        assert f"Start: {shown(vehicle.origin.name)}" in names
    write_csv(plan, net, tmp_path / "legs.csv")
    with (tmp_path / "legs.csv").open(newline="", encoding="utf-8") as handle:
        rows = list(csv.DictReader(handle))
    found = [row["vehicle"] for row in rows if row["leg"] == "1"]
    for cell, vehicle in zip(found, plan.vehicles, strict=True):
        assert cell == safe_cell(shown(vehicle.vehicle))
    signs = ("=", "+", "-", "@", "\t", "\r", "\n", "\uff1d")
    assert not any(cell.startswith(signs) for row in rows for cell in row.values())
    assert all(None not in row for row in rows), "a name made a cell of its own"


def test_a_formula_stays_a_text(net: RoadNetwork, tmp_path: Path) -> None:
    plan = make_plan(net, THREE, lambda name: f"=HYPERLINK(1) {name}")
    write_csv(plan, net, tmp_path / "legs.csv")
    assert "'=HYPERLINK(1) A," in (tmp_path / "legs.csv").read_text()


# -- notebooks -------------------------------------------------------------------------------------


@pytest.mark.browser
def test_explore_shows_in_a_notebook(
    plan: JointPlan, net: RoadNetwork, visit: Callable[..., Any], tmp_path: Path
) -> None:
    path = tmp_path / "notebook.html"
    path.write_text(f"<!DOCTYPE html><body>{explore(plan, net, height=700)._repr_html_()}</body>")
    opened = visit(path, wait_for="iframe")
    page = opened.page
    page.frame_locator("iframe").locator("#map_plan[data-ready]").wait_for()
    assert page.locator("iframe").bounding_box()["height"] == pytest.approx(700, abs=6)
    assert page.frame_locator("iframe").locator(".event-mark").count() == 4
    assert opened.complaints == []


@pytest.mark.browser
def test_a_plan_explores_itself(
    plan: JointPlan, net: RoadNetwork, visit: Callable[..., Any], tmp_path: Path
) -> None:
    path = tmp_path / "notebook.html"
    shown_map = plan.explore(net, height=500, title="Own title")
    path.write_text(f"<!DOCTYPE html><body>{shown_map._repr_html_()}</body>")
    page = visit(path, wait_for="iframe").page
    frame = page.frame_locator("iframe")
    frame.locator("#map_plan[data-ready]").wait_for()
    assert frame.locator("h1").inner_text() == "Own title"


def test_a_notebook_shows_the_table_of_a_plan(plan: JointPlan) -> None:
    rows = re.findall(r"<tr>(.*?)</tr>", plan._repr_html_().replace("\n", ""))
    cells = [re.sub("<[^>]*>", "|", row).replace("||", "|") for row in rows]
    assert [cell.strip("|").split("|")[0] for cell in cells] == [
        "Vehicle", "A", "B", "C", "All vehicles",
    ]  # fmt: skip
    assert "Torino| \u2192 |Trieste" in cells[1]


@pytest.mark.parametrize("start", range(0, len(HOSTILE), 12))
def test_hostile_names_in_a_notebook_stay_names(start: int) -> None:
    name = HOSTILE[start]
    plan = make_plan(
        po_valley(lambda text: f"{text} {name}"), THREE, lambda text: f"{text} {name}", case=name
    )
    html = plan._repr_html_()
    assert set(re.findall(r"<([a-z]+)", html)) == {
        "table", "caption", "bdi", "thead", "tr", "th", "tbody", "td", "tfoot",
    }  # fmt: skip


def test_a_plan_alone_loads_no_report() -> None:
    code = (
        "import sys, platoon_osm; from platoon_osm.plans.plan import JointPlan\n"
        "assert JointPlan.explore\n"
        "print([m for m in sys.modules if m.startswith('platoon_osm.report')])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout.strip() == "[]"


def test_what_nobody_offers_is_said() -> None:
    with pytest.raises(LookupError, match="nobody offers 'nonsense'"):
        offered("nonsense")
