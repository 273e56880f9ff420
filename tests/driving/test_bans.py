"""Driving bans: what laws say, as intervals of time."""

import tomllib
from datetime import UTC, date, datetime, timedelta
from zoneinfo import ZoneInfo

import pytest
from hypothesis import given
from hypothesis import strategies as st
from places import ROOT

from platoon_osm.driving.bans.calendar import holidays_of, season_of
from platoon_osm.driving.bans.judging import banned, driving_intervals
from platoon_osm.driving.bans.rules import BANNED_COUNTRIES, Road, bans_of
from platoon_osm.errors import ScenarioError
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE as TRUCK
from platoon_osm.vehicles.profile import VEHICLES, Vehicle

VAN = VEHICLES["van-3.5t"]
FIVE = Vehicle("five", mass_t=5, trailer=False, length_m=8)
PULLING = Vehicle("pulling", mass_t=5, trailer=True, length_m=8)
TEN = Vehicle("ten", mass_t=10, trailer=False, length_m=9)
ADR = Vehicle("adr", tunnel_code="D")
MINUTE = timedelta(minutes=1)


def is_banned(country, at, vehicle=TRUCK, **told):
    moment = datetime.fromisoformat(at)
    return bool(banned(country, vehicle, moment, moment + MINUTE, **told))


# The laws named in the files; weekdays: 2026-03-01 is a Sunday, 2026-05-01 a Friday.
HOURS = [
    ("AT", "2026-03-07T14:59", False), ("AT", "2026-03-07T15:00", True),
    ("AT", "2026-03-08T21:59", True), ("AT", "2026-03-08T22:00", False),
    ("AT", "2026-10-26T12:00", True), ("AT", "2026-04-03T12:00", False),
    ("CH", "2026-03-01T23:59", True), ("CH", "2026-03-02T04:59", True),
    ("CH", "2026-03-02T05:00", False), ("CH", "2026-08-01T12:00", True),
    ("CH", "2026-12-26T12:00", False), ("CH", "2024-12-26T12:00", True),
    ("CZ", "2026-03-01T12:59", False), ("CZ", "2026-03-01T13:00", True),
    ("CZ", "2026-07-03T18:00", True), ("CZ", "2026-06-26T18:00", False),
    ("CZ", "2026-08-29T08:00", True), ("CZ", "2026-09-28T14:00", True),
    ("DE", "2026-03-01T00:00", True), ("DE", "2026-03-01T22:00", False),
    ("DE", "2026-01-06T12:00", False), ("DE", "2026-06-04T12:00", True),
    ("DE", "2026-10-03T12:00", True), ("DE", "2026-02-28T12:00", False),
    ("ES", "2026-03-01T12:00", False),
    ("FR", "2026-02-28T22:00", True), ("FR", "2026-02-28T21:59", False),
    ("FR", "2026-03-01T22:00", False), ("FR", "2026-04-30T23:00", True),
    ("FR", "2025-07-05T08:00", True), ("FR", "2025-08-09T08:00", False),
    ("HU", "2026-02-28T22:30", True), ("HU", "2026-07-04T15:00", True),
    ("HU", "2026-06-27T15:00", False), ("HU", "2026-10-22T23:00", True),
    ("HU", "2026-01-02T12:00", False),  # worked in for on 10 January
    ("IT", "2026-03-01T08:59", False), ("IT", "2026-03-01T09:00", True),
    ("IT", "2026-03-01T22:00", False), ("IT", "2026-06-07T07:00", True),
    ("IT", "2026-10-04T07:30", False), ("IT", "2026-06-02T07:00", True),
    ("IT", "2026-04-03T14:00", True), ("IT", "2026-04-04T15:59", True),
    ("IT", "2026-04-07T13:59", True), ("IT", "2026-04-07T14:00", False),
    ("IT", "2026-07-04T15:59", True), ("IT", "2026-07-04T16:00", False),
    # As printed of the decree of 2024.
    ("IT", "2024-07-26T16:00", True), ("IT", "2024-07-19T16:00", False),
    ("IT", "2024-08-09T21:00", True), ("IT", "2024-08-10T21:59", True),
    ("IT", "2024-08-16T17:00", False), ("IT", "2024-08-17T16:00", False),
    ("IT", "2024-08-15T07:00", True), ("IT", "2024-08-31T08:00", True),
    ("PL", "2026-03-01T12:00", False), ("PL", "2026-01-06T12:00", False),
    ("PL", "2026-05-01T08:00", True), ("PL", "2026-04-30T18:00", True),
    ("PL", "2026-12-24T19:00", False), ("PL", "2026-06-26T18:00", True),
    ("PL", "2026-06-19T18:00", False), ("PL", "2026-08-30T12:00", True),
    ("SI", "2026-03-01T08:00", True), ("SI", "2026-04-03T14:00", True),
    ("SI", "2026-06-27T08:00", True), ("SI", "2026-06-20T08:00", False),
    ("SI", "2026-09-05T12:59", True), ("SI", "2026-09-12T12:00", False),
    ("SK", "2026-03-01T21:59", True), ("SK", "2026-11-17T12:00", False),
    ("SK", "2026-04-03T12:00", True), ("SK", "2026-12-24T12:00", False),
    ("SK", "2026-12-27T12:00", True), ("SK", "2026-07-04T07:00", True),
]  # fmt: skip


@pytest.mark.parametrize(("country", "at", "expected"), HOURS)
def test_bans_are_those_of_the_laws(country, at, expected):
    assert is_banned(country, at) == expected


@pytest.mark.parametrize(
    ("country", "at", "vehicle", "expected"),
    [
        ("DE", "2026-03-01T12:00", FIVE, False), ("DE", "2026-03-01T12:00", TEN, True),
        ("AT", "2026-03-01T12:00", PULLING, True), ("AT", "2026-03-01T12:00", FIVE, False),
        ("CH", "2026-03-01T12:00", FIVE, True), ("CH", "2026-03-01T12:00", VAN, False),
        ("PL", "2026-05-01T12:00", TEN, False), ("CZ", "2026-03-01T14:00", PULLING, True),
        ("ES", "2026-03-01T12:00", ADR, True), ("ES", "2026-03-01T07:59", ADR, False),
        # What the papers allow counts, not the load.
        ("DE", "2026-03-01T12:00", Vehicle("empty", mass_t=6, rating_t=12), True),
    ],
)  # fmt: skip
def test_bans_are_for_some_vehicles(country, at, vehicle, expected):
    assert is_banned(country, at, vehicle) == expected


def test_a_quiet_vehicle_drives_at_night_in_austria():
    assert not is_banned("AT", "2026-03-03T23:00")
    assert is_banned("AT", "2026-03-03T23:00", quiet=False)
    assert is_banned("CH", "2026-03-03T23:00")


@pytest.mark.parametrize(
    ("country", "at", "road", "expected"),
    [
        ("DE", "2026-07-04T12:00", Road("motorway", "A 7"), True),
        ("DE", "2026-07-04T12:00", Road("motorway", "A 20;A 7"), True),
        ("DE", "2026-07-04T12:00", Road("motorway", "A 20"), False),
        ("CZ", "2026-03-01T14:00", Road("secondary", "150"), False),
        ("CZ", "2026-03-01T14:00", Road("primary", "3"), True),
        ("HR", "2026-07-04T12:00", Road("primary", "D8"), True),
        ("HR", "2026-07-04T12:00", Road("primary", "DC 8"), True),
        ("HR", "2026-07-04T12:00", Road("motorway", "A1"), False),
        ("HR", "2026-06-13T12:00", Road("primary", "D8"), False),
    ],
)
def test_bans_are_for_some_roads(country, at, road, expected):
    assert is_banned(country, at, road=road) == expected


def test_a_night_is_shorter_when_clocks_go_forward():
    (night,) = banned("CH", TRUCK, datetime(2026, 3, 27, 23), datetime(2026, 3, 27, 23, 1))
    assert night.end.astimezone(UTC) - night.begin.astimezone(UTC) == timedelta(hours=7)
    spring = [
        ban
        for ban in banned("CH", TRUCK, datetime(2026, 3, 28, 21), datetime(2026, 3, 29, 6))
        if ban.name == "night ban"
    ]
    assert spring[0].end.astimezone(UTC) - spring[0].begin.astimezone(UTC) == timedelta(hours=6)
    assert (spring[0].begin.hour, spring[0].end.hour) == (22, 5)


def test_moments_with_a_zone_are_moved_to_the_country():
    tokyo = datetime(2026, 3, 1, 17, 0, tzinfo=ZoneInfo("Asia/Tokyo"))  # 9:00 in Rome
    assert banned("IT", TRUCK, tokyo, tokyo + MINUTE)
    assert not banned("IT", TRUCK, tokyo - 2 * MINUTE, tokyo - MINUTE)
    assert banned("it", TRUCK, tokyo, tokyo + MINUTE)[0].begin.utcoffset() == timedelta(hours=1)


def test_countries_without_bans_here_have_none():
    assert banned("NL", TRUCK, datetime(2026, 3, 1), datetime(2026, 3, 2)) == []
    whole = (datetime(2026, 3, 1), datetime(2026, 3, 2))
    assert driving_intervals("NL", TRUCK, *whole) == [whole]


def test_wrong_moments_end_in_one_line():
    with pytest.raises(ScenarioError, match="more than ten years"):
        banned("DE", TRUCK, datetime(2000, 1, 1), datetime(2026, 1, 1))
    with pytest.raises(ScenarioError, match="both without"):
        banned("DE", TRUCK, datetime(2026, 1, 1), datetime(2026, 1, 1, tzinfo=UTC))


@given(
    country=st.sampled_from(BANNED_COUNTRIES),
    start=st.datetimes(datetime(2024, 1, 1), datetime(2028, 1, 1)),
    hours=st.integers(1, 24 * 20),
)
def test_a_time_is_either_banned_or_allowed(country, start, hours):
    zone = ZoneInfo(bans_of(country).zone)
    first = start.replace(tzinfo=UTC)
    last = first + timedelta(hours=hours)
    bans = banned(country, TRUCK, first, last)
    free = driving_intervals(country, TRUCK, first, last)
    assert all(ban.begin < ban.end and ban.begin.tzinfo == zone and ban.source for ban in bans)
    for k in range(0, hours * 60, 37):
        at = first + timedelta(minutes=k)
        in_ban = any(ban.begin.astimezone(UTC) <= at < ban.end.astimezone(UTC) for ban in bans)
        in_free = any(a.astimezone(UTC) <= at < b.astimezone(UTC) for a, b in free)
        assert in_ban != in_free


def test_holidays_are_those_of_the_laws():
    assert date(2026, 1, 6) not in holidays_of(bans_of("PL"), 2026)
    assert date(2026, 4, 6) in holidays_of(bans_of("FR"), 2026)
    assert date(2026, 9, 15) not in holidays_of(bans_of("SK"), 2026)  # worked since 2026


def test_seasons_begin_on_weekdays():
    assert season_of(("Fr from 06-21", "last Su to 08-31"), 2024) == (
        date(2024, 6, 21), date(2024, 8, 25),
    )  # fmt: skip
    assert season_of(("last Sa to 06-29", "Su from 09-02"), 2012) == (
        date(2012, 6, 23), date(2012, 9, 2),
    )  # fmt: skip


@pytest.mark.parametrize("country", BANNED_COUNTRIES)
def test_every_rule_has_its_source(country):
    bans = bans_of(country)
    assert bans.country == country
    assert bans.rules
    for rule in bans.rules:
        assert all((rule.source, rule.page, rule.exceptions, rule.name)), rule
        assert all(len(hours.split("-")) == 2 for hours in rule.hours)
    file = ROOT / "platoon_osm" / "driving" / "bans" / "countries" / f"{country.lower()}.toml"
    named = {key for rule in tomllib.loads(file.read_text("utf-8"))["rules"] for key in rule}
    assert named <= set(type(bans.rules[0]).__slots__)


def table_row(bans, rule):
    """Return a rule as docs/hours.md shows it."""
    evening = " (the day before)" if rule.day_before else ""
    days = ", ".join(rule.days)
    who = "dangerous goods" if rule.load else f"over {rule.over_t:g} t"
    if rule.with_trailer_over_t:
        who += f", with a trailer over {rule.with_trailer_over_t:g} t"
    if rule.over_m:
        who += f", or over {rule.over_m:g} m"
    if rule.unless:
        who += f", unless {rule.unless}"
    cells = (
        bans.country, rule.name, f"{days}{evening}", ", ".join(rule.hours),
        " to ".join(rule.season) or "all year", who, ", ".join(rule.roads),
        f"{rule.source}; {rule.page}", rule.exceptions,
    )  # fmt: skip
    return "| " + " | ".join(cells) + " |"


def test_the_table_in_the_docs_is_the_data():
    text = (ROOT / "docs" / "hours.md").read_text("utf-8")
    rows = [
        table_row(bans_of(country), rule)
        for country in BANNED_COUNTRIES
        for rule in bans_of(country).rules
    ]
    shown = [line for line in text.splitlines() if line[:2] == "| " and line[4:6] == " |"]
    assert shown == rows
    for country in BANNED_COUNTRIES:
        for words in bans_of(country).left_out:
            assert f"- {country}: {words}." in text
