"""The curve of a master's departure under the law: every whole second against brute force."""

import math
from itertools import pairwise

import numpy as np
import pytest
from small_law import NO_PARTS, all_stops, drawn
from test_platoon_search import KINDS, cheapest

from platoon_osm.planning.legal.platoon import departure_steps, kernel, spans
from platoon_osm.planning.legal.platoon.departure_steps import steps_of_departure
from platoon_osm.planning.legal.platoon.record import MASTER, Timetable
from platoon_osm.planning.legal.platoon.star_searches import StarSearches, departures_of

FREELY = 10**9


@pytest.fixture(autouse=True)
def short_spans(monkeypatch):
    """Let spans of a few seconds be split, too, and be cut into few cells."""
    monkeypatch.setattr(spans, "SPLIT_S", 3)
    monkeypatch.setattr(kernel, "CELLS", 3)


def by_departure(one, rests=0):
    """Return the least that members pay at each departure with any stops, where there are any."""
    star = one.star
    members = range(len(star.alone))
    alone = [star.alone[k] if one.goes_alone(k) else math.inf for k in members]
    drive = int(star.road.drive_s.sum())
    found, known = {}, {}
    for stops in all_stops(star, rests):
        stood = sum(length for _, length in stops)
        last = min(star.window.latest_s, star.window.arrival_s - drive - stood)
        for departure in range(star.window.earliest_s, last + 1):
            table = Timetable.of(star, departure, stops)
            if one.real(MASTER, 0, 0, table) is not None:
                pays = sum(cheapest(one, table, alone, k, known) for k in members)
                found[departure] = min(found.get(departure, math.inf), pays)
    return found, np.isfinite(alone)


def told(one, in_time, most_spans=FREELY):
    """Return what members pay at each departure as the steps tell it, and the steps."""
    searches = StarSearches(one.star, one.real, one, in_time, extra_stops=6)
    found = steps_of_departure(searches, most_spans, 60)
    pays = {
        at: (sum(member.cost for member in step.members), step.open_cost)
        for step in found.steps
        for at in range(step.begin_s, step.end_s + 1)
    }
    assert len(pays) == sum(step.end_s - step.begin_s + 1 for step in found.steps)
    return pays, found


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("kind", KINDS)
def test_every_departure_costs_what_the_steps_tell(kind, seed):
    one = drawn(8000 + seed, **KINDS[kind])
    night = kind == "a night on the way"
    least, in_time = by_departure(one, int(night))
    if not night:
        # A rest more than its driving needs may help a master that cannot go without.
        least = {**by_departure(one, 1)[0], **least}
    pays, found = told(one, in_time)
    assert found.complete
    assert {at: cost for at, (cost, _) in pays.items()} == pytest.approx(least)
    assert all(short == 0 for _, short in pays.values())


@pytest.mark.parametrize(
    ("seed", "kind"),
    [(9001, "wide"), (9006, "wide"), (9018, "wide"), (9027, "wide"), (9007, ""), (9060, ""),
     (9073, "")],
)  # fmt: skip
def test_departures_that_need_other_stops_are_searched_apart(seed, kind):
    """Who leaves later has rested longer, and then fewer stops and rests are allowed."""
    one = drawn(seed, wide=kind == "wide")
    in_time = np.array([one.goes_alone(k) for k in range(len(one.star.alone))])
    searches = StarSearches(one.star, one.real, one, in_time, extra_stops=6)
    first, last = departures_of(one.star)
    needs = {at: searches.needs(at) for at in range(first, last + 1)}
    assert len(set(needs.values())) > 1
    every = [by_departure(one, rests)[0] for rests in range(3)]
    least = {}
    for at, (_, rests) in needs.items():
        some = [own[at] for own in every[rests:] if at in own]
        if some:
            least[at] = some[0]
    pays, found = told(one, in_time)
    assert found.complete
    assert {at: cost for at, (cost, _) in pays.items()} == pytest.approx(least)


@pytest.mark.parametrize(("seed", "wide"), [(9090, True), (9095, False), (9248, False)])
def test_no_departure_has_stops_that_only_another_may_have(seed, wide):
    """Without a stop to spare those who leave early may make one more than those who leave late."""
    one = drawn(seed, wide=True) if wide else drawn(seed, limits=NO_PARTS)
    in_time = np.array([one.goes_alone(k) for k in range(len(one.star.alone))])
    searches = StarSearches(one.star, one.real, one, in_time, extra_stops=0)
    found = steps_of_departure(searches, FREELY, 60)
    pays = {
        at: sum(member.cost for member in step.members)
        for step in found.steps
        for at in range(step.begin_s, step.end_s + 1)
    }
    first, last = departures_of(one.star)
    for at in range(first, last + 1):
        for more in range(3):
            search = searches.search(searches.needs(at), more)
            assert search.run(at, at)
            if search.found:
                break
        assert pays.get(at, math.inf) == pytest.approx(search.best)


def test_draws_hold_what_matters():
    """Else the comparisons above would compare nothing."""
    levels, gaps = 0, 0
    for seed in range(20):
        one = drawn(8500 + seed, members=3)
        pays, found = told(one, np.array([one.goes_alone(k) for k in range(3)]))
        levels += len({cost for cost, _ in pays.values()}) > 1
        gaps += any(a.end_s + 1 < b.begin_s for a, b in pairwise(found.steps))
    assert levels >= 5


@pytest.mark.parametrize("seed", range(8))
def test_when_spans_are_used_up_costs_can_be_had_and_bounds_hold(seed, monkeypatch):
    monkeypatch.setattr(departure_steps, "LEAST_SPANS", 2)
    one = drawn(8000 + seed, members=3)
    in_time = np.array([one.goes_alone(k) for k in range(3)])
    whole, _ = told(one, in_time)
    cut, found = told(one, in_time, 1)
    assert not whole or not found.complete
    assert set(cut) <= set(whole)
    for at, (cost, short) in cut.items():
        assert cost - short - 1e-9 <= whole[at][0] <= cost + 1e-9
