"""Cheapest schedules under any shares and a price of waiting, against all ticks one by one."""

import numpy as np
from certificates import slow_bound
from exhaustive import random_instance
from soak import chosen, soaked

from platoon_osm.fleets.bound.buckets import Clock, bucketed
from platoon_osm.fleets.bound.crews import Crew
from platoon_osm.fleets.bound.searching import Searching

SEEDS = range(chosen(150, 3000))


def drawn(seed, **asked):
    """Return a fleet, buckets cut anywhere, and shares of them that are any whole numbers."""
    rng = np.random.default_rng(seed)
    fleet = random_instance(
        seed, trucks=2, slack=int(rng.choice([3, 8, 16])), waiting=int(rng.choice([1, 3, 9])),
        **asked,
    )  # fmt: skip
    clock = Clock.of(fleet)
    cuts = clock.key(
        rng.integers(fleet.lanes, size=40), clock.first + rng.integers(clock.span, size=40)
    )
    listed = np.flatnonzero(rng.random(fleet.pairs) < 0.8)
    buckets = bucketed(fleet, clock, listed, np.unique(cuts))
    lane = fleet.pair_lane[np.repeat(listed, np.diff(buckets.first_share))]
    room = fleet.alone[lane] - fleet.member[lane]
    # What is paid is never below nothing: who turned in circles would earn by it.
    share = np.maximum(np.minimum(rng.integers(-20, 12, len(lane)), room), -fleet.member[lane])
    share = share.astype(np.float64)
    return fleet, buckets, share


def told(fleet, buckets, share):
    return {
        "lane_first": buckets.lane_first.tolist(), "starts": buckets.starts.tolist(),
        "truck": fleet.pair_truck[buckets.pairs].tolist(),
        "lane": fleet.pair_lane[buckets.pairs].tolist(),
        "first_bucket": buckets.first_bucket.tolist(),
        "first_share": buckets.first_share.tolist(), "share": share.astype(int).tolist(),
    }  # fmt: skip


def paid(fleet, buckets, share, lanes, departs):
    """Return what a schedule of the first truck costs, lane by lane."""
    cost, ready = 0.0, None
    for lane, at in zip(lanes, departs, strict=True):
        if ready is not None:
            assert at >= ready
            cost += fleet.waiting * (at - ready)
        ready = at + int(fleet.drive[lane])
        pair = next(p for p in range(fleet.first_pair[1]) if fleet.pair_lane[p] == lane)
        assert fleet.opens[pair] <= at <= fleet.closes[pair]
        found = np.flatnonzero(buckets.pairs == pair)
        if not len(found):
            cost += fleet.member[lane] - fleet.leader_saves[lane]
            continue
        own = buckets.starts[buckets.lane_first[lane] : buckets.lane_first[lane + 1]]
        bucket = buckets.lane_first[lane] + np.searchsorted(own, at, "right") - 1
        first = buckets.first_share[found[0]] - buckets.first_bucket[found[0]]
        cost += fleet.member[lane] + share[first + bucket]
    return cost


@soaked
def test_schedules_are_the_cheapest_of_all_ticks_and_told_as_they_are_paid():
    circles = 0
    for seed in SEEDS:
        fleet, buckets, share = drawn(seed)
        searching = Searching(fleet, buckets, share, every=True)
        with Crew(1) as crew:
            cost = searching.search(crew, pruned=False)
            assert cost == slow_bound(fleet, told(fleet, buckets, share)), seed
            assert abs(searching.search(crew) - cost) <= 1e-9 * abs(cost), seed
        lanes, departs, count = searching.schedules()
        own = paid(fleet, buckets, share, lanes[0, : count[0]], departs[0, : count[0]].tolist())
        assert abs(own - searching.routes.cost[0]) < 1e-6, seed
        circles += not searching.ways.in_order.all()
    assert circles


@soaked
def test_what_the_search_before_found_prunes_and_changes_nothing():
    for seed in SEEDS[::3]:
        fleet, buckets, share = drawn(seed)
        rng = np.random.default_rng(seed)
        searching = Searching(fleet, buckets, share)
        with Crew(1) as crew:
            for _ in range(4):
                least = -np.repeat(searching.prices.member, np.diff(searching.prices.first_share))
                searching.share[:] = np.maximum(
                    searching.share + rng.integers(-4, 3, len(share)), least
                )
                cost = searching.search(crew)
                anew = Searching(fleet, buckets, searching.share.copy()).search(crew, pruned=False)
                assert abs(cost - anew) <= 1e-9 * abs(anew), seed
