"""Stretches cut where their vehicles may stop, and plans cut where they do.

A vehicle may stop where it can leave the road it is on: at a junction, where another edge begins.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from ...costs.share import Share
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...plans.records import Stretch
from .on_the_spot import edge_times

__all__ = ["Cut", "cut_plan", "stops_within"]

MOST_STOPS = 40
"""Of more junctions within a stretch every second, third and so on is one to stop at."""

Cut = Mapping[int, Sequence[int]]
"""For some stretches, before which of their edges they are cut."""


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
    cuts : mapping of int to sequence of int
        For some stretches, before which of their edges they are cut.

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
    return replace(plan, stretches=tuple(stretches), ways=ways, events=events)


def _pieces(net: RoadNetwork, stretch: Stretch, cuts: Sequence[int]) -> list[Stretch]:
    if not cuts:
        return [stretch]
    bounds = [0, *sorted(cuts), len(stretch.edges)]
    begin, end = stretch.span
    lengths = net.length_m[list(stretch.edges)].tolist()
    lengths[0] *= 1 - begin
    lengths[-1] *= end
    whole = sum(lengths)
    times = edge_times(net, stretch)
    found = []
    for first, after in pairwise(bounds):
        share = sum(lengths[first:after]) / whole if whole else 1 / (len(bounds) - 1)
        edges = stretch.edges[first:after]
        inferred = net.inferred[list(edges)].tolist()
        found.append(
            replace(
                stretch,
                edges=edges,
                length_m=stretch.length_m * share,
                drive_s=times[after - 1][1] - times[first][0],
                shares=tuple(_part(one, share) for one in stretch.shares),
                inferred_m=sum(
                    metres
                    for metres, is_inferred in zip(lengths[first:after], inferred, strict=True)
                    if is_inferred
                ),
                span=(begin if first == 0 else 0.0, end if after == len(lengths) else 1.0),
            )
        )
    return found


def _part(share: Share, of: float) -> Share:
    return Share(
        share.cost * of,
        None if share.alone_cost is None else share.alone_cost * of,
        share.fuel_l * of,
        share.alone_fuel_l * of,
        None if share.money is None else share.money * of,
    )
