"""Texts of heights and slopes."""

from math import inf, isnan, tan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.sources.slopes import (
    NO_SIZE,
    STEEP,
    UNREAD,
    read_height_m,
    read_slope,
    slope_along,
)


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("350", 350), ("350.5", 350.5), ("350 m", 350), ("350m", 350), (" 350  m ", 350),
        ("+350", 350), ("-3", -3), ("\u22123 m", -3), ("0", 0), ("350,5", 350.5),
        ("350,50 m", 350.5),
        ("1148 ft", 349.9104), ("1,148 ft", 349.9104), ("1148'", 349.9104), ("1148 feet", 349.9104),
        ("1,148", 1148), ("1.148,5 m", 1148.5), ("1,148.5", 1148.5), ("1 148 m", 1148),
        ("350,125", 350.125), ("1,148.25 ft", 1148.25 * 0.3048), ("350;352", 351),
        ("350; 352 m", 351),
        ("~350", 350), ("ca. 350 m", 350), ("350.125", 350.125), ("0,5", 0.5), ("8848", 8848),
    ],
)  # fmt: skip
def test_heights(text, metres):
    assert read_height_m(text) == pytest.approx(metres)


@pytest.mark.parametrize(
    "text",
    ["", ";", "high", "350 yd", "350;high", "3 50", "nan", "inf", "1e3", "3..5", "-", "350 m NN",
     "12'6\"", "\u0663\u0665\u0660", "yes"],
)  # fmt: skip
def test_what_is_no_height(text):
    assert isnan(read_height_m(text))


@pytest.mark.parametrize("text", ["9001", "-451", "35000 ft", "99999999", "350;12000"])
def test_heights_of_no_road(text):
    assert read_height_m(text) == inf


@pytest.mark.parametrize(
    ("text", "slope"),
    [
        ("5%", 0.05), ("5 %", 0.05), ("-7.5 %", -0.075), ("7,5%", 0.075), ("+4%", 0.04),
        ("\u22124%", -0.04), ("0", 0), ("0%", 0), ("flat", 0),
        ("10\u00b0", tan(0.17453292519943295)),
        ("-10 deg", -tan(0.17453292519943295)), ("1:12", 1 / 12), ("-1:12", -1 / 12),
        ("1 in 10", 0.1), ("5-10%", 0.075), ("5%-10%", 0.075), ("5 % - 10 %", 0.075),
        ("-5-10%", -0.075), ("5\u20137%", 0.06), ("5%;7%", 0.06), ("~6%", 0.06), ("ca. 6 %", 0.06),
        ("30%", 0.3), ("-30%", -0.3), ("12\u2030", 0.012), ("-4%;-6%", -0.05), ("0-6%", 0.03),
    ],
)  # fmt: skip
def test_slopes(text, slope):
    assert read_slope(text) == (pytest.approx(slope), "")


@pytest.mark.parametrize(
    ("text", "remark"),
    [
        ("up", NO_SIZE), ("down", NO_SIZE), ("Up", NO_SIZE), ("yes", NO_SIZE), ("up;down", NO_SIZE),
        ("31%", STEEP), ("-100%", STEEP), ("45\u00b0", STEEP), ("1:2", STEEP), ("750%", STEEP),
        ("5", UNREAD), ("steep", UNREAD), ("", UNREAD), (";", UNREAD), ("5%;up", UNREAD),
        ("-5%;5%", UNREAD), ("<10%", UNREAD), ("90\u00b0", UNREAD), ("1:0", UNREAD),
        ("nan%", UNREAD),
        ("5%-10\u00b0", UNREAD), ("1.2.3%", UNREAD), ("%", UNREAD),
    ],
)  # fmt: skip
def test_slopes_that_say_nothing_are_told(text, remark):
    slope, told = read_slope(text)
    assert isnan(slope)
    assert told == remark


def test_what_holds_against_the_way_is_turned_round():
    assert slope_along({"incline:forward": "5%"}) == (pytest.approx(0.05), "")
    assert slope_along({"incline:backward": "5%"}) == (pytest.approx(-0.05), "")
    assert slope_along({"incline": "2%", "incline:backward": "5%"}) == (pytest.approx(0.02), "")
    assert slope_along({})[1] == ""
    assert isnan(slope_along({"incline:backward": "up"})[0])


@given(st.text(alphabet="0123456789.,-+;:% \u00b0mft'~inupdow", max_size=12))
def test_any_text_is_read_or_told(text):
    height = read_height_m(text)
    assert isnan(height) or height == inf or -450 <= height <= 9000
    slope, remark = read_slope(text)
    assert isnan(slope) == bool(remark)
    assert isnan(slope) or abs(slope) <= 0.3


@given(st.floats(-0.3, 0.3))
def test_a_slope_that_is_written_is_read(slope):
    assert read_slope(f"{100 * slope:.6f}%")[0] == pytest.approx(slope, abs=1e-8)
    assert read_slope(f"{100 * slope:.6f} %".replace(".", ","))[0] == pytest.approx(slope, abs=1e-8)
