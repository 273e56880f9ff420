"""The pairs of points at which each member may merge and separate, the cheapest first.

What a member pays with a timetable of the master is the cost of the first pair in its list that it
can drive. Within a part of the search no pair becomes drivable that was not before, so the search
only goes on in the list, from where it stood. Pairs are left out that cost more than driving alone,
or whose way is too long for the member's window with the fewest pauses. Of equal costs the longest
platoon comes first, then the earliest merging point.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import clocks as clocks
from .numbers import StarNumbers, least_s
from .star_times import NEVER_S

__all__ = ["MemberPairs", "pairs_of_star"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class MemberPairs:
    """The pairs of all vehicles; the master has one, its whole way.

    Attributes
    ----------
    first : ndarray of int, (M + 2,)
        Where each vehicle's begin.
    merge, separate : ndarray of int, (X,)
        Its points.
    cost : ndarray of float, (X,)
        What the vehicle pays.
    """

    first: Seconds
    merge: NDArray[np.int32]
    separate: NDArray[np.int32]
    cost: Floats


def pairs_of_star(some: StarNumbers) -> MemberPairs:
    """Return the pairs of a star.

    Parameters
    ----------
    some : StarNumbers
        The star.

    Returns
    -------
    MemberPairs
        The cheapest first.
    """
    n, members = len(some.pos), some.master
    merges, separates, costs, counts = [], [], [], []
    i, j = (one.astype(np.int64) for one in np.triu_indices(n, 1))
    drive = some.tau[some.pos]
    shared_s, together = drive[j] - drive[i], some.along[j] - some.along[i]
    for m in range(members):
        clock = some.clocks[some.clock_of[m]][some.pos]
        shared_clock = clock[j] - clock[i]
        v, own = some.vehicles[m], some.platoon[m]
        cost = (some.entry[m] - own)[i] + (own + some.leave[m])[j]
        alone, slack = some.alone[m], some.slack[m]
        usable = cost < alone - slack
        usable |= (cost <= alone + slack) & (together > 0)
        usable &= (some.approach[m][i] < NEVER_S) & (some.onward[m][j] < NEVER_S)
        begins = some.ready[m][i] + shared_s
        usable &= begins + some.onward[m][j] <= v[clocks.ARRIVAL]
        kept = np.flatnonzero(usable)
        own_s = some.approach[m][i[kept]] + some.onward[m][j[kept]]
        counted = own_s + shared_clock[kept]
        paused = least_s(v[None], counted[None], begins=True)[0] - counted
        lasts = own_s + shared_s[kept] + paused
        kept = kept[v[clocks.EARLIEST] + lasts <= v[clocks.ARRIVAL]]
        pays = cost[kept]
        order = np.argsort(pays, kind="stable")
        # Costs that differ by less than a hair are equal.
        step = np.diff(pays[order], prepend=pays[order[:1]]) > slack
        group = np.cumsum(step)
        kept = kept[order]
        tie = np.lexsort((j[kept], i[kept], -together[kept], group))
        merges.append(i[kept[tie]])
        separates.append(j[kept[tie]])
        costs.append(cost[kept[tie]])
        counts.append(len(kept))
    merges.append(np.array([0]))
    separates.append(np.array([n - 1]))
    costs.append(np.zeros(1))
    first = np.concatenate([[0], np.cumsum([*counts, 1])]).astype(np.int64)
    return MemberPairs(
        first, np.concatenate(merges).astype(np.int32), np.concatenate(separates).astype(np.int32),
        np.concatenate(costs),
    )  # fmt: skip
