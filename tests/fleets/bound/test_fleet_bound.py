"""The bound on a fleet's costs against the best plan, the linear program, and its own shares."""

import numpy as np
import pytest
from exhaustive import instance_of, optimum, random_instance
from soak import chosen, soaked
from tiny_fleets import all_schedules, cost_under, linear_bound, valid_by_trying

from platoon_osm.fleets.bound import ascent, schedules, splitting, waiting, whole
from platoon_osm.fleets.bound import bound as bounds
from platoon_osm.fleets.bound.bound import Bound
from platoon_osm.fleets.bound.warmth import warm_up

SEEDS = range(chosen(60, 3000))


def never():
    return False


def fleet_of(seed, **asked):
    """Return a tiny fleet of a seed, of any kind that the bound knows."""
    rng = np.random.default_rng(seed)
    return random_instance(
        seed, trucks=int(rng.integers(1, 5)), largest=int(rng.choice([0, 2, 3])),
        given=bool(rng.integers(2)), **{"waiting": int(rng.choice([0, 0, 1, 3, 8])), **asked},
    )  # fmt: skip


@soaked
@pytest.mark.parametrize("part", range(4))
def test_the_bound_is_that_of_the_linear_program(part):
    for seed in SEEDS[part::4]:
        fleet = fleet_of(seed)
        bound = Bound(fleet)
        started = bound.cost
        schedules = [all_schedules(fleet, k) for k in range(fleet.trucks)]
        program = linear_bound(fleet, schedules)
        best = optimum(fleet).cost
        bound.improve(best, 1500, never)
        assert started <= bound.cost <= program * (1 + 1e-9) <= best * (1 + 2e-9), seed
        assert bound.cost >= program * (1 - 1e-3), seed
        shares, cost = bound.certified()
        assert shares.share.dtype == np.int64
        assert valid_by_trying(fleet, shares), seed
        assert cost == cost_under(fleet, shares, schedules) <= best, seed
        # Rounding down takes at most a grain a lane.
        assert cost >= bound.cost - len(fleet.pair_lane), seed


@pytest.mark.parametrize("many", [0, bounds.MANY_PAIRS])
def test_shares_are_valid_at_every_step_and_the_bound_never_falls(many, monkeypatch):
    monkeypatch.setattr(bounds, "MANY_PAIRS", many)
    for seed in range(20):
        fleet = fleet_of(seed)
        bound, before = Bound(fleet), -np.inf
        best = optimum(fleet).cost
        for turn in range(12):
            bound.improve(best, 14, never, fine=turn >= 6)
            assert valid_by_trying(fleet, bound.certified()[0]), seed
            assert before <= bound.cost <= best
            before = bound.cost


def test_shares_that_are_loosened_are_valid_and_leave_no_price_unused():
    alone = 0
    for seed in range(40):
        fleet = fleet_of(seed)
        bound = Bound(fleet)
        bound.improve(float(fleet.alone_cost.sum()), 50, never)
        own = bound._buckets
        share = bounds._loosened(own, bound._volume.shares, fleet.largest)
        whole_ones = bounds._shares(own, np.floor(share + 1e-6).astype(np.int64))
        assert valid_by_trying(fleet, whole_ones), seed
        for b in range(len(own.keys)):
            some = share[own.entry[own.first_member[b] : own.first_member[b + 1]]]
            price, leader = own.extra[b], own.leader[b]
            if len(some) == 1:
                alone += 1
                assert some[0] == pytest.approx(price + leader), seed
            elif len(some) and leader == 0 and not 0 < fleet.largest < len(some):
                assert some.sum() == pytest.approx(price), seed
    assert alone > 100


def test_threads_change_nothing():
    fleet = random_instance(5, trucks=5, nodes=6, given=False)
    found = []
    for threads in (1, 2, 4):
        bound = Bound(fleet, threads)
        bound.improve(float(fleet.alone_cost.sum()), 300, never)
        shares, cost = bound.certified()
        found.append((bound.cost, cost, bound.shares.share.tolist(), shares.share.tolist()))
    assert found[0] == found[1] == found[2]


def test_the_guide_tells_schedules_that_can_be_driven():
    for seed in range(30):
        fleet = fleet_of(seed)
        bound = Bound(fleet)
        bound.improve(float(fleet.alone_cost.sum()), 50, never)
        guide = bound.guide
        assert len(guide.least) == fleet.pairs
        assert (guide.least >= -fleet.leader_saves[fleet.pair_lane]).all()
        assert guide.cost.sum() == pytest.approx(bound.cost)
        for k in range(fleet.trucks):
            lanes = guide.lanes[k, : guide.count[k]].tolist()
            departs = guide.departs[k, : guide.count[k]].tolist()
            told = tuple(zip(lanes, departs, strict=True))
            assert told in all_schedules(fleet, k), seed


def test_it_stops_when_it_is_told_to():
    fleet = fleet_of(3)
    bound = Bound(fleet)
    before = bound.cost
    bound.improve(float(fleet.alone_cost.sum()), 100, lambda: True)
    assert bound.cost == before


@pytest.mark.parametrize("latest", range(2, 8))
def test_a_cheap_way_that_is_late_by_a_tick_is_none(latest):
    # Two roads after each other, each quick and dear or slow and cheap: 1 + 1, 1 + 3 or 3 + 3.
    lanes = {
        "tail": [0, 0, 1, 1], "head": [1, 1, 2, 2], "drive": [1, 3, 1, 3],
        "alone": [20, 10, 20, 10], "member": [18, 9, 18, 9], "extra": [2, 1, 2, 1],
        "lane_kind": [0] * 4,
    }  # fmt: skip
    trucks = {
        "origin": [0], "destination": [2], "earliest": [0], "latest_departure": [latest],
        "latest": [latest], "kind": [0],
    }  # fmt: skip
    fleet = instance_of(lanes, trucks, nodes=3, largest=0, given=False)
    bound = Bound(fleet)
    bound.improve(40.0, 20, never)
    least = {2: 40, 3: 40, 4: 30, 5: 30, 6: 20, 7: 20}[latest]
    assert bound.cost == pytest.approx(least)
    assert bound.certified()[1] == least


def test_a_fleet_of_trucks_that_never_meet_costs_what_they_cost_alone():
    for seed in range(10):
        fleet = random_instance(seed, trucks=1)
        assert Bound(fleet).certified()[1] == fleet.alone_cost.sum()


@pytest.mark.parametrize("price", [0, 2])
def test_after_warming_up_nothing_is_compiled_any_more(price):
    search = waiting.cheapest_waiting if price else schedules.cheapest
    kernels = (search, ascent._move, splitting._cuts, whole._made_valid)
    warm_up(price)
    before = [len(kernel.signatures) for kernel in kernels]
    assert min(before) == 1
    bound = Bound(fleet_of(2, waiting=price))
    bound.improve(bound.cost * 1.01, 100, never)
    bound.certified()
    assert [len(kernel.signatures) for kernel in kernels] == before
