"""The command line as a user meets it: what it prints, writes, refuses, and with which status."""

import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from places import ROOT

import platoon_osm
from platoon_osm.atomic_file import whole_file
from platoon_osm.cli import main

VERBS = ("demo", "maps", "prepare", "download", "plan", "study", "compare", "warmup")

CORRIDOR = """
title = "A small corridor"
network = "{network}"
case = "C"

[[trips]]
vehicle = "A"
origin = "Torino"
destination = "Trieste"

[[trips]]
vehicle = "B"
origin = "Genova"
destination = "Belluno"
"""

NODE = '<node id="{}" lon="{}" lat="{}"/>'
ROAD = '<way id="{}"><nd ref="{}"/><nd ref="{}"/><tag k="highway" v="{}"/></way>'


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    """Every test starts in an empty folder, so that whatever is left behind is seen."""
    monkeypatch.chdir(tmp_path)


def osm(name, *lines):
    Path(name).write_text(f'<osm version="0.6">{"".join(lines)}</osm>')
    return name


def two_roads(name="two.osm"):
    """Two motorways, each in one direction, that do not meet."""
    return osm(
        name,
        *(NODE.format(i, 11 + i / 10, 45 + (i > 2) / 10) for i in range(1, 5)),
        ROAD.format(10, 1, 2, "motorway"),
        ROAD.format(11, 3, 4, "motorway"),
    )


def scenario(text=CORRIDOR, name="corridor.toml", **values):
    Path(name).write_text(text.format(network="italy-motorways", **values), encoding="utf-8")
    return name


def trips_between(origin, destination, network):
    """A scenario of one trip between two coordinates."""
    return (
        f'network = "{network}"\n[[trips]]\nvehicle = "A"\n'
        f"origin = {list(origin)}\ndestination = {list(destination)}\n"
    )


def run(*arguments):
    """Run in this process; return the status, also where argparse leaves by SystemExit."""
    try:
        return main([str(argument) for argument in arguments])
    except SystemExit as left:
        return left.code


def refused(capsys, arguments, *said):
    """The command must fail with status 2, one line, nothing printed and nothing written."""
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    capsys.readouterr()
    status = run(*arguments)
    out, err = capsys.readouterr()
    assert status == 2
    assert out == ""
    assert err.count("\n") == 1, err
    assert err.endswith("\n")
    assert err.startswith("platoon-osm")
    assert "Traceback" not in err
    for part in said:
        assert part in err
    after = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    assert after == before
    return err


# -- what works ------------------------------------------------------------------------------------


@pytest.mark.parametrize("verb", ["", *VERBS])
def test_help_teaches(verb, capsys):
    assert run(*([verb] if verb else []), "--help") == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert f"Usage: platoon-osm{' ' + verb if verb else ''}" in out
    if not verb:
        assert all(known in out for known in VERBS)
        assert "platoon-osm plan corridor.toml --html plan.html" in out
    else:
        assert len(out.splitlines()) > 4


def test_version(capsys):
    assert run("--version") == 0
    assert capsys.readouterr().out == f"platoon-osm {platoon_osm.__version__}\n"


def test_maps_lists_the_bundled_ones(capsys):
    assert run("maps") == 0
    out, err = capsys.readouterr()
    assert out.startswith("italy-motorways: ")
    assert err == ""


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
    assert saved["vehicles"] == direct["vehicles"]
    assert saved["network"]["identity"] == direct["network"]["identity"]
    assert saved["network"]["licence"] == direct["network"]["licence"] == "MIT"


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
    vehicles = json.loads(Path("a.json").read_text())["vehicles"]
    assert [item["vehicle"] for item in vehicles] == ["A", "B, the second"]
    assert vehicles[0]["destination"]["lon"] == pytest.approx(13.77, abs=0.1)


def command(*arguments):
    return subprocess.run(
        [sys.executable, "-m", "platoon_osm.cli", *arguments], capture_output=True, text=True,
        timeout=120, env={"PYTHONPATH": str(ROOT), "PATH": "", "PYTHONWARNINGS": "error"},
        check=False,
    )  # fmt: skip


def test_as_a_command_of_its_own():
    done = command("plan", scenario(), "--json", "a.json")
    assert (done.returncode, done.stderr) == (0, "")
    assert "Written: a.json" in done.stdout
    assert Path("a.json").is_file()


def test_as_a_command_that_fails():
    Path("page.osm").write_text("<html></html>")
    done = command("prepare", "page.osm", "-o", "a.platoon")
    assert (done.returncode, done.stdout) == (2, "")
    assert re.fullmatch(r"platoon-osm: page\.osm: not a readable OSM file .*\n", done.stderr)
    assert not Path("a.platoon").exists()


def test_a_command_without_a_verb():
    done = command()
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "--help" in done.stderr


# -- what is refused -------------------------------------------------------------------------------


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


OUTPUTS = ("--html", "a.html", "--gpkg", "a.gpkg", "--json", "a.json")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('case = "C"', 'caes = "C"', "no key 'caes'; did you mean 'case'?"),
        ("[[trips]]", "[[trip]]", "did you mean 'trips'?"),
        ('origin = "Genova"', 'orign = "Genova"', "did you mean 'origin'?"),
        ('case = "C"', "[costs]\nfuel_savings = 0.1", "did you mean 'fuel_saving'?"),
        ('network = "italy-motorways"', '[network]\nsorce = "x"', "network is missing"),
        ('network = "italy-motorways"', "", "network is missing"),
        ('case = "C"', 'case = "E"', "case 'E' is unknown; use A, B, C, D, best"),
        ('case = "C"', "case = 3", "must be a text in quotes"),
        ('case = "C"', 'objective = "both"', "objective 'both' is unknown; use member, system"),
        ('case = "C"', 'method = "magic"', "method 'magic' is unknown; use dijkstra, astar"),
        ('case = "C"', 'master = "Z"', "master 'Z' has no trip; vehicles are A, B"),
        ('case = "C"', "[costs]\ntau = -0.5", "tau = -0.5 must be a number in [0, 1]"),
        ('case = "C"', "[costs]\nspeed_kmh = -80", "speed_kmh = -80 must be a number"),
        ('case = "C"', "[costs]\nfuel_saving = nan", "fuel_saving = nan must be a number"),
        ('"Belluno"', '"Genova"', "same place"),
        ('"Belluno"', '"Bellumo"', "did you mean Belluno"),
        ('"Belluno"', '"ovest"', "ambiguous"),
        ('"Belluno"', "[13.7, 145.6]", "latitude within [-90, 90]"),
        ('"Belluno"', "[nan, 45.6]", "longitude comes first"),
        ('"Belluno"', "[13.7]", "must be a name or a [lon, lat] pair"),
        ('vehicle = "B"', 'vehicle = "A"', "vehicle 'A' has 2 trips"),
        ('vehicle = "B"', 'vehicle = ""', "vehicle"),
        ('vehicle = "B"\n', "", "has no vehicle"),
        ("title =", "title", "not a TOML file"),
    ],
)
def test_bad_scenarios(capsys, old, new, said):
    text = CORRIDOR.format(network="italy-motorways")
    assert old in text
    # A table must not swallow the keys after it, so it goes to the end.
    changed = (
        text.replace(old, "") + new if new.startswith("[costs]") else text.replace(old, new, 1)
    )
    Path("bad.toml").write_text(changed)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "bad.toml", said)


@pytest.mark.parametrize("value", ["-5", '"fast"', "nan", "true"])
def test_a_limiter_that_is_no_speed(capsys, value):
    text = CORRIDOR.replace('network = "{network}"', "") + (
        f'[network]\nsource = "italy-motorways"\nlimiter_kmh = {value}\n'
    )
    Path("bad.toml").write_text(text)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "limiter_kmh")


@pytest.mark.parametrize("value", ['"motorway"', "[1, 2]", "5"])
def test_classes_that_are_no_list(capsys, value):
    text = CORRIDOR.replace('network = "{network}"', "") + (
        f'[network]\nsource = "italy-motorways"\nclasses = {value}\n'
    )
    Path("bad.toml").write_text(text)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "classes")


def test_an_unreachable_destination(capsys):
    Path("bad.toml").write_text(trips_between((11.1, 45.0), (11.4, 45.1), two_roads()))
    refused(
        capsys, ["plan", "bad.toml", *OUTPUTS], "'A'", "no route from", "two.osm", "--infer-links"
    )


def test_origin_and_destination_in_one_spot(capsys):
    spot = (7.6, 45.1)
    Path("bad.toml").write_text(trips_between(spot, spot, "italy-motorways"))
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "bad.toml", "'A'", "same place")


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("vehicle,orign,destination\nA,Torino,Genova\n", "did you mean 'origin'?"),
        ("vehicle,origin,destination\n", "no rows"),
        ("vehicle,origin,destination\nA,Torino\n", "trips.csv line 2"),
        ("vehicle,origin,destination\nA,Torino,\n", "trips.csv line 2"),
        ("vehicle,origin,destination\nA,Torino,Nowhere at all\n", "no junction or town"),
        ("vehicle;origin;destination\nA;Torino;Genova\n", "trips.csv"),
        ("", "no rows"),
        ('vehicle,origin,destination\nA,"Torino,Genova\n', "trips.csv"),
    ],
)
def test_bad_trip_tables(capsys, table, said):
    Path("trips.csv").write_text(table)
    refused(capsys, ["plan", scenario(CSV), *OUTPUTS], said)


def test_missing_scenario_and_missing_table(capsys):
    refused(capsys, ["plan", "gone.toml", *OUTPUTS], "gone.toml: cannot be read")
    refused(capsys, ["plan", scenario(CSV), *OUTPUTS], "trips.csv cannot be read")


def test_a_scenario_that_is_a_folder_or_no_text(capsys):
    Path("dir.toml").mkdir()
    refused(capsys, ["plan", "dir.toml"], "dir.toml: cannot be read")
    Path("bytes.toml").write_bytes(b"\xff\xfe\x00")
    refused(capsys, ["plan", "bytes.toml"], "bytes.toml: not a TOML file")


@pytest.mark.parametrize("option", ["--html", "--gpkg", "--json"])
def test_nowhere_to_write(capsys, option):
    refused(capsys, ["plan", scenario(), option, "gone/a.out"], "gone/a.out", "folder")
    Path("taken").mkdir()
    refused(capsys, ["plan", scenario(), option, "taken"], "taken", "folder")


def test_nowhere_to_save(capsys):
    refused(capsys, ["prepare", two_roads(), "-o", "gone/a.platoon"], "gone/a.platoon")


def test_an_output_that_fails_leaves_the_old_file(capsys, monkeypatch):
    Path("a.platoon").write_text("old")

    def disk_full(self, target):
        raise OSError(28, "No space left on device", str(self))

    two_roads()
    monkeypatch.setattr(Path, "replace", disk_full)
    refused(capsys, ["prepare", "two.osm", "-o", "a.platoon"], "No space left on device")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["fly"], "invalid choice"),
        ([], "required"),
        (["plan"], "required"),
        (["prepare", "italy-motorways"], "-o"),
        (["maps", "italy-motorways", "--limiter", "fast"], "--limiter"),
        (["maps", "italy-motorways", "--limiter", "-5"], "limiter_kmh -5"),
        (["maps", "italy-motorways", "--country", "XX"], "country 'XX'"),
        (["maps", "italy-motorways", "--classes", ","], "--classes"),
        (["maps", "italy-motorways", "--classes", "footway"], "no road of class footway"),
        (["maps", "--colour\nred"], "unrecognized"),
        (["maps", "atlantis"], "no such file, and no bundled map of that name"),
        (["maps", "new\nline.osm"], "no such file"),
    ],
)
def test_bad_arguments(capsys, arguments, said):
    refused(capsys, arguments, said)


def test_an_unknown_case_on_the_command_line(capsys):
    refused(capsys, ["plan", scenario(), "--case", "X", *OUTPUTS], "case 'X' is unknown")


def test_control_characters_of_a_map_do_not_reach_the_terminal(capsys):
    text = CORRIDOR.format(network="italy-motorways").replace('"Belluno"', '"\\u001b[31mred\\nX"')
    Path("bad.toml").write_text(text)
    assert "\x1b" not in refused(capsys, ["plan", "bad.toml"], "red")


def test_a_request_to_end_cleans_up_first(capsys, monkeypatch):
    def ended(net, path):
        with whole_file(path) as draft:
            draft.write_text("half")
            signal.raise_signal(signal.SIGTERM)

    before = signal.getsignal(signal.SIGTERM)
    monkeypatch.setattr("platoon_osm.network.road_network.RoadNetwork.save", ended)
    refused(capsys, ["prepare", "italy-motorways", "-o", "a.platoon"], "interrupted")
    assert list(Path().iterdir()) == []
    assert signal.getsignal(signal.SIGTERM) is before


def test_an_interrupt_is_one_line_too(capsys, monkeypatch):
    def interrupted(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("platoon_osm.sources.load.load_network", interrupted)
    refused(capsys, ["prepare", "italy-motorways", "-o", "a.platoon"], "interrupted")


def test_the_demo_where_a_file_is_in_the_way(capsys):
    Path("out").write_text("mine")
    refused(capsys, ["demo", "-o", "out"], "out")


def test_the_demo(capsys):
    assert run("demo", "-o", "shown") == 0
    out = capsys.readouterr().out
    assert sorted(path.name for path in Path("shown").iterdir()) == ["demo.gpkg", "demo.html"]
    for case in "ABCD":
        assert re.search(rf"[Cc]ase {case}\b", out), case


def test_a_reader_that_has_seen_enough_is_no_error():
    seen, written = os.pipe()
    os.close(seen)
    try:
        done = subprocess.run(
            [sys.executable, "-m", "platoon_osm.cli", "maps", "italy-motorways"],
            stdout=written, stderr=subprocess.PIPE, timeout=60, check=False,
        )  # fmt: skip
    finally:
        os.close(written)
    assert (done.returncode, done.stderr) == (0, b"")
