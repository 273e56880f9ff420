"""Two stretches with the platoon that a member could drive, the cheapest first.

A member drives from point i to j with the platoon, alone along the master's way to k, and from k to
l with it. Of each j and k the cheapest i before and l behind are looked at first, and then the next
in order; a heap has the cheapest of all at its top. Those that could not be driven even with pauses
anywhere on the member's own ways are passed over. Functions are plain; `compiled.py` compiles them.
"""

from __future__ import annotations

import heapq

import numpy as np
from numpy.typing import NDArray

from .clocks import (
    ARRIVAL,
    DAY,
    FAR,
    REST,
    SPELL,
    WINDOW,
    breaks_s,
    entry_state,
    needed,
    onward_at,
    paused,
)

__all__ = ["HELPERS", "two_stretches"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]


def _pause(v: Seconds, state: Seconds, length: int, leaves: int) -> None:
    """Let clocks be those after a pause."""
    if length >= v[REST]:
        state[0], state[1], state[2], state[3] = 0, 0, 0, leaves
    else:
        state[0], state[1] = paused(v, state[0], state[1], length)


def _together(
    v: Seconds, clock: Seconds, stop_at: Seconds, stop_s: Seconds, arrive: Seconds,
    leave: Seconds, low: int, high: int, state: Seconds,
) -> bool:  # fmt: skip
    """Let clocks be those after driving with the platoon; return whether that may be."""
    at = low
    for q in range(len(stop_at) + 1):
        place = high
        if q < len(stop_at):
            place = stop_at[q]
            if place <= low:
                continue
            place = min(place, high)
        step = clock[place] - clock[at]
        at = place
        for part in range(2):
            state[part] = state[part] + step if state[part] + step <= v[SPELL] else FAR
        state[2] += step
        if min(state[0], state[1]) >= FAR or state[2] > v[DAY]:
            return False
        if arrive[place] - state[3] > v[WINDOW]:
            return False
        if place == high:
            return True
        _pause(v, state, stop_s[q], leave[place])
    return True


def _between(v: Seconds, state: Seconds, drive: int, lasts: int, leaves: int) -> bool:
    """Let clocks be at least as good as any after driving alone for some time, with pauses."""
    spare = lasts - drive
    if spare < 0:
        return False
    if spare >= v[REST]:
        state[0], state[1], state[2], state[3] = 0, 0, 0, leaves
        return True
    driven, part = min(state[0], state[1]), 1 if state[1] < FAR else 0
    breaks = needed(v[SPELL], driven, drive)
    if spare < breaks_s(v, breaks, part) or state[2] + drive > v[DAY]:
        return False
    left = 0
    if spare < breaks_s(v, breaks + 1, part):
        left = max(0, driven + drive - breaks * v[SPELL])
    state[0], state[1] = left, left
    state[2] += drive
    return True


def _could(
    v: Seconds, clock: Seconds, approach: Seconds, onward: Seconds, pos: Seconds, tau: Seconds,
    stop_at: Seconds, stop_s: Seconds, arrive: Seconds, leave: Seconds, i: int, j: int, k: int,
    m: int, state: Seconds,
) -> bool:  # fmt: skip
    """Whether a member could drive two stretches, with pauses anywhere on its own ways."""
    leaves, ends, again, parts = pos[i], pos[j], pos[k], pos[m]
    if not entry_state(v, approach[i], leave[leaves], state):
        return False
    if not _together(v, clock, stop_at, stop_s, arrive, leave, leaves, ends, state):
        return False
    drive, lasts = tau[again] - tau[ends], leave[again] - arrive[ends]
    if not _between(v, state, drive, lasts, leave[again]):
        return False
    if not _together(v, clock, stop_at, stop_s, arrive, leave, again, parts, state):
        return False
    last, drive = v[ARRIVAL], onward[m]
    if onward_at(v, state[0], state[1], state[2], state[3], arrive[parts], drive, drive) <= last:
        return True
    _pause(v, state, leave[parts] - arrive[parts], leave[parts])
    return bool(
        onward_at(v, state[0], state[1], state[2], state[3], leave[parts], drive, drive) <= last
    )


HELPERS = (
    needed, breaks_s, paused, onward_at, entry_state, _pause, _together, _between, _could,
)  # fmt: skip
"""What the kernel calls, callees first: to be made known to the compiler before it."""


def two_stretches(
    v: Seconds, clock: Seconds, approach: Seconds, onward: Seconds, pos: Seconds, tau: Seconds,
    stop_at: Seconds, stop_s: Seconds, arrive: Seconds, leave: Seconds, own: Floats,
    alone: Floats, into: Floats, out: Floats, first: Seconds, last: Seconds, most: float,
    looks: int, found: Seconds, cost: Floats,
) -> int:  # fmt: skip
    """Fill two stretches that could be driven, the cheapest first; return how many were looked at.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the member.
    clock : ndarray of int, (P + 1,)
        What its clocks count up to each position of the master's way [s].
    approach, onward : ndarray of int, (n,)
        Its driving times to each point, and from it [s].
    pos : ndarray of int, (n,)
        The positions of the points.
    tau : ndarray of int, (P + 1,)
        Driving time to each position [s].
    stop_at, stop_s : ndarray of int, (S,)
        Positions and lengths of the master's stops [s].
    arrive, leave : ndarray of int, (P + 1,)
        When it reaches each position and leaves it [s].
    own, alone : ndarray of float, (n,)
        What the member pays up to each point in the platoon, and alone; alone inf where it cannot
        drive alone.
    into, out : ndarray of float, (n,)
        What it pays to merge at each point less `own`, and to separate there more than it; inf
        where it cannot.
    first, last : ndarray of int, (n,)
        The points by these, the least first.
    most : float
        Two stretches that cost as much are of no interest.
    looks : int
        How many are looked at, at most.
    found : ndarray of int, (X, 4)
        To be filled: i, j, k and l; i is -1 where there are no more.
    cost : ndarray of float, (X,)
        To be filled: what they cost.

    Returns
    -------
    int
        Looked at.
    """
    n = len(pos)
    found[:, 0] = -1
    state = np.empty(4, np.int64)
    # In `last` where the points behind each begin.
    starts = np.zeros(n, np.int64)
    for k in range(n):
        while starts[k] < n and last[starts[k]] <= k:
            starts[k] += 1
    heap = [(np.inf, 0, 0, 0, 0)]
    heap.pop()
    for j in range(1, n - 1):
        if not np.isfinite(alone[j]):
            continue
        a = 0
        while first[a] >= j:
            a += 1
        for k in range(j + 1, n - 1):
            if not np.isfinite(alone[k]):
                continue
            stands = False
            for place in stop_at:
                stands |= pos[j] <= place <= pos[k]
            if stands:
                between = own[j] - alone[j] + alone[k] - own[k]
                total = into[first[a]] + between + out[last[starts[k]]]
                if total < most:
                    heapq.heappush(heap, (total, j, k, a, starts[k]))
    looked, count = 0, 0
    while len(heap) > 0 and looked < looks and count < len(found):
        total, j, k, a, b = heapq.heappop(heap)
        i, m = first[a], last[b]
        if _could(
            v, clock, approach, onward, pos, tau, stop_at, stop_s, arrive, leave, i, j, k, m, state
        ):
            found[count, 0], found[count, 1], found[count, 2], found[count, 3] = i, j, k, m
            cost[count] = total
            count += 1
        looked += 1
        between = own[j] - alone[j] + alone[k] - own[k]
        c = b + 1
        while c < n and last[c] <= k:
            c += 1
        if c < n:
            total = into[i] + between + out[last[c]]
            if total < most:
                heapq.heappush(heap, (total, j, k, a, c))
        if b == starts[k]:
            c = a + 1
            while c < n and first[c] >= j:
                c += 1
            if c < n:
                total = into[first[c]] + between + out[m]
                if total < most:
                    heapq.heappush(heap, (total, j, k, c, b))
    return looked
