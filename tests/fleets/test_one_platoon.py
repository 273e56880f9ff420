"""One platoon a trip, of any size: against everything that could be driven."""

import itertools
from collections import Counter

import numpy as np
import pytest
from exhaustive import cost_of, random_instance
from one_platoon_by_hand import best_choice, is_one_platoon
from soak import chosen, soaked

from platoon_osm.fleets.bound.bound import Bound
from platoon_osm.fleets.companies import companies_of
from platoon_osm.fleets.exact_process import Solver
from platoon_osm.fleets.growing import grown
from platoon_osm.fleets.joining import Joining
from platoon_osm.fleets.one_group import group_of
from platoon_osm.fleets.one_platoon import one_platoon
from platoon_osm.fleets.packing import FEW, packed
from platoon_osm.fleets.pairs import pair_offers


def drawn(seed, **asked):
    """A tiny fleet on few nodes, in which many could drive together."""
    leader = (False, True, None)[seed % 3 if seed % 2 else 0]
    given = {"largest": (0, 3, 4)[seed % 3], "slack": 3, "kinds": 1, "nodes": 4, "leader": leader}
    given["departures"] = seed % 4 == 0
    return random_instance(seed, **(given | asked))


def schedules(lanes, departs):
    return tuple(
        tuple(zip(own.tolist(), at.tolist(), strict=True))
        for own, at in zip(lanes, departs, strict=True)
    )


def check_group(instance, group):
    """A platoon is one, in time, and saves what it says."""
    own = schedules(group.lanes, group.departs)
    assert is_one_platoon(instance, own)
    assert len(group.trucks) <= (instance.largest or instance.trucks)
    alone = int(instance.alone_cost[list(group.trucks)].sum())
    assert alone - cost_of(instance, own) == group.saving
    for k, drives in zip(group.trucks, own, strict=True):
        node, at = instance.origin[k], instance.earliest[k]
        assert drives[0][1] <= instance.latest_departure[k]
        for lane, enters in drives:
            assert instance.tail[lane] == node
            assert enters >= at
            node, at = instance.head[lane], enters + instance.drive[lane]
        assert node == instance.destination[k]
        assert at <= instance.latest[k]


def compared(seeds, trucks):
    """What was found beside the best there is, and how many of them are of three and more."""
    equal, larger = 0, 0
    for seed in seeds:
        instance = drawn(seed, trucks=trucks)
        apart = [(0, 1), (1, 3)] if seed % 5 == 0 else []
        groups = grown(instance, apart=apart)
        for group in groups:
            check_group(instance, group)
            assert not any({*pair} <= {*group.trucks} for pair in apart)
        used = [k for group in groups for k in group.trucks]
        assert len(used) == len(set(used))
        saving, best = sum(group.saving for group in groups), best_choice(instance, apart)
        assert saving <= best
        assert instance.alone_cost.sum() - Bound(instance).cost >= best - 1e-6
        equal += saving == best
        larger += any(len(group.trucks) > 2 for group in groups)
    return equal, larger


CASES = [(range(60), 4), (range(60, 84), 5)]
ALL_CASES = [*CASES, (range(100, 700), 5), (range(1000, 1120), 6)]


@soaked
@pytest.mark.parametrize(("seeds", "trucks"), chosen(CASES, ALL_CASES))
def test_platoons_of_any_size_against_everything(seeds, trucks):
    equal, larger = compared(seeds, trucks)
    assert equal >= 0.95 * len(seeds)
    assert larger >= 0.15 * len(seeds)


def test_whoever_joins_saves_what_was_told():
    joins = 0
    for seed in range(150):
        instance = drawn(seed, trucks=5, largest=0, slack=4, nodes=(4, 6)[seed % 2])
        joining = Joining(instance)
        for one in pair_offers(instance):
            pair = (one.first, one.second)
            group = group_of(instance, joining.windows, pair, one.lanes, one.departs)
            others = [k for k in range(5) if k not in pair]
            for _ in range(3):
                gains = joining.gains(group, others).tolist()
                for k, gain in zip(others, gains, strict=True):
                    more = joining.joined(group, k)
                    assert (more is None) == (gain == 0)
                    if more is not None:
                        check_group(instance, more)
                        assert more.saving >= group.saving + gain
                if max(gains, default=0) == 0:
                    break
                k = others.pop(int(np.argmax(gains)))
                group = joining.joined(group, k)
                joins += 1
    assert joins > 60


def test_a_platoon_that_saves_too_little_is_not_driven():
    fewer = 0
    for seed in range(40):
        instance = drawn(seed, trucks=5)
        found = grown(instance)
        if not found:
            continue
        least = max(group.saving for group in found)
        kept = grown(instance, least=least)
        assert all(group.saving >= least for group in kept)
        assert kept
        fewer += len(kept) < len(found)
    assert fewer > 3


def test_nobody_drives_with_two_platoons():
    """Trucks of one place and minute, beside platoons of three at most."""
    for seed in range(12):
        instance = drawn(seed, trucks=6, largest=3, slack=3000, departures=False)
        groups = grown(instance)
        (lanes, departs), saving = one_platoon(instance, seed)
        assert saving == sum(group.saving for group in groups)
        of = {k: group.trucks for group in groups for k in group.trucks}
        for k, own in enumerate(companies_of(instance, lanes, departs)):
            assert {*itertools.chain(*own)} <= {k, *of.get(k, ())}
        again, same = one_platoon(instance, seed)
        assert same == saving
        assert schedules(*again) == schedules(lanes, departs)


def test_a_choice_of_many_is_as_good_as_that_of_few():
    """The solver chooses as well as going through all sets does."""
    instance = drawn(2, trucks=6, largest=0)
    some = next(iter(grown(drawn(7, trucks=5))))
    rng = np.random.default_rng(3)
    with Solver() as solver:
        for count in (FEW - 2, FEW + 8):
            groups = []
            for size in rng.integers(2, 5, 24):
                trucks = tuple(sorted(rng.choice(count, size, replace=False).tolist()))
                saving = int(rng.integers(1, 100))
                groups.append(type(some)(trucks, saving, (), (), (), (), 0))
            found = packed(groups, (), solver, None)
            used = Counter(k for group in found for k in group.trucks)
            assert max(used.values()) == 1
            best = 0
            todo = [(0, frozenset(), 0)]
            while todo:
                at, taken, sum_ = todo.pop()
                best = max(best, sum_)
                for i in range(at, len(groups)):
                    if taken.isdisjoint(groups[i].trucks):
                        more = taken | {*groups[i].trucks}
                        todo.append((i + 1, more, sum_ + groups[i].saving))
            assert sum(group.saving for group in found) == best
    assert instance.trucks == 6
