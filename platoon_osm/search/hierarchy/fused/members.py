"""Where members best join a route and leave it: both sweeps and the choice in one kernel.

For a block of members the entry costs D(o, r_i) and the exit costs D(r_j, g) to all nodes of the
route are swept side by side, a running minimum finds the least sum, and only the best pair is
kept: no table of all members and all route nodes ever exists.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...joining import Found, Positions
from ...tie_rule import is_platoon, preferred, slack_of
from ..customization import Metric
from ..runtime.jit import compiled
from ..runtime.threads import run_all
from ..sweeping.rows import sweep_rows
from .selection import climb, into_lane, select

__all__ = ["best_on_route"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]

BLOCK = 32
"""Members swept together: two tables of so many lanes stay in a core's second-level cache."""
WORTH_A_THREAD = 64

_slack_of = compiled(slack_of)
_preferred = compiled(preferred)
_is_platoon = compiled(is_platoon)


def best_on_route(
    metric: Metric,
    route: Longs,
    origins: Longs,
    destinations: Longs,
    platoon: Floats,
    length_m: Floats,
    entries: Positions | None = None,
    exits: Positions | None = None,
    threads: int = 1,
) -> Found:
    """Return for N members the best positions i < j on a route, and what they cost.

    Equal costs are those of `best_pairs`: the longest platoon [m] is best, then the smallest i.

    Parameters
    ----------
    metric : Metric
        The hierarchy under one weight.
    route : ndarray of int, (K + 1,)
        Nodes of the route.
    origins : ndarray of int, (N,)
        Nodes where members start.
    destinations : ndarray of int, (N,)
        Nodes where they go.
    platoon : ndarray of float, (K + 1,)
        Platoon weight along the route up to each node.
    length_m : ndarray of float, (K + 1,)
        Metres along the route up to each node.
    entries : tuple of ndarray of int, optional
        Positions where each member may join, as first (N + 1,) and positions; by default all.
    exits : tuple of ndarray of int, optional
        Positions where each member may leave, likewise.
    threads : int
        Cores to use; results do not depend on it.

    Returns
    -------
    i : ndarray of int, (N,)
        Positions where they join; -1 where staying alone is cheaper.
    j : ndarray of int, (N,)
        Positions where they leave; -1 likewise.
    cost : ndarray of float, (N,)
        What each pays.
    solo : ndarray of float, (N,)
        What each pays alone.
    """
    t, count = metric.topology, len(origins)
    i, j = np.full(count, -1, np.int64), np.full(count, -1, np.int64)
    cost, solo = np.empty(count), np.empty(count)
    if not count:
        return i, j, cost, solo
    part = select(t, route)
    up, down = metric.up[part.arc], metric.down[part.arc]
    free = (np.zeros(1, np.int64), np.zeros(0, np.int64))
    # Neighbours in one block share most of what they climb.
    order = np.argsort(t.rank[origins], kind="stable")
    starts, ends = t.rank[origins], t.rank[destinations]
    arguments = (
        starts, ends, t.first, t.head, t.parent, metric.up, metric.down, part.local, part.first,
        part.head, up, down, part.row, platoon, length_m, *(entries or free),
        *(exits or free), i, j, cost, solo,
    )  # fmt: skip
    width = min(BLOCK, max(8, -(-count // threads)))
    tasks = -(-count // width)
    workers = min(threads, tasks) if count >= WORTH_A_THREAD else 1
    run_all(lambda w: _blocks(order, w, workers, width, *arguments), range(workers), workers)
    return i, j, cost, solo


@compiled
def _blocks(
    order: Longs, worker: int, workers: int, width: int, starts: Ints, ends: Ints, first: Ints,
    head: Ints, parent: Ints, up: Floats, down: Floats, local: Ints, own_first: Ints,
    own_head: Ints, own_up: Floats, own_down: Floats, row: Ints, platoon: Floats,
    length_m: Floats, entry_first: Longs, entry_at: Longs, exit_first: Longs,
    exit_at: Longs, best_i: Longs, best_j: Longs, cost: Floats, solo: Floats,
) -> None:  # fmt: skip
    rows, stops = len(own_first) - 1, len(row)
    there, back = np.full(len(parent), np.inf), np.full(len(parent), np.inf)
    arrive, leave = np.empty((rows, width)), np.empty((rows, width))
    entry, exit_ = np.empty((stops, width)), np.empty((stops, width))
    lead, total = np.empty((stops, width)), np.empty((stops, width))
    least, good = np.empty(width), np.empty(stops, np.int64)
    reached, leads = np.empty(rows, np.bool_), np.empty(rows, np.bool_)
    for begin in range(worker * width, len(order), workers * width):
        members = order[begin : begin + width]
        reached[:], leads[:] = False, False
        for lane in range(len(members)):
            m = members[lane]
            climb(starts[m], first, head, parent, up, there)
            climb(ends[m], first, head, parent, down, back)
            alone = np.inf
            v = ends[m]
            while v >= 0:
                alone = min(alone, there[v] + back[v])
                v = parent[v]
            solo[m] = alone
            into_lane(starts[m], lane, parent, local, there, reached, arrive)
            into_lane(ends[m], lane, parent, local, back, leads, leave)
        sweep_rows(0, rows, own_first, own_head, own_down, reached, arrive)
        sweep_rows(0, rows, own_first, own_head, own_up, leads, leave)
        _copy_allowed(members, row, arrive, entry_first, entry_at, entry)
        _copy_allowed(members, row, leave, exit_first, exit_at, exit_)
        least[:] = np.inf
        for k in range(stops):
            for lane in range(width):
                value = entry[k, lane] - platoon[k]
                if k > 0:
                    before = lead[k - 1, lane]
                    value = value if value < before else before
                lead[k, lane] = value
                value = value + platoon[k] + exit_[k, lane]
                total[k, lane] = value
                least[lane] = value if value < least[lane] else least[lane]
        for lane in range(len(members)):
            m = members[lane]
            _choose(
                m, lane, entry, exit_, lead, total, least[lane], platoon, length_m, good, best_i,
                best_j, cost, solo,
            )  # fmt: skip


@compiled
def _copy_allowed(
    members: Longs, row: Ints, table: Floats, first: Longs, at: Longs, result: Floats
) -> None:
    """Copy the rows of the route's nodes; where a member may not use one, put inf."""
    if len(first) == 1:
        for k in range(len(row)):
            result[k] = table[row[k]]
        return
    result[:] = np.inf
    for lane in range(len(members)):
        for p in range(first[members[lane]], first[members[lane] + 1]):
            result[at[p], lane] = table[row[at[p]], lane]


@compiled
def _choose(
    m: int, lane: int, entry: Floats, exit_: Floats, lead: Floats, total: Floats, least: float,
    platoon: Floats, length_m: Floats, good: Longs, best_i: Longs, best_j: Longs, cost: Floats,
    solo: Floats,
) -> None:  # fmt: skip
    """Choose for one member by the rule of `tie_rule`; `good` (K + 1,) is room for positions."""
    alone = solo[m]
    cost[m] = alone
    slack = _slack_of(alone, least)
    if not (np.isfinite(least) and least <= alone + slack):
        return
    limit, count = least + slack, 0
    for j in range(len(platoon)):
        if total[j, lane] <= limit:
            good[count] = j
            count += 1
    i, j, together = _preferred(
        good[:count], limit, lead[:, lane], exit_[:, lane], platoon, length_m
    )
    if i < j and _is_platoon(together, least, alone, slack):
        best_i[m], best_j[m] = i, j
        cost[m] = entry[i, lane] + (platoon[j] - platoon[i]) + exit_[j, lane]
