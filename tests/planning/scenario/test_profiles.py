"""Vehicles and closed roads in scenarios and tables."""

import pytest
from bundled import italy as italy_map

import platoon_osm as po
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.scenario import read_scenario
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE, VEHICLES

TEXT = """
network = "italy-motorways"
profile = "low"
close = ["A 22"]

[profiles.low]
base = "eu-40t"
height_m = 3.4

[profiles.low-and-light]
base = "low"
mass_t = 18

[[trips]]
vehicle = "A"
origin = "Torino"
destination = "Trieste"

[[trips]]
vehicle = "B"
origin = "Genova"
destination = "Belluno"
profile = "low-and-light"

[[trips]]
vehicle = "C"
origin = "Genova"
destination = "Verona Sud"
profile = {base = "us-80k-lb", tunnel_code = "D"}
"""


def read(folder, text=TEXT):
    file = folder / "s.toml"
    file.write_text(text, encoding="utf-8")
    return read_scenario(file)


def test_vehicles_of_a_scenario(tmp_path):
    scenario = read(tmp_path)
    scenario.check()
    plan = scenario.plan(italy_map())
    low, light, other = (trip.profile for trip in plan.trips)
    assert (low.name, low.height_m, low.mass_t) == ("low", 3.4, 40)
    assert (light.name, light.height_m, light.mass_t, light.permitted_t) == (
        "low-and-light", 3.4, 18, 18,
    )  # fmt: skip
    assert (other.tunnel_code, other.mass_t) == ("D", VEHICLES["us-80k-lb"].mass_t)
    assert plan.closed == ("A 22",)
    net = italy_map()
    driven = {e for stretch in plan.stretches for e in stretch.edges}
    assert "A 22" not in {net.edge_ref(edge) for edge in driven}


def test_vehicles_in_a_table(tmp_path):
    file = tmp_path / "t.csv"
    file.write_text(
        "vehicle;origin;destination;profile;Height m;mass_t\n"
        "A;x;y;van-3.5t;;\nB;x;y;;3,4;18\nC;x;y;;;\nD;x;y;us-80k-lb;3,9;\n"
    )
    van, low, plain, us = po.read_trips(file)
    assert van.profile == VEHICLES["van-3.5t"]
    assert (low.profile.height_m, low.profile.mass_t) == (3.4, 18)
    assert (low.profile.width_m, plain.profile) == (DEFAULT_VEHICLE.width_m, None)
    assert (us.profile.height_m, us.profile.mass_t) == (3.9, VEHICLES["us-80k-lb"].mass_t)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('profile = "low"\n', 'profile = "lo"\n', "profile: vehicle 'lo' is unknown; did you mean"),
        ("height_m = 3.4", "hight_m = 3.4", "[profiles.low]: a vehicle has no 'hight_m'"),
        ("height_m = 3.4", 'height_m = "low"', "height_m is 'low'"),
        ('base = "low"', 'base = "lower"', "[profiles.low-and-light]: vehicle 'lower' is unknown"),
        ('profile = "low-and-light"', "profile = 7", "trip 2: profile: 7 is no vehicle"),
        ('tunnel_code = "D"', 'tunnel_code = "X"', "trip 3: profile: vehicle"),
        ('close = ["A 22"]', "close = {}", "close is a dict"),
        ("[profiles.low]", "[profile.low]", ""),
    ],
)
def test_each_mistake_in_one_line_with_the_file(tmp_path, old, new, said):
    assert old in TEXT
    with pytest.raises(ScenarioError) as caught:
        read(tmp_path, TEXT.replace(old, new)).check()
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)
    assert str(caught.value).startswith(str(tmp_path / "s.toml"))


def test_a_road_that_is_not_there_is_told_of(tmp_path):
    with pytest.raises(ScenarioError, match=r"close: 'A 222' is no road of italy-motorways; give"):
        read(tmp_path, TEXT.replace("A 22", "A 222")).plan(italy_map())
