"""Wrong input of every kind: one line, status 2, nothing written."""

import re
from pathlib import Path

import pytest
from command_line import command, refused


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
