"""What must hold of any day: pauses never harm, weeks are alike, and breaks against brute force."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import pytest
from driving_days import EU_DAYS, US_DAYS
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm import ScenarioError
from platoon_osm.inspection.activities import HOUR, MINUTE, WEEK, Activity, Record, record_of
from platoon_osm.inspection.breaks import break_violations
from platoon_osm.inspection.daily import days_of
from platoon_osm.inspection.day_text import day_of
from platoon_osm.inspection.driver_start import RESTED, DriverStart
from platoon_osm.inspection.eu561 import eu561_violations
from platoon_osm.inspection.us395 import us395_violations
from platoon_osm.inspection.violation import Violation

STEP = 15 * MINUTE
SPELL = 4 * HOUR + 30 * MINUTE

kinds = st.sampled_from(["drive", "drive", "drive", "work", "available", "rest", "rest"])
lengths = st.sampled_from([1, 1, 2, 2, 3, 4, 6, 9, 12, 18, 36, 44])


def record(parts: Sequence[tuple[str, int]], start: int = 6 * HOUR) -> Record:
    done, now = [], start
    for kind, steps in parts:
        done.append(Activity(kind, now, now + steps * STEP))
        now += steps * STEP
    return record_of(done, start, now)


def beyond(violations: Sequence[Violation]) -> float:
    return sum(one.over_s for one in violations)


def with_pause(parts: Sequence[tuple[str, int]], at: int, steps: int) -> list[tuple[str, int]]:
    """Return parts with a pause after so many steps; what follows comes later."""
    found: list[tuple[str, int]] = []
    for kind, length in parts:
        if 0 <= at < length:
            found += [(kind, at), ("rest", steps), (kind, length - at)]
        else:
            found.append((kind, length))
        at -= length
    return [part for part in found if part[1]]


days = st.lists(st.tuples(kinds, lengths), min_size=1, max_size=12)


def breaks_by_all_choices(parts: Sequence[tuple[str, int]]) -> bool:
    """Return whether some choice of pauses as breaks, and parts of breaks, is allowed.

    Every pause is left alone, or made a whole break, a first part or a second part; then the choice
    is read from left to right.
    """
    merged: list[tuple[str, int]] = []
    for kind, steps in parts:
        if kind == "rest" and merged and merged[-1][0] == "rest":
            merged[-1] = ("rest", merged[-1][1] + steps)
        else:
            merged.append((kind, steps))
    pauses = [k for k, (kind, _) in enumerate(merged) if kind == "rest"]
    for roles in itertools.product(("none", "whole", "first", "second"), repeat=len(pauses)):
        role = dict(zip(pauses, roles, strict=True))
        driven, parted, fine = 0, False, True
        for k, (kind, steps) in enumerate(merged):
            if kind == "drive":
                driven += steps
                fine &= driven <= 18
            elif role.get(k, "none") != "none":
                own = role[k]
                fine &= steps >= {"whole": 3, "first": 1, "second": 2}[own]
                fine &= own != "second" or parted
                fine &= own != "first" or driven > 0
                parted = own == "first" or (parted and own == "none")
                driven = driven if own == "first" else 0
        if fine:
            return True
    return False


@settings(max_examples=150)
@given(st.lists(st.tuples(kinds, st.sampled_from([1, 2, 3, 4, 6, 9])), min_size=1, max_size=9))
def test_breaks_against_all_choices(parts: list[tuple[str, int]]) -> None:
    assert (break_violations(record(parts), RESTED) == []) is breaks_by_all_choices(parts)


@given(days, st.integers(0, 200), st.sampled_from([1, 2, 3, 4]))
def test_one_more_pause_never_harms_a_break(
    parts: list[tuple[str, int]], at: int, steps: int
) -> None:
    before = break_violations(record(parts), RESTED)
    after = break_violations(record(with_pause(parts, at, steps)), RESTED)
    assert beyond(after) <= beyond(before)


@given(days, st.integers(0, 11), st.sampled_from([1, 2, 3]))
def test_a_longer_pause_harms_no_break(
    parts: list[tuple[str, int]], which: int, steps: int
) -> None:
    longer = [
        (kind, length + steps) if k == which and kind == "rest" else (kind, length)
        for k, (kind, length) in enumerate(parts)
    ]
    before = break_violations(record(parts), RESTED)
    assert beyond(break_violations(record(longer), RESTED)) <= beyond(before)


@given(days, st.integers(0, 11))
def test_rest_instead_of_work_keeps_a_legal_day_legal(
    parts: list[tuple[str, int]], which: int
) -> None:
    rested = [("rest" if k == which else kind, length) for k, (kind, length) in enumerate(parts)]
    before, after = record(parts), record(rested)
    assert len(days_of(after, RESTED)[1]) <= len(days_of(before, RESTED)[1])
    assert us395_violations(before) or not us395_violations(after)
    if which < len(parts) and parts[which][0] == "drive":
        return  # the driving within which a first part lay may be gone
    assert beyond(break_violations(after, RESTED)) <= beyond(break_violations(before, RESTED))
    assert eu561_violations(before) or not eu561_violations(after)


def shapes(violations: Sequence[Violation]) -> Counter[tuple[str, float, str]]:
    return Counter((one.article, one.over_s, one.text) for one in violations)


@given(days, st.integers(1, 60))
def test_weeks_are_alike(parts: list[tuple[str, int]], weeks: int) -> None:
    now, later = record(parts), record(parts, 6 * HOUR + weeks * WEEK)
    for check in (eu561_violations, us395_violations):
        moved = [replace(one, at_s=one.at_s - weeks * WEEK) for one in check(later)]
        assert moved == check(now)


@given(days, st.integers(1, 6))
def test_a_record_may_be_told_in_pieces(parts: list[tuple[str, int]], pieces: int) -> None:
    cut = [
        (kind, length // pieces + (k < length % pieces))
        for kind, length in parts
        for k in range(pieces)
    ]
    whole, told = record(parts), record([part for part in cut if part[1]])
    for check in (eu561_violations, us395_violations):
        assert shapes(check(told)) == shapes(check(whole))


@pytest.mark.parametrize("check", [eu561_violations, us395_violations])
def test_every_written_day_is_alike_in_any_week(check: object) -> None:
    rows = EU_DAYS if check is eu561_violations else US_DAYS
    for row in rows[::7]:
        later = tuple(
            replace(one, start_s=one.start_s + WEEK, end_s=one.end_s + WEEK) for one in row.record
        )
        found = check(row.record, row.state, **row.options)  # type: ignore[operator]  # either of two checkers
        moved = check(later, row.state, **row.options)  # type: ignore[operator]  # likewise
        assert [replace(one, at_s=one.at_s - WEEK) for one in moved] == found


@given(days)
def test_two_drivers_are_asked_for_no_more_rest(parts: list[tuple[str, int]]) -> None:
    alone = days_of(record(parts), RESTED)[1]
    team = days_of(record(parts), DriverStart(drivers=2))[1]
    assert len([one for one in team if "Art. 8" in one.article]) <= len(
        [one for one in alone if "Art. 8" in one.article]
    )


# -- what a record is ------------------------------------------------------------------------------


def test_unknown_time_is_rest() -> None:
    told = day_of("4h30 drive, 45m rest, 4h30 drive")
    known = [one for one in told if one.kind == "drive"]
    assert record_of(known, told[0].start_s, told[-1].end_s) == told
    assert record_of((), 0, 5) == (Activity("rest", 0, 5),)
    assert record_of((Activity("drive", 3, 3),), 0, 5) == (Activity("rest", 0, 5),)
    assert record_of((), 5, 5) == ()
    assert eu561_violations(()) == us395_violations(()) == []


@pytest.mark.parametrize(
    ("kind", "start", "end", "relieved"),
    [("sleep", 0, 1, 0), ("drive", 2, 1, 0), ("drive", 0, 1, 2), ("drive", 0, 1, -1),
     ("drive", 0.5, 1, 0), (None, 0, 1, 0)],
)  # fmt: skip
def test_what_is_no_activity_is_refused(kind: str, start: int, end: int, relieved: int) -> None:
    with pytest.raises(ScenarioError, match="activity"):
        Activity(kind, start, end, relieved)


def test_activities_must_not_overlap() -> None:
    with pytest.raises(ScenarioError, match="overlap"):
        record_of((Activity("drive", 0, 5), Activity("rest", 4, 6)), 0, 6)
    with pytest.raises(ScenarioError, match="outside"):
        record_of((Activity("drive", 0, 5),), 0, 4)
    with pytest.raises(ScenarioError, match="'two hours' is no time and kind"):
        day_of("1h drive, two hours")


# -- article 12 ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "excused"),
    [
        ("4h30 drive, 45m rest, 4h30 drive, 45m rest, 2h drive, 24h rest, 1m drive", True),
        ("4h30 drive, 45m rest, 4h30 drive, 45m rest, 2h1m drive, 24h rest, 1m drive", False),
        ("4h30 drive, 45m rest, 4h30 drive, 45m rest, 2h drive, 23h59 rest, 1m drive", False),
        ("4h30 drive, 45m rest, 4h30 drive, 45m rest, 1h drive, 30m rest, 2h drive, 45h rest, "
         "1m drive", True),
        ("4h30 drive, 45m rest, 4h30 drive, 45m rest, 1h drive, 30m rest, 2h drive, 44h59 rest, "
         "1m drive", False),
        ("4h30 drive, 45m rest, 4h30 drive, 45m rest, 1h drive, 29m rest, 2h drive, 45h rest, "
         "1m drive", False),
        ("4h30 drive, 45m rest, 4h30 drive, 45m rest, 1h drive, 30m rest, 2h1m drive, 45h rest, "
         "1m drive", False),
        ("4h31 drive, 45h rest, 1m drive", False),
    ],
)  # fmt: skip
def test_article_12_excuses_only_who_asks(text: str, excused: bool) -> None:
    day = day_of(text)
    assert not any(one.excusable for one in eu561_violations(day))
    (found,) = eu561_violations(day, article_12=True)
    assert found.excusable is excused
