"""What open stops of the master may do to its timetable."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .clocks import ARRIVAL, BREAK, DAY, FAR, REST, SECOND, SPELL, needed

__all__ = ["offsets", "openings"]

Seconds = NDArray[np.int64]


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


def openings(
    pos: Seconds, tau: Seconds, places: Seconds, plan: Seconds, v: Seconds, at: int, made: int,
    rested: int, stood: int, clocks: Seconds, departure: int, ahead: Seconds, later: Seconds,
) -> int:  # fmt: skip
    """Fill what stops not decided yet may do to the timetable; return where they may begin.

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
    departure : int
        When the master leaves at the earliest [s].
    ahead, later : ndarray of int, (n,)
        To be filled: by how much the platoon is later at each point, at least and at most [s].

    Returns
    -------
    int
        The first point behind such a stop; negative, less one, if one may be a daily rest.
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
