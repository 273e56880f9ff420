"""Which stops of the master may follow those that are decided, with its clocks after them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .clocks import DAY, FAR, REST, SPELL, breaks_s, needed, paused

__all__ = ["HELPERS", "next_stops"]

Seconds = NDArray[np.int64]

HELPERS = (needed, breaks_s, paused)
"""What the kernel calls, callees first: to be made known to the compiler before it."""


def next_stops(
    v: Seconds, places: Seconds, tau: Seconds, stay: Seconds, lengths: Seconds, at: int,
    clocks: Seconds, stops: int, rests: int, budget: int, night: int,
    night_s: int, turn: int, found: Seconds,
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
    night, night_s, turn : int
        The position of the next daily rest, how long that lasts [s], and how many stops come before
        it; negative if that is not decided yet, and no position if there is none.
    found : ndarray of int, (X, 5)
        To be filled: position, length, clocks.

    Returns
    -------
    int
        Rows filled.
    """
    count, end = 0, len(tau) - 1
    known = 0 <= night <= end
    if night > end:
        rests = 0
    for index in range(np.searchsorted(places, at, side="right"), len(places)):
        place = places[index]
        if known and place > night:
            break
        if known and (place < night) != (turn > 0):
            continue
        step = tau[place] - tau[at]
        free, parted, today = clocks[0] + step, clocks[1] + step, clocks[2] + step
        if min(free, parted) > v[SPELL] or today > v[DAY]:
            break
        if free > v[SPELL]:
            free = FAR
        if parted > v[SPELL]:
            parted = FAR
        left = tau[end] - tau[place]
        for length in lengths:
            rest = length >= v[REST]
            if length > stay[place] or length > budget or (rest and rests <= 0):
                continue
            if known and (length != night_s if place == night else rest):
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
            if known and place < night:
                # Stops before the night and behind it are counted apart.
                within, behind = tau[night] - tau[place], tau[end] - tau[night]
                resets = needed(v[DAY], 0, behind)
                breaks = needed(v[SPELL], min(a, b), within)
                after = max(needed(v[SPELL], 0, behind), resets)
                if breaks > turn - 1 or after > stops - turn - 1 or c + within > v[DAY]:
                    continue
                stood = breaks_s(v, breaks, 1 if b < FAR else 0) + night_s
                stood += resets * v[REST] if resets > 0 else 0
                stood += breaks_s(v, after - resets, 0)
                if stood > budget - length:
                    continue
            found[count, 0], found[count, 1] = place, length
            found[count, 2], found[count, 3], found[count, 4] = a, b, c
            count += 1
    return count
