"""Who is late by a plan, who would be even alone: what a reader should know of it first."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

from .clock import late_by
from .plan import Plan
from .text_table import listed
from .timetable import LATE_S, VehicleTimes

__all__ = [
    "NOT_FEASIBLE", "NOT_IN_TIME", "NOT_LAWFUL", "WAY_OUT", "Lateness", "Moments", "late_alone_s",
    "status_lines", "who_is_late",
]  # fmt: skip

NOT_FEASIBLE = "not feasible"
"""Begins the remarks of plans that cannot be as they were asked for."""
NOT_IN_TIME = f"{NOT_FEASIBLE} in time"
"""Begins those on who is late."""
NOT_LAWFUL = f"{NOT_FEASIBLE} within the law"
"""Begins those on who cannot keep to the driving rules."""
WAY_OUT = "would be in time"
"""Stands in those on what would do, between who is late and that."""


class Moments(Protocol):
    """What is known of a vehicle's punctuality [s]."""

    @property
    def late_s(self) -> float:
        """By the plan; 0 if it is in time."""

    @property
    def late_alone_s(self) -> float | None:
        """Leaving as early as it may and driving alone; None where that is not known."""

    @property
    def latest_arrival_s(self) -> float | None:
        """When it has to be there; None if it named none."""


@dataclass(frozen=True, slots=True)
class Lateness:
    """Who is late.

    Attributes
    ----------
    late : tuple of int
        Positions of the vehicles that arrive too late.
    even_alone : tuple of int
        Those of them that would be late alone too.
    in_time_alone : bool
        Whether all that are late are known to be in time alone.
    most_s : float
        The greatest lateness [s].
    asked : bool
        Whether any vehicle named a latest arrival.
    """

    late: tuple[int, ...]
    even_alone: tuple[int, ...]
    in_time_alone: bool
    most_s: float
    asked: bool


def late_alone_s(times: VehicleTimes, alone_s: float) -> float | None:
    """Return how late a vehicle would be if it left at once and drove alone.

    Parameters
    ----------
    times : VehicleTimes
        Of the plan.
    alone_s : float
        How long it drives alone [s].

    Returns
    -------
    float or None
        0 if it would be in time; None if it named no earliest departure or no latest arrival.
        Under driving rules breaks count too, and nobody is later than alone.
    """
    if times.drivers and times.late_s:
        return times.late_s
    first, latest = times.earliest_departure_s, times.latest_arrival_s
    if first is None or latest is None:
        return None
    late = first + alone_s - latest
    return late if late > LATE_S else 0.0


def who_is_late(days: Sequence[Moments | None]) -> Lateness:
    """Return who is late.

    Parameters
    ----------
    days : sequence of Moments or None
        Of each vehicle; None without times.

    Returns
    -------
    Lateness
        Nobody, for a plan without times.
    """
    known = [(place, day) for place, day in enumerate(days) if day is not None]
    late = [(place, day) for place, day in known if day.late_s > 0]
    return Lateness(
        late=tuple(place for place, _ in late),
        even_alone=tuple(place for place, day in late if day.late_alone_s),
        in_time_alone=bool(late) and all(day.late_alone_s == 0 for _, day in late),
        most_s=max((day.late_s for _, day in late), default=0.0),
        asked=any(day.latest_arrival_s is not None for _, day in known),
    )


@dataclass(frozen=True, slots=True)
class _Day:
    late_s: float
    late_alone_s: float | None
    latest_arrival_s: float | None


def status_lines(plan: Plan) -> Iterator[str]:
    """Yield what heads a summary, as what heads a page: lateness, and that nobody has company.

    Parameters
    ----------
    plan : Plan
        Any.

    Yields
    ------
    str
        In English, without a stop.
    """
    every = len(plan.vehicles)
    found = who_is_late(_days(plan))
    if found.late:
        names = [plan.vehicles[place].vehicle for place in found.even_alone]
        by = "by" if len(found.late) == 1 else "by up to"
        line = f"{len(found.late):,} of {every:,} late, {by} {late_by(found.most_s)}"
        if len(names) == len(found.late):
            line += "; late even alone" if len(names) == 1 else "; all of them late even alone"
        elif names:
            line += f"; {listed(names)} {'is' if len(names) == 1 else 'are'} late even alone"
        elif found.in_time_alone:
            line += f"; alone {'it' if len(found.late) == 1 else 'they'} would be in time"
        yield line
    elif found.asked:
        yield "In time" if every == 1 else "All in time"
    if not any(one.platoon_m > 0 for one in plan.vehicles):
        alone = "there is one vehicle" if every == 1 else "all vehicles drive alone"
        yield f"No platoon: {alone}"


def _days(plan: Plan) -> list[_Day]:
    if plan.timetable is None:
        return []
    return [
        _Day(times.late_s, late_alone_s(times, trip.alone.time_s), times.latest_arrival_s)
        for times, trip in zip(plan.timetable.vehicles, plan.trips, strict=True)
    ]
