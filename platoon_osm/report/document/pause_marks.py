"""Breaks, rests, bans and changes of drivers in words: who stands where, from when and how long.

Vehicles that stand at one place for the same while for the same purpose share a mark. A wait for
others has one only where it is at a place of its own: at a merging point the merge tells of it.
"""

from __future__ import annotations

from collections.abc import Iterator

from ...plans.clock import MENTIONED_S, duration
from ...plans.pauses import Pause
from ...shown_text import fitted, shortened, shown
from ..language.speech import clock_time, number, say
from .findings import Findings
from .model_map import EventMark
from .place_labels import LONGEST_NAME
from .stands import kind_of
from .stop_names import brief_name
from .wording import joined

__all__ = ["pause_marks"]

PLACES = {
    "services": "stops.services",
    "rest_area": "stops.rest-area",
    "truck_parking": "stops.parking",
    "parking": "stops.parking",
    "fuel": "stops.fuel",
    "charging": "stops.charging",
    "junction": "pause.no-parking",
    "origin": "events.at-start",
}
"""What there is at a place, by its kind; others are not told."""

WHAT = {
    "weekly_rest": "pause.weekly-rest",
    "reduced_weekly_rest": "pause.reduced-weekly-rest",
    "daily_rest": "pause.daily-rest",
    "reduced_daily_rest": "pause.reduced-daily-rest",
    "break": "pause.break",
    "second_part": "pause.second-part",
    "first_part": "pause.first-part",
    "change": "pause.change",
    "ban": "pause.ban",
    "company": "pause.company",
}
"""Words for each purpose of a pause."""

Key = tuple[str, float, float, int, int, tuple[str, ...]]


def pause_marks(found: Findings) -> tuple[EventMark, ...]:
    """Return the pauses of a plan.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Returns
    -------
    tuple of EventMark
        In order of time.
    """
    alike: dict[Key, list[tuple[int, Pause]]] = {}
    for index, times in enumerate(found.plan.times):
        for pause in () if times is None else times.pauses:
            if _is_told(pause):
                name, lon, lat = _where(found, index, pause)
                when = (round(pause.start_s), round(pause.end_s))
                key = (name, lon, lat, *when, pause.purposes)
                alike.setdefault(key, []).append((index, pause))
    marks = [_mark(found, key, some) for key, some in alike.items()]
    return tuple(sorted(marks, key=lambda one: (one.at_s, one.vehicles)))


def _is_told(pause: Pause) -> bool:
    if pause.duration_s < MENTIONED_S:
        return False
    return kind_of(pause.purposes) != "wait" or bool(pause.place and pause.place.has_parking)


def _where(found: Findings, index: int, pause: Pause) -> tuple[str, float, float]:
    """Return what a place is called, and where it is."""
    place, own = pause.place, found.plan.trips[index].origin
    if place is not None and place.kind != "origin":
        name = shortened(shown(place.name), LONGEST_NAME) or say(
            PLACES.get(place.kind, "pause.beside-road")
        )
        return name, round(found.longitude(place.lon), 6), round(place.lat, 6)
    if place is not None or pause.before == 0:
        name = fitted(brief_name(own.name, own.lon, own.lat))
        return name, round(found.longitude(own.lon), 6), round(own.lat, 6)
    edges = found.plan.stretches[found.plan.ways[index][pause.before]].edges
    node = int(found.net.tail[edges[0]])
    name = fitted(found.net.place_name(node)) or say("pause.beside-road")
    return name, round(float(found.net.lon[node]), 6), round(float(found.net.lat[node]), 6)


def _mark(found: Findings, key: Key, some: list[tuple[int, Pause]]) -> EventMark:
    name, lon, lat, *_ = key
    vehicles = tuple(index for index, _ in some)
    pause = some[0][1]
    table = found.plan.timetable
    assert table is not None
    return EventMark(
        kind=kind_of(pause.purposes),
        lon=lon,
        lat=lat,
        name=name,
        vehicles=vehicles,
        others=(),
        at_m=None,
        at_s=round(pause.start_s, 1),
        text=say(
            "pause.text",
            time=clock_time(table.clock, pause.start_s),
            who=joined(found.letters(vehicles)),
            what=say(WHAT[pause.purposes[0]]),
            lasts=duration(pause.duration_s),
        ),
        detail=", ".join(_details(found, pause)),
        until_s=round(pause.end_s, 1),
        has_parking=pause.place is not None and pause.place.has_parking,
    )


def _details(found: Findings, pause: Pause) -> Iterator[str]:
    """Yield until when, what there is, and what else the pause is for."""
    table, place = found.plan.timetable, pause.place
    assert table is not None
    yield say("pause.until", time=clock_time(table.clock, pause.end_s))
    if place is None:
        yield say("pause.no-parking")
    elif place.kind in PLACES:
        yield say(PLACES[place.kind])
    if place is not None and place.capacity is not None:
        yield say("stops.spaces", spaces=number(place.capacity))
    for purpose in pause.purposes[1:]:
        yield say("pause.also", what=say(WHAT[purpose]))
