"""The paper's edge weights, eq. 4, 5 and 11 to 13, against numbers worked out by hand."""

import math

import numpy as np
import pytest

from platoon_osm.costs.paper import PaperCosts, paper_weights
from platoon_osm.costs.weights import EdgeWeights
from platoon_osm.errors import ScenarioError
from platoon_osm.network.road_network import RoadNetwork

# v_c = 110 km/h: one metre takes 3.6 / 110 s. Rest adds 2700 / 32400 = 1 / 12.
SECONDS_PER_M = 3.6 / 110
REST = 1 / 12


@pytest.fixture
def net():
    """Two edges in a row, 1 km and 500 m."""
    return RoadNetwork.from_edges([0, 1], [1, 2], [1000, 500], lon=[9, 9.1, 9.2], lat=[45] * 3)


def test_eq_4_and_5_travel_time():
    costs = PaperCosts()
    assert costs.travel_platoon() == pytest.approx(SECONDS_PER_M)
    assert costs.travel_alone() == pytest.approx(SECONDS_PER_M * 13 / 12)
    # 110 km last an hour in a platoon and 65 minutes alone.
    assert costs.travel_platoon() * 110_000 == pytest.approx(3600)
    assert costs.travel_alone() * 110_000 == pytest.approx(3900)


def test_fuel_alone_and_in_a_platoon():
    costs = PaperCosts(fuel_l_per_100km=30, fuel_saving=0.1)
    assert costs.fuel_alone() * 100_000 == pytest.approx(30)
    assert costs.fuel_platoon() * 100_000 == pytest.approx(27)


def test_eq_11_solo_weight_is_distance_plus_time_plus_fuel(net):
    # 1 + 13/12 + 1 = 37/12 for each metre.
    assert paper_weights(net).solo == pytest.approx([37 / 12 * 1000, 37 / 12 * 500])


@pytest.mark.parametrize(
    ("tau", "xi", "per_metre"),
    [
        (0, 0, 1.0),  # time and fuel are free in a platoon
        (1, 0, 2.0),
        (0, 1, 1.82),
        (1, 1, 2.82),
        (1, 0.18, 2.1476),  # the paper's corner: 1 + 1 + 0.18 * 0.82
        (0.5, 0.5, 1.91),
    ],
)
def test_eq_12_as_printed(net, tau, xi, per_metre):
    weights = paper_weights(net, tau=tau, xi=xi, mixing="printed")
    assert weights.platoon == pytest.approx([1000 * per_metre, 500 * per_metre])


@pytest.mark.parametrize(
    ("tau", "xi", "per_metre"),
    [
        (0, 0, 37 / 12),  # nothing gained: as alone
        (1, 0, 3.0),  # the rest saved
        (0, 1, 25 / 12),  # all fuel saved
        (1, 1, 2.0),
        (1, 0.18, 2.82),
        (0.5, 0.5, 1 + 1 + 1 / 24 + 0.5),
    ],
)
def test_eq_12_read_as_gains(net, tau, xi, per_metre):
    weights = paper_weights(net, tau=tau, xi=xi, mixing="gain")
    assert weights.platoon == pytest.approx([1000 * per_metre, 500 * per_metre])


def test_eq_13_a_journey_sums_solo_and_platoon_edges(net):
    weights = paper_weights(net)
    journey = weights.solo[0] + weights.platoon[1]
    assert journey == pytest.approx(1000 * 37 / 12 + 500 * 2.1476)


def test_other_saving_and_rest_enter_where_they_should():
    costs = PaperCosts(tau=1, xi=1, fuel_saving=0.03, rest_s=0)
    assert costs.solo_factor() == pytest.approx(3.0)
    assert costs.platoon_factor() == pytest.approx(2.97)


@pytest.mark.parametrize("name", ["speed_kmh", "fuel_l_per_100km"])
def test_kappa_cancels_speed_and_fuel(name):
    # kappa rescales each term to metres, so neither value can change a cost.
    changed = PaperCosts(**{name: 77.0})
    assert changed.solo_factor() == pytest.approx(PaperCosts().solo_factor())
    assert changed.platoon_factor() == pytest.approx(PaperCosts().platoon_factor())


def test_the_lead_is_rotated_so_master_pays_as_any_member(net):
    weights = paper_weights(net)
    assert np.array_equal(weights.master, weights.platoon)
    assert weights.unit == "m"


@pytest.mark.parametrize("name", ["solo", "platoon", "master"])
def test_weights_are_read_only(net, name):
    with pytest.raises(ValueError, match="read-only"):
        getattr(paper_weights(net), name)[0] = 1


def test_making_weights_leaves_the_callers_array_alone():
    mine = np.array([1.0, 2.0])
    weights = EdgeWeights(mine, mine, mine, "m", {})
    mine[0] = 99
    assert weights.solo[0] == 1


def test_params_record_everything(net):
    params = paper_weights(net, tau=0.25, mixing="gain").params
    assert params == {
        "preset": "paper", "tau": 0.25, "xi": 0.18, "mixing": "gain", "fuel_saving": 0.18,
        "positions": None, "speed_kmh": 110.0, "rest_s": 2700.0, "driving_s": 32400.0,
        "fuel_l_per_100km": 32.0,
    }  # fmt: skip


NUMBERS = (
    "tau", "xi", "fuel_saving", "speed_kmh", "rest_s", "driving_s", "fuel_l_per_100km",
)  # fmt: skip


@pytest.mark.parametrize("name", NUMBERS)
@pytest.mark.parametrize("value", [-0.1, math.nan, math.inf, -math.inf, "1", None, True, [1]])
def test_a_parameter_that_is_no_number_in_range(net, name, value):
    with pytest.raises(ScenarioError, match=rf"^{name} = .* must be a number in \[.*\]$"):
        paper_weights(net, **{name: value})


@pytest.mark.parametrize(
    ("name", "value"),
    [("tau", 1.01), ("xi", 2), ("fuel_saving", 1), ("speed_kmh", 0), ("driving_s", 0),
     ("fuel_l_per_100km", 0)],
)  # fmt: skip
def test_a_parameter_just_out_of_range(name, value):
    with pytest.raises(ScenarioError, match=name):
        PaperCosts(**{name: value})


@pytest.mark.parametrize("mixing", ["Gain", "", None, 3, ["gain"]])
def test_unknown_mixing(mixing):
    with pytest.raises(ScenarioError, match=r'must be "printed" or "gain"$'):
        PaperCosts(mixing=mixing)


def test_unknown_parameter_lists_the_known_ones(net):
    with pytest.raises(ScenarioError, match=r"^cost parameter 'tao' is unknown; .*tau, xi") as one:
        paper_weights(net, tao=1)
    assert "\n" not in str(one.value)


def test_costs_and_fields_together_are_refused(net):
    with pytest.raises(ScenarioError, match="not both"):
        paper_weights(net, PaperCosts(), tau=1)


@pytest.mark.parametrize("value", [-1.0, math.nan, math.inf])
@pytest.mark.parametrize("name", ["solo", "platoon", "master"])
def test_a_weight_that_is_no_cost_names_the_edge(name, value):
    arrays = {key: np.ones(3) for key in ("solo", "platoon", "master")}
    arrays[name][1] = value
    with pytest.raises(ScenarioError, match=f"^weights: {name} cost of edge 1 is"):
        EdgeWeights(**arrays, unit="m", params={})


def test_weights_of_different_sizes():
    with pytest.raises(ScenarioError, match=r"^weights: platoon has shape \(2,\); .* 3 edges"):
        EdgeWeights(np.ones(3), np.ones(2), np.ones(3), "m", {})


def test_by_position_the_master_saves_what_a_leader_saves(net):
    weights = paper_weights(net, tau=1, xi=1, positions="nacfe")
    # 1 + 1 + (1 - s): nacfe saves 4 % in the lead and 10 % behind.
    assert weights.master == pytest.approx(net.length_m * 2.96)
    assert weights.platoon == pytest.approx(net.length_m * 2.90)
    assert weights.fuel_l_per_m == pytest.approx((32e-5, 0.96 * 32e-5, 0.9 * 32e-5))


def test_positions_must_be_known_and_need_the_printed_mixing(net):
    with pytest.raises(ScenarioError, match="nacfe"):
        paper_weights(net, positions="convoy")
    with pytest.raises(ScenarioError, match="printed"):
        paper_weights(net, positions="nacfe", mixing="gain")
