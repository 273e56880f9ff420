"""Names in upper case, as Windows users write them, and countries in lower case."""

import gzip
import json
import warnings

import osmnx
import pytest
from osm_files import MOTORWAY, row, write
from small_osm import NODES, ROADS, WAYS, as_overpass

import platoon_osm as po
from platoon_osm.cli import main
from platoon_osm.errors import MapDataError, ScenarioError
from platoon_osm.sources.load import load_network
from platoon_osm.sources.overpass.download import osmnx_settings
from platoon_osm.sources.readers import LINES, READERS
from platoon_osm.sources.truck import TruckRules


def swapped(suffix):
    """One capital at the very end: .osM."""
    return suffix[:-1] + suffix[-1].upper()


ROAD = row(4), {1: ([1, 2, 3, 4], MOTORWAY)}


@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf", ".osm.gz", ".osm.bz2"])
@pytest.mark.parametrize("change", [str.upper, str.title, swapped])
def test_an_extract_in_upper_case_is_read_as_in_lower(tmp_path, suffix, change):
    lower = write(tmp_path, *ROAD, suffix)
    upper = lower.with_name(f"My.Map{change(suffix)}")
    upper.write_bytes(lower.read_bytes())
    assert load_network(upper).m == load_network(lower).m


@pytest.mark.parametrize("suffix", [".OSM", ".OSM.GZ", ".OSM.BZ2"])
def test_drafts_of_josm_in_upper_case(tmp_path, suffix):
    """New objects have negative ids and are read in a second pass, which opens the file again."""
    nodes = {-key: value for key, value in row(4).items()}
    lower = write(tmp_path, nodes, {-1: ([-1, -2, -3, -4], MOTORWAY)}, suffix.lower())
    text = lower.read_bytes()
    upper = tmp_path / f"DRAFT{suffix}"
    upper.write_bytes(text)
    assert load_network(upper).identity() == load_network(lower).identity()


def test_a_node_off_the_globe_is_named_in_upper_case_too(tmp_path):
    lower = write(tmp_path, {**row(3), 3: (999.0, 45.0, {})}, {1: ([1, 2, 3], MOTORWAY)})
    upper = lower.with_name("BAD.OSM")
    lower.rename(upper)
    with pytest.raises(MapDataError, match=r"BAD\.OSM: .*node 3|BAD\.OSM: the node after node 2"):
        load_network(upper)


@pytest.mark.parametrize("suffix", [".osh", ".osh.gz", ".osh.pbf"])
def test_histories_in_either_case(tmp_path, suffix):
    lower = write(tmp_path, *ROAD, suffix.replace("osh", "osm"))
    known = load_network(lower).m
    for name in (f"map{suffix}", f"MAP{suffix.upper()}"):
        (tmp_path / name).write_bytes(lower.read_bytes())
        assert load_network(tmp_path / name).m == known


@pytest.mark.parametrize("suffix", [".osc", ".osc.gz"])
def test_change_files_in_either_case(tmp_path, suffix):
    text = write(tmp_path, *ROAD).read_text()
    known = load_network(tmp_path / "made.osm").m
    text = text.replace("<osm ", "<osmChange ").replace("</osm>", "</create></osmChange>")
    text = text.replace(">\n<node", ">\n<create>\n<node", 1)
    packed = gzip.compress(text.encode()) if suffix.endswith("gz") else text.encode()
    for name in (f"map{suffix}", f"MAP{suffix.upper()}"):
        (tmp_path / name).write_bytes(packed)
        assert load_network(tmp_path / name).m == known


def test_every_kind_of_graph_in_upper_case(tmp_path):
    osm = write(tmp_path, NODES, WAYS)
    with osmnx_settings(tmp_path / "cache", 0, {}):
        graph = osmnx.graph_from_xml(osm, simplify=False, retain_all=True)
    (tmp_path / "SMALL.JSON").write_text(json.dumps(as_overpass()))
    osmnx.save_graphml(graph, tmp_path / "SMALL.GRAPHML")
    osmnx.save_graph_geopackage(graph, tmp_path / "small.gpkg", directed=True)
    (tmp_path / "small.gpkg").rename(tmp_path / "SMALL.GPKG")
    load_network(osm, ROADS).save(tmp_path / "SMALL.PLATOON")
    known = load_network(osm, ROADS)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for kind in ("JSON", "GRAPHML", "GPKG", "PLATOON"):
            assert load_network(tmp_path / f"SMALL.{kind}", ROADS).m == known.m


def test_no_reader_was_forgotten():
    tried = {".osm", ".osm.pbf", ".osm.gz", ".osm.bz2", ".json", ".graphml", ".gpkg", ".platoon"}
    # Those of lines are tried in gis/test_lines.py; GDAL and pyarrow open all of them.
    tried |= set(LINES)
    tried |= {".osh", ".osh.pbf", ".osh.gz", ".osc", ".osc.gz"}
    assert {suffix for reader in READERS.values() for suffix in reader.suffixes} == tried


def test_every_verb_takes_them(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, *ROAD).rename("MAP.OSM")
    assert main(["maps", "MAP.OSM", "--country", "it"]) == 0
    assert "the truck limit of IT" in capsys.readouterr().out
    assert main(["prepare", "MAP.OSM", "--country", "It", "-o", "MAP.PLATOON"]) == 0
    assert main(["warmup", "MAP.PLATOON", "MAP.OSM"]) == 0
    assert (tmp_path / "MAP.PLATOON.hierarchy").is_file()
    assert not (tmp_path / "MAP.OSM.hierarchy").exists()
    capsys.readouterr()


def test_a_misnamed_extract_is_told_in_upper_case_too(tmp_path):
    lower = write(tmp_path, *ROAD)
    wrong = lower.with_name("MAP.OSM.PBF")
    lower.rename(wrong)
    with pytest.raises(MapDataError, match="its content is XML, its name says otherwise"):
        load_network(wrong)


@pytest.mark.parametrize("code", ["it", "It", " IT ", "us-ca"])
def test_a_country_in_any_case(code):
    rules = TruckRules(code)
    assert rules == TruckRules(code.strip().upper())
    net = po.load_network("italy-motorways", country=code)
    assert f"limit of {rules.country}" in str(net.report())


@pytest.mark.parametrize("code", ["", "xx", "itt"])
def test_a_country_that_is_none(code):
    with pytest.raises(ScenarioError, match="has no truck limit here; use AL, AT"):
        TruckRules(code)
