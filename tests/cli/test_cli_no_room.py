"""A disk that is full: one line, and everything is as it was before."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap
from functools import cache
from pathlib import Path

import pytest
from command_line import CORRIDOR, scenario
from places import ROOT

import platoon_osm as po

OUTPUTS = {
    "html": ["plan", "corridor.toml", "--html", "a.html"],
    "gpkg": ["plan", "corridor.toml", "--gpkg", "a.gpkg"],
    "json": ["plan", "corridor.toml", "--json", "a.json"],
    "csv": ["plan", "corridor.toml", "--csv", "a.csv"],
    "flows": ["plan", "corridor.toml", "--flows", "a.html"],
    "gpx": ["plan", "corridor.toml", "--gpx", "new/tracks"],
    "figures": ["plan", "corridor.toml", "--figures", "new/figures"],
    "all": ["plan", "corridor.toml", "--json", "a.json", "--gpkg", "a.gpkg", "--gpx", "new"],
    "compare": ["compare", "corridor.toml", "--cases", "A,C", "-o", "a.html"],
    "prepare": ["prepare", "map.platoon", "-o", "a.platoon"],
    "demo": ["demo", "-o", "new"],
    "study": ["study", "--runs", "2", "--vehicles", "3", "--grid", "2", "--diameter-km", "1",
              "--spawning", "points", "--nodes", "40", "--edges", "200", "--workers", "1",
              "-o", "new/study"],
}  # fmt: skip

needs_limits = pytest.mark.skipif(os.name == "nt", reason="limits of POSIX")


def environment():
    return {**os.environ, "PYTHONPATH": str(ROOT), "NUMBA_DISABLE_JIT": "0",
            "MPLCONFIGDIR": os.environ.get("MPLCONFIGDIR", "")}  # fmt: skip


def contents(folder):
    found = {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else None
        for path in folder.rglob("*")
    }
    # Runs that a study has finished stay, and the folders that hold them.
    kept = [name for name in found if name.startswith("new/study/runs/") and found[name]]
    for name in kept:
        for place in (name, *map(str, Path(name).parents)):
            found.pop(place, None)
    return found


def checked(done, before, folder):
    """Return whether it went well; if not, one line says why, and nothing has changed."""
    if done.returncode == 0:
        return True
    assert done.returncode == 2, done.stderr
    assert done.stderr.count("\n") == 1, done.stderr
    assert "Traceback" not in done.stderr
    assert re.search("cannot be|No usable temporary directory", done.stderr), done.stderr
    assert ".draft-" not in done.stderr
    assert len(done.stderr) < 500
    after = contents(folder)
    assert after == before, sorted(set(after) ^ set(before))
    return False


@cache
def saved_map():
    with tempfile.TemporaryDirectory() as folder:
        po.load_network("italy-motorways").save(f"{folder}/map.platoon")
        return Path(folder, "map.platoon").read_bytes()


def prepared(network="map.platoon"):
    """Make a map whose reading takes no temporary file, a scenario, and files that are there."""
    Path(network).write_bytes(saved_map())
    Path("corridor.toml").write_text(CORRIDOR.format(network=network), encoding="utf-8")
    Path("a.html").write_text("old")
    Path("a.gpkg").write_bytes(b"old")


@needs_limits
@pytest.mark.parametrize("name", OUTPUTS)
def test_writes_that_fail_leave_nothing(name, tmp_path, forks):
    prepared()
    before = contents(tmp_path)
    went_well = []
    for limit in (0, 9_000):
        # Beyond the limit a write fails, as on a disk that is full, but without being root.
        done = forks.run(*OUTPUTS[name], largest=limit)
        went_well.append(checked(done, before, tmp_path))
        if went_well[-1]:
            break
    assert went_well[0] is False


SILENT = textwrap.dedent("""
    import os, resource, signal, sys
    import platoon_osm as po
    net = po.load_network("italy-motorways")
    trips = [po.Trip("A", "Torino", "Trieste"), po.Trip("B", "Genova", "Belluno")]
    plan = po.plan_joint(net, po.paper_weights(net), trips)
    po.write_geopackage(plan, net, "whole.gpkg")
    whole = open("whole.gpkg", "rb").read()
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    most = resource.getrlimit(resource.RLIMIT_FSIZE)[1]
    for part in range(0, 33):
        # The last quarter is where GDAL says nothing.
        limit = len(whole) * (3 * 32 + part) // (4 * 32) if part else 0
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, most))
        try:
            po.write_geopackage(plan, net, "a.gpkg")
            refused = ""
        except po.ScenarioError as error:
            refused = str(error)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
        assert len(refused) < 400 and "\\n" not in refused, refused
        assert bool(refused) == (limit < len(whole)), (limit, refused)
        assert sorted(os.listdir()) == ["a.gpkg"] * (not refused) + ["whole.gpkg"], limit
    assert open("a.gpkg", "rb").read() == whole
""")


@needs_limits
def test_no_geopackage_lacks_a_part_in_silence():
    done = subprocess.run(
        [sys.executable, "-c", SILENT], check=False, text=True, capture_output=True,
        env=environment(), timeout=200,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 600 kB, which fills up."""
    place = tmp_path / "disk"
    place.mkdir()
    mount = shutil.which("mount")
    command = [mount or "mount", "-t", "tmpfs", "-o", "size=600k", "tmpfs", str(place)]
    done = subprocess.run(command, capture_output=True, check=False) if mount else None
    if done is None or done.returncode != 0:
        pytest.skip("a small file system cannot be mounted here, which takes root")
    yield place
    subprocess.run(["umount", str(place)], check=True)


@pytest.mark.parametrize("name", ["gpkg", "all", "figures", "demo"])
def test_a_small_disk_that_is_full(name, small_disk, tmp_path, forks):
    os.chdir(small_disk)
    try:
        prepared(tmp_path / "map.platoon")
        # The demo plans for seconds before it writes anything.
        for filled in (300_000,) if name == "demo" else (0, 300_000, 560_000):
            Path("filler").write_bytes(b"x" * filled)
            before = contents(small_disk)
            done = forks.run(*OUTPUTS[name])
            if name != "figures":  # which fit, at first
                assert done.returncode == 2
            if checked(done, before, small_disk):
                shutil.rmtree("new")
    finally:
        os.chdir("/")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
@pytest.mark.parametrize("more", [(), ("--json", "-"), ("--html", "-", "--gpkg", "b.gpkg")])
def test_standard_output_that_takes_nothing(more):
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "platoon_osm.cli", "plan", scenario(), *more], stdout=full,
            stderr=subprocess.PIPE, text=True, check=False, env=environment(), timeout=60,
        )  # fmt: skip
    assert done.returncode == 2
    assert "No space left" in done.stderr
    assert "Traceback" not in done.stderr
    assert "Exception ignored" not in done.stderr
