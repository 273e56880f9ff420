"""Plans whose times keep to driving bans and to the hours of roads."""

from datetime import datetime, timedelta
from functools import cache
from zoneinfo import ZoneInfo

import pytest
from bundled import italy as italy_map
from hypothesis import given, settings
from hypothesis import strategies as st
from roads_with_hours import in_country, row_with_turn_offs

import platoon_osm as po
from platoon_osm.network.placed import network_below
from platoon_osm.planning.timing.hours_check import broken_hours
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE, VEHICLES

ROME = ZoneInfo("Europe/Rome")
HALF_MINUTE = timedelta(seconds=30)


def at(text):
    return datetime.fromisoformat(text).replace(tzinfo=ROME)


@cache
def italy():
    return in_country(italy_map(), "IT")


@cache
def straight(text="no @ (07:00-19:00)", zone_country=""):
    """Return the row with a name for each road and junction."""
    return row_with_turn_offs(
        zone_country, text, ref=[f"S {k}" for k in range(7)], node_name=[f"N{k}" for k in range(8)]
    )


def planned(net, *trips, **told):
    return po.plan_joint(net, po.paper_weights(net), list(trips), **told)


def broken(plan, net, vehicles=None):
    vehicles = vehicles or [DEFAULT_VEHICLE] * len(plan.trips)
    return broken_hours(plan, network_below(net), vehicles)


def local(plan, index, seconds):
    moment = plan.timetable.clock.moment(seconds)
    return moment if moment.tzinfo is None else moment.astimezone(ROME)


def left_at(plan, index=0):
    return local(plan, index, plan.timetable.vehicles[index].departure_s)


def near(one, text):
    wanted = datetime.fromisoformat(text)
    return abs(one.replace(tzinfo=None) - wanted) < HALF_MINUTE


def test_a_departure_waits_for_the_end_of_a_ban():
    """2026-03-01 is a Sunday: no heavy vehicle drives from 9 to 22."""
    plan = planned(italy(), po.Trip("A", "Torino", "Trieste", at("2026-03-01T08:30")))
    assert broken(plan, italy()) == []
    assert near(left_at(plan), "2026-03-01T22:00")
    (remark,) = plan.remarks
    assert remark == ("A keeps to the Sunday and holiday ban of IT: it leaves 13 h 30 min later")


def test_a_light_vehicle_and_a_weekday_are_left_alone():
    van = VEHICLES["van-3.5t"]
    sunday = po.Trip("A", "Torino", "Trieste", at("2026-03-01T08:30"), profile=van)
    plan = planned(italy(), sunday)
    assert near(left_at(plan), "2026-03-01T08:30")
    assert plan.remarks == ()
    monday = planned(italy(), po.Trip("A", "Torino", "Trieste", at("2026-03-02T08:30")))
    assert near(left_at(monday), "2026-03-02T08:30")
    assert monday.remarks == ()


def test_who_must_leave_early_stops_on_its_way():
    trip = po.Trip(
        "A", "Torino", "Trieste", at("2026-03-01T06:00"), latest_departure=at("2026-03-01T07:00")
    )
    plan = planned(italy(), trip)
    times = plan.timetable.vehicles[0]
    assert broken(plan, italy()) == []
    assert left_at(plan) <= at("2026-03-01T07:00")
    assert sum(wait > 0 for wait in times.waits) == 1
    stop = next(k for k, wait in enumerate(times.waits) if wait)
    assert local(plan, 0, times.legs[stop - 1][1]) <= at("2026-03-01T09:00:01")
    assert near(local(plan, 0, times.legs[stop][0]), "2026-03-01T22:00")
    assert "stands 13 h" in plan.remarks[0]


def test_a_stop_takes_nothing_from_a_journey():
    """Lengths, costs and edges are those of the plan without a stop; every output is written."""
    free = po.Trip("A", "Torino", "Trieste", at("2026-03-03T06:00"), at("2026-03-03T07:00"))
    shut = po.Trip("A", "Torino", "Trieste", at("2026-03-01T06:00"), at("2026-03-01T07:00"))
    one, two = planned(italy(), free), planned(italy(), shut)
    assert len(two.stretches) == len(one.stretches) + 1
    for name in ("length_m", "drive_s", "inferred_m"):
        assert sum(getattr(s, name) for s in two.stretches) == pytest.approx(
            sum(getattr(s, name) for s in one.stretches)
        )
    assert two.joint_cost == pytest.approx(one.joint_cost)
    assert [e for s in two.stretches for e in s.edges] == [
        e for s in one.stretches for e in s.edges
    ]
    assert po.Plan.from_dict(two.to_dict()) == two


def test_a_plan_with_a_stop_is_shown(tmp_path):
    """A stands at a junction until the road opens at 19:00, and B with it."""
    net = straight()
    trips = [
        po.Trip("A", "N0", "N4", datetime(2026, 3, 2, 6), datetime(2026, 3, 2, 6, 30)),
        po.Trip("B", "N1", "N4", datetime(2026, 3, 2, 6), datetime(2026, 3, 2, 7, 30)),
    ]
    plan = planned(net, *trips)
    assert broken(plan, net) == []
    assert all(times.waiting_s > 9 * 3600 for times in plan.timetable.vehicles)
    po.write_html(plan, net, tmp_path / "plan.html")
    assert "keeps to the hours of S 2" in (tmp_path / "plan.html").read_text("utf-8")
    assert "keeps to the hours of S 2 (hgv=no)" in plan.summary()


def test_who_cannot_keep_a_ban_is_named():
    trip = po.Trip(
        "A", "Torino", "Trieste", at("2026-03-01T06:00"), latest_arrival=at("2026-03-01T14:00")
    )
    plan = planned(italy(), trip)
    assert plan.timetable.feasible
    assert broken(plan, italy())
    (remark,) = plan.remarks
    assert remark.startswith(
        "A drives while it may not (the Sunday and holiday ban of IT), from 2026-03-01 09:00 to "
    )


def test_a_latest_arrival_is_met_before_a_ban():
    """Without an earliest departure it leaves so early that it is there in time."""
    trip = po.Trip("A", "Torino", "Trieste", latest_arrival=at("2026-03-01T14:00"))
    plan = planned(italy(), trip)
    assert broken(plan, italy()) == []
    arrives = local(plan, 0, plan.timetable.vehicles[0].arrival_s)
    assert near(arrives, "2026-03-01T09:00")


def test_two_that_drive_together_keep_a_ban_together():
    plan = planned(
        italy(),
        po.Trip("A", "Torino", "Trieste", at("2026-03-01T06:00")),
        po.Trip("B", "Milano", "Trieste", at("2026-03-01T07:00")),
    )
    assert plan.saving > 0
    assert broken(plan, italy()) == []
    assert all(times.waiting_s == 0 for times in plan.timetable.vehicles)
    assert min(left_at(plan, 0), left_at(plan, 1)) >= at("2026-03-01T22:00") - HALF_MINUTE


def test_company_makes_nobody_break_a_ban():
    """A cannot keep it; B can, if it does not wait for A."""
    plan = planned(
        italy(),
        po.Trip("A", "Torino", "Trieste", at("2026-03-01T06:00"), None, at("2026-03-01T14:00")),
        po.Trip("B", "Milano", "Venezia", at("2026-03-01T05:00"), None, at("2026-03-01T23:00")),
    )
    assert {one.vehicle for one in broken(plan, italy())} == {0}
    assert plan.platoon_m == 0
    assert any(remark.startswith("driven apart") for remark in plan.remarks)
    assert [trip.reason for trip in plan.trips if trip.reason]
    assert plan.proof.cost == pytest.approx(plan.joint_cost)


def test_others_stay_together_without_who_breaks_a_ban():
    plan = planned(
        italy(),
        po.Trip("A", "Torino", "Trieste", at("2026-03-01T06:00"), None, at("2026-03-01T14:00")),
        po.Trip("B", "Milano", "Venezia", at("2026-03-01T05:00"), None, at("2026-03-01T23:00")),
        po.Trip("C", "Milano", "Venezia", at("2026-03-01T05:00"), None, at("2026-03-01T23:00")),
    )
    assert {one.vehicle for one in broken(plan, italy())} == {0}
    assert {vehicle.vehicle for vehicle in plan.vehicles if vehicle.platoon_m} == {"B", "C"}


def test_times_without_a_zone_are_those_of_the_country():
    plan = planned(italy(), po.Trip("A", "Torino", "Trieste", datetime(2026, 3, 1, 8, 30)))
    assert left_at(plan) == datetime(2026, 3, 1, 22)


@pytest.mark.parametrize(
    ("leaves", "expected"),
    [
        # From N0 to N2 it takes 90 min, and 45 min on to N3 by the road that closes at 7:00.
        ("2026-03-02T03:00", "2026-03-02T03:00"), ("2026-03-02T04:45", "2026-03-02T04:45"),
        ("2026-03-02T04:47", "2026-03-02T17:30"), ("2026-03-02T17:00", "2026-03-02T17:30"),
        ("2026-03-02T18:00", "2026-03-02T18:00"),
    ],
)  # fmt: skip
def test_a_road_is_passed_while_it_is_open(leaves, expected):
    net = straight()
    plan = planned(net, po.Trip("A", "N0", "N4", datetime.fromisoformat(leaves)))
    assert broken(plan, net) == []
    assert near(left_at(plan), expected)


def test_hours_are_for_those_they_are_made_for():
    net = straight("no @ (07:00-19:00 AND weight>44)")
    plan = planned(net, po.Trip("A", "N0", "N4", datetime(2026, 3, 2, 8)))
    assert left_at(plan) == datetime(2026, 3, 2, 8)
    assert plan.remarks == ()


def test_without_times_hours_and_bans_are_counted():
    plan = planned(straight(), po.Trip("A", "N0", "N4"))
    assert plan.remarks == ("passes roads with hours, not judged without times: A: S 2 (60.0 km)",)
    plan = planned(italy(), po.Trip("A", "Torino", "Trieste"))
    assert plan.remarks == ("driving bans are not judged without times: IT",)


def test_a_network_of_no_country_has_no_bans():
    net = italy_map()
    empty = in_country(net, "")
    plan = planned(empty, po.Trip("A", "Torino", "Trieste", at("2026-03-01T08:30")))
    assert near(left_at(plan), "2026-03-01T08:30")


def as_open(net):
    """Return the same network without hours."""
    return in_country(net, "")


WINDOWS = st.tuples(
    st.integers(0, 47), st.none() | st.integers(0, 6), st.none() | st.integers(4, 40)
)


@settings(max_examples=20)
@given(st.lists(WINDOWS, min_size=1, max_size=2), st.integers(0, 23), st.integers(1, 20))
def test_nobody_is_on_a_closed_road_if_that_can_be(windows, begin, long):
    """With room in the windows nobody breaks the hours, and windows are kept in any case."""
    end = (begin + long) % 24
    net = straight(f"no @ ({begin:02}:00-{end:02}:00)") if begin != end else straight()
    trips = []
    for name, start, (leave, latest, room) in zip("AB", ("N0", "N1"), windows, strict=False):
        first = datetime(2026, 3, 2) + timedelta(hours=leave)
        trips.append(
            po.Trip(
                name, start, "N4", first,
                None if latest is None else first + timedelta(hours=latest),
                None if room is None else first + timedelta(hours=room),
            )
        )  # fmt: skip
    plan = planned(net, *trips)
    left = {one.vehicle for one in broken(plan, net)}
    for index, (trip, (_, _, room)) in enumerate(zip(trips, windows, strict=False)):
        times = plan.timetable.vehicles[index]
        assert (
            plan.timetable.clock.moment(times.departure_s) >= trip.earliest_departure - HALF_MINUTE
        )
        assert times.late_s < 0.1
        named = any(remark.startswith(f"{trip.vehicle} drives while") for remark in plan.remarks)
        assert named == (index in left)
        if len(trips) == 1 and (room is None or room >= 28):
            assert not left
    # Company makes nobody break the hours.
    for index in left if len(trips) > 1 else ():
        assert broken(planned(net, trips[index]), net)


def test_the_check_sees_what_the_times_break():
    """Times of a plan for other hours, on the network with these."""
    net = straight()
    plan = planned(
        straight("no @ (01:00-01:30)"), po.Trip("A", "N0", "N4", datetime(2026, 3, 2, 8))
    )
    (found,) = broken(plan, net)
    assert (found.vehicle, found.road) == (0, "S 2")
    assert near(found.begin, "2026-03-02T09:30")
    assert near(found.end, "2026-03-02T10:15")
    assert found.why == "the hours of S 2 (hgv=no)"


def test_a_remark_tells_times_as_clocks_show_them():
    """Clocks go forward on the Sunday: 9:00 is seven hours after midnight and eight before it."""
    trip = po.Trip(
        "A", "Torino", "Trieste", at("2026-03-28T23:00"), at("2026-03-29T08:00"),
        at("2026-03-29T15:00"),
    )  # fmt: skip
    other = po.Trip("B", "Torino", "Trieste", at("2026-03-29T07:00"), None, at("2026-03-29T15:00"))
    plan = planned(italy(), trip, other)
    assert {one.vehicle for one in broken(plan, italy())} == {1}
    assert any("B drives while" in remark and "09:00 to" in remark for remark in plan.remarks)


def test_trips_of_other_years_are_judged_each():
    plan = planned(
        italy(),
        po.Trip("A", "Torino", "Milano", datetime(1950, 1, 1, 8)),
        po.Trip("B", "Torino", "Milano", datetime(2100, 3, 7, 12)),
    )
    assert broken(plan, italy()) == []
    assert [remark[:10] for remark in plan.remarks] == ["A keeps to", "B keeps to"]
