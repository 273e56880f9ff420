"""Timetables against brute force over whole minutes, longest paths, and what must always hold."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta, timezone
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plans_by_legs import plan_of, with_vehicles
from random_networks import network, problems

from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.joint import plan_joint
from platoon_osm.planning.timing.limits import PATIENCE_MIN
from platoon_osm.planning.timing.schedule import ROUTES_GIVEN, schedule
from platoon_osm.plans.records import Leg, NetworkIdentity, Stop
from platoon_osm.plans.trip import Trip
from platoon_osm.plans.vehicles import VehiclePlan

DAY = datetime(2026, 3, 2)
MINUTE = 60.0


def at(minute):
    return None if minute is None else DAY + timedelta(minutes=minute)


def trip(name, earliest=None, latest=None, arrival=None):
    return Trip(name, 0, 1, at(earliest), at(latest), at(arrival))


# -- plans by hand ---------------------------------------------------------------------------------


def company_plan(stretches, members):
    """A plan of a master A that drives stretches of some minutes, and members that join it.

    `members` holds (minutes before, first stretch, stretch after the last, minutes after).
    """
    names = [chr(ord("A") + k) for k in range(len(members) + 1)]
    there = [
        {names[0]} | {names[k + 1] for k, (_, i, j, _) in enumerate(members) if i <= s < j}
        for s in range(len(stretches))
    ]
    edges = iter(range(1000, 100_000))

    def leg(role, ids, partners, minutes):
        return Leg(role, tuple(ids), tuple(partners), 1e3 * minutes, MINUTE * minutes, 0.0, 1.0)

    def together(name, first, end):
        legs, begin = [], first
        for s in range(first + 1, end + 1):
            if s == end or there[s] != there[begin]:
                others = sorted(there[begin] - {name})
                minutes = sum(stretches[begin:s])
                legs.append(leg("platoon" if others else "solo", range(begin, s), others, minutes))
                begin = s
        return legs

    stop = Stop(0, 9.0, 45.0, "x")
    vehicles = []
    for k, name in enumerate(names):
        if k == 0:
            legs = together(name, 0, len(stretches))
        else:
            before, i, j, after = members[k - 1]
            legs = together(name, i, j)
            if before:
                legs.insert(0, leg("solo", [next(edges)], (), before))
            if after:
                legs.append(leg("solo", [next(edges)], (), after))
        vehicles.append(
            VehiclePlan(name, stop, stop, "member" if k else "master", tuple(legs), legs[0])
        )
    identity = NetworkIdentity("n", "", "", "", "", 1, 1, "i")
    return plan_of(vehicles, network=identity)


def minutes(timetable, name):
    """Departure, starts and ends of legs of a vehicle in minutes from DAY."""
    times = next(times for times in timetable.vehicles if times.vehicle == name)
    zero = (datetime.fromisoformat(timetable.start) - DAY).total_seconds()
    moments = (times.departure_s, *(moment for span in times.legs for moment in span))
    return [round((zero + moment) / MINUTE, 6) for moment in moments]


ONE = company_plan([30, 60, 30], [(45, 1, 2, 10)])
"""A drives 30, 60 and 30 minutes, the middle with B, which needs 45 to get there and 10 after."""


def test_a_member_leaves_so_that_nobody_waits():
    found = schedule(ONE, [trip("A", 360), trip("B", 300)])
    assert minutes(found, "A") == [360, 360, 390, 390, 450, 450, 480]
    assert minutes(found, "B") == [345, 345, 390, 390, 450, 450, 460]
    assert found.waiting_s == 0
    assert [times.held_s for times in found.vehicles] == [0, 45 * MINUTE]
    assert found.feasible
    assert found.start == "2026-03-02T05:45:00"


def test_who_has_to_leave_early_waits_where_it_merges():
    found = schedule(ONE, [trip("A", 360), trip("B", 300, 325)])
    assert minutes(found, "B") == [325, 325, 370, 390, 450, 450, 460]
    assert found.vehicles[1].waits == (0, 20 * MINUTE, 0)
    assert found.vehicles[1].waiting_s == 20 * MINUTE
    assert found.vehicles[0].waiting_s == 0


def test_the_master_shifts_its_departure_for_a_late_member():
    found = schedule(ONE, [trip("A", 360), trip("B", 400)])
    assert minutes(found, "A")[0] == 415
    assert found.waiting_s == 0


def test_the_master_waits_if_it_cannot_shift():
    found = schedule(ONE, [trip("A", 360, 380), trip("B", 400)])
    assert minutes(found, "A") == [380, 380, 410, 445, 505, 505, 535]
    assert found.vehicles[0].waiting_s == 35 * MINUTE


def test_a_flexible_trip_joins_the_others():
    found = schedule(ONE, [trip("A", 360), trip("B")])
    assert minutes(found, "B") == [345, 345, 390, 390, 450, 450, 460]


def test_latest_times_alone_are_met_just_in_time():
    found = schedule(ONE, [trip("A", arrival=480), trip("B", arrival=500)])
    assert minutes(found, "A")[-1] == 480
    assert minutes(found, "B")[0] == 345
    assert found.feasible


def test_vehicles_without_any_link_to_a_time_leave_at_the_earliest_one_named():
    apart = company_plan([30], [])
    other = replace(apart.vehicles[0], vehicle="B")
    plan = with_vehicles(apart, (*apart.vehicles, other))
    found = schedule(plan, [trip("A", 360), trip("B")])
    assert minutes(found, "B") == [360, 360, 390]


def test_lateness_is_told_in_minutes():
    trips = [trip("A", 360, None, 470), trip("B", 300)]
    found = schedule(ONE, trips)
    assert not found.feasible
    assert found.vehicles[0].late_s == pytest.approx(10 * MINUTE)
    assert found.vehicles[1].late_s == 0


def test_the_largest_lateness_comes_first():
    # B is late whatever happens if A waits for it; both share what cannot be avoided.
    trips = [trip("A", 360, 360, 480), trip("B", 380, None, 470)]
    found = schedule(ONE, trips)
    assert found.vehicles[0].late_s == pytest.approx(35 * MINUTE)
    assert found.vehicles[1].late_s == pytest.approx(25 * MINUTE)


def test_who_merges_at_its_origin_leaves_and_waits_there():
    both = company_plan([30, 30], [(0, 0, 1, 10)])
    found = schedule(both, [trip("A", 360), trip("B", 340, 350)])
    assert minutes(found, "B") == [350, 360, 390, 390, 400]
    assert found.vehicles[1].waits[0] == 10 * MINUTE
    assert found.vehicles[0].waiting_s == 0


def test_no_times_no_timetable():
    assert schedule(ONE, [trip("A"), trip("B")]) is None


# -- clocks ----------------------------------------------------------------------------------------


def test_times_of_several_zones_are_one_clock():
    rome, london = timezone(timedelta(hours=1)), UTC
    trips = [
        Trip("A", 0, 1, datetime(2026, 3, 2, 6, tzinfo=rome)),
        Trip("B", 0, 1, datetime(2026, 3, 2, 5, tzinfo=london), None, None),
    ]
    found = schedule(ONE, trips)
    # B may leave at 06:00 of Rome, so A leaves a quarter of an hour later.
    assert found.start == "2026-03-02T06:00:00+01:00"
    assert found.vehicles[0].departure_s == 15 * MINUTE


def test_the_night_the_clocks_change_has_all_its_hours():
    from zoneinfo import ZoneInfo

    rome = ZoneInfo("Europe/Rome")
    # From 01:30 to 04:00 on 29 March 2026 it is an hour and a half.
    trips = [
        Trip("A", 0, 1, datetime(2026, 3, 29, 1, 30, tzinfo=rome)),
        Trip("B", 0, 1, datetime(2026, 3, 29, 4, tzinfo=rome)),
    ]
    found = schedule(ONE, trips)
    a, b = found.vehicles
    assert b.departure_s - a.earliest_departure_s == 90 * MINUTE


# -- mistakes --------------------------------------------------------------------------------------


def test_all_times_have_a_zone_or_none():
    trips = [trip("A", 360), Trip("B", 0, 1, datetime(2026, 3, 2, 6, tzinfo=UTC))]
    with pytest.raises(ScenarioError, match=r"'B', earliest_departure has a time zone, trip 'A'"):
        schedule(ONE, trips)


def test_each_vehicle_needs_its_trip():
    with pytest.raises(ScenarioError, match="vehicle 'B' has no trip"):
        schedule(ONE, [trip("A", 360)])


def test_platoon_mates_need_the_same_time():
    member = ONE.vehicles[1]
    slow = replace(member.legs[1], time_s=4000.0)
    broken = replace(member, legs=(member.legs[0], slow, member.legs[2]))
    with pytest.raises(ScenarioError, match="need from 3600 to 4000 s for one stretch"):
        schedule(with_vehicles(ONE, (ONE.vehicles[0], broken)), [trip("A", 1), trip("B")])


def test_platoon_mates_drive_the_same_legs():
    with pytest.raises(ScenarioError, match="'A' drives with 'B', which is not in the plan"):
        schedule(with_vehicles(ONE, ONE.vehicles[:1]), [trip("A", 1)])


def test_legs_in_a_circle():
    first, second = ONE.vehicles
    a, b = first.legs[1], replace(first.legs[1], edges=(77,))
    circle = (
        replace(first, legs=(a, b)),
        replace(second, legs=(replace(b, partners=("A",)), replace(a, partners=("A",)))),
    )
    with pytest.raises(ScenarioError, match="wait for each other in a circle"):
        schedule(with_vehicles(ONE, circle), [trip("A", 1), trip("B")])


# -- brute force -----------------------------------------------------------------------------------

SPAN = range(-7, 14)
"""Minutes at which vehicles may leave in the brute force."""


@st.composite
def small_cases(draw):
    """Plans of two or three vehicles with few minutes, and windows of whole minutes."""
    stretches = draw(st.lists(st.integers(1, 3), min_size=2, max_size=4))
    members = []
    for _ in range(draw(st.integers(1, 2))):
        i = draw(st.integers(0, len(stretches) - 1))
        j = draw(st.integers(i + 1, len(stretches)))
        members.append((draw(st.integers(0, 3)), i, j, draw(st.integers(0, 2))))
    plan = company_plan(stretches, members)
    trips = []
    for k, vehicle in enumerate(plan.vehicles):
        # A names its earliest departure, so that all have something to go by.
        earliest = draw(st.integers(0, 5)) if k == 0 else draw(st.none() | st.integers(0, 5))
        latest = draw(st.none() | st.integers(earliest or 0, 7))
        arrival = draw(st.none() | st.integers((earliest or 0) + 1, 16))
        trips.append(trip(vehicle.vehicle, earliest, latest, arrival))
    return plan, trips


def driven(plan, departures):
    """When legs start and end [min] if all drive as soon as they can; an oracle by simulation."""
    spans = {name: [] for name in departures}
    waiting = True
    while waiting:
        waiting = False
        for vehicle in plan.vehicles:
            done = spans[vehicle.vehicle]
            if len(done) == len(vehicle.legs):
                continue
            waiting = True
            leg = vehicle.legs[len(done)]
            group = [vehicle.vehicle, *leg.partners]
            ready = []
            for other in plan.vehicles:
                if other.vehicle in group:
                    place = len(spans[other.vehicle])
                    if place < len(other.legs) and other.legs[place].edges == leg.edges:
                        past = spans[other.vehicle]
                        ready.append(past[-1][1] if past else departures[other.vehicle])
            if len(ready) == len(group):
                begin = max(ready)
                for name in group:
                    spans[name].append((begin, begin + leg.time_s / MINUTE))
    return spans


def value(plan, trips, departures, spans):
    """The aims of a schedule in their order [min]."""
    late, waits, arrivals = [0.0], 0.0, 0.0
    for vehicle, one in zip(plan.vehicles, trips, strict=True):
        arrival = spans[vehicle.vehicle][-1][1]
        if one.latest_arrival:
            late.append(max(0.0, arrival - (one.latest_arrival - DAY).total_seconds() / MINUTE))
        waits += arrival - departures[vehicle.vehicle] - vehicle.time_s / MINUTE
        arrivals += arrival
    return max(late), sum(late), waits, arrivals


def allowed(one, minute):
    first, last = one.earliest_departure, one.latest_departure
    return (first is None or at(minute) >= first) and (last is None or at(minute) <= last)


@settings(max_examples=40, deadline=None)
@given(small_cases())
def test_no_choice_of_whole_minutes_is_better(case):
    plan, trips = case
    names = [vehicle.vehicle for vehicle in plan.vehicles]
    choices = [[minute for minute in SPAN if allowed(one, minute)] for one in trips]
    best = min(
        value(plan, trips, leaving, driven(plan, leaving))
        for leaving in (dict(zip(names, some, strict=True)) for some in product(*choices))
    )
    found = schedule(plan, trips)
    leaving = {name: minutes(found, name)[0] for name in names}
    spans = {
        name: list(zip(minutes(found, name)[1::2], minutes(found, name)[2::2], strict=True))
        for name in names
    }
    assert value(plan, trips, leaving, spans) == pytest.approx(best, abs=1e-3)
    assert found.feasible == (best[0] == 0)


# -- what always holds -----------------------------------------------------------------------------


@st.composite
def timed(draw):
    """A planned problem with times; at least one vehicle names one."""
    net, weights, trips = draw(problems())
    trips = [Trip(one.vehicle, one.origin, one.destination) for one in trips]
    windows = []
    for k in range(len(trips)):
        earliest = draw(st.integers(0, 240)) if k == 0 else draw(st.none() | st.integers(0, 240))
        latest = draw(st.none() | st.integers(earliest or 0, 400))
        arrival = draw(st.none() | st.integers((earliest or 0) + 1, 1200))
        windows.append((earliest, latest, arrival))
    timed_trips = [
        replace(one, earliest_departure=at(e), latest_departure=at(d), latest_arrival=at(a))
        for one, (e, d, a) in zip(trips, windows, strict=True)
    ]
    case = draw(st.sampled_from("ABC" if len(trips) != 2 else "ABCD"))
    return net, weights, timed_trips, case


def planned(problem):
    net, weights, trips, case = problem
    return net, trips, plan_joint(net, weights, trips, case)


def starts_of_edges(net, vehicle, times):
    """When a vehicle enters each edge of its route [s]."""
    found = {}
    for leg, (begin, _) in zip(vehicle.legs, times.legs, strict=True):
        edges = np.array(leg.edges)
        seconds = net.length_m[edges] / net.speed_mps[edges]
        for edge, before in zip(leg.edges, np.cumsum(seconds) - seconds, strict=True):
            found[edge] = begin + before
    return found


@settings(max_examples=40, deadline=None)
@given(timed())
def test_windows_waiting_and_company(problem):
    net, trips, plan = planned(problem)
    table = plan.timetable
    zero = datetime.fromisoformat(table.start)
    for one, vehicle, times in zip(trips, plan.vehicles, table.vehicles, strict=True):
        leaves = zero + timedelta(seconds=times.departure_s)
        near = timedelta(milliseconds=5)
        assert one.earliest_departure is None or leaves >= one.earliest_departure - near
        assert one.latest_departure is None or leaves <= one.latest_departure + near
        assert all(wait >= 0 for wait in times.waits)
        assert all(
            one <= two for (_, one), (two, _) in zip(times.legs, times.legs[1:], strict=False)
        )
        for k, (leg, (begin, end)) in enumerate(zip(vehicle.legs, times.legs, strict=True)):
            assert end - begin == pytest.approx(leg.time_s, abs=1e-3)
            before = {vehicle.vehicle, *vehicle.legs[k - 1].partners} if k else {vehicle.vehicle}
            if times.waits[k]:
                # There is nobody to wait for where nobody joins.
                assert {vehicle.vehicle, *leg.partners} - before
    entered = [
        starts_of_edges(net, vehicle, times)
        for vehicle, times in zip(plan.vehicles, table.vehicles, strict=True)
    ]
    names = [vehicle.vehicle for vehicle in plan.vehicles]
    for vehicle, own in zip(plan.vehicles, entered, strict=True):
        for leg in vehicle.legs:
            for partner in leg.partners:
                other = entered[names.index(partner)]
                for edge in leg.edges:
                    assert own[edge] == pytest.approx(other[edge], abs=1e-3)
    assert ROUTES_GIVEN in plan.proof["conditions"]
    assert any("not feasible in time" in remark for remark in plan.remarks) != table.feasible


@settings(max_examples=20, deadline=None)
@given(timed(), st.integers(-100_000, 100_000))
def test_shifted_windows_shift_all_times(problem, by):
    _, trips, plan = planned(problem)

    def moved(moment):
        return None if moment is None else moment + timedelta(minutes=by)

    later = [
        replace(
            one,
            earliest_departure=moved(one.earliest_departure),
            latest_departure=moved(one.latest_departure),
            latest_arrival=moved(one.latest_arrival),
        )
        for one in trips
    ]
    found = schedule(plan, later, PATIENCE_MIN * MINUTE)
    assert found.feasible == plan.timetable.feasible
    starts = [datetime.fromisoformat(text.start) for text in (plan.timetable, found)]
    gap = (starts[1] - starts[0]).total_seconds() - by * MINUTE
    for one, two in zip(plan.timetable.vehicles, found.vehicles, strict=True):
        assert two.departure_s + gap == pytest.approx(one.departure_s, abs=0.02)
        assert two.arrival_s + gap == pytest.approx(one.arrival_s, abs=0.02)


def can_be_in_time(plan, trips):
    """Whether all windows fit together: no circle of demands has a positive sum (longest paths)."""
    demands = []  # (a, b, s): b is at least s after a

    def moment(when):
        return (when - DAY).total_seconds()

    for one, vehicle in zip(trips, plan.vehicles, strict=True):
        name = vehicle.vehicle
        leave = ("leave", name)
        stops = []
        for k, leg in enumerate(vehicle.legs):
            key = (frozenset({name, *leg.partners}), leg.edges) if leg.partners else (name, k)
            begin, end = ("begin", key), ("end", key)
            demands += [(begin, end, leg.time_s), (end, begin, -leg.time_s)]
            demands.append((stops[-1] if stops else leave, begin, 0.0))
            if not stops and not leg.partners:
                demands.append((begin, leave, 0.0))
            stops.append(end)
        if one.earliest_departure:
            demands.append(("zero", leave, moment(one.earliest_departure)))
        if one.latest_departure:
            demands.append((leave, "zero", -moment(one.latest_departure)))
        if one.latest_arrival:
            demands.append((stops[-1], "zero", -moment(one.latest_arrival)))
    longest = {key: 0.0 for a, b, _ in demands for key in (a, b)}
    for _ in range(len(longest) + 1):
        changed = False
        for a, b, least in demands:
            if longest[a] + least > longest[b] + 1e-6:
                longest[b] = longest[a] + least
                changed = True
        if not changed:
            return True
    return False


@settings(max_examples=40, deadline=None)
@given(timed())
def test_in_time_if_and_only_if_longest_paths_allow_it(problem):
    _, trips, plan = planned(problem)
    assert plan.timetable.feasible == can_be_in_time(plan, trips)


def test_fifty_vehicles_that_come_and_go():
    members = [(7 + k % 5, k, min(k + 10, 50), 3) for k in range(49)]
    plan = company_plan([5] * 50, members)
    trips = [trip(vehicle.vehicle, 360 + k) for k, vehicle in enumerate(plan.vehicles)]
    found = schedule(plan, trips)
    assert found.feasible
    # Each may leave a minute after the one before, and merges 5 minutes farther on.
    assert found.waiting_s == 0
    entered = [dict(zip([leg.edges for leg in vehicle.legs], times.legs, strict=True))
               for vehicle, times in zip(plan.vehicles, found.vehicles, strict=True)]  # fmt: skip
    for own in entered[1:]:
        for edges, span in own.items():
            if edges in entered[0]:
                assert span == entered[0][edges]


# -- through the planner ---------------------------------------------------------------------------


def test_plan_joint_fills_in_the_times():
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    weights = paper_weights(net)
    trips = [Trip("A", 0, 3, at(360)), Trip("B", 4, 5, at(350), at(351))]
    plan = plan_joint(net, weights, trips, "C", master="A")
    # 10 km at 80 km/h take 7 min 30 s: B is there at 05:58:30 and A at 06:07:30.
    assert plan.timetable.vehicles[1].waiting_s == pytest.approx(9 * MINUTE)
    assert plan.proof["conditions"][-1] == ROUTES_GIVEN
    without = plan_joint(net, weights, [Trip("A", 0, 3), Trip("B", 4, 5)], "C", master="A")
    assert without.timetable is None
    (remark,) = plan.remarks
    assert remark.startswith(
        "B may drive at 60 km/h instead of 80 to road near Pavia: it then wait"
    )
    assert replace(plan, timetable=None, proof=without.proof, remarks=()) == without


def test_a_plan_that_cannot_be_in_time_says_by_how_much():
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    trips = [Trip("A", 0, 3, at(360), None, at(370)), Trip("B", 4, 5, at(350))]
    plan = plan_joint(net, paper_weights(net), trips, "C", master="A")
    assert not plan.timetable.feasible
    assert plan.remarks[-1].startswith("not feasible in time: late even alone: A by 13 min")
    assert "Note: not feasible in time" in plan.summary()
