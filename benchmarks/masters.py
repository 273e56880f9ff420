"""What the choice of the master is worth, and what company off its route and turns add.

Trips between random towns of the bundled map, 8 vehicles a draw. Savings are means over all draws,
and hold no noise of the machine; the seconds are those of this machine. Run it with
`python -m benchmarks.masters`.
"""

from __future__ import annotations

import statistics
import time
from typing import Any

import numpy as np

import platoon_osm as po

DRAWS = 40
VEHICLES = 8
TOWNS = (
    "Torino", "Milano", "Genova", "Venezia", "Trieste", "Bologna", "Firenze", "Roma", "Napoli",
    "Bari", "Ancona", "Pescara", "Verona", "Brescia", "Salerno", "Parma", "Padova", "Udine",
)  # fmt: skip

RULES: tuple[tuple[str, dict[str, Any]], ...] = (
    ("the longest route leads, company with it alone (the paper)",
     {"master": "longest", "company": "master"}),
    ("the best master, company with it alone", {"company": "master"}),
    ("the longest route leads, company anywhere", {"master": "longest"}),
    ("the best master, company anywhere (the default)", {}),
    ("the same, platoons of at most 3", {"max_platoon": 3}),
)  # fmt: skip


def main() -> None:
    """Plan all draws by all rules and print a table."""
    net = po.load_network("italy-motorways")
    costs = po.paper_weights(net, tau=1.0, xi=0.18)
    rng = np.random.default_rng(0)
    draws = []
    for _ in range(DRAWS):
        pairs = [rng.choice(len(TOWNS), 2, replace=False) for _ in range(VEHICLES)]
        draws.append([po.Trip(f"V{k}", TOWNS[a], TOWNS[b]) for k, (a, b) in enumerate(pairs)])
    po.plan_joint(net, costs, draws[0], "C")
    print("| rule | saved, mean | median seconds a plan |\n|---|---|---|")
    for label, rule in RULES:
        saved, seconds, most = [], [], []
        for trips in draws:
            begin = time.perf_counter()
            plan = po.plan_joint(net, costs, trips, "C", **rule)
            seconds.append(time.perf_counter() - begin)
            saved.append(plan.saving)
            most.append(1 - (plan.proof.any_plan or 0.0) / plan.solo_cost)
        print(f"| {label} | {statistics.mean(saved):.1%} | {statistics.median(seconds):.2f} |")
    print(f"| no plan can save more than | {statistics.mean(most):.1%} | |")


if __name__ == "__main__":
    main()
