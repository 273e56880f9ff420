"""Drivers' clocks in whole numbers: breaks, rests, and the pauses that a way takes at least.

A vehicle is a row of numbers: its limits, what is known of its driver, its window. Its clocks are
what it has driven since its last break, with no part of the next one taken and with the first part
of it taken (which of them is better only shows later), what it has driven since its last daily
rest, and when its duty began. Functions are plain; kernels that call them compile them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["FAR", "NUMBERS", "breaks_s", "entry_state", "needed", "onward_at", "paused"]

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
    v: Seconds, free: int, parted: int, today: int, duty: int, at: int, drive_s: int, clock_s: int
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
    drive_s, clock_s : int
        For how long, and what its clocks count of it [s].

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
        count = needed(v[SPELL], driven, clock_s)
        if today + clock_s <= v[DAY]:
            arrives = at + drive_s + breaks_s(v, count, part)
            if arrives - duty <= v[WINDOW]:
                best = min(best, arrives)
        if v[REST] < FAR:
            rests = max(1, needed(v[DAY], today, clock_s))
            stood = rests * v[REST] + breaks_s(v, count - rests, part)
            best = min(best, at + drive_s + stood)
    return int(best)


def entry_state(v: Seconds, drive_s: int, leaves: int, state: Seconds) -> bool:
    """Fill the best clocks with which a vehicle may leave a point, with pauses anywhere before.

    Parameters
    ----------
    v : ndarray of int, (NUMBERS,)
        What is known of the vehicle.
    drive_s, leaves : int
        Its driving time to the point, and when it leaves it [s].
    state : ndarray of int, (4,)
        To be filled: driven with no part of a break taken and with the first, driven today, the
        beginning of its duty.

    Returns
    -------
    bool
        Whether it can leave then.
    """
    spare = leaves - v[EARLIEST] - drive_s
    if spare < 0:
        return False
    if v[HOLDS] == 0 and drive_s == 0:
        spare = 0  # what is known of it holds whenever it leaves
    held = v[HOLDS] == 1 and v[DUTY] >= 0
    before = max(0, v[DUTY])
    breaks = needed(v[SPELL], v[BROKEN], drive_s)
    if v[REST] < FAR and spare >= v[REST] + breaks_s(v, breaks - 1, v[PART]):
        state[0], state[1] = 0, 0 if drive_s > 0 else FAR
        state[2], state[3] = 0, leaves
        return True
    least = breaks_s(v, breaks, v[PART])
    if least > spare or v[TODAY] + drive_s > v[DAY]:
        return False
    driven = v[BROKEN] + drive_s - breaks * v[SPELL] if breaks > 0 else v[BROKEN] + drive_s
    fresh = breaks_s(v, breaks + 1, v[PART])
    state[0] = 0 if spare >= fresh else driven
    state[1] = FAR
    if spare >= fresh + v[FIRST] and drive_s > 0:
        state[1] = 0
    elif (spare >= least + v[FIRST] and driven > 0) or (breaks == 0 and v[PART] == 1):
        state[1] = driven
    state[2] = v[TODAY] + drive_s
    state[3] = v[EARLIEST] if held else min(v[LATEST], leaves - drive_s - least)
    state[3] -= before
    return True
