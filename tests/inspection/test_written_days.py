"""Days and weeks written by hand: the checker finds what a person finds, and nothing else."""

from __future__ import annotations

import pytest
from driving_days import EU_DAYS, US_DAYS, Written, told

from platoon_osm.inspection.eu561 import eu561_violations
from platoon_osm.inspection.us395 import us395_violations


@pytest.mark.parametrize("day", EU_DAYS, ids=lambda day: day.day[:60])
def test_days_under_561_2006(day: Written) -> None:
    assert sorted(map(told, eu561_violations(day.record, day.state))) == sorted(day.wrong)


@pytest.mark.parametrize("day", US_DAYS, ids=lambda day: day.day[:60])
def test_days_under_49_cfr_395(day: Written) -> None:
    found = us395_violations(day.record, day.state, **day.options)
    assert sorted(map(told, found)) == sorted(day.wrong)
