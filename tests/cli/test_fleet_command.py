"""`platoon-osm fleet` from a table to a folder; interrupted and killed while it searches."""

import csv
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import refused, run
from places import ROOT
from soak import chosen, soaked

import platoon_osm as po
from platoon_osm.fleets.day.trip_file import write_trips
from platoon_osm.plans.plan import Plan

posix = pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")

TABLES = {"assignment.csv", "platoons.csv", "vehicles.csv", "unserved.csv", "fleet.html"}
HEADER = "vehicle,origin,destination,earliest_departure,flexibility_min,carrier\n"
ROADS = (("Torino", "Trieste"), ("Milano", "Trieste"), ("Genova", "Trieste"), ("Milano", "Padova"))


def table(name="trips.csv", more=""):
    """Write twelve trips eastward, all within an hour, and whatever else is given."""
    rows = [
        f"t{k},{origin},{destination},2026-03-02 06:{5 * k:02d},45,{'North' if k < 6 else ''}\n"
        for k, (origin, destination) in enumerate(ROADS * 3)
    ]
    Path(name).write_text(HEADER + "".join(rows) + more, encoding="utf-8")
    return name


def rows(name):
    with Path("out", name).open(encoding="utf-8", newline="") as handle:
        return list(csv.DictReader(handle))


def made():
    whole = json.loads(Path("out/fleet.json").read_text(encoding="utf-8"))
    assert whole["format"] == "platoon-osm fleet"
    return Plan.from_dict(whole["plan"])


def test_a_table_becomes_a_folder(capsys):
    bad = (
        "x,Nowhere at all,Roma,2026-03-02 06:00,30,\ny,Torino,Milano,soon,30,\nz,Torino,Milano,,,\n"
    )
    Path("apart.csv").write_text("vehicle,apart_from\nt0,t2\ny,t2\n")
    Path("together.csv").write_text("t1,t3,y\n")
    given = ("fleet", table(more=bad), "--network", "italy-motorways", "--rounds", "2", "--seed",
             "1", "--max-platoon", "3", "--apart", "apart.csv", "--together", "together.csv",
             "-o", "out")  # fmt: skip
    assert run(*given) == 0
    out, err = capsys.readouterr()
    assert "12 trips" in out
    assert "Gap: " in out
    assert "3 trips could not be planned; out/unserved.csv tells why" in err
    assert {path.name for path in Path("out").iterdir()} >= {*TABLES, "fleet.json", "sheets"}
    assert {row["vehicle"] for row in rows("unserved.csv")} == {"x", "y", "z"}
    plan = made()
    assert {one.vehicle for one in plan.fleet.unserved} == {"x", "y", "z"}
    assert plan.fleet.saving > 0
    assert len(list(Path("out/sheets").glob("*.html"))) == 12
    companies = [{plan.trips[k].vehicle for k in one.vehicles} for one in plan.stretches]
    assert any(company >= {"t1", "t3"} for company in companies)
    north = {f"t{k}" for k in range(6)}
    for company in companies:
        assert len(company) <= 3
        assert not company >= {"t0", "t2"}  # who would be together else
        assert company <= north or not company & north
    assert {row["vehicle"] for row in rows("assignment.csv") if row["with"]} == {
        name for company in companies if len(company) > 1 for name in company
    }
    first = {path.name: path.read_bytes() for path in Path("out").glob("*.csv")}
    assert run(*given, "--threads", "1", "--no-sheets") == 0
    assert {path.name: path.read_bytes() for path in Path("out").glob("*.csv")} == first


def test_refused_before_anything_is_loaded(capsys):
    known = ("--network", "italy-motorways", "-o", "out")
    refused(capsys, ["fleet", "none.csv", *known], "none.csv")
    refused(capsys, ["fleet", table(), *known, "--time-limit", "0"], "time_s is 0.0")
    Path("apart.csv").write_text("t0,t99\n")
    refused(capsys, ["fleet", "trips.csv", *known, "--apart", "apart.csv"], "'t99'")
    refused(capsys, ["fleet", "trips.csv", *known, "--together", "apart.csv"], "'t99'")
    Path("bad.csv").write_text(HEADER + "a,Roma,Bari,soon,30,\n")
    refused(capsys, ["fleet", "bad.csv", *known], "no trip can be read; first: bad.csv line 2")
    refused(capsys, ["fleet", "trips.csv", "--network", "trips.csv", "-o", "out"], "trips.csv")


def searching():
    """Start a long search and return its process once it has written a plan."""
    net = po.load_network("italy-motorways")
    write_trips(po.draw_trips(net, 120, seed=5), "trips.csv")
    process = subprocess.Popen(
        [sys.executable, "-m", "platoon_osm.cli", "fleet", "trips.csv", "--network",
         "italy-motorways", "--time-limit", "500", "--threads", "1", "-o", "out"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    while process.poll() is None and not Path("out/fleet.json").exists():
        time.sleep(0.01)
    return process


@posix
@soaked
@pytest.mark.parametrize("name", chosen(["SIGKILL"], ["SIGKILL", "SIGINT"]))
def test_ended_in_the_middle_the_best_plan_so_far_is_there(name):
    process = searching()
    process.send_signal(getattr(signal, name))
    said, _ = process.communicate(timeout=200)
    plan = made()
    assert len(plan.trips) == 120
    assert plan.fleet.saving <= plan.fleet.bound
    if name == "SIGKILL":
        assert process.returncode == -signal.SIGKILL
        return
    # Ctrl-C: the search ends, and all else is written.
    assert process.returncode == 0
    assert "it was interrupted" in said
    assert {path.name for path in Path("out").iterdir()} >= {*TABLES, "fleet.json"}
    assert plan.fleet.ended == "interrupted"
    assert len({row["vehicle"] for row in rows("assignment.csv")}) == 120
