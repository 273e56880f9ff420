"""Robust plans under driving rules: never expected to save less, legal, and drawn again by hand."""

from datetime import datetime, timedelta

import pytest
from soak import chosen

import platoon_osm as po
from platoon_osm.planning.most_expected import ROBUST

FIVE = datetime(2026, 3, 3, 5)
NORTH = ("Milano", "Venezia", "Brescia", "Verona", "Torino", "Genova")


@pytest.fixture(scope="module")
def net():
    return po.load_network("italy-motorways")


def both(net, trips, spread_min, costs):
    return [
        po.solve(
            po.Problem(
                net, tuple(trips), costs, rules="eu561", robust=one, delays=po.Delays(spread_min)
            )
        )
        for one in (False, True)
    ]


@pytest.mark.parametrize("seed", chosen((0,), range(12)))
def test_it_is_never_expected_to_save_less_than_the_cheapest(net, seed):
    starts = [NORTH[(seed + k) % 6] for k in range(3)]
    trips = [
        po.Trip(
            one, one, "Napoli" if k else "Roma", FIVE + timedelta(minutes=20 * k),
            flexibility_min=90,
        )
        for k, one in enumerate(starts)
    ]  # fmt: skip
    costs = po.money_costs("eu", positions="nacfe")
    plain, robust = both(net, trips, (3, 10, 20)[seed % 3], costs)
    level = 3 * (plain.chances.saving_error + robust.chances.saving_error)
    assert robust.chances.expected_saving >= plain.chances.expected_saving - level
    assert not [one for one in po.inspect_plan(robust) if one.violation.article != "window"]
    assert any("plans compared on" in remark for remark in robust.remarks)
    late = [max(times.late_s for times in plan.times) for plan in (plain, robust)]
    assert late[1] <= late[0] + 1
    changed = ROBUST in robust.proof.conditions
    assert changed or robust.stretches == plain.stretches
    assert robust.proof.bound is None or robust.proof.bound <= robust.joint_cost + 1e-6


def test_who_is_hardly_ever_met_is_not_waited_for(net):
    """Delays of hours and dear waiting: company costs more than it saves, and nobody plans it."""
    trips = [
        po.Trip(one, one, "Napoli", FIVE, flexibility_min=120) for one in ("Milano", "Brescia")
    ]
    plain, robust = both(net, trips, 180, po.money_costs("eu", waiting_per_h=100))
    assert any(stretch.together for stretch in plain.stretches)
    assert robust.chances is not None
    assert robust.chances.expected_saving >= plain.chances.expected_saving
    if plain.chances.expected_saving < 0:
        assert not any(stretch.together for stretch in robust.stretches)
