"""Drivers and driving rules in scenarios and tables: units, columns, and each mistake in a line."""

import pytest

import platoon_osm as po
from platoon_osm.driving.rules import RULES, Rules
from platoon_osm.driving.state import RESTED, STATE_KEYS, DriverState
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.scenario import read_scenario
from platoon_osm.planning.scenario.checking import checked
from platoon_osm.planning.scenario.driver_cells import DRIVER_COLUMNS

TEXT = """
network = "italy-motorways"
rules = "eu561"
task_relief = 0.5

[[trips]]
vehicle = "A"
origin = "Torino"
destination = "Trieste"
earliest_departure = 2026-03-02T06:00:00
driver = {driven_today_h = 2, driven_since_break_min = 90}

[[trips]]
vehicle = "B"
origin = "Genova"
destination = "Belluno"

[trips.driver]
drivers = 2
driven_this_week_h = 31.5
"""
HEADER = "vehicle;origin;destination;drivers;Driver Driven Today h;driver_first_part_taken\n"


def read(folder, text=TEXT):
    file = folder / "s.toml"
    file.write_text(text, encoding="utf-8")
    return read_scenario(file)


def table(folder, text):
    file = folder / "t.csv"
    file.write_text(text, encoding="utf-8")
    return po.read_trips(file)


def test_rules_and_drivers_of_a_scenario(tmp_path):
    scenario = read(tmp_path)
    assert scenario.options == {"rules": "eu561", "task_relief": 0.5}
    first, second = (trip.driver for trip in scenario.trips)
    assert first == DriverState(driven_since_break_s=5400, driven_today_s=7200, duty_s=7200)
    assert second == DriverState(driven_this_week_s=31.5 * 3600, drivers=2)
    scenario.check()
    assert checked(scenario.file).endswith("2 trips on italy-motorways, case best, rules eu561")


def test_rules_that_a_package_adds_are_known_to_scenarios(tmp_path):
    RULES.add(Rules("our-own", "four hours a day"))
    try:
        read(tmp_path, TEXT.replace("eu561", "our-own")).check()
    finally:
        RULES.remove("our-own")


@pytest.mark.parametrize("key", [key for key in STATE_KEYS if key.rpartition("_")[2] in "hmins"])
def test_every_time_is_told_in_any_of_three_units(tmp_path, key):
    stem, _, unit = key.rpartition("_")
    seconds = {"h": 3600, "min": 60, "s": 1}[unit]
    more = "driven_today_h = 24, " if stem == "driven_since_break" else ""
    text = TEXT.replace("driven_today_h = 2, driven_since_break_min = 90", f"{more}{key} = 24")
    assert getattr(read(tmp_path, text).trips[0].driver, f"{stem}_s") == 24 * seconds
    (trip,) = table(
        tmp_path,
        f"vehicle,origin,destination,driver_driven_today_h,driver_{key}\nA,x,y,24,24\n"
        if more
        else f"vehicle,origin,destination,driver_{key}\nA,x,y,24\n",
    )
    assert getattr(trip.driver, f"{stem}_s") == 24 * seconds


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('rules = "eu561"', 'rules = "eu651"', "driving rules 'eu651' is unknown; did you mean"),
        ('rules = "eu561"', "rules = 561", "rules = 561 must be a text in quotes"),
        ('rules = "eu561"', 'rule = "eu561"', "no key 'rule'; did you mean 'rules'?"),
        ('rules = "eu561"', 'rules = "us395"', "rules 'us395' are not planned for two drivers"),
        ("earliest_departure", "# ", "driving rules 'eu561' need a clock; give at least one trip"),
        ("task_relief = 0.5", 'method = "astar"', "rules 'eu561' are beyond the paper's A*; use"),
        ("task_relief = 0.5", "task_relief = 2", "task_relief is 2; give a number from 0 to 1"),
        ("task_relief = 0.5", 'task_relief = "all"', "task_relief is 'all'"),
        ("task_relief = 0.5", "task_relief = nan", "task_relief is nan"),
        ("task_relief", "taskrelief", "no key 'taskrelief'; did you mean 'task_relief'?"),
        ("driver = {", "drivers = {", "trip 1 has no key 'drivers'; did you mean 'driver'?"),
        ("driven_today_h", "driven_todays_h", "did you mean 'driven_today_h'?"),
        ("driven_today_h", "zzz", "trip 'A': driver has no 'zzz'; known are driven_since_break_h"),
        ("today_h = 2", "today_h = 25", "driver driven_today_h is 25; give a number from 0 to 24"),
        ("today_h = 2", "today_h = nan", "driver driven_today_h is nan"),
        ("today_h = 2", "today_h = true", "driver driven_today_h is True"),
        ("min = 90", "min = 1441", "driven_since_break_min is 1441; give a number from 0 to 1440"),
        ("min = 90", "min = 130", "driven_since_break_s is more than driven_today_s"),
        ("min = 90", "min = 90, driven_today_s = 1", "names driven_today_s twice"),
        ("min = 90", 'min = 90, first_part_taken = "yes"', "first_part_taken is 'yes'; give true"),
        ("drivers = 2", "drivers = 3", "trip 'B': driver: drivers is 3; give a whole number from"),
        ("drivers = 2", "drivers = 1.5", "drivers is 1.5"),
        ("drivers = 2", "long_days_used = -1", "long_days_used is -1"),
        ("drivers = 2", "reduced_rests_used = 8", "reduced_rests_used is 8"),
        ("drivers = 2", "since_weekly_rest_h = 337", "since_weekly_rest_h is 337"),
        ("h = 31.5", 'h = "31:30"', "driven_this_week_h is '31:30'"),
    ],
)
def test_each_mistake_in_one_line_with_the_file(tmp_path, old, new, said):
    assert old in TEXT
    with pytest.raises(ScenarioError) as caught:
        read(tmp_path, TEXT.replace(old, new)).check()
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
    assert str(caught.value).startswith(f"{tmp_path / 's.toml'}: ")


def test_drivers_in_a_table(tmp_path):
    a, b, c, d = table(tmp_path, HEADER + "A;x;y;2;;\nB;x;y;;2,5;Yes\nC;x;y;;;0\nD;x;y;;;\n")
    assert a.driver == DriverState(drivers=2)
    assert b.driver == DriverState(driven_today_s=9000, first_part_taken=True)
    assert c.driver == RESTED
    assert d.driver is RESTED


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("A;x;y;3;;", "line 2: trip 'A': driver: drivers is 3"),
        ("A;x;y;two;;", "line 2: drivers = 'two' must be a whole number"),
        ("A;x;y;;2:30;", "line 2: driver_driven_today_h = '2:30' must be a number of hours"),
        ("A;x;y;;25;", "line 2: trip 'A': driver driven_today_h is 25.0; give a number from 0"),
        ("A;x;y;;;maybe", "line 2: driver_first_part_taken = 'maybe' must be true or false"),
    ],
)
def test_mistakes_of_a_table_name_the_line(tmp_path, row, said):
    with pytest.raises(ScenarioError) as caught:
        table(tmp_path, f"{HEADER}{row}\n")
    assert said in str(caught.value)
    assert str(caught.value).startswith("t.csv ")
    assert "\n" not in str(caught.value)


def test_a_column_without_its_first_word_is_named(tmp_path):
    with pytest.raises(ScenarioError, match="did you mean 'driver_driven_today_h'"):
        table(tmp_path, "vehicle,origin,destination,driven_today_h\nA,x,y,2\n")
    assert set(DRIVER_COLUMNS) == {
        key if key == "drivers" else f"driver_{key}" for key in STATE_KEYS
    }
