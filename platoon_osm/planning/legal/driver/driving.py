"""Driving: what a hop adds to the clocks of a label, and whether the limits allow it.

Driving that passes Sunday 24:00 UTC is shared between both weeks. Functions are plain; `kernel`
compiles them.
"""

from __future__ import annotations

from .label import (
    BESIDE,
    BROKEN,
    DUTY,
    DUTY_MOST,
    DUTY_WEEK,
    FAR,
    GONE,
    GONE_MOST,
    LAST_WEEK,
    LONG_DAYS,
    OTHER_BROKEN,
    OTHER_LAST_WEEK,
    OTHER_WEEK,
    REDUCED_USED,
    TIME,
    TODAY,
    WEEK,
    WEEK_DRIVEN,
    WEEK_S,
    WEEKLY_END,
    WORKED,
)
from .numbers import (
    BESIDE_LENGTH,
    CALENDAR,
    DAY,
    FORTNIGHT,
    LONG_DAY,
    LONG_WINDOW,
    MOST_LONG,
    MOST_REDUCED,
    MOST_WEEK,
    SPELL,
    WEEKLY_DUE,
    WINDOW,
    WORK,
)
from .road import NO_LIMIT, IntArray

__all__ = ["drive"]


def drive(
    a: IntArray, seconds: int, clock: int, p: IntArray, monday: int, weeks: int, weekly: int
) -> bool:
    """Let a label drive a hop.

    Parameters
    ----------
    a : int64 array, (COLUMNS,)
        The label, which is changed.
    seconds, clock : int
        How long the hop takes, and what the driver's clock counts of it [s].
    p : int64 array
        The limits.
    monday : int
        A Monday 0:00 UTC [s].
    weeks, weekly : int
        1 where driving in a week, or a weekly rest that is due, can matter.

    Returns
    -------
    bool
        Whether it may; else the label is of no more use.
    """
    if a[BROKEN] + clock > p[SPELL] or a[WORKED] + seconds > p[WORK]:
        return False
    today = a[TODAY] + clock
    if today > p[LONG_DAY]:
        return False
    duty = a[DUTY] + seconds
    if duty > p[LONG_WINDOW] or (duty > p[WINDOW] and a[REDUCED_USED] >= p[MOST_REDUCED]):
        return False
    begins = a[TIME]
    ends = begins + seconds
    if ends > a[WEEKLY_END] + p[WEEKLY_DUE]:
        return False
    began = begins - a[DUTY]
    # A duty period that began before the trip does not move with the departure.
    limit = p[LONG_WINDOW] if a[REDUCED_USED] < p[MOST_REDUCED] else p[WINDOW]
    gone = begins - a[GONE]
    if a[DUTY_MOST] < FAR:
        a[GONE_MOST] = min(a[GONE_MOST], gone + a[DUTY_MOST] - began + limit - duty)
    if weekly == 1:
        due = a[WEEKLY_END] + p[WEEKLY_DUE] - ends
        a[DUTY_MOST] = min(a[DUTY_MOST], began + due)
        a[GONE_MOST] = min(a[GONE_MOST], gone + due)
    if today > p[DAY] and a[LONG_DAYS] + (a[TODAY] <= p[DAY]) > p[MOST_LONG]:
        return False
    if today > p[DAY] and a[TODAY] <= p[DAY]:
        a[LONG_DAYS] += 1
        # It counts in the week in which the duty period begins, and is not moved into another.
        left = monday + (a[DUTY_WEEK] + 1) * WEEK_S - 1 - began
        if left >= 0:
            a[DUTY_MOST] = min(a[DUTY_MOST], began + left)
            a[GONE_MOST] = min(a[GONE_MOST], gone + left)
    if weeks == 1:
        before = clock
        left = 0
        if p[CALENDAR] == 1:
            week = (begins - monday) // WEEK_S
            if week > a[WEEK]:
                a[LAST_WEEK] = a[WEEK_DRIVEN] if week == a[WEEK] + 1 else 0
                a[OTHER_LAST_WEEK] = a[OTHER_WEEK] if week == a[WEEK] + 1 else 0
                a[WEEK_DRIVEN] = 0
                a[OTHER_WEEK] = 0
                a[WEEK] = week
            left = monday + (week + 1) * WEEK_S - begins
            if seconds > left:
                before = -(-clock * left // seconds)
            # What ends before Monday is not moved beyond it.
            slack = max(0, left - seconds)
            a[DUTY_MOST] = min(a[DUTY_MOST], began + slack)
            a[GONE_MOST] = min(a[GONE_MOST], gone + slack)
        a[WEEK_DRIVEN] += before
        if a[WEEK_DRIVEN] > p[MOST_WEEK] or a[WEEK_DRIVEN] + a[LAST_WEEK] > p[FORTNIGHT]:
            return False
        if p[CALENDAR] == 1 and seconds > left:
            a[LAST_WEEK] = a[WEEK_DRIVEN]
            a[OTHER_LAST_WEEK] = a[OTHER_WEEK]
            a[WEEK_DRIVEN] = clock - clock * left // seconds
            a[OTHER_WEEK] = 0
            a[WEEK] += 1
            if a[WEEK_DRIVEN] + a[LAST_WEEK] > p[FORTNIGHT]:
                return False
    a[BROKEN] += clock
    if p[WORK] < NO_LIMIT:
        a[WORKED] += seconds
    a[TODAY] = today
    a[DUTY] = duty
    a[TIME] = ends
    a[GONE] += seconds
    if a[BESIDE] < p[BESIDE_LENGTH]:
        a[BESIDE] = min(p[BESIDE_LENGTH], a[BESIDE] + seconds)
        if a[BESIDE] >= p[BESIDE_LENGTH]:
            a[OTHER_BROKEN] = 0
    return True
