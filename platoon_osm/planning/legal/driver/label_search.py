"""Labels of one driver along a road: what it has behind it, where that is all that matters.

At a point with a place a label (`label`) takes every kind of pause there is (`pausing`), each as
short as allowed, in every window (`leaving`); then it drives the next hop (`driving`), if it can be
in time (`least_left`). Labels that are behind another are dropped (`dominance`, `kept_labels`).

Functions are plain; `kernel` compiles them.
"""

from __future__ import annotations

import numpy as np

from .dominance import DOMINANCE
from .driving import drive
from .kept_labels import KEPT, grown, keep, most_promising
from .label import CLOSES, COLUMNS, INFO, KIND, LASTS, OPENS, PARENT, TIME, WEEKLY_END
from .least_left import LEFT, in_time, least_left
from .leaving import LEAVING, after_sunday, may_rest
from .numbers import CALENDAR, NONE
from .pausing import PAUSES, allowed, lasts, leave
from .road import FREE, NO_LIMIT, IntArray

__all__ = ["HELPERS", "search"]


def _ahead(
    drive_s: IntArray, clock_s: IntArray, leave_s: IntArray, latest: int
) -> tuple[IntArray, IntArray, IntArray, IntArray]:
    """Return what lies ahead of each point: driving, the clock's, when it is due, appointments."""
    n = len(drive_s)
    left_s = np.zeros(n + 1, np.int64)
    left_clock = np.zeros(n + 1, np.int64)
    # When each point has to be reached, and the next appointment from it on.
    due = np.full(n + 1, latest, np.int64)
    appointment = np.full(n + 1, n, np.int64)
    if leave_s[n] != FREE:
        due[n] = min(latest, leave_s[n])
    for k in range(n - 1, -1, -1):
        left_s[k] = left_s[k + 1] + drive_s[k]
        left_clock[k] = left_clock[k + 1] + clock_s[k]
        due[k] = due[k + 1] - drive_s[k]
        appointment[k] = appointment[k + 1]
        if leave_s[k] != FREE:
            due[k] = min(due[k], leave_s[k])
            appointment[k] = k
    return left_s, left_clock, due, appointment


def search(
    drive_s: IntArray, clock_s: IntArray, stay_s: IntArray, leave_s: IntArray,
    windows_first: IntArray, windows_s: IntArray, numbers: IntArray, kinds: IntArray,
    begins: IntArray, begins_info: IntArray, monday: int, fixed_weekly_end: int,
    latest: int, leaves: int, late: bool, weeks: int, weekly: int, width: int, openings: int,
    dominance: bool,
) -> tuple[IntArray, IntArray, IntArray]:  # fmt: skip
    """Return the labels of each point.

    Parameters
    ----------
    drive_s, clock_s : int64 array, (n,)
        Of the road [s].
    stay_s, leave_s : int64 array, (n + 1,)
        Of the road [s].
    windows_first, windows_s : int64 array
        Of `waiting.windows_of`.
    numbers, kinds : int64 array
        The limits, and the kinds of pause that they know.
    begins, begins_info : int64 array
        Labels that leave the origin, and how.
    monday : int
        A Monday 0:00 UTC [s].
    fixed_weekly_end : int
        The end of a weekly rest that does not move with the departure [s].
    latest : int
        When the destination has to be reached [s].
    leaves : int
        The origin need not be left before that, where `late` [s]: a trip that does so is known.
    late : bool
        Whether a later departure is worth a label.
    weeks, weekly : int
        1 where driving in a week, or a weekly rest that is due, can matter.
    width : int
        How many labels of each point are kept, the most promising; 0 for all.
    openings : int
        Of how many windows a pause is tried for, the first that it can be over in; 0 for all.
    dominance : bool
        Whether labels are dropped for others.

    Returns
    -------
    int64 array, (m, COLUMNS)
        The labels.
    int64 array, (m, INFO)
        How each came about.
    int64 array, (n + 2,)
        Where the labels of each point begin.
    """
    n = len(drive_s)
    p = numbers
    left_s, left_clock, due, appointment = _ahead(drive_s, clock_s, leave_s, latest)
    first = np.zeros(n + 2, np.int64)
    kept = np.zeros((256, COLUMNS), np.int64)
    kept_info = np.zeros((256, INFO), np.int64)
    found = np.zeros((256, COLUMNS), np.int64)
    found_info = np.zeros((256, INFO), np.int64)
    total = 0
    for k in range(n):
        count = 0
        low, high = first[k], total
        if k == 0:
            low, high = 0, len(begins)
        windows = windows_s[windows_first[k] : windows_first[k + 1]]
        regular = 1 if k == 0 else max(1, len(windows))
        extra = 0
        if k > 0 and weeks == 1 and p[CALENDAR] == 1 and stay_s[k] > 0 and leave_s[k] == FREE:
            extra = 2
        for label in range(low, high):
            for choice in range(1 if k == 0 else len(kinds)):
                kind = NONE
                if k > 0:
                    kind = kinds[choice]
                    if kind != NONE and p[kind] > stay_s[k]:
                        break
                    if not allowed(kind, kept[label], p):
                        continue
                tried = 0
                for opening in range(regular + extra):
                    if openings > 0 and tried >= openings and opening < regular:
                        continue
                    found = grown(found, count + 2)
                    found_info = grown(found_info, count + 2)
                    out = found[count]
                    if k == 0:
                        out[:] = begins[label]
                        found_info[count] = begins_info[label]
                    else:
                        a = kept[label]
                        opens, closes, forced = -NO_LIMIT, NO_LIMIT, 0
                        if opening >= regular:
                            opens, closes = after_sunday(
                                opening - regular, kind, a, p, monday, windows
                            )
                        elif len(windows) > 0:
                            opens, closes = windows[opening, 0], windows[opening, 1]
                        if leave_s[k] != FREE:
                            if leave_s[k] < opens or leave_s[k] > closes:
                                continue
                            opens, closes, forced = leave_s[k], leave_s[k], 1
                        if closes < a[TIME] or opens + drive_s[k] > due[k + 1]:
                            continue
                        if (
                            opening > 0 and weekly == 0
                            and may_rest(kind, a, p, opens, stay_s[k], late)
                        ):  # fmt: skip
                            continue
                        if not leave(
                            kind, a[TIME], opens, closes, stay_s[k], forced, a, p, monday,
                            fixed_weekly_end, out,
                        ):  # fmt: skip
                            continue
                        tried += 1
                        found_info[count, PARENT] = label
                        found_info[count, KIND] = kind
                        found_info[count, OPENS] = opens
                        found_info[count, CLOSES] = closes
                        found_info[count, LASTS] = lasts(kind, a, p)
                    if not drive(out, drive_s[k], clock_s[k], p, monday, weeks, weekly):
                        continue
                    if out[TIME] > due[k + 1] or not in_time(
                        out, left_s[k + 1], left_clock[k + 1], latest, leaves, p, monday, late,
                        weeks, weekly, out[WEEKLY_END] > fixed_weekly_end,
                    ):  # fmt: skip
                        continue
                    at = appointment[k + 1]
                    if at < n:
                        bound = least_left(
                            out, left_s[k + 1] - left_s[at], left_clock[k + 1] - left_clock[at],
                            p, monday, weeks,
                        )  # fmt: skip
                        if out[TIME] + bound > leave_s[at]:
                            continue
                    count += 1
        first[k + 1] = total
        if count == 0:
            for rest in range(k + 1, n + 1):
                first[rest + 1] = total
            return kept, kept_info, first
        kept, kept_info, total = keep(
            found, found_info, count, kept, kept_info, total, left_s[k + 1], left_clock[k + 1],
            latest, fixed_weekly_end, p, stay_s[k + 1] >= NO_LIMIT, late, weeks, weekly, dominance,
        )  # fmt: skip
        if width > 0 and total - first[k + 1] > width:
            most_promising(
                kept, kept_info, first[k + 1], total, width, left_s[k + 1], left_clock[k + 1],
                latest, p, monday, weeks,
            )  # fmt: skip
            total = first[k + 1] + width
    first[n + 1] = total
    return kept, kept_info, first


HELPERS = (*PAUSES, drive, *LEFT, *DOMINANCE, *LEAVING, *KEPT, _ahead)
"""What the search calls: to be made known to the compiler before it."""
