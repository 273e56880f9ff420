"""From lawful timetables in whole seconds to the record of a plan, with its pauses.

A leg of the plan begins at a whole second where its company changes and where somebody has waited
or paused; within it lanes follow each other without a stop, so that it ends a little before its
whole seconds are over.

How long a trip alone stands is told as it would be written so: beside its breaks and rests it
stands the parts of seconds that its driving before them was rounded up by. A vehicle waits for what
it stands longer.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ...network.placed import access_of, network_below
from ...planning.billing import with_bill
from ...planning.legal.cut_at_pauses import CutPlan, Driven, plan_with_days
from ...planning.timing.days import pauses_of
from ...plans.plan import Plan
from ...plans.proof import Proof
from ...plans.timetable import Timetable, VehicleTimes
from ...plans.zones import clock_of
from ..lanes import TICK_S
from ..model import FleetModel
from ..written import untimed_plan
from .driven import Scheduled

__all__ = ["instants_of", "lawful_plan", "longer_s"]

Ints = NDArray[np.int64]
Span = tuple[float, float]

TICKS = round(1 / TICK_S)
"""Ticks of a second."""


def instants_of(model: FleetModel, schedules: Sequence[Scheduled]) -> list[Ints]:
    """Return when each truck enters its lanes.

    Who enters a lane with others but stands within it, or they do, is not with them there: it is
    told to enter some ticks later.

    Parameters
    ----------
    model : FleetModel
        The problem.
    schedules : sequence of Scheduled, (N,)
        What each drives.

    Returns
    -------
    list of ndarray of int64, (N, ...)
        Ticks.
    """
    company: dict[tuple[int, tuple[int, ...]], list[int]] = {}
    for k, own in enumerate(schedules):
        for key in own.entries():
            company.setdefault(key, []).append(k)
    # Of several companies that enter a lane in one second, the first by its instants is on time.
    later: dict[tuple[int, tuple[int, ...]], int] = {}
    seen: dict[tuple[int, int], int] = {}
    for key in sorted(company):
        lane, moments = key
        later[key] = seen.get((lane, moments[0]), 0)
        seen[lane, moments[0]] = later[key] + 1
    found = []
    for own in schedules:
        way = own.way
        at: list[int] = []
        before, stood, ends = None, True, 0
        for place, key in enumerate(own.entries()):
            begin, end = way.first_hop[place : place + 2].tolist()
            moments = own.leaves[begin:end].tolist()
            drive_s = way.road.drive_s[begin:end].tolist()
            goes_on = company[key] == before and not stood and moments[0] == ends and not later[key]
            stands = any(after > moments[k] + drive_s[k] for k, after in enumerate(moments[1:]))
            if goes_on and not stands:
                at.append(at[-1] + int(model.instance.drive[int(own.way.lanes[place - 1])]))
            else:
                at.append(moments[0] * TICKS + later[key])
            before, stood, ends = company[key], stands, moments[-1] + drive_s[-1]
        found.append(np.array(at, np.int64))
    return found


def lawful_plan(
    model: FleetModel,
    schedules: Sequence[Scheduled],
    departs: Sequence[Ints],
    alone: Sequence[Scheduled],
    proof: Proof,
) -> Plan:
    """Return the plan of lawful timetables.

    Parameters
    ----------
    model : FleetModel
        The problem, with its law.
    schedules : sequence of Scheduled, (N,)
        What each drives.
    departs : sequence of ndarray of int64, (N, ...)
        When each enters its lanes, of `instants_of` [ticks].
    alone : sequence of Scheduled, (N,)
        The lawful trip of each alone.
    proof : Proof
        What is proved of its cost.

    Returns
    -------
    Plan
        With its timetable, breaks and rests in it, and with its bill if costs are money.
    """
    legal, problem = model.legal, model.question.problem
    assert legal is not None
    plan, routes, _ = untimed_plan(model, [own.way.lanes for own in schedules], departs, proof)
    driven = []
    for own, rules in zip(schedules, legal.rules, strict=True):
        assert own.trip is not None
        driven.append(Driven(own.way.points, own.trip, rules))
    cut = plan_with_days(plan, legal.question.net, routes, driven)
    trips = tuple(
        replace(trip, alone=replace(trip.alone, paused_s=_stands_alone(model, k, own)))
        for k, (trip, own) in enumerate(zip(cut.plan.trips, alone, strict=True))
    )
    table = _timetable(model, cut, schedules, driven)
    named = replace(table, rules=problem.rules.name, task_relief=problem.task_relief)
    whole = replace(cut.plan, trips=trips, timetable=named)
    return with_bill(whole, problem.objective, network_below(model.question.net))


def longer_s(plan: Plan) -> float:
    """Return how much longer vehicles stand on their ways than on their lawful trips alone.

    Parameters
    ----------
    plan : Plan
        Of `lawful_plan`.

    Returns
    -------
    float
        Of all together [s]; who stands less than alone has waited for nothing, and gains nothing.
    """
    return sum(
        max(0.0, times.waiting_s - trip.alone.paused_s)
        for trip, times in zip(plan.trips, plan.times, strict=True)
        if times is not None
    )


def _stands_alone(model: FleetModel, k: int, own: Scheduled) -> float:
    """Return how long a trip alone stands on its way, as a timetable would tell it [s].

    Its legs end at pauses, and where it joins or leaves the road.
    """
    assert own.trip is not None
    first, road, points = model.lanes.first_edge, own.way.road, own.way.points
    edges = np.concatenate(
        [model.lanes.edges[first[one] : first[one + 1]] for one in own.way.lanes.tolist()]
    )
    drive_s = model.question.fleet.drive_s((k,))[edges]
    before_s = np.concatenate([[0.0], np.cumsum(drive_s), [0.0]])
    beside = access_of(model.question.net, edges)
    ends = [points.index_of(int(at)) for at in np.flatnonzero(beside[1:] != beside[:-1]) + 1]
    ends += [pause.point for pause in own.trip.pauses]
    if not ends:
        return 0.0
    last = points.points[max(ends)]
    part_s = last.share * drive_s[last.at] if last.share else 0.0
    rounded_s = float(road.drive_s[: max(ends)].sum()) - before_s[last.at] - part_s
    return float(own.trip.paused_s + rounded_s)


def _timetable(
    model: FleetModel, cut: CutPlan, schedules: Sequence[Scheduled], driven: Sequence[Driven]
) -> Timetable:
    """Return when each drives its legs, and its pauses between them."""
    legs = [
        _legs(cut.plan, way, points, own)
        for way, points, own in zip(cut.plan.ways, cut.points, schedules, strict=True)
    ]
    shift = math.floor(min(spans[0][0] for spans in legs))
    vehicles = []
    for trip, spans, day, one, window in zip(
        cut.plan.trips, legs, cut.days, driven, model.windows, strict=True
    ):
        own = tuple((begin - shift, end - shift) for begin, end in spans)
        asked = window.moved(shift)
        drivers = tuple(replace(each, state_at_s=each.state_at_s - shift) for each in day.drivers)
        vehicles.append(
            VehicleTimes(
                trip.vehicle, min(one.trip.departure_s - shift, own[0][0]), own, asked.earliest,
                asked.latest, asked.arrival, pauses_of(own, day.stands), drivers,
            )
        )  # fmt: skip
    shown = clock_of(model.first, shift, (at for one in vehicles for at in one.moments))
    in_time = not any(times.late_s for times in vehicles)
    return Timetable(shown.start.isoformat(), in_time, tuple(vehicles), shown.name, shown.offsets)


def _legs(plan: Plan, way: Sequence[int], points: Sequence[int], own: Scheduled) -> list[Span]:
    """Return when a truck drives its legs; they begin at points, or as the one before ends."""
    found: list[Span] = []
    leaves = own.leaves.tolist()
    at = float(leaves[0])
    for k, point in zip(way, points, strict=True):
        begin = max(at, float(leaves[point]))
        at = begin + plan.stretches[k].drive_s
        found.append((begin, at))
    return found
