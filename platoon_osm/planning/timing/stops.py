"""Stretches cut where their vehicles may stop, and plans cut where they do.

A vehicle may stop where it can leave the road it is on: at a junction, where another edge begins,
or at a stop beside the road, which may lie anywhere on an edge.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...plans.records import Stretch
from .on_the_spot import edge_times

__all__ = ["Cut", "Place", "cut_plan", "stops_within", "time_to"]

Floats = NDArray[np.float64]

MOST_STOPS = 40
"""Of more junctions within a stretch every second, third and so on is one to stop at."""

Place = tuple[int, float]
"""A place within a stretch: a position among its edges, and how much of that edge, by length, lies
before it; 0 at the junction where the edge begins, never 1."""

Cut = Mapping[int, Sequence[Place]]
"""For some stretches, where they are cut."""


def stops_within(net: RoadNetwork, stretch: Stretch) -> list[int]:
    """Return where the vehicles of a stretch may stop on it.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges it names.
    stretch : Stretch
        Of a plan.

    Returns
    -------
    list of int
        Positions of edges before which they may, ascending.
    """
    found = [
        place + 1
        for place, edge in enumerate(stretch.edges[:-1])
        if net.first_out[net.head[edge] + 1] - net.first_out[net.head[edge]] > 1
    ]
    return found[:: -(-len(found) // MOST_STOPS)] if found else []


def cut_plan(net: RoadNetwork, plan: Plan, cuts: Cut) -> Plan:
    """Return a plan whose stretches are cut.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges it names.
    plan : Plan
        Without times.
    cuts : mapping of int to sequence of (int, float)
        For some stretches, at which places they are cut.

    Returns
    -------
    Plan
        The same journeys. What a stretch costs is shared among its pieces by their lengths.
    """
    stretches: list[Stretch] = []
    places: list[range] = []
    for number, stretch in enumerate(plan.stretches):
        pieces = _pieces(net, stretch, cuts.get(number, ()))
        places.append(range(len(stretches), len(stretches) + len(pieces)))
        stretches += pieces
    ways = tuple(tuple(piece for k in way for piece in places[k]) for way in plan.ways)
    events = tuple(
        replace(event, stretch=places[event.stretch][0 if event.kind == "merge" else -1])
        for event in plan.events
    )
    rotation = plan.rotation
    if rotation is not None:
        changes = (replace(one, stretch=places[one.stretch][0]) for one in rotation.changes)
        rotation = replace(rotation, changes=tuple(changes))
    return replace(plan, stretches=tuple(stretches), ways=ways, events=events, rotation=rotation)


def time_to(net: RoadNetwork, stretch: Stretch, place: Place) -> float:
    """Return how long after its start the vehicles of a stretch are at a place.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges it names.
    stretch : Stretch
        Of a plan.
    place : (int, float)
        Within it.

    Returns
    -------
    float
        Driving time [s].
    """
    at, share = place
    begin, end = edge_times(net, stretch)[at]
    first = stretch.span[0] if at == 0 else 0.0
    last = stretch.span[1] if at == len(stretch.edges) - 1 else 1.0
    return begin + (end - begin) * max(0.0, share - first) / (last - first)


def _pieces(net: RoadNetwork, stretch: Stretch, cuts: Sequence[Place]) -> list[Stretch]:
    if not cuts:
        return [stretch]
    last = len(stretch.edges) - 1
    bounds = [(0, stretch.span[0]), *sorted(cuts), (last, stretch.span[1])]
    lengths = net.length_m[list(stretch.edges)]
    whole = sum(_driven_m(lengths, (0, stretch.span[0]), (last, stretch.span[1])))
    times = [0.0, *(time_to(net, stretch, one) for one in bounds[1:-1]), stretch.drive_s]
    found = []
    for (begin, end), (starts, ends) in zip(pairwise(bounds), pairwise(times), strict=True):
        driven = _driven_m(lengths, begin, end)
        share = sum(driven) / whole if whole else 1 / (len(bounds) - 1)
        # A piece that ends where an edge begins does not have that edge.
        first, after = begin[0], end[0] + (end[1] > 0)
        edges = stretch.edges[first:after]
        inferred = net.inferred[list(edges)].tolist()
        found.append(
            replace(
                stretch,
                edges=edges,
                length_m=stretch.length_m * share,
                drive_s=ends - starts,
                shares=tuple(one.part(share) for one in stretch.shares),
                inferred_m=sum(
                    metres
                    for metres, is_inferred in zip(driven, inferred, strict=True)
                    if is_inferred
                ),
                span=(begin[1], end[1] if end[1] > 0 else 1.0),
            )
        )
    return found


def _driven_m(lengths: Floats, begin: Place, end: Place) -> list[float]:
    """Return how much of each edge from one place to another is driven [m]."""
    some: list[float] = lengths[begin[0] : end[0] + (end[1] > 0)].tolist()
    if end[1] > 0:
        some[-1] *= end[1]
    if begin[0] == end[0]:
        some[0] = float(lengths[begin[0]]) * (end[1] - begin[1])
    else:
        some[0] *= 1 - begin[1]
    return some
