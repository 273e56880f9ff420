"""From the schedules of trucks to the record of a plan, with its timetable.

What each pays is worked out anew from the objective, edge by edge, by its place in its platoon; the
whole numbers of the search decide only who drives with whom, and when.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..network.placed import access_of, network_below
from ..planning.billing import with_bill
from ..planning.company.platoons import platoons_of
from ..planning.writing import written_plan
from ..plans.fleet import FleetRecord
from ..plans.plan import Plan
from ..plans.proof import Proof
from ..plans.stretches import Run, runs_along
from ..plans.timetable import Timetable, VehicleTimes
from ..plans.zones import clock_of
from .companies import Company, companies_of
from .lanes import TICK_S
from .model import FleetModel

__all__ = ["plan_of", "untimed_plan"]

Ints = NDArray[np.int64]

NEAR_S = 1e-3
"""The start of a timetable is the whole second before the first departure, but for last digits."""


def plan_of(
    model: FleetModel,
    lanes: Sequence[Ints],
    departs: Sequence[Ints],
    proof: Proof,
    record: FleetRecord | None,
) -> Plan:
    """Return the plan of some schedules.

    Parameters
    ----------
    model : FleetModel
        The problem.
    lanes, departs : sequence of ndarray of int64, (N, ...)
        The lanes of each truck in driving order, and when it enters them [ticks].
    proof : Proof
        What is proved of its cost.
    record : FleetRecord or None
        What is known of the fleet.

    Returns
    -------
    Plan
        With its timetable, and with its bill if costs are money.
    """
    question = model.question
    plan, _, starts = untimed_plan(model, lanes, departs, proof)
    plan = plan.told(fleet=record, timetable=_timetable(model, plan, starts))
    return with_bill(plan, question.problem.objective, network_below(question.net))


def untimed_plan(
    model: FleetModel, lanes: Sequence[Ints], departs: Sequence[Ints], proof: Proof
) -> tuple[Plan, list[list[Run]], list[list[float]]]:
    """Return the plan of some schedules, without its times.

    Parameters
    ----------
    model : FleetModel
        The problem.
    lanes, departs : sequence of ndarray of int64, (N, ...)
        The lanes of each truck in driving order, and when it enters them [ticks].
    proof : Proof
        What is proved of its cost.

    Returns
    -------
    plan : Plan
        Its stretches, ways and platoons.
    routes : list of list of Run, (N, ...)
        What it was written from.
    starts : list of list of float, (N, ...)
        When each run begins [s].
    """
    question = model.question
    problem = question.problem
    together = companies_of(model.instance, lanes, departs)
    routes, starts = [], []
    for truck, (own, at) in enumerate(zip(lanes, departs, strict=True)):
        runs, begin = _runs(model, truck, own, at, together[truck])
        routes.append(runs)
        starts.append(begin)
    plan = written_plan(
        problem, question.fleet, question.ends, question.alone, routes,
        platoons_of(routes, None, "D"), [""] * len(routes), "D", proof,
    )  # fmt: skip
    return plan.told(proof=proof), routes, starts


def _runs(
    model: FleetModel, truck: int, lanes: Ints, departs: Ints, together: Sequence[Company]
) -> tuple[list[Run], list[float]]:
    """Return the runs of a truck and when each begins [s].

    They are cut where its company changes, where it waits, and where it leaves the road: ways
    beside the road are driven alone.
    """
    net, instance, first = model.question.net, model.instance, model.lanes.first_edge
    counts = np.diff(first)[lanes]
    edges = np.concatenate([model.lanes.edges[first[one] : first[one + 1]] for one in lanes])
    begins = np.concatenate([[0], np.cumsum(counts)])[:-1]
    at_lane = np.repeat(np.arange(len(lanes)), counts)
    drive_s = model.question.fleet.drive_s((truck,))[edges]
    before_s = np.concatenate([[0.0], np.cumsum(drive_s)])[:-1]
    at_s = departs[at_lane] * TICK_S + before_s - before_s[begins][at_lane]
    beside = access_of(net, edges)
    companies = [
        (truck,) if way else together[lane]
        for way, lane in zip(beside.tolist(), at_lane.tolist(), strict=True)
    ]
    cut = np.zeros(len(edges), bool)
    cut[begins[1:]] = departs[1:] > departs[:-1] + instance.drive[lanes[:-1]]
    cut[1:] |= beside[1:] | beside[:-1]
    pieces = np.concatenate([[0], np.flatnonzero(cut), [len(edges)]]).tolist()
    runs: list[Run] = []
    for begin, end in itertools.pairwise(pieces):
        runs += runs_along(edges[begin:end], companies[begin:end])
    starts = np.concatenate([[0], np.cumsum([len(run.edges) for run in runs])])[:-1]
    return runs, at_s[starts].tolist()


def _timetable(model: FleetModel, plan: Plan, starts: Sequence[Sequence[float]]) -> Timetable:
    """Return when each drives its stretches."""
    spans: dict[int, tuple[float, float]] = {}
    planned: dict[int, float] = {}
    for way, own in zip(plan.ways, starts, strict=True):
        planned.update(zip(way, own, strict=True))
    last: dict[int, float] = {}
    for k in sorted(planned, key=lambda one: (planned[one], one)):
        stretch = plan.stretches[k]
        # Sums of driving times may differ from whole ticks in their last digits.
        begin = max([planned[k], *(last[one] for one in stretch.vehicles if one in last)])
        spans[k] = (begin, begin + stretch.drive_s)
        last.update(dict.fromkeys(stretch.vehicles, spans[k][1]))
    leaves = [spans[way[0]][0] for way in plan.ways]
    shift = math.floor(min(leaves) + NEAR_S)
    vehicles = []
    for trip, way, window in zip(plan.trips, plan.ways, model.windows, strict=True):
        own_window = window.moved(shift)
        legs = tuple((spans[k][0] - shift, spans[k][1] - shift) for k in way)
        vehicles.append(
            VehicleTimes(
                trip.vehicle, legs[0][0], legs, own_window.earliest, own_window.latest,
                own_window.arrival,
            )
        )  # fmt: skip
    shown = clock_of(model.first, shift, (at for one in vehicles for at in one.moments))
    in_time = not any(times.late_s for times in vehicles)
    return Timetable(shown.start.isoformat(), in_time, tuple(vehicles), shown.name, shown.offsets)
