"""Wrong input of every kind: one line, status 2, nothing written."""

import re
from pathlib import Path

import pytest
from command_line import command, refused, scenario


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["fly"], "invalid choice"),
        ([], "required"),
        (["plan"], "SCENARIO is required, or --trips with --network"),
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


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["demo", "here"], "unexpected extra argument"),
        (["demo", "-o"], "demo: option '-o' requires an argument; see platoon-osm demo --help"),
        (["demo", "--outptu", "x"], "did you mean --output?"),
        (["demo", "-o", "a.file"], "a.file: is a file"),
        (["maps", "a.folder"], "a.folder: is a folder"),
        (["maps", "--infer"], "did you mean --infer-links"),
        (["maps", "a", "b"], "unexpected extra argument"),
        (["prepare"], "'SOURCE' is required; see platoon-osm prepare --help"),
        (["prepare", "gone.osm", "-o", "a.platoon"], "gone.osm: no such file"),
        (["prepare", "a.folder", "-o", "a.platoon"], "a.folder: is a folder"),
        (["prepare", "italy-motorways", "-o", "a.folder"], "a.folder: is a folder"),
        (["prepare", "italy-motorways", "-o", "a.platoon", "--classes", ""], "--classes: empty"),
        (["prepare", "italy-motorways", "-o", "a.platoon", "--limit", "9"], "--limiter"),
        (["download", "-o", "a.graphml"], "'PLACE' is required"),
        (["download", "Verona"], "'--output' is required"),
        (["download", "nan,1,2,3", "-o", "a.graphml"], "bounding box 'nan,1,2,3'"),
        (["download", "Verona", "-o", "a.txt"], "a.txt"),
        (["download", "Verona", "-o", "a.folder"], "a.folder: is a folder"),
        (["download", "Verona", "-o", "a.graphml", "--limiter", "fast"], "'fast' is not a valid"),
        (["download", "Verona", "-o", "a.graphml", "--classes", ","], "--classes: empty"),
        (["download", "Verona", "-o", "a.graphml", "--cache", "a.file"], "a.file' is a file"),
        (["plan", "gone.toml"], "gone.toml: cannot be read"),
        (["plan", "a.folder"], "a.folder: cannot be read"),
        (["plan", "gone.toml", "--hmtl", "a.html"], "did you mean --help or --html or"),
        (["plan", "gone.toml", "--html"], "'--html' requires an argument"),
        (["plan", "gone.toml", "--gpx", "a.file"], "a.file: is a file"),
        (["plan", "one.toml", "two.toml"], "unexpected extra argument"),
        (["compare", "-o", "c.html"], "'SCENARIO...' is required"),
        (["compare", "gone.toml"], "'--output' is required"),
        (["compare", "gone.toml", "-o", "c.html"], "gone.toml: cannot be read"),
        (["compare", "a.folder", "-o", "c.html"], "a.folder: cannot be read"),
        (["compare", "gone.toml", "-o", "a.folder"], "a.folder: is a folder"),
        (["compare", "gone.toml", "-o", "a.file/c.html"], "a.file is no folder"),
        (["study", "--runs", "many"], "'many' is not a valid integer"),
        (["study", "--dropout", "some"], "'some' is not a valid float"),
        (["study", "--pruning", "tall"], "'tall' is not one of 'shortest', 'random'"),
        (["study", "--rnus", "3"], "--runs"),
        (["study", "--method", ","], "methods"),
        (["study", "--diameter-km", ","], "give at least one of each"),
        (["study", "--network", "a.folder"], "a.folder: is a folder"),
        (["study", "--network", "gone.osm"], "gone.osm: no such file"),
        (["warmup", "gone.platoon"], "gone.platoon"),
        (["warmup", "a.folder"], "a.folder"),
        (["warmup", "a.file"], "a.file: not an OSM file by its name"),
        (["warmup", "--fast"], "unrecognized option --fast"),
        (["paln"], "did you mean 'plan'? use one of demo, maps"),
        (["--colour"], "unrecognized option --colour; see platoon-osm --help"),
        ([""], "VERB: invalid choice ''"),
    ],
)
def test_wrong_input_of_each_verb(capsys, arguments, said):
    Path("a.folder").mkdir()
    Path("a.file").write_text("mine")
    refused(capsys, arguments, said)


def test_cases_that_are_an_empty_list(capsys):
    refused(capsys, ["compare", scenario(), "-o", "c.html", "--cases", ","], "--cases: empty")


def test_a_command_without_a_verb():
    done = command()
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "--help" in done.stderr


def test_as_a_command_that_fails():
    Path("page.osm").write_text("<html></html>")
    done = command("prepare", "page.osm", "-o", "a.platoon")
    assert (done.returncode, done.stdout) == (2, "")
    assert re.fullmatch(r"platoon-osm: page\.osm: not a readable OSM file .*\n", done.stderr)
    assert not Path("a.platoon").exists()
