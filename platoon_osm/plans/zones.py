"""When clocks change in a zone while a plan is driven.

What a zone is called, and when its clocks change, is asked of the zone of the first time that is
named; it may come from zoneinfo or any other package. Trips of several zones are shown in that one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from datetime import UTC, datetime, timedelta, timezone, tzinfo

from .clock import Clock, Offsets

__all__ = ["clock_of", "in_order"]

STEP_S = 6 * 3600
"""Clocks of no zone change back within so short a time."""

AROUND_S = 3 * 3600
"""Changes so shortly before and after are known too: they tell which hours clocks show twice."""

LOOKED_AHEAD_S = 3 * 366 * 86_400
"""Changes are looked for over three years: a time asked for beyond is shown in the last offset."""


def in_order(moment: datetime) -> datetime:
    """Return a moment by which others are compared: in UTC, if it has a zone.

    Moments of one zone are compared by the face of the clock, which shows an hour twice in autumn.

    Parameters
    ----------
    moment : datetime
        With or without a zone.

    Returns
    -------
    datetime
        In UTC, or as it was.
    """
    return moment if moment.utcoffset() is None else moment.astimezone(UTC)


def clock_of(first: datetime, shift_s: float, moments: Iterable[float]) -> Clock:
    """Return the clock that starts some time after a moment, by the clocks of the moment's zone.

    Parameters
    ----------
    first : datetime
        With or without a zone.
    shift_s : float
        How long after it seconds begin.
    moments : iterable of float
        Moments that are to be shown, in seconds of the new clock.

    Returns
    -------
    Clock
        It knows all changes between these moments.
    """
    zone = first.tzinfo
    if zone is None or first.utcoffset() is None:
        return Clock(first + timedelta(seconds=shift_s))
    start = first.astimezone(UTC) + timedelta(seconds=shift_s)

    def offset(seconds: float) -> float:
        found = (start + timedelta(seconds=seconds)).astimezone(zone).utcoffset()
        return 0.0 if found is None else found.total_seconds()

    shown = [0.0, *moments]
    begin, end = min(shown) - AROUND_S, max(shown) + AROUND_S
    # Whole seconds of the calendar: clocks change at one.
    begin = float(int(begin) - 1) - start.microsecond / 1e6
    offsets = _changes(offset, begin, min(end, begin + LOOKED_AHEAD_S))
    own = timezone(timedelta(seconds=offset(0.0)))
    return Clock(start.astimezone(own), _name(zone), offsets if len(offsets) > 1 else ())


def _changes(offset: Callable[[float], float], begin: float, end: float) -> Offsets:
    """Return the offset at the begin, and each later one with when it begins, to the second."""
    found = [(begin, offset(begin))]
    at = begin
    while at < end:
        onward = at + STEP_S
        if offset(onward) != found[-1][1]:
            low, high = at, onward
            while high - low > 1:
                middle = low + (high - low) // 2
                low, high = (middle, high) if offset(middle) == found[-1][1] else (low, middle)
            if high > end:
                break
            found.append((high, offset(high)))
        at = onward
    return tuple(found)


def _name(zone: tzinfo) -> str:
    """Return what a zone is called: zoneinfo says `key`, pytz `zone`; empty if it has no name."""
    for field in ("key", "zone"):
        if isinstance(name := getattr(zone, field, None), str):
            return name
    return ""
