"""What is known of stops that are not decided, against every legal timetable of a master."""

import itertools
import math
from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from small_law import NO_PARTS, SMALL, all_stops, drawn

from platoon_osm.planning.legal.driver.road import NO_LIMIT, road_of
from platoon_osm.planning.legal.platoon import kernel, spans
from platoon_osm.planning.legal.platoon.asked import AskedTrips
from platoon_osm.planning.legal.platoon.kernel import evaluate
from platoon_osm.planning.legal.platoon.nodes import SpanNode
from platoon_osm.planning.legal.platoon.numbers import numbers_of_star
from platoon_osm.planning.legal.platoon.open_stops import (
    AHEAD,
    COLUMNS,
    LATER,
    LEAST,
    MOST,
    NEXT,
    RESTED,
    STOPPED,
    open_stops,
)
from platoon_osm.planning.legal.platoon.own_places import entries_by_places, exits_by_places
from platoon_osm.planning.legal.platoon.own_ways import plain_ways
from platoon_osm.planning.legal.platoon.pairs import pairs_of_star
from platoon_osm.planning.legal.platoon.record import MASTER, Timetable
from platoon_osm.planning.legal.platoon.spans import SpanSearch
from platoon_osm.planning.legal.platoon.star_times import Span
from platoon_osm.planning.legal.platoon.stops import OPEN, MasterStops
from platoon_osm.planning.legal.platoon.tables import OwnTables
from platoon_osm.planning.legal.platoon.values import StarValues


@dataclass(slots=True, eq=False)
class Everything(SpanSearch):
    """A search that keeps every node that is made of one, and bounds none."""

    made: list = field(default_factory=list)

    def _push(self, nodes):
        self.made += nodes


def roomy(seed, limits, **kinds):
    """Draw a star whose master has time for more stops than it needs, and a place at each hop."""
    one = drawn(seed, night=True, limits=limits, **kinds)
    window, road = one.star.window, one.star.road
    rng = np.random.default_rng(seed)
    stay = np.where(rng.random(road.hops + 1) < 0.9, NO_LIMIT, 0)
    late = Span(window.earliest_s, window.latest_s, window.arrival_s + int(rng.integers(0, 10)))
    one.star = replace(one.star, window=late, road=road_of(road.drive_s, stay))
    return one


def a_search(one, rests, most):
    """Return a search of a star that has not begun; nothing is known of its members' own ways."""
    members = len(one.star.alone)
    alone = np.array([one.goes_alone(k) for k in range(members)])
    numbers = numbers_of_star(one.star, alone, np.ones(members, bool), rests + 1)
    stops = MasterStops(numbers, most, rests)
    tables = OwnTables(numbers, one, plain_ways, entries_by_places, exits_by_places)
    values = StarValues(numbers, pairs_of_star(numbers), tables, stops, evaluate)
    return Everything(
        one.star, numbers, values, AskedTrips(one.star, numbers, one.real), stops, math.inf, 1e-9
    )


def legal(one, search, step=1):
    """Return the timetables that are legal for the master: stops and departures.

    Those are left out in which a daily rest would have to count as the first part of a break.
    """
    star, found = one.star, []
    drive = int(star.road.drive_s.sum())
    plans = (stops for stops in all_stops(star, search.stops.rests) if search.stops.allows(stops))
    for stops in itertools.islice(plans, 0, None, step):
        clocks = search.stops.states(stops, star.window.latest_s)
        if clocks is None or not search.stops.is_end(stops, clocks):
            continue
        last = star.window.arrival_s - drive - sum(length for _, length in stops)
        leaves = [
            at
            for at in range(star.window.earliest_s, min(star.window.latest_s, last) + 1)
            if one.real(MASTER, 0, 0, Timetable.of(star, at, stops)) is not None
        ]
        if leaves:
            found.append((stops, leaves))
    return found


def next_night(search, stops, count):
    """Return the first daily rest behind some stops."""
    rest = search.stops.held[search.stops.held >= search.numbers.vehicles[-1][5]].min()
    for index in range(count, len(stops)):
        if stops[index][1] >= rest:
            return (*stops[index], index)
    return len(search.numbers.tau), 0, 0


DRAWS = [(9100 + seed, SMALL if seed % 2 else NO_PARTS) for seed in range(8)]


@pytest.mark.parametrize(("seed", "limits"), DRAWS)
def test_every_legal_timetable_is_come_to(seed, limits):
    """Nights are decided first, then the stops before them: none is left out, none comes twice."""
    one = roomy(seed, limits)
    search = a_search(one, 1, 4)
    begin, end = one.star.window.earliest_s, one.star.window.latest_s
    clocks = search.stops.states((), end)
    assert clocks is not None
    search.made, ended = [search.start((), clocks, begin, end)], []
    while search.made:
        node = search.made.pop()
        if node.clocks is None:
            ended.append(node.stops)
        elif node.night == OPEN:
            search._with_nights(node)
        else:
            search._branch(node)
    assert len(ended) == len(set(ended))
    wanted = {stops for stops, _ in legal(one, search)}
    assert wanted <= set(ended)


@pytest.mark.parametrize("rests", [1, 2])
@pytest.mark.parametrize("first", range(9200, 9224, 6))
def test_open_stops_are_where_and_as_many_as_is_told(first, rests):
    seen = [told(seed, SMALL if seed % 2 else NO_PARTS, rests) for seed in range(first, first + 6)]
    assert sum(seen) > 100


def told(seed, limits, rests):
    """Compare with every legal timetable of a draw; return how often there was what to compare."""
    one = roomy(seed, limits)
    search = a_search(one, rests, 5)
    some, plan = search.numbers, search.stops.plan
    v, looked = some.vehicles[-1], 0
    for stops, leaves in legal(one, search, 2 if rests == 1 else 7):
        for count, known in itertools.product(range(len(stops) + 1), (True, False)):
            clocks = search.stops.states(stops[:count], leaves[-1])
            assert clocks is not None
            night = next_night(search, stops, count) if known else OPEN
            found = np.empty((len(some.pos), COLUMNS), np.int64)
            done = stops[:count]
            open_stops(
                some.pos, some.tau, search.stops.places, plan, v, done[-1][0] if done else 0,
                count, sum(length >= v[5] for _, length in done), sum(one for _, one in done),
                np.array(clocks), *night, leaves[0], found,
            )  # fmt: skip
            for k, pos in enumerate(some.pos.tolist()):
                before = [one for one in stops[count:] if one[0] < pos]
                upto = [one for one in stops[count:] if one[0] <= pos]
                assert found[k, AHEAD] <= sum(length for _, length in before)
                assert found[k, LATER] >= sum(length for _, length in upto)
                assert found[k, LEAST] <= len(upto) <= found[k, MOST]
                places = [place for place, _ in upto]
                assert found[k, STOPPED] >= max(places, default=-1)
                rested = [place for place, length in upto if length >= v[5]]
                assert found[k, RESTED] >= max(rested, default=-1)
                others = [place for place, _ in stops[count:] if place >= pos]
                assert found[k, NEXT] <= min(others, default=some.tau.size)
                looked += len(upto)
    return looked


def pays(one, table, member, alone, known):
    """Return what a member pays, pair by pair."""
    star, best = one.star, alone[member]
    entry, leave, own = star.entry[member], star.leave[member], star.platoon[member]
    for i, j in itertools.combinations(range(len(star.node_at)), 2):
        cost = entry[i] + own[j] - own[i] + leave[j]
        if cost < best:
            key = member, i, j, table.stops, table.departure_s
            if key not in known:
                known[key] = one.real(member, i, j, table) is not None
            best = cost if known[key] else best
    return best


@pytest.mark.parametrize("cells", [1, 3, 32])
@pytest.mark.parametrize("seed", range(8))
def test_what_was_ruled_out_before_is_out_of_every_timetable(seed, cells, monkeypatch):
    """From the whole span with all stops open to one timetable: no bound is above what it costs."""
    monkeypatch.setattr(kernel, "CELLS", cells)
    monkeypatch.setattr(spans, "SPLIT_S", 3)
    one = roomy(9300 + seed, SMALL if seed % 2 else NO_PARTS, relief=0.5 * (seed % 3))
    search, star = a_search(one, 1, 5), one.star
    alone = [
        star.alone[k] if one.goes_alone(k) else search.numbers.penalty
        for k in range(len(star.alone))
    ]
    begin, end = star.window.earliest_s, star.window.latest_s
    known, rng = {}, np.random.default_rng(seed)
    plans = legal(one, search)
    for at in rng.permutation(len(plans))[:12].tolist():
        stops, leaves = plans[at]
        costs = {
            leave: sum(
                pays(one, Timetable.of(star, leave, stops), k, alone, known)
                for k in range(len(alone))
            )
            for leave in leaves
        }
        clocks = search.stops.states((), end)
        assert clocks is not None
        node = search.start((), clocks, begin, end)
        most = max(costs.values()) + 1.0
        low, high = begin, end
        for count in range(-1, len(stops) + 1):
            after = search.stops.states(stops[: max(count, 0)], high)
            night = OPEN if count < 0 else next_night(search, stops, count)
            if count == len(stops):
                after, night = None, OPEN
            step: SpanNode = replace(
                node, stops=stops[: max(count, 0)], clocks=after, night=night, begin=low, end=high
            )
            got = search.bounded([step], most)
            held = {leave: cost for leave, cost in costs.items() if low <= leave <= high}
            bound = got[0][0] if got else math.inf
            assert bound <= min(held.values(), default=math.inf) + 1e-9
            if not got:
                break
            node = step
            if count % 2 == 0 and low < high:
                # Only one half of the span is followed.
                middle = (low + high) // 2
                low, high = (low, middle) if rng.random() < 0.5 else (middle + 1, high)
