"""Nights of a clock change: every time in the offset that holds then, against zoneinfo itself."""

import json
from dataclasses import asdict
from datetime import UTC, datetime, timedelta, timezone
from zoneinfo import ZoneInfo

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from random_networks import network

from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import ScenarioError
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.clock import Clock
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.timetable import Timetable, VehicleTimes
from platoon_osm.plans.trip import Trip
from platoon_osm.plans.zones import clock_of, in_order

ROME, ANGELES = ZoneInfo("Europe/Rome"), ZoneInfo("America/Los_Angeles")
HOUR, DAY = 3600.0, 86_400.0
NIGHTS = [
    datetime(2026, 3, 28, 22, tzinfo=ROME), datetime(2026, 10, 24, 22, tzinfo=ROME),
    datetime(2026, 3, 7, 22, tzinfo=ANGELES), datetime(2026, 10, 31, 22, tzinfo=ANGELES),
    # Half an hour, southern summer, and a zone whose clocks never change.
    datetime(2026, 4, 4, 22, tzinfo=ZoneInfo("Australia/Lord_Howe")),
    datetime(2026, 10, 3, 22, tzinfo=ZoneInfo("Australia/Sydney")),
    datetime(2026, 3, 28, 22, tzinfo=ZoneInfo("Asia/Kolkata")),
]  # fmt: skip


def local(first, seconds):
    """What zoneinfo says of a moment: the oracle."""
    return (first.astimezone(UTC) + timedelta(seconds=seconds)).astimezone(first.tzinfo)


def is_shown_twice(moment):
    """Whether clocks show this time twice: it reads the same with the other fold."""
    return moment.replace(fold=0).utcoffset() != moment.replace(fold=1).utcoffset()


def text_by_hand(clock_start, moment):
    """Hours and minutes of a moment on whole minutes, days from the start, offset if need be."""
    days = (moment.date() - clock_start.date()).days
    text = f"{moment:%H:%M}" + (f" {days:+d} d" if days else "")
    if not is_shown_twice(moment):
        return text
    hours, minutes = divmod(round(moment.utcoffset() / timedelta(minutes=1)), 60)
    return f"{text} UTC{hours:+d}" + (f":{minutes:02d}" if minutes else "")


@pytest.mark.parametrize("first", NIGHTS, ids=str)
@settings(max_examples=60, deadline=None)
@given(
    shift=st.integers(-2 * 1440, 2 * 1440),
    minutes=st.lists(st.integers(-3 * 1440, 9 * 1440), max_size=8),
)
@example(shift=0, minutes=list(range(0, 720, 10)))
def test_every_moment_is_that_of_zoneinfo(first, shift, minutes):
    shown = [60.0 * k for k in minutes]
    clock = clock_of(first, shift * 60, shown)
    start = local(first, shift * 60)
    assert clock.start.isoformat() == start.isoformat()
    for seconds in shown:
        expected = local(first, shift * 60 + seconds)
        found = clock.moment(seconds)
        # As texts, for Python finds moments of an hour that comes twice equal to nothing.
        assert found.isoformat() == expected.isoformat()
        assert clock.text(seconds) == text_by_hand(start, expected)
        assert clock.iso(seconds) == expected.isoformat(timespec="seconds")
        assert clock.seconds(found) == seconds
    # It is kept as plain numbers, and shows the same where no zone is known.
    again = Clock.from_text(clock.start.isoformat(), clock.name, clock.offsets)
    assert [again.text(at) for at in shown] == [clock.text(at) for at in shown]


def test_both_nights_by_hand():
    spring = clock_of(NIGHTS[0], 0, [0, 8 * HOUR])
    assert [spring.text(k * HOUR) for k in range(7)] == [
        "22:00", "23:00", "00:00 +1 d", "01:00 +1 d", "03:00 +1 d", "04:00 +1 d", "05:00 +1 d",
    ]  # fmt: skip
    assert spring.zone == "Europe/Rome (UTC+01:00 until 02:00 +1 d, then UTC+02:00)"
    # A time that is rounded to the minute of the change is shown as what begins then.
    assert spring.text(4 * HOUR - 20) == "03:00 +1 d"
    autumn = clock_of(NIGHTS[1], 0, [0, 8 * HOUR])
    assert [autumn.text(k * HOUR) for k in range(3, 7)] == [
        "01:00 +1 d", "02:00 +1 d UTC+2", "02:00 +1 d UTC+1", "03:00 +1 d",
    ]  # fmt: skip
    assert autumn.zone == "Europe/Rome (UTC+02:00 until 03:00 +1 d, then UTC+01:00)"
    west = clock_of(NIGHTS[3], 0, [0, 8 * HOUR])
    assert west.text(3 * HOUR) == "01:00 +1 d UTC-7"
    assert west.text(4 * HOUR) == "01:00 +1 d UTC-8"


@pytest.mark.parametrize(
    ("zone", "text"),
    [
        (ROME, "Europe/Rome (UTC+01:00)"), (UTC, "UTC"), (ZoneInfo("UTC"), "UTC"),
        (timezone(timedelta(hours=2)), "UTC+02:00"), (None, "local time"),
    ],
)  # fmt: skip
def test_without_a_change_nothing_is_kept(zone, text):
    clock = clock_of(datetime(2026, 1, 15, 6, tzinfo=zone), 0, [-DAY, 5 * DAY])
    assert clock.offsets == ()
    assert clock.zone == text


def test_several_changes_and_times_far_off():
    clock = clock_of(datetime(2026, 3, 1, tzinfo=ROME), 0, [0, 300 * DAY])
    assert len(clock.offsets) == 3
    assert clock.zone.count("until") == 2
    # A time asked for in a thousand years takes no time to show.
    assert len(clock_of(datetime(2026, 3, 1, tzinfo=ROME), 0, [1000 * 365 * DAY]).offsets) < 9


@settings(max_examples=100, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 300), st.sampled_from([0, 1])), min_size=2, max_size=4))
def test_moments_of_one_zone_are_in_the_order_in_which_they_come(named):
    night = datetime(2026, 10, 25, 0, tzinfo=ROME)
    moments = [(night + timedelta(minutes=m)).replace(fold=fold) for m, fold in named]
    in_time = sorted(moments, key=in_order)
    stamps = [moment.timestamp() for moment in in_time]
    assert stamps == sorted(stamps)


# -- plans ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def road():
    """Two edges of 110 km, an hour each."""
    net = network([0, 1], [1, 2], [110e3, 110e3])
    return net, paper_weights(net)


def hours_of(net):
    return float((net.length_m / net.speed_mps).sum()) / HOUR


@pytest.mark.parametrize("first", NIGHTS[:4], ids=str)
def test_a_plan_over_the_night_keeps_what_it_needs(road, first):
    net, weights = road
    # It leaves so that clocks change while it drives.
    leaves = local(first, 3.5 * HOUR)
    trips = [Trip("A", 0, 2, leaves), Trip("B", 0, 1, local(first, 2 * HOUR))]
    plan = plan_joint(net, weights, trips, "C")
    table = plan.timetable
    assert table.zone == first.tzinfo.key
    assert len(table.offsets) == 2
    for times in table.vehicles:
        for at in times.moments:
            shown = table.clock.moment(at)
            assert shown.utcoffset() == shown.astimezone(first.tzinfo).utcoffset()
    # The face of the clock goes an hour too far, or too little; the drive does not.
    (a, _) = table.vehicles
    assert a.arrival_s - a.departure_s == pytest.approx(hours_of(net) * HOUR)
    faces = [table.clock.moment(at).replace(tzinfo=None) for at in (a.departure_s, a.arrival_s)]
    passed = (faces[1] - faces[0]).total_seconds()
    assert abs(passed - hours_of(net) * HOUR) == pytest.approx(HOUR, abs=1)
    again = Plan.from_dict(json.loads(json.dumps(plan.to_dict())))
    assert again == plan
    assert again.summary() == plan.summary()
    assert table.clock.zone in plan.summary()


def test_trips_of_two_zones_are_shown_in_that_of_the_first(road):
    net, weights = road
    rome = datetime(2026, 10, 25, 1, tzinfo=ROME)
    # The same night in Los Angeles is the afternoon before; clocks there change a week later.
    west = datetime(2026, 10, 24, 17, tzinfo=ANGELES)
    table = plan_joint(net, weights, [Trip("A", 0, 2, west), Trip("B", 0, 2, rome)], "C").timetable
    assert table.zone == "Europe/Rome"
    (departure,) = {times.departure_s for times in table.vehicles}
    assert table.clock.moment(departure).isoformat() == "2026-10-25T02:00:00+02:00"


def test_fixed_offsets_stay_what_they_are(road):
    net, weights = road
    summer, winter = timezone(timedelta(hours=2)), timezone(timedelta(hours=1))
    trips = [
        Trip("A", 0, 2, datetime(2026, 10, 25, 1, tzinfo=summer)),
        Trip("B", 0, 2, datetime(2026, 10, 25, 4, tzinfo=winter)),
    ]
    table = plan_joint(net, weights, trips, "C", master="A").timetable
    # Nobody named a zone, so nobody knows that clocks change: all times in the first offset.
    assert (table.zone, table.offsets) == ("", ())
    assert table.clock.zone == "UTC+02:00"


def test_the_hour_that_comes_twice_is_no_contradiction():
    first = datetime(2026, 10, 25, 2, 50, tzinfo=ROME)
    # Twenty minutes later clocks show 02:10 for the second time.
    Trip("A", 0, 1, first, first.replace(minute=10, fold=1))
    with pytest.raises(ScenarioError, match="is not after earliest_departure"):
        Trip("A", 0, 1, first.replace(minute=10, fold=1), first)
    # In spring, an hour of the face is none.
    Trip("A", 0, 1, datetime(2026, 3, 29, 1, 50, tzinfo=ROME),
         datetime(2026, 3, 29, 3, 5, tzinfo=ROME))  # fmt: skip


def test_another_packages_zone_will_do():
    class Told(type(UTC).__base__):
        """A zone without a name, as some packages have: Rome's."""

        def utcoffset(self, moment):
            return moment.replace(tzinfo=ROME).utcoffset()

        def dst(self, moment):
            return moment.replace(tzinfo=ROME).dst()

        def tzname(self, _):
            return "?"

        def fromutc(self, moment):
            return ROME.fromutc(moment.replace(tzinfo=ROME)).replace(tzinfo=self)

    clock = clock_of(datetime(2026, 10, 24, 22, tzinfo=Told()), 0, [8 * HOUR])
    assert clock.name == ""
    assert clock.zone == "UTC+02:00 until 03:00 +1 d, then UTC+01:00"


TIMES = VehicleTimes("A", 0.0, ((0.0, HOUR),))


@pytest.mark.parametrize(
    ("offsets", "said"),
    [
        ([[0, 3600], [0, 7200]], "moments in order"), ([[5, 3600], [0, 7200]], "moments in order"),
        ([[0, "x"]], "moments in order"), ([[float("nan"), 3600]], "moments in order"),
        ([[0, 90_000]], "a day or more"), ([[0, 7200]], "do not fit the start"),
        ([[0]], "does not fit"), (3, "does not fit"), ([[0, True]], "moments in order"),
    ],
)  # fmt: skip
def test_damaged_offsets_are_refused(road, offsets, said):
    net, weights = road
    start = datetime(2026, 1, 15, 6, tzinfo=ROME)
    data = json.loads(json.dumps(plan_joint(net, weights, [Trip("A", 0, 2, start)], "C").to_dict()))
    data["timetable"]["offsets"] = offsets
    with pytest.raises(ScenarioError, match=said) as error:
        Plan.from_dict(data)
    assert "\n" not in str(error.value)


def test_a_zone_that_is_no_name_is_refused():
    with pytest.raises(ScenarioError, match="zone 3 is no name"):
        Timetable("2026-01-15T06:00:00+01:00", True, (TIMES,), zone=3)
    table = Timetable("2026-01-15T06:00:00+01:00", True, (TIMES,))
    assert Timetable.from_dict(asdict(table)) == table
