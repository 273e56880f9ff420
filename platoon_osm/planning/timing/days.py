"""What driving rules ask of the times of a vehicle: where it stands, and how long a day may be.

Who drives what, and where it stands for which rule, is settled before; the linear programme of
`programme.py` then finds the times. With s the least time that a vehicle stands before a leg,

    t_q >= t_p + d_p + s,

and a duty period from leg p to leg q that may last w at most has t_q + d_q - t_p <= w. So times
found by a search in whole seconds are also times of the programme, which has no need to round.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ...plans.pauses import DriverDay, Pause, PausePlace
from ...plans.timetable import LATE_S
from .limits import Window
from .pieces import Pieces
from .programme import Programme

__all__ = [
    "Day", "Duty", "Stand", "demand_days", "pauses_of", "stands_before", "until_moments",
    "windows_within",
]  # fmt: skip

Span = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Stand:
    """A pause that is planned before a leg.

    Attributes
    ----------
    leg : int
        The leg that follows, counted from 0 along the vehicle's way; 1 or more.
    least_s : float
        How long it lasts at least [s].
    purposes : tuple of str
        As in `Pause`.
    place : PausePlace or None
        Where.
    until : float or None
        Before when it does not end [s]; for a ban.
    """

    leg: int
    least_s: float
    purposes: tuple[str, ...]
    place: PausePlace | None = None
    until: float | None = None


@dataclass(frozen=True, slots=True)
class Duty:
    """A duty period, from the end of one daily rest until driving ends before the next.

    Attributes
    ----------
    first, last : int
        Its legs.
    most_s : float
        How long it may last [s].
    until : float or None
        When it ends at the latest [s]; for one that began before the trip.
    """

    first: int
    last: int
    most_s: float
    until: float | None = None


@dataclass(frozen=True, slots=True)
class Day:
    """What is settled of a vehicle before its times are.

    Attributes
    ----------
    stands : tuple of Stand
        In the order of its way.
    leaves_after : float or None
        Before when it does not leave, for it rests at its origin [s].
    duties : tuple of Duty
        Those that have a limit.
    drivers : tuple of DriverDay
        For the record; `state_at_s` on the same clock as the windows.
    """

    stands: tuple[Stand, ...] = ()
    leaves_after: float | None = None
    duties: tuple[Duty, ...] = ()
    drivers: tuple[DriverDay, ...] = ()


def stands_before(
    days: Sequence[Day], ways: Sequence[Sequence[int]]
) -> dict[tuple[int, int], float]:
    """Return how long vehicles stand before stretches, as `pieces_of` takes it.

    Parameters
    ----------
    days : sequence of Day, (N,)
        One a vehicle.
    ways : sequence of sequence of int, (N, ...)
        The stretches of each.

    Returns
    -------
    dict of (int, int) to float
        By vehicle and stretch [s].
    """
    return {
        (index, ways[index][stand.leg]): stand.least_s
        for index, day in enumerate(days)
        for stand in day.stands
    }


def windows_within(windows: Sequence[Window], days: Sequence[Day]) -> list[Window]:
    """Return windows of which vehicles that rest at their origin first use a part.

    Parameters
    ----------
    windows : sequence of Window, (N,)
        How far each may be moved.
    days : sequence of Day, (N,)
        What is settled.

    Returns
    -------
    list of Window, (N,)
        With later earliest departures.
    """
    found = []
    for window, day in zip(windows, days, strict=True):
        named = [at for at in (window.earliest, day.leaves_after) if at is not None]
        found.append(Window(max(named, default=None), window.latest, window.arrival))
    return found


def demand_days(model: Programme, pieces: Pieces, days: Sequence[Day]) -> None:
    """Add to a programme what days ask for beside how long vehicles stand.

    Parameters
    ----------
    model : Programme
        Of a timetable.
    pieces : Pieces
        Its pieces; those before which somebody stands until a moment have a start of their own.
    days : sequence of Day, (N,)
        What is settled.
    """
    for way, day in zip(pieces.ways, days, strict=True):
        for stand in day.stands:
            if stand.until is not None:
                root = pieces.pieces[way[stand.leg]].root
                low, high = model.bounds[root]
                late = stand.until - pieces.pieces[way[stand.leg]].offset_s
                model.bounds[root] = (late if low is None else max(low, late), high)
        for duty in day.duties:
            model.limit_span(way[duty.first], way[duty.last], duty.most_s)
            if duty.until is not None:
                model.limit_end(way[duty.last], duty.until)


def pauses_of(legs: Sequence[Span], stands: Sequence[Stand]) -> tuple[Pause, ...]:
    """Return the pauses of a vehicle, for the record.

    Parameters
    ----------
    legs : sequence of (float, float)
        When it drives [s].
    stands : sequence of Stand
        What is planned between them.

    Returns
    -------
    tuple of Pause
        Each as long as the gap it lies in; where that is longer than planned, it waits there too.
    """
    found = []
    for stand in stands:
        begin, end = legs[stand.leg - 1][1], legs[stand.leg][0]
        waits = end - begin > stand.least_s + 1.0 and stand.until is None
        purposes = stand.purposes
        if waits and "company" not in purposes:
            purposes = (*purposes, "company")
        if end - begin > LATE_S:
            found.append(Pause(stand.leg, purposes, begin, end, stand.place))
    return tuple(found)


def until_moments(days: Sequence[Day], ways: Sequence[Sequence[int]]) -> Mapping[int, float]:
    """Return before which stretches somebody stands until a moment, and until when.

    Parameters
    ----------
    days : sequence of Day, (N,)
        One a vehicle.
    ways : sequence of sequence of int, (N, ...)
        The stretches of each.

    Returns
    -------
    mapping of int to float
        Seconds by stretch; `pieces_of` gives them a start of their own.
    """
    found: dict[int, float] = {}
    for index, day in enumerate(days):
        for stand in day.stands:
            if stand.until is not None:
                stretch = ways[index][stand.leg]
                found[stretch] = max(found.get(stretch, stand.until), stand.until)
    return found
