"""When everyone drives, so that those who merge are there together: exact for given routes.

With t_p the start [s] of piece p (`pieces.py`) and d_p its driving time [s], a vehicle that drives
p and then q needs

    t_q = t_p + d_p    if nobody joins where q begins,
    t_q >= t_p + d_p   if somebody does; the difference is waiting on the road [s].

With e, l and a a vehicle's earliest departure, latest departure and latest arrival [s], p its
first piece and z its last: t_p >= e; t_p <= l, unless it merges at its very origin, where it
leaves by l and waits; t_z + d_z <= a + L, with its lateness L >= 0. What is linear in t and L is
minimised in turn, each under the least values of those before:

1. the largest L,
2. the sum of all L,
3. the sum of all waiting, so departures are shifted before anyone waits,
4. the sum of all arrivals; in a group of vehicles that drive together and name latest times only,
   the negative sum: such a group arrives just in time,
5. the sum of all t, which settles at which of several points the waiting happens.

A group of vehicles that names no time at all leaves at the earliest moment the plan names.
The model is ours.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from ...plans.clock import late_by
from ...plans.plan import Plan
from ...plans.text_table import listed
from ...plans.timetable import LATE_S, Timetable, VehicleTimes
from ...plans.trip import Trip, check_one_clock
from ...plans.zones import clock_of
from .days import Day, demand_days, pauses_of, stands_before, until_moments, windows_within
from .limits import Window, first_named, windows_of
from .pieces import Pieces, pieces_of
from .programme import Programme

__all__ = ["ROUTES_GIVEN", "schedule", "settled", "solved", "with_times"]

ROUTES_GIVEN = "cost chose among what the clock allows, and the times are exact for these routes"

SLACK_S = 1e-5
"""How far a later aim may move an earlier one from its least value [s]."""

NEAR_S = 0.005
"""Times of the solver this near to a bound are meant to be at it [s]."""

LONGEST_PATIENCE_S = 1e8
"""Who would wait for years waits for ever; no driver is told a day for it [s]."""

Floats = NDArray[np.float64]
Row = dict[int, float]


def with_times(
    plan: Plan,
    trips: Sequence[Trip],
    patience_s: float | None = None,
    days: Sequence[Day] | None = None,
) -> Plan:
    """Return a plan with its timetable; the plan itself if no trip names a time.

    Parameters
    ----------
    plan : Plan
        Without times.
    trips : sequence of Trip
        Those of the plan's vehicles, by name.
    patience_s : float, optional
        As in `schedule`.
    days : sequence of Day, (N,), optional
        As in `schedule`.

    Returns
    -------
    Plan
        The same routes; remarks tell who is late.
    """
    timetable = schedule(plan, trips, patience_s, days)
    if timetable is None:
        return plan
    return replace(
        plan,
        timetable=timetable,
        proof=replace(plan.proof, conditions=(*plan.proof.conditions, ROUTES_GIVEN)),
        remarks=(*plan.remarks, *_lateness(plan, timetable)),
    )


def _lateness(plan: Plan, timetable: Timetable) -> Iterator[str]:
    alone: list[str] = []
    joined: list[str] = []
    for trip, times in zip(plan.trips, timetable.vehicles, strict=True):
        if times.late_s:
            first, latest = times.earliest_departure_s, times.latest_arrival_s
            late_alone = first is not None and latest is not None and (
                times.late_s <= first + trip.alone.time_s - latest + LATE_S
            )  # fmt: skip
            (alone if late_alone else joined).append(f"{times.vehicle} by {late_by(times.late_s)}")
    if alone:
        yield (
            f"not feasible in time: late even alone: {listed(alone)}; give earlier departures "
            "or later arrivals"
        )
    if joined:
        yield (
            f"not feasible in time: late are at best {listed(joined)}; give earlier departures, "
            "later arrivals, or other company"
        )


def schedule(
    plan: Plan,
    trips: Sequence[Trip],
    patience_s: float | None = None,
    days: Sequence[Day] | None = None,
    alone_s: Sequence[float] | None = None,
) -> Timetable | None:
    """Return when everyone drives; None if no trip names a time.

    Parameters
    ----------
    plan : Plan
        Without times.
    trips : sequence of Trip
        Those of the plan's vehicles, by name.
    patience_s : float, optional
        How far company may move a vehicle without a window [s]; see `timing.limits`. Without it
        only the windows that trips name count.
    days : sequence of Day, (N,), optional
        What driving rules ask of each vehicle; seconds count from the first time that trips name.
    alone_s : sequence of float, (N,), optional
        How long each would take alone [s], breaks and rests included; by default its driving time.

    Returns
    -------
    Timetable or None
        The best times for these routes, as the module's text says.

    Raises
    ------
    ScenarioError
        Times with and without a zone, a vehicle without its trip, or legs that do not fit together.
    """
    check_one_clock(trips)
    first = first_named(trips)
    if first is None:
        return None
    known = {trip.vehicle: trip for trip in trips}
    for vehicle in plan.vehicles:
        if vehicle.vehicle not in known:
            raise ScenarioError(f"schedule: vehicle {vehicle.vehicle!r} has no trip; give it one")
    asked, windows = windows_of(
        [known[trip.vehicle] for trip in plan.trips],
        [trip.alone.time_s for trip in plan.trips] if alone_s is None else alone_s,
        patience_s,
        first,
    )
    settled_days = [Day()] * len(plan.trips) if days is None else list(days)
    windows = windows_within(windows, settled_days)
    pieces = pieces_of(
        plan.stretches, plan.ways,
        until_moments(settled_days, plan.ways), stands_before(settled_days, plan.ways),
    )  # fmt: skip
    model = Programme(pieces, windows, asked)
    demand_days(model, pieces, settled_days)
    starts = solved(model)
    # Seconds count from the whole second at or before the first departure.
    leaving = (w.leaves(starts[way[0]]) for w, way in zip(windows, pieces.ways, strict=True))
    shift = math.floor(min(leaving) + NEAR_S)
    asked, windows = ([window.moved(shift) for window in some] for some in (asked, windows))
    spans = settled(pieces, windows, starts - shift)
    vehicles = tuple(
        VehicleTimes(
            vehicle.vehicle,
            window.leaves(spans[way[0]][0]),
            tuple(spans[piece] for piece in way),
            own.earliest, own.latest, own.arrival,
            pauses_of([spans[piece] for piece in way], day.stands),
            tuple(replace(one, state_at_s=one.state_at_s - shift) for one in day.drivers),
        )
        for vehicle, window, own, way, day in zip(
            plan.vehicles, windows, asked, pieces.ways, settled_days, strict=True
        )
    )  # fmt: skip
    in_time = not any(times.late_s for times in vehicles)
    # By the clocks of the zone that is named first, as far as times are shown.
    shown = clock_of(first, shift, (at for times in vehicles for at in times.moments))
    patience = None if patience_s is None or patience_s > LONGEST_PATIENCE_S else patience_s
    return Timetable(
        shown.start.isoformat(), in_time, vehicles, shown.name, shown.offsets, patience
    )


# -- the linear programme --------------------------------------------------------------------------


def solved(model: Programme) -> Floats:
    """Return the start of each piece, right but for the last digits.

    Parameters
    ----------
    model : Programme
        What is demanded; the least values of its aims are added to it.

    Returns
    -------
    ndarray of float
        Seconds.

    Raises
    ------
    ScenarioError
        Demands that no times meet.
    """
    from scipy.optimize import linprog

    pieces = model.pieces
    values: Floats = np.zeros(model.size)
    for aim in model.aims():
        if not aim.any():
            continue
        rows, limits = model.demands()
        found = linprog(aim, rows, limits, bounds=model.bounds, method="highs")
        if found.x is None:
            raise ScenarioError(
                f"schedule: the solver found no times ({found.message}); check the times of the "
                "trips"
            )
        values = found.x
        model.limit(
            {k: aim[k] for k in np.flatnonzero(aim).tolist()}, float(aim @ values) + SLACK_S
        )
    return np.array([values[piece.root] + piece.offset_s for piece in pieces.pieces])


def settled(pieces: Pieces, windows: Sequence[Window], starts: Floats) -> list[tuple[float, float]]:
    """Return start and end of each piece, so that all that should be equal is so to the last digit.

    The solver's times hold to about 1e-7 s: those near a bound are put there, others are
    rounded to milliseconds.

    Parameters
    ----------
    pieces : Pieces
        In an order of time.
    windows : sequence of Window, (N,)
        What is demanded of each vehicle.
    starts : ndarray of float
        As the solver gave them [s].

    Returns
    -------
    list of (float, float)
        Start and end of each piece [s].
    """
    spans: list[tuple[float, float]] = []
    for k, piece in enumerate(pieces.pieces):
        if piece.root != k:
            begin = spans[piece.before[0]][1] + piece.stands_s[0]
        else:
            ready = zip(piece.before, piece.stands_s, strict=True)
            low = [spans[last][1] + stands for last, stands in ready]
            own = [windows[index] for index in piece.begins]
            low += [window.earliest for window in own if window.earliest is not None]
            least = max(low, default=-math.inf)
            near = [least, *(window.latest for window in own if window.latest is not None)]
            at = float(starts[k])
            # Rounded down, or those who wait for it would wait for the rounding.
            rounded = math.floor(at * 1e3 + 0.1) / 1e3
            begin = next((one for one in near if abs(one - at) < NEAR_S), rounded)
            begin = max(begin, least)
        spans.append((begin, begin + piece.time_s))
    return spans
