"""When a point is better left: so that a week's driving suffices, or after a rest meanwhile.

Functions are plain; `kernel` compiles them.
"""

from __future__ import annotations

from .label import (
    GONE,
    GONE_MOST,
    LAST_WEEK,
    OTHER_LAST_WEEK,
    OTHER_WEEK,
    PART,
    TIME,
    WEEK,
    WEEK_DRIVEN,
    WEEK_S,
)
from .numbers import APART, CHANGE, DAILY, FIRST, FORTNIGHT, MOST_WEEK, NONE, PIECE, POOLED, WEEKLY
from .pausing import allowed
from .road import NO_LIMIT, IntArray

__all__ = ["LEAVING", "after_sunday", "may_rest"]


def _sunday_start(which: int, kind: int, a: IntArray, p: IntArray, monday: int) -> int:
    """Return when to start so that the week's driving is not too much, at the earliest.

    That is next Monday 0:00, or as long before it as who then drives may still in this week.
    """
    week = (a[TIME] - monday) // WEEK_S
    begins = monday + (week + 1) * WEEK_S
    if which == 0:
        return int(begins)
    driven, last = a[WEEK_DRIVEN], a[LAST_WEEK]
    if kind >= CHANGE and p[POOLED] == 0:
        driven, last = a[OTHER_WEEK], a[OTHER_LAST_WEEK]
    if week > a[WEEK]:
        last = driven if week == a[WEEK] + 1 else 0
        driven = 0
    return int(begins - max(0, min(p[MOST_WEEK] - driven, p[FORTNIGHT] - driven - last)))


def after_sunday(
    which: int, kind: int, a: IntArray, p: IntArray, monday: int, windows: IntArray
) -> tuple[int, int]:
    """Return from and to when a label may leave a point that waits for a week to suffice.

    Parameters
    ----------
    which : int
        0 to wait for Monday, 1 until what is left of the week lasts till then.
    kind : int
        Of its pause.
    a : int64 array, (COLUMNS,)
        The label.
    p : int64 array
        The limits.
    monday : int
        A Monday 0:00 UTC [s].
    windows : int64 array, (k, 2)
        When the point may be left [s]; empty if at any time.

    Returns
    -------
    opens, closes : int
        Both in it [s]; `closes` is before all times if it need not wait.
    """
    opens, closes = _sunday_start(which, kind, a, p, monday), NO_LIMIT
    if opens <= a[TIME]:
        return opens, -NO_LIMIT
    for window in range(len(windows)):
        closes = windows[window, 1]
        if closes >= opens:
            return max(opens, windows[window, 0]), closes
    return opens, closes


def may_rest(kind: int, a: IntArray, p: IntArray, opens: int, stay: int, late: bool) -> bool:
    """Return whether a label that waits for a moment had better rest meanwhile.

    Who can rest does, unless it left later instead.

    Parameters
    ----------
    kind : int
        Of its pause.
    a : int64 array, (COLUMNS,)
        The label.
    p : int64 array
        The limits.
    opens, stay : int
        When it may leave, and how long it may stand [s].
    late : bool
        Whether a later departure is worth a label.

    Returns
    -------
    bool
        True if another kind of pause is better than this.
    """
    spare = opens - a[TIME] - p[DAILY]
    if late:
        spare -= a[GONE_MOST] - (a[TIME] - a[GONE])
    if spare < 0 or p[DAILY] > stay:
        return False
    # A first part that was taken is no worse than a rest, where it counts.
    other = APART[kind] in (DAILY, WEEKLY, FIRST) or (a[PART] == 1 and kind in (NONE, PIECE))
    return not other and allowed(DAILY, a, p)


LEAVING = (_sunday_start, after_sunday, may_rest)
"""Functions here, callees first."""
