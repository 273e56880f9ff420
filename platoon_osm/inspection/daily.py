"""(EC) 561/2006 art. 8(2) to (5) and 6(1): daily rests, and how much is driven between two of them.

A day runs from the end of one daily or weekly rest to the end of the next, whatever the calendar.
Within 24 h of its beginning 11 h of rest must have been taken, or 3 and then 9 h, or 9 h at most
three times between two weekly rests; of a rest only what lies within those 24 h counts (art. 8(2)).
Each of two drivers in a vehicle needs 9 h within 30 h, which uses up no reduced rest (art. 8(5)
departs from 8(2)). Driving is 9 h a day, 10 h twice a calendar week; a day across Sunday midnight
counts in either week, not in both.

The reading: days are allowed if *some* choice of rests as daily rests makes them so; a rest of 9 h
need not be counted as one. All choices are tried; of those that lead to the same rest only those
are kept that no other beats in what is too much, reduced rests and long days. Driving while a ferry
interrupts the rest that was chosen is not driving of the day (Addendum, point 4).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from .activities import DAY, HOUR, WEEK, Activity, Record, clock_span, crossing
from .driver_start import DriverStart
from .rests import MOST_INTERRUPTED_S, MOST_INTERRUPTIONS, RestTaken, rests_of, taken
from .violation import Violation, badness

__all__ = ["Day", "days_of"]

REGULAR_S = 11 * HOUR
REDUCED_S = 9 * HOUR
FIRST_PART_S = 3 * HOUR
WITHIN_S = 1 * DAY
TEAM_WITHIN_S = 30 * HOUR
MOST_REDUCED = 3
WEEKLY_S = 24 * HOUR
"""From here on a rest is a weekly one."""

DRIVING_S = 9 * HOUR
LONG_DRIVING_S = 10 * HOUR
MOST_LONG_DAYS = 2


@dataclass(frozen=True, slots=True)
class Day:
    """What lies between two daily rests.

    Attributes
    ----------
    start_s, end_s : int
        From the end of one to the beginning of the next [s].
    next_s : int
        When the next ends [s].
    """

    start_s: int
    end_s: int
    next_s: int


@dataclass(frozen=True, slots=True)
class _Choice:
    """A choice of daily rests so far."""

    start_s: int
    driven_s: int
    reduced: int
    long_days: tuple[int, ...]
    """The weeks in which long days were counted, each as often as it was."""
    days: tuple[Day, ...] = ()
    found: tuple[Violation, ...] = ()


def days_of(record: Record, start: DriverStart) -> tuple[tuple[Day, ...], tuple[Violation, ...]]:
    """Return the days of a record, and what is wrong with their rests and their driving.

    Parameters
    ----------
    record : tuple of Activity
        What a driver does.
    start : DriverStart
        What it has behind it.

    Returns
    -------
    tuple of Day
        Of a choice of rests with the least too much.
    tuple of Violation
        Theirs.
    """
    rests = rests_of(record)
    began_s, reduced = record[0].start_s, start.reduced_rests_used
    if start.duty_s is not None:
        began_s -= start.duty_s
    elif rests[0].start_s == began_s:
        opening = rests.pop(0)
        began_s = opening.end_s
        if opening.span_s >= WEEKLY_S:
            reduced = 0
    if not rests:
        return (), ()
    drives = [activity for activity in record if activity.driven_s]
    mains = taken(rests, REDUCED_S)
    firsts = taken(rests, FIRST_PART_S)
    week = record[0].start_s // WEEK
    long_days = (week,) * start.long_days_used
    if began_s // WEEK < week:
        # Nothing is known of the week before, so no long day of it is left.
        long_days += (week - 1,) * MOST_LONG_DAYS
    first = _Choice(began_s, start.driven_today_s, reduced, long_days)
    within_s = TEAM_WITHIN_S if start.drivers > 1 else WITHIN_S
    reached: list[list[_Choice]] = [[first], *([] for _ in rests)]
    for after in range(len(rests)):
        for choice in _best(reached[after]):
            for main in _usable(mains, after, choice.start_s + within_s):
                parts = [one for one in firsts if after <= one.first and one.last < main.first]
                for split in (None, *parts):
                    reached[main.last + 1] += _next_day(choice, main, split, drives, within_s)
    last = min(reached[-1], key=lambda choice: badness(choice.found))
    return last.days, last.found


def _usable(mains: Sequence[RestTaken], after: int, until_s: int) -> list[RestTaken]:
    """Return the rests that may end a day; none after one that lasts until its time is over.

    Of later rests nothing would count, and all driving until then would.
    """
    last = next(
        main.first
        for main in mains
        if main.first >= after and not main.interruptions and main.end_s >= until_s
    )
    return [main for main in mains if after <= main.first <= last]


def _best(choices: Sequence[_Choice]) -> list[_Choice]:
    """Return the choices with the least too much, for each use of reduced rests and long days."""
    kept: dict[tuple[int, tuple[int, ...]], _Choice] = {}
    for choice in sorted(choices, key=lambda one: badness(one.found)):
        kept.setdefault((choice.reduced, tuple(sorted(choice.long_days))), choice)
    return list(kept.values())


def _next_day(
    choice: _Choice,
    main: RestTaken,
    split: RestTaken | None,
    drives: Sequence[Activity],
    within_s: int,
) -> Iterator[_Choice]:
    """Yield what follows if a day ends with a rest, after the first part of it or without one."""
    parts = [main] if split is None else [split, main]
    if sum(part.interruptions for part in parts) > MOST_INTERRUPTIONS:
        return
    if sum(part.interrupted_s for part in parts) > MOST_INTERRUPTED_S:
        return
    if main.interruptions and split is None and main.rest_s < REGULAR_S:
        return  # a reduced daily rest must not be interrupted
    team = within_s == TEAM_WITHIN_S
    until_s = choice.start_s + within_s
    rest_s = main.rest_before(until_s)
    whole = rest_s >= (REDUCED_S if team or split is not None else REGULAR_S)
    reduced = choice.reduced
    found = choice.found
    if not whole:
        may_be_reduced = rest_s >= REDUCED_S and not main.interruptions
        if may_be_reduced and reduced < MOST_REDUCED:
            reduced += 1
        else:
            nine = split is not None or (reduced < MOST_REDUCED and not main.interruptions)
            least_s = REDUCED_S if team or nine else REGULAR_S
            over_s = least_s - rest_s + max(0, main.start_s - until_s)
            article = f"561/2006 Art. 8({'5' if team else '4' if may_be_reduced else '2'})"
            text = f"{clock_span(rest_s)} of daily rest within {clock_span(within_s)}, "
            text += f"{clock_span(least_s)} needed"
            found += (Violation(article, until_s - least_s, over_s, text),)
    if main.rest_s >= WEEKLY_S:
        reduced = 0
    day = Day(choice.start_s, main.start_s, main.end_s)
    after = replace(
        choice, start_s=main.end_s, driven_s=0, reduced=reduced, days=(*choice.days, day),
        found=found,
    )  # fmt: skip
    own = [drive for drive in drives if _counts(drive, day, split)]
    yield from _driven(after, own, choice.driven_s, day)


def _counts(drive: Activity, day: Day, split: RestTaken | None) -> bool:
    """Return whether a drive is driving of the day, and does not interrupt a part of its rest."""
    if split is not None and split.start_s < drive.start_s < split.end_s:
        return False
    return day.start_s <= drive.start_s and drive.end_s <= day.end_s


def _driven(
    after: _Choice, drives: Sequence[Activity], driven_s: int, day: Day
) -> Iterator[_Choice]:
    """Yield the choices of a week in which a day is a long one, if it is."""
    own_s = sum(drive.driven_s for drive in drives)
    total_s = driven_s + own_s
    weeks = {day.start_s // WEEK, (day.end_s - 1) // WEEK} if total_s > DRIVING_S else set()
    usable = [week for week in sorted(weeks) if after.long_days.count(week) < MOST_LONG_DAYS]
    used: list[tuple[int, ...]] = [(week,) for week in usable] or [()]
    for week in used:
        most_s = LONG_DRIVING_S if week else DRIVING_S
        found = after.found
        # What was too much before the record begins is no driving of it.
        if total_s > most_s and own_s:
            at_s = _when(drives, driven_s, most_s, day)
            text = f"{clock_span(total_s)} driven in a day, {clock_span(most_s)} allowed"
            found += (Violation("561/2006 Art. 6(1)", at_s, total_s - most_s, text),)
        yield replace(after, long_days=after.long_days + week, found=found)


def _when(drives: Sequence[Activity], driven_s: int, most_s: int, day: Day) -> int:
    """Return when a day's driving reaches its limit."""
    for drive in drives:
        if driven_s + drive.driven_s > most_s:
            return crossing(drive, max(0, most_s - driven_s))
        driven_s += drive.driven_s
    return day.end_s
