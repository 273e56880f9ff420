"""Lines of a GIS in all forms, against the same map as OSM XML; and files that are none."""

import json
import warnings

import geopandas
import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from osm_files import scattered, write

from platoon_osm.errors import MapDataError
from platoon_osm.sources.gis.columns import tags_of
from platoon_osm.sources.load import load_network
from platoon_osm.sources.osm.extract import read_osm
from platoon_osm.sources.truck import TruckRules

ROADS = ("motorway", "primary")
TAGS = {
    "maxspeed": ["60", "50 mph", "none"],
    "maxspeed:hgv": ["70"],
    "oneway": ["yes", "-1", "no"],
    "maxheight": ["3.8", "12'6\""],
    "hgv:forward": ["no"],
    "hgv": ["destination"],
    "toll": ["yes"],
    "name": ['Via "Roma" \\ 1', "a=>b, {c}", "Größe"],
    "ref": ["A 1"],
    "hazmat:adr_tunnel_cat": ["C"],
}


@st.composite
def maps(draw):
    """Roads between few crossings, with tags."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    n = draw(st.integers(3, 7))
    nodes = scattered(rng, n)
    ways = {}
    for way in range(10, 10 + draw(st.integers(1, 6))):
        refs = rng.choice(n, int(rng.integers(2, min(n, 4) + 1)), replace=False) + 1
        tags = {"highway": str(rng.choice(ROADS))}
        for key, values in TAGS.items():
            if rng.random() < 0.25:
                tags[key] = str(rng.choice(values))
        ways[way] = (refs.tolist(), tags)
    return nodes, ways


def hstore(tags):
    def quoted(text):
        inside = text.replace("\\", "\\\\").replace('"', '\\"')
        return f'"{inside}"'

    return ",".join(f"{quoted(key)}=>{quoted(value)}" for key, value in tags.items())


FORMS = {
    "a column each": lambda tags: {key.replace(":", "_"): value for key, value in tags.items()},
    "hstore": lambda tags: {
        "highway": tags["highway"],
        "other_tags": hstore({key: value for key, value in tags.items() if key != "highway"}),
    },
    "json": lambda tags: {"tags": json.dumps(tags)},
}


def table(nodes, ways, form):
    rows = [{"osm_id": str(way), **FORMS[form](tags)} for way, (_, tags) in ways.items()]
    shapes = [shapely.LineString([nodes[k][:2] for k in refs]) for refs, _ in ways.values()]
    return geopandas.GeoDataFrame(rows, geometry=shapes, crs=4326)


def told(net):
    """What a network says of its roads, whatever its nodes are called."""
    place = list(zip(net.lon.tolist(), net.lat.tolist(), strict=True))
    text = net.texts
    return sorted(
        (
            place[net.tail[e]], place[net.head[e]], round(float(net.length_m[e]), 6),
            round(float(net.speed_mps[e]), 9), round(float(net.posted_mps[e]), 9),
            text[net.restriction[e]], text[net.ref[e]], text[net.name[e]], bool(net.toll[e]),
            int(net.road_class[e]), net.shape(e).tolist(),
        )
        for e in range(net.m)
    )  # fmt: skip


@settings(max_examples=60)
@given(maps(), st.sampled_from(list(FORMS)))
def test_a_table_of_lines_is_the_network_of_the_same_osm_file(tmp_path_factory, problem, form):
    folder = tmp_path_factory.mktemp("lines")
    table(*problem, form).to_parquet(folder / "map.parquet")
    try:
        expected = read_osm(write(folder, *problem), ROADS, TruckRules("IT"))
    except MapDataError:
        with pytest.raises(MapDataError):
            load_network(folder / "map.parquet", ROADS, country="IT")
        return
    net = load_network(folder / "map.parquet", ROADS, country="IT")
    assert told(net) == told(expected)
    for key, number in expected.report().counts.items():
        assert net.report()[key] == number, key


@pytest.mark.parametrize(
    "name",
    [
        "a.gpkg",
        "a.geojson",
        "a.geojsonl",
        "a.fgb",
        "a.shp",
        "a.parquet",
        "utm.gpkg",
        "A.GEOJSON",
        "A.PARQUET",
    ],
)
def test_every_kind_of_file(tmp_path, name):
    lines = [
        shapely.LineString([(11, 45, 100), (11.1, 45, 120)]),
        shapely.MultiLineString([[(11.1, 45, 9), (11.2, 45, 9)], [(11.2, 45, 9), (11.3, 45.1, 9)]]),
    ]
    rows = geopandas.GeoDataFrame(
        {"highway": ["motorway"] * 2, "oneway": [True, False], "maxheight": [3.8, np.nan]},
        geometry=lines,
        crs=4326,
    )
    if name == "utm.gpkg":
        rows = rows.to_crs(32632)
    if name.lower().endswith("parquet"):
        rows.rename_geometry("geom").to_parquet(tmp_path / name)
    else:
        drivers = {".geojsonl": "GeoJSONSeq", ".GEOJSON": "GeoJSON"}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            rows.to_file(tmp_path / name, driver=drivers.get((tmp_path / name).suffix))
    net = load_network(tmp_path / name)
    assert (net.n, net.m) == (3, 3)
    assert net.length_m.sum() == pytest.approx(7_883 + 2 * (7_883 + 13_637), rel=1e-3)
    assert sorted({net.texts[code] for code in net.restriction}) == ["", "maxheight=3.8"]
    # Nothing says that these lines are from OpenStreetMap.
    assert (net.source.licence, net.source.attribution) == ("", "")


def test_lines_that_cross_without_a_common_point_do_not_meet(tmp_path):
    rows = geopandas.GeoDataFrame(
        {"highway": ["primary"] * 3},
        geometry=[
            shapely.LineString([(11, 45), (11.2, 45)]),
            shapely.LineString([(11.1, 44.9), (11.1, 45.1)]),
            shapely.LineString([(11.2, 45), (11.2, 45.1)]),
        ],
        crs=4326,
    )
    rows.to_file(tmp_path / "map.gpkg")
    net = load_network(tmp_path / "map.gpkg", ["primary"])
    # The two that share an end are one road, the third one is another.
    assert (net.n, net.m) == (4, 4)


def test_exits_and_places_come_from_points(tmp_path):
    lines = geopandas.GeoDataFrame(
        {"osm_id": ["1", "2"], "highway": ["motorway"] * 2, "other_tags": ['"oneway"=>"yes"'] * 2},
        geometry=[
            shapely.LineString([(11, 45), (11.1, 45)]), shapely.LineString([(11.1, 45), (11.2, 45)])
        ],
        crs=4326,
    )  # fmt: skip
    points = geopandas.GeoDataFrame(
        {
            "osm_id": ["5", "6"], "name": ["Verona Est", "Area Garda"],
            "highway": ["motorway_junction", "services"], "ref": ["12", None],
            "other_tags": [None, None],
        },
        geometry=[shapely.Point(11.1, 45), shapely.Point(11.15, 45.001)],
        crs=4326,
    )  # fmt: skip
    lines.to_file(tmp_path / "map.gpkg", layer="lines")
    points.to_file(tmp_path / "map.gpkg", layer="points")
    net = load_network(tmp_path / "map.gpkg")
    names = {net.junction_name(v): net.texts[net.node_ref[v]] for v in range(net.n)}
    assert names["Verona Est"] == "12"
    assert [net.texts[code] for code in net.points.name] == ["Area Garda"]
    assert net.source.attribution == "© OpenStreetMap contributors"


def test_shapefiles_of_geofabrik():
    row = {"osm_id": "7", "code": 5111, "fclass": "motorway", "oneway": "T", "maxspeed": 0}
    assert tags_of(row) == {"highway": "motorway", "oneway": "-1"}
    assert tags_of({**row, "oneway": "B", "maxspeed": 80})["maxspeed"] == "80"
    assert tags_of({**row, "oneway": "B"})["oneway"] == "no"


@pytest.mark.parametrize(
    "value",
    [
        '{"maxheight": "3.8"}', {"maxheight": 3.8}, [("maxheight", "3.8")], '"maxheight"=>"3.8"',
        '"a"=>NULL, "maxheight" => "3.8"',
    ],
)  # fmt: skip
def test_forms_of_common_columns(value):
    assert tags_of({"tags": value}) == {"maxheight": "3.8"}


@pytest.mark.parametrize("value", [None, np.nan, "{", "[1]", "no tags", 3.0, [1, 2], '{"a": 1}'])
def test_common_columns_that_say_nothing(value):
    assert tags_of({"tags": value, "highway": "primary"}) == {"highway": "primary"}


def as_geojson(*features):
    return json.dumps({"type": "FeatureCollection", "features": list(features)}).encode()


def feature(coordinates, kind="LineString", **properties):
    geometry = {"type": kind, "coordinates": coordinates}
    return {"type": "Feature", "properties": properties, "geometry": geometry}


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("map.geojson", b"", "not a GeoJSON file, or damaged"),
        ("map.geojson", as_geojson(feature([[11, 45], [12, 45]], highway="motorway"))[:90],
         "not a GeoJSON file, or damaged"),
        ("map.geojson", as_geojson(), "no layer has a column highway"),
        ("map.geojson", as_geojson(feature([[11, 45], [12, 45]], road="A 1")),
         r"no layer has a column highway.*\(map: road\)"),
        ("map.geojson", as_geojson(feature([[11, 45], [12, 45]], highway="primary")),
         r"found: primary \(1\)"),
        ("map.geojson", as_geojson(feature([[11, 45], [12, 95]], highway="motorway")),
         "row 1 has a point at lon 12, lat 95, which is no place on earth"),
        ("map.geojson", as_geojson(feature([11, 45], "Point", highway="motorway")),
         "found: no road at all"),
        ("map.gpkg", b"SQLite format 3\0 and no more", "not a GeoPackage, or damaged"),
        ("map.parquet", b"PAR1 and no more", "not a GeoParquet file, or damaged"),
        ("map.fgb", b"fgb", "not a FlatGeobuf file, or damaged"),
        ("map.shp", b"\0" * 100, "not a shapefile, or damaged"),
    ],
)  # fmt: skip
def test_broken_files_say_what_and_where_in_one_line(tmp_path, name, content, said):
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(MapDataError, match=said) as caught:
        load_network(path)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_system_that_is_not_told(tmp_path):
    rows = geopandas.GeoDataFrame(
        {"highway": ["motorway"]}, geometry=[shapely.LineString([(600000, 5e6), (610000, 5e6)])]
    )
    with pytest.warns(UserWarning, match="crs"):
        rows.to_file(tmp_path / "map.gpkg")
    with pytest.raises(MapDataError, match="does not tell its coordinate system"):
        load_network(tmp_path / "map.gpkg")
    rows.geometry = [shapely.LineString([(11, 45), (11.1, 45)])]
    with pytest.warns(UserWarning, match="crs"):
        rows.to_file(tmp_path / "degrees.gpkg")
    remarks = load_network(tmp_path / "degrees.gpkg").report().remarks
    assert any("degrees were taken" in remark for remark in remarks)


def test_rows_that_are_no_lines_are_counted(tmp_path):
    content = as_geojson(
        feature([[11, 45], [11.1, 45]], highway="motorway"),
        feature([[[11, 45], [11.1, 45], [11.1, 45.1], [11, 45]]], "Polygon", highway="services"),
        {"type": "Feature", "properties": {"highway": "motorway"}, "geometry": None},
    )
    (tmp_path / "map.geojson").write_bytes(content)
    report = load_network(tmp_path / "map.geojson").report()
    assert report["rows left out: neither line nor point"] == 2
