"""Places between junctions and beside the road, on pages and in files for other programs."""

from __future__ import annotations

import csv
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import pytest
from bundled import italy as italy_map

import platoon_osm as po
from platoon_osm.plans.plan import Plan
from platoon_osm.report.document.document import report_document
from platoon_osm.report.document.flows import flow_document

HOSTILE = '<img src=x onerror="alert(1)">\u202e'
Visit = Callable[..., Any]


@pytest.fixture(scope="module")
def italy() -> po.RoadNetwork:
    return italy_map()


@pytest.fixture(scope="module")
def plan(italy: po.RoadNetwork) -> Plan:
    trips = [
        po.Trip("A", "Torino", "Trieste"),
        po.Trip("B", (8.774, 45.472), "Padova Est"),
        po.Trip("C", po.Place((10.27, 45.46), label="Depot"), (12.05, 45.437)),
        po.Trip("D", (12.05, 45.437), (10.27, 45.46)),
    ]
    return po.plan_joint(italy, po.PaperCosts(tau=1.0, xi=0.18), trips, "C", master="A")


def test_a_way_beside_the_road_is_told(plan: Plan, italy: po.RoadNetwork) -> None:
    c, d = plan.vehicles[2:]
    assert [leg.role for leg in c.legs] == ["access", "platoon", "platoon"]
    assert d.legs[-1].role == "access"
    assert f"C: access {c.access_m / 1000:.1f} km to Brescia Est" in plan.summary()
    assert f"D: access {d.access_m / 1000:.1f} km from {d.legs[-1].access_at}" in plan.summary()
    document = report_document(plan, italy)
    lines = [line for line in document["solos"] if line["access"]]
    assert [line["vehicle"] for line in lines] == [2, 3]
    assert lines[0]["tip"]["lines"][-1].startswith("Access by Brescia Est")
    assert [vehicle["access_m"] > 0 for vehicle in document["vehicles"]] == [
        False, False, True, True
    ]  # fmt: skip
    assert document["vehicles"][2]["access_text"].endswith("to Brescia Est")


def test_lengths_of_files_are_those_of_the_plan(
    plan: Plan, italy: po.RoadNetwork, tmp_path: Path
) -> None:
    po.write_geopackage(plan, italy, tmp_path / "plan.gpkg")
    routes = geopandas.read_file(tmp_path / "plan.gpkg", layer="routes")
    legs = [leg for vehicle in plan.vehicles for leg in vehicle.legs]
    assert routes["role"].tolist() == [leg.role for leg in legs]
    drawn = routes.to_crs(routes.estimate_utm_crs()).length
    for metres, leg in zip(drawn, legs, strict=True):
        detour = 1.3 if leg.role == "access" else 1.0
        assert metres * detour == pytest.approx(leg.length_m, rel=0.01, abs=60)
    network = geopandas.read_file(tmp_path / "plan.gpkg", layer="network")
    assert len(network) == italy.m
    platoons = geopandas.read_file(tmp_path / "plan.gpkg", layer="platoons")
    together = [one.length_m for one in plan.stretches if one.together]
    drawn = platoons.to_crs(platoons.estimate_utm_crs()).length
    assert drawn.to_numpy() == pytest.approx(together, rel=0.01)

    po.write_csv(plan, italy, tmp_path / "plan.csv")
    with (tmp_path / "plan.csv").open(encoding="utf-8", newline="") as handle:
        rows = list(csv.DictReader(handle))
    assert [row["role"] for row in rows] == [leg.role for leg in legs]
    assert all((row["roads"] == "") == (row["role"] == "access") for row in rows)


def test_tracks_begin_and_end_where_the_trips_do(
    plan: Plan, italy: po.RoadNetwork, tmp_path: Path
) -> None:
    name = "{http://www.topografix.com/GPX/1/1}trkpt"
    for path, vehicle in zip(po.write_gpx(plan, italy, tmp_path), plan.vehicles, strict=True):
        points = [
            (float(point.get("lon", 0)), float(point.get("lat", 0)))
            for point in ElementTree.parse(path).iter(name)
        ]
        for at, stop in ((points[0], vehicle.origin), (points[-1], vehicle.destination)):
            assert at == pytest.approx((stop.lon, stop.lat), abs=2e-6)


def test_roads_used_are_those_driven(plan: Plan, italy: po.RoadNetwork) -> None:
    flows = flow_document(plan, italy)["flows"]
    used = sum(flow["vehicles"] * flow["length_m"] for flow in flows)
    road = sum(vehicle.length_m - vehicle.access_m for vehicle in plan.vehicles)
    assert used == pytest.approx(road)


def test_weights_given_back_tell_what_legs_cost_alone(italy: po.RoadNetwork, plan: Plan) -> None:
    weights = po.paper_weights(italy, tau=1.0, xi=0.18)
    shares = tuple(
        replace(one, shares=tuple(replace(share, alone_cost=None) for share in one.shares))
        if one.together else one
        for one in plan.stretches
    )  # fmt: skip
    untold = replace(plan, stretches=shares)
    told = report_document(untold, italy, weights=weights)
    assert told["vehicles"] == report_document(plan, italy)["vehicles"]
    with pytest.raises(po.ScenarioError, match="do not give the costs"):
        report_document(untold, italy, weights=po.paper_weights(italy, rest_s=9000.0))


def test_every_page_and_picture_is_made(plan: Plan, italy: po.RoadNetwork, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    other = po.plan_joint(italy, po.PaperCosts(), [po.Trip("A", "Torino", (12.05, 45.437))])
    po.write_html(plan, italy, tmp_path / "page.html")
    po.write_flows(plan, italy, tmp_path / "flows.html")
    po.write_comparison([plan, other], italy, tmp_path / "both.html")
    po.write_figures(plan, italy, tmp_path, formats=("svg",))
    assert po.explore(plan, italy)
    plan.write_json(tmp_path / "plan.json")
    assert Plan.read_json(tmp_path / "plan.json") == plan
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert "Way to the road" in page
    assert 'stroke-dasharray="0.1 8"' in page
    assert "Way to the road" not in _page(other, italy, tmp_path)


def _page(plan: Plan, italy: po.RoadNetwork, folder: Path) -> str:
    po.write_html(plan, italy, folder / "other.html")
    return (folder / "other.html").read_text(encoding="utf-8")


def test_names_of_junctions_are_text(italy: po.RoadNetwork, plan: Plan, tmp_path: Path) -> None:
    stretches = tuple(
        replace(one, access_at=HOSTILE) if one.access else one for one in plan.stretches
    )
    page = _page(replace(plan, stretches=stretches), italy, tmp_path)
    assert "<img src=x" not in page


def test_the_page_in_a_browser(
    plan: Plan, italy: po.RoadNetwork, visit: Visit, tmp_path: Path
) -> None:
    path = tmp_path / "page.html"
    po.write_html(plan, italy, path)
    opened = visit(path)
    dotted = opened.page.locator('.leaflet-routes-pane path[stroke-dasharray="0.1 8"]')
    assert dotted.count() == 2
    assert "5.3\u202fkm to Brescia Est" in opened.page.locator("#panel").inner_text().replace(
        " km", "\u202fkm"
    )
    opened.check(path)
    still = visit(path, java_script_enabled=False)
    assert still.page.locator('path[stroke-dasharray="0.1 8"]').count() >= 2


def test_times_count_the_way_to_the_road(italy: po.RoadNetwork) -> None:
    from datetime import datetime

    start = datetime(2026, 3, 2, 6)
    plan = po.plan_joint(
        italy, po.PaperCosts(tau=1.0, xi=0.18),
        [
            po.Trip("A", "Torino", "Trieste", earliest_departure=start),
            po.Trip("C", (10.27, 45.46), (12.05, 45.437)),
        ], "C", master="A",
    )  # fmt: skip
    assert plan.timetable is not None
    times = plan.timetable.vehicles[1]
    (begin, end), (joins, _) = times.legs
    assert end - begin == pytest.approx(plan.vehicles[1].legs[0].time_s)
    assert joins >= end - 1e-6


def test_other_objectives_price_the_way_too(italy: po.RoadNetwork) -> None:
    class PerHour:
        name, unit = "hours", "EUR"

        def weights(self, net: po.RoadNetwork, vehicle: object = None) -> po.EdgeWeights:
            del vehicle
            cost = net.length_m / net.speed_mps / 3600 * 40
            return po.EdgeWeights(cost, cost * 0.9, cost * 0.95, "EUR", {"preset": self.name})

        def waiting(self, seconds: float) -> float:
            return seconds / 3600 * 40

    plan = po.plan_joint(italy, PerHour(), [po.Trip("C", (10.27, 45.46), "Padova Est")])
    way = plan.vehicles[0].legs[0]
    assert way.cost == pytest.approx(way.time_s / 3600 * 40)
    assert np.isclose(way.time_s, way.length_m / (50 / 3.6))
