"""Times of day and time spans as people read them."""

from datetime import UTC, datetime, timedelta, timezone

import pytest

from platoon_osm.errors import ScenarioError
from platoon_osm.plans.clock import Clock, duration

SIX = datetime(2026, 3, 2, 6)


@pytest.mark.parametrize(
    ("seconds", "text"),
    [
        (0, "06:00"), (29.9, "06:00"), (30, "06:01"), (90, "06:02"), (8460, "08:21"),
        (64_800, "00:00 +1 d"), (64_769, "23:59"), (-21_600, "00:00"), (-21_631, "23:59 -1 d"),
        (18 * 3600 + 86_400, "00:00 +2 d"),
    ],
)  # fmt: skip
def test_times_of_day(seconds, text):
    assert Clock(SIX).text(seconds) == text


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0, "0 min"), (29, "0 min"), (30, "1 min"), (3569, "59 min"), (3570, "1 h 00 min"),
     (3900, "1 h 05 min"), (100 * 3600, "100 h 00 min")],
)  # fmt: skip
def test_durations(seconds, text):
    assert duration(seconds) == text


@pytest.mark.parametrize(
    ("zone", "text"),
    [
        (None, "local time"), (UTC, "UTC"), (timezone(timedelta(hours=1)), "UTC+01:00"),
        (timezone(timedelta(hours=-3, minutes=-30)), "UTC-03:30"),
    ],
)  # fmt: skip
def test_zones(zone, text):
    clock = Clock.at(SIX.replace(tzinfo=zone))
    assert clock.zone == text
    assert Clock.from_text(clock.start.isoformat()) == clock


def test_moments():
    clock = Clock.at(SIX)
    assert clock.moment(90) == datetime(2026, 3, 2, 6, 1, 30)
    assert clock.seconds(clock.moment(90)) == 90
    assert clock.iso(90.6) == "2026-03-02T06:01:31"


@pytest.mark.parametrize("text", ["", "today", "2026-13-01T00:00:00", None, 7])
def test_no_moment(text):
    with pytest.raises(ScenarioError, match="is no ISO 8601 moment; plan again"):
        Clock.from_text(text)
