"""How much longer than alone a trip may take, against the latest arrival worked out by hand."""

from datetime import UTC, datetime, timedelta
from zoneinfo import ZoneInfo

import pytest
from bundled import italy as italy_map
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import problems

import platoon_osm as po
from platoon_osm.planning.timing.flexibility import with_latest_arrivals

SIX = datetime(2026, 3, 2, 6)


def test_earliest_departure_driving_time_alone_and_so_much():
    asked = po.Trip("A", "x", "y", SIX, flexibility_min=30)
    (trip,) = with_latest_arrivals([asked], [3600.0])
    assert trip == po.Trip("A", "x", "y", SIX, latest_arrival=datetime(2026, 3, 2, 7, 30))
    (again,) = with_latest_arrivals([trip], [9.0])
    assert again is trip


def test_others_stay_as_they_are():
    trips = [
        po.Trip("A", "x", "y"),
        po.Trip("B", "x", "y", SIX, latest_arrival=SIX.replace(hour=9)),
    ]
    assert with_latest_arrivals(trips, [1.0, 2.0]) == trips
    with pytest.raises(po.ScenarioError, match="2 trips have 1 driving times"):
        with_latest_arrivals(trips, [1.0])


@given(st.floats(0, 1e6), st.floats(0, 1e5))
def test_never_earlier_and_less_than_a_second_later(alone_s, minutes):
    (trip,) = with_latest_arrivals([po.Trip("A", 0, 1, SIX, flexibility_min=minutes)], [alone_s])
    exact = alone_s + 60 * minutes
    assert -1e-5 <= (trip.latest_arrival - SIX).total_seconds() - exact <= 1


def test_hours_that_pass_count_not_those_of_the_clock():
    """In the night to 29 March 2026 clocks in Rome go from 02:00 to 03:00."""
    early = datetime(2026, 3, 29, 1, 30, tzinfo=ZoneInfo("Europe/Rome"))
    asked = po.Trip("A", "x", "y", early, flexibility_min=60)
    (trip,) = with_latest_arrivals([asked], [3600.0])
    assert trip.latest_arrival.isoformat() == "2026-03-29T04:30:00+02:00"


@settings(max_examples=60, deadline=None)
@given(problems(), st.lists(st.floats(0, 90), min_size=8, max_size=8), st.booleans())
def test_a_plan_is_that_of_the_latest_arrivals(problem, minutes, zoned):
    """The plan alone tells how long each drives; with arrivals from that it must be the same."""
    net, weights, trips = problem
    first = SIX.replace(tzinfo=UTC) if zoned else SIX
    alone = [trip.alone.time_s for trip in po.plan_joint(net, weights, trips).trips]
    flexible, fixed = [], []
    for k, trip in enumerate(trips):
        early = first + timedelta(minutes=k)
        ends = trip.vehicle, trip.origin, trip.destination
        flexible.append(po.Trip(*ends, early, flexibility_min=minutes[k]))
        (given_by,) = with_latest_arrivals([flexible[-1]], [alone[k]])
        fixed.append(po.Trip(*ends, early, latest_arrival=given_by.latest_arrival))
    assert po.plan_joint(net, weights, flexible) == po.plan_joint(net, weights, fixed)


def test_without_any_flexibility_nobody_alone_is_late():
    net = italy_map()
    trip = po.Trip("A", "Torino", "Trieste", SIX, flexibility_min=0)
    plan = po.plan_joint(net, po.paper_weights(net), [trip])
    (times,) = plan.timetable.vehicles
    assert times.late_s == 0
    alone_s = plan.trips[0].alone.time_s
    assert plan.timetable.feasible
    assert times.latest_arrival_s - times.earliest_departure_s - alone_s == pytest.approx(0, abs=1)


ARRIVAL = SIX.replace(hour=9)


@pytest.mark.parametrize(
    ("times", "minutes", "said"),
    [
        ((), 30, "counts from earliest_departure; give that too"),
        ((SIX, None, ARRIVAL), 30, "and latest_arrival both say when it must be there"),
        ((SIX,), -1, "must be a number of minutes from 0 to"),
        ((SIX,), float("nan"), "must be a number of minutes"),
        ((SIX,), float("inf"), "must be a number of minutes"),
        ((SIX,), True, "must be a number of minutes"),
        ((SIX,), "30", "must be a number of minutes"),
        ((SIX,), 1e9, "from 0 to 527040"),
    ],
)
def test_what_is_no_flexibility(times, minutes, said):
    with pytest.raises(po.ScenarioError, match=said):
        po.Trip("A", "x", "y", *times, flexibility_min=minutes)
