"""Styles of a GeoPackage: QGIS finds them where it looks, and they show what the page shows."""

import re
import sqlite3
import xml.etree.ElementTree as ElementTree
from contextlib import closing
from importlib import resources

import pytest
from hostile_names import HOSTILE
from po_valley import THREE, fifty, make_plan

import platoon_osm as po
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.report.drawing.vehicle_styles import vehicle_styles
from platoon_osm.report.exports.qgis_styles import MERGE, MOST_VEHICLES, SEPARATION
from platoon_osm.report.exports.qgis_symbols import quoted, rgba
from platoon_osm.shown_text import shown

SHAPES = ("routes", "platoons", "points", "network")


def styles_of(path):
    """Return the styles of a file by layer, found as QGIS looks for them."""
    with closing(sqlite3.connect(path)) as file:
        return {
            layer: ElementTree.fromstring(qml)
            for layer in SHAPES
            for (qml,) in file.execute(
                "SELECT styleQML FROM layer_styles WHERE f_table_schema = '' AND f_table_name = ? "
                "AND f_geometry_column = (SELECT column_name FROM gpkg_geometry_columns "
                "WHERE table_name = f_table_name) AND useAsDefault = 1",
                [layer],
            )
        }


def values(path, column, table):
    with closing(sqlite3.connect(path)) as file:
        return {value for (value,) in file.execute(f'SELECT DISTINCT "{column}" FROM "{table}"')}


def options(part):
    """Return the options of a layer of a symbol."""
    return {one.get("name"): one.get("value") for one in part.find("Option")}


@pytest.fixture(scope="module")
def written(tmp_path_factory, plan, net):
    path = tmp_path_factory.mktemp("qgis") / "plan.gpkg"
    po.write_geopackage(plan, net, path)
    return path


def test_every_layer_with_shapes_has_a_style_that_is_taken(written):
    found = styles_of(written)
    assert tuple(found) == SHAPES
    for root in found.values():
        assert root.tag == "qgis"
        assert root.get("version") == "3.22.0"
        kinds = {part.get("class") for part in root.iter("layer")}
        assert kinds <= {
            "SimpleLine",
            "GeometryGenerator",
            "SimpleMarker",
            "FontMarker",
            "SvgMarker",
        }


def test_the_table_is_one_as_qgis_writes_it_and_other_readers_read(written):
    import geopandas
    import pyogrio

    with closing(sqlite3.connect(written)) as file:
        columns = [row[1] for row in file.execute("PRAGMA table_info(layer_styles)")]
        kinds = dict(file.execute("SELECT table_name, data_type FROM gpkg_contents"))
    assert columns == [
        "id", "f_table_catalog", "f_table_schema", "f_table_name", "f_geometry_column", "styleName",
        "styleQML", "styleSLD", "useAsDefault", "description", "owner", "ui", "update_time",
    ]  # fmt: skip
    assert kinds["layer_styles"] == "attributes"
    listed = dict(pyogrio.list_layers(written).tolist())
    assert {name for name, shape in listed.items() if shape is not None} == set(SHAPES)
    assert len(geopandas.read_file(written, layer="layer_styles")) == len(SHAPES)
    assert len(geopandas.read_file(written, layer="routes")) > 0


def test_vehicles_look_as_on_the_page(written, plan):
    names = [shown(vehicle.vehicle) for vehicle in plan.vehicles]
    root = styles_of(written)["routes"]
    renderer = root.find("renderer-v2")
    assert renderer.get("attr") == "vehicle"
    categories = {one.get("value"): one.get("symbol") for one in renderer.iter("category")}
    assert set(categories) == values(written, "vehicle", "routes") == set(names)
    symbols = {one.get("name"): one for one in renderer.find("symbols")}
    assert set(symbols) == set(categories.values())
    for name, style in zip(names, vehicle_styles(names), strict=True):
        lines = [part for part in symbols[categories[name]].iter("layer")
                 if part.get("class") == "SimpleLine"]  # fmt: skip
        colours = [options(part)["line_color"] for part in lines]
        assert colours == [rgba("#fff"), rgba(style.colour), rgba(style.colour)]
        assert {options(part)["use_custom_dash"] for part in lines[1:]} == {
            "1" if style.dash else "0"
        }


def test_ends_are_lettered_and_events_wear_the_marks_of_the_page(written, plan):
    root = styles_of(written)["points"]
    found = {one.get("value") for one in root.iter("category")}
    assert found == {"start", "destination", "merge", "separation"}
    assert values(written, "kind", "points") <= found
    chars = [one.get("value") for one in root.iter("Option") if one.get("name") == "expression"]
    for vehicle, style in zip(
        plan.vehicles, vehicle_styles([v.vehicle for v in plan.vehicles]), strict=True
    ):
        wanted = f"{quoted(shown(vehicle.vehicle))}, {quoted(style.letter)}"
        assert any(wanted in text for text in chars)
    page = resources.files("platoon_osm.report.assets").joinpath("map.svg.html").read_text()
    for mark in (MERGE, SEPARATION):
        for drawn in re.findall(r' d="([^"]+)"| r="([^"]+)"', mark):
            assert next(filter(None, drawn)) in page


def test_all_symbols_have_names_of_their_own(written):
    for root in styles_of(written).values():
        names = [one.get("name") for one in root.iter("symbol")]
        assert len(names) == len(set(names))


def test_the_same_plan_gives_the_same_bytes(written, plan, net, tmp_path):
    po.write_geopackage(plan, net, tmp_path / "again.gpkg")
    assert (tmp_path / "again.gpkg").read_bytes() == written.read_bytes()


def test_more_vehicles_than_looks(net: RoadNetwork, tmp_path):
    trips = fifty()
    again = [(f"{name} again", *way) for name, *way in trips[1:]]
    more = make_plan(net, [*trips, *again][: MOST_VEHICLES + 1])
    po.write_geopackage(more, net, tmp_path / "more.gpkg")
    found = styles_of(tmp_path / "more.gpkg")
    assert found["routes"].find("renderer-v2").get("type") == "singleSymbol"
    assert not [part for part in found["points"].iter("layer") if part.get("class") == "FontMarker"]
    assert (tmp_path / "more.gpkg").stat().st_size < 4_000_000


def test_names_stay_names(net: RoadNetwork, tmp_path):
    for number, one in enumerate(HOSTILE[::6]):
        plan = make_plan(net, THREE, lambda name, one=one: f"{one} {name}")
        path = tmp_path / f"{number}.gpkg"
        po.write_geopackage(plan, net, path)
        found = styles_of(path)
        assert tuple(found) == SHAPES
        names = [category.get("value") for category in found["routes"].iter("category")]
        assert names == [shown(vehicle.vehicle) for vehicle in plan.vehicles]


def test_a_text_of_an_expression_ends_nowhere_but_at_its_end():
    assert quoted("it's") == r"'it\'s'"
    assert quoted("back\\") == r"'back\\'"
    assert quoted("\\' || @x || '") == r"'\\\' || @x || \''"
