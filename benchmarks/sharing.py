"""How often shares are in the core, and what it costs to find out.

Games of one company first: 180 of them a row, two to seven vehicles, with savings drawn alike. Then
plans between towns of the bundled map, by European prices: coalitions drive as planned, or plan
anew. The counts hold no noise of the machine; the times are those of this one.
Run it with `python -m benchmarks.sharing`.
"""

from __future__ import annotations

import statistics
import time

import numpy as np

import platoon_osm as po
from benchmarks.masters import TOWNS
from platoon_osm.sharing.checked import checked
from platoon_osm.sharing.company import CompanyGame
from platoon_osm.sharing.rule_names import SharingRule

SPREADS = (0.0, 0.5, 0.8)
GAMES = 30
PLANS = 40
VEHICLES = (4, 5, 6)
RULES: tuple[SharingRule, ...] = ("equal", "shapley", "least-core")
HAIR = 1e-9


def main() -> None:
    """Print both tables."""
    print(
        "| what followers save, leaders nothing | Shapley in the core | equal parts in the core |"
    )
    print("|---|---|---|")
    for least in SPREADS:
        rng = np.random.default_rng(0)
        saved = [rng.uniform(least, 1, n) for n in range(2, 8) for _ in range(GAMES)]
        games = [CompanyGame(own, np.zeros(len(own))) for own in saved]
        shapley = sum(checked(one.shapley(), one.values()).worst <= HAIR for one in games)
        equal = sum(checked(one.equal_parts(), one.values()).worst <= HAIR for one in games)
        print(f"| {least:g} to 1, uniform | {shapley} of {len(games)} | {equal} of {len(games)} |")
    print()
    net = po.load_network("italy-motorways")
    rng = np.random.default_rng(0)
    plans: list[tuple[po.Plan, po.Problem]] = []
    while len(plans) < PLANS:
        count = VEHICLES[len(plans) % len(VEHICLES)]
        ends = [rng.choice(len(TOWNS), 2, replace=False) for _ in range(count)]
        trips = [po.Trip(f"V{k}", TOWNS[a], TOWNS[b]) for k, (a, b) in enumerate(ends)]
        problem = po.Problem(net, trips, po.MoneyCosts("eu"))
        plan = po.solve(problem)
        if plan.saving > 0:
            plans.append((plan, problem))
    print(
        "| rule | coalitions | none gains a cent | the most one gains, cents | nobody worse off | "
        "median and longest ms |"
    )
    print("|---|---|---|---|---|---|")
    for anew in (False, True):
        for rule in RULES:
            found, seconds = [], []
            for plan, problem in plans:
                begin = time.perf_counter()
                found.append(po.share_gain(plan, problem, rule, anew=anew).gain)
                seconds.append(1e3 * (time.perf_counter() - begin))
            gains = [one for one in found if one is not None]
            worst = [one.worst_cents or 0.0 for one in gains]
            content = sum(own < 1 for own in worst)
            kept = sum(one.nobody_is_worse_off for one in gains)
            print(
                f"| {rule} | {gains[0].manner} | {content} of {PLANS} | {max(worst):.0f} | "
                f"{kept} of {PLANS} | {statistics.median(seconds):.0f}, {max(seconds):.0f} |"
            )


if __name__ == "__main__":
    main()
