"""One door for every kind of network."""

import json

import numpy as np
import osmnx
import pytest
from osm_files import MOTORWAY, row, write
from small_osm import NODES, ROADS, WAYS, as_overpass

from platoon_osm.errors import MapDataError, NetworkError, ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.sources.catalog import BUNDLED_MAPS, bundled_path
from platoon_osm.sources.load import load_network
from platoon_osm.sources.overpass.download import osmnx_settings

CROSSING = {
    1: (11.0, 45.05, {}), 2: (11.1, 45.05, {}), 3: (11.05, 45.0, {}), 4: (11.05, 45.1, {}),
}  # fmt: skip
CROSSING_WAYS = {10: ([1, 2], MOTORWAY), 11: ([3, 4], MOTORWAY)}


def shape_of(net):
    ids = net.node_id
    return sorted(
        (int(ids[a]), int(ids[b]), round(float(length), 3), round(float(speed), 6))
        for a, b, length, speed in zip(
            net.tail, net.head, net.length_m, net.speed_mps, strict=True
        )
    )  # fmt: skip


def test_every_kind_of_file_gives_the_same_roads(tmp_path):
    osm = write(tmp_path, NODES, WAYS)
    expected = shape_of(load_network(osm, ROADS, country="IT"))
    with osmnx_settings(tmp_path / "cache", 0, {}):
        graph = osmnx.graph_from_xml(osm, simplify=False, retain_all=True)
    (tmp_path / "small.json").write_text(json.dumps(as_overpass()))
    osmnx.save_graphml(graph, tmp_path / "small.graphml")
    osmnx.save_graph_geopackage(graph, tmp_path / "small.gpkg", directed=True)
    load_network(osm, ROADS, country="IT").save(tmp_path / "small.platoon")
    sources = [graph, *(tmp_path / f"small.{kind}" for kind in ("json", "graphml", "gpkg"))]
    for source in [*sources, tmp_path / "small.platoon", str(tmp_path / "small.platoon")]:
        net = load_network(source, ROADS, country="IT")
        assert [row[:2] for row in shape_of(net)] == [row[:2] for row in expected]
        # OSMnx measures on a sphere, which is up to 0.3 % off.
        np.testing.assert_allclose(
            [row[2:] for row in shape_of(net)], [row[2:] for row in expected], rtol=4e-3
        )


def test_the_saved_form_is_known_by_its_content_not_its_name(tmp_path):
    net = load_network(write(tmp_path, row(3), {1: ([1, 2, 3], MOTORWAY)}))
    net.save(tmp_path / "odd.platoon")
    (tmp_path / "odd.platoon").rename(tmp_path / "odd.osm")
    assert load_network(tmp_path / "odd.osm").identity() == net.identity()


def test_the_bundled_map_knows_its_country_and_licence():
    net = load_network("italy-motorways")
    assert net.source.name == "italy-motorways"
    assert net.source.licence == "MIT"
    assert "by hand" in net.source.attribution
    assert len(net.source.sha256) == 64
    assert net.speed_mps.max() * 3.6 == pytest.approx(80)
    faster = load_network("italy-motorways", country="FR")
    assert faster.speed_mps.max() * 3.6 == pytest.approx(90)


def test_bundled_maps_are_there():
    for bundled in BUNDLED_MAPS.values():
        found = bundled_path(bundled.name)
        assert found is not None
        assert found[1].name == bundled.file
    assert bundled_path("atlantis") is None


def test_a_network_in_memory_goes_through():
    net = RoadNetwork.from_edges([0, 1], [1, 0], lon=[11.0, 11.1], lat=[45.0, 45.0])
    assert load_network(net) is net


def test_limiter_and_classes_reach_the_reader(tmp_path):
    ways = {1: ([1, 2], {**MOTORWAY, "maxspeed": "130"}), 2: ([2, 3], {"highway": "primary"})}
    path = write(tmp_path, row(3), ways)
    assert load_network(path).speed_mps.max() * 3.6 == pytest.approx(80)
    assert load_network(path, limiter_kmh=75).speed_mps.max() * 3.6 == pytest.approx(75)
    assert load_network(path, ("motorway", "primary")).m == 3


@pytest.mark.parametrize(
    "options",
    [
        {"country": "XX"}, {"limiter_kmh": -1}, {"limiter_kmh": "fast"}, {"classes": "motorway"},
        {"classes": ["motorway", 5]},
    ],
)  # fmt: skip
def test_options_out_of_range(tmp_path, options):
    with pytest.raises(ScenarioError):
        load_network(write(tmp_path, row(2), {1: ([1, 2], MOTORWAY)}), **options)


@pytest.mark.parametrize("source", [None, 5, [1], object()])
def test_things_that_are_no_source(source):
    with pytest.raises(NetworkError, match="is not a networkx graph"):
        load_network(source)


def test_an_extract_without_ramps_is_said_to_be_one(tmp_path):
    net = load_network(write(tmp_path, CROSSING, CROSSING_WAYS))
    report = net.report()
    assert report["carriageways that end without going on"] == 2
    remark = report.remarks[-1]
    assert "only 0% of the carriageway-km hang together" in remark
    assert "--infer-links" in remark


def test_an_extract_with_ramps_is_not_said_to_lack_them(tmp_path):
    ways = {10: ([1, 2], MOTORWAY), 11: ([3, 4], {**MOTORWAY, "highway": "motorway_link"})}
    remark = load_network(write(tmp_path, CROSSING, ways)).report().remarks[-1]
    assert "a small piece of the network" in remark
    assert "without their ramps" not in remark


def test_a_connected_extract_gets_no_remark_but_what_capped_the_speeds(tmp_path):
    path = write(tmp_path, row(3), {10: ([1, 2, 3], {**MOTORWAY, "oneway": "no"})})
    (remark,) = load_network(path).report().remarks
    assert "a limiter of 90 km/h and the truck limit of IT" in remark
    (remark,) = load_network(path, country="DE", limiter_kmh=85).report().remarks
    assert "a limiter of 85 km/h and the truck limit of DE" in remark


def test_a_saved_network_says_that_it_keeps_its_own_options(tmp_path):
    path = write(tmp_path, row(3), {10: ([1, 2, 3], {**MOTORWAY, "oneway": "no"})})
    load_network(path).save(tmp_path / "a.platoon")
    for options in ({"country": "DE"}, {"limiter_kmh": 60}, {"classes": ("trunk",)}):
        again = load_network(tmp_path / "a.platoon", **options)
        assert "opened as it was saved" in again.report().remarks[-1]
        assert again.m == 2


def test_the_remark_is_made_once_also_through_the_saved_form(tmp_path):
    load_network(write(tmp_path, CROSSING, CROSSING_WAYS)).save(tmp_path / "a.platoon")
    again = load_network(tmp_path / "a.platoon")
    assert len(again.report().remarks) == 2
    assert again.report()["carriageways that end without going on"] == 2


def test_links_are_inferred_on_demand_and_only_once(tmp_path):
    path = write(tmp_path, CROSSING, CROSSING_WAYS)
    assert not load_network(path).inferred.any()
    joined = load_network(path, infer_links=True)
    assert joined.inferred.any()
    assert "were inferred, not mapped" in joined.report().remarks[1]
    joined.save(tmp_path / "joined.platoon")
    assert load_network(tmp_path / "joined.platoon", infer_links=True).m == joined.m


def test_a_bundled_map_whose_file_is_gone(monkeypatch):
    monkeypatch.setattr("pathlib.Path.is_file", lambda _: False)
    with pytest.raises(MapDataError, match=r"italy-motorways.osm: missing from the installation"):
        bundled_path("italy-motorways")
