"""A timetable that takes the search's own moments, in whole seconds."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from ...plans.plan import Plan
from ...plans.timetable import Timetable, VehicleTimes
from ...plans.zones import clock_of
from ..timing.days import Day, pauses_of
from ..timing.limits import Window
from .cut_at_pauses import Driven
from .driver.road import FREE
from .legal_question import LegalQuestion

__all__ = ["left_at", "table_of_moments"]

Span = tuple[float, float]


def left_at(driven: Driven) -> list[int]:
    """Return when a vehicle leaves each point of its way.

    Parameters
    ----------
    driven : Driven
        Its way and its times.

    Returns
    -------
    list of int, (n,)
        Seconds; of each point but its destination.
    """
    pauses = {one.point: one for one in driven.trip.pauses}
    road = driven.way.road
    at, found = driven.trip.departure_s, []
    for point in range(road.hops):
        if point in pauses:
            at = max(at, pauses[point].end_s)
        if road.leave_s[point] != FREE:
            at = max(at, int(road.leave_s[point]))
        found.append(at)
        at += int(road.drive_s[point])
    return found


def table_of_moments(
    legal: LegalQuestion,
    plan: Plan,
    days: Sequence[Day],
    points: Sequence[Sequence[int]],
    driven: Sequence[Driven],
) -> Timetable:
    """Return the timetable of a plan that is cut at its pauses.

    Parameters
    ----------
    legal : LegalQuestion
        What was asked, with its law.
    plan : Plan
        Without times.
    days : sequence of Day, (N,)
        Where each vehicle stands.
    points : sequence of sequence of int, (N, ...)
        The point of its way at which each leg of a vehicle begins.
    driven : sequence of Driven, (N,)
        When each drives.

    Returns
    -------
    Timetable
        Legs begin at whole seconds and last as long as they are driven, less the part of a second
        by which sums are shorter.
    """
    legs: list[list[Span]] = []
    ends: dict[int, float] = {}
    for way, own, one in zip(plan.ways, points, driven, strict=True):
        left = left_at(one)
        spans: list[Span] = []
        for k, point in zip(way, own, strict=True):
            # Sums are rounded, not every leg: one may last a little longer than its whole seconds.
            begin = float(left[point])
            if spans and 0 < spans[-1][1] - begin < 1:
                spans[-1] = (spans[-1][0], begin)
            spans.append((begin, begin + plan.stretches[k].drive_s))
        if 0 < spans[-1][1] - one.trip.arrival_s < 1:
            spans[-1] = (spans[-1][0], float(one.trip.arrival_s))
        for k, (_, end) in zip(way, spans, strict=True):
            ends[k] = min(ends.get(k, end), end)
        legs.append(spans)
    legs = [
        [(begin, ends[k]) for k, (begin, _) in zip(way, spans, strict=True)]
        for way, spans in zip(plan.ways, legs, strict=True)
    ]
    shift = math.floor(min(one.trip.departure_s for one in driven))
    asked = [window.moved(shift) for window in legal.asked]
    vehicles = tuple(
        _times(trip.vehicle, own, day, one, window, shift)
        for trip, own, day, one, window in zip(plan.trips, legs, days, driven, asked, strict=True)
    )
    shown = clock_of(legal.first, shift, (at for one in vehicles for at in one.moments))
    return Timetable(
        shown.start.isoformat(), not any(one.late_s for one in vehicles), vehicles, shown.name,
        shown.offsets, legal.question.problem.patience_min * 60.0,
    )  # fmt: skip


def _times(
    name: str, legs: Sequence[Span], day: Day, driven: Driven, asked: Window, shift: float
) -> VehicleTimes:
    own = tuple((begin - shift, end - shift) for begin, end in legs)
    moved = [replace(one, state_at_s=one.state_at_s - shift) for one in day.drivers]
    return VehicleTimes(
        name, min(driven.trip.departure_s - shift, own[0][0]), own, asked.earliest, asked.latest,
        asked.arrival, pauses_of(own, day.stands), tuple(moved),
    )  # fmt: skip
