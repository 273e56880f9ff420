"""How long the rest of a road takes at least: a bound from below, with pauses anywhere.

As many breaks and rests as the driving needs that is left, each as short as it may be. Functions
are plain; `kernel` compiles them.
"""

from __future__ import annotations

from .label import (
    BEFORE,
    BROKEN,
    ENDS,
    GONE,
    GONE_MOST,
    LAST_WEEK,
    LONG_DAYS,
    OTHER_BEFORE,
    OTHER_LAST_WEEK,
    OTHER_LONG_DAYS,
    OTHER_TODAY,
    OTHER_WEEK,
    PART,
    TIME,
    TODAY,
    WEEK,
    WEEK_DRIVEN,
    WEEK_S,
    WEEKLY_END,
)
from .numbers import (
    BREAK,
    CALENDAR,
    CHANGE,
    DAILY,
    DAY,
    FIRST,
    FORTNIGHT,
    LONG_DAY,
    MOST_WEEK,
    POOLED,
    REDUCED,
    SECOND,
    SPELL,
    WEEKLY,
    WEEKLY_DUE,
)
from .road import NO_LIMIT, IntArray

__all__ = ["LEFT", "in_time", "least_left"]


def least_left(
    a: IntArray, seconds: int, clock: int, p: IntArray, monday: int, weeks: int
) -> int:  # fmt: skip
    """Return how long the rest of a road takes at least, with breaks and rests anywhere on it.

    Parameters
    ----------
    a : int64 array, (COLUMNS,)
        The label.
    seconds, clock : int
        What is left to drive, and what the clock counts of it [s].
    p : int64 array
        The limits.
    monday : int
        A Monday 0:00 UTC [s].
    weeks : int
        1 where driving in a week can matter.

    Returns
    -------
    int
        Its duration [s].
    """
    rest = min(p[REDUCED], p[DAILY])
    rests = 0
    if rest < NO_LIMIT and p[LONG_DAY] < NO_LIMIT:
        share = 2 if p[CHANGE] < NO_LIMIT and p[POOLED] == 0 else 1
        most = max(1, share * p[LONG_DAY])
        rests = max(0, -(-(a[TODAY] + a[OTHER_TODAY] + clock - most) // most))
    breaks = 0
    pause = min(p[BREAK], p[CHANGE])
    if p[FIRST] < NO_LIMIT:
        pause = min(pause, p[FIRST] + p[SECOND])
    if p[SPELL] < NO_LIMIT:
        most = max(1, p[SPELL])
        breaks = max(0, -(-(a[BROKEN] + clock - most) // most) - rests)
    bound = seconds + (rests * rest if rests > 0 else 0)
    if breaks > 0:
        if pause >= NO_LIMIT:
            return NO_LIMIT
        bound += breaks * pause
        if a[PART] == 1:
            bound -= pause - min(pause, p[SECOND])
    if weeks == 1 and p[CALENDAR] == 1 and clock > 0:
        week = (a[TIME] - monday) // WEEK_S
        driven, last = a[WEEK_DRIVEN], a[LAST_WEEK]
        if week > a[WEEK]:
            last = driven if week == a[WEEK] + 1 else 0
            driven = 0
        over = clock - min(p[MOST_WEEK] - driven, p[FORTNIGHT] - driven - last)
        if p[CHANGE] < NO_LIMIT and p[POOLED] == 0:
            driven, last = a[OTHER_WEEK], a[OTHER_LAST_WEEK]
            if week > a[WEEK]:
                last = driven if week == a[WEEK] + 1 else 0
                driven = 0
            over -= min(p[MOST_WEEK] - driven, p[FORTNIGHT] - driven - last)
        if over > 0:
            # So much is driven after Monday, in as much time if the clock counts all of it.
            bound = max(bound, monday + (week + 1) * WEEK_S - a[TIME] + over)
    return bound


def _without_waiting(
    a: IntArray, seconds: int, clock: int, bound: int, p: IntArray, monday: int, weekly: int,
    moves: bool,
) -> int:  # fmt: skip
    """Return how long the rest of a road takes at least if Mondays are not waited for.

    A weekly rest is needed if the end comes too long after the last, which moves with the departure
    if that does. It stands for a daily rest or a break.
    """
    least = least_left(a, seconds, clock, p, monday, 0)
    if weekly == 1:
        left = a[WEEKLY_END] + p[WEEKLY_DUE] - a[TIME]
        slack = max(0, a[GONE_MOST] - (a[TIME] - a[GONE])) if moves else 0
        if least > left or bound > left + slack:
            least += max(0, p[WEEKLY] - max(p[BREAK], min(p[REDUCED], p[DAILY])))
    return int(least)


def in_time(
    a: IntArray, seconds: int, clock: int, latest: int, leaves: int, p: IntArray, monday: int,
    late: bool, weeks: int, weekly: int, moves: bool,
) -> bool:  # fmt: skip
    """Return whether a label can arrive in time, and fill what follows from that.

    Parameters
    ----------
    a : int64 array, (COLUMNS,)
        The label, whose `ENDS`, `BEFORE` and `OTHER_BEFORE` are filled.
    seconds, clock : int
        What is left to drive, and what the clock counts of it [s].
    latest : int
        When the destination has to be reached [s].
    leaves : int
        The origin need not be left before that, where `late` [s].
    p : int64 array
        The limits.
    monday : int
        A Monday 0:00 UTC [s].
    late : bool
        Whether a later departure is worth a label.
    weeks, weekly : int
        1 where driving in a week, or a weekly rest that is due, can matter.
    moves : bool
        Whether the end of the last weekly rest moves with the departure.

    Returns
    -------
    bool
        Whether it can, as far as the bound tells.
    """
    bound = least_left(a, seconds, clock, p, monday, weeks)
    if a[TIME] + bound > latest:
        return False
    # Waiting for Monday moves departures, what is driven and paused does not.
    if weeks == 1 or weekly == 1:
        bound = _without_waiting(a, seconds, clock, bound, p, monday, weekly, moves)
    ends = latest - bound
    if a[TIME] > ends:
        return False
    if late and min(a[GONE_MOST], ends - a[GONE]) < leaves:
        return False
    a[ENDS] = ends
    a[BEFORE] = a[LONG_DAYS] - (a[TODAY] > p[DAY])
    a[OTHER_BEFORE] = a[OTHER_LONG_DAYS] - (a[OTHER_TODAY] > p[DAY])
    return True


LEFT = (least_left, _without_waiting, in_time)
"""Functions here, callees first."""
