"""What is left of a saving when trucks run late, and what it is worth to weigh that in the choice.

Four trucks from towns in the north of the bundled map to towns in its south, drawn at random, each
leaving within an hour of six in the morning, with some time to spare. The paper's costs with
tau = 1 and xi = 0.18, an hour's waiting at 100 km-equivalents; then the money preset `eu`. Both
plans are judged on the same 10,000 days drawn with a seed of their own, not those on which the
robust one was chosen. Run it with `python -m benchmarks.late_members`.
"""

from __future__ import annotations

import statistics
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from typing import Any

import numpy as np

import platoon_osm as po

DRAWS = 20
VEHICLES = 4
SIX = datetime(2026, 3, 3, 6)
SPREADS_MIN = (5.0, 10.0, 20.0)
SPARE_MIN = (20.0, 60.0)
SEED = 1
NORTH = (
    "Torino", "Milano", "Genova", "Venezia", "Trieste", "Verona", "Brescia", "Parma", "Padova",
    "Udine",
)  # fmt: skip
SOUTH = ("Bologna", "Firenze", "Roma", "Napoli", "Salerno", "Bari", "Ancona", "Pescara")


@dataclass(frozen=True)
class Priced:
    """The paper's costs, and 100 km-equivalents for an hour of waiting."""

    driving: po.PaperCosts = field(default_factory=lambda: po.PaperCosts(tau=1.0, xi=0.18))
    name = "paper with waiting"
    unit = "m"
    params: Any = field(default_factory=lambda: {"waiting_km_h": 100})

    def weights(self, net: po.RoadNetwork, vehicle: Any = None) -> po.EdgeWeights:
        """Return what driving costs."""
        return self.driving.weights(net, vehicle)

    def waiting(self, seconds: float) -> float:
        """Return what waiting costs [m]."""
        return 1e5 * seconds / 3600


def drawn(spare_min: float) -> list[list[po.Trip]]:
    """Return the trips of all draws; their towns and times are the same whatever is to spare."""
    rng = np.random.default_rng(0)
    draws = []
    for _ in range(DRAWS):
        trips = []
        for k in range(VEHICLES):
            start, end = rng.choice(NORTH), rng.choice(SOUTH)
            leaves = SIX + timedelta(minutes=int(rng.integers(0, 61)))
            trips.append(po.Trip(f"V{k}", str(start), str(end), leaves, flexibility_min=spare_min))
        draws.append(trips)
    return draws


def main() -> None:
    """Plan all draws with and without `robust` and print a table."""
    from platoon_osm.costs.presets import PRESETS

    net = po.load_network("italy-motorways")
    euros = PRESETS.find("eu").objective({})
    print(
        "| costs | to spare, spread | merges that succeed | saving planned | expected | of the "
        "robust plan | plans changed |\n|---|---|---|---|---|---|---|"
    )
    for name, costs in (("paper, priced waiting", Priced()), ("`eu`", euros)):
        for spare in SPARE_MIN:
            for spread in SPREADS_MIN:
                told = row(net, costs, spare, spread)
                print(f"| {name} | {spare:.0f} min, {spread:.0f} min | {told}", flush=True)


def row(net: po.RoadNetwork, costs: Any, spare: float, spread: float) -> str:
    """Return the means over all draws."""
    delays = po.Delays(spread, correlation=0.3)
    met, planned, expected, robust, changed = [], [], [], [], 0
    for trips in drawn(spare):
        plans = [
            po.plan_joint(net, costs, trips, delays=delays, robust=one) for one in (False, True)
        ]
        days = [po.simulate_delays(plan, delays, seed=SEED, objective=costs) for plan in plans]
        alone = plans[0].solo_cost
        met += [float(share) for share in days[0].met.mean(axis=1)]
        planned.append(days[0].chances.planned_saving / alone)
        expected.append(days[0].chances.expected_saving / alone)
        robust.append(days[1].chances.expected_saving / alone)
        changed += plans[0].timetable != plans[1].timetable
    return (
        f"{statistics.mean(met or [0.0]):.0%} | {statistics.mean(planned):.2%} | "
        f"{statistics.mean(expected):.2%} | {statistics.mean(robust):.2%} | {changed} of {DRAWS} |"
    )


if __name__ == "__main__":
    main()
