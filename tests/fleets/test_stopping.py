"""How far a search is: of its time, less what telling and writing the plan takes."""

from __future__ import annotations

import pytest

from platoon_osm.fleets import stopping
from platoon_osm.fleets.limits import Limits
from platoon_osm.fleets.stopping import Course


class _Clock:
    now = 5.0

    def monotonic(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> _Clock:
    own = _Clock()
    monkeypatch.setattr(stopping, "time", own)
    return own


def test_the_search_ends_so_early_that_closing_fits(clock: _Clock) -> None:
    course = Course(Limits(time_s=100), lambda: False)
    course.closing_s = 20.0
    half, whole = course.until(0.5), course.until(1.0)
    clock.now = 5.0 + 39.9
    assert not half()
    assert course.share == pytest.approx(39.9 / 80)
    clock.now = 5.0 + 40.0
    assert half()
    assert not whole()
    course.closing_s = 60.0
    # However long closing takes, half of the limit is for the search.
    clock.now = 5.0 + 49.9
    assert not whole()
    clock.now = 5.0 + 50.0
    assert whole()


def test_rounds_know_no_closing_and_whoever_asks_ends_it(clock: _Clock) -> None:
    asked: list[bool] = []
    course = Course(Limits(time_s=None, rounds=4), lambda: bool(asked))
    course.closing_s = 20.0
    course.rounds = 3
    clock.now = 1e9
    assert course.share == 0.75
    assert not course.until(0.1)()
    asked.append(True)
    assert course.until(1.0)()
