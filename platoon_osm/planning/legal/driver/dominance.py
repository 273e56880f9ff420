"""Dominance: of two labels at a point one is dropped if the other is in nothing behind.

That is not later, and has driven no more since anything that counts; what can no longer be made use
of until the end does not count. Whatever follows the one may then follow the other, which pauses
longer where it would be too early. Functions are plain; `kernel` compiles them.
"""

from __future__ import annotations

from .label import (
    BEFORE,
    BESIDE,
    BROKEN,
    DUTY,
    DUTY_MOST,
    DUTY_WEEK,
    ENDS,
    GONE,
    GONE_MOST,
    LAST_WEEK,
    LONG_DAYS,
    OTHER_BEFORE,
    OTHER_BROKEN,
    OTHER_LAST_WEEK,
    OTHER_LONG_DAYS,
    OTHER_TODAY,
    OTHER_WEEK,
    PART,
    REDUCED_USED,
    TIME,
    TODAY,
    WEEK,
    WEEK_DRIVEN,
    WEEKLY_END,
    WORKED,
)
from .numbers import CHANGE, DAILY, DAY, MOST_LONG, MOST_REDUCED, REDUCED, WEEKLY, WEEKLY_DUE
from .road import NO_LIMIT, IntArray

__all__ = ["DOMINANCE", "ask_less", "covers"]


def ask_less(
    a: IntArray, seconds: int, clock: int, latest: int, moves: bool, p: IntArray
) -> None:  # fmt: skip
    """Let a label have no more left than it can make use of till the end.

    Its `ENDS` less what elapses from a departure or the beginning of a duty period is the latest
    that this may be moved to: the rest arrives too late. A weekly rest that is due before the end
    begins before it is over by then.

    Parameters
    ----------
    a : int64 array, (COLUMNS,)
        The label, which is changed.
    seconds, clock : int
        What is left to drive, and what the clock counts of it [s].
    latest : int
        When the destination has to be reached [s].
    moves : bool
        Whether the end of the last weekly rest moves with the departure.
    p : int64 array
        The limits.
    """
    a[DUTY_MOST] = min(a[DUTY_MOST], a[ENDS] - a[DUTY])
    a[GONE_MOST] = min(a[GONE_MOST], a[ENDS] - a[GONE])
    if p[WEEKLY_DUE] < NO_LIMIT:
        after = latest - p[WEEKLY_DUE]
        if not moves and a[WEEKLY_END] + p[WEEKLY_DUE] < a[TIME] + latest - a[ENDS]:
            after -= p[WEEKLY]
        a[WEEKLY_END] = min(a[WEEKLY_END], after)
    rest = min(p[REDUCED], p[DAILY])
    if p[CHANGE] < NO_LIMIT or rest >= NO_LIMIT or rest == 0:
        return
    rests = (latest - a[TIME] - seconds) // rest
    a[REDUCED_USED] = max(a[REDUCED_USED], p[MOST_REDUCED] - rests - 1)
    days = min(rests, clock // (p[DAY] + 1)) + (a[TODAY] + clock > p[DAY])
    a[BEFORE] = max(a[BEFORE], p[MOST_LONG] - days)


def _covers_week(a: IntArray, b: IntArray) -> bool:
    """Return whether a label that waits for the week of another has driven no more in it."""
    last, other_last = 0, 0
    if a[WEEK] == b[WEEK] - 1:
        last, other_last = a[WEEK_DRIVEN], a[OTHER_WEEK]
    return bool(
        last <= b[WEEK_DRIVEN] + b[LAST_WEEK] and other_last <= b[OTHER_WEEK] + b[OTHER_LAST_WEEK]
    )


def covers(a: IntArray, b: IntArray, place: bool, late: bool, weeks: int, weekly: int) -> bool:
    """Return whether a label that is not later than another is in nothing behind it.

    Parameters
    ----------
    a, b : int64 array, (COLUMNS,)
        The label, and the other, of which no more is asked than it can make use of.
    place : bool
        Whether one may wait there as long as one likes.
    late : bool
        Whether a later departure is worth a label.
    weeks, weekly : int
        1 where driving in a week, or a weekly rest that is due, can matter.

    Returns
    -------
    bool
        Whether whatever follows the other may follow the label.
    """
    if a[BROKEN] > b[BROKEN] or a[PART] < b[PART] or a[TODAY] > b[TODAY] or a[DUTY] > b[DUTY]:
        return False
    if a[BROKEN] == 0 and b[BROKEN] > 0:
        return False
    if a[DUTY_MOST] < b[DUTY_MOST] or a[REDUCED_USED] > b[REDUCED_USED]:
        return False
    if a[BEFORE] > b[BEFORE] or a[WORKED] > b[WORKED]:
        return False
    if (a[LONG_DAYS] > 0 or a[OTHER_LONG_DAYS] > 0) and a[DUTY_WEEK] > b[DUTY_WEEK]:
        return False
    if late and (a[GONE] > b[GONE] or a[GONE_MOST] < b[GONE_MOST]):
        return False
    if a[OTHER_BROKEN] > b[OTHER_BROKEN] or a[BESIDE] < b[BESIDE]:
        return False
    if a[OTHER_TODAY] > b[OTHER_TODAY]:
        return False
    if a[OTHER_BEFORE] > b[OTHER_BEFORE]:
        return False
    if weekly == 1 and a[WEEKLY_END] < b[WEEKLY_END]:
        return False
    if weeks == 1:
        if a[WEEK] != b[WEEK]:
            return place and a[WEEK] < b[WEEK] and _covers_week(a, b)
        later = b[TIME] - a[TIME]
        # Who is earlier drives more of what follows before Monday, unless it can wait.
        more = 0 if place else later
        if a[WEEK_DRIVEN] + more > b[WEEK_DRIVEN] or a[OTHER_WEEK] + more > b[OTHER_WEEK]:
            return False
        if a[WEEK_DRIVEN] + a[LAST_WEEK] + more > b[WEEK_DRIVEN] + b[LAST_WEEK]:
            return False
        if a[OTHER_WEEK] + a[OTHER_LAST_WEEK] + more > b[OTHER_WEEK] + b[OTHER_LAST_WEEK]:
            return False
    return True


DOMINANCE = (ask_less, _covers_week, covers)
"""Functions here, callees first."""
