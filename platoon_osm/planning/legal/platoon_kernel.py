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

__all__ = [
    "FAR",
    "HELPERS",
    "NUMBERS",
    "entry_states",
    "evaluate",
    "needed",
    "next_stops",
    "paused",
]

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
    A first part lies within the driving that its second ends, not before it.

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
    if pause >= v[FIRST] and free > 0:
        after = min(parted, free)
    if pause >= v[BREAK] or (parted < FAR and pause >= v[SECOND]):
        return 0, after
    return free, after


def onward_at(
    v: Seconds, free: int, parted: int, today: int, duty: int, at: int, drive_s: int
) -> int:
    """Return when a vehicle arrives at the earliest that drives on, with pauses anywhere.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the vehicle.
    free, parted, today : int
        What it has driven since its last break, likewise with the first part, and today [s].
    duty, at : int
        When its duty began, and when it drives on [s].
    drive_s : int
        For how long [s].

    Returns
    -------
    int
        A moment [s]; `FAR` if never.
    """
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
        states[0, 0], states[0, 1] = 0, 0 if drive_s > 0 else FAR
        states[0, 2], states[0, 3] = 0, leaves
        return 1
    least = breaks_s(v, breaks, v[PART])
    if least > spare or v[TODAY] + drive_s > v[DAY]:
        return 0
    driven = v[BROKEN] + drive_s - breaks * v[SPELL] if breaks > 0 else v[BROKEN] + drive_s
    fresh = breaks_s(v, breaks + 1, v[PART])
    states[0, 0] = 0 if spare >= fresh else driven
    states[0, 1] = FAR
    if spare >= fresh + v[FIRST] and drive_s > 0:
        states[0, 1] = 0
    elif (spare >= least + v[FIRST] and driven > 0) or (breaks == 0 and v[PART] == 1):
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


def _openings(
    pos: Seconds, tau: Seconds, places: Seconds, plan: Seconds, v: Seconds, at: int, made: int,
    rested: int, stood: int, clocks: Seconds, departure: int, ahead: Seconds, later: Seconds,
) -> int:  # fmt: skip
    """Fill what stops not decided yet may do to the timetable; return where they may begin.

    At each point the platoon is later by `ahead` at least and by `later` at most. The point that
    is returned is negative, less one, if one of the stops may be a daily rest.
    """
    n = len(pos)
    ahead[:] = 0
    later[:] = 0
    first = np.searchsorted(places, at, side="right")
    budget = FAR
    if v[ARRIVAL] < FAR // 2:
        budget = v[ARRIVAL] - departure - tau[len(tau) - 1] - stood
    left = plan[0] - made
    if left <= 0 or first >= len(places) or budget <= 0:
        return n
    rests = max(0, plan[1] - rested)
    if budget < v[REST]:
        rests = 0
    open_from = np.searchsorted(pos, places[first])
    half = v[BREAK] - min(v[BREAK], v[SECOND]) if clocks[1] < FAR else 0
    driven = min(clocks[0], clocks[1])
    passed = first
    for k in range(open_from, n):
        while passed < len(places) and places[passed] <= pos[k]:
            passed += 1
        count = min(left, passed - first)
        resting = min(rests, count)
        most = resting * plan[3] + (count - resting) * plan[2]
        later[k] = min(most, budget)
        drive = tau[pos[k]] - tau[at]
        resets = needed(v[DAY], clocks[2], drive)
        more = needed(v[SPELL], driven, drive) - resets
        least = resets * v[REST] if resets > 0 else 0
        if more > 0:
            least += more * v[BREAK] - half
        ahead[k] = min(least, later[k])
    return int(-1 - open_from if rests > 0 else open_from)


def _cheapest(
    v: Seconds, approach: Seconds, ready: Seconds, entry: Floats, onward_s: Seconds,
    must: Seconds, leave: Floats, own: Floats, alone: float, slack: float, pos: Seconds,
    clock: Seconds, along: Floats,
    stay: Seconds, stop_at: Seconds, stop_s: Seconds, stops: int, open_from: int, rests_open: bool,
    gone: Seconds, met: Seconds, dep: Seconds, arr: Seconds, stop_dep: Seconds,
    stop_arr: Seconds, sure: bool,
    refuted: Seconds, begin: int, end: int, least: Floats, promise: Floats, states: Seconds,
) -> tuple[float, int, int]:  # fmt: skip
    """Return what one vehicle pays, and its points."""
    n = len(pos)
    best, best_i, best_j, longest = alone, -1, -1, 0.0
    if sure and v[PLAIN] == 0:
        return best, best_i, best_j
    day = v[SURE_DAY] if sure else v[DAY]
    rest = v[SURE_REST] if sure else v[REST]
    window = v[SURE_WINDOW] if sure else v[WINDOW]
    last = v[ARRIVAL]
    least[n] = np.inf
    promise[n - 1] = np.inf
    for j in range(n - 1, -1, -1):
        if j < n - 1:
            # It leaves its origin with the platoon if that is the point.
            promise[j] = np.inf
            away = approach[j] if sure else 0  # without a pause, if it is to be certain
            if (
                ready[j] <= dep[j] and (approach[j] > 0 or gone[j] <= v[LATEST])
                and away <= v[SPELL]
            ):  # fmt: skip
                promise[j] = entry[j] - own[j] + least[j + 1]
        least[j] = least[j + 1]
        away = onward_s[j] if sure else 0
        if own[j] + leave[j] < least[j] and arr[j] <= must[j] and away <= v[SPELL]:
            least[j] = own[j] + leave[j]
    while True:
        i = 0
        for k in range(1, n):
            if promise[k] < promise[i]:
                i = k
        if not promise[i] <= best + slack or promise[i] == np.inf:
            return best, best_i, best_j
        promise[i] = np.inf
        base = entry[i] - own[i]
        count = entry_states(v, approach[i], dep[i], stay[pos[i]], sure, states)
        for state in range(count):
            free, parted, today, duty = (
                states[state, 0], states[state, 1], states[state, 2], states[state, 3]
            )  # fmt: skip
            q = 0
            while q < stops and stop_at[q] <= pos[i]:
                q += 1
            at = clock[pos[i]]
            for j in range(i + 1, n):
                if not base + least[j] <= best + slack:
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
                total = base + own[j] + leave[j]
                if not total <= best + slack:
                    continue
                together = along[j] - along[i]
                if best_i < 0:
                    better = total < best - slack or (together > 0.0 and best < np.inf)
                else:
                    better = total < best - slack or (
                        together > longest or (together == longest and i < best_i)
                    )
                if not better:
                    continue
                known = True
                for code in range(begin, end):
                    if (
                        refuted[code, 0] == i * n + j
                        and gone[i] >= refuted[code, 1]
                        and dep[i] <= refuted[code, 2]
                        and arr[j] >= refuted[code, 3]
                        and met[j] <= refuted[code, 4]
                    ):
                        known = False
                if not known:
                    continue
                drive = onward_s[j]
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
                        ends = onward_at(v, a, b, t, s, arr[j] + wait, drive)
                    if ends <= last:
                        best, best_i, best_j, longest = min(best, total), i, j, together
                        break


def evaluate(
    rows: Seconds, vehicles: Seconds, approach: Seconds, ready: Seconds, entry: Floats,
    onward_s: Seconds, must: Seconds, leave: Floats, platoon: Floats, alone: Floats,
    slack: Floats, pos: Seconds, tau: Seconds,
    clocks: Seconds, clock_of: Seconds, along: Floats, stay: Seconds, places: Seconds,
    plan: Seconds, stop_at: Seconds, stop_s: Seconds, stop_count: Seconds, begun: Seconds,
    leaves: Seconds, arrives: Seconds, sure: bool, refuted_first: Seconds, refuted: Seconds,
    floor: Floats, most: float, cost: Floats, merge: Seconds, separate: Seconds,
) -> None:  # fmt: skip
    """Fill the cost and the points of some vehicles, for some timetables of the master.

    Parameters
    ----------
    rows : ndarray of int, (R,)
        Which vehicles.
    vehicles, approach, ready, entry, onward_s, must, leave, platoon, alone, slack : ndarray
        Of all vehicles, see `StarNumbers`.
    pos, tau, clocks, clock_of, along, stay : ndarray
        The master's way, likewise.
    places : ndarray of int
        The positions at which it may stop.
    plan : ndarray of int, (4,)
        Stops and daily rests at most, and the longest stop without and with a rest [s].
    stop_at, stop_s : ndarray of int, (C, S)
        Of each timetable positions and lengths of the stops that are decided [s].
    stop_count : ndarray of int, (C,)
        How many these are.
    begun : ndarray of int, (C, 3)
        The master's clocks after the last of them; -1 first if no other stops follow.
    leaves, arrives : ndarray of int, (C,)
        The master's departure, as it counts for merging and for separating [s].
    sure : bool
        Whether the value is wanted that is certain; else the least.
    refuted_first : ndarray of int, (R + 1,)
        Where each row's begin in `refuted`.
    refuted : ndarray of int, (X, 5)
        Pairs of points, as i * n + j, that are out if the platoon leaves i and reaches j within
        some moments.
    floor : ndarray of float, (R,)
        What each vehicle pays at least, as far as is known.
    most : float
        A timetable is of no interest if all together pay as much; its costs become inf.
    cost, merge, separate : ndarray, (C, R)
        To be filled; -1 for who stays alone.
    """
    n = len(pos)
    dep, arr = np.empty(n, np.int64), np.empty(n, np.int64)
    gone, met = np.empty(n, np.int64), np.empty(n, np.int64)
    ahead, later = np.zeros(n, np.int64), np.zeros(n, np.int64)
    room = stop_at.shape[1]
    stop_dep, stop_arr = np.empty(room, np.int64), np.empty(room, np.int64)
    least, promise = np.empty(n + 1), np.empty(n)
    states = np.empty((2, 4), np.int64)
    master = vehicles[len(vehicles) - 1]
    known = 0.0
    for row in range(len(rows)):
        known += floor[row]
    for c in range(len(stop_count)):
        stops = stop_count[c]
        open_from, rests_open = n, False
        ahead[:] = 0
        later[:] = 0
        if begun[c, 0] >= 0:
            at, rested, stood = 0, 0, 0
            for q in range(stops):
                at = stop_at[c, q]
                stood += stop_s[c, q]
                rested += 1 if stop_s[c, q] >= master[REST] else 0
            open_from = _openings(
                pos, tau, places, plan, master, at, stops, rested, stood, begun[c], arrives[c],
                ahead, later,
            )  # fmt: skip
            if open_from < 0:
                open_from, rests_open = -1 - open_from, True
        _timetable(
            pos, tau, stop_at[c, :stops], stop_s[c, :stops], leaves[c], arrives[c], ahead, later,
            dep, arr, stop_dep, stop_arr,
        )  # fmt: skip
        for k in range(n):
            gone[k] = dep[k] - later[k] + ahead[k] + arrives[c] - leaves[c]
            met[k] = arr[k] - ahead[k] + later[k] + leaves[c] - arrives[c]
        total = known
        for row in range(len(rows)):
            m = rows[row]
            cost[c, row], merge[c, row], separate[c, row] = _cheapest(
                vehicles[m], approach[m], ready[m], entry[m], onward_s[m], must[m], leave[m],
                platoon[m], alone[m],
                slack[m], pos, clocks[clock_of[m]], along, stay, stop_at[c], stop_s[c], stops,
                open_from, rests_open, gone, met, dep, arr, stop_dep, stop_arr, sure, refuted,
                refuted_first[row], refuted_first[row + 1], least, promise, states,
            )  # fmt: skip
            total += cost[c, row] - floor[row]
            if not sure and not total < most:
                cost[c, :] = np.inf
                break


def next_stops(
    v: Seconds, places: Seconds, tau: Seconds, stay: Seconds, lengths: Seconds, at: int,
    clocks: Seconds, stops: int, rests: int, budget: int, found: Seconds,
) -> int:  # fmt: skip
    """Fill the stops that may follow, with the clocks after them; return how many there are.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the master.
    places, tau, stay : ndarray of int
        Positions where it may stop; driving time to each position, longest pause there [s].
    lengths : ndarray of int
        How long stops may last [s].
    at : int
        The position of the last stop.
    clocks : ndarray of int, (3,)
        The master's after it.
    stops, rests : int
        How many more stops and daily rests there may be.
    budget : int
        How long it may still stand [s].
    found : ndarray of int, (X, 5)
        To be filled: position, length, clocks.

    Returns
    -------
    int
        Rows filled.
    """
    count = 0
    for index in range(np.searchsorted(places, at, side="right"), len(places)):
        place = places[index]
        step = tau[place] - tau[at]
        free, parted, today = clocks[0] + step, clocks[1] + step, clocks[2] + step
        if min(free, parted) > v[SPELL] or today > v[DAY]:
            break
        if free > v[SPELL]:
            free = FAR
        if parted > v[SPELL]:
            parted = FAR
        left = tau[len(tau) - 1] - tau[place]
        for length in lengths:
            rest = length >= v[REST]
            if length > stay[place] or length > budget or (rest and rests <= 0):
                continue
            a, b, c = 0, FAR, 0
            if not rest:
                a, b = paused(v, free, parted, length)
                c = today
            breaks = needed(v[SPELL], min(a, b), left)
            resets = needed(v[DAY], c, left)
            if max(breaks, resets) > stops - 1 or resets > rests - (1 if rest else 0):
                continue
            stood = resets * v[REST] if resets > 0 else 0
            stood += breaks_s(v, breaks - resets, 1 if b < FAR else 0)
            if stood > budget - length:
                continue
            found[count, 0], found[count, 1] = place, length
            found[count, 2], found[count, 3], found[count, 4] = a, b, c
            count += 1
    return count


HELPERS = (
    needed, breaks_s, paused, onward_at, entry_states, _timetable, _openings, _cheapest,
)  # fmt: skip
"""What the kernel calls, callees first: to be made known to the compiler before it."""
