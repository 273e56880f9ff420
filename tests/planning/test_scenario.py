"""Scenario files: what is read, and how each mistake is told."""

from datetime import datetime, timedelta
from pathlib import Path

import pytest
from bundled import italy as italy_map

import platoon_osm as po
from platoon_osm.errors import PlatoonError, ScenarioError
from platoon_osm.planning.scenario import read_scenario
from platoon_osm.plans.trip import Trip
from platoon_osm.sources.catalog import BUNDLED_MAPS

GOOD = """
title = "Two trucks"
network = "italy-motorways"
case = "C"
objective = "system"
master = "A"

[costs]
tau = 0.5
mixing = "gain"

[[trips]]
vehicle = "A"
origin = "Torino"
destination = [13.77, 45.6]

[[trips]]
vehicle = "B"
origin = "Genova"
destination = "Belluno"
"""


def read(folder, text):
    file = folder / "trip.toml"
    file.write_text(text, encoding="utf-8")
    return read_scenario(file)


def test_all_there_is(tmp_path):
    scenario = read(tmp_path, GOOD)
    assert scenario.file == tmp_path / "trip.toml"
    assert scenario.title == "Two trucks"
    assert scenario.network == {"source": "italy-motorways"}
    assert scenario.options == {"case": "C", "optimum": "system", "master": "A"}
    assert scenario.costs == {"tau": 0.5, "mixing": "gain"}
    assert scenario.trips == (
        Trip("A", "Torino", (13.77, 45.6)),
        Trip("B", "Genova", "Belluno"),
    )


LEAST = 'network = "n"\n[[trips]]\nvehicle = "A"\norigin = "x"\ndestination = "y"\n'


def test_the_least_there_must_be(tmp_path):
    scenario = read(tmp_path, LEAST)
    assert scenario.title == "trip"  # the file's own name
    assert (scenario.options, scenario.costs) == ({}, {})


def test_network_as_a_table(tmp_path):
    scenario = read(
        tmp_path, '[network]\nsource = "n"\ninfer_links = true\n' + LEAST.split("\n", 1)[1]
    )
    assert scenario.network == {"source": "n", "infer_links": True}


def test_a_map_beside_the_scenario_is_found(tmp_path):
    (tmp_path / "my.osm").write_text("<osm/>", encoding="utf-8")
    scenario = read(tmp_path, LEAST.replace('"n"', '"my.osm"'))
    assert scenario.network["source"] == str(tmp_path / "my.osm")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("case =", "cases =", "scenario has no key 'cases'; did you mean 'case'?"),
        ("case =", "zzz =", "scenario has no key 'zzz'; known are title, network"),
        ("tau =", "tua =", r"\[costs\] has no key 'tua'; did you mean 'tau'?"),
        ("[costs]", '[costs]\npreset = "money"', "objective .money. is unknown; use one"),
        ("[costs]", "[cost]", "scenario has no key 'cost'; did you mean 'costs'?"),
        ("[costs]\ntau = 0.5\nmixing = \"gain\"", "costs = 3", "costs must be a table"),
        ('network = "italy-motorways"', "", "network is missing; write network = "),
        ('network = "italy-motorways"', "network = 3", "network is missing"),
        ('network = "italy-motorways"', "network = {}", "network is missing"),
        ('network = "italy-motorways"', "network = {source = 3}", "source = 3 must be a text"),
        ('network = "italy-motorways"', 'network = {source = "n", clases = "x"}',
         r"\[network\] has no key 'clases'; did you mean 'classes'?"),
        ('case = "C"', "case = 3", "case = 3 must be a text in quotes"),
        ('case = "C"', 'case = ""', "case = '' must be a text in quotes"),
        ('title = "Two trucks"', "title = 1979-05-27", "title = .* must be a text in quotes"),
        ('objective = "system"', "objective = true", "objective = True must be a text"),
        ('objective = "system"', "optimum = true", "optimum = True must be a text"),
        ('objective = "system"', 'objective = "cheap"', r"same table; give \[objective\] alone"),
        ('objective = "system"', 'objective = "system"\noptimum = "member"', "give optimum alone"),
        ('master = "A"', 'master = ["A"]', r"master = \['A'\] must be a text"),
        ('origin = "Genova"', "", "trip 2 has no origin"),
        ('vehicle = "B"', "", "trip 2 has no vehicle"),
        ('destination = "Belluno"', "", "trip 2 has no destination"),
        ('origin = "Genova"', 'orgin = "x"', "trip 2 has no key 'orgin'; did you mean 'origin'?"),
        ('vehicle = "B"', "vehicle = 2", "trip 2: vehicle = 2 must be a text"),
        ('origin = "Genova"', "origin = 44.4", "trip 2: origin = 44.4 must be a name or a"),
        ('origin = "Genova"', 'origin = ""', "trip 2: origin = '' must be a name or a"),
        ('origin = "Genova"', "origin = [8.9]", r"origin = \[8.9\] must be a name or a"),
        ('origin = "Genova"', 'origin = ["8.9", "44"]', "must be a name or a"),
        ('origin = "Genova"', "origin = [true, false]", "must be a name or a"),
        ("[[trips]]", "[[trip]]", "scenario has no key 'trip'; did you mean 'trips'?"),
        ('title = "Two trucks"', 'title = "Two trucks', "not a TOML file"),
    ],
)  # fmt: skip
def test_each_mistake_in_one_line_with_the_file(tmp_path, old, new, message):
    assert old in GOOD
    with pytest.raises(ScenarioError, match=message) as error:
        read(tmp_path, GOOD.replace(old, new))
    assert str(error.value).startswith(f"{tmp_path / 'trip.toml'}: ")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("trips", ["", "trips = []", "trips = 3"])
def test_no_trips(tmp_path, trips):
    with pytest.raises(ScenarioError, match=r"no trips; add \[\[trips\]\]"):
        read(tmp_path, f'network = "n"\n{trips}\n')


def test_a_trip_that_is_no_table(tmp_path):
    with pytest.raises(ScenarioError, match="trip 1 must be a table with vehicle, origin"):
        read(tmp_path, 'network = "n"\ntrips = ["A"]\n')


def test_no_such_file(tmp_path):
    with pytest.raises(ScenarioError, match=r"none\.toml: cannot be read \(No such file"):
        read_scenario(tmp_path / "none.toml")


def test_a_folder(tmp_path):
    with pytest.raises(ScenarioError, match="cannot be read"):
        read_scenario(tmp_path)


def test_bytes_that_are_no_text(tmp_path):
    (tmp_path / "x.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ScenarioError, match="begins as UTF-16 text and breaks off"):
        read_scenario(tmp_path / "x.toml")


# -- trips from CSV ------------------------------------------------------------------------------


def read_csv(folder, table, encoding="utf-8"):
    (folder / "trips.csv").write_text(table, encoding=encoding)
    return read(folder, 'network = "n"\ntrips = "trips.csv"\n').trips


def test_trips_from_csv_beside_the_scenario(tmp_path):
    table = 'vehicle,origin,destination\n12,7.69 45.07,"Monza"\nB 2,Sesto San Giovanni,9.2 45\n'
    assert read_csv(tmp_path, table) == (
        Trip("12", (7.69, 45.07), "Monza"),
        Trip("B 2", "Sesto San Giovanni", (9.2, 45.0)),
    )


def test_a_vehicle_named_by_two_numbers_is_no_place(tmp_path):
    (trip,) = read_csv(tmp_path, "vehicle,origin,destination\n7 12,Torino,Monza\n")
    assert trip.vehicle == "7 12"


def test_csv_as_spreadsheets_save_it(tmp_path):
    (trip,) = read_csv(tmp_path, "vehicle,origin,destination\r\nA,Torino,Forlì\r\n", "utf-8-sig")
    assert trip == Trip("A", "Torino", "Forlì")


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ("", "has no rows under its header"),
        ("vehicle,origin,destination\n", "has no rows under its header"),
        ("vehicle,origin\nA,Torino\n", "trips.csv line 1: has no column destination"),
        ("vehicle,origin,destnation\nA,x,y\n", "line 1: unknown column 'destnation'; did you mean"),
        ("vehicle,origin,destination\nA,x,y\nB,x\n", "line 3: destination is empty; give a name"),
        ("vehicle,origin,destination\n,x,y\n", "line 2: vehicle is empty; every trip has"),
        (
            "vehicle,origin,destination\nA,x,y,z\n",
            "line 2 has 4 cells, the header 3; a cell that holds",
        ),
    ],
)
def test_csv_mistakes_name_the_line(tmp_path, table, message):
    with pytest.raises(ScenarioError, match=message) as error:
        read_csv(tmp_path, table)
    assert "\n" not in str(error.value)


def test_no_such_csv(tmp_path):
    with pytest.raises(
        ScenarioError, match=r"trip\.toml: none\.csv: cannot be read \(No such file"
    ):
        read(tmp_path, 'network = "n"\ntrips = "none.csv"\n')


# -- times -----------------------------------------------------------------------------------------

TIMED = GOOD.replace('vehicle = "B"\n', 'vehicle = "B"\nlatest_departure = 2026-03-02T06:30:00\n')


def test_times_are_those_of_toml(tmp_path):
    first, second = read(tmp_path, TIMED).trips
    assert first.times == {}
    assert second.times == {"latest_departure": datetime(2026, 3, 2, 6, 30)}
    (zoned,) = [
        one for one in read(tmp_path, TIMED.replace(":00\n", ":00+01:00\n")).trips if one.times
    ]
    assert zoned.times["latest_departure"].utcoffset() == timedelta(hours=1)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("2026-03-02T06:30:00", "06:30:00", "trip 2: latest_departure = 06:30:00 must be a day"),
        ("2026-03-02T06:30:00", "2026-03-02", "latest_departure = 2026-03-02 must be a day and"),
        ("2026-03-02T06:30:00", '"soon"', "latest_departure = soon must be a day and a time"),
        ("2026-03-02T06:30:00", "[]", r"latest_departure = \[\] must be a day and a time"),
        ("2026-03-02T06:30:00", '""', "latest_departure =  must be a day and a time"),
        ("latest_departure", "latest_depature", "did you mean 'latest_departure'?"),
        (
            "latest_departure = ",
            "earliest_departure = 2026-03-02T06:31:00\nlatest_departure = ",
            "trip 'B': latest_departure 2026-03-02T06:30:00 is not after earliest_departure",
        ),
        (
            "latest_departure = ",
            "latest_arrival = 2026-03-02T09:31:00Z\nlatest_departure = ",
            "give all times of a plan with their zone or none",
        ),
    ],
)
def test_wrong_times_in_one_line_with_the_file(tmp_path, old, new, message):
    assert old in TIMED
    with pytest.raises(ScenarioError, match=message) as error:
        read(tmp_path, TIMED.replace(old, new))
    assert str(error.value).startswith(f"{tmp_path / 'trip.toml'}: ")
    assert "\n" not in str(error.value)


def test_times_from_csv(tmp_path):
    table = (
        "vehicle,origin,destination,earliest_departure,latest_arrival\n"
        "A,Torino,Monza,2026-03-02 06:00,\nB,Torino,Monza,,2026-03-02T09:00:00\n"
    )
    first, second = read_csv(tmp_path, table)
    assert first.times == {"earliest_departure": datetime(2026, 3, 2, 6)}
    assert second.times == {"latest_arrival": datetime(2026, 3, 2, 9)}


@pytest.mark.parametrize("text", ["06:00", "2026-03-02", "2 March 2026, 06:00", "2026-02-30T06:00"])
def test_wrong_times_in_csv_name_the_line(tmp_path, text):
    table = f'vehicle,origin,destination,earliest_departure\nA,Torino,Monza,"{text}"\n'
    with pytest.raises(ScenarioError, match=f"line 2: earliest_departure = {text} must be a day"):
        read_csv(tmp_path, table)


# -- planning one --------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def italy():
    return italy_map()


def test_a_scenario_is_planned_with_its_own_options(tmp_path, italy):
    plan = read(tmp_path, GOOD.replace("45]", "45.65]")).plan(italy)
    assert (plan.case, plan.objective) == ("C", "system")
    assert (plan.params["tau"], plan.params["mixing"]) == (0.5, "gain")
    assert plan.vehicles[0].role == "master"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("tau = 0.5", "tau = 2", r"tau = 2 must be a number in \[0, 1\]"),
        ("tau = 0.5", 'tau = "half"', "tau = 'half' must be a number"),
        ('case = "C"', 'case = "F"', "case 'F' is unknown"),
        ('master = "A"', 'master = "Z"', "master 'Z' has no trip"),
        ('"Belluno"', '"Beluno"', "trip 'B', destination: .*did you mean Belluno"),
        ("[13.77, 45.6]", "[45.65, 113.77]", "trip 'A', destination: .*longitude comes first"),
        ("[13.77, 45.6]", "[nan, 45.0]", "trip 'A', destination: "),
        ('vehicle = "B"', 'vehicle = "A"', "vehicle 'A' has 2 trips"),
        ('"Belluno"', '"Genova"', "trip 'B': origin and destination are the same place"),
    ],
)
def test_mistakes_found_when_planning_name_the_file(tmp_path, italy, old, new, message):
    scenario = read(tmp_path, GOOD.replace(old, new))
    with pytest.raises(PlatoonError, match=message) as error:
        scenario.plan(italy)
    assert str(error.value).startswith(f"{tmp_path / 'trip.toml'}: ")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("file", sorted((Path(po.__file__).parent / "scenarios").glob("*.toml")))
def test_bundled_scenarios_are_sound(file):
    scenario = read_scenario(file)
    assert scenario.title
    assert scenario.network["source"] in BUNDLED_MAPS
    assert len(scenario.trips) >= 2
