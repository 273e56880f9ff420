"""`plan --trips` beside a scenario and without one, options, and the verb `scenario`."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import refused, run, scenario
from trip_files import write_gpkg, write_xlsx

import platoon_osm as po

TABLE = "vehicle,origin,destination\nA,Torino,Trieste\nB,Genova,Belluno\n"
WITHOUT = ("plan", "--network", "italy-motorways", "--trips")


def planned(*arguments):
    """Run and return the plan that is written."""
    assert run(*arguments, "--json", "made.json") == 0
    return json.loads(Path("made.json").read_text(encoding="utf-8"))


def put(text, name="trips.csv"):
    Path(name).write_text(text, encoding="utf-8")
    return name


def test_a_table_with_a_network_needs_no_scenario(capsys):
    plan = planned(*WITHOUT, put(TABLE), "--case", "C")
    assert [trip["vehicle"] for trip in plan["trips"]] == ["A", "B"]
    net = po.load_network("italy-motorways")
    again = po.plan_joint(net, po.paper_weights(net), po.read_trips("trips.csv"), "C")
    assert again.to_dict() == plan


@pytest.mark.parametrize("kind", ["csv", "xlsx", "gpkg"])
def test_every_kind_of_table_gives_the_same_plan(capsys, kind):
    rows = [
        {"vehicle": "A", "origin": "Torino", "destination": "Trieste"},
        {"vehicle": "B", "origin": "Genova", "destination": "Belluno"},
    ]
    Path("trips.csv").write_text(TABLE, encoding="utf-8")
    write_xlsx("trips.xlsx", rows)
    write_gpkg("trips.gpkg", rows)
    expected = planned(*WITHOUT, "trips.csv", "--case", "C")
    assert planned(*WITHOUT, f"trips.{kind}", "--case", "C") == expected


def test_the_vehicle_and_closed_roads_are_options(capsys):
    plan = planned(*WITHOUT, put(TABLE), "--case", "C", "--profile", "van-3.5t")
    assert {trip["profile"]["name"] for trip in plan["trips"]} == {"van-3.5t"}
    plan = planned(*WITHOUT, put(TABLE), "--case", "C", "--close", "A 21", "--close", "A 7")
    assert len(plan["closed"]) == 2
    refused(capsys, [*WITHOUT, "trips.csv", "--profile", "sedan"], "sedan")


def test_a_table_beside_a_scenario_replaces_its_trips(capsys):
    put("vehicle,origin,destination\nX,Genova,Trieste\n")
    plan = planned("plan", scenario(), "--trips", "trips.csv")
    assert [trip["vehicle"] for trip in plan["trips"]] == ["X"]
    assert plan["asked"] == "C"  # of the scenario


def test_a_sheet_by_name(capsys):
    write_xlsx("t.xlsx", [{"vehicle": "A", "origin": "Torino", "destination": "Monza"}], "Monday")
    assert planned(*WITHOUT, "t.xlsx", "--sheet", "Monday")["trips"][0]["vehicle"] == "A"
    refused(
        capsys, [*WITHOUT, "t.xlsx", "--sheet", "Friday"], "no sheet 'Friday'; sheets are Monday"
    )
    refused(capsys, ["plan", scenario(), "--sheet", "Monday"], "--sheet names a sheet of --trips")


def test_options_come_before_the_scenario(capsys):
    asked = scenario(
        'network = "{network}"\ncase = "C"\nmaster = "A"\n[costs]\ntau = 1.0\nxi = 0.2\n'
        '[[trips]]\nvehicle = "A"\norigin = "Torino"\ndestination = "Trieste"\n'
        '[[trips]]\nvehicle = "B"\norigin = "Genova"\ndestination = "Belluno"\n'
    )
    plan = planned(
        "plan", asked, "--case", "A", "--master", "B", "--objective", "system", "--method",
        "dijkstra", "--cost", "tau=0.5", "--cost", "mixing=gain",
    )  # fmt: skip
    assert (plan["asked"], plan["objective"], plan["method"]) == ("A", "system", "dijkstra")
    assert plan["params"]["tau"] == 0.5
    assert plan["params"]["mixing"] == "gain"
    assert plan["params"]["xi"] == 0.2  # of the scenario
    assert plan["platoons"] == [] or plan["platoons"][0]["master"] == 1


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["plan"], "SCENARIO is required, or --trips with --network"),
        (["plan", "--network", "italy-motorways"], "SCENARIO is required, or --trips"),
        (["plan", "--trips", "trips.csv"], "which network? add --network italy-motorways"),
        (["plan", "trips.csv"], "is a table of trips, not a scenario; give it as --trips"),
        ([*WITHOUT, "gone.csv"], "gone.csv: cannot be read"),
        ([*WITHOUT, "."], "it is a folder"),
        ([*WITHOUT, "trips.csv", "--case", "E"], "trips.csv: case 'E' is unknown"),
        ([*WITHOUT, "trips.csv", "--method", "x"], "method 'x' is unknown; use dijkstra, astar"),
        ([*WITHOUT, "trips.csv", "--optimum", "x"], "optimum 'x' is unknown"),
        (
            [*WITHOUT, "trips.csv", "--preset", "x"],
            "objective 'x' is unknown; use one of eu",
        ),
        ([*WITHOUT, "trips.csv", "--cost", "tua=1"], "costs has no key 'tua'; did you mean 'tau'?"),
        ([*WITHOUT, "trips.csv", "--cost", "tau"], "write a name and a value, as tau=0.5"),
        ([*WITHOUT, "trips.csv", "--cost", "tau="], "write a name and a value, as tau=0.5"),
        ([*WITHOUT, "trips.csv", "--cost", "tau=x"], "tau = 'x' must be a number in [0, 1]"),
        ([*WITHOUT, "trips.csv", "--cost", "tau=1", "--cost", "tau=0"], "tau is given twice"),
        ([*WITHOUT, "trips.csv", "--country", "xx"], "country 'xx' has no truck limit here"),
        ([*WITHOUT, "trips.csv", "--limiter-kmh", "fast"], "--limiter-kmh"),
        ([*WITHOUT, "trips.csv", "--classes", ","], "--classes: empty"),
        (["plan", "--network", "gone.osm", "--trips", "trips.csv"], "gone.osm: no such file"),
        (["scenario"], "--example or --check FILE is required"),
        (["scenario", "--example", "--check", "trips.csv"], "is required, one of them"),
        (["scenario", "--check", "gone.toml"], "gone.toml: cannot be read"),
        (["scenario", "here"], "unexpected extra argument"),
    ],
)
def test_what_is_refused(capsys, arguments, said):
    put(TABLE)
    refused(capsys, arguments, said)


def test_the_example_runs_as_it_is_printed(capsys):
    """Printed on any system, through any shell: PowerShell writes UTF-16 with a mark."""
    assert run("scenario", "--example") == 0
    text = capsys.readouterr().out
    assert text.count("#") > 15
    for encoding in ("utf-8", "utf-16"):
        Path("e.toml").write_bytes(text.replace("\n", "\r\n").encode(encoding))
        assert run("scenario", "--check", "e.toml") == 0
        assert "e.toml: 3 trips on italy-motorways, case best" in capsys.readouterr().out
        plan = planned("plan", "e.toml")
        assert [trip["vehicle"] for trip in plan["trips"]] == ["A", "B", "C"]
        assert plan["timetable"]["feasible"] is True


def test_what_the_example_has_commented_out_is_right_too(capsys):
    run("scenario", "--example")
    text = capsys.readouterr().out
    for line in ('# master = "A"', '# classes = ["motorway", "motorway_link"]'):
        assert line in text
        text = text.replace(line, line[2:])
    Path("e.toml").write_text(text, encoding="utf-8")
    assert run("scenario", "--check", "e.toml") == 0


def test_checking_says_what_a_file_holds(capsys):
    assert run("scenario", "--check", put(TABLE), "--check", scenario()) == 0
    assert capsys.readouterr().out == (
        "trips.csv: 2 trips\ncorridor.toml: 2 trips on italy-motorways, case C\n"
    )


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('case = "C"', 'case = "E"', "case 'E' is unknown"),
        ('case = "C"', 'master = "Z"', "master 'Z' has no trip"),
        ('vehicle = "B"', 'vehicle = "A"', "vehicle 'A' has 2 trips"),
        ('"italy-motorways"', '"gone.osm"', "'gone.osm' is no file and no bundled map"),
        ('case = "C"', '[costs]\ntau = 3', "tau = 3 must be a number"),
    ],
)  # fmt: skip
def test_checking_finds_what_needs_no_network(capsys, old, new, said):
    from command_line import CORRIDOR

    text = CORRIDOR.format(network="italy-motorways")
    changed = text.replace(old, "") + new if "costs" in new else text.replace(old, new)
    Path("s.toml").write_text(changed, encoding="utf-8")
    refused(capsys, ["scenario", "--check", "s.toml"], "s.toml: ", said)


def test_checking_loads_no_engine():
    code = (
        "import sys; from platoon_osm.cli import main\n"
        "status = main(['scenario', '--example'])\n"
        "print(status, [m for m in ('numba', 'geopandas', 'osmium') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout.splitlines()[-1] == "0 []"
