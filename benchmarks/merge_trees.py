"""Merge trees in a fleet: how long a group takes, and what they find that the search did not.

A day of trips is planned for some seconds by the bound and the search of `plan_fleet`. Then, for a
third of that time each: groups of 2 to 8 trucks that overlap are planned anew as merge trees,
beside the companies of all others, and kept if all pay less; or the search goes on.

    python -m benchmarks.merge_trees DE 1000 5 30 30    # place, trucks, largest, window, seconds
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Literal

import numpy as np

from benchmarks.sections import ROOT

if TYPE_CHECKING:
    from platoon_osm.fleets.bound.bound import Bound
    from platoon_osm.fleets.instance import Instance
    from platoon_osm.fleets.plan.search import FleetSearch

SHARED = ROOT.parent / "shared" / "data" / "etis"
SAVED = 0.10


def instance_of(
    place: str, trucks: int, largest: int, window_min: float, seed: int,
    routes: Literal["free", "given"] = "free",
) -> Instance:  # fmt: skip
    """Return a day of trips in whole numbers, on costs as of `benchmarks.fleets`."""
    import platoon_osm as po
    from platoon_osm.fleets.model import modelled

    bundled, folder = place == "map", SHARED / place
    if not bundled and not folder.is_dir():
        sys.exit(f"{place}: not found in ../shared/data/etis; this benchmark needs it")
    net = po.load_network("italy-motorways" if bundled else folder / "graph.graphml")
    trips = po.draw_trips(
        net, trucks, flows=None if bundled else folder / "traffic.csv",
        flexibility_min=window_min, min_km=100.0, seed=seed,
    )  # fmt: skip
    length = net.length_m
    costs = po.EdgeWeights(
        solo=length, platoon=(1 - SAVED) * length, master=length, unit="m", params={}
    )
    problem = po.Problem(net, trips, costs, max_platoon=largest or None)
    return modelled(problem, po.Limits(time_s=1.0, routes=routes)).instance


def searched(bound: Bound, search: FleetSearch, seconds: float, heat: float) -> None:
    """Let the search go on for some time, ever colder."""
    begun = time.perf_counter()

    def spent() -> float:
        return (time.perf_counter() - begun) / seconds

    while spent() < 1:
        now = heat * max(0.0, (1 - spent() - 0.15) / 0.85)
        search.improve(bound.shares, bound.guide, 1000, now, lambda: spent() >= 1)


def bounded(bound: Bound, search: FleetSearch, seconds: float) -> None:
    """Let the bound go on for some time."""
    begun = time.perf_counter()

    def late() -> bool:
        return time.perf_counter() - begun >= seconds

    while not late() and not bound.settled:
        bound.improve(float(search.cost), 100, late)


def group_around(
    instance: Instance, lanes: list[np.ndarray], rng: np.random.Generator
) -> list[int]:
    """Return 2 to 8 trucks that overlap one of those before on a lane of its plan."""
    group, wanted = [int(rng.integers(instance.trucks))], int(rng.integers(2, 9))
    for _ in range(60):
        if len(group) >= wanted:
            break
        k = int(rng.choice(group))
        lane = int(rng.choice(lanes[k]))
        pairs = np.flatnonzero(instance.pair_lane == lane)
        own = pairs[instance.pair_truck[pairs] == k][0]
        near = pairs[
            (instance.opens[pairs] <= instance.closes[own])
            & (instance.closes[pairs] >= instance.opens[own])
        ]
        mate = int(rng.choice(instance.pair_truck[near]))
        if mate not in group:
            group.append(mate)
    return group


def of_trees(
    instance: Instance, search: FleetSearch, seconds: float, seed: int
) -> tuple[int, int, int, list[float]]:
    """Return moves by merge trees, how many saved, the cost then, and how long each took [ms]."""
    from platoon_osm.fleets.plan.schedules import company_cost
    from platoon_osm.fleets.trees.merge_trees import merge_tree

    def companies(some: list[int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        lane, at = (np.concatenate([one[k] for k in some]) for one in (lanes, departs))
        order = np.lexsort((at, lane))
        lane, at = lane[order], at[order]
        first = np.flatnonzero(
            np.concatenate([[True], (np.diff(lane) != 0) | (np.diff(at) != 0)])
        )  # fmt: skip
        return lane[first], at[first], np.diff(np.append(first, len(lane)))

    def total() -> int:
        lane, _, size = companies(list(range(instance.trucks)))
        costs = (one[lane] for one in (instance.alone, instance.member, instance.extra))
        return int(company_cost(size, *costs, instance.largest).sum())

    rng = np.random.default_rng(seed)
    lanes, departs = search.best.ways()
    cost, moves, wins, took = search.cost, 0, 0, []
    begun = time.perf_counter()
    while time.perf_counter() - begun < seconds:
        group = group_around(instance, lanes, rng)
        others = companies([k for k in range(instance.trucks) if k not in group])
        before = time.perf_counter()
        tree = merge_tree(instance, group, others)
        took.append(1000 * (time.perf_counter() - before))
        kept = [(lanes[k], departs[k]) for k in group]
        for place, k in enumerate(group):
            lanes[k], departs[k] = tree.lanes[place], tree.departs[place]
        now = total()
        moves, wins = moves + 1, wins + (now < cost)
        if now > cost:
            for k, (own, at) in zip(group, kept, strict=True):
                lanes[k], departs[k] = own, at
        cost = min(cost, now)
    return moves, wins, cost, took


def main() -> None:
    """Plan one day, then go on in both ways."""
    from platoon_osm.fleets.bound.bound import Bound
    from platoon_osm.fleets.plan.search import FleetSearch
    from platoon_osm.fleets.trees.compiled import PLANTED
    from platoon_osm.fleets.trees.merge_trees import merge_tree
    from platoon_osm.fleets.warmth import warm_up

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("place", choices=("DE", "IT", "map"))
    for name in ("trucks", "largest", "window"):
        parser.add_argument(name, type=int)
    parser.add_argument("seconds", type=float)
    parser.add_argument("--seed", type=int, default=1)
    own = parser.parse_args()
    instance = instance_of(own.place, own.trucks, own.largest, own.window, own.seed)
    warm_up()
    PLANTED.now()
    merge_tree(instance, [0])
    bound = Bound(instance, threads=2, seed=own.seed)
    search = FleetSearch(instance, threads=2, seed=own.seed)
    alone = int(instance.alone_cost.sum())

    def tell(what: str, cost: int) -> None:
        gap = (cost - bound.cost) / (alone - bound.cost)
        print(
            f"{what}: saved {100 * (alone - cost) / alone:.4f} %, gap {100 * gap:.4f} %", flush=True
        )

    steps: list[tuple[Callable[..., None], tuple[object, ...]]] = [
        (bounded, (bound, search, 0.3 * own.seconds)),
        (searched, (bound, search, 0.4 * own.seconds, 1.0)),
        (bounded, (bound, search, 0.1 * own.seconds)),
        (searched, (bound, search, 0.2 * own.seconds, 0.5)),
    ]
    for step, arguments in steps:
        step(*arguments)
        search.construct(bound.shares, bound.guide)
    tell("planned", search.cost)
    moves, wins, cost, took = of_trees(instance, search, own.seconds / 3, own.seed)
    tell(f"{moves} trees, {wins} of them better", cost)
    print(f"a tree: {np.median(took):.1f} ms in the median, {max(took):.0f} at most")
    searched(bound, search, own.seconds / 3, 0.3)
    tell("search instead", search.cost)


if __name__ == "__main__":
    main()
