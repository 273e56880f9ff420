"""The entries and exits of a member's own way whose places to pause are known.

As in `own_ways.py`, but every pause is at a place of the way, of a length that the law
names: labels are carried from point to point, forward from the origin and back from the
destination, and of two labels one is dropped if the other is in nothing behind. With the generous
limits nothing that can be driven is missed; with the strict ones everything can be driven.
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
    paused,
)  # fmt: skip
from .own_ways import (
    BEFORE,
    DRIVEN,
    ENTRY,
    EXIT,
    FREE,
    HELD,
    HUGE,
    LASTS,
    LEAVING,
    MODE,
    MOST_DUTY,
    MOST_FREE,
    MOST_PARTED,
    MOST_TODAY,
    PARTED,
    READY,
    RESTED,
    STANDS,
)  # fmt: skip

__all__ = ["HELPERS", "MOST_LABELS", "entries_by_places", "exits_by_places"]

Seconds = NDArray[np.int64]

MOST_LABELS = 96
"""Labels of one point that are kept; a way that needs more is not tabulated."""


def _put(rows: Seconds, at: int, row: Seconds) -> None:
    """Copy a label; assigned as a whole it would be held in an array of its own meanwhile."""
    for x in range(rows.shape[1]):
        rows[at, x] = row[x]


def _keep_entry(rows: Seconds, count: int, new: Seconds) -> int:
    """Add a label to those of a point if none is as good; return how many there are, or -1."""
    for k in range(count):
        row = rows[k]
        if (
            row[READY] <= new[READY] and row[FREE] <= new[FREE] and row[PARTED] <= new[PARTED]
            and row[DRIVEN] <= new[DRIVEN] and row[LASTS] <= new[LASTS]
            and row[BEFORE] <= new[BEFORE] and row[MODE] == new[MODE]
        ):  # fmt: skip
            return count
    kept = 0
    for k in range(count):
        row = rows[k]
        worse = (
            row[READY] >= new[READY] and row[FREE] >= new[FREE] and row[PARTED] >= new[PARTED]
            and row[DRIVEN] >= new[DRIVEN] and row[LASTS] >= new[LASTS]
            and row[BEFORE] >= new[BEFORE] and row[MODE] == new[MODE]
        )  # fmt: skip
        if not worse:
            if kept < k:
                _put(rows, kept, row)
            kept += 1
    if kept >= len(rows):
        return -1
    _put(rows, kept, new)
    return kept + 1


def _keep_exit(rows: Seconds, count: int, new: Seconds) -> int:
    """Likewise of the way on."""
    for k in range(count):
        row = rows[k]
        if (
            row[MOST_FREE] >= new[MOST_FREE] and row[MOST_PARTED] >= new[MOST_PARTED]
            and row[MOST_TODAY] >= new[MOST_TODAY] and row[MOST_DUTY] >= new[MOST_DUTY]
            and row[STANDS] <= new[STANDS]
        ):  # fmt: skip
            return count
    kept = 0
    for k in range(count):
        row = rows[k]
        worse = (
            row[MOST_FREE] <= new[MOST_FREE] and row[MOST_PARTED] <= new[MOST_PARTED]
            and row[MOST_TODAY] <= new[MOST_TODAY] and row[MOST_DUTY] <= new[MOST_DUTY]
            and row[STANDS] >= new[STANDS]
        )  # fmt: skip
        if not worse:
            if kept < k:
                _put(rows, kept, row)
            kept += 1
    if kept >= len(rows):
        return -1
    _put(rows, kept, new)
    return kept + 1


HELPERS = (paused, _put, _keep_entry, _keep_exit)
"""What the kernels call, callees first: to be made known to the compiler before them."""


def entries_by_places(
    v: Seconds, drive: Seconds, clock: Seconds, stay: Seconds, sure: bool, until: int,
    found: Seconds,
) -> int:  # fmt: skip
    """Fill the entries of one way.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the vehicle.
    drive, clock : ndarray of int, (h,)
        The driving time of each hop, and what its clocks count of it [s].
    stay : ndarray of int, (h + 1,)
        The longest pause at each point, the last of them the merging point [s].
    sure : bool
        Whether those are wanted that are certain.
    until : int
        An entry is of no use that is ready later [s].
    found : ndarray of int, (MOST_LABELS, ENTRY)
        To be filled.

    Returns
    -------
    int
        Rows filled; -1 if there are too many.
    """
    day = v[SURE_DAY] if sure else v[DAY]
    rest = v[SURE_REST] if sure else v[REST]
    window = v[SURE_WINDOW] if sure else v[WINDOW]
    new = np.empty(ENTRY, np.int64)
    rows = np.empty((MOST_LABELS, ENTRY), np.int64)
    count, first = 1, found[0]
    first[READY] = v[EARLIEST]
    first[FREE] = FAR if v[PART] == 1 else v[BROKEN]
    first[PARTED] = v[BROKEN] if v[PART] == 1 else FAR
    first[DRIVEN], first[LASTS], first[BEFORE] = v[TODAY], 0, max(0, v[DUTY])
    first[MODE] = HELD if v[HOLDS] == 1 and v[DUTY] >= 0 else LEAVING
    hops = len(drive)
    left = drive.sum()
    # Where its window ends before its duty could last too long, that need not be counted.
    counts = first[MODE] != HELD and v[ARRIVAL] - v[EARLIEST] + first[BEFORE] > window
    # What it has behind it may hold whenever it leaves: then standing at the origin is no pause.
    begin = 0 if v[HOLDS] == 1 else 1
    for k in range(hops + 1):
        if k > 0:
            before = count
            rows[:before] = found[:before]
            count = 0
            left -= drive[k - 1]
            for at in range(before):
                new[:] = rows[at]
                new[READY] += drive[k - 1]
                if counts:
                    new[LASTS] += drive[k - 1]
                new[DRIVEN] += clock[k - 1]
                for part in (FREE, PARTED):
                    new[part] = min(new[part] + clock[k - 1], FAR)
                    if new[part] > v[SPELL]:
                        new[part] = FAR
                if (new[FREE] >= FAR and new[PARTED] >= FAR) or new[DRIVEN] > day:
                    continue
                lasts = new[READY] - v[EARLIEST] if new[MODE] == HELD else new[LASTS]
                if lasts + new[BEFORE] > window:
                    continue
                count = _keep_entry(found, count, new)
                if count < 0:
                    return -1
        if k < begin or (k > 0 and stay[k] <= 0):
            continue
        before = count
        rows[:before] = found[:before]
        for at in range(before):
            for option in range(4):
                length = rest if option == 3 else v[(FIRST, SECOND, BREAK)[option]]
                if length >= HUGE or (k > 0 and length > stay[k]):
                    continue
                if k == 0 and v[EARLIEST] + length > v[LATEST]:
                    continue
                new[:] = rows[at]
                new[READY] += length
                if new[READY] + left > until:
                    continue
                if option == 3:
                    lasts = rows[at, READY] - v[EARLIEST]
                    if new[MODE] != HELD:
                        lasts = new[LASTS]
                    if (k > 0 or sure) and lasts + new[BEFORE] > window:
                        continue
                    if sure and k > 0 and stay[k] < HUGE:
                        continue  # it might have to wait there longer than it may stay
                    new[FREE], new[PARTED], new[DRIVEN] = 0, FAR, 0
                    new[LASTS], new[BEFORE] = 0, 0
                    new[MODE] = LEAVING if k == 0 else RESTED
                else:
                    free, parted = paused(v, new[FREE], new[PARTED], length)
                    if free == new[FREE] and parted == new[PARTED]:
                        continue
                    new[FREE], new[PARTED] = free, parted
                    if k > 0 and counts:
                        new[LASTS] += length
                count = _keep_entry(found, count, new)
                if count < 0:
                    return -1
    return count


def exits_by_places(
    v: Seconds, drive: Seconds, clock: Seconds, stay: Seconds, sure: bool, until: int,
    found: Seconds,
) -> int:  # fmt: skip
    """Fill the exits of one way.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the vehicle.
    drive, clock : ndarray of int, (h,)
        The driving time of each hop, and what its clocks count of it [s].
    stay : ndarray of int, (h + 1,)
        The longest pause at each point, the first of them the separation point [s].
    sure : bool
        Whether those are wanted that are certain.
    until : int
        An exit is of no use that stands longer [s].
    found : ndarray of int, (MOST_LABELS, EXIT)
        To be filled.

    Returns
    -------
    int
        Rows filled; -1 if there are too many.
    """
    day = v[SURE_DAY] if sure else v[DAY]
    rest = v[SURE_REST] if sure else v[REST]
    window = v[SURE_WINDOW] if sure else v[WINDOW]
    new = np.empty(EXIT, np.int64)
    rows = np.empty((MOST_LABELS, EXIT), np.int64)
    count, last = 1, found[0]
    last[MOST_FREE], last[MOST_PARTED], last[MOST_TODAY] = v[SPELL], v[SPELL], day
    last[MOST_DUTY], last[STANDS] = window, 0
    hops = len(drive)
    counts = v[ARRIVAL] - v[EARLIEST] + max(0, v[DUTY]) > window
    for k in range(hops, -1, -1):
        if k < hops:
            before = count
            rows[:before] = found[:before]
            count = 0
            for at in range(before):
                new[:] = rows[at]
                new[MOST_FREE] = max(-1, new[MOST_FREE] - clock[k])
                new[MOST_PARTED] = max(-1, new[MOST_PARTED] - clock[k])
                new[MOST_TODAY] -= clock[k]
                if counts:
                    new[MOST_DUTY] -= drive[k]
                if max(new[MOST_FREE], new[MOST_PARTED]) < 0 or new[MOST_TODAY] < 0:
                    continue
                if new[MOST_DUTY] < 0:
                    continue
                count = _keep_exit(found, count, new)
                if count < 0:
                    return -1
        if k == hops or stay[k] <= 0:
            continue
        before = count
        rows[:before] = found[:before]
        for at in range(before):
            free, parted, duty = rows[at, MOST_FREE], rows[at, MOST_PARTED], rows[at, MOST_DUTY]
            for option in range(4):
                length = rest if option == 3 else v[(FIRST, SECOND, BREAK)[option]]
                if length >= HUGE or length > stay[k] or rows[at, STANDS] + length > until:
                    continue
                new[:] = rows[at]
                new[STANDS] += length
                if counts:
                    new[MOST_DUTY] = duty - length
                if option == 0:
                    # The first part lies behind some driving.
                    if parted <= free or (sure and (k == 0 or clock[k - 1] == 0)):
                        continue
                    new[MOST_FREE] = parted
                elif free < 0:
                    continue
                elif option == 1:
                    new[MOST_FREE], new[MOST_PARTED] = -1, v[SPELL]
                else:
                    new[MOST_FREE] = new[MOST_PARTED] = v[SPELL]
                if option == 3:
                    new[MOST_TODAY], new[MOST_DUTY] = day, window
                if new[MOST_DUTY] < 0:
                    continue
                count = _keep_exit(found, count, new)
                if count < 0:
                    return -1
    return count
