"""A platoon under the law against every stop, departure, pair of points and second of standing."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from small_law import NO_PARTS, all_stops, drawn

from platoon_osm.driving.state import RESTED
from platoon_osm.driving.us395 import US395
from platoon_osm.planning.legal.driver.road import NO_LIMIT, road_of
from platoon_osm.planning.legal.platoon import kernel, spans
from platoon_osm.planning.legal.platoon.again import Again, joined_again
from platoon_osm.planning.legal.platoon.asked import AskedTrips
from platoon_osm.planning.legal.platoon.kernel import evaluate
from platoon_osm.planning.legal.platoon.numbers import numbers_of_star
from platoon_osm.planning.legal.platoon.own_places import entries_by_places, exits_by_places
from platoon_osm.planning.legal.platoon.own_ways import plain_ways
from platoon_osm.planning.legal.platoon.pairs import pairs_of_star
from platoon_osm.planning.legal.platoon.real import RoadTrips
from platoon_osm.planning.legal.platoon.record import MASTER, Timetable
from platoon_osm.planning.legal.platoon.search import choices_of, search_platoon
from platoon_osm.planning.legal.platoon.spans import SpanSearch
from platoon_osm.planning.legal.platoon.star_times import NEVER_S, Span, StarTimes, VehicleRules
from platoon_osm.planning.legal.platoon.stops import MasterStops
from platoon_osm.planning.legal.platoon.tables import OwnTables
from platoon_osm.planning.legal.platoon.values import StarValues


@pytest.fixture(autouse=True)
def short_spans(monkeypatch):
    """Let spans of a few seconds be split, too, and be cut into few cells."""
    monkeypatch.setattr(spans, "SPLIT_S", 3)
    monkeypatch.setattr(kernel, "CELLS", 3)


def pairs_of(star, member):
    nodes = range(len(star.node_at))
    cost = star.entry[member][:, None] + star.leave[member] + np.subtract.outer(
        -star.platoon[member], -star.platoon[member]
    )  # fmt: skip
    return sorted((cost[i, j], i, j) for i in nodes for j in nodes if i < j)


def cheapest(one, table, alone, member, known):
    """Try all pairs, the cheapest first."""
    star = one.star
    for cost, i, j in pairs_of(star, member):
        if cost >= alone[member]:
            break
        low, high = star.node_at[i], star.node_at[j]
        key = member, i, j, table.stops, tuple(table.leave_s[low:high])
        if key not in known:
            known[key] = one.real(member, i, j, table) is not None
        if known[key]:
            return cost
    return alone[member]


def everything(one, rests=0):
    """Return the least cost of members over all stops and departures; inf if there is none."""
    star = one.star
    members = range(len(star.alone))
    alone = [star.alone[k] if one.goes_alone(k) else math.inf for k in members]
    best, known = math.inf, {}
    drive = int(star.road.drive_s.sum())
    for stops in all_stops(star, rests):
        stood = sum(length for _, length in stops)
        last = min(star.window.latest_s, star.window.arrival_s - drive - stood)
        for departure in range(star.window.earliest_s, last + 1):
            table = Timetable.of(star, departure, stops)
            if one.real(MASTER, 0, 0, table) is not None:
                best = min(best, sum(cheapest(one, table, alone, k, known) for k in members))
    return best, alone


KINDS = {
    "rest only where it may": {},
    "rest anywhere": {"everywhere": True},
    "half relieved": {"relief": 0.5},
    "fully relieved": {"relief": 1.0},
    "no break in parts": {"limits": NO_PARTS},
    "a night on the way": {"night": True},
}


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_cheaper_than_what_is_found(kind, seed):
    one = drawn(1000 + seed, **KINDS[kind])
    rests = int(kind == "a night on the way")
    best, alone = everything(one, rests)
    found = search_platoon(
        one.star, one.real, 60, roads=one, in_time=np.isfinite(alone), extra_stops=6
    )
    assert found.proved
    if math.isinf(best) and not rests:
        # A rest more than its driving needs may help a master that cannot go without.
        best, _ = everything(one, 1)
    assert found.cost - one.star.master_alone == pytest.approx(best)


def test_draws_hold_what_matters():
    """Else the comparison above would compare nothing."""
    met, apart, nobody = 0, 0, 0
    for seed in range(40):
        one = drawn(seed)
        found = search_platoon(one.star, one.real, 60, extra_stops=6)
        nobody += found.timetable is None
        for member in found.members:
            met += not member.is_alone
            apart += member.is_alone
    assert min(met, apart, nobody) >= 5


@pytest.mark.parametrize("seed", range(12))
def test_every_node_is_bounded_by_what_its_departures_cost(seed):
    """Of decided stops: least over a span <= cost at each departure <= certain over the span."""
    one = drawn(2000 + seed, relief=0.5 * (seed % 3))
    star = one.star
    alone = [star.alone[k] if one.goes_alone(k) else math.inf for k in range(len(star.alone))]
    search = a_search(one, np.isfinite(alone), looked=bool(seed % 2))
    rows = np.arange(len(star.alone))
    first, last = star.window.earliest_s, star.window.latest_s
    known = {}
    for stops in itertools.islice(all_stops(star, 0), 0, None, 9):
        span = stops, None, first, last
        least = search.values.of(rows, [span]).cost
        certain = certain_costs(search, rows, span)
        for departure in range(first, last + 1):
            table = Timetable.of(star, departure, stops)
            for member in rows.tolist():
                cost = min(cheapest(one, table, alone, member, known), search.numbers.penalty)
                assert least[0, member] <= cost + 1e-9
                assert cost <= certain[0, member] + 1e-9


@pytest.mark.parametrize("seed", range(12))
def test_open_stops_are_bounded_by_whatever_they_may_be(seed):
    one = drawn(3000 + seed)
    star = one.star
    alone = [star.alone[k] if one.goes_alone(k) else math.inf for k in range(len(star.alone))]
    search = a_search(one, np.isfinite(alone), looked=bool(seed % 2))
    rows = np.arange(len(star.alone))
    first, last = star.window.earliest_s, star.window.latest_s
    known = {}
    for stops in itertools.islice(all_stops(star, 0), 0, None, 7):
        for departure in range(first, last + 1, 2):
            table = Timetable.of(star, departure, stops)
            if one.real(MASTER, 0, 0, table) is None:
                continue
            for count in range(len(stops)):
                clocks = search.stops.states(stops[:count], last)
                assert clocks is not None
                least = search.values.of(rows, [(stops[:count], clocks, first, last)]).cost
                for member in rows.tolist():
                    cost = min(cheapest(one, table, alone, member, known), search.numbers.penalty)
                    assert least[0, member] <= cost + 1e-9


@pytest.mark.parametrize("seed", range(8))
def test_only_departures_that_cost_too_much_are_dropped(seed):
    """With all stops decided: the bound holds for those kept, and those dropped cost as much."""
    one = drawn(8000 + seed)
    star = one.star
    alone = [star.alone[k] if one.goes_alone(k) else math.inf for k in range(len(star.alone))]
    search = a_search(one, np.isfinite(alone))
    rows, penalty = np.arange(len(star.alone)), search.numbers.penalty
    first, last = star.window.earliest_s, star.window.latest_s
    known, dropped = {}, 0
    for stops in itertools.islice(all_stops(star, 0), 0, None, 11):
        pays = []
        for departure in range(first, last + 1):
            table = Timetable.of(star, departure, stops)
            members = (cheapest(one, table, alone, k, known) for k in rows.tolist())
            pays.append(sum(min(cost, penalty) for cost in members))
        for most in sorted(set(pays)):
            got = search.values.of(rows, [(stops, None, first, last)], most=most)
            begin, end = int(got.begin[0]), int(got.end[0])
            if math.isinf(got.bound[0]):
                begin, end = last + 1, last
            kept = pays[begin - first : end - first + 1]
            assert got.bound[0] <= min(kept, default=math.inf) + 1e-9
            out = pays[: begin - first] + pays[end - first + 1 :]
            assert all(cost >= most - 1e-9 for cost in out)
            dropped += len(out)
    assert dropped > 0


def a_search(one, in_time, looked=True):
    """Return a search that has not begun, with all own ways looked at or none."""
    numbers = numbers_of_star(one.star, in_time, np.ones(len(in_time), bool), 1)
    stops = MasterStops(numbers, 6, 0)
    tables = OwnTables(numbers, one, plain_ways, entries_by_places, exits_by_places)
    pairs = pairs_of_star(numbers)
    for m in range(len(in_time) if looked else 0):
        own = slice(pairs.first[m], pairs.first[m + 1])
        rows = np.full(own.stop - own.start, m)
        tables.look(rows, pairs.merge[own], pairs.separate[own])
    values = StarValues(numbers, pairs, tables, stops, evaluate)
    trips = AskedTrips(one.star, numbers, one.real)
    return SpanSearch(one.star, numbers, values, trips, math.inf, 1e-9)


def certain_costs(search, rows, span):
    """Return the cost of the first pair of each that can be driven throughout a span."""
    found = np.full((1, len(rows)), math.inf)
    for row in rows.tolist():
        first = search.values.pairs.first
        for rank in range(first[row + 1] - first[row] + 1):
            got = search.values.of(
                np.array([row]), [span], sure=True, throughout=True, rank=np.array([rank])
            )
            if got.cost[0, 0] < math.inf:
                found[0, row] = got.cost[0, 0]
                break
    return found


def test_a_span_in_which_nobody_is_left_to_be_charged_has_an_end():
    one = drawn(0, members=2)
    search = a_search(one, np.isfinite(everything(one)[1]))
    nobody = np.zeros(0, np.int64)
    for length in (1, 5, 400):
        span = ((), None, 0, length)
        assert search.values.of(nobody, [span], most=0.0).bound[0] == math.inf
        found = search.values.of(nobody, [span], most=1.0)
        assert (found.bound[0], found.begin[0], found.end[0]) == (0.0, 0, length)


def test_when_the_time_is_over_the_bound_holds():
    for seed in range(12):
        one = drawn(seed, members=3)
        whole = search_platoon(one.star, one.real, 60, extra_stops=6)
        if whole.timetable is None:
            continue
        cut = search_platoon(one.star, one.real, 0.0, extra_stops=6)
        assert not cut.proved
        assert cut.bound <= whole.cost + 1e-9
        assert cut.cost >= whole.cost - 1e-9


@pytest.mark.parametrize("seed", [2, 5, 8, 10, 12, 13])
def test_what_is_closed_to_the_master_is_not_entered(seed):
    """A closed hop moves the departure, or the stops; brute force skips what starts within it."""
    one = drawn(4000 + seed)
    road = one.star.road
    rng = np.random.default_rng(seed)
    closed = [[] for _ in range(road.hops)]
    for hop in range(road.hops):
        begin = int(rng.integers(0, 16))
        closed[hop] = [(begin, begin + int(rng.integers(2, 5)))]
    shut = road_of(road.drive_s, road.stay_s, forbidden=closed)
    one = replace(one, star=replace(one.star, road=shut))
    open_real = one.real

    def real(member, i, j, table):
        hours = zip(table.leave_s.tolist(), closed, strict=False)
        blocked = any(a < at < b for at, some in hours for a, b in some)
        return None if member == MASTER and blocked else open_real(member, i, j, table)

    one.real = real
    best, alone = everything(one)
    found = search_platoon(
        one.star, open_real, 60, in_time=np.isfinite(alone), extra_stops=6
    )  # fmt: skip
    if math.isinf(best):
        best, _ = everything(one, 1)
    assert found.proved
    assert found.cost - one.star.master_alone == pytest.approx(best)


def test_breaks_under_american_rules_hold_for_all():
    """11 h in one day, 8 h without 30 min: one stop, and the members' clocks begin anew there."""
    hour = 3600
    rules = VehicleRules(US395, RESTED, 0)
    late = Span(0, 0, 10 * hour + 1800)
    star = StarTimes(
        road=road_of([4 * hour, 1 * hour, 5 * hour], [NO_LIMIT] * 4), node_at=np.array([0, 3]),
        window=late, rules=rules, approach_s=np.array([[0, NEVER_S]]),
        onward_s=np.array([[NEVER_S, 0]]), entry=np.array([[0.0, np.inf]]),
        leave=np.array([[np.inf, 0.0]]), platoon=np.array([[0.0, 9.0]]),
        length_m=np.array([0.0, 8e5]), alone=np.array([10.0]), alone_s=np.array([10 * hour]),
        windows=(late,), member_rules=(rules,), relief=0.0, master_alone=10.0, gain=np.zeros(1),
    )  # fmt: skip
    nothing = road_of([], [NO_LIMIT])
    found = search_platoon(star, RoadTrips(star, lambda *_: nothing, lambda *_: nothing), 60)
    assert (found.cost, found.proved, found.stops) in [
        (19.0, True, ((1, 1800),)), (19.0, True, ((2, 1800),))
    ]  # fmt: skip
    assert found.members[0].trip.arrival_s == 10 * hour + 1800
    assert [one.purposes for one in found.master_trip.pauses] == [("break",)]


def test_of_equal_plans_the_plain_one_that_leaves_first_is_taken():
    """No stop can be left out, and no earlier departure with these stops costs as little."""
    looked = 0
    for seed in range(20):
        one = drawn(5000 + seed)
        star = one.star
        alone = [star.alone[k] if one.goes_alone(k) else math.inf for k in range(len(star.alone))]
        found = search_platoon(one.star, one.real, 60, in_time=np.isfinite(alone), extra_stops=6)
        if found.timetable is None or math.isinf(found.cost):
            continue

        def cost(stops, departure, one=one, alone=alone):
            table = Timetable.of(one.star, departure, stops)
            late = table.arrive_s[-1] > one.star.window.arrival_s
            if late or one.real(MASTER, 0, 0, table) is None:
                return math.inf
            return sum(cheapest(one, table, alone, k, {}) for k in range(len(alone)))

        pays = found.cost - star.master_alone
        first, last = star.window.earliest_s, star.window.latest_s
        assert cost(found.stops, found.departure_s) == pytest.approx(pays)
        assert all(cost(found.stops, at) > pays + 1e-6 for at in range(first, found.departure_s))
        for k in range(len(found.stops)):
            fewer = found.stops[:k] + found.stops[k + 1 :]
            assert all(cost(fewer, at) > pays + 1e-6 for at in range(first, last + 1))
            looked += 1
    assert looked >= 8


def test_who_stops_alone_joins_again_where_that_is_cheaper():
    """All pairs of stretches with real trips, for timetables of the master that are drawn."""
    better = 0
    for seed in range(20):
        one = drawn(7000 + seed, members=3, wide=True)
        star = one.star
        alone = np.array([one.goes_alone(k) for k in range(3)])
        search = a_search(one, alone)
        search.values.stops = MasterStops(search.numbers, 9, 0)
        legal = [
            (stops, departure)
            for stops in all_stops(star, 0)
            for departure in range(star.window.earliest_s, star.window.latest_s + 1)
            if one.real(MASTER, 0, 0, Timetable.of(star, departure, stops)) is not None
        ]
        along = np.concatenate([[0], np.cumsum(star.road.drive_s)])[star.node_at] * 0.7
        again = Again(np.array([along - along[0]] * 3), one.trip)
        for at in np.random.default_rng(seed).permutation(len(legal))[:3].tolist():
            stops, departure = legal[at]
            members = choices_of(search, stops, departure)
            table = Timetable.of(star, departure, stops)
            found, complete = joined_again(search.numbers, table, members, again)
            assert complete
            for k, (once, twice) in enumerate(zip(members, found, strict=True)):
                assert twice.cost == pytest.approx(least_in_two(one, table, along, k, once.cost))
                better += len(twice.stretches) == 2
    assert better >= 3


def least_in_two(one, table, along, member, best):
    """Return the least cost of a member that may drive two stretches, or pay what is given."""
    star = one.star
    entry, leave, own = star.entry[member], star.leave[member], star.platoon[member]
    for i, j, a, b in itertools.combinations(range(len(star.node_at)), 4):
        cost = entry[i] + own[j] - own[i] + along[a] - along[j] + own[b] - own[a] + leave[b]
        if cost < best - 1e-9 and one.trip(member, [(i, j), (a, b)], table):
            best = cost
    return best
