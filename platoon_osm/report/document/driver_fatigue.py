"""Fatigue of a driver along a journey, alone and as planned, by hours of driving.

The curves are read by driving time alone, and the time of day is left out, for not every plan has
one. What a driver does in a platoon is taken as in the paper: the driving clock stands. So it does
while a driver waits; after a break, or so much of a rest, it runs from 0.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...costs.fatigue import FITTED_RANGE_S, FatigueModel, driving_clock
from ...plans.timetable import VehicleTimes
from ...plans.vehicles import VehiclePlan
from .model_day import Fatigue, FatigueCurve
from .stands import stands_of

__all__ = ["fatigue_along"]

MODEL = FatigueModel("monotone", task_relief=1.0)
STEP_S = 900.0

BREAK_S = 2700.0
"""So long a break is; who rests longer is as fresh from then on [s]."""


def fatigue_along(vehicle: VehiclePlan, times: VehicleTimes | None = None) -> Fatigue:
    """Return fatigue alone and as planned, and the highest of each.

    Parameters
    ----------
    vehicle : VehiclePlan
        Whose driver is meant.
    times : VehicleTimes or None
        Its times, where they are known: then hours of waiting count too.

    Returns
    -------
    Fatigue
        By hours since the departure.
    """
    alone = _curve([("solo", vehicle.alone.time_s)])
    legs: list[tuple[str, float]] = []
    stands = () if times is None else stands_of(times)
    for number, leg in enumerate(vehicle.legs):
        if times is not None:
            since = times.legs[number - 1][1] if number else times.departure_s
            here = (one for one in stands if since <= one.begin_s < times.legs[number][0])
            for one in here:
                if one.restarts:
                    legs.append(("break", min(one.lasts_s, BREAK_S)))
                if not one.restarts or one.lasts_s > BREAK_S:
                    legs.append(("wait", one.lasts_s - BREAK_S * one.restarts))
        legs.append((_role(leg.role), leg.time_s))
    joint = _curve(legs)
    return Fatigue(alone, joint, max(alone.values), max(joint.values))


def _role(role: str) -> str:
    return "platoon" if role == "platoon" else "solo"


def _curve(legs: list[tuple[str, float]]) -> FatigueCurve:
    time_s, clock_s = driving_clock(legs, MODEL.task_relief, STEP_S)
    # Beyond the range of the curves the last value is held: it can only be too low.
    values: NDArray[np.float64] = MODEL.along(np.minimum(clock_s, FITTED_RANGE_S[1]))
    return FatigueCurve(
        hours=tuple(round(float(t) / 3600, 3) for t in time_s),
        values=tuple(round(float(value), 2) for value in values),
        beyond=bool(clock_s.max() > FITTED_RANGE_S[1]),
    )
