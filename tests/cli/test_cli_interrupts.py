"""Interrupts at random moments: one line, no half file; and equal runs give equal bytes."""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import CORRIDOR, scenario
from places import ROOT
from soak import chosen, soaked

import platoon_osm as po

posix = pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")

ALL = ("--html", "a.html", "--json", "a.json", "--csv", "a.csv", "--gpkg", "a.gpkg",
       "--flows", "f.html", "--gpx", "new/tracks", "--figures", "new/figures")  # fmt: skip


def start(*arguments, **environment):
    return subprocess.Popen(
        [sys.executable, "-m", "platoon_osm.cli", *arguments], stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)} | environment,
    )  # fmt: skip


def files():
    return {str(p): p.read_bytes() for p in Path().rglob("*") if p.is_file()}


@posix
@soaked
def test_a_plan_interrupted_at_any_moment(forks):
    po.load_network("italy-motorways").save("map.platoon")
    Path("plan.toml").write_text(CORRIDOR.format(network="map.platoon"), encoding="utf-8")
    Path("a.html").write_text("old")
    before = files()
    draw = random.Random(7)
    for number in range(chosen(3, 40)):
        # What imports at its start is interrupted there too, and the others while they work.
        begin, seconds = (start, (0.8, 3.0)) if number % 4 == 0 else (forks.start, (0.05, 5.0))
        process = begin("plan", "plan.toml", *ALL)
        try:
            _, said = process.communicate(timeout=draw.uniform(*seconds))
        except subprocess.TimeoutExpired:
            process.send_signal(draw.choice([signal.SIGINT, signal.SIGTERM, signal.SIGHUP]))
            _, said = process.communicate(timeout=60)
        assert not list(Path().rglob(".draft-*")), number
        if process.returncode == 0 or files() != before:
            # It came after all was moved into place; then everything is there.
            assert len(files()) == len(before) + 4 + 2 + 9, (number, said)
            for name in set(files()) - set(before):
                Path(name).unlink()
            Path("a.html").write_text("old")
            Path("new/tracks").rmdir()
            Path("new/figures").rmdir()
            Path("new").rmdir()
        else:
            assert not Path("new").exists(), number
        if process.returncode == 2:
            assert said == "platoon-osm: interrupted; nothing was left half written\n"


@posix
def test_an_interrupted_study_says_what_is_kept(tmp_path):
    asked = ("study", "--runs", "400", "--vehicles", "4", "--grid", "3", "--diameter-km", "1",
             "--spawning", "points", "--nodes", "60", "--edges", "300", "-o", "out/study",
             "--workers")  # fmt: skip
    for workers in ("1", "2"):
        process = start(*asked, workers)
        kept = Path("out/study/runs")
        while process.poll() is None and len(list(kept.glob("*/run-*.npz"))) < 6:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
        assert process.returncode == 2, said
        count = len(list(kept.glob("*/run-*.npz")))
        assert 6 <= count < 400
        assert said == (
            f"platoon-osm: interrupted; {count} of 400 runs are kept in out/study/runs, and the "
            "same command goes on from there\n"
        )
        assert not list(Path().rglob(".draft-*"))
        for file in kept.rglob("*.npz"):
            file.unlink()


def test_equal_runs_give_equal_bytes():
    made = []
    for seed in ("0", "77"):
        asked = [word.replace("new/", f"{seed}/") for word in ALL]
        names = [f"{seed}-{word}" if word.startswith(("a.", "f.")) else word for word in asked]
        process = start("plan", scenario(), *names, PYTHONHASHSEED=seed)
        out, said = process.communicate(timeout=120)
        assert process.returncode == 0, said
        found = {
            name.removeprefix(seed)[1:]: content
            for name, content in files().items()
            if name.startswith((f"{seed}-", f"{seed}/"))
        }
        summary = [line for line in out.splitlines() if not line.startswith("Written")]
        made.append((found, summary))
    assert len(made[0][0]) == 5 + 2 + 9
    for found, summary in made[1:]:
        assert found.keys() == made[0][0].keys()
        assert [name for name in found if found[name] != made[0][0][name]] == []
        assert summary == made[0][1]


def test_a_geopackage_tells_the_moment_that_is_asked_for(monkeypatch):
    import sqlite3
    from contextlib import closing

    process = start("plan", scenario(), "--gpkg", "a.gpkg", SOURCE_DATE_EPOCH="1700000000")
    process.communicate(timeout=60)
    with closing(sqlite3.connect("a.gpkg")) as file:
        moments = {row[0] for row in file.execute("SELECT last_change FROM gpkg_contents")}
    assert moments == {"2023-11-14T22:13:20.000Z"}
