"""What a sheet and a calendar say of a break, a rest, a ban or a change of drivers.

Said in the language that is spoken: what it is, how long and with whom; from when to when; what is
known of the place; and what it counts as by driving rules.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from ...plans.clock import Clock, duration
from ...shown_text import fitted, shortened
from ..document.halts import Halt
from ..language.speech import clock_time, day_and_date, say, time_of_day
from ..markup.quantities import kilometres

__all__ = [
    "from_to", "pause_at", "pause_called", "pause_remarks", "pause_title", "place_called",
    "unnamed_place",
]  # fmt: skip

LONGEST_NAME = 44
"""Of a place, in characters."""

BESIDE_M = 50.0
"""A place no farther from the road is at it."""

CALLED = {
    "weekly_rest": "sheet.weekly-rest", "reduced_weekly_rest": "sheet.reduced-weekly-rest",
    "daily_rest": "sheet.daily-rest", "reduced_daily_rest": "sheet.reduced-daily-rest",
    "break": "sheet.break", "second_part": "sheet.break", "first_part": "sheet.break",
    "change": "sheet.change", "ban": "sheet.ban", "company": "sheet.waits",
}  # fmt: skip
"""What a pause is called, by its first purpose."""

PARTS = ("first_part", "second_part")
"""Of a break in two, which are always told."""

COUNTS = {
    "weekly_rest": "sheet.counts-rest", "reduced_weekly_rest": "sheet.counts-rest",
    "daily_rest": "sheet.counts-rest", "reduced_daily_rest": "sheet.counts-rest",
    "break": "sheet.counts-break", "second_part": "sheet.counts-second",
    "first_part": "sheet.counts-first", "change": "sheet.counts-change", "ban": "sheet.counts-ban",
    "company": "sheet.counts-wait",
}  # fmt: skip
"""What else a pause is for."""

PLACES = {
    "services": "stops.services", "rest_area": "stops.rest-area",
    "truck_parking": "stops.parking", "parking": "stops.parking", "fuel": "stops.fuel",
    "charging": "stops.charging",
}  # fmt: skip
"""What a place without a name is called, by what is there."""

Names = Callable[[Sequence[int]], str]
"""Puts some vehicles in a row."""


def pause_title(halt: Halt) -> str:
    """Return what a pause is and how long.

    Parameters
    ----------
    halt : Halt
        The pause.

    Returns
    -------
    str
        Such as "Break, 45 min".
    """
    return say("sheet.stand", what=say(CALLED[halt.purposes[0]]), span=duration(halt.lasts_s))


def pause_called(halt: Halt, names: Names) -> str:
    """Return what a pause is, how long and with whom.

    Parameters
    ----------
    halt : Halt
        The pause.
    names : callable
        Puts vehicles in a row.

    Returns
    -------
    str
        A sentence.
    """
    if not halt.company:
        return f"{pause_title(halt)}."
    return say("sheet.stand-with", pause=pause_title(halt), who=names(halt.company))


def pause_at(halt: Halt, names: Names) -> str:
    """Return the same with the place, where a step is told by another one.

    Parameters
    ----------
    halt : Halt
        The pause.
    names : callable
        Puts vehicles in a row.

    Returns
    -------
    str
        A sentence or two.
    """
    place = shortened(place_called(halt), LONGEST_NAME)
    return say("sheet.stand-at", pause=pause_called(halt, names), place=place)


def from_to(halt: Halt, clock: Clock) -> str:
    """Return from when to when a pause is, with dates if it goes over midnight.

    Parameters
    ----------
    halt : Halt
        The pause.
    clock : Clock
        Of the plan.

    Returns
    -------
    str
        A sentence.
    """
    moments = [clock.moment(at) for at in (halt.begin_s, halt.end_s)]
    ends = (halt.begin_s, halt.end_s)
    times = [clock_time(clock, at) for at in ends]
    if moments[0].date() != moments[1].date():
        times = [
            say("sheet.dated", date=day_and_date(moment), time=time_of_day(clock, at))
            for moment, at in zip(moments, ends, strict=True)
        ]
    return say("sheet.stand-from", begin=times[0], end=times[1])


def pause_remarks(halt: Halt) -> Iterator[str]:
    """Yield what is known of the place of a pause, and what it counts as.

    Parameters
    ----------
    halt : Halt
        The pause.

    Yields
    ------
    str
        A sentence.
    """
    if halt.beside_m >= BESIDE_M:
        yield say("sheet.beside", km=kilometres(halt.beside_m))
    if halt.capacity is not None:
        yield say("sheet.spaces", n=halt.capacity)
    if not halt.has_parking and halt.kind != "origin":
        yield say("sheet.no-parking")
    first, *more = halt.purposes
    if first in PARTS:
        yield say(COUNTS[first])
    for purpose in more:
        yield say(COUNTS[purpose])


def place_called(halt: Halt) -> str:
    """Return the name of the place of a pause, or what is there.

    Parameters
    ----------
    halt : Halt
        The pause.

    Returns
    -------
    str
        As it is shown.
    """
    return fitted(halt.name) or unnamed_place(halt.kind)


def unnamed_place(kind: str) -> str:
    """Return what a place without a name is called.

    Parameters
    ----------
    kind : str
        What is there, as of `Halt.kind`.

    Returns
    -------
    str
        In the language that is spoken.
    """
    return say(PLACES.get(kind, "sheet.on-road"))
