"""Break-even in closed form, against the road on which plans change from alone to together."""

from __future__ import annotations

import math
from dataclasses import dataclass
from datetime import datetime, timedelta

import numpy as np
import pytest
from places import ROOT
from soak import chosen, soaked

from platoon_osm import (
    EdgeWeights,
    FuelCosts,
    PaperCosts,
    Problem,
    RoadNetwork,
    Trip,
    money_costs,
    solve,
    write_break_even,
)
from platoon_osm.costs.break_even import break_even
from platoon_osm.errors import ScenarioError

SIX = datetime(2026, 3, 2, 6)
KMH = 72.0
SHARED_KM = 100.0


@dataclass(frozen=True)
class Prices:
    """Costs of a kilometre by place, and of a minute."""

    alone: float
    master: float
    member: float
    waiting_min: float = 0.0
    delay_min: float = 0.0
    name = "prices"
    unit = "EUR"
    params = {}  # noqa: RUF012 (nobody changes it)

    def weights(self, net, vehicle=None):
        del vehicle
        km = net.length_m / 1000
        return EdgeWeights(
            km * self.alone, km * self.member, km * self.master, self.unit, self.params,
            network=net.identity(),
        )  # fmt: skip

    def per_km(self, vehicle, position, size, speed_kmh):
        del vehicle, speed_kmh
        return self.alone if size == 1 else self.member if position else self.master

    def waiting(self, seconds):
        return self.waiting_min * seconds / 60

    def delay(self, seconds):
        return self.delay_min * seconds / 60


def two_roads(ramp_km, own_km=SHARED_KM):
    """Return the master's road 0 1 2 3 and the member's 4 5, with a way to it and one from it."""
    km = np.array([10.0, SHARED_KM, 10.0, own_km, ramp_km, ramp_km])
    return RoadNetwork.from_edges(
        [0, 1, 2, 4, 4, 2], [1, 2, 3, 5, 1, 5], 1000 * km,
        lon=[9, 9.1, 9.9, 10, 9.1, 9.9], lat=[45, 45, 45, 45, 45.1, 45.1], speed_mps=KMH / 3.6,
    )  # fmt: skip


def together(net, costs, optimum, trips=None, case="best"):
    """Return whether the plan has a platoon."""
    trips = trips or (Trip("master", 0, 3), Trip("member", 4, 5))
    plan = solve(Problem(net, trips, costs, optimum=optimum, case=case))
    return any(len(stretch.vehicles) > 1 for stretch in plan.stretches)


def bisected(low, high, holds):
    """Return where something that holds at `low` no longer does."""
    assert holds(low)
    assert not holds(high)
    for _ in range(10):
        middle = (low + high) / 2
        low, high = (middle, high) if holds(middle) else (low, middle)
    return (low + high) / 2


DRAWN = np.random.default_rng(15)
PRICED = [
    Prices(1.0, round(1.0 - leads, 3), round(1.0 - follows, 3))
    for leads, follows in DRAWN.uniform([0.0, 0.05], [0.2, 0.5], (20, 2))
]
CHOSEN = [
    *(PaperCosts(positions=name) for name in (None, "eddi")),
    money_costs("eu", positions="nacfe"),
    FuelCosts("plafosim"),
    *chosen(PRICED[:2], PRICED),
]


@soaked
@pytest.mark.parametrize("costs", CHOSEN)
@pytest.mark.parametrize("optimum", ["member", "system"])
def test_the_detour_at_which_plans_change_is_the_break_even(costs, optimum):
    known = break_even(costs, optimum=optimum, speed_kmh=KMH).table[0].km_per_detour_km
    ramp = bisected(
        0.0, SHARED_KM / 2, lambda km: together(two_roads(km + 1e-3), costs, optimum)
    )  # fmt: skip
    # As exact as so many halvings are.
    assert 2 * ramp / SHARED_KM == pytest.approx(1 / known, abs=1e-3)


@pytest.mark.parametrize(("optimum", "delay_min"), [("member", 0.0), ("system", 0.05)])
def test_the_wait_at_which_plans_change_is_the_break_even(optimum, delay_min):
    """The member leaves at six and drives no detour; the master comes by the later the longer.

    Waiting is weighed against what both save, whosever cost is least.
    """
    costs = Prices(1.0, 0.99, 0.9, waiting_min=0.2, delay_min=delay_min)
    row = break_even(costs, optimum="system", speed_kmh=KMH, late=True).table[0]
    net = two_roads(1.0, own_km=SHARED_KM + 2.0)
    meets = SIX + timedelta(hours=1 / KMH) - timedelta(hours=10 / KMH)

    def holds(minutes):
        leaves = meets + timedelta(minutes=minutes)
        trips = (
            Trip("master", 0, 3, leaves, latest_departure=leaves),
            Trip("member", 4, 5, SIX, latest_departure=SIX),
        )
        return together(net, costs, optimum, trips, case="C")

    found = bisected(0.0, 100.0, holds)
    assert found / SHARED_KM == pytest.approx(1 / row.km_per_waiting_min, abs=1e-3)
    if delay_min:
        free = break_even(costs, optimum="system", speed_kmh=KMH).table[0]
        assert free.km_per_waiting_min < row.km_per_waiting_min
        assert free.km_per_detour_km < row.km_per_detour_km


def test_by_hand():
    """Alone 1, leading 0.98, following 0.9: 0.1 saved by the member, 0.12 by both."""
    costs = Prices(1.0, 0.98, 0.9, waiting_min=0.3, delay_min=0.1)
    mine, ours = (break_even(costs, optimum=side).table[0] for side in ("member", "system"))
    assert mine.km_per_detour_km == pytest.approx(10)
    assert mine.km_per_waiting_min == pytest.approx(3)
    assert ours.km_per_detour_km == pytest.approx(1 / 0.12)
    assert ours.km_together(detour_km=3, waiting_min=4) == pytest.approx((3 + 1.2) / 0.12)
    # A kilometre of detour at 60 km/h makes a minute later.
    late = break_even(costs, speed_kmh=60, late=True).table[0]
    assert late.km_per_detour_km == pytest.approx(11)
    assert late.km_per_waiting_min == pytest.approx(4)


def test_who_joins_two_counts_what_changes_for_both():
    """Two save 0 and 8, three 0, 12 and 8: the third brings its own 8, and 4 to the second."""

    class Third(Prices):
        def per_km(self, vehicle, position, size, speed_kmh):
            del vehicle, speed_kmh
            return 100 - {1: (0,), 2: (0, 8), 3: (0, 12, 8)}[size][position]

    costs = Third(100, 0, 0)
    assert break_even(costs, size=3).table[0].saved_per_km == 8
    assert break_even(costs, size=3, optimum="system").table[0].saved_per_km == 12


def test_what_never_pays_takes_forever_and_what_is_free_nothing():
    row = break_even(Prices(1.0, 1.0, 1.0, waiting_min=0.5)).table[0]
    assert row.km_per_detour_km == row.km_per_waiting_min == math.inf
    assert row.km_together() == 0
    assert break_even(Prices(1.0, 1.0, 1.2)).table[0].km_per_detour_km == math.inf
    assert break_even(PaperCosts()).table[0].km_per_waiting_min == 0


def test_as_a_table():
    found = break_even({name: PaperCosts(positions=name) for name in ("eddi", "nrel")})
    frame = found.to_frame()
    assert frame["name"].tolist() == ["eddi", "nrel"]
    assert frame["unit"].tolist() == ["m", "m"]
    assert frame["km_per_detour_km"].tolist() == [
        row.km_per_detour_km for row in found.table
    ]  # fmt: skip
    # Who saves more needs fewer kilometres.
    assert frame["km_per_detour_km"].is_monotonic_decreasing
    assert (found.vehicle, found.size, found.optimum) == ("eu-40t", 2, "member")


def test_figures_are_the_same_to_the_last_byte(tmp_path):
    """One that pays, one that never does, and one whose waiting is free."""
    found = break_even({"eddi $1$": money_costs("eu"), "no": Prices(1, 1, 1, 1), "p": PaperCosts()})
    for name in ("a", "b"):
        write_break_even(found, tmp_path / f"{name}.svg", language="de")
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()


def test_the_table_in_the_docs_is_what_comes_out():
    rows = [
        [cell.strip() for cell in line.strip("|").split("|")]
        for line in (ROOT / "docs" / "money.md").read_text(encoding="utf-8").splitlines()
        if line.startswith(("| `", "| the paper"))
    ]
    told = {row[0].strip("`"): row[1:] for row in rows if len(row) == 4}
    costs = {name: money_costs("eu", positions=name) for name in ("eddi", "nacfe", "nrel")}
    costs["the paper's weights"] = PaperCosts()
    ours, mine = (break_even(costs, optimum=side).table for side in ("system", "member"))
    for both, own in zip(ours, mine, strict=True):
        detour, alone, minute = told[both.name]
        digits = 1 if both.unit == "m" else 0
        assert detour == f"{both.km_per_detour_km:.{digits}f}"
        assert alone == f"{own.km_per_detour_km:.{digits}f}"
        assert minute.split(":")[0] == f"{both.km_per_waiting_min:.0f}"


def test_a_figure_of_what_is_none_or_where_none_can_be(tmp_path):
    with pytest.raises(ScenarioError, match=r"use \.png, \.svg or \.pdf"):
        write_break_even(break_even(PaperCosts()), tmp_path / "a.gif")
    with pytest.raises(ScenarioError, match="is no break-even"):
        write_break_even(PaperCosts(), tmp_path / "a.png")


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"size": 1}, "size is 1; give 2 to 100"),
        ({"speed_kmh": 0}, "speed_kmh is 0; give 1 to 200 km/h"),
        ({"optimum": "all"}, "optimum 'all' is unknown; use member, system"),
        ({"costs": {}}, "no costs are given"),
        ({"costs": PaperCosts}, "without `per_km` and `waiting`"),
        ({"costs": 3}, "without `per_km` and `waiting`"),
        ({"costs": Prices(-1.0, 0, 0)}, "costs must be finite and 0 or more"),
    ],
)
def test_what_cannot_be_is_refused(given, says):
    with pytest.raises(ScenarioError) as refusal:
        break_even(**{"costs": PaperCosts(), **given})
    assert says in str(refusal.value)
    assert "\n" not in str(refusal.value)
