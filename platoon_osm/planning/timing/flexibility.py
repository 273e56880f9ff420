"""Trips that say how much longer than alone they may take: their latest arrival.

With e a trip's earliest departure, d its driving time alone and f its flexibility, it arrives by

    a = e + d + f, rounded up to the second.

So with f = 0 it may drive with others on its way, and neither wait nor go round.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime, timedelta

from ...errors import ScenarioError
from ...plans.trip import Trip

__all__ = ["with_latest_arrivals"]

SAME_S = 1e-6
"""Sums of driving times differ in their last digits; a second is not begun for them."""


def with_latest_arrivals(trips: Sequence[Trip], alone_s: Sequence[float]) -> list[Trip]:
    """Return trips whose flexibility has become a latest arrival; others as they are.

    Parameters
    ----------
    trips : sequence of Trip, (N,)
        What is asked.
    alone_s : sequence of float, (N,)
        Driving time of each alone [s].

    Returns
    -------
    list of Trip, (N,)
        Without flexibility.

    Raises
    ------
    ScenarioError
        Not one driving time for each trip.
    """
    if len(trips) != len(alone_s):
        raise ScenarioError(f"flexibility: {len(trips)} trips have {len(alone_s)} driving times")
    return [_timed(trip, float(drive)) for trip, drive in zip(trips, alone_s, strict=True)]


def _timed(trip: Trip, alone_s: float) -> Trip:
    if trip.flexibility_min is None or trip.earliest_departure is None:
        return trip
    # Nobody arrives as it leaves, were the way a millimetre.
    seconds = max(1, math.ceil(alone_s + 60 * trip.flexibility_min - SAME_S))
    arrival = _later(trip.earliest_departure, seconds)
    return replace(trip, latest_arrival=arrival, flexibility_min=None)


def _later(moment: datetime, seconds: int) -> datetime:
    """Add seconds that pass, also through a night in which the clocks are changed."""
    if moment.tzinfo is None:
        return moment + timedelta(seconds=seconds)
    return (moment.astimezone(UTC) + timedelta(seconds=seconds)).astimezone(moment.tzinfo)
