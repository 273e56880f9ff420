"""How members really drive, which plans use too: one departure, and spans of them."""

from dataclasses import replace

import numpy as np
import pytest
from small_law import SMALL, all_stops, drawn, drivable
from soak import chosen, soaked

from platoon_osm.planning.legal.driver.road import road_of
from platoon_osm.planning.legal.platoon.real import RoadTrips
from platoon_osm.planning.legal.platoon.record import Timetable

CALENDAR = replace(SMALL, week_s=7, fortnight_s=40, weekly_rest_s=60, weekly_after_s=60)


def drawn_closings(rng, seconds):
    """Draw when hops of a second are closed: few are."""
    found = []
    for _ in range(seconds):
        begin = int(rng.integers(0, 30))
        found.append(((begin, begin + int(rng.integers(2, 6))),) if rng.random() < 0.1 else ())
    return tuple(found)


class Ways:
    """A drawn star with closings on the members' own ways, as the code and the oracle see it."""

    def __init__(self, seed, **options):
        self.one = drawn(seed, **options)
        self.rng = np.random.default_rng(seed)
        self.closed = [
            [[() if way is None else drawn_closings(self.rng, len(way[0])) for way in row]
             for row in table]
            for table in (self.one.approach, self.one.onward)
        ]  # fmt: skip
        self.trips = RoadTrips(self.one.star, self.road(0), self.road(1))

    def road(self, which):
        ways = (self.one.approach, self.one.onward)[which]

        def found(member, node):
            drive, stay = ways[member][node]
            return road_of(drive, stay, forbidden=self.closed[which][member][node])

        return found

    def really(self, member, i, j, table):
        """Whether a member can drive so, by the oracle."""
        star = self.one.star
        way = self.one.way(member, i, j, table)
        shared = int(star.node_at[j] - star.node_at[i])
        closed = (*self.closed[0][member][i], *[()] * shared, *self.closed[1][member][j])
        return drivable(
            replace(way, closed=closed), star.member_rules[member], star.windows[member]
        )

    def asked(self):
        """Draw a member, its points, and stops of the master."""
        star, rng = self.one.star, self.rng
        every = list(all_stops(star, 1))
        while True:
            member = int(rng.integers(len(star.alone)))
            i, j = sorted(rng.choice(len(star.node_at), 2, replace=False).tolist())
            if self.one.approach[member][i] is not None:
                return member, i, j, every[int(rng.integers(len(every)))]


@soaked
@pytest.mark.parametrize("seed", range(chosen(16, 200)))
def test_a_departure_is_answered_as_by_every_second_of_standing(seed):
    ways = Ways(8000 + seed, relief=0.5 * (seed % 3), members=3)
    for _ in range(12):
        member, i, j, stops = ways.asked()
        table = Timetable.of(ways.one.star, int(ways.rng.integers(0, 16)), stops)
        assert (ways.trips(member, i, j, table) is not None) == ways.really(member, i, j, table)


@pytest.mark.parametrize("calendar", [False, True], ids=["days", "weeks"])
@soaked
@pytest.mark.parametrize("seed", range(chosen(24, 200)))
def test_a_span_is_answered_for_all_its_departures(seed, calendar):
    """Who can for a whole span can at each departure of it; who never can, at none."""
    ways = Ways(9000 + seed, relief=0.5 * (seed % 3), members=3)
    if calendar:
        star, rng = ways.one.star, ways.rng
        rules = tuple(
            replace(rules, limits=CALENDAR, state=replace(
                rules.state, driven_this_week_s=int(rng.integers(0, 7)),
                driven_last_week_s=int(rng.integers(0, 6)),
                since_weekly_rest_s=int(rng.integers(15, 50)),
            ))
            for rules in star.member_rules
        )  # fmt: skip
        monday = int(rng.integers(4, 20))
        ways.one.star = replace(star, member_rules=rules, monday_s=monday)
        ways.trips = RoadTrips(ways.one.star, ways.road(0), ways.road(1))
    known = {"never": 0, "always": 0}
    for _ in range(24):
        member, i, j, stops = ways.asked()
        begin = int(ways.rng.integers(0, 16))
        end = begin + int(ways.rng.integers(1, 6))
        # The shifted way, without a slack, answers for the one departure.
        each = [
            ways.trips(member, i, j, Timetable.of(ways.one.star, at, stops)) is not None
            for at in range(begin, end + 1)
        ]
        late = Timetable.of(ways.one.star, end, stops, end - begin)
        early = Timetable.of(ways.one.star, begin, stops, begin - end)
        if ways.trips(member, i, j, late) is None:
            known["never"] += 1
            assert not any(each)
        if ways.trips(member, i, j, early) is not None:
            known["always"] += 1
            assert all(each)
    assert known["never"] or known["always"]


def test_a_member_that_merges_at_its_origin_may_leave_earlier_within_a_span():
    """Its latest departure lies within the span: neither never nor always."""
    for seed in range(200):
        ways = Ways(9500 + seed)
        star = ways.one.star
        for member in range(len(star.alone)):
            if star.approach_s[member, 0] or star.node_at[0]:
                continue
            latest = star.windows[member].latest_s
            alone = Timetable.of(star, latest, ())
            if ways.trips(member, 0, 1, alone) is None:
                continue
            assert ways.trips(member, 0, 1, Timetable.of(star, latest + 2, (), 4)) is not None
            assert ways.trips(member, 0, 1, Timetable.of(star, latest - 2, (), -4)) is None
            return
    raise AssertionError("no draw merges at its origin")


@soaked
@pytest.mark.parametrize("seed", range(chosen(6, 200)))
def test_two_stretches_are_answered_as_by_every_second_of_standing(seed):
    ways = Ways(9700 + seed, members=3, wide=True)
    star = ways.one.star
    trips = RoadTrips(
        star, *[lambda member, node, some=some: road_of(*some[member][node])
                for some in (ways.one.approach, ways.one.onward)]
    )  # fmt: skip
    every = list(all_stops(star, 0))
    for _ in range(25):
        member = int(ways.rng.integers(3))
        nodes = np.sort(ways.rng.choice(len(star.node_at), 4, replace=False)).tolist()
        if ways.one.approach[member][nodes[0]] is None:
            continue
        stretches = [tuple(nodes[:2]), tuple(nodes[2:])]
        stops = every[int(ways.rng.integers(len(every)))]
        table = Timetable.of(star, int(ways.rng.integers(0, 8)), stops)
        here = trips.trip(member, stretches, table) is not None
        assert here == (ways.one.trip(member, stretches, table) is not None)
