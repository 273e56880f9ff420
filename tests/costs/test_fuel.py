"""Fuel saved by position in the platoon."""

import math

import pytest

from platoon_osm.costs.fuel import FUEL_SAVINGS, FuelSaving, fuel_saving
from platoon_osm.errors import ScenarioError

THREE = FuelSaving("three", leader=0.06, middle=0.12, last=0.09)


@pytest.mark.parametrize(
    ("size", "shares"),
    [
        (0, ()),
        (1, (0.0,)),  # nobody saves alone
        (2, (0.06, 0.09)),
        (3, (0.06, 0.12, 0.09)),
        (4, (0.06, 0.12, 0.12, 0.09)),
        (5, (0.06, 0.12, 0.12, 0.12, 0.09)),
    ],
)
def test_by_position(size, shares):
    assert THREE.by_position(size) == shares


@pytest.mark.parametrize(
    ("size", "share"), [(0, 0), (1, 0), (2, 0.075), (3, 0.09), (4, 0.0975), (5, 0.102)]
)
def test_mean_is_what_each_saves_when_the_lead_rotates(size, share):
    assert THREE.mean(size) == pytest.approx(share)


def test_presets_say_who_measured_them():
    assert set(FUEL_SAVINGS) == {"seed_18", "nrel", "nacfe", "bhoopalam", "plafosim", "eddi"}
    for name, saving in FUEL_SAVINGS.items():
        assert saving.name == name
        assert saving.source
        # Whoever drives in front saves least.
        assert saving.leader <= saving.middle
        assert saving.leader <= saving.last


def test_preset_values():
    assert fuel_saving("seed_18").by_position(3) == (0.0, 0.18, 0.18)
    assert fuel_saving("plafosim").by_position(4) == (0.055, 0.124, 0.124, 0.106)
    assert fuel_saving("nacfe").mean(2) == pytest.approx(0.07)


def test_a_model_of_ones_own_passes_through():
    assert fuel_saving(THREE) is THREE


@pytest.mark.parametrize("name", ["nacf", "", None, ["nrel"], 18])
def test_unknown_preset_lists_the_known(name):
    near = r"did you mean 'nacfe'\? " if name == "nacf" else ""
    with pytest.raises(ScenarioError, match=rf"unknown; {near}use one of seed_18, .*eddi$"):
        fuel_saving(name)


def test_a_table_of_ones_own_is_found_by_its_name():
    FUEL_SAVINGS.add(THREE)
    try:
        assert fuel_saving("three") is FUEL_SAVINGS["three"] is THREE
    finally:
        FUEL_SAVINGS.remove("three")
    with pytest.raises(ScenarioError, match="'three' is unknown"):
        fuel_saving("three")


@pytest.mark.parametrize("position", ["leader", "middle", "last"])
@pytest.mark.parametrize("share", [-0.01, 1, math.nan, math.inf, "0.1", None, True])
def test_a_share_out_of_range(position, share):
    shares = {"leader": 0.0, "middle": 0.1, "last": 0.1, position: share}
    with pytest.raises(ScenarioError, match=rf"^fuel saving 'mine': {position} saves .*\[0, 1\)$"):
        FuelSaving("mine", **shares)
