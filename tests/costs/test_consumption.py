"""Litres by physics, against published consumption and against a sum over pieces of road."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from places import ROOT

from platoon_osm.costs.climb_fuel import ClimbFuel
from platoon_osm.costs.consumption import Consumption
from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.vehicles.pace import drive_times
from platoon_osm.vehicles.profile import VEHICLES, Vehicle

FUEL = Consumption()
ICCT_L, ICCT_BEST_L, ICCT_T = 32.6, 29.9, 34.3
"""Average and best tractor-trailer over the long-haul cycle: ICCT 2018, with 19.3 t of payload."""
DEFRA_KG_A_KM, DEFRA_KG_A_L, DEFRA_T = 0.9237, 2.57082, 27.0
"""Articulated vehicles above 33 t with average load, diesel: UK conversion factors 2025."""


def truck(mass_t):
    return Vehicle("truck", mass_t=mass_t)


def roads(climb, descent, length, graded, speed=22.0):
    count = len(length)
    return RoadNetwork.from_edges(
        list(range(count)), list(range(1, count + 1)), length,
        lon=9 + np.arange(count + 1) / 100, lat=np.full(count + 1, 45.0),
        speed_mps=speed, climb_m=climb, descent_m=descent, graded_m=graded,
    )  # fmt: skip


def off(found, published):
    """Return by which share a figure differs from a published one."""
    return found / published - 1


def test_the_default_truck_takes_what_is_published():
    found = FUEL.per_100km("eu-40t", 80.0)
    assert off(found, ICCT_L) == pytest.approx(0.001, abs=0.0005)
    assert 30 < found < 33  # of a 40 t tractor-trailer
    assert FUEL.per_100km() == found


def test_how_far_the_formula_is_from_other_figures():
    lighter = FUEL.per_100km(truck(ICCT_T), 80.0)
    assert off(lighter, ICCT_L) == pytest.approx(-0.0745, abs=0.0005)
    assert off(lighter, ICCT_BEST_L) == pytest.approx(0.0090, abs=0.0005)
    defra_l = DEFRA_KG_A_KM / DEFRA_KG_A_L * 100
    assert defra_l == pytest.approx(35.93, abs=0.005)
    british = FUEL.per_100km(truck(DEFRA_T), 80.0)
    assert off(british, defra_l) == pytest.approx(-0.2481, abs=0.0005)
    told = (ROOT / "docs" / "money.md").read_text(encoding="utf-8")
    usual = FUEL.per_100km()
    for found, published in (
        (usual, ICCT_L), (lighter, ICCT_L), (lighter, ICCT_BEST_L), (british, defra_l),
    ):  # fmt: skip
        row = rf"\| {found:.1f} \| {published:.1f}: .* \| {100 * off(found, published):+.1f} % \|"
        assert re.search(row.replace("+", r"\+"), told), row
    assert f"{FUEL.per_100km(speed_kmh=90.0):.1f} l/100 km at 90 km/h" in told


def test_the_default_truck_by_hand():
    # 0.6 x 0.57 x 10.2 m2 x 493.83 m2/s2 = 1722.7 N, 0.0055 x 392,266 N = 2157.5 N, 15 % of both
    # more, 5,000 W / 22.22 m/s = 225 N: 468.7 MJ on 100 km; / (0.399 x 36 MJ/l).
    assert float(FUEL.force_n(80 / 3.6)) == pytest.approx(1.15 * (1722.7 + 2157.5) + 225, abs=0.3)
    assert FUEL.per_100km() == pytest.approx(468.72 / 14.364, abs=0.01)
    assert float(FUEL.air_share("eu-40t", 80 / 3.6)) == pytest.approx(1722.7 / 4687.2, abs=1e-4)


def by_pieces(fuel, who, climb, descent, length, graded, speed, saved):
    """Return litres of an edge, driven up, down and level one after the other.

    Engine and brakes are counted, not the sums that the formula has.
    """
    weight = who.mass_t * 9806.65
    still = 0.5 * fuel.air_kgpm3 * fuel.drag * who.height_m * who.width_m * speed * speed
    alone, here = still + fuel.rolling * weight, still * (1 - saved) + fuel.rolling * weight
    down = graded * descent / (climb + descent) if climb + descent else 0.0
    push, pull = weight * descent, here * down
    helped = fuel.recovered * min(push, pull)
    engine = here * (length - down) + weight * climb + (pull - helped)
    braked = push - helped
    engine += fuel.unsteady * alone * (length - graded)  # what is not known
    engine += max(0.0, fuel.unsteady * alone * graded - braked)  # what is known, and not braked
    engine += 1000 * fuel.auxiliary_kw * length / speed
    return engine / (fuel.efficiency * fuel.fuel_mjpl * 1e6)


lengths = st.floats(50, 20_000)
heights = st.floats(0, 400)
shares = st.floats(0, 1)


@given(
    edges=st.lists(st.tuples(heights, heights, lengths, shares), min_size=1, max_size=4),
    mass=st.floats(3.5, 60),
    speed=st.floats(8, 30),
    saved=shares,
    unsteady=st.sampled_from([0.0, 0.15, 1.0]),
    recovered=st.sampled_from([0.0, 0.6, 1.0]),
)
def test_litres_are_those_of_engine_and_brakes(edges, mass, speed, saved, unsteady, recovered):
    climb, descent, length, known = (np.array(values) for values in zip(*edges, strict=True))
    net = roads(climb, descent, length, known * length, speed)
    fuel = Consumption(unsteady=unsteady, recovered=recovered)
    who = truck(mass)
    speeds = np.full(net.m, speed)
    found = fuel.litres(net, who, speed_mps=speeds, air_saved=saved)
    for edge in range(net.m):
        wanted = by_pieces(
            fuel, who, float(net.climb_m[edge]), float(net.descent_m[edge]),
            float(net.length_m[edge]), float(net.graded_m[edge]), speed, saved,
        )  # fmt: skip
        assert found[edge] == pytest.approx(wanted, rel=1e-9, abs=1e-9)
    assert (found >= 0).all()
    assert (fuel.litres(net, truck(mass + 1), speed_mps=speeds, air_saved=saved) >= 0).all()
    # Company never costs fuel, and saves no more than the air's share.
    alone = fuel.litres(net, who, speed_mps=speeds)
    level = Consumption(unsteady=0, auxiliary_kw=0, rolling=0)
    air = level.litres(roads(0 * climb, 0 * climb, length, 0 * climb, speed), who, speed_mps=speeds)
    assert (found <= alone + 1e-12).all()
    assert (alone - found <= saved * air + 1e-9).all()


@given(climb=heights, length=lengths)
def test_no_hill_is_counted_twice_and_none_makes_road_cheaper(climb, length):
    unknown = roads([0.0], [0.0], [length], [0.0])
    level = roads([0.0], [0.0], [length], [length])
    hill = roads([climb], [climb], [length], [length])
    usual, steady = FUEL.litres(unknown)[0], Consumption(unsteady=0).litres(hill)[0]
    assert FUEL.litres(level)[0] == pytest.approx(usual)
    # Either the loss that is known or the usual one.
    assert FUEL.litres(hill)[0] == pytest.approx(max(usual, steady))


def test_climbs_are_those_of_the_view():
    net = roads([50.0, 0.0, 10.0], [0.0, 50.0, 40.0], [1000.0] * 3, [1000.0, 1000.0, 400.0])
    steady = Consumption(rolling=0.0068, drag=0.63, unsteady=0.0)
    flat = roads([0.0] * 3, [0.0] * 3, [1000.0] * 3, [0.0] * 3)
    added = steady.litres(net) - steady.litres(flat)
    assert added == pytest.approx(ClimbFuel().extra_l(net))


def test_edges_and_their_own_speeds():
    net = roads([0.0, 20.0, 0.0], [0.0] * 3, [1000.0, 2000.0, 3000.0], [0.0, 2000.0, 0.0], 30.0)
    whole = FUEL.litres(net)
    picked = np.array([2, 0])
    assert FUEL.litres(net, edges=picked).tolist() == whole[picked].tolist()
    pace = net.length_m / drive_times(net, VEHICLES["eu-40t"])
    assert FUEL.litres(net, speed_mps=pace) == pytest.approx(whole)
    assert pace.max() == pytest.approx(25.0)  # the limiter
    slow = FUEL.litres(net, edges=picked, speed_mps=np.array([20.0, 20.0]))
    assert (slow < whole[picked]).all()
    assert FUEL.hills_mj(net)[[0, 2]].tolist() == [0, 0]


def test_auxiliaries_are_paid_by_time():
    only = Consumption(rolling=0, drag=0, auxiliary_kw=7.2, efficiency=0.4)
    # 7.2 kW for 500 s are 3.6 MJ, a quarter of what a litre gives.
    assert only.litres(roads([0], [0], [5000], [0]), speed_mps=np.array([10.0]))[0] == 0.25


@given(mass=st.floats(3.5, 60), speed=st.floats(5, 35))
def test_the_air_has_a_share_of_the_fuel_that_weight_lessens_and_speed_raises(mass, speed):
    share = float(FUEL.air_share(truck(mass), speed))
    assert 0 < share < 1
    assert float(FUEL.air_share(truck(mass + 1), speed)) < share
    assert float(FUEL.air_share(truck(mass), speed + 1)) > share
    saved = FUEL.per_100km(truck(mass), speed * 3.6, air_saved=0.3)
    assert saved == pytest.approx(FUEL.per_100km(truck(mass), speed * 3.6) * (1 - 0.3 * share))


@pytest.mark.parametrize(
    ("field", "value"),
    [("efficiency", 0), ("unsteady", -0.1), ("recovered", 2), ("auxiliary_kw", None),
     ("fuel_mjpl", float("nan")), ("drag", True)],
)  # fmt: skip
def test_what_cannot_be_is_refused(field, value):
    with pytest.raises(ScenarioError, match=f"consumption: {field} is"):
        Consumption(**{field: value})


def test_shares_and_speeds_that_cannot_be():
    net = roads([0], [0], [1000], [0])
    for share in (-0.1, 1.1, None):
        with pytest.raises(ScenarioError, match=r"air_saved is .*; give 0 to 1"):
            FUEL.litres(net, air_saved=share)
    for speeds in ([0.0], [1.0, 2.0], [float("nan")]):
        with pytest.raises(ScenarioError, match="one speed above 0 for each of 1 edges"):
            FUEL.litres(net, speed_mps=np.array(speeds))
