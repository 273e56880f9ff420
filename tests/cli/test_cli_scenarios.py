"""Scenarios and trip tables that `plan` refuses."""

from pathlib import Path

import pytest
from command_line import CORRIDOR, OUTPUTS, refused, scenario, trips_between, two_roads


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('case = "C"', 'caes = "C"', "no key 'caes'; did you mean 'case'?"),
        ("[[trips]]", "[[trip]]", "did you mean 'trips'?"),
        ('origin = "Genova"', 'orign = "Genova"', "did you mean 'origin'?"),
        ('case = "C"', "[costs]\nfuel_savings = 0.1", "did you mean 'fuel_saving'?"),
        ('network = "italy-motorways"', '[network]\nsorce = "x"', "network is missing"),
        ('network = "italy-motorways"', "", "network is missing"),
        ('case = "C"', 'case = "E"', "case 'E' is unknown; use A, B, C, D, best"),
        ('case = "C"', "case = 3", "must be a text in quotes"),
        ('case = "C"', 'objective = "both"', "objective 'both' is unknown; use member, system"),
        ('case = "C"', 'method = "magic"', "method 'magic' is unknown; use dijkstra, astar"),
        ('case = "C"', 'master = "Z"', "master 'Z' has no trip; vehicles are A, B"),
        ('case = "C"', "[costs]\ntau = -0.5", "tau = -0.5 must be a number in [0, 1]"),
        ('case = "C"', "[costs]\nspeed_kmh = -80", "speed_kmh = -80 must be a number"),
        ('case = "C"', "[costs]\nfuel_saving = nan", "fuel_saving = nan must be a number"),
        ('"Belluno"', '"Genova"', "same place"),
        ('"Belluno"', '"Bellumo"', "did you mean Belluno"),
        ('"Belluno"', '"ovest"', "ambiguous"),
        ('"Belluno"', "[13.7, 145.6]", "latitude within [-90, 90]"),
        ('"Belluno"', "[nan, 45.6]", "longitude comes first"),
        ('"Belluno"', "[13.7]", "must be a name or a [lon, lat] pair"),
        ('vehicle = "B"', 'vehicle = "A"', "vehicle 'A' has 2 trips"),
        ('vehicle = "B"', 'vehicle = ""', "vehicle"),
        ('vehicle = "B"\n', "", "has no vehicle"),
        ("title =", "title", "not a TOML file"),
    ],
)
def test_bad_scenarios(capsys, old, new, said):
    text = CORRIDOR.format(network="italy-motorways")
    assert old in text
    # A table must not swallow the keys after it, so it goes to the end.
    changed = (
        text.replace(old, "") + new if new.startswith("[costs]") else text.replace(old, new, 1)
    )
    Path("bad.toml").write_text(changed)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "bad.toml", said)


@pytest.mark.parametrize("value", ["-5", '"fast"', "nan", "true"])
def test_a_limiter_that_is_no_speed(capsys, value):
    text = CORRIDOR.replace('network = "{network}"', "") + (
        f'[network]\nsource = "italy-motorways"\nlimiter_kmh = {value}\n'
    )
    Path("bad.toml").write_text(text)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "limiter_kmh")


@pytest.mark.parametrize("value", ['"motorway"', "[1, 2]", "5"])
def test_classes_that_are_no_list(capsys, value):
    text = CORRIDOR.replace('network = "{network}"', "") + (
        f'[network]\nsource = "italy-motorways"\nclasses = {value}\n'
    )
    Path("bad.toml").write_text(text)
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "classes")


def test_an_unreachable_destination(capsys):
    Path("bad.toml").write_text(trips_between((11.1, 45.0), (11.4, 45.1), two_roads()))
    refused(
        capsys, ["plan", "bad.toml", *OUTPUTS], "'A'", "no route from", "two.osm", "--infer-links"
    )


def test_origin_and_destination_in_one_spot(capsys):
    spot = (7.6, 45.1)
    Path("bad.toml").write_text(trips_between(spot, spot, "italy-motorways"))
    refused(capsys, ["plan", "bad.toml", *OUTPUTS], "bad.toml", "'A'", "same place")


CSV = 'network = "{network}"\ncase = "C"\ntrips = "trips.csv"\n'


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("vehicle,orign,destination\nA,Torino,Genova\n", "did you mean 'origin'?"),
        ("vehicle,origin,destination\n", "no rows"),
        ("vehicle,origin,destination\nA,Torino\n", "trips.csv line 2"),
        ("vehicle,origin,destination\nA,Torino,\n", "trips.csv line 2"),
        ("vehicle,origin,destination\nA,Torino,Nowhere at all\n", "no junction or town"),
        ("vehicle;origin;destination\nA;Torino;Nowhere at all\n", "no junction or town"),
        ("", "no rows"),
        ('vehicle,origin,destination\nA,"Torino,Genova\n', "trips.csv"),
    ],
)
def test_bad_trip_tables(capsys, table, said):
    Path("trips.csv").write_text(table)
    refused(capsys, ["plan", scenario(CSV), *OUTPUTS], said)


def test_missing_scenario_and_missing_table(capsys):
    refused(capsys, ["plan", "gone.toml", *OUTPUTS], "gone.toml: cannot be read")
    refused(capsys, ["plan", scenario(CSV), *OUTPUTS], "trips.csv: cannot be read")


def test_a_scenario_that_is_a_folder_or_no_text(capsys):
    Path("dir.toml").mkdir()
    refused(capsys, ["plan", "dir.toml"], "dir.toml: cannot be read")
    Path("bytes.toml").write_bytes(b"\xff\xfe\x00")
    refused(capsys, ["plan", "bytes.toml"], "bytes.toml: begins as UTF-16 text and breaks off")


def test_control_characters_of_a_map_do_not_reach_the_terminal(capsys):
    text = CORRIDOR.format(network="italy-motorways").replace('"Belluno"', '"\\u001b[31mred\\nX"')
    Path("bad.toml").write_text(text)
    assert "\x1b" not in refused(capsys, ["plan", "bad.toml"], "red")
