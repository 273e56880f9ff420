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
