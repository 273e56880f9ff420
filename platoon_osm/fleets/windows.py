"""Which truck may enter which lane, and when: windows, and pairs that no optimal plan needs.

With T the quickest times, a truck from o to g with window [e, l] may enter lane (u, v) from
e + T(o, u) to l - T(v, g) - drive, and out of its origin until its latest departure. On free routes
some pairs are then dropped, round by round: price a pair at member - h if another truck's window
for the lane overlaps it (h is what a leader saves), else at alone; drop it if the truck's cheapest
way through it costs no less than its way alone, unless it lies on that. A plan with such a pair
costs no less once its truck drives alone instead: whom it leaves loses at most h a lane, and a
platoon of fewer has no more price; whoever it meets on its own way gains. `docs/certificate.md` has
the whole argument, and `inspection.certificate` works the pairs out anew.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..search.hierarchy.runtime.jit import compiled
from .instance import Instance
from .lanes import Lanes

__all__ = ["ROUNDS", "Wanted", "paired"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]

ROUNDS = 4
"""Rounds of dropping pairs at most; the fourth drops few."""

TOGETHER = 256
"""Trucks whose quickest times are held at once."""

FAR = 1 << 60


@dataclass(frozen=True, slots=True, eq=False)
class Wanted:
    """What trucks ask for, in whole numbers; nodes are positions in `Lanes.nodes`.

    Attributes
    ----------
    origin, destination : ndarray of int64, (N,)
        Nodes.
    earliest, latest_departure, latest : ndarray of int64, (N,)
        Windows [ticks].
    alone : sequence of ndarray of int64, (N, ...)
        Lanes of each truck's cheapest route alone that is in time.
    """

    origin: Ints
    destination: Ints
    earliest: Ints
    latest_departure: Ints
    latest: Ints
    alone: Sequence[Ints]


def paired(
    lanes: Lanes,
    wanted: Wanted,
    *,
    given: bool,
    largest: int,
    waiting: int = 0,
    whole: Sequence[int] = (),
) -> tuple[Instance, int]:
    """Return the instance of some trucks on some lanes.

    Parameters
    ----------
    lanes : Lanes
        The network.
    wanted : Wanted
        The trucks.
    given : bool
        Whether each keeps its route alone.
    largest : int
        Vehicles of the largest platoon; 0 for any.
    waiting : int
        Price of waiting on the road [grains a tick].
    whole : sequence of int
        Trucks that keep all their pairs, also those that no best plan needs.

    Returns
    -------
    instance : Instance
        With its pairs.
    rounds : int
        Rounds of dropping pairs that were done.
    """
    on_route = np.repeat(np.arange(len(wanted.alone)), [len(route) for route in wanted.alone])
    route_lane = np.concatenate([*wanted.alone, np.zeros(0, np.int64)]).astype(np.int64)
    cost = np.zeros(len(wanted.origin), np.int64)
    np.add.at(cost, on_route, lanes.alone[route_lane])
    if given:
        truck, lane, opens, closes = _of_routes(lanes, wanted)
        on_alone = np.ones(len(lane), bool)
    else:
        truck, lane, opens, closes = _in_time(lanes, wanted)
        on_alone = np.isin(truck * len(lanes.tail) + lane, on_route * len(lanes.tail) + route_lane)
    done = 0
    while not given and done < ROUNDS:
        keep = _needed(lanes, wanted, cost, truck, lane, opens, closes, on_alone)
        keep |= np.isin(truck, whole)
        done += 1
        if keep.all():
            break
        truck, lane, opens, closes, on_alone = (
            column[keep] for column in (truck, lane, opens, closes, on_alone)
        )
    order = np.lexsort((lane, lanes.tail[lane], truck))
    instance = Instance(
        nodes=len(lanes.nodes),
        tail=lanes.tail, head=lanes.head, drive=lanes.drive, alone=lanes.alone,
        member=lanes.member, extra=lanes.extra, lane_kind=lanes.lane_kind,
        origin=wanted.origin, destination=wanted.destination, earliest=wanted.earliest,
        latest_departure=wanted.latest_departure, latest=wanted.latest, kind=lanes.kind,
        largest=largest, given=given, waiting=waiting,
        first_pair=np.searchsorted(truck[order], np.arange(len(cost) + 1)),
        pair_truck=truck[order], pair_lane=lane[order], opens=opens[order], closes=closes[order],
        on_alone=on_alone[order], alone_cost=cost,
    )  # fmt: skip
    return instance, done


def _of_routes(lanes: Lanes, wanted: Wanted) -> tuple[Ints, Ints, Ints, Ints]:
    """Return truck, lane and window of all lanes of the routes."""
    columns = []
    for k, route in enumerate(wanted.alone):
        before = np.concatenate([[0], np.cumsum(lanes.drive[route])])
        opens = wanted.earliest[k] + before[:-1]
        closes = wanted.latest[k] - (before[-1] - before[:-1])
        closes[0] = min(closes[0], wanted.latest_departure[k])
        columns.append((np.full(len(route), k), route, opens, closes))
    truck, lane, opens, closes = (np.concatenate(column) for column in zip(*columns, strict=True))
    return truck, lane, opens, closes


def _in_time(lanes: Lanes, wanted: Wanted) -> tuple[Ints, Ints, Ints, Ints]:
    """Return truck, lane and window of all that is in time."""
    found: list[tuple[Ints, Ints, Ints, Ints]] = []
    for kind in np.unique(lanes.kind).tolist():
        own = np.flatnonzero(lanes.lane_kind == kind)
        trucks = np.flatnonzero(lanes.kind == kind)
        tail, head, drive = lanes.tail[own], lanes.head[own], lanes.drive[own]
        there, back = _Quickest(lanes, own, True), _Quickest(lanes, own, False)
        for begin in range(0, len(trucks), TOGETHER):
            some = trucks[begin : begin + TOGETHER]
            origin, destination = wanted.origin[some], wanted.destination[some]
            opens = wanted.earliest[some, None] + there.times(origin)[:, tail]
            closes = wanted.latest[some, None] - back.times(destination)[:, head] - drive
            first = tail[None, :] == origin[:, None]
            departs = wanted.latest_departure[some, None]
            closes = np.where(first, np.minimum(closes, departs), closes)
            row, column = np.nonzero(opens <= closes)
            found.append((some[row], own[column], opens[row, column], closes[row, column]))
    truck, lane, opens, closes = (np.concatenate(column) for column in zip(*found, strict=True))
    order = np.argsort(truck, kind="stable")
    return truck[order], lane[order], opens[order], closes[order]


class _Quickest:
    """Quickest times over some lanes, from or to nodes."""

    def __init__(self, lanes: Lanes, own: Ints, forward: bool) -> None:
        from scipy.sparse import csr_array

        count = len(lanes.nodes)
        tail, head = (lanes.tail, lanes.head) if forward else (lanes.head, lanes.tail)
        # Of parallel lanes the quickest: the last written of a descending order stays.
        order = own[np.argsort(-lanes.drive[own], kind="stable")]
        key = tail[order] * count + head[order]
        _, last = np.unique(key[::-1], return_index=True)
        best = order[::-1][last]
        self._graph = csr_array(
            (lanes.drive[best].astype(np.float64), (tail[best], head[best])), shape=(count, count)
        )

    def times(self, nodes: Ints) -> Ints:
        """Return the times of all nodes, one row for each of some [ticks]."""
        from scipy.sparse.csgraph import dijkstra

        each, rows = np.unique(nodes, return_inverse=True)
        found = dijkstra(self._graph, indices=each)
        return np.where(np.isfinite(found), found, FAR).astype(np.int64)[rows]


def _needed(
    lanes: Lanes,
    wanted: Wanted,
    cost: Ints,
    truck: Ints,
    lane: Ints,
    opens: Ints,
    closes: Ints,
    on_alone: Marks,
) -> Marks:
    """Mark the pairs that an optimal plan may need; see the module's text."""
    meets = np.zeros(len(lane), bool)
    order = np.lexsort((opens, lane))
    _mark_overlaps(lane[order], opens[order], closes[order], order, meets)
    least = 2 * lanes.member + lanes.extra - lanes.alone
    price = np.where(meets, least[lane], lanes.alone[lane])
    first = np.searchsorted(truck, np.arange(len(cost) + 1))
    # In the order in which lanes open, a forward pass sees nearly every way at once.
    by_time = np.lexsort((opens, truck))
    through = np.empty(len(lane), np.int64)
    _cost_through(
        first, by_time, lane, lanes.tail, lanes.head, price, wanted.origin, wanted.destination,
        len(lanes.nodes), through,
    )  # fmt: skip
    return on_alone | (through < cost[truck])


@compiled
def _mark_overlaps(lane: Ints, opens: Ints, closes: Ints, order: Ints, meets: Marks) -> None:
    """Mark windows that overlap another of their lane; sorted by lane and opening."""
    last, until, at = -1, 0, -1
    for i in range(len(lane)):
        if lane[i] != last:
            last, until, at = lane[i], closes[i], i
            continue
        if opens[i] <= until:
            meets[order[i]] = True
            # Whoever lasts longest of those before overlaps it too.
            meets[order[at]] = True
        if closes[i] > until:
            until, at = closes[i], i


@compiled
def _cost_through(
    first: Ints,
    order: Ints,
    lane: Ints,
    tail: Ints,
    head: Ints,
    price: Ints,
    origin: Ints,
    destination: Ints,
    nodes: int,
    through: Ints,
) -> None:
    """Work out the cheapest way of each truck through each of its pairs."""
    far = np.int64(1 << 60)
    there = np.full(nodes, far, np.int64)
    onward = np.full(nodes, far, np.int64)
    for k in range(len(origin)):
        begin, end = first[k], first[k + 1]
        for i in range(begin, end):
            one = lane[order[i]]
            there[tail[one]] = there[head[one]] = far
            onward[tail[one]] = onward[head[one]] = far
        there[origin[k]] = 0
        onward[destination[k]] = 0
        changed = True
        while changed:
            changed = False
            for i in range(begin, end):
                p = order[i]
                u, v = tail[lane[p]], head[lane[p]]
                if there[u] + price[p] < there[v]:
                    there[v] = there[u] + price[p]
                    changed = True
        changed = True
        while changed:
            changed = False
            for i in range(end - 1, begin - 1, -1):
                p = order[i]
                u, v = tail[lane[p]], head[lane[p]]
                if onward[v] + price[p] < onward[u]:
                    onward[u] = onward[v] + price[p]
                    changed = True
        for p in range(begin, end):
            through[p] = there[tail[lane[p]]] + price[p] + onward[head[lane[p]]]
