"""The exact model, pairs of trucks and their matching: against every plan there is."""

import itertools
import sys
from types import ModuleType

import networkx as nx
import numpy as np
import pytest
from exhaustive import cost_of, optimum, random_instance

from platoon_osm.errors import PlatoonError, ScenarioError
from platoon_osm.fleets.companies import companies_of
from platoon_osm.fleets.exact import programme_of
from platoon_osm.fleets.exact_process import Solver, exact_fleet
from platoon_osm.fleets.instance import Instance
from platoon_osm.fleets.instants import entries_of
from platoon_osm.fleets.matching import matched, matched_pairs
from platoon_osm.fleets.one_platoon import one_platoon
from platoon_osm.fleets.pairs import PairOffer, candidate_pairs, pair_offers


@pytest.fixture(scope="module")
def solver():
    with Solver() as one:
        yield one


def plan(ways):
    """Lanes and instants of each truck, as the oracle has them."""
    return tuple(
        tuple(zip(own.tolist(), at.tolist(), strict=True)) for own, at in zip(*ways, strict=True)
    )


def drawn(seed, **asked):
    """A tiny fleet whose trucks leave at any time of their windows."""
    return random_instance(seed, departures=False, **asked)


def check_ways(instance, ways):
    for k, own in enumerate(plan(ways)):
        node, at = instance.origin[k], instance.earliest[k]
        assert own[0][1] <= instance.latest_departure[k]
        for lane, enters in own:
            assert instance.tail[lane] == node
            assert enters >= at
            node, at = instance.head[lane], enters + instance.drive[lane]
        assert node == instance.destination[k]
        assert at <= instance.latest[k]


def meeting(routes, leaves):
    """Trucks on a road 0 - 1 - 2 whose pieces take three ticks either way, ten late at most."""
    lanes = {(0, 1): 0, (1, 2): 1, (1, 0): 2, (2, 1): 3}
    tail, head = zip(*lanes, strict=True)
    cost = np.full(4, 10)
    pairs = [
        (k, lanes[step], leaves[k] + 3 * leg, leaves[k] + 3 * leg + 10)
        for k, route in enumerate(routes)
        for leg, step in enumerate(itertools.pairwise(route))
    ]
    # As in open networks, each may also drive back.
    pairs += [
        (k, lanes[route[1], route[0]], leaves[k] + 3, leaves[k] + 9)
        for k, route in enumerate(routes)
    ]
    pairs.sort()
    truck, lane, opens, closes = (np.array(column) for column in zip(*pairs, strict=True))
    count, earliest = len(routes), np.array(leaves)
    return Instance(
        nodes=3, tail=np.array(tail), head=np.array(head), drive=np.full(4, 3), alone=cost,
        member=cost - 3, extra=np.zeros(4, int), lane_kind=np.zeros(4, int),
        origin=np.array([route[0] for route in routes]),
        destination=np.array([route[-1] for route in routes]), earliest=earliest,
        latest_departure=earliest + 10, latest=earliest + 16, kind=np.zeros(count, int), largest=0,
        given=False, waiting=0, first_pair=np.searchsorted(truck, np.arange(count + 1)),
        pair_truck=truck, pair_lane=lane, opens=opens, closes=closes,
        on_alone=np.ones(len(pairs), bool), alone_cost=np.full(count, 20),
    )  # fmt: skip


@pytest.mark.parametrize("seed", range(45))
def test_the_exact_model_finds_the_optimum(seed, solver):
    instance = random_instance(
        seed, trucks=4, largest=(0, 2, 3)[seed % 3], departures=bool(seed // 3 % 2)
    )
    found = exact_fleet(instance, 20.0, solver)
    assert found.proved
    best = int(instance.alone_cost.sum()) - optimum(instance).cost
    assert abs(found.saving - best) <= 1
    assert found.bound >= best
    check_ways(instance, found.ways)
    assert cost_of(instance, plan(found.ways)) == int(instance.alone_cost.sum()) - best


@pytest.mark.parametrize("seed", range(12))
def test_its_linear_relaxation_is_a_bound(seed, solver):
    instance = drawn(seed, trucks=4, largest=(0, 2, 3)[seed % 3])
    values, value, bound = solver.solve(programme_of(instance), 20.0, relaxed=True)
    assert bound == value
    assert len(values) == len(programme_of(instance).gain)
    assert value >= -optimum(instance).cost - 1e-6 * abs(value)


def test_instants_come_from_those_who_go_on_over_the_lane():
    # Trucks leave a road's two ends a tick apart; nobody turns back, so nobody's instant does.
    there, back = (0, 1, 2), (2, 1, 0)
    instance = meeting([there, there, back, back], [0, 1, 0, 1])
    entries = entries_of(instance)
    assert {*zip(entries.lane.tolist(), entries.at.tolist(), strict=True)} == {
        (lane, 3 * leg + late) for lane, leg in ((0, 0), (1, 1), (3, 0), (2, 1)) for late in (0, 1)
    }


def test_the_script_that_asks_is_not_run_again(tmp_path, monkeypatch):
    script = tmp_path / "script.py"
    script.write_text(f"open({str(tmp_path / 'again')!r}, 'w').close()", encoding="utf-8")
    main = ModuleType("__main__")
    main.__file__ = str(script)
    monkeypatch.setitem(sys.modules, "__main__", main)
    assert exact_fleet(drawn(3, trucks=2), 20.0).proved
    assert not (tmp_path / "again").exists()
    assert sys.modules["__main__"] is main


def test_a_model_that_would_be_too_large_is_not_made():
    instance = drawn(3, trucks=4)
    assert entries_of(instance, most=2) is None
    assert programme_of(instance, most=2) is None
    assert exact_fleet(instance, 1.0, most=2) is None


def test_waiting_at_a_price_is_refused_in_one_line():
    instance = random_instance(1, waiting=2)
    for ask in (programme_of, pair_offers):
        with pytest.raises(ScenarioError, match="waiting") as told:
            ask(instance)
        assert "\n" not in str(told.value)


def test_a_solver_that_dies_is_told_and_the_next_question_answered(solver):
    instance = drawn(5, trucks=3)
    assert exact_fleet(instance, 20.0, solver) is not None
    solver._process.kill()
    solver._process.join()
    assert exact_fleet(instance, 20.0, solver) is not None
    with pytest.raises(PlatoonError, match="failed"):
        solver.solve("no programme", 1.0)


# -- pairs of trucks -------------------------------------------------------------------------------


def one_stretch(instance, both):
    """Whether two trucks drive together once, from a merge to a separation."""
    together = set(both[0]) & set(both[1])
    for own in both:
        marks = [entry in together for entry in own]
        begins = sum(now and (k == 0 or not marks[k - 1]) for k, now in enumerate(marks))
        if begins > 1:
            return False
    return True


@pytest.mark.parametrize("seed", range(60))
def test_a_pair_is_planned_as_well_as_by_every_plan(seed):
    instance = drawn(seed, trucks=2, largest=2, kinds=1)
    alone = int(instance.alone_cost.sum())
    best = optimum(instance)
    offers = pair_offers(instance)
    saving = offers[0].saving if offers else 0
    assert saving <= alone - best.cost
    if one_stretch(instance, best.schedules):
        assert saving == alone - best.cost
    for offer in offers:
        ways = (list(offer.lanes), list(offer.departs))
        check_ways(instance, ways)
        assert cost_of(instance, plan(ways)) <= alone - offer.saving


@pytest.mark.parametrize("seed", range(30))
def test_no_pair_that_could_save_is_lost(seed):
    instance = drawn(seed, trucks=4, largest=2)
    found = {tuple(pair) for pair in candidate_pairs(instance).tolist()}
    reach = {}
    for p in range(instance.pairs):
        key = int(instance.pair_lane[p])
        reach.setdefault(key, []).append(p)
    slow = {
        tuple(sorted((int(instance.pair_truck[p]), int(instance.pair_truck[q]))))
        for lane, own in reach.items()
        if 2 * instance.member[lane] + instance.extra[lane] < 2 * instance.alone[lane]
        for p, q in itertools.combinations(own, 2)
        if max(instance.opens[p], instance.opens[q]) <= min(instance.closes[p], instance.closes[q])
    }
    assert found == slow


@pytest.mark.parametrize("seed", range(20))
def test_a_matching_is_as_good_as_that_of_networkx(seed):
    rng = np.random.default_rng(seed)
    none = (np.zeros(0, np.int64),) * 2
    offers = [
        PairOffer(a, b, int(rng.integers(1, 10**12)), none, none)
        for a, b in itertools.combinations(range(9), 2)
        if rng.random() < 0.5
    ]
    graph = nx.Graph()
    graph.add_weighted_edges_from((one.first, one.second, one.saving) for one in offers)
    best = sum(graph.edges[pair]["weight"] for pair in nx.max_weight_matching(graph))
    chosen = matched(9, offers)
    assert sum(one.saving for one in chosen) == best
    used = [k for one in chosen for k in (one.first, one.second)]
    assert len(used) == len(set(used))


@pytest.mark.parametrize("seed", range(25))
def test_one_platoon_a_trip_is_the_best_choice_of_pairs(seed):
    instance = drawn(seed, trucks=5, largest=2)
    apart = [(0, 1), (2, 4)] if seed % 2 else []
    worth = {
        (one.first, one.second): one.saving
        for one in pair_offers(instance)
        if (one.first, one.second) not in apart
    }

    def best(trucks):
        if len(trucks) < 2:
            return 0
        first, *others = trucks
        without = best(others)
        return max(
            [without]
            + [
                worth[first, other] + best([k for k in others if k != other])
                for other in others
                if (first, other) in worth
            ]
        )

    lanes, departs, saving = matched_pairs(instance, apart=apart)
    assert saving == best(list(range(5)))
    check_ways(instance, (lanes, departs))


def test_nobody_has_a_second_platoon_by_accident():
    """Trucks that leave one place at one minute are in pairs, or alone."""
    planned = 0
    for seed in range(12):
        instance = drawn(seed, trucks=5, largest=2, slack=3000)
        try:
            (lanes, departs), saving = one_platoon(instance, seed)
        except ScenarioError:
            continue  # a window of no ticks to spare
        planned += 1
        assert saving >= 0
        for own in companies_of(instance, lanes, departs):
            assert len({company for company in own if len(company) > 1}) <= 1
    assert planned > 6


def test_trucks_that_keep_apart_are_no_pair():
    kept = 0
    for seed in range(12):
        instance = drawn(seed, trucks=5, largest=2, slack=3000)
        offers = pair_offers(instance)
        if not offers:
            continue
        best = max(offers, key=lambda one: one.saving)
        apart = [(best.first, best.second)]
        try:
            (lanes, departs), saving = one_platoon(instance, seed, apart=apart)
            free = one_platoon(instance, seed)[1]
        except ScenarioError:
            continue  # a window of no ticks to spare
        assert saving <= free
        kept += 1
        met = {company for own in companies_of(instance, lanes, departs) for company in own}
        assert apart[0] not in met
    assert kept > 3
