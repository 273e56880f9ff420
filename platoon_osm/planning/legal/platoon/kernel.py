"""What each member of a platoon pays at least, or for certain, while the master leaves in a span.

A member merges at point i and separates at point j of the master's way; its pairs are listed, the
cheapest first (`pairs.py`), and at each departure of the master it pays the cost of the
first that it can drive. With one of its entries to i and one of its exits from j
(`own_ways.py`) a pair can be driven while the master leaves between two moments: it leaves
i no earlier than it can be there, and what comes after, its duty and its arrival, only gets later.
So a span of departures is cut into cells, and in each cell each member is charged the first of its
pairs that can be driven at some departure of it: no plan costs less than the sum. Cells that cost
too much are dropped from both ends of the span. With the strict entries, exits and limits, a pair
that can be driven at all departures of a span is certain.

Stops of the master that are not decided yet leave clocks anything from their value down to nothing,
and the platoon leaves late and arrives early by as much as they may last; but the whole rest of the
member's trip, with pauses anywhere, must be in time, too. Functions are plain;
`compiled.py` compiles them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .clocks import ARRIVAL, FAR, PLAIN, REST
from .openings import offsets, openings
from .own_ways import READY, STANDS
from .pair_times import HELPERS as TIMES
from .pair_times import departures

__all__ = ["CELLS", "HELPERS", "evaluate"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]

CELLS = 32
"""Into how many cells a span is cut at most, below 63."""


def _charge(
    m: int, k: int, v: Seconds, approach: Seconds, onward: Seconds, entry_at: Seconds,
    entries: Seconds, exit_at: Seconds, exits: Seconds, base: int, count: int, pair_i: Seconds,
    pair_j: Seconds, pair_cost: Floats, alone: float, pos: Seconds, tau: Seconds, clocks: Seconds,
    own: int, stop_at: Seconds, stop_s: Seconds, c: int, stops: int, open_from: int,
    rests_open: bool, arrive: Seconds, leave: Seconds, ahead: Seconds, later: Seconds, begin: int,
    end: int, cells: int, width: int, sure: bool, throughout: bool, floor: float, most: float,
    total: Floats, from_cell: Seconds, till_cell: Seconds, pays: Floats,
) -> int:  # fmt: skip
    """Fill what a vehicle pays in each cell; return its first pair.

    Cells that are, or would be, of no interest cost inf.
    """
    n = len(pos)
    first = -1
    wanted, least = 0, np.inf  # the cells for which no pair is known yet
    for g in range(cells):
        pays[g] = np.inf
        if total[g] < most:
            wanted |= 1 << g
            least = min(least, total[g])
    if sure and v[PLAIN] == 0 and k < count:
        wanted, first = 0, k
    if wanted != 0 and k < count and not throughout:
        # Before and after which cells a point is of no use, whatever the other one is.
        for i in range(n):
            opens, stands = FAR, FAR
            for e in range(entry_at[m, i, 0], entry_at[m, i, 1]):
                opens = min(opens, entries[e, READY])
            for e in range(exit_at[m, i, 0], exit_at[m, i, 1]):
                stands = min(stands, exits[e, STANDS])
            opens -= leave[i] + later[i] + begin
            ends = v[ARRIVAL] - onward[m, i] - stands - arrive[i] - ahead[i] - begin
            from_cell[i] = max(opens // width, 0)
            till_cell[i] = min(ends // width, cells - 1)
    while wanted != 0 and k < count:
        price = pair_cost[base + k]
        if not least + price - floor < most:
            break
        i, j = pair_i[base + k], pair_j[base + k]
        k += 1
        if not throughout and (
            from_cell[i] > till_cell[j]
            or (wanted >> from_cell[i]) & ((2 << (till_cell[j] - from_cell[i])) - 1) == 0
        ):
            continue
        low, high = pos[i], pos[j]
        q = 0
        while q < stops and stop_at[c, q] <= low:
            q += 1
        news = False
        # The cells for which the separation point is of use.
        till = (2 << till_cell[j]) - 1 if not throughout else 1
        for e in range(entry_at[m, i, 1] - 1, entry_at[m, i, 0] - 1, -1):
            opens = entries[e, READY] - leave[i] - later[i] - begin
            if opens + begin > end or (
                opens > 0 and not throughout and (wanted & till) >> (opens // width) == 0
            ):
                continue
            opens, closes = departures(
                v, entries, e, exits, exit_at[m, j, 0], exit_at[m, j, 1], approach[m, i],
                onward[m, j], low, high, tau, clocks, own, stop_at, stop_s, c,
                stops, q, j >= open_from, rests_open, leave[i] + ahead[i],
                leave[i] + later[i], arrive[j] + ahead[j], sure, begin,
            )  # fmt: skip
            if closes < opens or closes < begin or opens > end:
                continue
            if throughout:
                if opens <= begin and closes >= end:
                    pays[0], wanted = price, 0
                    break
                continue
            last = min((closes - begin) // width, cells - 1)
            for g in range((opens - begin) // width, last + 1):
                if (wanted >> g) & 1:
                    pays[g] = price
                    wanted ^= 1 << g
                    news = True
            if wanted == 0:
                break
        if throughout:
            first, wanted = k - 1, 0
            break
        if news:
            if first < 0:
                first = k - 1
            least = np.inf
            for g in range(cells):
                if (wanted >> g) & 1:
                    least = min(least, total[g])
    if wanted != 0 and k >= count:
        for g in range(cells):
            if pays[g] == np.inf:
                pays[g] = alone
    return first if first >= 0 else min(k, count)


HELPERS = (*TIMES, openings, offsets, _charge)
"""What the kernel calls, callees first: to be made known to the compiler before it."""


def evaluate(
    rows: Seconds, rank: Seconds, vehicles: Seconds, approach: Seconds, onward: Seconds,
    entry_at: Seconds, entries: Seconds, exit_at: Seconds, exits: Seconds, pair_first: Seconds,
    pair_i: Seconds, pair_j: Seconds, pair_cost: Floats, alone: Floats, pos: Seconds,
    tau: Seconds, clocks: Seconds, clock_of: Seconds, places: Seconds, plan: Seconds,
    stop_at: Seconds, stop_s: Seconds, stop_count: Seconds, begun: Seconds, sure: bool,
    throughout: bool,
    floor: Floats, most: float, begin: Seconds, end: Seconds, bound: Floats, cost: Floats,
    found: Seconds,
) -> None:  # fmt: skip
    """Fill the cost and the pair of some vehicles, for some timetables of the master.

    Parameters
    ----------
    rows : ndarray of int, (R,)
        Which vehicles.
    rank : ndarray of int, (C, R) or (1, R)
        Where in its list each is to go on: all pairs before are known not to be drivable.
    vehicles, approach, onward : ndarray of int
        Of all vehicles, see `StarNumbers`.
    entry_at, entries, exit_at, exits : ndarray of int
        See `plain_ways`.
    pair_first, pair_i, pair_j, pair_cost : ndarray
        See `MemberPairs`.
    alone : ndarray of float, (M + 1,)
        What each pays alone.
    pos, tau, clocks, clock_of : ndarray of int
        The master's way, see `StarNumbers`.
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
    sure : bool
        Whether entries, exits and limits are the strict ones.
    throughout : bool
        Whether the pair at `rank` is drivable at all departures of the span; no other is looked at,
        and the cost is inf if it is not.
    floor : ndarray of float, (R,)
        What each vehicle pays at least, as far as is known.
    most : float
        Departures are of no interest if all together pay as much.
    begin, end : ndarray of int, (C,)
        The span of the master's departure [s]; it is made shorter if its ends are of no interest.
    bound : ndarray of float, (C,)
        To be filled: what all together pay at least; inf if no departure is of interest.
    cost : ndarray of float, (C, R)
        To be filled: what each pays at least.
    found : ndarray of int, (C, R)
        To be filled: the place of its first pair in its list; its length for who stays alone.
    """
    n = len(pos)
    arrive, leave = np.empty(n, np.int64), np.empty(n, np.int64)
    ahead, later = np.zeros(n, np.int64), np.zeros(n, np.int64)
    total, pays = np.empty(CELLS), np.empty(CELLS)
    from_cell, till_cell = np.empty(n, np.int64), np.empty(n, np.int64)
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
            open_from = openings(
                pos, tau, places, plan, master, at, stops, rested, stood, begun[c], begin[c],
                ahead, later,
            )  # fmt: skip
            if open_from < 0:
                open_from, rests_open = -1 - open_from, True
        offsets(pos, tau, stop_at[c, :stops], stop_s[c, :stops], arrive, leave)
        cells = 1 if throughout else min(CELLS, end[c] - begin[c] + 1)
        width = (end[c] - begin[c]) // cells + 1
        cells = (end[c] - begin[c]) // width + 1
        for g in range(cells):
            total[g] = known
        bound[c] = known
        for row in range(len(rows)):
            m = rows[row]
            base, count = pair_first[m], pair_first[m + 1] - pair_first[m]
            first = _charge(
                m, rank[min(c, len(rank) - 1), row], vehicles[m], approach, onward, entry_at,
                entries, exit_at, exits, base, count, pair_i, pair_j, pair_cost, alone[m], pos,
                tau, clocks, clock_of[m], stop_at, stop_s, c, stops, open_from, rests_open, arrive,
                leave, ahead, later, begin[c], end[c], cells, width, sure, throughout, floor[row],
                most, total, from_cell, till_cell, pays,
            )  # fmt: skip
            cheapest, bound[c] = np.inf, np.inf
            for g in range(cells):
                if total[g] < np.inf:
                    total[g] += pays[g] - floor[row]
                cheapest = min(cheapest, pays[g])
                bound[c] = min(bound[c], total[g])
            cost[c, row], found[c, row] = cheapest, first
            if throughout:
                total[0] = known
            elif not bound[c] < most:
                bound[c] = np.inf
                break
        if throughout or not bound[c] < np.inf:
            continue
        if not bound[c] < most:
            # Nobody was left to be charged.
            bound[c] = np.inf
            continue
        low, high = 0, cells - 1
        while not total[low] < most:
            low += 1
        while not total[high] < most:
            high -= 1
        end[c] = min(end[c], begin[c] + (high + 1) * width - 1)
        begin[c] += low * width
