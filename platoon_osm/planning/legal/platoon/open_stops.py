"""Where stops of the master that are not decided yet may lie, and how many before each point.

A place is of use for such a stop if the master can come there with the stops that it may still
make, and can drive on from there, its clocks begun anew, with those that are then left. So before
a point there are no more stops than the way behind the last place of use can spare, and no fewer
than it takes to come to the next. With one stop left and one needed it is open between two places
alone; before the first and behind the second the timetable is known. Where the next daily rest is
decided, the stops before and behind it are counted apart.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .clocks import ARRIVAL, BREAK, DAY, FAR, REST, SECOND, SPELL, needed

__all__ = [
    "AHEAD", "COLUMNS", "HELPERS", "LATER", "LEAST", "MOST", "NEXT", "RESTED", "STOPPED",
    "offsets", "open_stops",
]  # fmt: skip

Seconds = NDArray[np.int64]

# By how much the platoon is later at a point, at least and at most; how many stops lie before it at
# least and at most; the last position at which it may have stopped, and rested, and the first from
# the point on at which it may stop; -1 if nowhere.
AHEAD, LATER, LEAST, MOST, STOPPED, RESTED, NEXT = range(7)
COLUMNS = 7


def offsets(
    pos: Seconds, tau: Seconds, stop_at: Seconds, stop_s: Seconds, arrive: Seconds, leave: Seconds
) -> None:
    """Fill how long after the master's departure it reaches points and leaves them.

    Parameters
    ----------
    pos, tau : ndarray of int
        The points' positions, and driving time to each position [s].
    stop_at, stop_s : ndarray of int, (S,)
        Positions and lengths of the stops that are decided [s].
    arrive, leave : ndarray of int, (n,)
        To be filled; other stops are not counted [s].
    """
    stood, q = 0, 0
    for k in range(len(pos)):
        while q < len(stop_at) and stop_at[q] < pos[k]:
            stood += stop_s[q]
            q += 1
        here = stop_s[q] if q < len(stop_at) and stop_at[q] == pos[k] else 0
        arrive[k] = tau[pos[k]] + stood
        leave[k] = arrive[k] + here


def _pauses_s(v: Seconds, breaks: int, rests: int) -> int:
    """Return how long breaks and daily rests last of which the rests are some of the breaks."""
    stands = rests * v[REST] if rests > 0 else 0
    if breaks > rests:
        stands += (breaks - rests) * v[BREAK]
    return int(stands)


def _stops_to(
    place: int, at: int, tau: Seconds, v: Seconds, driven: int, today: int, known: bool,
    night: int, until: int,
) -> int:  # fmt: skip
    """Return how many stops it takes at least to come to a position."""
    if known and place == night:
        return until - 1
    if known and place > night:
        step = tau[place] - tau[night]
        return int(until + max(needed(v[SPELL], 0, step), needed(v[DAY], 0, step)))
    step = tau[place] - tau[at]
    breaks = needed(v[SPELL], driven, step)
    return int(breaks if known else max(breaks, needed(v[DAY], today, step)))


def _stops_from(place: int, tau: Seconds, v: Seconds, known: bool, night: int, behind: int) -> int:
    """Return how many it takes at least from one that is made up to the night or the end."""
    if known and place < night:
        return int(needed(v[SPELL], 0, tau[night] - tau[place]))
    if known and place == night:
        return int(behind)
    step = tau[len(tau) - 1] - tau[place]
    return int(max(needed(v[SPELL], 0, step), needed(v[DAY], 0, step)))


def _of_use(
    index: int, places: Seconds, at: int, tau: Seconds, v: Seconds, driven: int, today: int,
    known: bool, night: int, until: int, behind: int, left: int,
) -> int:  # fmt: skip
    """Return which place of use is the first from one on; their number if there is none."""
    for found in range(index, len(places)):
        place = places[found]
        spare = until - 1 if known and place < night else left
        spare -= _stops_from(place, tau, v, known, night, behind)
        if _stops_to(place, at, tau, v, driven, today, known, night, until) < spare:
            return found
    return len(places)


def open_stops(
    pos: Seconds, tau: Seconds, places: Seconds, plan: Seconds, v: Seconds, at: int, made: int,
    rested: int, stood: int, clocks: Seconds, night: int, night_s: int, turn: int,
    departure: int, found: Seconds,
) -> None:  # fmt: skip
    """Fill what open stops may be before each point.

    Parameters
    ----------
    pos, tau : ndarray of int
        The points' positions, and driving time to each position [s].
    places : ndarray of int
        The positions at which the master may stop.
    plan : ndarray of int, (4,)
        Stops and daily rests at most, and the longest stop without and with a rest [s].
    v : ndarray of int, (NUMBERS,)
        What is known of the master.
    at, made, rested, stood : int
        The position of the last stop that is decided, how many these are, how many of them are
        rests, and how long all last [s].
    clocks : ndarray of int, (3,)
        The master's after it.
    night, night_s, turn : int
        The position of its next daily rest, how long that lasts [s], and how many stops come before
        it in all; negative if that is not decided yet, and no position if there is none.
    departure : int
        When the master leaves at the earliest [s].
    found : ndarray of int, (n, COLUMNS)
        To be filled.
    """
    n, end = len(pos), tau[len(tau) - 1]
    found[:] = 0
    found[:, STOPPED:] = -1
    budget = FAR
    if v[ARRIVAL] < FAR // 2:
        budget = v[ARRIVAL] - departure - end - stood
    left, rests = plan[0] - made, max(0, plan[1] - rested)
    if budget < v[REST] or night >= len(tau):
        rests = 0
    if left <= 0 or budget <= 0:
        return
    known = 0 <= night < len(tau)
    half = v[BREAK] - min(v[BREAK], v[SECOND])
    parted = half if clocks[1] < FAR else 0
    driven, today = min(clocks[0], clocks[1]), clocks[2]
    # Stops and pauses up to the night with it, and behind it.
    until, until_s, behind, behind_s = 0, 0, 0, 0
    if known:
        until = turn - made + 1
        breaks = needed(v[SPELL], driven, tau[night] - tau[at])
        until_s = _pauses_s(v, breaks, 0) - (parted if breaks > 0 else 0) + night_s
        breaks = needed(v[SPELL], 0, end - tau[night])
        more = needed(v[DAY], 0, end - tau[night])
        behind = max(breaks, more)
        behind_s = night_s + _pauses_s(v, breaks, more)
    first = int(np.searchsorted(places, at, side="right"))
    k = int(np.searchsorted(pos, at, side="right"))
    index, used, most, latest, stopped, slept = first, 0, 0, 0, -1, -1
    use = _of_use(
        first, places, at, tau, v, driven, today, known, night, until, behind, left
    )  # fmt: skip
    for early in range(k):
        found[early, NEXT] = places[use] if use < len(places) else len(tau) - 1
    while k < n:
        # What the places up to this point are good for.
        while index < len(places) and places[index] <= pos[k]:
            place = places[index]
            index += 1
            if index - 1 < use:
                continue
            use = _of_use(
                index, places, at, tau, v, driven, today, known, night, until, behind, left
            )  # fmt: skip
            spare = until - 1 if known and place < night else left
            spare -= _stops_from(place, tau, v, known, night, behind)
            used = 0 if known and place == night else used + 1
            stopped = place
            most = max(most, min(spare, used + (until if known and place >= night else 0)))
            rest_of_it = end - tau[place]
            resets = needed(v[DAY], 0, rest_of_it)
            if known and place < night:
                taken = 0
                breaks = needed(v[SPELL], 0, tau[night] - tau[place])
                stands = behind_s + _pauses_s(v, breaks, 0) - (half if breaks > 0 else 0)
            else:
                breaks = needed(v[SPELL], 0, rest_of_it)
                stands = _pauses_s(v, breaks, resets) - (half if breaks > resets else 0)
                taken = max(0, rests - resets)
                slept = place if taken > 0 and not known else slept
                if known:
                    reached = needed(v[DAY], 0, tau[place] - tau[night])
                    slept = place if place == night or reached + 2 + resets <= rests else slept
            taken = min(taken, most)
            lasts = taken * plan[3] + (most - taken) * plan[2]
            lasts -= plan[3] - night_s if known and taken > 0 else 0
            latest = max(latest, min(lasts, budget - stands))
        # What it takes to come to the next place of use at the point or behind it, or to the end.
        target = places[use] if use < len(places) else len(tau) - 1
        if stopped == pos[k]:
            target = stopped
        least = _stops_to(target, at, tau, v, driven, today, known, night, until)
        if known and target > night:
            step = tau[target] - tau[night]
            stands = until_s + _pauses_s(v, needed(v[SPELL], 0, step), needed(v[DAY], 0, step))
        else:
            step = tau[target] - tau[at]
            breaks = needed(v[SPELL], driven, step)
            resets = 0 if known else needed(v[DAY], today, step)
            stands = _pauses_s(v, breaks, resets) - (parted if breaks > resets else 0)
        # The same holds up to the next place.
        place = places[index] if index < len(places) else len(tau)
        while k < n and pos[k] < place:
            found[k, AHEAD], found[k, LATER] = min(stands, latest), latest
            found[k, LEAST], found[k, MOST] = least, most
            found[k, STOPPED], found[k, RESTED] = stopped, slept
            found[k, NEXT] = target
            here = pos[k]
            k += 1
            if k < n and index > first and places[index - 1] == here:
                break


HELPERS = (needed, _pauses_s, _stops_to, _stops_from, _of_use, open_stops, offsets)
"""What the kernel calls, callees first: to be made known to the compiler before it."""
