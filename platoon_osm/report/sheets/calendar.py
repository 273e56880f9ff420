"""A vehicle's journey as a calendar (RFC 5545): departure, meetings, waits, partings, arrival.

Moments are in UTC where the plan's times have a zone, else local and without one, as the plan's
are. Nothing depends on the hour of writing: an event is known by journey, day, kind and number, so
that a calendar renews it when the plan is made again, and all are stamped with one moment that the
caller names.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime

from ...plans.clock import Clock
from ...plans.plan import Plan
from ...shown_text import fitted, shown
from ..language.speech import say
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
    trip = plan.trips[index]
    made = Calendar()
    made.add("prodid", f"-//platoon_osm//{shown(plan.version) or '0'}//EN")
    made.add("version", "2.0")
    made.add("calscale", "GREGORIAN")
    made.add("x-wr-calname", fitted(trip.vehicle))
    known = [
        plan.network.identity, trip.vehicle, trip.origin.name, trip.destination.name,
        f"{clock.moment(plan.timetable.vehicles[index].departure_s):%Y-%m-%d}",
    ]  # fmt: skip
    for kind, number, begin_s, end_s, what in _entries(steps, words):
        event, said = Event(), words[number]
        event.add("uid", _uid([*known, kind, str(number)]))
        event.add("dtstamp", stamp)
        event.add("dtstart", _moment(clock, begin_s))
        if end_s is not None:
            event.add("dtend", _moment(clock, end_s))
        event.add("summary", f"{fitted(trip.vehicle)}: {what}")
        event.add("location", said.place)
        place = steps[number].place
        event.add("geo", (round(place.lat, 6), round(place.lon, 6)))
        told = (said.what, said.wait, said.without, said.way, said.at, " \u00b7 ".join(credits))
        event.add("description", "\n".join(text for text in told if text))
        made.add_component(event)
    return made.to_ical()  # type: ignore[no-any-return]


def _entries(
    steps: Sequence[Step], words: Sequence[StepWords]
) -> Iterator[tuple[str, int, float, float | None, str]]:
    """Yield kind, number of the step, begin and end [s] of each entry, and what it is called."""
    for number, (step, said) in enumerate(zip(steps, words, strict=True)):
        if said.kind == "road":
            continue
        if step.wait_s and step.reached_s is not None:
            yield "wait", number, step.reached_s, step.leaves_s, say("sheet.waiting", at=said.place)
        at = step.reached_s if step.leaves_s is None else step.leaves_s
        if at is not None:
            yield said.kind, number, at, None, said.what


def _moment(clock: Clock, seconds: float) -> datetime:
    """Return a moment to the second, in UTC if the clock has a zone."""
    moment = clock.moment(round(seconds))
    return moment if moment.tzinfo is None else moment.astimezone(UTC)


def _uid(parts: Sequence[str]) -> str:
    text = "\0".join(parts).encode("utf-8", "surrogatepass")
    return f"{hashlib.sha256(text).hexdigest()[:32]}@platoon-osm"
