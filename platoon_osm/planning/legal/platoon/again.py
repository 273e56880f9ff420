"""Who has to stop alone may follow the platoon and join it again where it pauses.

For a fixed timetable of the master, a member may drive two stretches with it: from i to j, alone
along the master's way to k, and from k to l. That helps only if the platoon pauses between j and k,
and costs the member what driving alone between them does more. All such quadruples are gone through
in order of their cost, as long as they are cheaper than what the member pays; those that could not
be driven even with pauses anywhere are passed over, and the first that can really be driven is the
cheapest.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..driver.road import LegalTrip
from . import clocks as clocks_of
from .numbers import StarNumbers
from .record import MemberTiming, Timetable

__all__ = ["Again", "joined_again"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]
Four = tuple[int, int, int, int]
State = tuple[int, int, int, int]
"""Driven, with no part of a break and with the first; today; when duty began."""

FAR = clocks_of.FAR

MOST_LOOKED = 20_000
"""Quadruples that are looked at for a member."""

MOST_ASKED = 60
"""Real trips that are asked for a member."""


@dataclass(frozen=True, slots=True)
class Again:
    """What it takes to look for second stretches.

    Attributes
    ----------
    solo_along : ndarray of float, (M, K + 1)
        What each member pays alone along the master's route, from its first node to each.
    trip : callable
        From a member, its stretches and a timetable to its real trip, or None.
    """

    solo_along: Floats
    trip: Callable[[int, Sequence[tuple[int, int]], Timetable], LegalTrip | None]


def joined_again(
    numbers: StarNumbers, table: Timetable, members: Sequence[MemberTiming], again: Again
) -> tuple[list[MemberTiming], bool]:
    """Return what members do if they may join again, and whether all ways to were compared.

    Parameters
    ----------
    numbers : StarNumbers
        The star.
    table : Timetable
        The master's.
    members : sequence of MemberTiming, (M,)
        What they do in one stretch.
    again : Again
        Costs alone along the route, and who answers for real trips.

    Returns
    -------
    members : list of MemberTiming, (M,)
        The same where no two stretches are cheaper.
    complete : bool
        False if a member had more ways to than are looked at.
    """
    found, complete = [], True
    for row, one in enumerate(members):
        best, whole = _best(numbers, table, row, one, again)
        found.append(best)
        complete &= whole
    return found, complete


def _best(
    some: StarNumbers, table: Timetable, row: int, one: MemberTiming, again: Again
) -> tuple[MemberTiming, bool]:
    shift, asked = some.first_node, 0
    for looked, (cost, four) in enumerate(_in_order(some, table, row, again, one.cost)):
        if looked >= MOST_LOOKED or asked >= MOST_ASKED:
            return one, False
        if not _could(some, table, row, four):
            continue
        asked += 1
        i, j, k, m = (at - shift for at in four)
        trip = again.trip(row, [(i, j), (k, m)], table)
        if trip is not None:
            return replace(
                one, cost=cost, merge=i, separate=m, trip=trip, possible=True,
                stretches=((i, j), (k, m)),
            ), True  # fmt: skip
    return one, True


def _in_order(
    some: StarNumbers, table: Timetable, row: int, again: Again, most: float
) -> Iterator[tuple[float, Four]]:
    """Yield quadruples that cost less than the member pays, the cheapest first."""
    n = len(some.pos)
    arrives, leaves = table.arrive_s[some.pos], table.leave_s[some.pos]
    own = some.platoon[row]
    nodes = slice(some.first_node, some.first_node + again.solo_along.shape[1])
    alone = np.full(n, np.inf)
    alone[nodes] = again.solo_along[row]
    into = np.where(some.ready[row] <= leaves, some.entry[row] - own, np.inf)
    out = np.where(arrives <= some.must[row], some.leave[row] + own, np.inf)
    heap: list[tuple[float, int, int, int, int]] = []
    before = [np.argsort(into[:j], kind="stable") for j in range(n)]
    behind = [k + 1 + np.argsort(out[k + 1 :], kind="stable") for k in range(n)]
    paused = np.searchsorted(np.array([at for at, _ in table.stops], np.int64), some.pos, "left")
    until = np.searchsorted(np.array([at for at, _ in table.stops], np.int64), some.pos, "right")

    def push(j: int, k: int, a: int, b: int) -> None:
        if a < len(before[j]) and b < len(behind[k]):
            between = own[j] - alone[j] + alone[k] - own[k]
            cost = into[before[j][a]] + between + out[behind[k][b]]
            if cost < most * (1 - 1e-9):
                heapq.heappush(heap, (float(cost), j, k, a, b))

    for j in range(1, n - 1):
        if not np.isfinite(alone[j]):
            continue
        for k in range(j + 1, n - 1):
            if np.isfinite(alone[k]) and until[k] > paused[j]:
                push(j, k, 0, 0)
    while heap:
        cost, j, k, a, b = heapq.heappop(heap)
        yield cost, (int(before[j][a]), j, k, int(behind[k][b]))
        push(j, k, a, b + 1)
        if b == 0:
            push(j, k, a + 1, 0)


def _could(some: StarNumbers, table: Timetable, row: int, four: Four) -> bool:
    """Whether a member could drive two stretches, with pauses anywhere on its own ways."""
    v = some.vehicles[row]
    i, j, k, m = four
    arrives, leaves = table.arrive_s[some.pos], table.leave_s[some.pos]
    entered = np.empty(4, np.int64)
    if not clocks_of.entry_state(v, int(some.approach[row, i]), int(leaves[i]), entered):
        return False
    free, parted, today, duty = entered.tolist()
    first = _with_platoon(some, table, row, (free, parted, today, duty), i, j)
    if first is None:
        return False
    rejoins = _alone(v, first, int(some.tau[some.pos[k]] - some.tau[some.pos[j]]),
                     int(leaves[k] - arrives[j]), int(leaves[k]))  # fmt: skip
    last = None if rejoins is None else _with_platoon(some, table, row, rejoins, k, m)
    if last is None:
        return False
    stands = int(leaves[m] - arrives[m])
    after = _paused(v, last, stands, int(leaves[m]))
    onward = int(some.onward[row, m])
    ends = min(
        clocks_of.onward_at(v, *state, at, onward, onward)
        for state, at in ((last, int(arrives[m])), (after, int(leaves[m])))
    )
    return bool(ends <= v[clocks_of.ARRIVAL])


def _with_platoon(
    some: StarNumbers, table: Timetable, row: int, state: State, begin: int, end: int
) -> State | None:
    v, clock = some.vehicles[row], some.clocks[some.clock_of[row]]
    low, high = int(some.pos[begin]), int(some.pos[end])
    at = low
    for place, length in (*(one for one in table.stops if low < one[0] < high), (high, -1)):
        step = int(clock[place] - clock[at])
        at = place
        free, parted, today, duty = state
        free = free + step if free + step <= v[clocks_of.SPELL] else FAR
        parted = parted + step if parted + step <= v[clocks_of.SPELL] else FAR
        state = free, parted, today + step, duty
        tired = min(free, parted) >= FAR or today + step > v[clocks_of.DAY]
        if tired or table.arrive_s[place] - duty > v[clocks_of.WINDOW]:
            return None
        if length >= 0:
            state = _paused(v, state, length, int(table.leave_s[place]))
    return state


def _paused(v: Seconds, state: State, length: int, leaves: int) -> State:
    free, parted, today, duty = state
    if length >= v[clocks_of.REST]:
        return 0, 0, 0, leaves
    free, parted = clocks_of.paused(v, free, parted, length)
    return int(free), int(parted), today, duty


def _alone(v: Seconds, state: State, drive: int, lasts: int, leaves: int) -> State | None:
    """Return clocks at least as good as any after driving alone for some time, with pauses."""
    free, parted, today, duty = state
    spare, driven, part = lasts - drive, min(free, parted), int(parted < FAR)
    if spare < 0:
        return None
    if spare >= v[clocks_of.REST]:
        return 0, 0, 0, leaves
    breaks = clocks_of.needed(int(v[clocks_of.SPELL]), driven, drive)
    if spare < clocks_of.breaks_s(v, breaks, part) or today + drive > v[clocks_of.DAY]:
        return None
    if spare >= clocks_of.breaks_s(v, breaks + 1, part):
        return 0, 0, today + drive, duty
    left = max(0, driven + drive - breaks * int(v[clocks_of.SPELL]))
    return left, left, today + drive, duty
