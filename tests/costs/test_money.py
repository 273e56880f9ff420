"""Costs in money: terms, sources, what a place in a platoon is worth, and what is refused."""

import math
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.costs.consumption import Consumption
from platoon_osm.costs.fuel import FUEL_SAVINGS, FuelSaving
from platoon_osm.costs.money.driving import Driving
from platoon_osm.costs.money.figures import GIVEN, figures_of, looked_up, physics_of
from platoon_osm.costs.money.fuel_costs import FuelCosts
from platoon_osm.costs.money.objective import CURRENCIES, PRICES, MoneyCosts, money_costs
from platoon_osm.costs.presets import PRESETS
from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.vehicles.pace import drive_times
from platoon_osm.vehicles.profile import VEHICLES, vehicle_of

NAMES = ("seed_18", "nrel", "nacfe", "bhoopalam", "plafosim", "eddi")


@pytest.fixture(scope="module")
def net():
    """Four roads of unlike speed; Germany charges by the kilometre, Italy what the map marks."""
    return RoadNetwork.from_edges(
        [0, 1, 2, 3], [1, 2, 3, 4], [10e3, 20e3, 30e3, 40e3],
        speed_mps=np.array([80, 90, 60, 85]) / 3.6,
        lon=[9 + 0.1 * k for k in range(5)], lat=[45.0] * 5,
    )  # fmt: skip


def test_every_figure_of_the_physics_has_a_source():
    told = {one.name: one for one in physics_of(Consumption(drag=0.5))}
    assert set(told) == {item.name for item in fields(Consumption)}
    assert told["drag"].source == GIVEN
    assert all(one.source != GIVEN for name, one in told.items() if name != "drag")


def test_every_price_has_a_source():
    for preset in CURRENCIES:
        table = figures_of(preset)
        assert set(table) == set(PRICES)
        for figure in table.values():
            assert len(figure.source) > 10
            assert math.isfinite(figure.value)
            assert figure.unit.partition("/")[0] in ("", "kg", CURRENCIES[preset])
    assert looked_up().year >= 2026


def test_a_figure_of_ones_own_says_so():
    told = {figure.name: figure for figure in money_costs("eu", fuel_per_l=1.5).figures()}
    assert (told["fuel_per_l"].value, told["fuel_per_l"].source) == (1.5, GIVEN)
    assert told["driver_per_h"].source != GIVEN
    assert told["saving_leader"].value == FUEL_SAVINGS["eddi"].leader
    assert "A9" in told["saving_leader"].source


def test_waiting_costs_the_drivers_hour_unless_told():
    assert MoneyCosts().waiting(3600) == MoneyCosts().driver_per_h
    assert money_costs("eu", driver_per_h=20).waiting(1800) == 10
    assert money_costs("eu", waiting_per_h=0).waiting(1800) == 0
    assert money_costs("eu", delay_per_h=6).delay(600) == 1


def test_what_driving_costs_is_the_sum_of_its_terms(net):
    costs = money_costs("eu", co2_per_t=100.0, toll_unknown_per_km=0.2)
    driving = Driving(costs, net, None)
    fuel, driver, toll, co2 = driving.amounts()
    litres = costs.consumption.litres(
        net, edges=np.arange(net.m), speed_mps=net.length_m / drive_times(net)
    )
    np.testing.assert_allclose(fuel, 1.30 * litres)
    np.testing.assert_allclose(driver, 33.0 * drive_times(net) / 3600)
    np.testing.assert_allclose(co2, 0.1 * 2.57082 * litres)
    assert not toll.any()  # the map has no country and marks no toll
    np.testing.assert_allclose(costs.weights(net).solo, fuel + driver + toll + co2)


def test_toll_is_that_of_the_country_and_a_stated_one_where_it_is_not_known():
    roads = RoadNetwork.from_edges(
        [0, 1, 2], [1, 2, 3], [10e3] * 3, lon=[9, 9.1, 9.2, 9.3], lat=[45.0] * 4,
        country=["DE", "IT", "IT"], toll=[False, True, False],
        road_class=[0] * 3,
    )  # fmt: skip
    toll = Driving(MoneyCosts(), roads, None).amounts()[2]
    np.testing.assert_allclose(toll, [3.48, 1.753, 0.0])
    half = Driving(money_costs("eu", toll=0.5), roads, None).amounts()[2]
    np.testing.assert_allclose(half, toll / 2)
    dollars = Driving(money_costs("us", toll_unknown_per_km=0.1), roads, None).amounts()[2]
    np.testing.assert_allclose(dollars, [1.0, 1.0, 0.0])


@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from(NAMES), st.integers(2, 6), st.data(),
    st.sampled_from(["eu-40t", "van-3.5t", "us-80k-lb"]), st.floats(0.5, 1.0), st.floats(0.2, 1),
)  # fmt: skip
def test_nobody_pays_more_than_was_planned_with(name, size, data, who, slower, paid):
    net = RoadNetwork.from_edges(
        [0, 1, 2], [1, 2, 3], [10e3, 20e3, 5e3], speed_mps=np.array([80, 90, 70]) / 3.6,
        lon=[9, 9.1, 9.2, 9.3], lat=[45.0] * 4,
    )  # fmt: skip
    costs = money_costs("eu", positions=name, driver_following=paid)
    driving = Driving(costs, net, vehicle_of(who))
    slowest = driving.own_s / slower
    member, master = driving.planned(slowest)
    position = data.draw(st.integers(0, size - 1))
    pace = driving.own_s + data.draw(st.floats(0, 1)) * (slowest - driving.own_s)
    share = driving.share(np.arange(3), position, size, pace)
    planned = float((master if position == 0 else member).sum())
    assert share.cost <= planned * (1 + 1e-12)
    assert share.cost >= driving.least(size, slowest) * planned * (1 - 1e-12)
    assert sum(share.terms) == pytest.approx(share.cost)
    assert sum(share.alone_terms) == pytest.approx(share.alone_cost)


def test_where_places_and_paces_are_alike_nothing_is_left_open(net):
    assert MoneyCosts().weights(net).least_by_position(9) == 1.0
    assert money_costs("eu", positions="plafosim").weights(net).least_by_position(2) == 1.0
    assert 0.9 < money_costs("eu", positions="plafosim").weights(net).least_by_position(3) < 1.0


def test_each_saves_by_its_own_air_resistance(net):
    """A light van meets nearly nothing but air, so company saves it a larger share of its fuel."""
    saved = {}
    for who in ("van-3.5t", "eu-40t"):
        share = Driving(money_costs("eu", positions="nacfe"), net, vehicle_of(who)).share(
            np.arange(4), 1, 2, None
        )
        saved[who] = 1 - share.fuel_l / share.alone_fuel_l
    assert saved["van-3.5t"] > 1.3 * saved["eu-40t"] > 0.05


def test_a_slow_leader_costs_time_and_saves_fuel(net):
    driving = Driving(MoneyCosts(), net, None)
    slow = driving.share(np.arange(4), 1, 2, driving.own_s * 1.2)
    usual = driving.share(np.arange(4), 1, 2, None)
    assert slow.fuel_l < usual.fuel_l
    assert slow.terms[1] == pytest.approx(1.2 * usual.terms[1])
    assert slow.alone_cost == usual.alone_cost


def test_the_hour_of_a_driver_who_follows_may_cost_less(net):
    free = Driving(money_costs("eu", driver_following=0.5), net, None)
    behind, front = free.share(np.arange(4), 1, 2, None), free.share(np.arange(4), 0, 2, None)
    assert behind.terms[1] == pytest.approx(front.terms[1] / 2)


@pytest.mark.parametrize("name", NAMES)
def test_fuel_alone_is_counted_in_litres(net, name):
    weights = FuelCosts(positions=name).weights(net)
    assert weights.unit == "l"
    share = weights.share(np.arange(4), 100e3, 1, 2)
    assert share.cost == pytest.approx(share.fuel_l)
    assert FuelCosts().waiting(3600) == 0


def test_weights_of_vehicles_that_differ_in_name_alone_are_the_same(net):
    truck = VEHICLES["eu-40t"]
    costs = MoneyCosts()
    assert costs.weights(net, truck).same(costs.weights(net, replace(truck, name="ours")))
    assert not costs.weights(net, truck).same(costs.weights(net, replace(truck, mass_t=20.0)))


@pytest.mark.parametrize(
    ("preset", "params", "told"),
    [
        ("eu", {"fuel_per_l": -1}, "fuel_per_l = -1 must be a number"),
        ("eu", {"fuel_per_l": "dear"}, "must be a number"),
        ("eu", {"driver_following": 1.5}, r"must be a number in \[0, 1\]"),
        ("eu", {"positions": "oddi"}, "did you mean 'eddi'"),
        ("eu", {"fuel_price": 1.0}, "did you mean 'fuel_per_l'"),
        ("us", {"efficiency": 0}, "efficiency"),
        ("fuel", {"fuel_per_l": 1.0}, "unknown"),
    ],
)
def test_what_is_no_price_is_refused(preset, params, told):
    with pytest.raises(ScenarioError, match=told) as error:
        PRESETS[preset].objective(params)
    assert "\n" not in str(error.value)


def test_a_preset_that_is_none():
    with pytest.raises(ScenarioError, match="use eu, us"):
        MoneyCosts("uk")
    with pytest.raises(ScenarioError, match="give a Consumption"):
        MoneyCosts(consumption=3)


def test_savings_of_ones_own(net):
    costs = MoneyCosts(positions=FuelSaving("ours", 0.02, 0.06, 0.05, "measured by ourselves"))
    assert costs.params["positions"] == "ours"
    assert costs.weights(net).least_by_position(3) < 1


def test_every_parameter_of_a_preset_is_taken(net):
    for name in ("eu", "us", "fuel", "paper"):
        preset = PRESETS[name]
        params = preset.objective({}).params
        given = {key: params[key] for key in preset.parameters if key in params}
        assert set(given) == set(preset.parameters)
        assert preset.objective(given).params == params
