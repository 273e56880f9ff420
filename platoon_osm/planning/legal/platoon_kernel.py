"""What each member of a platoon pays at least, or for certain, while the master leaves in a span.

A member merges at point i and separates at point j of the master's way. Its clocks are what it has
driven since its last break, with no part of the next one taken and with the first part of it taken
(which of them is better only shows later), what it has driven since its last daily rest, and when
its duty began. Of a span [u, v] of the master's departure two values
are computed by the same loop:

- *at least*: it merges as if the master left at v and separates as if at u, may pause anywhere on
  its own ways, and its duty begins as late as possible. No plan with the master's departure in the
  span costs it less.
- *for certain*: it merges as if the master left at u and separates as if at v, and pauses only
  before it leaves, where it merges and with the platoon. That is within the law whenever the
  master leaves in the span.

Stops of the master that are not decided yet leave clocks anything from their value down to nothing,
and the platoon leaves late and arrives early by as much as they may last. Functions are plain;
`platoon_compiled.py` compiles them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["FAR", "HELPERS", "NUMBERS", "entry_states", "evaluate", "needed", "paused"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]

FAR = 2**50
"""No time is so long [s]."""

# What is known of a vehicle, as whole numbers.
SPELL, BREAK, FIRST, SECOND = range(4)
DAY, REST, WINDOW = range(4, 7)
SURE_DAY, SURE_REST, SURE_WINDOW, PLAIN = range(7, 11)
BROKEN, PART, TODAY, DUTY, HOLDS = range(11, 16)
EARLIEST, LATEST, ARRIVAL = range(16, 19)
NUMBERS = 19


def needed(spell: int, driven: int, seconds: int) -> int:
    """Return how many breaks it takes to drive on for some seconds.

    Parameters
    ----------
    spell, driven, seconds : int
        The longest spell, what was driven of it, and what is to be driven [s].

    Returns
    -------
    int
        The fewest.
    """
    over = driven + seconds - spell
    return int((over + spell - 1) // spell) if over > 0 else 0


def breaks_s(v: Seconds, count: int, part: int) -> int:
    """Return how long some breaks last, of which the first may be half taken.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the vehicle.
    count : int
        How many.
    part : int
        1 if the first part of the first is taken.

    Returns
    -------
    int
        Together [s].
    """
    if count <= 0:
        return 0
    return int(
        count * v[BREAK] - (v[BREAK] - v[SECOND] if part == 1 and v[SECOND] < v[BREAK] else 0)
    )


def paused(v: Seconds, free: int, parted: int, pause: int) -> tuple[int, int]:
    """Return what has been driven after a pause: with no part of a break taken, and with the first.

    A pause need not be counted as all it could be, so both are kept; `FAR` is a state that is not.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the vehicle.
    free, parted : int
        What was driven before it, likewise [s].
    pause : int
        How long it lasts [s].

    Returns
    -------
    free, parted : int
        What counts after it [s].
    """
    after = parted
    if pause >= v[FIRST]:
        after = min(parted, free)
    if pause >= v[BREAK] or (parted < FAR and pause >= v[SECOND]):
        return 0, after
    return free, after


def _onward(
    v: Seconds, free: int, parted: int, today: int, duty: int, at: int, drive_s: int
) -> int:
    """Return when a vehicle arrives at the earliest that drives on, with pauses anywhere."""
    best = FAR
    for part in range(2):
        driven = parted if part == 1 else free
        if driven >= FAR:
            continue
        count = needed(v[SPELL], driven, drive_s)
        if today + drive_s <= v[DAY]:
            arrives = at + drive_s + breaks_s(v, count, part)
            if arrives - duty <= v[WINDOW]:
                best = min(best, arrives)
        if v[REST] < FAR:
            rests = max(1, needed(v[DAY], today, drive_s))
            stood = rests * v[REST] + breaks_s(v, count - rests, part)
            best = min(best, at + drive_s + stood)
    return int(best)


def entry_states(
    v: Seconds, drive_s: int, leaves: int, stay_s: int, sure: bool, states: Seconds
) -> int:
    """Fill the clocks with which a vehicle may leave its merging point; return how many there are.

    Each row holds what it has driven with no part of a break taken and with the first part, what it
    has driven today, and the beginning of its duty.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the vehicle.
    drive_s, leaves : int
        Its driving time to the point, and when it leaves it [s].
    stay_s : int
        How long it may pause there [s].
    sure : bool
        Whether it pauses only before it leaves its origin and there; else anywhere.
    states : ndarray of int, (2, 4)
        To be filled.

    Returns
    -------
    int
        Rows filled.
    """
    spare = leaves - v[EARLIEST] - drive_s
    if spare < 0:
        return 0
    if v[HOLDS] == 0 and drive_s == 0:
        spare = 0  # what is known of it holds whenever it leaves
    held = v[HOLDS] == 1 and v[DUTY] >= 0
    before = max(0, v[DUTY])
    if sure:
        count = 0
        # Pausing where it merges, or all before it leaves.
        for here in range(2):
            pause = v[BREAK] if here == 0 else 0
            if here == 0 and (spare < pause or stay_s < pause or v[BREAK] >= FAR):
                continue
            start = min(leaves - drive_s - pause, v[LATEST])
            stood = start - v[EARLIEST] if v[HOLDS] == 1 else 0
            free = FAR if v[PART] == 1 else v[BROKEN]
            parted = v[BROKEN] if v[PART] == 1 else FAR
            today = v[TODAY]
            duty = v[EARLIEST] - before if held else start - before
            if stood >= v[SURE_REST]:
                free, parted, today, duty = 0, FAR, 0, start
            else:
                free, parted = paused(v, free, parted, stood)
            free += drive_s
            parted += drive_s
            today += drive_s
            if free > v[SPELL]:
                free = FAR
            if parted > v[SPELL]:
                parted = FAR
            if (free >= FAR and parted >= FAR) or today > v[SURE_DAY]:
                continue
            if here == 0:
                free, parted = paused(v, free, parted, pause)
            states[count, 0], states[count, 1] = free, parted
            states[count, 2], states[count, 3] = today, duty
            count += 1
        return count
    breaks = needed(v[SPELL], v[BROKEN], drive_s)
    if v[REST] < FAR and spare >= v[REST] + breaks_s(v, breaks - 1, v[PART]):
        states[0, 0], states[0, 1], states[0, 2], states[0, 3] = 0, 0, 0, leaves
        return 1
    least = breaks_s(v, breaks, v[PART])
    if least > spare or v[TODAY] + drive_s > v[DAY]:
        return 0
    driven = v[BROKEN] + drive_s - breaks * v[SPELL] if breaks > 0 else v[BROKEN] + drive_s
    fresh = breaks_s(v, breaks + 1, v[PART])
    states[0, 0] = 0 if spare >= fresh else driven
    states[0, 1] = FAR
    if spare >= fresh + v[FIRST]:
        states[0, 1] = 0
    elif spare >= least + v[FIRST] or (breaks == 0 and v[PART] == 1):
        states[0, 1] = driven
    states[0, 2] = v[TODAY] + drive_s
    states[0, 3] = v[EARLIEST] if held else min(v[LATEST], leaves - drive_s - least)
    states[0, 3] -= before
    return 1


def _timetable(
    pos: Seconds, tau: Seconds, stop_at: Seconds, stop_s: Seconds, leaves: int, arrives: int,
    ahead: Seconds, later: Seconds, dep: Seconds, arr: Seconds, stop_dep: Seconds,
    stop_arr: Seconds,
) -> None:  # fmt: skip
    """Fill when the platoon leaves points and stops at the latest, and arrives at the earliest."""
    stood, q = 0, 0
    for k in range(len(pos)):
        while q < len(stop_at) and stop_at[q] < pos[k]:
            stop_arr[q] = arrives + tau[stop_at[q]] + stood
            stood += stop_s[q]
            stop_dep[q] = leaves + tau[stop_at[q]] + stood
            q += 1
        here = stop_s[q] if q < len(stop_at) and stop_at[q] == pos[k] else 0
        arr[k] = arrives + tau[pos[k]] + stood + ahead[k]
        dep[k] = leaves + tau[pos[k]] + stood + here + later[k]


def evaluate(
    rows: Seconds, vehicles: Seconds, approach: Seconds, entry: Floats, onward_s: Seconds,
    leave: Floats, platoon: Floats, alone: Floats, slack: Floats, pos: Seconds, tau: Seconds,
    clocks: Seconds, clock_of: Seconds, along: Floats, stay: Seconds, stop_at: Seconds,
    stop_s: Seconds, open_from: int, rests_open: bool, ahead: Seconds, later: Seconds, leaves: int,
    arrives: int, sure: bool, refuted_first: Seconds, refuted: Seconds, cost: Floats,
    merge: Seconds, separate: Seconds,
) -> None:  # fmt: skip
    """Fill the cost and the points of some vehicles.

    Parameters
    ----------
    rows : ndarray of int, (R,)
        Which vehicles.
    vehicles, approach, entry, onward_s, leave, platoon, alone, slack : ndarray
        Of all vehicles, see `StarNumbers`.
    pos, tau, clocks, clock_of, along, stay : ndarray
        The master's way, likewise.
    stop_at, stop_s : ndarray of int
        Positions and lengths of the stops that are decided [s].
    open_from : int
        The point from which on there may be others; as many as there are points if there are none.
    rests_open : bool
        Whether one of them may be a daily rest.
    ahead, later : ndarray of int, (n,)
        By how much the platoon is later for them at each point, at least and at most [s].
    leaves, arrives : int
        The master's departure, as it counts for merging and for separating [s].
    sure : bool
        Whether the value is wanted that is certain; else the least.
    refuted_first : ndarray of int, (R + 1,)
        Where each row's begin in `refuted`.
    refuted : ndarray of int
        Pairs of points that are out, as i * n + j.
    cost, merge, separate : ndarray, (R,)
        To be filled; -1 for who stays alone.
    """
    n = len(pos)
    dep, arr = np.empty(n, np.int64), np.empty(n, np.int64)
    stops = len(stop_at)
    stop_dep, stop_arr = np.empty(stops, np.int64), np.empty(stops, np.int64)
    _timetable(
        pos, tau, stop_at, stop_s, leaves, arrives, ahead, later, dep, arr, stop_dep, stop_arr
    )
    least = np.empty(n + 1)
    states = np.empty((2, 4), np.int64)
    for row in range(len(rows)):
        m = rows[row]
        v, clock, own = vehicles[m], clocks[clock_of[m]], platoon[m]
        best, best_i, best_j, longest = alone[m], -1, -1, 0.0
        cost[row], merge[row], separate[row] = best, -1, -1
        if sure and v[PLAIN] == 0:
            continue
        day = v[SURE_DAY] if sure else v[DAY]
        rest = v[SURE_REST] if sure else v[REST]
        window = v[SURE_WINDOW] if sure else v[WINDOW]
        last = v[ARRIVAL]
        least[n] = np.inf
        for j in range(n - 1, -1, -1):
            least[j] = least[j + 1]
            if arr[j] + onward_s[m, j] <= last and own[j] + leave[m, j] < least[j]:
                least[j] = own[j] + leave[m, j]
        for i in range(n - 1):
            base = entry[m, i] - own[i]
            if not base + least[i + 1] <= best + slack[m] or base + least[i + 1] == np.inf:
                continue
            if approach[m, i] == 0 and dep[i] - later[i] + ahead[i] + arrives - leaves > v[LATEST]:
                continue  # it leaves its origin with the platoon
            count = entry_states(v, approach[m, i], dep[i], stay[pos[i]], sure, states)
            for state in range(count):
                free, parted, today, duty = (
                    states[state, 0], states[state, 1], states[state, 2], states[state, 3]
                )  # fmt: skip
                q = 0
                while q < stops and stop_at[q] <= pos[i]:
                    q += 1
                at = clock[pos[i]]
                for j in range(i + 1, n):
                    if not base + least[j] <= best + slack[m]:
                        break
                    legal = True
                    while True:
                        stands = q < stops and stop_at[q] < pos[j]
                        step = clock[stop_at[q] if stands else pos[j]] - at
                        at += step
                        free += step
                        parted += step
                        today += step
                        if j >= open_from and not stands:
                            free, parted = 0, 0
                            if rests_open:
                                today, duty = 0, max(duty, dep[j])
                        if free > v[SPELL]:
                            free = FAR
                        if parted > v[SPELL]:
                            parted = FAR
                        when = stop_arr[q] if stands else arr[j]
                        if (free >= FAR and parted >= FAR) or today > day or when - duty > window:
                            legal = False
                            break
                        if not stands:
                            break
                        if stop_s[q] >= rest:
                            free, parted, today, duty = 0, FAR if sure else 0, 0, stop_dep[q]
                        else:
                            free, parted = paused(v, free, parted, stop_s[q])
                        q += 1
                    if not legal:
                        break
                    total = base + own[j] + leave[m, j]
                    if not total <= best + slack[m]:
                        continue
                    together = along[j] - along[i]
                    better = (
                        total < best - slack[m]
                        or (best_i >= 0 and together > longest)
                        or (best_i < 0 and together > 0.0 and best < np.inf)
                    )
                    if not better:
                        continue
                    known = True
                    for code in range(refuted_first[row], refuted_first[row + 1]):
                        if refuted[code] == i * n + j:
                            known = False
                    if not known:
                        continue
                    drive = onward_s[m, j]
                    for after in range(2):
                        wait = 0
                        a, b, t, s = free, parted, today, duty
                        if after == 1:
                            if not (q < stops and stop_at[q] == pos[j]):
                                break
                            wait = stop_s[q]
                            if wait >= rest:
                                a, b, t, s = 0, FAR if sure else 0, 0, dep[j]
                            else:
                                a, b = paused(v, a, b, wait)
                        if sure:
                            ends = arr[j] + wait + drive
                            if min(a, b) + drive > v[SPELL] or t + drive > day or ends - s > window:
                                ends = FAR
                        else:
                            ends = _onward(v, a, b, t, s, arr[j] + wait, drive)
                        if ends <= last:
                            best, best_i, best_j, longest = min(best, total), i, j, together
                            break
        cost[row], merge[row], separate[row] = best, best_i, best_j


HELPERS = (needed, breaks_s, paused, _onward, entry_states, _timetable)
"""What the kernel calls: to be made known to the compiler before it."""
