"""GIS files, opened again."""

from __future__ import annotations

from pathlib import Path

import geopandas
import pyogrio
import pytest
from hostile_names import HOSTILE
from po_valley import THREE, make_plan, po_valley

from platoon_osm.network.load_report import Source
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report import to_geodataframe, write_geopackage
from platoon_osm.shown_text import shown


def test_legs_as_a_frame(plan: JointPlan, net: RoadNetwork) -> None:
    frame = to_geodataframe(plan, net)
    assert frame.crs == "EPSG:4326"
    assert len(frame) == sum(len(vehicle.legs) for vehicle in plan.vehicles)
    by_vehicle = frame.groupby("vehicle")["cost"].sum()
    for vehicle in plan.vehicles:
        assert by_vehicle[vehicle.vehicle] == pytest.approx(vehicle.joint_cost)
    assert (frame["attribution"] == "Made by hand for tests, CC0").all()


def test_geopackage_opens_again(plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    path = tmp_path / "plan.gpkg"
    write_geopackage(plan, net, path)
    assert {name for name, _ in pyogrio.list_layers(path)} == {
        "routes", "platoons", "points", "network", "about", "layer_styles",
    }  # fmt: skip
    routes = geopandas.read_file(path, layer="routes")
    assert routes.crs == "EPSG:4326"
    assert list(routes.columns) == list(to_geodataframe(plan, net).columns)
    points = geopandas.read_file(path, layer="points")
    assert sorted(points["kind"].value_counts().items()) == [
        ("destination", 3), ("merge", 2), ("separation", 2), ("start", 3),
    ]  # fmt: skip
    network = geopandas.read_file(path, layer="network")
    assert len(network) == net.m
    assert network["length_m"].sum() == pytest.approx(net.length_m.sum())
    assert list(geopandas.read_file(path, layer="platoons")["size"]) == [2, 3, 2]
    about = pyogrio.read_dataframe(path, layer="about").set_index("item")["text"]
    assert about["attribution"] == "Made by hand for tests, CC0"
    assert about["parameter xi"] == "0.18"


def test_geopackage_replaces_an_old_one(plan: JointPlan, net: RoadNetwork, tmp_path: Path) -> None:
    path = tmp_path / "plan.gpkg"
    path.write_text("an older file")
    write_geopackage(plan, net, path)
    assert len(geopandas.read_file(path, layer="routes")) == 13
    assert [item.name for item in tmp_path.iterdir()] == ["plan.gpkg"]


def test_geopackage_without_platoons(net: RoadNetwork, tmp_path: Path) -> None:
    plan = make_plan(net, [("A", "Torino", "Trieste", None, None)])
    write_geopackage(plan, net, tmp_path / "alone.gpkg")
    assert len(geopandas.read_file(tmp_path / "alone.gpkg", layer="platoons")) == 0


@pytest.mark.parametrize("start", range(0, len(HOSTILE), 6))
def test_hostile_names_are_kept(start: int, tmp_path: Path) -> None:
    """In every text of every layer, as they are shown elsewhere."""
    given: dict[str, str] = {}

    def spoiled(name: str) -> str:
        return given.setdefault(name, f"{name} {HOSTILE[(start + len(given)) % len(HOSTILE)]}")

    one = HOSTILE[start]
    net = po_valley(spoiled, Source(one, one, one, one, one))
    plan = make_plan(
        net, THREE, spoiled, case=one, asked=one, objective=one, method=one, unit=one,
        version=one, remarks=(one,), params={one: one}, proof={"kind": one, "conditions": [one]},
    )  # fmt: skip
    path = tmp_path / "plan.gpkg"
    write_geopackage(plan, net, path)
    routes = geopandas.read_file(path, layer="routes")
    assert len(routes) == 13
    for vehicle in plan.vehicles:
        own = routes[routes["vehicle"] == shown(vehicle.vehicle)]
        assert set(own["origin"]) == {shown(vehicle.origin.name)}
        assert set(own["destination"]) == {shown(vehicle.destination.name)}
    network = geopandas.read_file(path, layer="network").sort_values("edge")
    texts = [shown(text) for text in net.texts]
    # What a name may be reduced to is nothing, which a GIS reads as none.
    assert list(network["ref"].fillna("")) == [texts[code] for code in net.ref]
    assert list(network["name"].fillna("")) == [texts[code] for code in net.name]
    points = geopandas.read_file(path, layer="points")
    stops = {shown(stop.name) for v in plan.vehicles for stop in (v.origin, v.destination)}
    assert stops <= set(points["name"])
    platoons = geopandas.read_file(path, layer="platoons")
    assert all(shown(plan.vehicles[0].vehicle) in who for who in platoons["vehicles"])
    about = pyogrio.read_dataframe(path, layer="about")
    assert {shown(one), ""} >= set(about[about["item"] == "remark"]["text"].fillna(""))
    assert f"parameter {shown(one)}".strip() in set(about["item"])
