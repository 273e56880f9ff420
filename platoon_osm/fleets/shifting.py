"""When everybody drives, for companies that are fixed: nobody waits on the road without need.

Whoever enters a lane together is a group. First each group starts as early as its members can be
there; arrivals are then fixed, and each group starts as late as its members' next ones allow. So
waits move to where trips begin, where they cost nothing, as far as latest departures let them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..search.hierarchy.runtime.jit import compiled
from .instance import Instance

__all__ = ["shifted"]

Ints = NDArray[np.int64]


def shifted(instance: Instance, lanes: Sequence[Ints], departs: Sequence[Ints]) -> list[Ints]:
    """Return other instants for the same companies, with less waiting on the road.

    Parameters
    ----------
    instance : Instance
        The problem.
    lanes, departs : sequence of ndarray of int64, (N, ...)
        The lanes of each truck in driving order, and when it enters them [ticks].

    Returns
    -------
    list of ndarray of int64, (N, ...)
        When each enters its lanes; nobody arrives later.
    """
    sizes = np.array([len(own) for own in lanes])
    first = np.concatenate([[0], np.cumsum(sizes)])
    lane, at = np.concatenate(lanes), np.concatenate(departs)
    truck = np.repeat(np.arange(len(lanes)), sizes)
    order = np.lexsort((lane, at))
    begins = np.ones(len(order), bool)
    begins[1:] = (np.diff(lane[order]) != 0) | (np.diff(at[order]) != 0)
    group = np.empty(len(order), np.int64)
    group[order] = np.cumsum(begins) - 1
    starts = np.full(int(group.max()) + 1, np.iinfo(np.int64).min)
    _earliest(order, truck, first, group, instance.drive[lane], instance.earliest, starts)
    final = starts.copy()
    _latest(
        order, truck, first, group, instance.drive[lane], instance.latest_departure, starts, final
    )
    return [final[group[first[k] : first[k + 1]]] for k in range(len(lanes))]


@compiled
def _earliest(
    order: Ints, truck: Ints, first: Ints, group: Ints, drive: Ints, earliest: Ints, starts: Ints
) -> None:
    """Start each group as early as its members can be there; `order` is that of time."""
    for row in order:
        k = truck[row]
        ready = earliest[k] if row == first[k] else starts[group[row - 1]] + drive[row - 1]
        if ready > starts[group[row]]:
            starts[group[row]] = ready


@compiled
def _latest(
    order: Ints,
    truck: Ints,
    first: Ints,
    group: Ints,
    drive: Ints,
    latest: Ints,
    starts: Ints,
    final: Ints,
) -> None:
    """Start each group as late as what its members do next allows, the last ones first."""
    free = np.int64(1) << 60
    final[:] = free
    for i in range(len(order) - 1, -1, -1):
        row = order[i]
        k, own = truck[row], group[row]
        if row + 1 == first[k + 1]:
            # Arrivals stay.
            until = starts[own]
        else:
            until = final[group[row + 1]] - drive[row]
        if row == first[k] and latest[k] < until:
            until = max(starts[own], latest[k])
        if until < final[own]:
            final[own] = until
