"""The labels of a point that are kept: not dropped for another, and of too many the most promising.

Functions are plain; `kernel` compiles them.
"""

from __future__ import annotations

import numpy as np

from .dominance import ask_less, covers
from .label import BEFORE, BROKEN, COLUMNS, DUTY, ENDS, REDUCED_USED, TIME, TODAY, WEEKLY_END
from .least_left import least_left
from .road import IntArray

__all__ = ["KEPT", "grown", "keep", "most_promising"]

TO_MONDAY = 8
"""How much less the time without waiting for Monday counts for what is promising."""


def _by_time(labels: IntArray, count: int, order: IntArray) -> None:
    """Sort the positions of rows by their first column, the time of labels (Shell's method)."""
    for k in range(count):
        order[k] = k
    gap = count // 2
    while gap > 0:
        for k in range(gap, count):
            moved = order[k]
            at = labels[moved, 0]
            place = k
            while place >= gap and labels[order[place - gap], 0] > at:
                order[place] = order[place - gap]
                place -= gap
            order[place] = moved
        gap //= 2


def grown(array: IntArray, least: int) -> IntArray:
    """Return an array with room for more rows.

    Parameters
    ----------
    array : int64 array, (m, k)
        The rows.
    least : int
        How many there must be.

    Returns
    -------
    int64 array
        The same array if it has as many; else a larger one that begins with its rows.
    """
    rows = len(array)
    if least <= rows:
        return array
    larger = np.zeros((max(least, 2 * rows), array.shape[1]), np.int64)
    larger[:rows] = array
    return larger


def keep(
    found: IntArray, found_info: IntArray, count: int, kept: IntArray, kept_info: IntArray,
    begin: int, seconds: int, clock: int, latest: int, fixed_weekly_end: int, p: IntArray,
    place: bool, late: bool, weeks: int, weekly: int, dominance: bool,
) -> tuple[IntArray, IntArray, int]:  # fmt: skip
    """Add the labels of a point that no other covers.

    Parameters
    ----------
    found, found_info : int64 array
        Its labels, and how each came about.
    count : int
        How many there are.
    kept, kept_info : int64 array
        The labels of all points before.
    begin : int
        How many those are.
    seconds, clock : int
        What is left to drive, and what the clock counts of it [s].
    latest : int
        When the destination has to be reached [s].
    fixed_weekly_end : int
        The end of a weekly rest that does not move with the departure [s].
    p : int64 array
        The limits.
    place : bool
        Whether one may wait there as long as one likes.
    late : bool
        Whether a later departure is worth a label.
    weeks, weekly : int
        1 where driving in a week, or a weekly rest that is due, can matter.
    dominance : bool
        Whether labels are dropped for others.

    Returns
    -------
    kept, kept_info : int64 array
        With those of the point.
    total : int
        How many there are then.
    """
    order = np.zeros(count, np.int64)
    need = np.zeros(COLUMNS, np.int64)
    total = begin
    _by_time(found, count, order)
    for position in range(count):
        label = order[position]
        b = found[label]
        need[:] = b
        moves = need[WEEKLY_END] > fixed_weekly_end
        ask_less(need, seconds, clock, latest, moves, p)
        covered = False
        if dominance:
            for other in range(begin, total):
                # Most are told apart by these.
                if (
                    kept[other, BROKEN] > need[BROKEN] or kept[other, DUTY] > need[DUTY]
                    or kept[other, REDUCED_USED] > need[REDUCED_USED]
                    or kept[other, BEFORE] > need[BEFORE] or kept[other, TODAY] > need[TODAY]
                ):  # fmt: skip
                    continue
                if covers(kept[other], need, place, late, weeks, weekly):
                    covered = True
                    break
        if covered:
            continue
        kept = grown(kept, total + 1)
        kept_info = grown(kept_info, total + 1)
        kept[total] = b
        kept_info[total] = found_info[label]
        total += 1
    return kept, kept_info, total


def most_promising(
    kept: IntArray, kept_info: IntArray, begin: int, total: int, width: int, seconds: int,
    clock: int, latest: int, p: IntArray, monday: int, weeks: int,
) -> None:  # fmt: skip
    """Move the most promising labels of a point to the front: who could arrive the earliest.

    Parameters
    ----------
    kept, kept_info : int64 array
        The labels of all points, and how each came about; rows are changed.
    begin, total : int
        Where those of the point begin and end.
    width : int
        How many are to be kept.
    seconds, clock : int
        What is left to drive, and what the clock counts of it [s].
    latest : int
        When the destination has to be reached [s].
    p : int64 array
        The limits.
    monday : int
        A Monday 0:00 UTC [s].
    weeks : int
        1 where driving in a week can matter.
    """
    size = total - begin
    order = np.zeros(size, np.int64)
    old, old_info = kept[begin:total].copy(), kept_info[begin:total].copy()
    bounds = np.zeros((size, 1), np.int64)
    for position in range(size):
        a = old[position]
        bound = least_left(a, seconds, clock, p, monday, weeks)
        # The same Monday is waited for by many: then who would be there first without.
        bounds[position, 0] = a[TIME] + bound + (a[TIME] + latest - a[ENDS]) // TO_MONDAY
    _by_time(bounds, size, order)
    for position in range(width):
        kept[begin + position] = old[order[position]]
        kept_info[begin + position] = old_info[order[position]]


KEPT = (_by_time, grown, keep, most_promising)
"""Functions here, callees first."""
