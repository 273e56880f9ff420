"""What a member's own way does to its clocks before it merges, and asks of them afterwards.

An *entry* is one way to come to a merging point: the earliest moment at which the member can leave
it so, and its clocks then. An *exit* is one way to go on from a separation point: what its clocks
may be at most, and how long it stands on the way. Each point has several, those with less standing
first. There are two kinds for the two values of the search (`kernel.py`):

- *at least*: pauses anywhere, as short as the way allows, with the more generous limits;
- *for certain*: pauses only before leaving and at the merging point, with the stricter limits.

Where the places of an own way are known, `own_places.py` replaces both by what they allow.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .clocks import (
    ARRIVAL,
    BREAK,
    BROKEN,
    DAY,
    DUTY,
    EARLIEST,
    FAR,
    FIRST,
    HOLDS,
    LATEST,
    PART,
    REST,
    SECOND,
    SPELL,
    SURE_DAY,
    SURE_REST,
    SURE_WINDOW,
    TODAY,
    WINDOW,
    breaks_s,
    needed,
    paused,
)  # fmt: skip

__all__ = ["ENTRY", "EXIT", "HELPERS", "MOST_ROWS", "plain_ways"]

Seconds = NDArray[np.int64]

# An entry: when the point can be left at the earliest; driven with no part of a break taken, with
# the first part, and today; for how long it has been on duty; what duty it had behind it; how its
# duty begins.
READY, FREE, PARTED, DRIVEN, LASTS, BEFORE, MODE = range(7)
ENTRY = 7

# Its duty begins when it leaves its origin, by its latest departure; or has begun already; or it
# begins after a rest on the way.
LEAVING, HELD, RESTED = range(3)

# An exit: the most driven with no part of a break taken, with the first part, and today; the most
# time since its duty began; how long it stands.
MOST_FREE, MOST_PARTED, MOST_TODAY, MOST_DUTY, STANDS = range(5)
EXIT = 5

MOST_ROWS = 32
"""Rows of one point that `plain_ways` may need."""

HUGE = FAR // 2


def _entry(
    rows: Seconds, count: int, ready: int, free: int, parted: int, today: int, lasts: int,
    before: int, mode: int,
) -> int:  # fmt: skip
    """Add an entry."""
    if ready >= HUGE:
        return count
    row = rows[count]
    row[READY], row[FREE], row[PARTED], row[DRIVEN] = ready, free, parted, today
    row[LASTS], row[BEFORE], row[MODE] = lasts, before, mode
    return count + 1


def _exit(
    rows: Seconds, count: int, free: int, parted: int, today: int, duty: int, stands: int
) -> int:
    """Add an exit, unless nobody could take it."""
    if max(free, parted) < 0 or today < 0 or duty < 0 or stands >= HUGE:
        return count
    row = rows[count]
    row[MOST_FREE], row[MOST_PARTED], row[MOST_TODAY] = free, parted, today
    row[MOST_DUTY], row[STANDS] = duty, stands
    return count + 1


def _entries_at_least(v: Seconds, drive_s: int, rows: Seconds) -> int:
    """Fill the entries of a way with pauses anywhere."""
    mode = HELD if v[HOLDS] == 1 and v[DUTY] >= 0 else LEAVING
    before = max(0, v[DUTY])
    begin = v[EARLIEST] + drive_s
    rigid = v[HOLDS] == 0 and drive_s == 0  # what is known of it holds whenever it leaves
    count = 0
    breaks = needed(v[SPELL], v[BROKEN], drive_s)
    least = breaks_s(v, breaks, v[PART])
    today = v[TODAY] + drive_s
    if today <= v[DAY] and least < HUGE and (least == 0 or not rigid):
        driven = v[BROKEN] + drive_s - breaks * v[SPELL] if breaks > 0 else v[BROKEN] + drive_s
        parted = driven if breaks == 0 and v[PART] == 1 else FAR
        lasts = drive_s + least
        count = _entry(rows, count, begin + least, driven, parted, today, lasts, before, mode)
        if not rigid and v[BREAK] < HUGE:
            if v[FIRST] < HUGE and driven > 0 and parted >= FAR:
                count = _entry(
                    rows, count, begin + least + v[FIRST], driven, driven, today, lasts, before,
                    mode,
                )  # fmt: skip
            fresh = breaks_s(v, breaks + 1, v[PART])
            if v[FIRST] < HUGE and driven > 0 and fresh >= least + v[FIRST]:
                parted = driven
            count = _entry(rows, count, begin + fresh, 0, parted, today, lasts, before, mode)
            if v[FIRST] < HUGE and drive_s > 0:
                count = _entry(
                    rows, count, begin + fresh + v[FIRST], 0, 0, today, lasts, before, mode
                )
    if v[REST] < HUGE and not rigid:
        stood = v[REST] + breaks_s(v, breaks - 1, v[PART])
        parted = 0 if drive_s > 0 else FAR
        count = _entry(rows, count, begin + stood, 0, parted, 0, 0, 0, RESTED)
    return count


def _entries_for_certain(v: Seconds, drive_s: int, stay_s: int, rows: Seconds) -> int:
    """Fill the entries of a way with pauses before leaving and at the merging point only."""
    held = v[HOLDS] == 1 and v[DUTY] >= 0
    count = 0
    for option in range(5):
        stood = 0
        if option > 0:
            stood = v[SURE_REST] if option == 4 else v[(FIRST, SECOND, BREAK)[option - 1]]
            if v[HOLDS] == 0 or stood >= HUGE or v[EARLIEST] + stood > v[LATEST]:
                continue
        free = FAR if v[PART] == 1 else v[BROKEN]
        parted = v[BROKEN] if v[PART] == 1 else FAR
        today, before = v[TODAY], max(0, v[DUTY])
        mode = HELD if held else LEAVING
        if option == 4:
            free, parted, today, before, mode = 0, FAR, 0, 0, LEAVING
        else:
            free, parted = paused(v, free, parted, stood)
        free += drive_s
        parted += drive_s
        today += drive_s
        if free > v[SPELL]:
            free = FAR
        if parted > v[SPELL]:
            parted = FAR
        if (free >= FAR and parted >= FAR) or today > v[SURE_DAY]:
            continue
        ready = v[EARLIEST] + drive_s + stood
        count = _entry(rows, count, ready, free, parted, today, drive_s, before, mode)
        rigid = v[HOLDS] == 0 and drive_s == 0
        if stay_s >= v[BREAK] and v[BREAK] < HUGE and not rigid:
            free, parted = paused(v, free, parted, v[BREAK])
            lasts = drive_s + v[BREAK]
            count = _entry(
                rows, count, ready + v[BREAK], free, parted, today, lasts, before, mode
            )  # fmt: skip
    return count


def _exits_at_least(v: Seconds, drive_s: int, rows: Seconds) -> int:
    """Fill the exits of a way with pauses anywhere."""
    half = v[BREAK] - v[SECOND] if v[SECOND] < v[BREAK] else 0
    count = 0
    fewest = needed(v[DAY], 0, drive_s)
    for rests in range(fewest, fewest + 2):
        if rests > 0 and v[REST] >= HUGE:
            break
        today = v[DAY] if v[DAY] >= HUGE else (rests + 1) * v[DAY] - drive_s
        today = min(today, v[DAY])
        duty = v[WINDOW]
        if rests == 0 and duty < HUGE:
            duty -= drive_s
        resets = max(0, needed(v[SPELL], 0, drive_s) - rests)
        while True:
            free = v[SPELL] if v[SPELL] >= HUGE else (rests + resets + 1) * v[SPELL] - drive_s
            stands = rests * v[REST] if rests > 0 else 0
            if resets > 0:
                stands += resets * v[BREAK]
            if free >= 0:
                free = min(free, v[SPELL])
                within = duty - resets * v[BREAK] if rests == 0 and resets > 0 else duty
                if resets > 0 and half > 0:
                    more = within + half if rests == 0 else within
                    count = _exit(rows, count, -1, free, today, more, stands - half)
                count = _exit(rows, count, free, free, today, within, stands)
            resets += 1
            if free >= v[SPELL] or v[BREAK] >= HUGE:
                break
    return count


def _exits_for_certain(v: Seconds, drive_s: int, rows: Seconds) -> int:
    """Fill the exit of a way without a pause."""
    free = v[SPELL] - drive_s
    return _exit(rows, 0, free, free, v[SURE_DAY] - drive_s, v[SURE_WINDOW] - drive_s, 0)


HELPERS = (
    needed, breaks_s, paused, _entry, _exit, _entries_at_least, _entries_for_certain,
    _exits_at_least, _exits_for_certain,
)  # fmt: skip
"""What the kernel calls, callees first: to be made known to the compiler before it."""


def plain_ways(
    vehicles: Seconds, drives: Seconds, stay: Seconds, until: Seconds, never_s: int,
    entering: bool, sure: bool, at: Seconds, found: Seconds,
) -> int:  # fmt: skip
    """Fill the entries or exits of all vehicles and points; return how many there are.

    Parameters
    ----------
    vehicles : ndarray of int, (M + 1, NUMBERS)
        What is known of them.
    drives : ndarray of int, (M + 1, n)
        Driving times to the points, or from them [s].
    stay : ndarray of int, (n,)
        The longest pause at each [s].
    until : ndarray of int, (M + 1, n)
        Until when entries are of use, and how long exits may stand to be of use [s].
    never_s : int
        The driving time where there is no way [s].
    entering : bool
        Whether entries are wanted; else exits.
    sure : bool
        Whether those are wanted that are certain; else the best there could be.
    at : ndarray of int, (M + 1, n, 2)
        To be filled: from which row to which they are.
    found : ndarray of int, (X, ENTRY) or (X, EXIT)
        To be filled; if it is too small, only the number is right.

    Returns
    -------
    int
        Rows.
    """
    rows = np.empty((MOST_ROWS, found.shape[1]), np.int64)
    total = 0
    column = READY if entering else STANDS
    for m in range(len(vehicles)):
        v = vehicles[m]
        for k in range(drives.shape[1]):
            count = 0
            # Who could not be in time even without a pause need not be looked at.
            if drives[m, k] < never_s and v[EARLIEST] + drives[m, k] <= v[ARRIVAL]:
                if entering and sure:
                    count = _entries_for_certain(v, drives[m, k], stay[k], rows)
                elif entering:
                    count = _entries_at_least(v, drives[m, k], rows)
                elif sure:
                    count = _exits_for_certain(v, drives[m, k], rows)
                else:
                    count = _exits_at_least(v, drives[m, k], rows)
            kept = 0
            for row in range(count):
                if rows[row, column] <= until[m, k]:
                    rows[kept] = rows[row]
                    kept += 1
            at[m, k, 0], at[m, k, 1] = total, total + kept
            if total + kept <= len(found):
                found[total : total + kept] = rows[:kept]
            total += kept
    return total
