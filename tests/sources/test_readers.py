"""The list of readers: what finds one, and that a user adds one without touching the package."""

import subprocess
import sys
from pathlib import Path

import pytest
from osm_files import MOTORWAY, row, write

from platoon_osm import load_network
from platoon_osm.errors import MapDataError, ScenarioError
from platoon_osm.network.load_report import Source
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.sources.catalog import BUNDLED_MAPS, BundledMap
from platoon_osm.sources.readers import READERS, Reader, reader_of, supported_files


def read_links(path, classes, rules):
    """Read "lon lat lon lat", a road a line."""
    rows = [[float(part) for part in line.split()] for line in path.read_text().splitlines()]
    lon = [value for row in rows for value in (row[0], row[2])]
    lat = [value for row in rows for value in (row[1], row[3])]
    ends = range(0, len(lon), 2)
    return RoadNetwork.from_edges(
        ends, [end + 1 for end in ends], lon=lon, lat=lat, source=Source(path.name),
        speed_mps=rules.limiter_kmh / 3.6,
    )  # fmt: skip


@pytest.fixture
def links(tmp_path, monkeypatch):
    monkeypatch.setattr(READERS, "_items", dict(READERS._items))
    READERS.add(Reader("links", (".links", ".osm.links"), "list of links", read_links))
    path = tmp_path / "a.osm.LINKS"
    path.write_text("9.0 45.0 9.1 45.0\n9.1 45.0 9.0 45.0\n")
    return path


def test_a_reader_of_ones_own_is_found_by_its_suffix(links):
    net = load_network(links, limiter_kmh=72)
    assert (net.m, net.source.name) == (2, "a.osm.LINKS")
    assert net.speed_mps.tolist() == [20.0, 20.0]
    assert any("a limiter of 72 km/h" in remark for remark in net.report().remarks)
    assert "list of links (.links, .osm.links)" in supported_files()


def test_messages_name_a_reader_that_was_added(links, tmp_path):
    (tmp_path / "map.txt").write_text("hello")
    with pytest.raises(MapDataError, match=r"use .osm.pbf.*other maps end in .graphml.*\.links"):
        load_network(tmp_path / "map.txt")


def test_a_reader_must_return_a_network(links):
    READERS.add(Reader("links", (".links",), "nothing", lambda *_: {}), replace=True)
    with pytest.raises(MapDataError, match="reader 'links' returned a dict"):
        load_network(links)


def test_a_reader_is_found_by_what_the_file_begins_with(links, tmp_path):
    READERS.add(Reader("odd", (), "odd", lambda *_: None, begins=b"ODDFORM"))
    (tmp_path / "a.links").write_bytes(b"ODDFORM and more")
    assert reader_of(tmp_path / "a.links").name == "odd"


def test_the_last_of_two_readers_for_a_suffix_has_it(links):
    READERS.add(Reader("better", (".osm.links",), "better", read_links))
    assert reader_of(links).name == "better"


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("a.osm.pbf", "osm"), ("a.OSM", "osm"), ("a.osm.gz", "osm"), ("a.osm.bz2", "osm"),
        ("a.pbf", "osm"), ("a", "osm"), ("a.GraphML", "graphml"), ("a.gpkg", "geopackage"),
        ("a.json", "overpass"), ("a.platoon", "saved"),
    ],
)  # fmt: skip
def test_names_of_files(tmp_path, name, expected):
    (tmp_path / name).write_bytes(b"")
    assert reader_of(tmp_path / name).name == expected


@pytest.mark.parametrize("suffixes", [("links",), (".LINKS",), ".links", (3,), ()])
def test_suffixes_that_could_never_be_found(suffixes):
    with pytest.raises(ScenarioError, match="must be texts in lower case"):
        Reader("links", suffixes, "list of links", read_links)


def test_reading_the_list_imports_nothing_heavy():
    code = (
        "import sys, platoon_osm.sources.readers\n"
        "print([n for n in ('numpy', 'osmium', 'networkx') if n in sys.modules])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_a_map_of_ones_own_has_a_name(tmp_path, monkeypatch):
    monkeypatch.setattr(BUNDLED_MAPS, "_items", dict(BUNDLED_MAPS._items))
    path = write(tmp_path, row(3), {1: ([1, 2, 3], {**MOTORWAY, "oneway": "no"})})
    BUNDLED_MAPS.add(BundledMap("ours", str(path), "FR", "ours", "us", "none"))
    net = load_network("ours")
    assert (net.source.name, net.source.attribution, net.source.licence) == ("ours", "us", "none")
    assert any("the truck limit of FR" in remark for remark in net.report().remarks)
    with pytest.raises(MapDataError, match=r"nowhere.*\(italy-motorways, .*corridor, ours\)"):
        load_network(Path("nowhere"))
