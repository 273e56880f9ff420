"""What a vehicle pays at least in each cell of a span, or for certain in all of it.

Its pairs are tried in their order. In a cell it is charged the first that can be driven at some
departure of the cell. What an earlier look at a longer span, or at fewer stops, has ruled out in
the cell is passed over.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .clocks import ARRIVAL, FAR, PLAIN, REST
from .open_stops import AHEAD, LATER, LEAST, MOST, NEXT, RESTED, STOPPED
from .own_ways import DRIVEN, FREE, PARTED, READY, STANDS
from .pair_times import HELPERS as TIMES
from .pair_times import departures, most_driven

__all__ = ["DEAD", "HELPERS", "charge", "holds"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]

DEAD = 2**30
"""As a place in the list of pairs: this cell costs too much."""


def _first_of_use(entries: Seconds, entry: int, entry_end: int, leaves: int, width: int) -> int:
    """Return before which cell a merging point is of no use, whatever the separation point is."""
    opens = FAR
    for e in range(entry, entry_end):
        opens = min(opens, entries[e, READY])
    return int(max((opens - leaves) // width, 0))


def _last_of_use(exits: Seconds, go: int, gone: int, latest: int, width: int, cells: int) -> int:
    """Return behind which cell a separation point is of no use, whatever the merging point is."""
    stands = FAR
    for e in range(go, gone):
        stands = min(stands, exits[e, STANDS])
    return int(max(min((latest - stands) // width, cells - 1), -1))


def charge(
    m: int, v: Seconds, approach: Seconds, onward: Seconds, entry_at: Seconds, entries: Seconds,
    exit_at: Seconds, exits: Seconds, base: int, count: int, pair_i: Seconds, pair_j: Seconds,
    pair_cost: Floats, alone: float, pos: Seconds, tau: Seconds, clocks: Seconds, own: int,
    stop_at: Seconds, stop_s: Seconds, c: int, stops: int, still: Seconds, short_s: int,
    arrive: Seconds, leave: Seconds, begin: int, end: int, cells: int, width: int, sure: bool,
    most: float, total: Floats, from_cell: Seconds, till_cell: Seconds, start: Seconds,
    paid: Floats, pays: Floats, rank: Seconds,
) -> int:  # fmt: skip
    """Fill what a vehicle pays in each cell, and the places of its pairs; return the first of them.

    In each cell its pair is sought from `start` on, and `paid` for that is in the total already.
    Cells that are, or would be, of no interest cost inf.

    Parameters
    ----------
    m, v : int, ndarray of int
        The vehicle, and what is known of it.
    approach, onward, entry_at, entries, exit_at, exits : ndarray of int
        As of `evaluate`.
    base, count : int
        Where its pairs begin, and how many they are.
    pair_i, pair_j, pair_cost : ndarray
        As of `evaluate`.
    alone : float
        What it pays alone.
    pos, tau, clocks : ndarray of int
        As of `evaluate`.
    own : int
        Which of the clocks is its own.
    stop_at, stop_s : ndarray of int, (C, S)
        As of `evaluate`.
    c, stops : int
        The timetable, and how many stops of it are decided.
    still : ndarray of int, (n, COLUMNS)
        What other stops may be, see `open_stops`.
    short_s : int
        The longest of these that is no rest of the master [s].
    arrive, leave : ndarray of int, (n,)
        How long after its departure the master reaches and leaves points, see `offsets` [s].
    begin, end, cells, width : int
        The span, and how many cells it has of which length [s].
    sure : bool
        Whether entries, exits and limits are the strict ones.
    most : float
        Cells are of no interest in which all together pay as much.
    total : ndarray of float, (CELLS,)
        What all pay together at least.
    from_cell, till_cell : ndarray of int, (n,)
        Room to note from which cell to which points are of use.
    start : ndarray of int, (CELLS,)
        From where on a pair is sought; `DEAD` where none need be.
    paid : ndarray of float, (CELLS,)
        What the vehicle pays there.
    pays : ndarray of float, (CELLS,)
        To be filled: what it pays at least.
    rank : ndarray of int, (CELLS,)
        To be filled: the place of its pair.

    Returns
    -------
    int
        The first of these places.
    """
    wanted, active, least, coming = 0, 0, np.inf, DEAD
    k = DEAD
    for g in range(cells):
        pays[g], rank[g] = np.inf, DEAD
        if total[g] < most and start[g] < DEAD:
            wanted |= 1 << g
            least = min(least, total[g] - paid[g])
            k = min(k, start[g])
    if wanted == 0:
        return count
    coming = k
    from_cell[:] = -1
    till_cell[:] = -2
    while wanted != 0 and k < count:
        if k >= coming:
            # These cells have come to pairs of which nothing is known.
            active, coming = 0, DEAD
            for g in range(cells):
                if (wanted >> g) & 1:
                    if start[g] <= k:
                        active |= 1 << g
                    else:
                        coming = min(coming, start[g])
        if active == 0:
            k = coming
            continue
        price = pair_cost[base + k]
        if not least + price < most:
            break
        i, j = pair_i[base + k], pair_j[base + k]
        k += 1
        if from_cell[i] < 0:
            from_cell[i] = _first_of_use(
                entries,
                entry_at[m, i, 0],
                entry_at[m, i, 1],
                leave[i] + still[i, LATER] + begin,
                width,
            )
        if till_cell[j] < -1:
            till_cell[j] = _last_of_use(
                exits, exit_at[m, j, 0], exit_at[m, j, 1],
                v[ARRIVAL] - onward[m, j] - arrive[j] - still[j, AHEAD] - begin, width, cells,
            )  # fmt: skip
        if from_cell[i] > till_cell[j]:
            continue
        # The cells for which both points are of use.
        of_use = active & ((2 << till_cell[j]) - 1)
        if of_use >> from_cell[i] == 0:
            continue
        low, high = pos[i], pos[j]
        q = 0
        while q < stops and stop_at[c, q] <= low:
            q += 1
        # Where open stops may lie between the two.
        stopped, rested, once = -1, -1, False
        if still[j, STOPPED] > low and still[j, MOST] > still[i, LEAST]:
            stopped, once = still[j, STOPPED], still[j, MOST] == still[i, LEAST] + 1
            rested = still[j, RESTED] if still[j, RESTED] > low else -1
            if short_s >= v[REST]:
                # What is none for the master may be a rest for it.
                rested = stopped
        news = False
        most_free, most_parted, most_today = most_driven(
            v, exits, exit_at[m, j, 0], exit_at[m, j, 1], clocks, own, low, high, stop_at, c,
            stops, q, stopped, rested, still[i, NEXT], sure,
        )  # fmt: skip
        top = till_cell[j]
        while (of_use >> top) & 1 == 0:
            top -= 1
        before = min((top + 1) * width, end + 1 - begin)
        for e in range(entry_at[m, i, 1] - 1, entry_at[m, i, 0] - 1, -1):
            opens = entries[e, READY] - leave[i] - still[i, LATER] - begin
            if (
                opens >= before
                or (entries[e, FREE] > most_free and entries[e, PARTED] > most_parted)
                or entries[e, DRIVEN] > most_today
            ):
                continue
            opens, closes = departures(
                v, entries, e, exits, exit_at[m, j, 0], exit_at[m, j, 1], approach[m, i],
                onward[m, j], low, high, tau, clocks, own, stop_at, stop_s, c,
                stops, q, stopped, rested, still[i, NEXT], once, leave[i] + still[i, AHEAD],
                leave[i] + still[i, LATER], arrive[j] + still[j, AHEAD], sure, begin,
            )  # fmt: skip
            if closes < opens or closes < begin or opens > end:
                continue
            last = min((closes - begin) // width, cells - 1)
            for g in range((opens - begin) // width, last + 1):
                if (of_use >> g) & 1:
                    pays[g], rank[g] = price, k - 1
                    of_use ^= 1 << g
                    active ^= 1 << g
                    wanted ^= 1 << g
                    news = True
            if of_use == 0:
                break
        if news:
            least = np.inf
            for g in range(cells):
                if (wanted >> g) & 1:
                    least = min(least, total[g] - paid[g])
    if wanted != 0 and k >= count:
        for g in range(cells):
            if (wanted >> g) & 1:
                pays[g], rank[g] = alone, count
    first = count
    for g in range(cells):
        first = min(first, rank[g])
    return int(first)


def holds(
    m: int, k: int, v: Seconds, approach: Seconds, onward: Seconds, entry_at: Seconds,
    entries: Seconds, exit_at: Seconds, exits: Seconds, base: int, count: int, pair_i: Seconds,
    pair_j: Seconds, pos: Seconds, tau: Seconds, clocks: Seconds, own: int, stop_at: Seconds,
    stop_s: Seconds, c: int, stops: int, arrive: Seconds, leave: Seconds, begin: int, end: int,
    sure: bool,
) -> bool:  # fmt: skip
    """Tell whether a vehicle can drive one pair at all departures of a span; all is decided.

    Parameters
    ----------
    m, k : int
        The vehicle, and the place of the pair in its list.
    v, approach, onward, entry_at, entries, exit_at, exits : ndarray of int
        As of `charge`.
    base, count : int
        Likewise.
    pair_i, pair_j, pos, tau, clocks : ndarray of int
        Likewise.
    own : int
        Likewise.
    stop_at, stop_s : ndarray of int
        Likewise.
    c, stops : int
        Likewise.
    arrive, leave : ndarray of int
        Likewise.
    begin, end : int
        Likewise.
    sure : bool
        Likewise.

    Returns
    -------
    bool
        True for who stays alone.
    """
    if k >= count:
        return True
    if sure and v[PLAIN] == 0:
        return False
    i, j = pair_i[base + k], pair_j[base + k]
    low, high = pos[i], pos[j]
    q = 0
    while q < stops and stop_at[c, q] <= low:
        q += 1
    for e in range(entry_at[m, i, 1] - 1, entry_at[m, i, 0] - 1, -1):
        if entries[e, READY] - leave[i] > begin:
            continue
        opens, closes = departures(
            v, entries, e, exits, exit_at[m, j, 0], exit_at[m, j, 1], approach[m, i],
            onward[m, j], low, high, tau, clocks, own, stop_at, stop_s, c, stops, q, -1, -1, -1,
            False, leave[i], leave[i], arrive[j], sure, begin,
        )  # fmt: skip
        if opens <= begin and closes >= end:
            return True
    return False


HELPERS = (*TIMES, _first_of_use, _last_of_use, charge, holds)
"""What kernels call, callees first: to be made known to the compiler before them."""
