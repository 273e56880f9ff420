"""Who has to stop alone may follow the platoon and join it again where it pauses.

For a fixed timetable of the master, a member may drive two stretches with it: from i to j, alone
along the master's way to k, and from k to l. That helps only if the platoon pauses between j and k,
and costs the member what driving alone between them does more. All such quadruples are gone through
in order of their cost, as long as they are cheaper than what the member pays; those that could not
be driven even with pauses anywhere are passed over, and the first that can really be driven is the
cheapest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..driver.road import LegalTrip
from .compiled import kernels_for
from .numbers import StarNumbers
from .record import MemberTiming, Timetable

__all__ = ["Again", "joined_again"]

Floats = NDArray[np.float64]

NO_CHEAPER = 1e-9
"""What costs less by this share costs the same."""

MOST_LOOKED = 20_000
"""Quadruples that are looked at for a member."""

MOST_ASKED = 60
"""Real trips that are asked for a member."""

FEW_ASKED = 3
"""So many are found at first."""


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
    shift, done = some.first_node, 0
    for most_asked in (FEW_ASKED, MOST_ASKED):
        costs, fours, looked = _in_order(some, table, row, again, one.cost, most_asked)
        for cost, four in zip(costs[done:], fours[done:], strict=True):
            i, j, k, m = (at - shift for at in four)
            trip = again.trip(row, [(i, j), (k, m)], table)
            if trip is not None:
                return replace(
                    one, cost=cost, merge=i, separate=m, trip=trip, possible=True,
                    stretches=((i, j), (k, m)),
                ), True  # fmt: skip
        done = len(fours)
        if done < most_asked:
            return one, looked < MOST_LOOKED
    return one, False


def _in_order(
    some: StarNumbers, table: Timetable, row: int, again: Again, most: float, most_asked: int
) -> tuple[list[float], list[list[int]], int]:
    """Return what could be driven and is cheaper, the cheapest first, and how many were looked at.

    Points are those of the star's numbers.
    """
    n = len(some.pos)
    arrives, leaves = table.arrive_s[some.pos], table.leave_s[some.pos]
    own = some.platoon[row]
    alone = np.full(n, np.inf)
    alone[some.first_node : some.first_node + again.solo_along.shape[1]] = again.solo_along[row]
    into = np.where(some.ready[row] <= leaves, some.entry[row] - own, np.inf)
    out = np.where(arrives <= some.must[row], some.leave[row] + own, np.inf)
    stops = np.array(table.stops, np.int64).reshape(-1, 2)
    fours = np.empty((most_asked, 4), np.int64)
    costs = np.empty(most_asked)
    looked = kernels_for(n * len(some.alone)).two_stretches(
        some.vehicles[row], some.clocks[some.clock_of[row]], some.approach[row], some.onward[row],
        some.pos, some.tau, stops[:, 0].copy(), stops[:, 1].copy(), table.arrive_s, table.leave_s,
        own, alone, into, out, np.argsort(into, kind="stable"), np.argsort(out, kind="stable"),
        most * (1 - NO_CHEAPER), MOST_LOOKED, fours, costs,
    )  # fmt: skip
    count = int((fours[:, 0] >= 0).sum())
    return costs[:count].tolist(), fours[:count].tolist(), looked
