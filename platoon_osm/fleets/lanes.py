"""Roads of a network as lanes in whole numbers, chains of edges contracted, one for each kind.

Chains end where one may turn off, and where trips start or end. A trip never gains by waiting
within a chain, for who drives a part of it drives all of it: so a lane is entered at its tail.

A tick is short enough that lanes rounded up to whole ticks shift no instant by more than
milliseconds; a grain is the largest decimal part of the unit of costs, at most a millionth, at
which all costs together stay whole in double precision.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..network.preparing.chains import contract_chains
from ..network.road_network import RoadNetwork
from ..planning.fleet import Fleet
from .company_costs import company_line

__all__ = ["TICK_S", "Lanes", "grains_per_unit", "lanes_of"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

TICK_S = 1e-4
"""A tick [s]: a hundred lanes rounded up to ticks take at most a hundredth of a second longer."""

FINEST = 1e6
"""Grains in a unit of cost at most; a millionth of a metre or of a euro is nothing to anybody."""

FINEST_WAITING = 1e12
"""The same where waiting has a price, for one tick of it has to be some grains."""

ROOM = 2.0**50
"""All costs together stay below this many grains."""


@dataclass(frozen=True, slots=True, eq=False)
class Lanes:
    """The lanes of a fleet's network; arrays as in `Instance`.

    Attributes
    ----------
    nodes : ndarray of int64, (n,)
        Nodes of the network at which lanes begin or end, ascending; lanes name their positions.
    tail, head, drive, alone, member, extra, lane_kind : ndarray of int64, (L,)
        As in `Instance`.
    first_edge : ndarray of int64, (L + 1,)
        Where the edges of each lane begin.
    edges : ndarray of int64
        Edges of the network, lane by lane in driving order.
    kind : ndarray of int64, (N,)
        The kind of each truck.
    grains : float
        Grains in a unit of cost.
    """

    nodes: Ints
    tail: Ints
    head: Ints
    drive: Ints
    alone: Ints
    member: Ints
    extra: Ints
    lane_kind: Ints
    first_edge: Ints
    edges: Ints
    kind: Ints
    grains: float

    def of_routes(self, routes: Sequence[Ints]) -> list[Ints]:
        """Return the lanes of routes of edges.

        Parameters
        ----------
        routes : sequence of ndarray of int64, (N, ...)
            Edges of the network, from one place of trips to another.

        Returns
        -------
        list of ndarray of int64, (N, ...)
            Lanes in driving order, each truck's of its own kind.
        """
        begins: dict[int, Ints] = {}
        for kind in np.unique(self.kind).tolist():
            own = np.flatnonzero(self.lane_kind == kind)
            begins[kind] = np.full(int(self.edges.max()) + 1, -1, np.int64)
            begins[kind][self.edges[self.first_edge[own]]] = own
        found = []
        for kind, route in zip(self.kind.tolist(), routes, strict=True):
            lanes = begins[kind][route]
            lanes = lanes[lanes >= 0]
            driven = np.diff(self.first_edge)[lanes].sum()
            assert driven == len(route), "routes lead from place to place, where lanes end"
            found.append(lanes)
        return found


def grains_per_unit(total: float, waits: bool = False) -> float:
    """Return into how many grains a unit of cost is cut.

    Parameters
    ----------
    total : float
        What all trucks cost alone, or anything else that is to be told in grains.
    waits : bool
        Whether waiting has a price.

    Returns
    -------
    float
        A power of ten, at most `FINEST`, or `FINEST_WAITING`.
    """
    finest = FINEST_WAITING if waits else FINEST
    return min(finest, 10.0 ** math.floor(math.log10(ROOM / max(total, 1.0))))


def lanes_of(
    net: RoadNetwork,
    fleet: Fleet,
    kinds: Sequence[int],
    ends: Sequence[int],
    largest: int,
    grains: float,
) -> Lanes:
    """Return the lanes of a fleet.

    Parameters
    ----------
    net : RoadNetwork
        The network, with the places of all trips as nodes.
    fleet : Fleet
        What edges cost each truck, which it may drive, and how long it takes.
    kinds : sequence of int, (N,)
        Which trucks may drive together; those of one number are alike in the fleet.
    ends : sequence of int
        Nodes where trips start or end.
    largest : int
        Vehicles of the largest platoon; 0 for any.
    grains : float
        Grains in a unit of cost.

    Returns
    -------
    Lanes
        Those of the first kind first.
    """
    keep = np.zeros(net.n, bool)
    keep[np.asarray(ends, np.int64)] = True
    found = [
        _of_kind(net, fleet, kinds.index(kind), keep, largest, grains)
        for kind in range(max(kinds) + 1)
    ]
    sizes = [len(columns[0]) for columns, *_ in found]
    tail, head, drive, alone, member, extra = (
        np.concatenate(column) for column in zip(*(columns for columns, *_ in found), strict=True)
    )
    nodes, places = np.unique(np.concatenate([tail, head]), return_inverse=True)
    counts = np.concatenate([np.diff(first) for _, first, _ in found])
    return Lanes(
        nodes=nodes,
        tail=places[: len(tail)],
        head=places[len(tail) :],
        drive=drive,
        alone=alone,
        member=member,
        extra=extra,
        lane_kind=np.repeat(np.arange(len(sizes)), sizes),
        first_edge=np.concatenate([[0], np.cumsum(counts)]),
        edges=np.concatenate([edges for *_, edges in found]),
        kind=np.asarray(kinds, np.int64),
        grains=grains,
    )


def _of_kind(
    net: RoadNetwork,
    fleet: Fleet,
    truck: int,
    keep: NDArray[np.bool_],
    largest: int,
    grains: float,
) -> tuple[tuple[Ints, Ints, Ints, Ints, Ints, Ints], Ints, Ints]:
    """Return the lanes of trucks like one: their columns, and the edges of each."""
    weights = fleet[truck]
    open_to = np.flatnonzero(np.isfinite(fleet.alone(truck)))
    tail, head = net.tail[open_to].astype(np.int64), net.head[open_to].astype(np.int64)
    chains = contract_chains(tail, head, net.n, keep)
    order, first = open_to[chains.segments], chains.first
    begin, end = order[first[:-1]], order[first[1:] - 1]
    member, extra = company_line(weights, largest)
    solo = weights.solo
    # Where company saves nothing, as on a way beside the road, it costs what each pays alone.
    helps = (2 * member + extra < 2 * solo) & (member < solo)
    member, extra = np.where(helps, member, solo), np.where(helps, extra, 0.0)
    drive_s = fleet.drive_s((truck,))
    sums = [np.add.reduceat(column[order], first[:-1]) for column in (drive_s, solo, member, extra)]
    own = np.rint(sums[1] * grains).astype(np.int64)
    each = np.minimum(np.rint(sums[2] * grains).astype(np.int64), own)
    once = np.clip(np.rint(sums[3] * grains).astype(np.int64), 0, own - each)
    ticks = np.maximum(1, np.ceil(sums[0] / TICK_S - 1e-6).astype(np.int64))
    loops = net.tail[begin] == net.head[end]
    stay = ~loops
    counts = np.diff(first)
    columns = (
        net.tail[begin].astype(np.int64), net.head[end].astype(np.int64), ticks, own, each, once,
    )  # fmt: skip
    a, b, c, d, e, f = (column[stay] for column in columns)
    lengths = np.concatenate([[0], np.cumsum(counts[stay])]).astype(np.int64)
    return (a, b, c, d, e, f), lengths, order[np.repeat(stay, counts)]
