"""What a vehicle is to the roads: presets, and what is refused."""

import pytest

from platoon_osm.errors import ScenarioError
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE, VEHICLES, Vehicle, vehicle_of


def test_the_default_is_the_largest_that_needs_no_permit_in_the_eu():
    assert DEFAULT_VEHICLE.name == "eu-40t"
    size = (DEFAULT_VEHICLE.height_m, DEFAULT_VEHICLE.width_m, DEFAULT_VEHICLE.length_m)
    assert size == (4.0, 2.55, 16.5)
    assert (DEFAULT_VEHICLE.mass_t, DEFAULT_VEHICLE.axle_load_t) == (40, 11.5)
    assert DEFAULT_VEHICLE.heavy


def test_a_van_is_no_heavy_vehicle_and_a_loaded_american_truck_weighs_36_tonnes():
    assert not VEHICLES["van-3.5t"].heavy
    assert VEHICLES["us-80k-lb"].mass_t == pytest.approx(36.287, abs=1e-3)
    assert VEHICLES["us-80k-lb"].height_m == pytest.approx(4.115, abs=1e-3)


def test_an_empty_truck_is_heavy_by_its_papers():
    assert Vehicle("empty", mass_t=3.2, rating_t=12).heavy


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("eu-40", "trip 'A': vehicle 'eu-40' is unknown; did you mean 'eu-40t'?"),
        ({"heigth_m": 4}, "trip 'A': a vehicle has no 'heigth_m'"),
        ({"height_m": 400}, "height_m is 400; give 0.5 to 10 m"),
        ({"height_m": True}, "height_m is True"),
        ({"mass_t": float("nan")}, "mass_t is nan"),
        ({"rating_t": 12}, "it weighs 40 t and may weigh 12 t"),
        ({"tunnel_code": "A1"}, "tunnel_code is 'A1'"),
        ({"trailer": "yes"}, "trailer is 'yes'"),
        ({"base": "van"}, "vehicle 'van' is unknown"),
        (7, "7 is no vehicle"),
    ],
)
def test_what_is_no_vehicle_is_refused_in_one_line(given, said):
    with pytest.raises(ScenarioError) as caught:
        vehicle_of(given, "trip 'A'")
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_table_changes_what_it_names():
    low = vehicle_of({"base": "us-80k-lb", "height_m": 3.4, "tunnel_code": "c"})
    assert (low.height_m, low.tunnel_code, low.mass_t) == (3.4, "C", VEHICLES["us-80k-lb"].mass_t)
    assert low.name == "like us-80k-lb"
    assert "3.4 m high" in low.told()
    assert "tunnel code C" in low.told()


def test_it_comes_back_from_its_plain_form():
    for vehicle in VEHICLES.values():
        assert Vehicle(**vehicle.to_dict()) == vehicle
