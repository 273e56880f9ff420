"""The search of a fleet's plan against enumeration, and what every plan of it keeps."""

from __future__ import annotations

import itertools
from collections import Counter
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from exhaustive import cost_of, instance_of, optimum, random_instance
from soak import chosen, soaked
from tiny_fleets import all_schedules

from platoon_osm.errors import ScenarioError
from platoon_osm.fleets.plan.schedules import Schedules
from platoon_osm.fleets.plan.search import FleetSearch

SEEDS = chosen(range(10), range(2000))


def searched(instance, seed=0, threads=1, rounds=4, moves=40, apart=None):
    search = FleetSearch(instance, threads=threads, seed=seed, apart=apart)
    search.construct(None, None)
    for r in range(rounds):
        search.improve(None, None, moves, 1 - r / max(rounds - 1, 1), lambda: False)
    return search


def as_tuples(plan):
    return tuple(
        tuple(
            zip(
                plan.lanes[k, : plan.count[k]].tolist(),
                plan.departs[k, : plan.count[k]].tolist(),
                strict=True,
            )
        )
        for k in range(len(plan.count))
    )


@soaked
def test_the_search_finds_the_optimum_of_tiny_fleets_and_never_goes_below_it():
    missed = 0
    for seed in SEEDS:
        waiting = (0, 3, 0, 1)[seed % 4]
        instance = random_instance(seed, waiting=waiting, trucks=2 + seed % 3 if waiting else None)
        search = searched(instance, seed)
        search.best.check(instance)
        least = optimum(instance).cost
        assert search.cost >= least
        assert search.cost == search.best.cost(instance) == cost_of(
            instance, as_tuples(search.best)
        )  # fmt: skip
        missed += search.cost > least
    assert missed <= len(SEEDS) // 100


@soaked
def test_one_truck_alone_with_the_rest_fixed_drives_what_no_other_schedule_beats():
    """All but one truck are bound to their schedules by windows without slack."""
    tried = 0
    for seed in SEEDS:
        instance = random_instance(seed, trucks=4, given=True, waiting=(0, 1, 4)[seed % 3])
        plan = searched(instance, seed, rounds=1).best
        opens, closes = instance.opens.copy(), instance.closes.copy()
        for p in range(instance.pairs):
            k = instance.pair_truck[p]
            if k > 0:
                at = plan.lanes[k, : plan.count[k]].tolist().index(instance.pair_lane[p])
                opens[p] = closes[p] = plan.departs[k, at]
        bound = replace(instance, opens=opens, closes=closes)
        fixed = as_tuples(plan)[1:]
        window = {int(bound.pair_lane[p]): p for p in range(*bound.first_pair[:2])}
        route = [lane for lane, _ in as_tuples(plan)[0]]
        spans = [range(opens[window[one]], closes[window[one]] + 1) for one in route]
        drives = [int(instance.drive[one]) for one in route]
        ways = [
            tuple(zip(route, times, strict=True))
            for times in itertools.product(*spans)
            if all(a + d <= b for a, d, b in zip(times, drives, times[1:], strict=False))
        ]
        search = searched(bound, seed, rounds=1, moves=4)
        assert search.cost == min(cost_of(bound, (way, *fixed)) for way in ways)
        tried += len(ways) > 1
    assert tried > len(SEEDS) // 3


def day(trucks, largest=0, seed=1, hours=24):
    """Return trucks on one long road of six lanes, both ways, over a day in minutes."""
    rng = np.random.default_rng(seed)
    nodes, minutes = 7, 30
    ahead = [(i, i + 1) for i in range(nodes - 1)]
    roads = ahead + [(b, a) for a, b in ahead]
    lanes = {
        "tail": [a for a, _ in roads], "head": [b for _, b in roads],
        "drive": [minutes] * len(roads), "alone": [300] * len(roads),
        "member": [270] * len(roads), "extra": [30] * len(roads),
        "lane_kind": [0] * len(roads),
    }  # fmt: skip
    ends = [sorted(rng.choice(nodes, 2, replace=False).tolist()) for _ in range(trucks)]
    ends = [pair if rng.random() < 0.5 else pair[::-1] for pair in ends]
    earliest = rng.integers(0, 60 * hours, trucks).tolist()
    latest = [
        at + minutes * abs(a - b) + 40 for at, (a, b) in zip(earliest, ends, strict=True)
    ]  # fmt: skip
    wanted = {
        "origin": [a for a, _ in ends], "destination": [b for _, b in ends],
        "earliest": earliest, "latest_departure": latest, "latest": latest,
        "kind": [0] * trucks,
    }  # fmt: skip
    return instance_of(lanes, wanted, nodes=nodes, largest=largest)


@pytest.mark.parametrize(("largest", "waiting"), [(0, 0), (3, 0), (0, 1)])
def test_any_number_of_threads_gives_the_same_plan_and_costs_kept_are_costs_counted(
    largest, waiting
):
    instance = replace(day(130, largest), waiting=waiting)
    plans = [searched(instance, 5, threads, rounds=3, moves=60) for threads in (1, 2, 4)]
    slabs = plans[0]._slabs()
    assert len(slabs) == 2, "the day is not cut, so that threads have nothing to share"
    for one in plans:
        one.best.check(instance)
        assert one.cost == one.best.cost(instance)
        assert one._current == one._now().cost(instance)
        assert as_tuples(one.best) == as_tuples(plans[0].best)
    assert plans[0].cost < instance.alone_cost.sum() - 100
    sizes = plans[0].best.companies()[2]
    assert sizes.max() > 1
    other = searched(instance, 6, rounds=3, moves=60)
    assert as_tuples(other.best) != as_tuples(plans[0].best)


def test_the_order_of_trucks_changes_nothing_at_the_optimum():
    instance = random_instance(11, trucks=5, given=False)
    order = np.array([3, 0, 4, 1, 2])
    columns = ("origin", "destination", "earliest", "latest_departure", "latest", "kind")
    which = np.concatenate(
        [np.arange(instance.first_pair[k], instance.first_pair[k + 1]) for k in order]
    )
    back = np.argsort(order)
    truck = back[instance.pair_truck[which]]
    turned = replace(
        instance, **{name: getattr(instance, name)[order] for name in columns},
        alone_cost=instance.alone_cost[order],
        first_pair=np.searchsorted(truck, np.arange(6)), pair_truck=truck,
        **{
            name: getattr(instance, name)[which]
            for name in ("pair_lane", "opens", "closes", "on_alone")
        },
    )  # fmt: skip
    assert searched(instance).cost == searched(turned).cost == optimum(instance).cost


@soaked
def test_who_must_keep_apart_never_enters_a_lane_with_the_other():
    met = 0
    for seed in SEEDS:
        instance = random_instance(seed, trucks=4, kinds=1, waiting=(0, 2)[seed % 2])
        plan = as_tuples(searched(instance, seed).best)
        met += bool(set(plan[0]) & set(plan[1]))
        # Told of one of the two alone.
        apart = (np.array([0, 1, 1, 1, 1]), np.array([1]))
        if not any(
            set(one).isdisjoint(other)
            for one in all_schedules(instance, 0)
            for other in all_schedules(instance, 1)
        ):
            with pytest.raises(ScenarioError, match="must keep apart from others"):
                FleetSearch(instance, seed=seed, apart=apart)
            continue
        search = searched(instance, seed, apart=apart)
        search.best.check(instance)
        kept = as_tuples(search.best)
        assert not set(kept[0]) & set(kept[1])
        assert search.cost == cost_of(instance, kept) >= optimum(instance).cost
    assert met


@pytest.mark.parametrize("seed", [70, 338])
def test_another_order_is_tried_where_the_first_leaves_somebody_no_way(seed):
    instance = random_instance(seed, trucks=4, kinds=1)
    search = FleetSearch(instance, seed=seed, apart=(np.array([0, 1, 1, 1, 1]), np.array([1])))
    kept = as_tuples(search.best)
    assert set(kept[0]).isdisjoint(kept[1])


def test_two_who_leave_one_place_at_one_instant_cannot_keep_apart():
    road = {"tail": [0], "head": [1], "drive": [3], "alone": [10], "member": [9], "extra": [1]}
    trucks = {name: [0, 0] for name in ("origin", "earliest", "latest_departure", "kind")}
    instance = instance_of(
        {**road, "lane_kind": [0]}, {**trucks, "destination": [1, 1], "latest": [9, 9]}, nodes=2
    )
    apart = (np.array([0, 1, 2]), np.array([1, 0]))
    with pytest.raises(ScenarioError, match="must keep apart from others"):
        FleetSearch(instance, apart=apart)


def test_companies_are_limited_and_shares_guide_the_first_plan():
    """Shares say where platoons form: free at one instant, as dear as alone at all others."""
    road = {"tail": [0], "head": [1], "drive": [10], "alone": [10], "member": [8], "extra": [2]}
    three = {"origin": [0] * 3, "destination": [1] * 3, "kind": [0] * 3}
    window = {"earliest": [0, 4, 5], "latest_departure": [9] * 3, "latest": [19] * 3}
    instance = instance_of({**road, "lane_kind": [0]}, {**three, **window}, nodes=2)
    shares = SimpleNamespace(
        starts=np.array([0, 4, 7, 8]), pairs=np.arange(3), first_bucket=np.array([0, 1, 1]),
        first_share=np.array([0, 4, 7, 10]),
        share=np.array([2.0, 2, 0.5, 2, 2, 0.5, 2, 2, 0.5, 2]),
    )  # fmt: skip
    guide = SimpleNamespace(
        least=np.full(3, 0.5), cost=np.full(3, 8.5), lanes=np.zeros((3, 1), np.int32),
        count=np.ones(3, np.int64),
    )  # fmt: skip
    search = FleetSearch(instance)
    search.construct(shares, guide)
    search.improve(shares, guide, 5, 0.5, lambda: False)
    assert Counter(as_tuples(search.best)) == {((0, 7),): 3}
    assert search.cost == 26


def test_warming_up_calls_every_kernel(monkeypatch):
    """Each is told to be compiled, and then run on arrays such as it will meet."""
    from platoon_osm.fleets.plan import compiled, kernels, margin, slabs, sweeps, warmth

    called = []

    class Plain:
        def __init__(self, name):
            self.run = getattr(kernels, name)
            self.name = name

        def now(self):
            called.append(("now", self.name))

        def ready(self, _):
            called.append(("run", self.name))
            return self.run

    for name, kernel in (("EXPLORE", "explore"), ("SWEEP", "sweep"), ("THROUGH", "through_pairs")):
        for module in (compiled, margin, slabs, sweeps, warmth):
            if hasattr(module, name):
                monkeypatch.setattr(module, name, Plain(kernel))
    warmth.warm_up()
    assert set(called) == {
        (what, name) for what in ("now", "run") for name in ("explore", "sweep", "through_pairs")
    }


def test_schedules_that_are_no_plan_are_refused():
    instance = day(3)
    plan = searched(instance, rounds=1, moves=1).best
    late = plan.departs.copy()
    late[0, 0] += 500
    early = plan.departs.copy()
    early[1, 0] = instance.earliest[1] - 1
    short = plan.count.copy()
    short[2] -= 1
    for departs, count, told in (
        (late, plan.count, "truck 0"),
        (early, plan.count, "truck 1"),
        (plan.departs, short, "truck 2"),
    ):  # fmt: skip
        with pytest.raises(ScenarioError, match=told):
            Schedules(plan.lanes, departs, count).check(instance)
