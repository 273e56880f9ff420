"""Shares of the bound as guides of the search for a plan: those nearer to the best beside others.

The bound of a day of trips rises by the usual steps, then by fine ones. With the shares of both the
same plans are searched: by as many moves, cooled alike, a seed each.

    python -m benchmarks.fleet_guides IT 5000 given    # place, trucks, routes
    python -m benchmarks.fleet_guides DE 5000 free --steps 1000 --rounds 20 --seeds 4
"""

from __future__ import annotations

import argparse
import statistics
from typing import TYPE_CHECKING

from benchmarks.merge_trees import instance_of

if TYPE_CHECKING:
    from platoon_osm.fleets.bound.bound import Bound
    from platoon_osm.fleets.instance import Instance

ALL_AT_ONCE = (("plan", 1.0),)
"""The course of a search without a bound."""


def never() -> bool:
    """Go on."""
    return False


def planned(instance: Instance, bound: Bound, rounds: int, seed: int) -> int:
    """Return what a plan costs that is searched with the shares of a bound."""
    from platoon_osm.fleets.cooling import heat_at
    from platoon_osm.fleets.plan.search import FleetSearch
    from platoon_osm.fleets.run import MOVES

    search = FleetSearch(instance, threads=2, seed=seed)
    search.construct(bound.shares, bound.guide)
    for number in range(rounds):
        heat = heat_at(ALL_AT_ONCE, 0, 0.0, number / rounds, instance.trucks)
        search.improve(bound.shares, bound.guide, MOVES, heat, never)
    return search.cost


def main() -> None:
    """Measure one day."""
    from platoon_osm.fleets.bound.bound import Bound
    from platoon_osm.fleets.warmth import warm_up

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("place", choices=("DE", "IT", "map"))
    parser.add_argument("trucks", type=int)
    parser.add_argument("routes", choices=("given", "free"))
    parser.add_argument("--steps", type=int, default=1000)
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--day", type=int, default=1, help="seed of the trips")
    own = parser.parse_args()
    instance = instance_of(own.place, own.trucks, 0, 30, own.day, own.routes)
    warm_up()
    alone = int(instance.alone_cost.sum())
    bound = Bound(instance, threads=2)
    first = planned(instance, bound, own.rounds, 1)
    for fine in (False, True):
        bound.improve(float(first), own.steps, never, fine)
        costs = [planned(instance, bound, own.rounds, seed + 1) for seed in range(own.seeds)]
        plans = [100 * (alone - cost) / alone for cost in costs]
        spread = statistics.stdev(plans) if own.seeds > 1 else 0.0
        kind = "fine" if fine else "usual"
        print(
            f"{kind} steps: bound {100 * (alone - bound.cost) / alone:.4f} %, "
            f"plans {statistics.fmean(plans):.4f} % +- {spread:.4f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
