"""What the command writes harms nothing: no input, no other output, nothing that is no file."""

import json
import os
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import refused, run, scenario
from places import ROOT

posix = pytest.mark.skipif(os.name == "nt", reason="links and devices of POSIX")

CSV = 'network = "map.osm"\ncase = "C"\ntrips = "trips.csv"\n'
ROWS = "vehicle,origin,destination\nTorino,Torino,Trieste\nB,Genova,Belluno\n"


@pytest.fixture
def inputs():
    """A scenario, its table of trips and its map, all in this folder."""
    Path("map.osm").write_bytes((ROOT / "maps" / "italy-motorways.osm").read_bytes())
    Path("trips.csv").write_text(ROWS)
    Path("plan.toml").write_text(CSV)


@pytest.mark.parametrize(
    ("option", "name"),
    [("--csv", "trips.csv"), ("--json", "linked.json"), ("--html", "hard.html"),
     ("--json", "toml.json"), ("--csv", "./sub/../trips.csv"), ("--html", "map.html")],
)  # fmt: skip
@posix
def test_an_input_is_no_output(capsys, inputs, option, name):
    Path("sub").mkdir()
    Path("linked.json").symlink_to("trips.csv")
    os.link("trips.csv", "hard.html")
    Path("toml.json").symlink_to("plan.toml")
    os.link("map.osm", "map.html")
    said = refused(capsys, ["plan", "plan.toml", option, name], f"{option} {Path(name)}", "is read")
    assert "would replace" in said


@posix
def test_an_input_in_a_folder_that_is_written_into(capsys, inputs):
    Path("schedule.csv").write_text(ROWS)
    Path("plan.toml").write_text(CSV.replace("trips.csv", "schedule.csv"))
    refused(capsys, ["plan", "plan.toml", "--figures", "."], "--figures .", "schedule.csv")
    Path("tracks").mkdir()
    os.link("schedule.csv", "tracks/x.gpx")
    refused(capsys, ["plan", "plan.toml", "--gpx", "tracks"], "--gpx tracks", "schedule.csv")


@posix
def test_inputs_of_the_other_verbs(capsys, inputs):
    os.link("map.osm", "again.platoon")
    refused(capsys, ["prepare", "map.osm", "-o", "again.platoon"], "which is read")
    os.link("trips.csv", "c.html")
    refused(capsys, ["compare", "plan.toml", "-o", "c.html"], "which is read")
    Path("out").mkdir()
    os.link("map.osm", "out/comparison.csv")
    refused(capsys, ["study", "--network", "map.osm", "-o", "out"], "which is read")
    marks = "<!-- study:begin --><!-- study:end -->"
    Path("out/report.html").write_text(marks)
    refused(capsys, ["study", "-o", "out", "--table", "out/report.html"], "write the same file")


@pytest.mark.parametrize(
    "options",
    [
        ("--html", "a.html", "--flows", "a.html"),
        ("--html", "a.html", "--flows", "./a.html"),
        ("--html", "a.html", "--flows", "b.html"),  # a link to it
        ("--html", "kept.html", "--flows", "hard.html"),  # two names of one file
        ("--csv", "figures/schedule.csv", "--figures", "figures"),
        ("--gpx", "new", "--html", "new"),
        ("--figures", "figures", "--csv", "linked.csv"),
    ],
)
@posix
def test_two_outputs_are_two_files(capsys, options):
    Path("b.html").symlink_to("a.html")
    Path("kept.html").write_text("kept")
    os.link("kept.html", "hard.html")
    Path("figures").mkdir()
    Path("linked.csv").symlink_to("figures/schedule.csv")
    refused(capsys, ["plan", scenario(), *options], "write the same file")


def test_folders_of_several_kinds_of_output_may_be_one(capsys):
    Path("all").mkdir()
    asked = ("--gpx", "all", "--figures", "all", "--html", "all/plan.html")
    assert run("plan", scenario(), *asked) == 0
    assert {"a.gpx", "b.gpx", "plan.html", "costs.svg"} <= {p.name for p in Path("all").iterdir()}
    assert not list(Path().rglob(".draft-*"))


@pytest.mark.parametrize("name", ["/dev/null", "/dev/full", "pipe", "socket", "/dev/stdout",
                                  "/dev/fd/1", "/proc/self/fd/1"])  # fmt: skip
@posix
def test_what_is_no_file_is_refused(capsys, name):
    os.mkfifo("pipe")
    with socket.socket(socket.AF_UNIX) as bound:
        bound.bind("socket")
        for option in ("--html", "--gpkg", "--json", "--csv", "--flows", "--gpx", "--figures"):
            refused(capsys, ["plan", scenario(), option, name], name)
        for verb in (["prepare", "italy-motorways"], ["download", "Verona"], ["demo"],
                     ["compare", scenario()], ["study"]):  # fmt: skip
            refused(capsys, [*verb, "-o", name], name)


@pytest.mark.parametrize(
    ("option", "name", "right"),
    [("--html", "x.gpkg", ".html"), ("--gpkg", "x.html", ".gpkg"), ("--json", "x.toml", ".json"),
     ("--csv", "x.xlsx", ".csv"), ("--flows", "x.json", ".html")],
)  # fmt: skip
def test_a_suffix_of_another_format(capsys, option, name, right):
    refused(capsys, ["plan", scenario(), option, name], name, right)


def test_suffixes_of_the_other_verbs(capsys):
    refused(capsys, ["prepare", "italy-motorways", "-o", "a.osm"], "a.osm", ".platoon")
    refused(capsys, ["compare", scenario(), "-o", "a.json"], "a.json", ".html")
    refused(capsys, ["download", "Verona", "-o", "a.html"], "a.html", ".graphml")


def test_everything_is_checked_before_anything_is_done(capsys, monkeypatch):
    def never(*_, **__):
        raise AssertionError("worked before it looked")

    monkeypatch.setattr("platoon_osm.sources.load.load_network", never)
    for option in ("--gpx", "--figures"):
        Path("file").write_text("mine")
        refused(capsys, ["plan", scenario(), "--html", "a.html", option, "file/in"], "file")
    refused(capsys, ["plan", scenario(), "--html", "a.html", "--json", "file/a.json"], "no folder")


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write all")
def test_a_folder_that_takes_no_files(capsys):
    Path("closed").mkdir(mode=0o500)
    refused(capsys, ["plan", scenario(), "--html", "closed/a.html"], "takes no files")
    refused(capsys, ["plan", scenario(), "--gpx", "closed/new"], "takes no files")


def test_the_demo_does_not_take_the_place_of_a_folder(capsys):
    Path("out/demo.html").mkdir(parents=True)
    refused(capsys, ["demo", "-o", "out"], "demo.html: is a folder")


@pytest.mark.parametrize(
    ("option", "begins"),
    [("--json", "{"), ("--csv", "vehicle,"), ("--html", "<!doctype"), ("--flows", "<!doctype")],
)  # fmt: skip
def test_text_goes_to_standard_output_and_the_summary_beside(capsys, option, begins):
    assert run("plan", scenario(), option, "-", "--gpkg", "a.gpkg") == 0
    out, err = capsys.readouterr()
    assert out.lower().startswith(begins)
    assert "Written" not in out
    assert "Written: a.gpkg" in err
    assert "Case C" in err
    if option == "--json":
        assert len(json.loads(out)["trips"]) == 2
    assert sorted(path.name for path in Path().iterdir()) == ["a.gpkg", "corridor.toml"]


def test_a_comparison_goes_to_standard_output(capsys):
    assert run("compare", scenario(), "--cases", "A,C", "-o", "-") == 0
    out, err = capsys.readouterr()
    assert out.lower().startswith("<!doctype html")
    assert "case A" in err


def test_what_does_not_go_to_standard_output(capsys):
    for option in ("--gpkg", "--gpx", "--figures"):
        refused(capsys, ["plan", scenario(), option, "-"], f"{option} -")
    for verb in (["prepare", "italy-motorways"], ["download", "Verona"], ["demo"]):
        refused(capsys, [*verb, "-o", "-"], "-o -")
    refused(capsys, ["plan", scenario(), "--json", "-", "--csv", "-"], "takes one")


def test_a_file_may_be_named_by_a_hyphen(capsys):
    assert run("plan", scenario(), "--json", "./-") == 0
    assert json.loads(Path("-").read_text(encoding="utf-8"))["case"] == "C"


@posix
def test_standard_output_led_into_an_input(inputs):
    with Path("trips.csv").open("a") as trips:
        done = subprocess.run(
            [sys.executable, "-m", "platoon_osm.cli", "plan", "plan.toml", "--csv", "-"],
            stdout=trips, stderr=subprocess.PIPE, text=True, check=False, timeout=60,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
        )  # fmt: skip
    assert done.returncode == 2
    assert "standard output is trips.csv" in done.stderr
    assert Path("trips.csv").read_text() == ROWS


def test_a_failure_at_the_last_output_leaves_none(capsys, monkeypatch):
    Path("a.html").write_text("old")

    def full(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("platoon_osm.report.exports.gis.write_layers", full)
    asked = ["plan", scenario(), "--html", "a.html", "--gpx", "new/deep", "--gpkg", "a.gpkg"]
    refused(capsys, asked, "a.gpkg", "No space left")
    assert Path("a.html").read_text() == "old"
    assert sorted(path.name for path in Path().iterdir()) == ["a.html", "corridor.toml"]


def test_options_that_do_not_apply(capsys):
    for option in ("--nodes", "--edges", "--dropout", "--area-km", "--access-nodes"):
        refused(capsys, ["study", "--network", "italy-motorways", option, "1"], option, "random")
    refused(capsys, ["study", "--network", "italy-motorways", "--directed"], "--directed")
    refused(capsys, ["study", "--network", "italy-motorways", "--spawning", "nodes"], "--spawning")
    refused(capsys, ["study", "--country", "IT"], "--country", "--network")
    refused(capsys, ["study", "--infer-links"], "--infer-links", "--network")
    refused(capsys, ["maps", "--country", "IT"], "--country", "name one beside it")
    refused(capsys, ["download", "Verona", "-o", "a.graphml", "--country", "IT"], "--country")
