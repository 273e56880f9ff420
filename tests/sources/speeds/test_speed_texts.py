"""Texts of speed limits: the rules of the wiki, and what people write besides."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.sources.speeds.texts import read_limit, read_speed_kmh

MPH, KNOT = 1.609344, 1.852


@pytest.mark.parametrize(
    ("text", "kmh"),
    [
        ("80", 80), ("80.5", 80.5), (" 80 ", 80), ("080", 80), ("80 km/h", 80), ("80km/h", 80),
        ("80 kmh", 80), ("80 KPH", 80), ("80,5", 80.5), ("80,5 km/h", 80.5), ("８０", 80),
        ("55 mph", 55 * MPH), ("55mph", 55 * MPH), ("65 MPH", 65 * MPH),
        ("10 knots", 10 * KNOT), ("10 knot", 10 * KNOT),
        ("70|100", 70), ("100|70|80", 70), ("|100", 100), ("80;100", 80), ("none|80", 80),
        ("50,60", 50), ("70|signals", 70), ("variable|50", 50),
        # A unit that stands once holds for the list.
        ("55;60 mph", 55 * MPH), ("60 mph;55", 55 * MPH), ("65 mph | 55", 55 * MPH),
        ("55;60 mph;70 km/h", 55), ("60-80", 60), ("60 - 80", 60), ("80–60", 60),
        ("35-45 mph", 35 * MPH),
        # What is said of trucks is for them.
        ("60 (hgv)", 60), ("60 km/h hgv", 60), ("100;60 (hgv)", 60), ("55 mph trucks", 55 * MPH),
        ("none", 150), ("None", 150), ("unlimited", 150), ("no limit", 150),
        ("IT:motorway", 130), ("DE:motorway", 150), ("motorway", 130), ("IT:trunk", 110),
        ("FR:rural", 80), ("DE:rural", 100), ("RO:urban", 50), ("DE:living_street", 20),
        ("walk", 7), ("DE:walk", 7), ("CH:urban", 50), ("BE-VLG:rural", 70), ("ZW:rural", 90),
        ("GB:nsl_dual", 70 * MPH), ("GB:nsl_single", 60 * MPH), ("GB:nsl_restricted", 30 * MPH),
        ("uk:nsl_single", 60 * MPH), ("IT:motorway:hgv", 130),
        ("DE:zone:30", 30), ("DE:zone30", 30), ("IT:30", 30), ("GB:20", 20 * MPH),
        ("US:urban", 50), ("US-NY:rural", 55 * MPH), ("DE:bicycle_road", 30),
        ("signals", None), ("variable", None), ("", None), ("|", None), ("IT:0", None),
        ("DE:999", None), ("DE:zone:999", None),
    ],
)  # fmt: skip
def test_what_is_understood(text, kmh):
    assert read_speed_kmh(text) == (None if kmh is None else pytest.approx(kmh))


@pytest.mark.parametrize(
    ("text", "kmh"),
    [
        ("60/80", 60), ("80 90", 80), ("60 or 80", 60), ("60?", 60), ("~80", 80), ("-50", 50),
        ("max 60", 60), ("50 (Mo-Fr 07:00-17:00)", 50), ("80 @ (22:00-06:00)", 80),
        ("fast 60;90", 60), ("80 furlongs", 80),
        ("55/65 mph", 55 * MPH), ("70 (wet) 90", 70), ("100 (cars) / 80 (hgv)", 80),
        # Slips of the pen and what nobody can read: not a number that a plan may rest on.
        ("70100", None), ("1000", None), ("0", None), ("2", None), ("fast", None),
        ("DE:fast", None), ("1e2", None), ("nan", None), ("inf", None), ("9" * 400, None),
        ("999 mph", None), ("1 knot", None),
    ],
)  # fmt: skip
def test_of_what_is_not_understood_the_lowest_number_is_taken(text, kmh):
    limit = read_limit(text)
    assert not limit.sure
    assert limit.trucks == (None if kmh is None else pytest.approx(kmh))


def test_a_limit_for_trucks_is_none_for_cars():
    limit = read_limit("100; 60 (hgv)")
    assert (limit.trucks, limit.cars, limit.sure) == (60, 100, True)
    assert read_limit("60 (hgv)").cars is None


ANYTHING = st.text(max_size=12) | st.from_regex(
    r"([A-Z]{2}:[a-z]*:?[0-9]{0,4}|[0-9. |;,/-]{1,9}( ?mph| ?km/h| ?knots| \(hgv\)| hgv|@)?){1,2}",
    fullmatch=True,
)


@settings(max_examples=300, deadline=None)
@given(ANYTHING)
def test_no_text_gives_a_speed_that_no_truck_drives(text):
    kmh = read_speed_kmh(text)
    assert kmh is None or 3 <= kmh <= 150


SPEEDS = st.integers(3, 93)
BETWEEN = st.sampled_from([";", "|", " / ", " - ", " to ", " und ", "; max ", " | ca. ", ", "])


@settings(max_examples=200, deadline=None)
@given(st.lists(SPEEDS, min_size=1, max_size=4), BETWEEN, st.sampled_from(["", " mph", " km/h"]))
def test_no_list_is_faster_than_its_lowest_number(numbers, between, unit):
    kmh = read_speed_kmh(between.join(map(str, numbers)) + unit)
    assert kmh == pytest.approx(min(numbers) * (MPH if unit == " mph" else 1))


@settings(max_examples=200, deadline=None)
@given(st.text(alphabet="0123456789 abc()/?+", max_size=14))
def test_odd_texts_are_no_faster_than_the_lowest_speed_in_them(text):
    speeds = [float(digits) for digits in re.findall(r"\d+", text)]
    lowest = min((speed for speed in speeds if 3 <= speed <= 150), default=None)
    assert read_limit(text).trucks == lowest
