"""The command as tests type it: what they run, the files they give, and how a refusal looks."""

import os
import subprocess
import sys
from pathlib import Path

from places import ROOT

from platoon_osm.cli import main

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


OUTPUTS = ("--html", "a.html", "--gpkg", "a.gpkg", "--json", "a.json")


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


def refused(capsys, arguments, *said, status=2):
    """The command must fail with a status, one line, nothing printed and nothing written."""
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    capsys.readouterr()
    found = run(*arguments)
    out, err = capsys.readouterr()
    assert found == status
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


def command(*arguments, path=None):
    """Run in a process of its own, with the packages of a folder installed."""
    places = [str(ROOT), *([str(path)] if path else [])]
    return subprocess.run(
        [sys.executable, "-m", "platoon_osm.cli", *arguments], capture_output=True, text=True,
        timeout=120, check=False,
        env={"PYTHONPATH": os.pathsep.join(places), "PATH": "", "PYTHONWARNINGS": "error"},
    )  # fmt: skip
