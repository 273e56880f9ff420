"""Merge trees and shared legs against all plans of their class, and against exact pairs."""

from __future__ import annotations

import itertools
from collections import Counter, defaultdict
from dataclasses import replace

import numpy as np
import pytest
from exhaustive import company_cost, cost_of, instance_of, optimum, random_instance, schedules_of
from soak import chosen

from platoon_osm.errors import ScenarioError
from platoon_osm.fleets.pairs import pair_offers
from platoon_osm.fleets.plan.schedules import Schedules
from platoon_osm.fleets.plan.search import FleetSearch
from platoon_osm.fleets.trees.merge_trees import merge_tree, shared_leg
from platoon_osm.fleets.trees.starting import tree_start

SEEDS = chosen(range(14), range(150))
MOST_PLANS = 2500


def tuples_of(tree):
    return tuple(
        tuple(zip(lanes.tolist(), departs.tolist(), strict=True))
        for lanes, departs in zip(tree.lanes, tree.departs, strict=True)
    )


def schedules_from(instance, tree):
    """Return the schedules of a tree that names all trucks in their order."""
    width = max(len(own) for own in tree.lanes)
    lanes = np.zeros((instance.trucks, width), np.int32)
    departs = np.zeros((instance.trucks, width), np.int64)
    for k, (own, at) in enumerate(zip(tree.lanes, tree.departs, strict=True)):
        lanes[k, : len(own)], departs[k, : len(own)] = own, at
    return Schedules(lanes, departs, np.array([len(own) for own in tree.lanes]))


def connected(companies):
    """Return the sets of trucks that are linked by companies."""
    sets = []
    for company in companies:
        linked = [one for one in sets if one & company]
        sets = [one for one in sets if not one & company]
        sets.append(frozenset(company.union(*linked)))
    return sets


def present(instance, plan, k):
    """Return where a truck is from when to when, beside what it does before and after."""
    at, now = int(instance.origin[k]), int(instance.earliest[k])
    for place, (lane, depart) in enumerate(plan[k]):
        yield at, now, depart, place
        at, now = int(instance.head[lane]), depart + int(instance.drive[lane])
    yield at, now, int(instance.latest[k]), len(plan[k])


def is_tree(instance, plan, company_of, members):
    """Tell whether trucks are all somewhere at once, and only ever meet before and part after."""
    stays = [list(present(instance, plan, k)) for k in members]
    for chosen_stays in itertools.product(*stays):
        if len({node for node, *_ in chosen_stays}) > 1:
            continue
        if max(begin for _, begin, _, _ in chosen_stays) > min(
            end for _, _, end, _ in chosen_stays
        ):
            continue
        fits = True
        for k, (*_, place) in zip(members, chosen_stays, strict=True):
            there = [company_of[entry] for entry in plan[k][:place]]
            onward = [company_of[entry] for entry in plan[k][place:]]
            fits &= all(a <= b for a, b in itertools.pairwise(there))
            fits &= all(a >= b for a, b in itertools.pairwise(onward))
        if fits:
            return True
    return False


def is_leg(plan, company_of, members):
    """Tell whether trucks are alone, then all together, then alone."""
    for k in members:
        sizes = [len(company_of[entry]) for entry in plan[k]]
        where = [place for place, size in enumerate(sizes) if size > 1]
        if not where or where[-1] - where[0] + 1 != len(where):
            return False
        if any(sizes[place] != len(members) for place in where):
            return False
    return True


def companies_in(plan):
    company_of = defaultdict(set)
    for k, own in enumerate(plan):
        for entry in own:
            company_of[entry].add(k)
    return {entry: frozenset(own) for entry, own in company_of.items()}


def paid(instance, plan, beside):
    """Return what companies pay more than those of others alone."""
    together = Counter(entry for own in plan for entry in own)
    return sum(
        company_cost(instance, lane, n + beside.get((lane, at), 0))
        - company_cost(instance, lane, beside.get((lane, at), 0))
        for (lane, at), n in together.items()
    )


def least_of_classes(instance, choices, beside):
    """Return the least costs of trees and of legs among all plans."""
    tree, leg = None, None
    pairs = set(zip(instance.pair_truck.tolist(), instance.pair_lane.tolist(), strict=True))
    for plan in itertools.product(*choices):
        cost = paid(instance, plan, beside)
        better = tree is None or cost < tree or leg is None or cost < leg
        if not better:
            continue
        company_of = companies_in(plan)
        if (tree is None or cost < tree) and all(
            is_tree(instance, plan, company_of, sorted(members))
            for members in connected(company_of.values())
        ):
            tree = cost
        # No leg drags a truck along that had better drive alone: such pairs were dropped.
        kept = {(k, lane) for k, own in enumerate(plan) for lane, _ in own} <= pairs
        if (leg is None or cost < leg) and kept and is_leg(plan, company_of, range(len(plan))):
            leg = cost
    return tree, leg


def dear_and_quick(seed, trucks, largest):
    """Return an instance in which the cheapest way is hardly ever the quickest."""
    rng = np.random.default_rng([seed, 17])
    roads = [(a, b) for a in range(4) for b in range(4) if a != b and rng.random() < 0.45]
    roads += [(a, a + 1) for a in range(3)]
    drive = rng.integers(1, 5, len(roads))
    alone = 100 - 20 * drive + rng.integers(0, 5, len(roads))
    member = alone - rng.integers(1, alone // 3)
    origin = rng.integers(0, 2, trucks)
    earliest = rng.integers(0, 4, trucks)
    latest = earliest + 9
    columns = {
        "tail": [a for a, _ in roads], "head": [b for _, b in roads], "drive": drive,
        "alone": alone, "member": member, "extra": alone - member, "lane_kind": 0 * drive,
    }  # fmt: skip
    wanted = {
        "origin": origin, "destination": origin + 2, "earliest": earliest,
        "latest_departure": latest, "latest": latest, "kind": 0 * origin,
    }  # fmt: skip
    return instance_of(columns, wanted, nodes=4, largest=largest or 0)


def small(seed, largest=None):
    """Return an instance whose plans can all be looked at, and the schedules of each truck."""
    for draw in itertools.count(1000 * seed):
        if seed % 2:
            instance = dear_and_quick(draw, 3, largest)
        else:
            instance = random_instance(draw, trucks=3 + seed // 2 % 2, slack=4, largest=largest)
        choices = schedules_of(instance)
        if 20 < np.prod([len(own) for own in choices], dtype=float) <= MOST_PLANS:
            return instance, choices
    raise AssertionError


@pytest.mark.parametrize("seed", SEEDS)
def test_no_plan_of_the_class_costs_less(seed):
    instance, choices = small(seed)
    everyone = range(instance.trucks)
    found = merge_tree(instance, everyone)
    tree, leg = least_of_classes(instance, choices, {})
    real = cost_of(instance, tuples_of(found))
    schedules_from(instance, found).check(instance)
    assert optimum(instance).cost <= real <= found.cost <= tree
    if real == found.cost:
        assert found.cost == tree
    assert found.saving == instance.alone_cost.sum() - found.cost >= 0
    if not instance.largest or instance.trucks <= instance.largest:
        once = shared_leg(instance, everyone)
        saves = leg is not None and leg < instance.alone_cost.sum()
        assert once is not None or not saves
        if once is not None:
            at_once = cost_of(instance, tuples_of(once))
            assert max(at_once, found.cost) <= once.cost
            # Who drives together by accident beside the leg makes no plan of its class.
            assert at_once < once.cost or once.cost == leg
            assert leg is None or once.cost <= leg
            schedules_from(instance, once).check(instance)


@pytest.mark.parametrize("seed", SEEDS)
def test_beside_others_no_plan_of_the_class_costs_less(seed):
    instance, choices = small(seed, largest=0)
    best = optimum(instance)
    rng = np.random.default_rng(seed)
    count = 1 + int(rng.integers(instance.trucks - 1))
    some = rng.permutation(instance.trucks)[:count].tolist()
    beside = Counter(
        entry for k, own in enumerate(best.schedules) if k not in some for entry in own
    )
    rows = np.array([(*entry, n) for entry, n in sorted(beside.items())], np.int64).reshape(-1, 3)
    found = merge_tree(instance, some, (rows[:, 0], rows[:, 1], rows[:, 2]))
    # The class looks at the trucks of the group by their numbers in it.
    own = replace(
        instance, origin=instance.origin[some], destination=instance.destination[some],
        earliest=instance.earliest[some], latest=instance.latest[some],
        latest_departure=instance.latest_departure[some], kind=instance.kind[some],
        alone_cost=instance.alone_cost[some], first_pair=np.zeros(count + 1),
    )  # fmt: skip
    tree, _ = least_of_classes(own, [choices[k] for k in some], beside)
    real = paid(instance, tuples_of(found), beside)
    assert real <= found.cost <= tree
    if real == found.cost:
        assert found.cost == tree
    # The rest of an optimal plan leaves no better one.
    assert real >= paid(instance, [best.schedules[k] for k in some], beside)


@pytest.mark.parametrize("seed", SEEDS)
def test_two_are_planned_as_pairs_are(seed):
    instance = random_instance(seed)
    known = {(offer.first, offer.second): offer.saving for offer in pair_offers(instance)}
    for one, other in itertools.combinations(range(instance.trucks), 2):
        leg = shared_leg(instance, [other, one])
        assert merge_tree(instance, [one, other]).saving == known.get((one, other), 0)
        assert (leg.saving if leg else 0) == known.get((one, other), 0)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_order_of_trucks_changes_nothing(seed):
    instance = random_instance(seed, trucks=5, nodes=6, largest=0)
    order = np.random.default_rng(seed).permutation(5)
    one, other = (merge_tree(instance, trucks) for trucks in (range(5), order))
    assert one.cost == other.cost
    legs = [shared_leg(instance, trucks) for trucks in (range(5), order)]
    assert len({None if leg is None else leg.cost for leg in legs}) == 1
    if legs[0] is not None:
        assert one.cost <= legs[0].cost


def comb(number):
    """Return a road along which trucks join one by one, and then leave one by one."""
    road = [(k, k + 1) for k in range(2 * number)]
    ramps = [(100 + k, k) for k in range(number)] + [
        (number + 1 + k, 200 + k) for k in range(number)
    ]
    ends = sorted({node for lane in road + ramps for node in lane})
    lanes = road + ramps
    count = len(lanes)
    columns = {
        "tail": [ends.index(a) for a, _ in lanes], "head": [ends.index(b) for _, b in lanes],
        "drive": [10] * count, "alone": [100] * count, "member": [90] * count,
        "extra": [10] * count, "lane_kind": [0] * count,
    }  # fmt: skip
    trucks = {
        "origin": [ends.index(100 + k) for k in range(number)],
        "destination": [ends.index(200 + number - 1 - k) for k in range(number)],
        "earliest": [7 * k for k in range(number)], "latest_departure": [500] * number,
        "latest": [500] * number, "kind": [0] * number,
    }  # fmt: skip
    return instance_of(columns, trucks, nodes=len(ends))


def test_eight_that_join_and_leave_one_by_one_are_together_as_long_as_they_can_be():
    instance = comb(8)
    tree = merge_tree(instance, range(8))
    # The first drives all of the road, which is 16 lanes, the last one two lanes of it.
    driven = [len(lanes) - 2 for lanes in tree.lanes]
    assert driven == [16, 14, 12, 10, 8, 6, 4, 2]
    assert tree.sets == (tuple(range(8)),)
    assert tree.saving == sum(10 * on_road for on_road in driven[1:])
    assert cost_of(instance, tuples_of(tree)) == tree.cost
    leg = shared_leg(instance, range(8))
    assert leg is not None
    assert leg.saving == 7 * 20


def test_what_no_tree_is_planned_for_is_refused():
    instance = comb(9)
    with pytest.raises(ScenarioError, match="1 to 8 trucks"):
        merge_tree(instance, range(9))
    with pytest.raises(ScenarioError, match="each named once"):
        merge_tree(instance, [1, 1])
    with pytest.raises(ScenarioError, match="none of the 9"):
        merge_tree(instance, [1, 9])
    with pytest.raises(ScenarioError, match="waiting no price"):
        merge_tree(replace(instance, waiting=1), [0, 1])
    with pytest.raises(ScenarioError, match="1 to 3 trucks"):
        shared_leg(replace(instance, largest=3), range(4))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_search_goes_on_from_a_tree(seed):
    instance = random_instance(seed, trucks=4, largest=0)
    search = FleetSearch(instance)
    before = search.cost
    start = tree_start(instance)
    assert start is not None
    search.take(*start)
    tree = merge_tree(instance, range(4))
    assert search.cost == min(before, cost_of(instance, tuples_of(tree)))
    search.best.check(instance)
    assert search.best.cost(instance) == search.cost
    search.improve(None, None, 20, 0.0, lambda: False)
    search.best.check(instance)
    assert optimum(instance).cost <= search.best.cost(instance) == search.cost <= tree.cost


def test_many_trucks_or_a_price_of_waiting_begin_with_no_tree():
    assert tree_start(comb(9)) is None
    assert tree_start(replace(comb(3), waiting=1)) is None
