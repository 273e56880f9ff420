"""One truck's response against all of its schedules, where waiting on the road has a price."""

import itertools
from dataclasses import replace

import numpy as np
from exhaustive import cost_of, random_instance
from soak import chosen, soaked
from tiny_fleets import all_schedules

from platoon_osm.fleets.plan.search import FleetSearch

SEEDS = range(chosen(80, 1500))


def as_tuples(plan):
    ways = zip(*plan.ways(), strict=True)
    return [tuple(zip(lanes.tolist(), at.tolist(), strict=True)) for lanes, at in ways]


def bound_but_for_the_first(seed):
    """Return a fleet in which all trucks but one have one schedule each, and those schedules."""
    rng = np.random.default_rng(seed)
    fleet = random_instance(
        seed, trucks=4, kinds=1, nodes=5, slack=9, waiting=int(rng.choice([1, 1, 4])),
    )  # fmt: skip
    opens, closes = fleet.opens.copy(), fleet.closes.copy()
    earliest, latest = fleet.earliest.copy(), fleet.latest.copy()
    keep = fleet.pair_truck == 0
    fixed = []
    for k in range(1, fleet.trucks):
        own = all_schedules(fleet, k)
        way = own[int(rng.integers(len(own)))]
        fixed.append(way)
        earliest[k], latest[k] = way[0][1], way[-1][1] + int(fleet.drive[way[-1][0]])
        for p in range(fleet.first_pair[k], fleet.first_pair[k + 1]):
            for lane, at in way:
                if fleet.pair_lane[p] == lane:
                    keep[p] = True
                    opens[p] = closes[p] = at
    truck = fleet.pair_truck[keep]
    return replace(
        fleet, earliest=earliest, latest=latest, pair_truck=truck,
        pair_lane=fleet.pair_lane[keep], opens=opens[keep],
        closes=closes[keep], on_alone=fleet.on_alone[keep],
        first_pair=np.searchsorted(truck, np.arange(fleet.trucks + 1)),
    ), fixed  # fmt: skip


@soaked
def test_the_response_is_the_best_of_all_schedules_whoever_must_keep_apart():
    waited = moved = 0
    for seed in SEEDS:
        fleet, fixed = bound_but_for_the_first(seed)
        apart = None
        ways = all_schedules(fleet, 0)
        spare = fleet.latest - fleet.earliest
        # Who has the least time comes first, and must not be the one who could go elsewhere.
        if seed % 3 == 0 and spare[1] < spare[0]:
            apart = (np.array([0, 1, 1, 1, 1]), np.array([1]))
            ways = [way for way in ways if not set(way) & set(fixed[0])]
        if not ways:
            continue
        search = FleetSearch(fleet, seed=seed, apart=apart)
        search.construct(None, None)
        best = search.best
        best.check(fleet)
        costs = [cost_of(fleet, (way, *fixed)) for way in ways]
        assert search.cost == min(costs) == best.cost(fleet), seed
        own = as_tuples(best)[0]
        assert own in ways
        waited += best.waited(fleet) > sum(
            at - before - int(fleet.drive[lane])
            for way in fixed
            for (lane, before), (_, at) in itertools.pairwise(way)
        )
        moved += own[0][1] > fleet.earliest[0]
    assert waited > 1
    assert moved > len(SEEDS) // 12
