"""A finished plan, times and all, cut where the lead is handed on, and put in its new order.

A cut changes no moment: whoever is somewhere at some time is there at that time. What a stretch
costs is shared among its pieces by their lengths, as everywhere where stretches are cut.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...plans.timetable import VehicleTimes
from ..timing.stops import Place, cut_plan, time_to

__all__ = ["cut_with_times", "pieces_of_cuts"]

Cuts = Mapping[int, Sequence[Place]]


def pieces_of_cuts(count: int, cuts: Cuts) -> list[range]:
    """Return which pieces stretches become.

    Parameters
    ----------
    count : int
        How many stretches there are.
    cuts : mapping of int to sequence of (int, float)
        For some of them, where they are cut.

    Returns
    -------
    list of range
        Positions of the pieces among all.
    """
    found: list[range] = []
    first = 0
    for number in range(count):
        found.append(range(first, first + 1 + len(cuts.get(number, ()))))
        first = found[-1].stop
    return found


def cut_with_times(net: RoadNetwork, plan: Plan, cuts: Cuts) -> Plan:
    """Return a plan with or without times whose stretches are cut.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges it names.
    plan : Plan
        Any.
    cuts : mapping of int to sequence of (int, float)
        For some stretches, at which places they are cut, in driving order.

    Returns
    -------
    Plan
        The same journeys, meetings and moments.
    """
    found = cut_plan(net, replace(plan, timetable=None), cuts)
    if plan.timetable is None:
        return found
    after_s = {
        number: [time_to(net, plan.stretches[number], place) for place in places]
        for number, places in cuts.items()
    }
    vehicles = tuple(
        _times(times, way, after_s)
        for times, way in zip(plan.timetable.vehicles, plan.ways, strict=True)
    )
    return replace(found, timetable=replace(plan.timetable, vehicles=vehicles))


def _times(
    times: VehicleTimes, way: Sequence[int], after_s: Mapping[int, Sequence[float]]
) -> VehicleTimes:
    legs: list[tuple[float, float]] = []
    pieces: list[range] = []
    for number, (begin, end) in zip(way, times.legs, strict=True):
        inner = [min(begin + own, end) for own in after_s.get(number, ())]
        pieces.append(range(len(legs), len(legs) + 1 + len(inner)))
        legs += pairwise([begin, *inner, end])
    return replace(
        times,
        legs=tuple(legs),
        pauses=tuple(replace(one, before=pieces[one.before].start) for one in times.pauses),
        drivers=tuple(
            one
            if one.drives is None
            else replace(one, drives=tuple(piece for leg in one.drives for piece in pieces[leg]))
            for one in times.drivers
        ),
    )
