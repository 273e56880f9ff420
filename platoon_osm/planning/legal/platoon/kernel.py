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

Where stops of the master that are not decided yet may lie between the two points (`open_stops.py`),
clocks may have begun anew at the last of these places, and the platoon leaves late and arrives
early by as much as the stops may last; but the whole rest of the member's trip, with pauses
anywhere, must be in time, too. What was ruled out in a cell of a longer span, or with fewer stops
decided, stays out. Functions are plain;
`compiled.py` compiles them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .cells import DEAD, charge, holds
from .cells import HELPERS as CHARGES
from .clocks import REST
from .open_stops import COLUMNS, STOPPED, offsets, open_stops
from .open_stops import HELPERS as STILL_OPEN

__all__ = ["CELLS", "HELPERS", "evaluate"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]
Places = NDArray[np.int32]

CELLS = 32
"""Into how many cells a span is cut at most, below 63."""


HELPERS = (*CHARGES, *STILL_OPEN)
"""What the kernel calls, callees first: to be made known to the compiler before it."""


def evaluate(
    rows: Seconds, rank: Seconds, past: Places, past_begin: int, past_s: int,
    vehicles: Seconds, approach: Seconds, onward: Seconds,
    entry_at: Seconds, entries: Seconds, exit_at: Seconds, exits: Seconds, pair_first: Seconds,
    pair_i: Seconds, pair_j: Seconds, pair_cost: Floats, alone: Floats, pos: Seconds,
    tau: Seconds, clocks: Seconds, clock_of: Seconds, places: Seconds, plan: Seconds,
    stop_at: Seconds, stop_s: Seconds, stop_count: Seconds, begun: Seconds, nights: Seconds,
    sure: bool, throughout: bool, most: float, begin: Seconds, end: Seconds, bound: Floats,
    cost: Floats, found: Seconds, ranks: Places, cut: Seconds,
) -> None:  # fmt: skip
    """Fill the cost and the pair of some vehicles, for some timetables of the master.

    Parameters
    ----------
    rows : ndarray of int, (R,)
        Which vehicles.
    rank : ndarray of int, (C, R) or (1, R)
        Where in its list each is to go on: all pairs before are known not to be drivable.
    past : ndarray of int, (R, G)
        Likewise in each cell of a longer span, or with fewer stops; `DEAD` where it was too dear.
    past_begin, past_s : int
        When the first of these cells begins, and how long each is [s].
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
    nights : ndarray of int, (C, 3)
        Its next daily rest, see `open_stops` [s].
    sure : bool
        Whether entries, exits and limits are the strict ones.
    throughout : bool
        Whether the pair at `rank` is drivable at all departures of the span; no other is looked at,
        and the cost is inf if it is not.
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
    ranks : ndarray of int, (C, R, H)
        To be filled: likewise in each cell, or in as many cells together as there is room for.
    cut : ndarray of int, (C, 2)
        To be filled: when the first of these begins, and how long each is [s].
    """
    n = len(pos)
    arrive, leave = np.empty(n, np.int64), np.empty(n, np.int64)
    still = np.empty((n, COLUMNS), np.int64)
    total, pays, paid = np.empty(CELLS), np.empty(CELLS), np.empty((len(rows), CELLS))
    start, rank_of = np.empty((len(rows), CELLS), np.int64), np.empty((len(rows), CELLS), np.int64)
    from_cell, till_cell = np.empty(n, np.int64), np.empty(n, np.int64)
    order = np.arange(len(rows))
    master = vehicles[len(vehicles) - 1]
    for c in range(len(stop_count)):
        stops = stop_count[c]
        still[:, :STOPPED] = 0
        still[:, STOPPED:] = -1
        if begun[c, 0] >= 0:
            at, rested, stood = 0, 0, 0
            for q in range(stops):
                at = stop_at[c, q]
                stood += stop_s[c, q]
                rested += 1 if stop_s[c, q] >= master[REST] else 0
            open_stops(
                pos, tau, places, plan, master, at, stops, rested, stood, begun[c],
                nights[c, 0], nights[c, 1], nights[c, 2], begin[c], still,
            )  # fmt: skip
        offsets(pos, tau, stop_at[c, :stops], stop_s[c, :stops], arrive, leave)
        own_rank = rank[min(c, len(rank) - 1)]
        if throughout:
            for row in range(len(rows)):
                m, k = rows[row], own_rank[row]
                base, count = pair_first[m], pair_first[m + 1] - pair_first[m]
                certain = holds(
                    m, k, vehicles[m], approach, onward, entry_at, entries, exit_at, exits, base,
                    count, pair_i, pair_j, pos, tau, clocks, clock_of[m], stop_at, stop_s, c,
                    stops, arrive, leave, begin[c], end[c], sure,
                )  # fmt: skip
                found[c, row] = k
                cost[c, row] = np.inf
                if certain:
                    cost[c, row] = pair_cost[base + k] if k < count else alone[m]
            continue
        cells = min(CELLS, end[c] - begin[c] + 1)
        width = (end[c] - begin[c]) // cells + 1
        cells = (end[c] - begin[c]) // width + 1
        for g in range(cells):
            total[g] = 0.0
            opens = begin[c] + g * width
            closes = min(opens + width - 1, end[c])
            first = max(0, min(past.shape[1] - 1, (opens - past_begin) // past_s))
            last = max(0, min(past.shape[1] - 1, (closes - past_begin) // past_s))
            for row in range(len(rows)):
                m = rows[row]
                base, count = pair_first[m], pair_first[m + 1] - pair_first[m]
                at_least = past[row, first]
                for h in range(first + 1, last + 1):
                    at_least = min(at_least, past[row, h])
                k = max(own_rank[row], at_least)
                start[row, g] = k
                price = np.inf
                if k < DEAD:
                    price = pair_cost[base + k] if k < count else alone[m]
                paid[row, g] = price
                total[g] += price
        bound[c] = np.inf
        for g in range(cells):
            bound[c] = min(bound[c], total[g])
        for turn in range(len(rows)):
            row = order[turn]
            m = rows[row]
            base, count = pair_first[m], pair_first[m + 1] - pair_first[m]
            found[c, row] = charge(
                m, vehicles[m], approach, onward, entry_at, entries, exit_at, exits, base, count,
                pair_i, pair_j, pair_cost, alone[m], pos, tau, clocks, clock_of[m], stop_at,
                stop_s, c, stops, still, plan[2], arrive, leave, begin[c], end[c], cells, width,
                sure, most, total, from_cell, till_cell, start[row],
                paid[row], pays, rank_of[row],
            )  # fmt: skip
            cheapest, bound[c] = np.inf, np.inf
            for g in range(cells):
                if pays[g] < np.inf:
                    total[g] += pays[g] - paid[row, g]
                else:
                    total[g] = np.inf
                cheapest = min(cheapest, pays[g])
                bound[c] = min(bound[c], total[g])
            cost[c, row] = cheapest
            if not bound[c] < most:
                # Who makes this timetable too dear may do so with the next one, too.
                order[1 : turn + 1] = order[:turn].copy()
                order[0] = row
                break
        if not bound[c] < most:
            bound[c] = np.inf
            continue
        # As many cells together as there is room for.
        each = (cells + ranks.shape[2] - 1) // ranks.shape[2]
        cut[c, 0], cut[c, 1] = begin[c], each * width
        for row in range(len(rows)):
            for h in range(ranks.shape[2]):
                ranks[c, row, h] = DEAD
            for g in range(cells):
                if total[g] < most:
                    ranks[c, row, g // each] = min(ranks[c, row, g // each], rank_of[row, g])
        low, high = 0, cells - 1
        while not total[low] < most:
            low += 1
        while not total[high] < most:
            high -= 1
        end[c] = min(end[c], begin[c] + (high + 1) * width - 1)
        begin[c] += low * width
