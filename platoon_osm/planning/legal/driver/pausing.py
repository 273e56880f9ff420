"""Pauses: which kinds a label may take at a point, how long each lasts, and what is left after it.

Each is as short as allowed; one that is longer never does harm, and a wait that is left moves the
departure or the beginning of the duty period (`label`). Functions are plain; `kernel` compiles
them.
"""

from __future__ import annotations

from .label import (
    BESIDE,
    BROKEN,
    COLUMNS,
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
    OTHER_LONG_DAYS,
    OTHER_TODAY,
    OTHER_WEEK,
    PART,
    REDUCED_USED,
    TIME,
    TODAY,
    WEEK_DRIVEN,
    WEEK_S,
    WEEKLY_END,
    WORKED,
)
from .numbers import (
    APART,
    BESIDE_LENGTH,
    BREAK,
    CALENDAR,
    CHANGE,
    CHANGE_RESTED,
    DAILY,
    FIRST,
    LONG_WINDOW,
    MOST_REDUCED,
    NONE,
    PIECE,
    PIECE_LENGTH,
    POOLED,
    REDUCED,
    SECOND,
    WEEKLY,
    WEEKLY_DUE,
    WINDOW,
)
from .road import NO_LIMIT, IntArray

__all__ = ["PAUSES", "allowed", "lasts", "leave"]


def allowed(kind: int, a: IntArray, p: IntArray) -> bool:
    """Return whether a label may take a kind of pause.

    Parameters
    ----------
    kind : int
        Of `numbers`.
    a : int64 array, (COLUMNS,)
        The label.
    p : int64 array
        The limits.

    Returns
    -------
    bool
        Whether the law lets it begin one now.
    """
    if kind == FIRST:
        # It lies within the driving that the second ends, and not before it.
        return bool(a[BROKEN] > 0 and a[PART] == 0)
    if kind == SECOND:
        return bool(a[PART] == 1)
    if kind == PIECE:
        return bool(a[WORKED] > 0)
    if kind == CHANGE_RESTED:
        return bool(a[OTHER_BROKEN] > 0 and a[BESIDE] + p[CHANGE] < p[BESIDE_LENGTH])
    pause = APART[kind]
    if pause == BREAK:
        return bool(
            (a[BROKEN] > 0 or a[OTHER_BROKEN] > 0) and (a[PART] == 0 or p[BREAK] < p[SECOND])
        )
    if pause == REDUCED:
        return bool(a[DUTY] <= p[LONG_WINDOW] and a[REDUCED_USED] < p[MOST_REDUCED])
    if pause == DAILY:
        return bool(a[DUTY] <= p[WINDOW])
    if pause == WEEKLY:
        # A reduced daily rest that is left is as good as none used: the weekly rest restores them.
        late = a[DUTY] > p[WINDOW] and a[REDUCED_USED] >= p[MOST_REDUCED]
        due = a[WEEKLY_END] + p[WEEKLY_DUE]
        return bool(a[DUTY] <= p[LONG_WINDOW] and not late and a[TIME] <= due)
    return True


def lasts(kind: int, a: IntArray, p: IntArray) -> int:
    """Return how long a pause of a kind takes a label at least.

    Parameters
    ----------
    kind : int
        Of `numbers`.
    a : int64 array, (COLUMNS,)
        The label.
    p : int64 array
        The limits.

    Returns
    -------
    int
        Its length [s].
    """
    if kind == CHANGE_RESTED:
        return int(max(p[CHANGE], p[BESIDE_LENGTH] - a[BESIDE]))
    return int(p[kind])


def _change_seats(a: IntArray, length: int, p: IntArray, out: IntArray) -> None:
    """Let the other driver of a label take over after both have paused, but not long enough."""
    out[BROKEN] = a[OTHER_BROKEN] if a[BESIDE] + length < p[BESIDE_LENGTH] else 0
    out[OTHER_BROKEN] = a[BROKEN]
    out[BESIDE] = length if a[BROKEN] > 0 else p[BESIDE_LENGTH]


def leave(
    kind: int, begins: int, opens: int, closes: int, stay: int, forced: int, a: IntArray,
    p: IntArray, monday: int, fixed_weekly_end: int, out: IntArray,
) -> bool:  # fmt: skip
    """Fill a label that has paused and leaves, within moments that are allowed.

    Parameters
    ----------
    kind : int
        Of its pause, which is as long as that asks at least.
    begins : int
        When it arrives [s].
    opens, closes : int
        When it leaves at the earliest and at the latest [s].
    stay : int
        How long it may stand [s].
    forced : int
        1 if it has to leave at that moment, and may stand longer.
    a : int64 array, (COLUMNS,)
        The label.
    p : int64 array
        The limits.
    monday : int
        A Monday 0:00 UTC [s].
    fixed_weekly_end : int
        The end of a weekly rest that does not move with the departure [s].
    out : int64 array, (COLUMNS,)
        Filled.

    Returns
    -------
    bool
        Whether it can.
    """
    length = lasts(kind, a, p)
    pause = APART[kind]
    if length > stay and kind != NONE:
        return False
    ready = begins + length
    if ready > closes:
        return False
    leaves = max(ready, opens)
    for column in range(COLUMNS):
        out[column] = a[column]
    wait = leaves - ready
    duty_slack = a[DUTY_MOST] - (begins - a[DUTY])
    gone_slack = a[GONE_MOST] - (begins - a[GONE])
    if pause in (REDUCED, DAILY, WEEKLY) and a[DUTY_MOST] < FAR:
        # A duty period that began before the trip does not move with the departure: the rest still
        # has to begin in time.
        full = pause == DAILY or (pause == WEEKLY and a[REDUCED_USED] >= p[MOST_REDUCED])
        window = p[WINDOW] if full else p[LONG_WINDOW]
        gone_slack = min(gone_slack, duty_slack + window - a[DUTY])
    duty_move = min(wait, duty_slack)
    gone_move = min(wait, gone_slack)
    move = max(duty_move, gone_move)
    slack = max(duty_slack, gone_slack) - move
    stood = leaves - begins - move
    ends = leaves
    if stood > stay:
        if forced == 0:
            return False
        # Of a longer wait than the place allows only so much is a pause; the rest comes after it.
        ends = leaves - (stood - max(stay, length))
    if a[WEEKLY_END] > fixed_weekly_end:
        out[WEEKLY_END] += gone_move
    room = NO_LIMIT
    if forced == 1:
        room = 0
    elif closes < NO_LIMIT:
        room = closes - leaves
    out[TIME] = leaves
    out[GONE] = a[GONE] + (leaves - begins) - gone_move
    if room < NO_LIMIT:
        gone_slack = min(gone_slack - gone_move, room)
        out[GONE_MOST] = leaves - out[GONE] + gone_slack
    else:
        out[GONE_MOST] = min(a[GONE_MOST], begins - a[GONE] + gone_slack)
    if length >= p[PIECE_LENGTH]:
        out[WORKED] = 0
    if kind == FIRST:
        out[PART] = 1
    if kind >= CHANGE:
        _change_seats(a, length, p, out)
    if kind >= CHANGE and p[POOLED] == 0:
        out[TODAY], out[OTHER_TODAY] = a[OTHER_TODAY], a[TODAY]
        out[LONG_DAYS], out[OTHER_LONG_DAYS] = a[OTHER_LONG_DAYS], a[LONG_DAYS]
        out[WEEK_DRIVEN], out[OTHER_WEEK] = a[OTHER_WEEK], a[WEEK_DRIVEN]
        out[LAST_WEEK], out[OTHER_LAST_WEEK] = a[OTHER_LAST_WEEK], a[LAST_WEEK]
    if pause in (SECOND, BREAK, REDUCED, DAILY, WEEKLY):
        out[BROKEN] = 0
        out[PART] = 0
        out[OTHER_BROKEN] = 0
        out[BESIDE] = p[BESIDE_LENGTH]
    if pause in (REDUCED, DAILY, WEEKLY):
        out[WORKED] = 0
        out[TODAY] = 0
        out[OTHER_TODAY] = 0
        out[DUTY] = leaves - ends
        longer = stay - (stood if stood < stay else stay)
        slack = min(slack + longer, room)
        out[DUTY_MOST] = ends + slack if slack < FAR else NO_LIMIT
        week = (ends - monday) // WEEK_S
        if week != a[DUTY_WEEK]:
            out[LONG_DAYS] = 0
            out[OTHER_LONG_DAYS] = 0
            out[DUTY_WEEK] = week
        if pause == REDUCED:
            out[REDUCED_USED] += 1
        if pause == WEEKLY:
            out[REDUCED_USED] = 0
            out[WEEKLY_END] = ends
            if p[CALENDAR] == 0:
                out[WEEK_DRIVEN] = 0
                out[OTHER_WEEK] = 0
    else:
        out[DUTY] = a[DUTY] + (leaves - begins) - duty_move
        if room < NO_LIMIT:
            out[DUTY_MOST] = min(a[DUTY_MOST], leaves - out[DUTY] + room)
    return True


PAUSES = (allowed, lasts, _change_seats, leave)
"""What these functions call, and they themselves, callees first."""
