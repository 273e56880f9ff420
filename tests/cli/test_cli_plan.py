"""The verb `plan`: what it prints and writes."""

import json
from pathlib import Path

import pytest
from command_line import OUTPUTS, refused, run, scenario, trips_between, two_roads

import platoon_osm


def test_plan_prints_a_table_and_writes_what_is_asked_for(capsys):
    assert run("plan", scenario(), "--html", "a.html", "--gpkg", "a.gpkg", "--json", "a.json") == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert [line for line in out.splitlines() if line.startswith("Written: ")] == [
        "Written: a.html", "Written: a.gpkg", "Written: a.json",
    ]  # fmt: skip
    page = Path("a.html").read_text(encoding="utf-8")
    assert page.lstrip().lower().startswith("<!doctype html")
    assert "A small corridor" in page
    assert Path("a.gpkg").read_bytes().startswith(b"SQLite format 3")
    plan = platoon_osm.JointPlan.from_dict(json.loads(Path("a.json").read_text()))
    assert [vehicle.vehicle for vehicle in plan.vehicles] == ["A", "B"]
    assert plan.case == plan.asked == "C"
    assert 0 < plan.saving < 0.5
    assert sorted(path.name for path in Path().iterdir()) == [
        "a.gpkg", "a.html", "a.json", "corridor.toml",
    ]  # fmt: skip


def test_plan_writes_tables_tracks_figures_and_flows(capsys):
    asked = ("--csv", "a.csv", "--flows", "f.html", "--gpx", "tracks", "--figures", "made/figures")
    assert run("plan", scenario(), *asked) == 0
    assert Path("a.csv").read_text(encoding="utf-8").count("\n") > 3
    assert "Content-Security-Policy" in Path("f.html").read_text(encoding="utf-8")
    assert len(list(Path("tracks").glob("*.gpx"))) == 2
    assert list(Path("made/figures").glob("*.svg"))
    assert "Written: tracks" in capsys.readouterr().out


def test_folders_are_made_only_for_a_plan(capsys):
    Path("bad.toml").write_text('network = "nowhere"\n[[trips]]\n', encoding="utf-8")
    assert run("plan", "bad.toml", "--gpx", "tracks", "--figures", "figures") == 2
    assert not Path("tracks").exists()
    assert not Path("figures").exists()


def test_the_case_on_the_command_line_comes_first(capsys):
    assert run("plan", scenario(), "--case", "best", "--json", "a.json") == 0
    assert json.loads(Path("a.json").read_text())["asked"] == "best"


def test_a_map_beside_its_scenario(capsys, monkeypatch, tmp_path):
    (tmp_path / "sub").mkdir()
    text = trips_between((11.1, 45.0), (11.2, 45.0), two_roads(str(tmp_path / "sub" / "two.osm")))
    (tmp_path / "sub" / "one.toml").write_text(text.replace(str(tmp_path / "sub") + "/", ""))
    assert run("plan", "sub/one.toml") == 0
    assert "A" in capsys.readouterr().out


CSV = 'network = "{network}"\ncase = "C"\ntrips = "trips.csv"\n'


def test_trips_from_csv(capsys):
    Path("trips.csv").write_text(
        'vehicle,origin,destination\nA,Torino,13.77 45.65\n"B, the second",Genova,Belluno\n'
    )
    assert run("plan", scenario(CSV), "--json", "a.json") == 0
    vehicles = json.loads(Path("a.json").read_text())["trips"]
    assert [item["vehicle"] for item in vehicles] == ["A", "B, the second"]
    assert vehicles[0]["destination"]["lon"] == pytest.approx(13.77, abs=0.1)


@pytest.mark.parametrize("option", ["--html", "--gpkg", "--json"])
def test_nowhere_to_write(capsys, option):
    Path("file").write_text("mine")
    refused(capsys, ["plan", scenario(), option, "file/a.out"], "file/a.out", "file is no folder")
    Path("taken").mkdir()
    refused(capsys, ["plan", scenario(), option, "taken"], "taken", "folder")


def test_an_unknown_case_on_the_command_line(capsys):
    refused(capsys, ["plan", scenario(), "--case", "X", *OUTPUTS], "case 'X' is unknown")
