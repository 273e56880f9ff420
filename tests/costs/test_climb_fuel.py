"""Fuel of climbs, against numbers worked out by hand."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.costs.climb_fuel import ClimbFuel
from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.vehicles.profile import Vehicle

TRUCK = Vehicle("truck", height_m=4.0, width_m=2.5, mass_t=40)
PLAIN = ClimbFuel(efficiency=0.4, rolling=0.006, drag=0.6, air_kgpm3=1.2)


def road(climb=0.0, descent=0.0, length=1000.0, graded=None, speed=25.0):
    return RoadNetwork.from_edges(
        [0], [1], [length], lon=[9, 9.1], lat=[45, 45], speed_mps=speed, climb_m=[climb],
        descent_m=[descent], graded_m=[length if graded is None else graded],
    )  # fmt: skip


def test_a_climb_costs_the_energy_of_its_height():
    # 40,000 kg x 9.80665 m/s2 x 50 m = 19.6133 MJ; / (0.4 x 36 MJ/l) = 1.36204 l.
    assert PLAIN.extra_mj(road(climb=50), TRUCK)[0] == pytest.approx(19.6133)
    assert PLAIN.extra_l(road(climb=50), TRUCK)[0] == pytest.approx(1.3620, abs=1e-4)


def test_a_gentle_descent_gives_all_of_it_back():
    # Resistance: 0.006 x 392,266 N + 0.6 kg/m3 x 0.6 x 10 m2 x 625 m2/s2 = 2353.6 + 2250 N, which
    # takes 4.6036 MJ on a kilometre; 5 m of descent give 1.96133 MJ.
    assert PLAIN.extra_mj(road(descent=5), TRUCK)[0] == pytest.approx(-1.96133)


def test_of_a_steep_descent_the_brakes_take_what_resistance_does_not():
    assert PLAIN.extra_mj(road(descent=50), TRUCK)[0] == pytest.approx(-4.6036, abs=1e-4)


def test_a_part_of_what_a_descent_could_save_may_be_lost():
    half = ClimbFuel(efficiency=0.4, rolling=0.006, drag=0.6, recovered=0.5)
    assert half.extra_mj(road(descent=5), TRUCK)[0] == pytest.approx(-0.980665)


def test_up_and_down_again_costs_what_is_braked_away():
    # 50 m up and 50 m down, each on half of the kilometre: 19.6133 - 2.3018 MJ.
    assert PLAIN.extra_mj(road(50, 50), TRUCK)[0] == pytest.approx(17.3115, abs=1e-4)


def test_where_no_grade_is_known_nothing_is_added():
    assert PLAIN.extra_l(road(graded=0), TRUCK)[0] == 0
    assert ClimbFuel().extra_l(road(climb=10))[0] > 0  # the default vehicle


@given(st.floats(0, 300), st.floats(0, 300), st.floats(100, 5000))
def test_no_descent_saves_more_than_level_road_takes(climb, descent, length):
    extra = PLAIN.extra_mj(road(climb, descent, length), TRUCK)[0]
    level = 4603.6 * length / 1e6
    assert extra >= -level * 1.001
    assert extra >= (climb - descent) * 0.392266 * 1.001 - 0.001 or climb > descent
    more = ClimbFuel(efficiency=0.4, rolling=0.006, drag=0.6, recovered=0.0)
    assert more.extra_mj(road(climb, descent, length), TRUCK)[0] >= extra - 1e-9


@pytest.mark.parametrize(
    ("field", "value"),
    [("efficiency", 0), ("efficiency", 1.1), ("recovered", -0.1), ("rolling", "x"),
     ("fuel_mjpl", float("nan")), ("drag", True)],
)  # fmt: skip
def test_what_cannot_be_is_refused(field, value):
    with pytest.raises(ScenarioError, match=f"climb fuel: {field} is"):
        ClimbFuel(**{field: value})


def test_it_is_read_only_of_the_network():
    net = road(climb=50)
    before = net.climb_m.copy()
    PLAIN.extra_l(net, TRUCK)
    assert np.array_equal(net.climb_m, before)
