"""Days with times, in every form that cells have."""

from datetime import UTC, date, datetime, time, timedelta, timezone

import pytest
from hypothesis import given
from hypothesis import strategies as st

from platoon_osm.errors import ScenarioError
from platoon_osm.planning.scenario.clock_texts import moment

SIX = datetime(2026, 3, 2, 6)


@pytest.mark.parametrize(
    "text",
    [
        "2026-03-02 06:00", "2026-03-02T06:00", "2026-03-02T06:00:00", " 2026-03-02 06:00 ",
        "02.03.2026 06:00", "2.3.2026 6:00", "02.03.2026 06:00:00", "02.03.2026, 06:00",
        "02.03.2026T06:00", "2026/03/02 06:00", "2026/3/2 6:00", "2026-3-2 6:00",
        "2026.03.02 06:00", "02.03.2026  06:00",
    ],
)  # fmt: skip
def test_forms(text):
    assert moment("here", text) == SIX


def test_zones():
    plus_one = timezone(timedelta(hours=1))
    assert moment("here", "2026-03-02T06:00:00+01:00") == SIX.replace(tzinfo=plus_one)
    assert moment("here", "2026-03-02T06:00Z") == SIX.replace(tzinfo=UTC)
    assert moment("here", SIX) is SIX


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("03/02/2026 06:00", "may put the day or the month first"),
        ("13/02/2026 06:00", "may put the day or the month first"),
        ("3-2-2026 06:00", "may put the day or the month first"),
        ("02/03/26 06:00", "may put the day or the month first"),
        ("02.03.26 06:00", "has a year of two digits"),
        ("2026-03-02 06:00 AM", "must count its hours to 24"),
        ("6:00 p.m.", "must count its hours to 24"),
        ("46083.25", "is a spreadsheet's number for a day"),
        ("46083,25", "is a spreadsheet's number for a day"),
        ("46083", "is a spreadsheet's number for a day"),
        ("2026-03-02", "must be a day and a time"),
        ("02.03.2026", "must be a day and a time"),
        ("06:00", "must be a day and a time"),
        ("soon", "must be a day and a time"),
        ("32.03.2026 06:00", "must be a day and a time"),
        ("02.13.2026 06:00", "must be a day and a time"),
        ("02.03.2026 25:00", "must be a day and a time"),
        ("29.02.2026 06:00", "must be a day and a time"),
        ("", "must be a day and a time"),
        (46083.25, "must be a day and a time"),
        (True, "must be a day and a time"),
        (None, "must be a day and a time"),
        ([], "must be a day and a time"),
        (date(2026, 3, 2), "= 2026-03-02 must be a day and a time"),
        (time(6), "= 06:00:00 must be a day and a time"),
    ],
)
def test_what_is_none(value, said):
    with pytest.raises(ScenarioError, match=r"^here = ") as error:
        moment("here", value)
    assert said in str(error.value)
    assert "\n" not in str(error.value)


MOMENTS = st.datetimes(datetime(1900, 1, 1), datetime(8999, 1, 1)).map(
    lambda at: at.replace(microsecond=0)
)


@given(MOMENTS, st.sampled_from(["%Y-%m-%d %H:%M:%S", "%d.%m.%Y %H:%M:%S", "%Y/%m/%d %H:%M:%S"]))
def test_written_and_read(at, form):
    assert moment("here", at.strftime(form)) == at


def read(text):
    """Return what a text is read as, and what is said of it."""
    try:
        return moment("here", text), ""
    except ScenarioError as error:
        return None, str(error)


@given(st.text(max_size=30))
def test_any_text_is_a_moment_or_told(text):
    found, said = read(text)
    assert isinstance(found, datetime) == (not said)
    assert "\n" not in said
    assert len(said) < 300
