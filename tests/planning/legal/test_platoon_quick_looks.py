"""What is passed over at a quick look could not be driven; who is not asked could be."""

import itertools
import math

import numpy as np
import pytest
from small_law import all_stops, drawn

from platoon_osm.planning.legal.platoon import cells
from platoon_osm.planning.legal.platoon.asked import AskedTrips
from platoon_osm.planning.legal.platoon.clocks import FAR
from platoon_osm.planning.legal.platoon.kernel import evaluate
from platoon_osm.planning.legal.platoon.numbers import numbers_of_star
from platoon_osm.planning.legal.platoon.own_places import entries_by_places, exits_by_places
from platoon_osm.planning.legal.platoon.own_ways import plain_ways
from platoon_osm.planning.legal.platoon.pairs import pairs_of_star
from platoon_osm.planning.legal.platoon.spans import SpanSearch
from platoon_osm.planning.legal.platoon.stops import MasterStops
from platoon_osm.planning.legal.platoon.tables import OwnTables
from platoon_osm.planning.legal.platoon.values import StarValues

WHAT = ("cost", "rank", "bound", "begin", "end", "ranks", "cut")

SPARED = {0, 1, 3, 4}
"""Draws in which some pairs are passed over."""


def a_search(one, looked):
    """Return a search that has not begun, with all own ways looked at or none."""
    members = len(one.star.alone)
    alone = np.array([one.goes_alone(k) for k in range(members)])
    numbers = numbers_of_star(one.star, alone, np.ones(members, bool), 1)
    stops = MasterStops(numbers, 6, 1)
    tables = OwnTables(numbers, one, plain_ways, entries_by_places, exits_by_places)
    pairs = pairs_of_star(numbers)
    for m in range(members if looked else 0):
        own = slice(pairs.first[m], pairs.first[m + 1])
        tables.look(np.full(own.stop - own.start, m), pairs.merge[own], pairs.separate[own])
    values = StarValues(numbers, pairs, tables, stops, evaluate)
    trips = AskedTrips(one.star, numbers, one.real)
    return SpanSearch(one.star, numbers, values, trips, math.inf, 1e-9)


def nodes_of(one, search):
    """Return timetables with and without stops that are still open."""
    first, last = one.star.window.earliest_s, one.star.window.latest_s
    made = []
    for stops in itertools.islice(all_stops(one.star, 1), 0, None, 41):
        made.append((stops, None, first, last))
        for count in range(len(stops)):
            after = search.stops.states(stops[:count], last)
            if after is not None:
                made.append((stops[:count], after, first, last))
    return made


@pytest.mark.parametrize("seed", [0, 1, 3, 4, 6, 9, 12])
def test_values_are_those_of_a_scan_that_passes_over_nothing(monkeypatch, seed):
    one = drawn(7000 + seed, night=bool(seed % 2), relief=0.5 * (seed % 3), wide=seed % 4 > 1)
    search = a_search(one, looked=seed % 3 > 0)
    rows, tables = np.arange(len(one.star.alone)), nodes_of(one, search)
    asked = [0, 0]

    def counted(turn):
        def departures(*args, departures=cells_departures):
            asked[turn] += 1
            return departures(*args)

        return departures

    cells_departures = cells.departures
    found = []
    for turn in range(2):
        monkeypatch.setattr(cells, "departures", counted(turn))
        if turn:
            monkeypatch.setattr(cells, "most_driven", lambda *_: (FAR, FAR, FAR))
        found.append(
            [
                search.values.of(rows, tables, sure=sure, most=most)
                for sure in (False, True)
                for most in (math.inf, float(one.star.alone[0]))
            ]
        )
    for quick, naive in zip(*found, strict=True):
        kept = np.isfinite(naive.bound)
        assert np.array_equal(quick.bound, naive.bound)
        for name in WHAT:
            assert np.array_equal(getattr(quick, name)[kept], getattr(naive, name)[kept]), name
    assert asked[0] <= asked[1]
    if seed in SPARED:
        assert asked[0] < asked[1]


@pytest.mark.parametrize("seed", range(1, 6))
def test_members_pay_the_same_whether_all_trips_are_asked_for_or_few(seed):
    one = drawn(7100 + seed, relief=0.5 * (seed % 3))
    first, last = one.star.window.earliest_s, one.star.window.latest_s
    asked = [0, 0]
    for stops in itertools.islice(all_stops(one.star, 0), 0, None, 13):
        for departure in (first, (first + last) // 2, last):
            found = []
            for with_trips in (False, True):
                search = a_search(one, looked=False)
                chosen = search.choices(stops, departure, with_trips=with_trips)
                found.append(chosen and [one[:3] for one in chosen])
                asked[with_trips] += len(search.trips.asked)
            assert found[0] == found[1]
    assert asked[0] <= asked[1]
