"""Verbs that read maps: `maps` and `prepare`, and what every verb says of a bad map."""

import json
from pathlib import Path

import pytest
from command_line import CORRIDOR, NODE, ROAD, osm, refused, run, scenario, trips_between, two_roads


def test_maps_reports_on_a_file(capsys):
    assert run("maps", two_roads(), "--infer-links", "--country", "IT", "--limiter", "85") == 0
    out = capsys.readouterr().out
    assert "RoadNetwork two.osm" in out
    assert "2  ways kept" in out
    assert "speed capped for trucks" in out


def test_prepare_then_plan_on_the_saved_form(capsys):
    assert run("prepare", "italy-motorways", "-o", "italy.platoon") == 0
    assert "Saved: italy.platoon" in capsys.readouterr().out
    text = CORRIDOR.replace("{network}", "italy.platoon")
    Path("saved.toml").write_text(text)
    assert run("plan", "saved.toml", "--json", "saved.json") == 0
    assert run("plan", scenario(), "--json", "direct.json") == 0
    saved, direct = (json.loads(Path(f"{name}.json").read_text()) for name in ("saved", "direct"))
    for part in ("trips", "stretches", "ways", "platoons", "events"):
        assert saved[part] == direct[part]
    assert saved["network"]["identity"] == direct["network"]["identity"]
    assert saved["network"]["licence"] == direct["network"]["licence"] == "MIT"


def bad_maps():
    """Names of bad maps, how to make each, and what the message must say."""
    here = [NODE.format(1, 11.0, 45.0), NODE.format(2, 11.1, 45.0)]
    road = ROAD.format(10, 1, 2, "motorway")
    return {
        "not OSM": ("page.osm", "<html></html>", "not a readable OSM file"),
        "nothing": ("empty.osm", "", "not a readable OSM file"),
        "truncated": ("cut.osm.pbf", "\x00\x00\x00\x0e\n\tOSMHeader\x18", "download"),
        "empty area": ("none.osm", [], "no road of class motorway"),
        "no motorway": ("city.osm", [*here, ROAD.format(10, 1, 2, "primary")], "no road of class"),
        "nodes missing": ("bare.osm", [road], "way 10"),
        "one node": ("one.osm", [*here, road.replace('<nd ref="2"/>', "")], "way 10"),
        "NaN": ("nan.osm", [here[0], NODE.format(2, "nan", 45), road], "node 2"),
        "absurd": ("off.osm", [here[0], NODE.format(2, 11, 95), road], "node 2"),
        "wrong suffix": ("map.txt", "hello", "use .osm.pbf, .osm, .osm.gz or .osm.bz2"),
        "not saved": ("map.platoon", "hello", "not a saved network"),
        "missing": ("gone.osm", None, "no such file"),
    }


@pytest.fixture(params=bad_maps().items(), ids=bad_maps())
def bad_map(request):
    name, content, said = request.param[1]
    if isinstance(content, list):
        osm(name, *content)
    elif content is not None:
        Path(name).write_bytes(content.encode("latin-1"))
    return name, said


@pytest.mark.parametrize("verb", ["maps", "prepare", "plan"])
def test_bad_maps(capsys, bad_map, verb):
    name, said = bad_map
    trip = trips_between((11, 45), (12, 45), name)
    Path("bad.toml").write_text(trip)
    arguments = {
        "maps": ["maps", name],
        "prepare": ["prepare", name, "-o", "out.platoon"],
        "plan": ["plan", "bad.toml", "--html", "a.html", "--gpkg", "a.gpkg", "--json", "a.json"],
    }[verb]
    refused(capsys, arguments, name, said)


def test_a_folder_instead_of_a_map(capsys):
    Path("folder").mkdir()
    refused(capsys, ["maps", "folder"], "folder: is a folder")


def test_nowhere_to_save(capsys):
    refused(capsys, ["prepare", two_roads(), "-o", "two.osm/a.platoon"], "no folder")


def test_an_output_that_fails_leaves_the_old_file(capsys, monkeypatch):
    Path("a.platoon").write_text("old")

    def disk_full(self, target):
        raise OSError(28, "No space left on device", str(self))

    two_roads()
    monkeypatch.setattr(Path, "replace", disk_full)
    refused(capsys, ["prepare", "two.osm", "-o", "a.platoon"], "No space left on device")
