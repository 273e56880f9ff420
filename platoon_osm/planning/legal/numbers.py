"""Limits in the whole seconds that the search counts in, at positions of one array.

Limits are rounded down and pauses up, so that what keeps them here keeps them as they were given.
Two drivers are counted each for itself: a limit of the vehicle allows each half of it.
"""

from __future__ import annotations

import math

import numpy as np

from ...driving.limits import Limits
from .road import NO_LIMIT, IntArray

__all__ = [
    "BREAK", "CHANGE", "CHANGE_IN_BREAK", "DAILY", "FIRST", "LENGTHS", "NONE", "PIECE", "REDUCED",
    "SECOND", "WEEKLY", "kinds_of", "numbers_of",
]  # fmt: skip

NONE, FIRST, SECOND, BREAK, REDUCED, DAILY, WEEKLY, CHANGE, CHANGE_IN_BREAK, PIECE = range(10)
"""What a label may do at a point: nothing, the parts of a break in two, a break, the three rests, a
change of seats, one within a break of both, and a piece of pause that only ends a spell of work."""

LENGTHS = 10
"""How many kinds there are; the lengths of their pauses come first among the numbers."""


def numbers_of(limits: Limits) -> IntArray:
    """Return limits as an array.

    Parameters
    ----------
    limits : Limits
        Of one driver, or of two in one vehicle.

    Returns
    -------
    int64 array
        For each kind of pause its length, `NO_LIMIT` if it is not taken; then the longest spell,
        spell of work, pause that ends one, day, long day, long days, window, long window, reduced
        rests, week, fortnight, what ends a weekly rest is due after, time beside that is a break,
        and whether weeks are those of the calendar [s].
    """
    two = limits.change_s > 0
    share = 2 if two else 1
    whole = _up(limits.beside_s if two else limits.break_s)
    spells = math.isfinite(limits.spell_s)
    days = math.isfinite(limits.day_s) or math.isfinite(limits.window_s)
    parts = limits.parts_s if spells and not two else None
    first, second = (NO_LIMIT, NO_LIMIT) if parts is None else map(_up, parts)
    # Whoever has to take a break before has no spell of work that is too long: it is all driving.
    works = limits.work_spell_s < limits.spell_s
    pause = _up(limits.work_pause_s)
    numbers = (
        0, first, second, whole if spells else NO_LIMIT,
        _up(limits.reduced_rest_s) if days and limits.reduced_rests else NO_LIMIT,
        _up(limits.rest_s) if days else NO_LIMIT,
        _up(limits.weekly_rest_s), _up(limits.change_s) if two else NO_LIMIT,
        max(whole, _up(limits.change_s)) if two else NO_LIMIT,
        pause if works else NO_LIMIT,
        _down(limits.spell_s), _down(limits.work_spell_s) if works else NO_LIMIT, pause,
        _down(limits.day_s / share), _down(limits.long_day_s / share), limits.long_days,
        _down(limits.window_s), _down(limits.long_window_s), limits.reduced_rests,
        _down(limits.week_s / share),
        _down(limits.fortnight_s / share) if limits.calendar_weeks else NO_LIMIT,
        _down(limits.weekly_after_s), whole, int(limits.calendar_weeks),
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
