"""When one vehicle may start the parts of its route, so that it is nowhere while it is closed.

A part takes d [s] and is driven without a stop; between two parts the vehicle may wait. A section
of it that lasts from b to e after its start and is closed in the open interval (f, g) forbids
starts in

    (f - e, g - b).

The union of these over all sections and closings is what is forbidden. Who starts a part later ends
it later by as much, so the earliest arrival follows from starting each part as early as allowed,
and the latest departure, backwards, from starting each as late as allowed. Both are exact.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

__all__ = [
    "Interval", "Part", "Section", "allowed_between", "forbidden_starts",
    "latest_starts_along", "united",
]  # fmt: skip

Interval = tuple[float, float]
"""An open interval of time [s]."""


@dataclass(frozen=True, slots=True)
class Section:
    """A piece of road with one set of closings.

    Attributes
    ----------
    begin_s, end_s : float
        When it is driven, after the start of its part [s].
    closed : tuple of Interval
        When nobody may be on it [s].
    """

    begin_s: float
    end_s: float
    closed: tuple[Interval, ...]


@dataclass(frozen=True, slots=True)
class Part:
    """What is driven without a stop.

    Attributes
    ----------
    drive_s : float
        How long it takes [s].
    forbidden : tuple of Interval
        When it may not be started [s]; disjoint and in order, as `united` returns them.
    """

    drive_s: float
    forbidden: tuple[Interval, ...] = ()


def united(intervals: Iterable[Interval]) -> tuple[Interval, ...]:
    """Return the union of open intervals.

    Parameters
    ----------
    intervals : iterable of Interval
        In any order; empty ones count for nothing.

    Returns
    -------
    tuple of Interval
        Disjoint, in order. Two that only touch stay two: the moment between them is in neither.
    """
    found: list[Interval] = []
    for begin, end in sorted(one for one in intervals if one[0] < one[1]):
        if found and begin < found[-1][1]:
            found[-1] = (found[-1][0], max(found[-1][1], end))
        else:
            found.append((begin, end))
    return tuple(found)


def forbidden_starts(sections: Iterable[Section]) -> tuple[Interval, ...]:
    """Return when a part may not be started.

    Parameters
    ----------
    sections : iterable of Section
        Of the part.

    Returns
    -------
    tuple of Interval
        Disjoint, in order.
    """
    return united(
        (begin - section.end_s, end - section.begin_s)
        for section in sections
        for begin, end in section.closed
    )


def allowed_between(
    forbidden: Sequence[Interval], first: float, last: float
) -> list[tuple[float, float]]:
    """Return the closed intervals that are left between two moments.

    Parameters
    ----------
    forbidden : sequence of Interval
        Disjoint, in order.
    first, last : float
        The moments [s].

    Returns
    -------
    list of (float, float)
        In order; some may be a single moment.
    """
    found = []
    at = first
    for begin, end in forbidden:
        if begin >= last:
            break
        if begin >= at:
            found.append((at, begin))
        at = max(at, end)
    if at <= last:
        found.append((at, last))
    return found


def latest_starts_along(parts: Sequence[Part], arrival_s: float) -> list[float]:
    """Return the latest start of each part that is in time for an arrival.

    Parameters
    ----------
    parts : sequence of Part
        In driving order.
    arrival_s : float
        When the vehicle has to be there [s].

    Returns
    -------
    list of float
        Seconds.
    """
    starts = []
    at = arrival_s
    for part in reversed(parts):
        at -= part.drive_s
        for begin, end in reversed(part.forbidden):
            if begin < at < end:
                at = begin
        starts.append(at)
    return starts[::-1]
