"""A vehicle's journey as a calendar (RFC 5545): departure, meetings, pauses, partings, arrival.

Moments are in UTC where the plan's times have a zone, else local and without one, as the plan's
are. Nothing depends on the hour of writing: an event is known by journey, day, kind and number, so
that a calendar renews it when the plan is made again, and all are stamped with one moment that the
caller names. The button of a plan's page (assets/data_calendar.js) makes the same entries, with the
same moments and names, so that who takes both has each once.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime

from ...network.antimeridian import wrapped_deg
from ...plans.clock import MENTIONED_S, Clock
from ...plans.plan import Plan
from ...shown_text import fitted, shown
from ..document.halts import Halt
from ..language.speech import say
from .pause_words import pause_title, place_called
from .steps import Step
from .words import StepWords

__all__ = ["calendar"]


def calendar(
    plan: Plan,
    index: int,
    steps: Sequence[Step],
    words: Sequence[StepWords],
    credits: Sequence[str],
    stamp: datetime,
) -> bytes:
    """Return the calendar of a vehicle.

    Parameters
    ----------
    plan : Plan
        With times.
    index : int
        Position of the vehicle in it.
    steps : sequence of Step
        Of the vehicle.
    words : sequence of StepWords
        The same in words.
    credits : sequence of str
        Whom to name with the map.
    stamp : datetime
        In UTC; what the calendar says it was made at.

    Returns
    -------
    bytes
        The file, its lines folded and ended as the standard has it.
    """
    from icalendar import Calendar, Event

    assert plan.timetable is not None
    clock = plan.timetable.clock
    name = fitted(plan.trips[index].vehicle)
    made = Calendar()
    made.add("prodid", f"-//platoon_osm//{shown(plan.version) or '0'}//EN")
    made.add("version", "2.0")
    made.add("calscale", "GREGORIAN")
    made.add("x-wr-calname", name)
    journey, seen = _journey(plan, index, clock), Counter[str]()
    for kind, number, begin_s, end_s, what, halt in _entries(steps, words):
        event, said = Event(), words[number]
        seen[kind] += 1
        event.add("uid", f"{journey}-{kind}-{seen[kind]}@platoon-osm")
        event.add("dtstamp", stamp)
        event.add("dtstart", _moment(clock, begin_s))
        if end_s is not None:
            event.add("dtend", _moment(clock, end_s))
        event.add("summary", f"{name}: {what}")
        place = steps[number].place if halt is None else halt
        named = said.place if halt is None else place_called(halt)
        event.add("location", named)
        event.add("geo", (round(place.lat, 6), round(float(wrapped_deg(place.lon)), 6)))
        told = (said.what, said.wait, said.without, said.way, said.at, " \u00b7 ".join(credits))
        event.add("description", "\n".join(text for text in told if text))
        made.add_component(event)
    return made.to_ical()  # type: ignore[no-any-return]  # its types say Any


def _entries(
    steps: Sequence[Step], words: Sequence[StepWords]
) -> Iterator[tuple[str, int, float, float | None, str, Halt | None]]:
    """Yield of each entry kind, number of the step, begin and end [s], name, and any halt."""
    for number, (step, said) in enumerate(zip(steps, words, strict=True)):
        if said.kind == "road":
            continue
        if step.pauses:
            for halt in step.halts:
                yield halt.what, number, halt.begin_s, halt.end_s, _called(halt), halt
        elif _waits(step):
            begin_s = step.reached_s or 0.0
            yield "wait", number, begin_s, step.leaves_s, say("sheet.waiting", at=said.place), None
        if step.is_pause and number:
            continue
        at = step.reached_s if step.leaves_s is None else step.leaves_s
        if at is not None:
            yield said.kind, number, at, None, said.what, None


def _called(halt: Halt) -> str:
    return say("sheet.waiting", at=place_called(halt)) if halt.what == "wait" else pause_title(halt)


def _waits(step: Step) -> bool:
    if step.reached_s is None or step.leaves_s is None:
        return False
    return _tenths(step.leaves_s) - _tenths(step.reached_s) >= MENTIONED_S * 10


def _tenths(seconds: float) -> int:
    """Return a moment as a page holds it."""
    return round(round(seconds, 1) * 10)


def _moment(clock: Clock, seconds: float) -> datetime:
    """Return a moment to the second, in UTC if the clock has a zone."""
    moment = _local(clock, seconds)
    return moment if moment.tzinfo is None else moment.astimezone(UTC)


def _local(clock: Clock, seconds: float) -> datetime:
    # From tenths and half up, as a page rounds.
    return clock.moment(math.floor(_tenths(seconds) / 10 + 0.5))


def _journey(plan: Plan, index: int, clock: Clock) -> str:
    """Return what a vehicle's journey of one day is known by, in any plan of it."""
    assert plan.timetable is not None
    trip = plan.trips[index]
    name = fitted(trip.vehicle)
    departure = _local(clock, plan.timetable.vehicles[index].departure_s)
    namesakes = sum(fitted(other.vehicle) == name for other in plan.trips[:index])
    ends = fitted(trip.origin.name), fitted(trip.destination.name)
    return _named("\0".join([name, *ends, f"{departure:%Y-%m-%d}", str(namesakes)]))


def _named(text: str) -> str:
    """Return FNV-1a in 64 bits: a few lines in a page too, where no secure hash is to be had."""
    found = 0xCBF29CE484222325
    for byte in text.encode():
        found = (found ^ byte) * 0x100000001B3 % 2**64
    return f"{found:016x}"
