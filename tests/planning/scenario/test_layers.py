"""Layers of a GeoPackage: points, lines and their multi-part siblings, in any coordinate system."""

import random
from datetime import UTC, datetime

import geopandas
import pandas
import pyogrio
import pytest
import shapely
from shapely import LineString, MultiLineString, MultiPoint, Point
from trip_files import write_gpkg

import platoon_osm as po

WEST, EAST, NORTH = (7.68, 45.07), (13.77, 45.65), (11.5, 47.0)
ROW = {"vehicle": "A", "destination": "Belluno"}


@pytest.mark.parametrize("point", [Point(WEST), MultiPoint([WEST]), Point(*WEST, 230.0)])
def test_points_are_origins(tmp_path, point):
    file = write_gpkg(tmp_path / "t.gpkg", [ROW], [point])
    assert po.read_trips(file) == [po.Trip("A", WEST, "Belluno")]


@pytest.mark.parametrize(
    "line",
    [
        LineString([WEST, EAST]), LineString([WEST, NORTH, EAST]),
        MultiLineString([[WEST, NORTH, EAST]]), MultiLineString([[WEST, NORTH], [NORTH, EAST]]),
    ],
)  # fmt: skip
def test_lines_run_from_origin_to_destination(tmp_path, line):
    labels = {"vehicle": "A", "origin_label": "Depot", "destination_label": "Harbour"}
    file = write_gpkg(tmp_path / "t.gpkg", [labels], [line])
    expected = po.Trip("A", po.Place(WEST, label="Depot"), po.Place(EAST, label="Harbour"))
    assert po.read_trips(file) == [expected]


@pytest.mark.parametrize("crs", [3857, 25832, 3035, 4258])
def test_any_coordinate_system(tmp_path, crs):
    there = geopandas.GeoSeries([LineString([WEST, EAST])], crs=4326).to_crs(crs)
    (trip,) = po.read_trips(write_gpkg(tmp_path / "t.gpkg", [{"vehicle": "A"}], there, crs=crs))
    assert trip.origin == pytest.approx(WEST, abs=1e-6)
    assert trip.destination == pytest.approx(EAST, abs=1e-6)


@pytest.mark.parametrize(
    ("geometry", "said"),
    [
        (MultiPoint([WEST, EAST]), "feature 1: its geometry is a MultiPoint of 2 parts"),
        (MultiLineString([[WEST, NORTH], [EAST, WEST]]), "a MultiLineString of 2 parts"),
        (shapely.box(7, 45, 8, 46), "its geometry is a Polygon of 1 parts; give a point"),
    ],
)
def test_other_geometries(tmp_path, geometry, said):
    with pytest.raises(po.ScenarioError, match=said):
        po.read_trips(write_gpkg(tmp_path / "t.gpkg", [ROW], [geometry]))


def test_what_the_geometry_says_no_column_says_too(tmp_path):
    row = {"vehicle": "A", "Origin": "Torino", "destination": "Belluno"}
    with pytest.raises(po.ScenarioError, match="tells the origin by its geometry and in a column"):
        po.read_trips(write_gpkg(tmp_path / "t.gpkg", [row], [Point(WEST)]))


def test_a_feature_without_geometry_among_others(tmp_path):
    rows = [ROW, {"vehicle": "B", "destination": "Belluno"}]
    with pytest.raises(po.ScenarioError, match="feature 2: origin is empty"):
        po.read_trips(write_gpkg(tmp_path / "t.gpkg", rows, [Point(WEST), None]))


def test_a_table_without_geometry(tmp_path):
    table = pandas.DataFrame([{"vehicle": "A", "origin": "Torino", "destination": "9, 45"}])
    pyogrio.write_dataframe(table, tmp_path / "t.gpkg", layer="list")
    assert po.read_trips(tmp_path / "t.gpkg") == [po.Trip("A", "Torino", (9, 45))]


def test_no_coordinate_system_or_a_wrong_one(tmp_path):
    with pytest.warns(UserWarning, match="'crs' was not provided"):
        file = write_gpkg(tmp_path / "t.gpkg", [ROW], [Point(WEST)], crs=None)
    with pytest.raises(po.ScenarioError, match="has no coordinate system; give it one"):
        po.read_trips(file)
    with pytest.raises(po.ScenarioError, match=r"no place on earth|cannot be brought into"):
        po.read_trips(write_gpkg(tmp_path / "u.gpkg", [ROW], [Point(5e5, 5e6)]))


def test_moments_and_numbers_of_a_layer(tmp_path):
    at = datetime(2026, 3, 2, 6)
    row = {**ROW, "earliest_departure": at, "flexibility_min": 30, "destination": None}
    row |= {"destination_osmid": 2**40}
    (trip,) = po.read_trips(write_gpkg(tmp_path / "t.gpkg", [row], [Point(WEST)]))
    assert trip == po.Trip("A", WEST, po.Place(osmid=2**40), at, flexibility_min=30)
    zoned = {**ROW, "latest_arrival": at.replace(tzinfo=UTC)}
    (trip,) = po.read_trips(write_gpkg(tmp_path / "u.gpkg", [zoned], [Point(WEST)]))
    assert trip.latest_arrival == at.replace(tzinfo=UTC)


def test_layers_by_name(tmp_path):
    file = write_gpkg(tmp_path / "t.gpkg", [ROW], [Point(WEST)], layer="monday")
    write_gpkg(file, [{**ROW, "vehicle": "B"}], [Point(WEST)], layer="tuesday")
    with pytest.raises(po.ScenarioError, match=r"has several layers \(monday, tuesday\); name one"):
        po.read_trips(file)
    assert [trip.vehicle for trip in po.read_trips(file, "tuesday")] == ["B"]
    with pytest.raises(po.ScenarioError, match="has no layer 'x'; layers are monday, tuesday"):
        po.read_trips(file, "x")
    write_gpkg(file, [{**ROW, "vehicle": "C"}], [Point(WEST)], layer="trips")
    assert [trip.vehicle for trip in po.read_trips(file)] == ["C"]


def test_a_network_is_no_table_of_trips(tmp_path):
    for layer in ("nodes", "edges"):
        write_gpkg(tmp_path / "t.gpkg", [{"osmid": 1}], [Point(WEST)], layer=layer)
    with pytest.raises(po.ScenarioError, match="is a network, not trips"):
        po.read_trips(tmp_path / "t.gpkg")


def test_damaged_geopackages_are_read_or_told_in_one_line(tmp_path):
    good = write_gpkg(tmp_path / "t.gpkg", [ROW] * 3, [Point(WEST)] * 3).read_bytes()
    rng = random.Random(7)
    told = 0
    for _ in range(40):
        data = bytearray(good)
        for _ in range(rng.randint(1, 40)):
            data[rng.randrange(len(data))] = rng.randrange(256)
        file = tmp_path / "damaged.gpkg"
        file.write_bytes(bytes(data[: rng.choice([len(data), rng.randrange(len(data))])]))
        try:
            po.read_trips(file)
        except po.PlatoonError as error:
            told += 1
            text = str(error)
            assert "\n" not in text and len(text) < 400, text  # noqa: PT018 (one claim: a line that can be read)
    assert told > 10
