"""The oracle of fleets against one that skips nothing, and pairs against all that may be driven."""

from __future__ import annotations

from dataclasses import replace

import pytest
from exhaustive import company_cost, cost_of, instance_of, optimum, random_instance, slow_optimum


def tiny(seed: int, waiting: int):
    return random_instance(seed, trucks=2 + (seed % 2), nodes=4, waiting=waiting, slack=3)


@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("waiting", [0, 2])
def test_the_oracle_finds_what_every_plan_at_every_tick_has_at_best(seed, waiting):
    instance = tiny(seed, waiting)
    best = optimum(instance)
    assert best.cost == slow_optimum(instance).cost
    assert best.cost == cost_of(instance, best.schedules)


def test_some_random_fleets_save_by_leaving_their_ways_alone():
    free = [random_instance(seed, given=False, trucks=3) for seed in range(12)]
    left = [
        instance
        for instance in free
        if any(
            len(schedule) and {lane for lane, _ in schedule} - on_alone(instance, k)
            for k, schedule in enumerate(optimum(instance).schedules)
        )
    ]
    assert left
    assert any(optimum(one).cost < one.alone_cost.sum() for one in free)


def on_alone(instance, k):
    own = slice(instance.first_pair[k], instance.first_pair[k + 1])
    return set(instance.pair_lane[own][instance.on_alone[own]].tolist())


@pytest.mark.parametrize("seed", range(12))
def test_some_best_plan_needs_no_pair_that_was_dropped(seed):
    instance = random_instance(seed, given=False, trucks=3)
    allowed = set(zip(instance.pair_truck.tolist(), instance.pair_lane.tolist(), strict=True))
    best = optimum(instance)
    assert optimum(instance, only=allowed).cost == best.cost


def test_a_company_pays_for_as_many_platoons_as_it_needs():
    road = {"tail": [0], "head": [1], "drive": [1], "alone": [10], "member": [6], "extra": [3]}
    truck = {"origin": [0], "destination": [1], "earliest": [0], "latest_departure": [5]}
    instance = instance_of(
        {**road, "lane_kind": [0]}, {**truck, "latest": [6], "kind": [0]}, nodes=2
    )
    any_size = [company_cost(instance, 0, n) for n in range(5)]
    assert any_size == [0, 10, 15, 21, 27]
    pairs = replace(instance, largest=2)
    assert [company_cost(pairs, 0, n) for n in range(6)] == [0, 10, 15, 25, 30, 40]
    three = replace(instance, largest=3)
    assert [company_cost(three, 0, n) for n in range(6)] == [0, 10, 15, 21, 30, 36]
