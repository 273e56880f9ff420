"""The lanes that a truck may use, as a small network of its own.

Places of each truck are numbered anew. Where its lanes close no circle they are numbered in the
order of the drive, so that one pass over the lanes sees every way, forwards and backwards.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled
from ..instance import Instance

__all__ = ["Ways", "ways_of"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]


class Ways(NamedTuple):
    """The networks of all trucks over some pairs, which `K` counts.

    Attributes
    ----------
    first : ndarray of int64, (N + 1,)
        Where the pairs of each truck begin.
    order : ndarray of int64, (K,)
        Pairs, truck by truck, sorted by the head of the lane.
    tail, head : ndarray of int64, (K,)
        Places of each pair's lane, numbered from 0 for each truck.
    first_place : ndarray of int64, (N + 1,)
        Where the places of each truck begin.
    leaving : ndarray of int64, (places + N,)
        Where the pairs that leave a place begin; place u of truck k is at first_place[k] + k + u.
    in_order : ndarray of bool, (N,)
        Whether lanes lead from lower to higher places.
    source, sink : ndarray of int64, (N,)
        Places of origin and destination; -1 if no pair touches them.
    earliest : ndarray of int64, (N,)
        Earliest departure [ticks].
    drive, opens, closes : ndarray of int64, (K,)
        How long each pair's lane takes, and the window of entering it [ticks].
    """

    first: Ints
    order: Ints
    tail: Ints
    head: Ints
    first_place: Ints
    leaving: Ints
    in_order: Marks
    source: Ints
    sink: Ints
    earliest: Ints
    drive: Ints
    opens: Ints
    closes: Ints


def ways_of(instance: Instance, pairs: Ints) -> Ways:
    """Return the networks of all trucks over some pairs.

    Parameters
    ----------
    instance : Instance
        The fleet's problem.
    pairs : ndarray of int64, (K,)
        Which, ascending.

    Returns
    -------
    Ways
        Of every truck.
    """
    count, lane = len(pairs), instance.pair_lane[pairs]
    first = np.searchsorted(pairs, instance.first_pair)
    tail, head, order = (np.empty(count, np.int64) for _ in range(3))
    first_place = np.zeros(instance.trucks + 1, np.int64)
    source, sink = (np.full(instance.trucks, -1, np.int64) for _ in range(2))
    in_order = np.zeros(instance.trucks, np.bool_)
    leaving = np.zeros(2 * count + instance.trucks + 1, np.int64)
    drive = instance.drive[lane]
    by_time = np.lexsort((instance.closes[pairs] + drive, instance.pair_truck[pairs]))
    used = _number_places(
        first, instance.tail[lane], instance.head[lane], by_time, instance.origin,
        instance.destination, instance.nodes, tail, head, order, first_place, leaving, in_order,
        source, sink,
    )  # fmt: skip
    return Ways(
        first, order, tail, head, first_place, leaving[:used].copy(), in_order, source, sink,
        instance.earliest, drive, instance.opens[pairs], instance.closes[pairs],
    )  # fmt: skip


@compiled
def _number_places(
    first: Ints,
    tail: Ints,
    head: Ints,
    by_time: Ints,
    origin: Ints,
    destination: Ints,
    nodes: int,
    own_tail: Ints,
    own_head: Ints,
    order: Ints,
    first_place: Ints,
    leaving: Ints,
    in_order: Marks,
    source: Ints,
    sink: Ints,
) -> int:
    """Give places of each truck numbers, sort its pairs, and return the room used of `leaving`."""
    number = np.full(nodes, -1, np.int64)
    inward = np.zeros(nodes, np.int64)
    queue = np.empty(nodes, np.int64)
    begins = np.zeros(nodes + 1, np.int64)
    used = 0
    for k in range(len(origin)):
        begin, end = first[k], first[k + 1]
        for p in range(begin, end):
            number[tail[p]] = number[head[p]] = -1
            inward[tail[p]] = inward[head[p]] = 0
            begins[tail[p]] = begin
        places = 0
        for p in range(begin, end):
            inward[head[p]] += 1
            begins[tail[p]] = begin
        # Pairs are sorted by tail: where those of a tail begin.
        for p in range(end - 1, begin - 1, -1):
            begins[tail[p]] = p
        # Take places that nothing unnumbered leads to, from the queue's front.
        count = 0
        for p in range(begin, end):
            if inward[tail[p]] == 0 and number[tail[p]] == -1:
                number[tail[p]] = -2
                queue[count] = tail[p]
                count += 1
        taken = 0
        while taken < count:
            u = queue[taken]
            number[u] = taken
            taken += 1
            p = begins[u]
            while p < end and p >= begin and tail[p] == u:
                v = head[p]
                inward[v] -= 1
                if inward[v] == 0:
                    number[v] = -2
                    queue[count] = v
                    count += 1
                p += 1
            # A place that nothing leaves keeps an old begin, which its tail tells.
        places = taken
        straight = True
        for i in range(begin, end):
            p = by_time[i]
            for u in (tail[p], head[p]):
                if number[u] < 0:
                    straight = False
                    number[u] = places
                    queue[places] = u
                    places += 1
        in_order[k] = straight
        first_place[k + 1] = first_place[k] + places
        base = first_place[k] + k
        for u in range(places + 1):
            leaving[base + u] = 0
        for p in range(begin, end):
            own_tail[p] = number[tail[p]]
            own_head[p] = number[head[p]]
        used = base + places + 1
        if end > begin:
            if number[origin[k]] >= 0:
                source[k] = _own(number, queue, places, origin[k])
            if number[destination[k]] >= 0:
                sink[k] = _own(number, queue, places, destination[k])
        # Sort by head, counting; pairs of a head keep their order by time.
        for p in range(begin, end):
            leaving[base + own_head[p]] += 1
        at = begin
        for u in range(places + 1):
            own = leaving[base + u]
            leaving[base + u] = at
            at += own
        if straight:
            for i in range(begin, end):
                p = by_time[i]
                order[leaving[base + own_head[p]]] = p
                leaving[base + own_head[p]] += 1
        else:
            for i in range(begin, end):
                order[i] = by_time[i]
        # Pairs of a tail lie side by side.
        for u in range(places):
            u_begin = begins[queue[u]]
            stands = begin <= u_begin < end and tail[u_begin] == queue[u]
            leaving[base + u] = u_begin if stands else end
        leaving[base + places] = end
    return used


@compiled
def _own(number: Ints, queue: Ints, places: int, node: int) -> int:
    """Return the number of a node if it is of this truck: nodes keep numbers of trucks before."""
    at = int(number[node])
    return at if at < places and queue[at] == node else -1
