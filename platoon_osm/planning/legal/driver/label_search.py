"""Labels of one driver along a road: what it has behind it, where that is all that matters.

A label is a legal beginning of a trip up to a point. Its fields are the time, driving since the
last break and since the last daily rest, how long ago the duty period began and how late that could
have been, and so on. At a point that has a place it takes every kind of pause there is, each as
short as allowed; then it drives the next hop. Of two labels at a point one is dropped if the other
is not later and in nothing behind: whatever follows the one may follow the other, which pauses
longer where it would be too early. (A pause that is longer never does harm.)

Slack. Where a vehicle has to wait (an appointment, a ban), it could instead have left later or have
prolonged its last rest, which moves the beginning of the duty period. So labels hold besides that
beginning the latest moment to which it could be moved without any other change, and likewise for
the departure. A wait of w with a pause of q in it moves both by what is left of w, as far as they
go; each q is a label of its own. As elapsed times do not change when all is moved, labels are
compared in elapsed time and in the latest moment.

Functions here are plain; `kernel` compiles them.
"""

from __future__ import annotations

import numpy as np

from .numbers import (
    APART,
    BREAK,
    CHANGE,
    CHANGE_RESTED,
    DAILY,
    FIRST,
    LENGTHS,
    NONE,
    PIECE,
    REDUCED,
    SECOND,
    WEEKLY,
)  # fmt: skip
from .road import FREE, NO_LIMIT, IntArray

__all__ = ["COLUMNS", "HELPERS", "INFO", "least_left", "search"]

# Fields of a label.
TIME, BROKEN, PART, WORKED, TODAY, DUTY, DUTY_MOST, LONG_DAYS, REDUCED_USED = range(9)
WEEK_DRIVEN, LAST_WEEK, WEEK, WEEKLY_END, GONE, GONE_MOST, BESIDE = range(9, 16)
OTHER_TODAY, OTHER_LONG_DAYS, OTHER_WEEK, OTHER_LAST_WEEK, DUTY_WEEK = range(16, 21)
OTHER_BROKEN = 21
# Long days but today, and when to be here at the latest if all that follows is driving and pauses.
BEFORE, OTHER_BEFORE, ENDS = 22, 23, 24
COLUMNS = 25

# What is kept of how it came about: its parent, its kind of pause, when it might then leave, and
# how long it pauses at least.
PARENT, KIND, OPENS, CLOSES, LASTS = range(5)
INFO = 5

# Positions of the limits, after the lengths of the pauses.
SPELL, WORK, PIECE_LENGTH, DAY, LONG_DAY, MOST_LONG, WINDOW, LONG_WINDOW = range(
    LENGTHS, LENGTHS + 8
)
MOST_REDUCED, MOST_WEEK, FORTNIGHT, WEEKLY_DUE, BESIDE_LENGTH, CALENDAR, POOLED, DUE = range(
    LENGTHS + 8, LENGTHS + 16
)

WEEK_S = 604_800

TO_MONDAY = 8
"""How much less the time without waiting for Monday counts for what is promising."""

FAR = 2**50
"""No time is so long [s]."""


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


def _drive(
    a: IntArray, seconds: int, clock: int, p: IntArray, monday: int, weeks: int, weekly: int
) -> bool:
    """Let a label drive a hop; return whether it may."""
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


def _ask_less(
    a: IntArray, seconds: int, clock: int, latest: int, moves: bool, p: IntArray
) -> None:  # fmt: skip
    """Let a label have no more left than it can make use of till the end.

    Its `ENDS` less what elapses from a departure or the beginning of a duty period is the latest
    that this may be moved to: the rest arrives too late. A weekly rest that is due before the end
    begins before it is over by then.
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


def _covers(a: IntArray, b: IntArray, place: bool, late: bool, weeks: int, weekly: int) -> bool:
    """Return whether a label that is not later than another is in nothing behind it."""
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


def _by_time(labels: IntArray, count: int, order: IntArray) -> None:
    """Sort the positions of labels by time (Shell's method)."""
    for k in range(count):
        order[k] = k
    gap = count // 2
    while gap > 0:
        for k in range(gap, count):
            moved = order[k]
            at = labels[moved, TIME]
            place = k
            while place >= gap and labels[order[place - gap], TIME] > at:
                order[place] = order[place - gap]
                place -= gap
            order[place] = moved
        gap //= 2


def _grown(array: IntArray, least: int) -> IntArray:
    """Return an array with room for more rows."""
    rows = len(array)
    if least <= rows:
        return array
    larger = np.zeros((max(least, 2 * rows), array.shape[1]), np.int64)
    larger[:rows] = array
    return larger


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
    first = np.zeros(n + 2, np.int64)
    kept = np.zeros((256, COLUMNS), np.int64)
    kept_info = np.zeros((256, INFO), np.int64)
    found = np.zeros((256, COLUMNS), np.int64)
    found_info = np.zeros((256, INFO), np.int64)
    order = np.zeros(256, np.int64)
    need = np.zeros(COLUMNS, np.int64)
    total = 0
    for k in range(n):
        count = 0
        low, high = first[k], total
        if k == 0:
            low, high = 0, len(begins)
        for label in range(low, high):
            tries = 1 if k == 0 else len(kinds)
            for choice in range(tries):
                kind = NONE
                regular = 1
                extra = 0
                if k > 0:
                    kind = kinds[choice]
                    if kind != NONE and p[kind] > stay_s[k]:
                        break
                    if not allowed(kind, kept[label], p):
                        continue
                    regular = max(1, windows_first[k + 1] - windows_first[k])
                    if weeks == 1 and p[CALENDAR] == 1 and stay_s[k] > 0 and leave_s[k] == FREE:
                        extra = 2
                tried = 0
                for opening in range(regular + extra):
                    if openings > 0 and tried >= openings and opening < regular:
                        continue
                    found = _grown(found, count + 2)
                    found_info = _grown(found_info, count + 2)
                    out = found[count]
                    opens, closes, forced = 0, NO_LIMIT, 0
                    if k == 0:
                        out[:] = begins[label]
                        found_info[count, OPENS] = begins_info[label, OPENS]
                        found_info[count, CLOSES] = begins_info[label, CLOSES]
                        found_info[count, KIND] = begins_info[label, KIND]
                        found_info[count, LASTS] = begins_info[label, LASTS]
                        found_info[count, PARENT] = -1
                    else:
                        a = kept[label]
                        opens = -NO_LIMIT
                        if opening >= regular:
                            # Wait for Monday, or until what is left of the week lasts till then.
                            opens = _sunday_start(opening - regular, kind, a, p, monday)
                            if opens <= a[TIME]:
                                continue
                            for window in range(windows_first[k], windows_first[k + 1]):
                                closes = windows_s[window, 1]
                                if closes >= opens:
                                    opens = max(opens, windows_s[window, 0])
                                    break
                        elif windows_first[k + 1] > windows_first[k]:
                            opens = windows_s[windows_first[k] + opening, 0]
                            closes = windows_s[windows_first[k] + opening, 1]
                        if leave_s[k] != FREE:
                            if leave_s[k] < opens or leave_s[k] > closes:
                                continue
                            opens, closes, forced = leave_s[k], leave_s[k], 1
                        if closes < a[TIME]:
                            continue
                        if opens + drive_s[k] > due[k + 1]:
                            continue
                        # Who can rest meanwhile does, unless it left later instead.
                        spare = opens - a[TIME] - p[DAILY]
                        if late:
                            spare -= a[GONE_MOST] - (a[TIME] - a[GONE])
                        # A first part that was taken is no worse than a rest, where it counts.
                        other = APART[kind] in (DAILY, WEEKLY, FIRST) or (
                            a[PART] == 1 and kind in (NONE, PIECE)
                        )
                        if (
                            opening > 0 and weekly == 0 and spare >= 0 and not other
                            and p[DAILY] <= stay_s[k] and allowed(DAILY, a, p)
                        ):  # fmt: skip
                            continue
                        done = leave(
                            kind, a[TIME], opens, closes, stay_s[k], forced, a, p, monday,
                            fixed_weekly_end, out,
                        )  # fmt: skip
                        if not done:
                            continue
                        tried += 1
                        found_info[count, PARENT] = label
                        found_info[count, KIND] = kind
                        found_info[count, OPENS] = opens
                        found_info[count, CLOSES] = closes
                        found_info[count, LASTS] = lasts(kind, a, p)
                    if not _drive(out, drive_s[k], clock_s[k], p, monday, weeks, weekly):
                        continue
                    if out[TIME] > due[k + 1]:
                        continue
                    bound = least_left(out, left_s[k + 1], left_clock[k + 1], p, monday, weeks)
                    if out[TIME] + bound > latest:
                        continue
                    # Waiting for Monday moves departures, what is driven and paused does not.
                    if weeks == 1 or weekly == 1:
                        bound = _without_waiting(
                            out, left_s[k + 1], left_clock[k + 1], bound, p, monday, weekly,
                            out[WEEKLY_END] > fixed_weekly_end,
                        )  # fmt: skip
                    ends = latest - bound
                    if out[TIME] > ends:
                        continue
                    if late and min(out[GONE_MOST], ends - out[GONE]) < leaves:
                        continue
                    out[ENDS] = ends
                    out[BEFORE] = out[LONG_DAYS] - (out[TODAY] > p[DAY])
                    out[OTHER_BEFORE] = out[OTHER_LONG_DAYS] - (out[OTHER_TODAY] > p[DAY])
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
        if count > len(order):
            order = np.zeros(2 * count, np.int64)
        _by_time(found, count, order)
        place = stay_s[k + 1] >= NO_LIMIT
        for position in range(count):
            label = order[position]
            b = found[label]
            need[:] = b
            moves = need[WEEKLY_END] > fixed_weekly_end
            _ask_less(need, left_s[k + 1], left_clock[k + 1], latest, moves, p)
            covered = False
            if dominance:
                for other in range(first[k + 1], total):
                    # Most are told apart by these.
                    if (
                        kept[other, BROKEN] > need[BROKEN] or kept[other, DUTY] > need[DUTY]
                        or kept[other, REDUCED_USED] > need[REDUCED_USED]
                        or kept[other, BEFORE] > need[BEFORE] or kept[other, TODAY] > need[TODAY]
                    ):  # fmt: skip
                        continue
                    if _covers(kept[other], need, place, late, weeks, weekly):
                        covered = True
                        break
            if covered:
                continue
            kept = _grown(kept, total + 1)
            kept_info = _grown(kept_info, total + 1)
            kept[total] = b
            kept_info[total] = found_info[label]
            total += 1
        if width > 0 and total - first[k + 1] > width:
            # The most promising: by when they could arrive at the earliest.
            begin = first[k + 1]
            size = total - begin
            bounds = np.zeros(size, np.int64)
            for position in range(size):
                a = kept[begin + position]
                found[position] = a
                found_info[position] = kept_info[begin + position]
                bounds[position] = a[TIME]
                bound = least_left(a, left_s[k + 1], left_clock[k + 1], p, monday, weeks)
                # The same Monday is waited for by many: then who would be there first without.
                found[position, TIME] += bound + (a[TIME] + latest - a[ENDS]) // TO_MONDAY
            _by_time(found, size, order)
            for position in range(width):
                label = order[position]
                kept[begin + position] = found[label]
                kept[begin + position, TIME] = bounds[label]
                kept_info[begin + position] = found_info[label]
            total = begin + width
    first[n + 1] = total
    return kept, kept_info, first


HELPERS = (
    allowed, lasts, _change_seats, leave, _drive, _ask_less, _covers_week, _covers, least_left,
    _without_waiting, _sunday_start, _by_time, _grown,
)  # fmt: skip
"""What the search calls: to be made known to the compiler before it."""
