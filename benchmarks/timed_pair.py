"""What the clock costs two vehicles with free routes, and what it costs to find out.

Pairs of trips between random towns of the bundled map that would save by company if there were no
clock. Both leave from some minute of two hours on, and may be so much longer under way than alone.
Savings are means over all pairs and hold no noise of the machine; the times are those of this one.
Run it with `python -m benchmarks.timed_pair`.
"""

from __future__ import annotations

import statistics
import time
from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np

import platoon_osm as po
from benchmarks.masters import TOWNS

PAIRS = 60
FLEXIBILITY_MIN = (15.0, 30.0, 60.0, 120.0)
FIRST = datetime(2026, 3, 2, 6)


def main() -> None:
    """Plan all pairs with every flexibility and print a table."""
    net = po.load_network("italy-motorways")
    costs = po.paper_weights(net, tau=1.0, xi=0.18)

    def planned(trips: list[po.Trip], case: str) -> po.Plan:
        return po.plan_joint(net, costs, trips, case, objective="system")

    rng = np.random.default_rng(0)
    pairs: list[tuple[list[po.Trip], po.Plan]] = []
    while len(pairs) < PAIRS:
        ends = [rng.choice(len(TOWNS), 2, replace=False) for _ in range(2)]
        later = [timedelta(minutes=int(rng.integers(0, 120))) for _ in range(2)]
        trips = [po.Trip(f"V{k}", TOWNS[a], TOWNS[b]) for k, (a, b) in enumerate(ends)]
        free = planned(trips, "D")
        if free.saving > 0:
            leaving = zip(trips, later, strict=True)
            pairs.append(([replace(t, earliest_departure=FIRST + by) for t, by in leaving], free))
    print(
        "| longer than alone by at most | no clock | cheapest if in time, else alone | "
        "one keeps its route, in time | both free, in time | median and longest ms |"
    )
    print("|---|---|---|---|---|---|")
    for minutes in FLEXIBILITY_MIN:
        blind, kept, star, both, seconds = [], [], [], [], []
        for trips, free in pairs:
            given = [replace(trip, flexibility_min=minutes) for trip in trips]
            begin = time.perf_counter()
            plan = planned(given, "D")
            seconds.append(1e3 * (time.perf_counter() - begin))
            blind.append(free.saving)
            both.append(plan.saving)
            kept.append(plan.saving if plan.joint_cost <= free.joint_cost * (1 + 1e-9) else 0.0)
            star.append(planned(given, "C").saving)
        told = " | ".join(f"{statistics.mean(some):.2%}" for some in (blind, kept, star, both))
        print(
            f"| {minutes:.0f} min | {told} | {statistics.median(seconds):.0f} and "
            f"{max(seconds):.0f} |"
        )


if __name__ == "__main__":
    main()
