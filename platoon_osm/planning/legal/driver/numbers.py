"""Limits in the whole seconds that the search counts in, at positions of one array.

Limits are rounded down and pauses up, so that what keeps them here keeps them as they were given.
Two drivers are counted each for itself: a limit of the vehicle allows each half of it.
"""

from __future__ import annotations

import math

import numpy as np

from ....driving.limits import Limits
from .road import NO_LIMIT, IntArray

__all__ = [
    "APART", "BREAK", "CHANGE", "CHANGE_IN_BREAK", "CHANGE_RESTED", "DAILY", "FIRST", "LENGTHS",
    "NONE", "PIECE", "REDUCED", "SECOND", "WEEKLY", "kinds_of", "numbers_of",
]  # fmt: skip

NONE, FIRST, SECOND, BREAK, REDUCED, DAILY, WEEKLY, PIECE = range(8)
"""What a label may do at a point: nothing, the parts of a break in two, a break, the three rests,
and a piece of pause that only ends a spell of work."""

CHANGE, CHANGE_RESTED, CHANGE_IN_BREAK = range(8, 11)
"""What two drivers may do besides: change seats, at once, or as soon as who sat beside the other
has had its break there, or within a break of both."""

LENGTHS = 14
"""How many kinds there are; the lengths of their pauses come first among the numbers. The last are
the three rests in which two drivers change seats."""

# Positions of the limits, after the lengths of the pauses.
SPELL, WORK, PIECE_LENGTH, DAY, LONG_DAY, MOST_LONG, WINDOW, LONG_WINDOW = range(
    LENGTHS, LENGTHS + 8
)
MOST_REDUCED, MOST_WEEK, FORTNIGHT, WEEKLY_DUE, BESIDE_LENGTH, CALENDAR, POOLED, DUE = range(
    LENGTHS + 8, LENGTHS + 16
)

APART = (NONE, FIRST, SECOND, BREAK, REDUCED, DAILY, WEEKLY, PIECE, NONE, NONE, BREAK,
         REDUCED, DAILY, WEEKLY)  # fmt: skip
"""What each kind is to both drivers, whether they change seats in it or not."""

ROUNDED_S = 5
"""Driving times are rounded up, each part of a joint way by less than a second: so much longer one
driver sits beside the other than a break lasts [s]."""


def numbers_of(limits: Limits, pooled: bool = False) -> IntArray:
    """Return limits as an array.

    Parameters
    ----------
    limits : Limits
        Of one driver, or of two in one vehicle.
    pooled : bool, optional
        Whether the driving of two in a day and in a week is counted together, whoever drives: that
        allows all that is allowed to each, and more.

    Returns
    -------
    int64 array
        For each kind of pause its length, the least where that depends on what was before,
        `NO_LIMIT` if it is not taken; then the longest spell,
        spell of work, pause that ends one, day, long day, long days, window, long window, reduced
        rests, week, fortnight, what ends a weekly rest is due after, time beside that is a break,
        whether weeks are those of the calendar, whether driving is pooled, and whether rests begin
        within the windows [s].
    """
    two = limits.change_s > 0
    pooled = pooled and two
    share = 2 if two and not pooled else 1
    whole = _up(limits.beside_s if two else limits.break_s)
    spells = math.isfinite(limits.spell_s)
    days = math.isfinite(limits.day_s) or math.isfinite(limits.window_s)
    parts = limits.parts_s if spells and not two else None
    first, second = (NO_LIMIT, NO_LIMIT) if parts is None else map(_up, parts)
    reduced = _up(limits.reduced_rest_s) if days and limits.reduced_rests else NO_LIMIT
    daily, weekly = _up(limits.rest_s) if days else NO_LIMIT, _up(limits.weekly_rest_s)
    change = _up(limits.change_s) if two else NO_LIMIT
    # Whoever has to take a break before has no spell of work that is too long: it is all driving.
    works = limits.work_spell_s < limits.spell_s
    pause = _up(limits.work_pause_s)
    numbers = (
        0, first, second, whole if spells else NO_LIMIT,
        reduced, daily, weekly, pause if works else NO_LIMIT,
        change, change if spells else NO_LIMIT, max(whole, change) if spells else NO_LIMIT,
        *(NO_LIMIT if pooled else max(one, change) for one in (reduced, daily, weekly)),
        _down(limits.spell_s), _down(limits.work_spell_s) if works else NO_LIMIT, pause,
        _down(limits.day_s / share), _down(limits.long_day_s / share),
        limits.long_days * (2 if pooled else 1),
        _down(limits.window_s), _down(limits.long_window_s), limits.reduced_rests,
        _down(limits.week_s / share),
        _down(limits.fortnight_s / share) if limits.calendar_weeks else NO_LIMIT,
        _down(limits.weekly_after_s), whole + ROUNDED_S if two else 0, int(limits.calendar_weeks),
        int(pooled), int(limits.rest_in_window),
    )  # fmt: skip
    return np.array(numbers, dtype=np.int64)


def kinds_of(numbers: IntArray) -> IntArray:
    """Return the kinds of pause that limits know, `NONE` among them, the shortest first.

    Parameters
    ----------
    numbers : int64 array
        Of `numbers_of`.

    Returns
    -------
    int64 array
        Kinds.
    """
    known = [kind for kind in range(LENGTHS) if numbers[kind] < NO_LIMIT]
    return np.array(sorted(known, key=lambda kind: (numbers[kind], kind)), dtype=np.int64)


def _down(seconds: float) -> int:
    return NO_LIMIT if math.isinf(seconds) else math.floor(seconds)


def _up(seconds: float) -> int:
    return NO_LIMIT if math.isinf(seconds) else math.ceil(seconds)
