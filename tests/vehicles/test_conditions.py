"""Conditional tags: read, settled for a vehicle and a moment, and never a reason to stop."""

from datetime import datetime, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.vehicles.conditional_values import has_conditions, rules_of
from platoon_osm.vehicles.conditions import apply, next_change
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE as TRUCK
from platoon_osm.vehicles.profile import VEHICLES, Vehicle

VAN = VEHICLES["van-3.5t"]
GAS = Vehicle("gas", tunnel_code="B")
RIGID = Vehicle("rigid", length_m=10, mass_t=7.0, rating_t=12.0, axle_load_t=4.5, trailer=False)
MONDAY = datetime(2026, 3, 2, 8, 0)
BERLIN = (13.4, 52.5)


def settled(text, key="hgv", plain=None, vehicle=TRUCK, when=None, place=None, country=None):
    tags = {f"{key}:conditional": text} | ({} if plain is None else {key: plain})
    found, undecided = apply(tags, vehicle, when, place, country)
    assert all(not name.endswith(":conditional") for name in found)
    return found.get(key), undecided


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("no @ 22:00-06:00", ["no"]),
        ("no@(22:00-06:00)", ["no"]),
        ("no @ (Mo-Fr 06:00-09:00; PH off)", ["no"]),
        ("no @ Mo-Fr 06:00-09:00; PH off", ["no"]),
        ("60 @ (22:00-06:00); 80 @ (wet)", ["60", "80"]),
        ("destination @ (weight>7.5 AND 22:00-06:00) ; no @ (length>12);", ["destination", "no"]),
        ("", []),
        (";;", []),
    ],
)
def test_a_value_falls_into_rules(text, values):
    assert [rule.value for rule in rules_of(text)] == values


@pytest.mark.parametrize(
    "text",
    [
        "no @ (weight>7.5 AND Mo-Fr 06:00-10:00)",
        "no @ ((weight>7.5) AND (Mo-Fr 06:00-10:00))",
        "no @ (weight>7.5) and (Mo-Fr 06:00-10:00)",
        "no @ weight>7.5 AND Mo-Fr 06:00-10:00",
        "no @ (weight > 7.5 t && Mo-Fr 06:00-10:00)",
    ],
)
def test_conditions_are_joined_with_and_without_brackets(text):
    assert rules_of(text)[0].conditions[1] == "Mo-Fr 06:00-10:00"
    assert settled(text, when=MONDAY) == ("no", False)
    assert settled(text, when=MONDAY + timedelta(hours=2)) == (None, False)
    assert settled(text, when=MONDAY, vehicle=VAN) == (None, False)
    assert settled(text) == (None, True)
    assert settled(text, vehicle=VAN) == (None, False)  # whatever the hour


@pytest.mark.parametrize(
    ("condition", "vehicle", "holds"),
    [
        ("weight>7.5", TRUCK, True), ("weight>7.5", RIGID, False),
        ("weightrating>7.5", RIGID, True), ("weight>=40", TRUCK, True), ("weight>40", TRUCK, False),
        ("weight>7500 kg", TRUCK, True), ("weight>26000 lbs", TRUCK, True),
        ("weight<3.5", VAN, False), ("weight<=3.5", VAN, True), ("weight>7,5", TRUCK, True),
        ("weight>44.1 st", TRUCK, False), ("weight>44 st", TRUCK, True),
        ("length>12", TRUCK, True), ("length>12 m", RIGID, False), ("length>40'", TRUCK, True),
        ("length>55 ft", TRUCK, False), ("height>12'6\"", TRUCK, True), ("height>4", TRUCK, False),
        ("width>2.5", TRUCK, True), ("width>255 cm", TRUCK, False),
        ("axleload>10", TRUCK, True), ("axleload>10", RIGID, False),
        ("trailer", TRUCK, True), ("trailer", RIGID, False), ("trailer=no", RIGID, True),
        ("hgv", TRUCK, True), ("hgv", VAN, False), ("goods", VAN, True), ("goods", TRUCK, False),
        ("hazmat", TRUCK, False), ("hazmat", GAS, True),
        ("hgv_articulated", RIGID, False), ("hgv_articulated", TRUCK, True),
        ("psv", TRUCK, False), ("bus", TRUCK, False), ("emergency", TRUCK, False),
        ("motor_vehicle", VAN, True), ("occupants>=2", TRUCK, False),
        ("axles>4", TRUCK, None), ("wet", TRUCK, None), ("snow", TRUCK, None),
        ("winter", TRUCK, None), ("SH", TRUCK, None), ("axles>4 t", TRUCK, None),
        ("weight>7.5 m", TRUCK, None), ("weight>heavy", TRUCK, None),
        ("emissions<euro_5", TRUCK, None), ("no idea", TRUCK, None), ("()", TRUCK, None),
    ],
)  # fmt: skip
def test_a_vehicle_is_asked(condition, vehicle, holds):
    """What is known of it is decided, with and without a moment; what is not, is counted."""
    for when in (None, MONDAY):
        found, undecided = settled(f"50 @ ({condition})", "maxspeed", "80", vehicle, when)
        assert (found, undecided) == ("50" if holds else "80", holds is None)


@pytest.mark.parametrize(
    ("times", "when", "holds"),
    [
        ("22:00-05:00", "2026-03-02T23:00", True), ("22:00-05:00", "2026-03-02T04:59", True),
        ("22:00-05:00", "2026-03-02T05:00", False), ("22:00-05:00", "2026-03-02T21:59", False),
        ("Mo-Fr 07:00-19:00", "2026-03-01T12:00", False),
        ("Su,PH 00:00-22:00", "2026-03-01T12:00", True),
        ("Su,PH 00:00-22:00", "2026-05-01T12:00", True),
        ("Su,PH 00:00-22:00", "2026-05-02T12:00", False),
        ("PH", "2026-12-25T12:00", True), ("Nov-Mar", "2026-01-10T12:00", True),
        ("Apr 15-Oct 15", "2026-04-14T12:00", False), ("Apr 15-Oct 15", "2026-04-15T12:00", True),
        ("sunset-sunrise", "2026-06-21T20:00", False), ("sunset-sunrise", "2026-12-21T17:00", True),
        ("24/7", "2026-03-01T12:00", True),
    ],
)  # fmt: skip
def test_times_are_read_for_a_moment(times, when, holds):
    moment = datetime.fromisoformat(when)
    found = settled(f"no @ ({times})", when=moment, place=BERLIN, country="DE")
    assert found == ("no" if holds else None, False)
    assert settled(f"no @ ({times})", place=BERLIN, country="DE") == (None, True)


@pytest.mark.parametrize(
    "times", ["PH", "Mo-Fr,PH 10:00-12:00", "sunset-sunrise", "SH", "SH 08:00-16:00"]
)
def test_times_that_ask_for_what_is_not_known_are_undecided(times):
    assert settled(f"no @ ({times})", when=MONDAY) == (None, True)


def test_of_the_rules_that_hold_the_last_counts():
    text = "60 @ (hgv); 40 @ (22:00-06:00); 80 @ (psv)"
    assert settled(text, "maxspeed", "100", when=MONDAY) == ("60", False)
    assert settled(text, "maxspeed", "100", when=datetime(2026, 3, 2, 23)) == ("40", False)
    assert settled(text, "maxspeed", "100") == ("60", True)
    # A rule that holds for sure beats undecided ones before it.
    assert settled("40 @ (wet); 60 @ (hgv)", "maxspeed") == ("60", False)


def test_what_would_change_nothing_is_not_open():
    assert settled("no @ (22:00-06:00)", plain="no") == ("no", False)
    assert settled("yes @ (06:00-22:00)", plain="no") == ("no", True)


@pytest.mark.parametrize(
    ("text", "plain", "expected"),
    [
        ("yes @ destination", "no", ("destination", False)),
        ("yes @ (delivery AND 06:00-10:00)", "no", ("delivery", False)),
        ("destination @ (weight>7.5)", "yes", ("destination", False)),
        ("no @ (destination)", "yes", ("yes", True)),
        ("permissive @ (customers)", "no", ("customers", False)),
        ("yes @ (delivery AND weight<7.5)", "no", ("no", False)),
    ],
)
def test_a_purpose_is_for_the_ends_of_a_trip(text, plain, expected):
    assert settled(text, plain=plain, when=MONDAY) == expected


def test_a_limit_lifted_for_a_purpose_stands_and_is_counted():
    """Whether somebody delivers there is not known where the limit is read."""
    assert settled("none @ destination", "maxweight", "7.5") == ("7.5", True)


def test_several_keys_are_settled_each():
    tags = {
        "maxspeed": "80", "maxspeed:hgv:conditional": "60 @ (22:00-06:00)", "ref": "A 1",
        "hgv:conditional": "no @ (22:00-05:00)",
    }  # fmt: skip
    night, day = datetime(2026, 3, 2, 23), MONDAY
    kept = {"maxspeed": "80", "ref": "A 1"}
    assert apply(tags, TRUCK, day) == (kept, False)
    assert apply(tags, TRUCK, night) == ({**kept, "maxspeed:hgv": "60", "hgv": "no"}, False)
    assert apply(tags, TRUCK) == (kept, True)


@pytest.mark.parametrize("key", ["hour_on", "access:day_off", "date_on", "hgv:hour_off"])
def test_old_forms_are_counted_and_taken_out(key):
    assert has_conditions({key: "22:00"})
    assert apply({key: "22:00", "hgv": "no"}, TRUCK, MONDAY) == ({"hgv": "no"}, True)


def test_tags_without_conditions_stay():
    assert not has_conditions({"hgv": "no"})
    assert apply({"hgv": "no"}, TRUCK) == ({"hgv": "no"}, False)


def test_when_it_changes_next():
    tags = {"hgv:conditional": "no @ (22:00-05:00)"}
    assert next_change(tags, TRUCK, MONDAY) == datetime(2026, 3, 2, 22)
    assert next_change(tags, TRUCK, datetime(2026, 3, 2, 23)) == datetime(2026, 3, 3, 5)
    # Nothing changes for who is not meant, nor where another rule wins all day.
    light = {"hgv:conditional": "no @ (22:00-05:00 AND weight>7.5)"}
    assert next_change(light, VAN, MONDAY) is None
    both = {"hgv:conditional": "no @ (22:00-05:00); no @ (hgv)"}
    assert next_change(both, TRUCK, MONDAY) is None
    assert next_change({"hgv": "no"}, TRUCK, MONDAY) is None


PIECES = st.sampled_from([
    "no", "60", " @ ", "(", ")", ";", "Mo-Fr", "22:00-05:00", "weight>7.5", "AND", "PH", "SH",
    "wet", "sunset", "-", ",", "destination", "2026", "Feb 30", "week 1-53",
    "\"x\"", "'", "\x00", "é",
    " ", "off", "||", "25:00-48:00", "easter", "+1 days", "00:00", "length>9e999", "weight>1e5 t",
])  # fmt: skip
TEXTS = st.one_of(st.text(max_size=30), st.lists(PIECES, max_size=12).map("".join))
MOMENTS = st.one_of(st.none(), st.datetimes())


@given(key=st.sampled_from(["hgv", "maxspeed", "", "access"]), text=TEXTS, when=MOMENTS,
       place=st.sampled_from([None, BERLIN, (180.0, -90.0)]),
       country=st.sampled_from([None, "DE", "ZZ", "", "de"]))  # fmt: skip
def test_no_text_stops_anybody(key, text, when, place, country):
    tags = {f"{key}:conditional": text, "hgv": "yes"}
    found, undecided = apply(tags, TRUCK, when, place, country)
    assert isinstance(undecided, bool)
    assert all(isinstance(value, str) for value in found.values())
    if when is not None:
        change = next_change(tags, TRUCK, when, place, country)
        assert change is None or change > when


HOURS = st.integers(0, 23)


@given(begin=HOURS, end=HOURS, start=st.integers(0, 24 * 60 * 14))
def test_changes_are_those_of_a_walk_by_hours(begin, end, start):
    """The next change is the first moment whose tags differ."""
    if begin == end:
        return
    tags = {"hgv:conditional": f"no @ (Mo-Fr {begin:02}:00-{end:02}:00)"}
    at = datetime(2026, 3, 2) + timedelta(minutes=start)
    now, found = apply(tags, TRUCK, at), next_change(tags, TRUCK, at)
    assert found is not None
    assert apply(tags, TRUCK, found) != now
    hours = -(-int((found - at).total_seconds()) // 3600)
    assert all(apply(tags, TRUCK, at + timedelta(hours=k)) == now for k in range(hours))
    assert apply(tags, TRUCK, found - timedelta(minutes=1)) == now
