"""Between which departures of the master a member can drive a pair of points, with one entry.

The member leaves its merging point when it and the platoon can at the earliest. What comes after,
how long it has been on duty and when it arrives, only gets later if it leaves later; so the
departures at which the pair can be driven lie between two moments. Its clocks do not depend on the
departure: it drives from one stop of the platoon to the next, and goes on by one of its exits.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .clocks import (
    ARRIVAL,
    DAY,
    EARLIEST,
    FAR,
    LATEST,
    REST,
    SPELL,
    SURE_DAY,
    SURE_REST,
    SURE_WINDOW,
    WINDOW,
    breaks_s,
    needed,
    onward_at,
    paused,
)  # fmt: skip
from .own_ways import (
    BEFORE,
    DRIVEN,
    FREE,
    HELD,
    LASTS,
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

__all__ = ["HELPERS", "departures", "most_driven"]

Seconds = NDArray[np.int64]


def _leaves_by(
    exits: Seconds, go: int, gone: int, free: int, parted: int, today: int, lasts: int, since: int,
    spare_s: int,
) -> int:  # fmt: skip
    """Return when a member may leave its merging point at the latest to take some exit.

    Its clocks at the separation point are given; how long it has been on duty by then at least,
    and when its duty began if it has begun already, as a moment; and when it would have to leave
    to be in time without standing [s].
    """
    latest = -FAR
    for k in range(go, gone):
        if (
            (free <= exits[k, MOST_FREE] or parted <= exits[k, MOST_PARTED])
            and today <= exits[k, MOST_TODAY]
            and lasts <= exits[k, MOST_DUTY]
        ):
            latest = max(latest, min(exits[k, MOST_DUTY] + since, spare_s - exits[k, STANDS]))
    return latest


def most_driven(
    v: Seconds, exits: Seconds, go: int, gone: int, clocks: Seconds, own: int, low: int, high: int,
    stop_at: Seconds, c: int, stops: int, q: int, stopped: int, rested: int, soon: int, sure: bool,
) -> tuple[int, int, int]:  # fmt: skip
    """Return what clocks may be at a merging point at most for a pair to be driven.

    They must last up to the first stop of the platoon, or for some exit where it makes none. With
    an entry whose clocks are beyond that `departures` need not be asked.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the member.
    exits : ndarray of int
        See `plain_ways`.
    go, gone : int
        From which exit to which.
    clocks : ndarray of int
        The master's way, see `StarNumbers`.
    own : int
        Which of the clocks is the member's.
    low, high : int
        The positions of the points.
    stop_at : ndarray of int, (C, S)
        Stops that are decided.
    c, stops, q, stopped, rested, soon : int
        As `departures` takes them.
    sure : bool
        Whether limits are the strict ones.

    Returns
    -------
    (int, int, int)
        Driven with no part of a break taken, with the first part, one of which must hold, and
        today [s].
    """
    day = v[SURE_DAY] if sure else v[DAY]
    step = clocks[own, high] - clocks[own, low]
    if q < stops and stop_at[c, q] <= high:
        step = clocks[own, stop_at[c, q]] - clocks[own, low]
        return v[SPELL] - step, v[SPELL] - step, day - step
    if stopped >= 0:
        alone = v[SPELL] - clocks[own, soon] + clocks[own, low]
        return alone, alone, FAR if rested >= 0 else day - step
    free, parted, today = -1, -1, -1
    for k in range(go, gone):
        free = max(free, exits[k, MOST_FREE])
        parted = max(parted, exits[k, MOST_PARTED])
        today = max(today, exits[k, MOST_TODAY])
    free, parted, today = min(free, v[SPELL]), min(parted, v[SPELL]), min(today, day)
    return free - step, parted - step, today - step


def departures(
    v: Seconds, entries: Seconds, e: int, exits: Seconds, go: int, gone: int, approach_s: int,
    onward_s: int, low: int, high: int, tau: Seconds, clocks: Seconds, own: int, stop_at: Seconds,
    stop_s: Seconds, c: int, stops: int, q: int, stopped: int, rested: int, soon: int, once: bool,
    first: int,
    last: int, arrives: int, sure: bool, begin: int,
) -> tuple[int, int]:  # fmt: skip
    """Return between which departures of the master a pair can be driven with an entry.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the member.
    entries : ndarray of int
        See `plain_ways`.
    e : int
        The entry.
    exits : ndarray of int
        See `plain_ways`.
    go, gone : int
        From which exit to which.
    approach_s, onward_s : int
        Driving times to the merging point and from the separation point [s].
    low, high : int
        Their positions.
    tau, clocks : ndarray of int
        The master's way, see `StarNumbers`.
    own : int
        Which of the clocks is the member's.
    stop_at, stop_s : ndarray of int, (C, S)
        Stops that are decided.
    c, stops, q : int
        The timetable, how many stops it has, and the first of them behind `low`.
    stopped, rested : int
        The last position before `high` at which the platoon may have stopped, and rested, where
        that is not decided; -1 if nowhere behind `low`.
    soon : int
        The first position at which it may do so, of no meaning if it may not.
    once : bool
        Whether it does so once at most.
    first, last : int
        When the platoon leaves `low`, after the master's departure [s].
    arrives : int
        When it reaches `high` at the earliest, likewise [s].
    sure : bool
        Whether limits are the strict ones.
    begin : int
        Departures before this are of no interest [s].

    Returns
    -------
    (int, int)
        The first and the last; the last is before the first if there is none [s].
    """
    day = v[SURE_DAY] if sure else v[DAY]
    rest = v[SURE_REST] if sure else v[REST]
    window = v[SURE_WINDOW] if sure else v[WINDOW]
    spell = v[SPELL]
    ready = entries[e, READY]
    opens = max(begin, ready - last)
    latest = v[LATEST] if approach_s == 0 else FAR
    # After t seconds behind `low` it has been on duty for `lasts + t` at least, and since `since`.
    if entries[e, MODE] == HELD:
        lasts, since = -FAR, v[EARLIEST] - entries[e, BEFORE]
    elif entries[e, MODE] == RESTED:
        lasts, since = entries[e, LASTS], FAR
    else:
        lasts = entries[e, LASTS] + entries[e, BEFORE]
        since = v[LATEST] - entries[e, BEFORE]
    free, parted, today = entries[e, FREE], entries[e, PARTED], entries[e, DRIVEN]
    at, after = low, 0
    while q < stops and stop_at[c, q] < high:
        step = clocks[own, stop_at[c, q]] - clocks[own, at]
        after += tau[stop_at[c, q]] - tau[at]
        at = stop_at[c, q]
        free = free + step if free + step <= spell else FAR
        parted = parted + step if parted + step <= spell else FAR
        today += step
        if (free >= FAR and parted >= FAR) or today > day or lasts + after > window:
            return 0, -1
        latest = min(latest, window - after + since)
        after += stop_s[c, q]
        if stop_s[c, q] >= rest:
            free, parted, today, lasts, since = 0, FAR, 0, -after, FAR
        else:
            free, parted = paused(v, free, parted, stop_s[c, q])
        q += 1
    step, drive = clocks[own, high] - clocks[own, at], tau[high] - tau[at]
    spare = v[ARRIVAL] - onward_s
    if stopped >= 0:
        # Clocks may begin anew on the way; but then that takes its time.
        driven, duty, from_then = today + step, lasts + after + drive, since
        alone_s = clocks[own, soon] - clocks[own, at]
        if min(free, parted) + alone_s > spell:
            return 0, -1
        fresh = clocks[own, high] - clocks[own, stopped]
        # One stop alone is no first part and whole break, or second part, of one another.
        half = min(free, parted) + step if once else fresh
        if rested >= 0:
            driven, from_then = clocks[own, high] - clocks[own, rested], FAR
            duty = tau[high] - tau[rested]
        elif driven > day or duty > window:
            return 0, -1
        closes = _leaves_by(
            exits, go, gone, fresh, half, driven, duty, from_then - after - drive,
            spare - after - drive,
        )  # fmt: skip
        opens_at = max(ready, opens + first)
        on_duty = max(lasts + after, opens_at + after - since)
        now = opens_at + after
        ends = onward_at(
            v, free, parted, today, now - on_duty, now, drive + onward_s, step + onward_s
        )  # fmt: skip
        latest = min(latest, closes, opens_at + v[ARRIVAL] - ends)
        by_platoon = _leaves_by(exits, go, gone, fresh, half, driven, duty, FAR, spare) - arrives
        if latest < ready:
            return 0, -1
        return opens, min(latest - first, by_platoon)
    after += drive
    free = free + step if free + step <= spell else FAR
    parted = parted + step if parted + step <= spell else FAR
    today += step
    if (free >= FAR and parted >= FAR) or today > day or lasts + after > window:
        return 0, -1
    latest = min(latest, window - after + since)
    closes = _leaves_by(
        exits, go, gone, free, parted, today, lasts + after, since - after, spare - after
    )
    if q < stops and stop_at[c, q] == high:
        # It stops with the platoon before it goes on.
        after += stop_s[c, q]
        if stop_s[c, q] >= rest:
            free, parted, today, lasts, since = 0, FAR, 0, -after, FAR
        else:
            free, parted = paused(v, free, parted, stop_s[c, q])
        closes = max(
            closes,
            _leaves_by(
                exits, go, gone, free, parted, today, lasts + after, since - after, spare - after
            ),
        )
    latest = min(latest, closes)
    if latest < ready:
        return 0, -1
    return opens, latest - first


HELPERS = (needed, breaks_s, paused, onward_at, _leaves_by, most_driven, departures)
"""What kernels call, callees first: to be made known to the compiler before them."""
