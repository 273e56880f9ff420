"""Searches that are given up or go on later find what one search without a break does."""

import math
from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest
from small_law import SMALL, drawn

import platoon_osm as po
from platoon_osm.driving.state import RESTED, DriverState
from platoon_osm.planning.asked import Asked
from platoon_osm.planning.legal import compared
from platoon_osm.planning.legal.compared import Compared
from platoon_osm.planning.legal.driver.road import NO_LIMIT, road_of
from platoon_osm.planning.legal.legal_question import LegalQuestion
from platoon_osm.planning.legal.platoon import kernel, spans
from platoon_osm.planning.legal.platoon.given_up import leaves, most_gained
from platoon_osm.planning.legal.platoon.real import RoadTrips
from platoon_osm.planning.legal.platoon.search import PlatoonSearch, search_platoon
from platoon_osm.planning.legal.platoon.star_searches import StarSearches, departures_of
from platoon_osm.planning.legal.platoon.star_times import NEVER_S, Span, StarTimes, VehicleRules
from platoon_osm.planning.legal.star_in_time import StarSearch
from platoon_osm.planning.problem import Problem

SIX = datetime(2026, 3, 3, 6)
NORTH, SOUTH = ("Milano", "Torino", "Genova", "Bologna"), ("Roma", "Napoli", "Firenze")


@pytest.fixture
def short_spans(monkeypatch):
    """Let spans of a few seconds be split, too, and be cut into few cells."""
    monkeypatch.setattr(spans, "SPLIT_S", 3)
    monkeypatch.setattr(kernel, "CELLS", 3)


def with_gains(seed, **how):
    """Return a drawn star whose master gains from company, and which members may go alone."""
    one = drawn(seed, **how)
    rng = np.random.default_rng(seed)
    gain = rng.integers(0, 4, len(one.star.node_at) - 1).astype(float)
    one.star = replace(one.star, gain=gain)
    return one, np.array([one.goes_alone(k) for k in range(len(one.star.alone))])


def paid(found):
    return sum(member.cost for member in found.members)


@pytest.mark.parametrize("seed", range(20))
def test_what_is_cheaper_than_the_best_known_is_found(seed, short_spans):
    one, able = with_gains(1000 + seed)

    def found_below(below):
        return search_platoon(
            one.star, one.real, 60, roads=one, in_time=able, extra_stops=2, waits=False,
            below=below,
        )  # fmt: skip

    whole = found_below(math.inf)
    if not math.isfinite(whole.cost):
        return
    for more in (-9.0, -3.0, 0.0, 1.0, 5.0, 40.0):
        below = whole.cost + more
        found = found_below(below)
        assert found.proved
        if more > 0:
            assert paid(found) == pytest.approx(paid(whole))
        if found.timetable is None:
            assert more <= 0
            assert found.bound == pytest.approx(below)
        else:
            assert paid(found) == pytest.approx(paid(whole))


def test_masters_are_given_up():
    """Else the comparison above would compare nothing."""
    given_up, fewer = 0, 0
    for seed in range(20):
        one, able = with_gains(1000 + seed)
        whole = search_platoon(one.star, one.real, 60, in_time=able, waits=False)
        found = search_platoon(
            one.star, one.real, 60, in_time=able, waits=False, below=whole.cost - 9
        )
        given_up += math.isfinite(whole.cost) and found.timetable is None
        fewer += found.spans < whole.spans
    assert min(given_up, fewer) >= 5


def test_a_search_that_goes_on_finds_the_same(short_spans):
    turns = 0
    for seed in range(25):
        one, able = with_gains(1000 + seed)
        whole = search_platoon(one.star, one.real, 60, in_time=able, extra_stops=2, waits=False)
        search = PlatoonSearch(StarSearches(one.star, one.real, None, able, None, 2), None, False)
        found = search.go_on(1)
        while not found.proved:
            assert found.bound <= whole.cost + 1e-9
            turns, found = turns + 1, search.go_on(7)
        assert found.cost == pytest.approx(whole.cost)
        assert paid(found) == pytest.approx(paid(whole))
    assert turns >= 20


def test_a_master_that_needs_another_rest_is_not_given_up_for_it():
    """Its road is closed for longer than a break, and it may not leave later."""
    late = Span(0, 0, 20)
    rules = VehicleRules(SMALL, RESTED, 0)
    star = StarTimes(
        road=road_of([1, 1], [NO_LIMIT] * 3, forbidden=[[], [(0, 8)]]), node_at=np.array([0, 2]),
        window=late, rules=rules, approach_s=np.array([[0, NEVER_S]]),
        onward_s=np.array([[NEVER_S, 0]]), entry=np.array([[0.0, np.inf]]),
        leave=np.array([[np.inf, 0.0]]), platoon=np.array([[0.0, 9.0]]),
        length_m=np.array([0.0, 2e4]), alone=np.array([10.0]), alone_s=np.array([2]),
        windows=(late,), member_rules=(rules,), relief=0.0, master_alone=10.0, gain=np.ones(1),
    )  # fmt: skip
    nothing = road_of([], [NO_LIMIT])
    trips = RoadTrips(star, lambda *_: nothing, lambda *_: nothing)
    searches = StarSearches(star, trips, extra_stops=1)
    assert not leaves(searches, (0, 0), 0)
    assert leaves(searches, (0, 0), 1)
    for below, cost in ((math.inf, 18.0), (18.5, 18.0), (17.0, math.inf)):
        found = search_platoon(star, trips, 60, below=below)
        assert found.proved
        assert found.cost == cost


@pytest.mark.parametrize("seed", range(20))
def test_a_master_leaves_with_company_or_without(seed):
    one, able = with_gains(seed, wide=seed % 2 == 1)
    searches = StarSearches(one.star, one.real, None, able)
    last = departures_of(one.star)
    needs = searches.needs(last[1])
    search = searches.search(needs)
    search.run(*last)
    assert leaves(searches, needs, 0) == (search.found is not None)


def test_no_plan_gains_more_than_is_thought():
    for seed in range(30):
        one, able = with_gains(1000 + seed)
        search = StarSearches(one.star, one.real, None, able).search((1, 0))
        pairs = search.values.pairs
        met = np.zeros(len(one.star.gain), bool)
        for at in range(pairs.first[len(able)]):
            first = search.numbers.first_node
            met[pairs.merge[at] - first : pairs.separate[at] - first] = True
        assert most_gained(search) == pytest.approx(one.star.gain[met].sum())


@pytest.mark.parametrize(("seed", "objective"), [(0, "member"), (1, "member"), (2, "system")])
def test_the_best_master_is_that_of_searches_apart(seed, objective, monkeypatch):
    monkeypatch.setattr(compared, "FIRST_SPANS", 40)
    monkeypatch.setattr(compared, "LEAST_SPANS", 40)
    net = po.load_network("italy-motorways")
    rng = np.random.default_rng(seed)
    trips = [
        po.Trip(
            f"V{k}", str(rng.choice(NORTH)), str(rng.choice(SOUTH)),
            SIX + timedelta(minutes=int(rng.integers(0, 90))), flexibility_min=60.0,
        )
        for k in range(4)
    ]  # fmt: skip
    problem = Problem(
        net, tuple(trips), po.paper_weights(net), rules="eu561", case="C", optimum=objective
    )
    question = Asked.of(problem).question
    legal = LegalQuestion(question, [problem.vehicle_of(trip) for trip in trips])
    stars = sorted(map(question.star, range(4)), key=lambda star: star.bound)
    alone = float(question.solo.sum())
    apart = [StarSearch(legal, star).go_on(10**9) for star in stars]
    assert all(one.timing.proved for one in apart)
    least = min(one.timing.cost for one in apart if one.joined)
    assert least < alone
    found = Compared(legal, None, alone)
    found.search(stars, 10**6)
    assert found.least == pytest.approx(least)
    assert found.best.timing.cost == found.least
    if objective == "member":
        assert found.bound == pytest.approx(least)
        assert not found.unfinished
    assert found.work < sum(one.timing.work for one in apart)
    short = Compared(legal, None, alone)
    short.search(stars, 1)
    assert short.bound <= least + 1e-6
    assert short.unfinished == (short.bound < short.least * (1 - 1e-9))


def test_real_trips_count_by_what_they_take():
    """A team near its limit of a week takes long, and leaves fewer spans to look at."""
    net = po.load_network("italy-motorways")
    worked = []
    for drivers, week in ((1, 0), (2, 44)):
        state = DriverState(drivers=drivers, driven_this_week_s=week * 3600.0)
        trips = [
            po.Trip(f"V{k}", *ends, SIX, flexibility_min=60.0, driver=state)
            for k, ends in enumerate((("Milano", "Napoli"), ("Torino", "Napoli")))
        ]
        problem = Problem(net, tuple(trips), po.paper_weights(net), rules="eu561", case="C")
        legal = LegalQuestion(
            Asked.of(problem).question, [problem.vehicle_of(trip) for trip in trips]
        )
        search = StarSearch(legal, legal.question.star(0))
        timing = search.go_on(2000).timing
        assert timing.asked
        assert timing.work > timing.spans
        worked.append((timing.work - timing.spans) / timing.asked)
    assert worked[1] > worked[0] > 0
