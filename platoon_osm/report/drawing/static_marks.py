"""Marks on a still map: starts, destinations, merges and separations, clear of one another."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from ..markup.fragments import Markup, fill
from .map_view import MapView, Point
from .placement import Box, Cover

__all__ = ["event_places", "placed_marks"]

CROWD_COLOUR = "#4d5560"
LETTER_SIZE = {1: 11.0, 2: 9.0, 3: 8.0}

CROWD = 8
"""Of more vehicles than this, starts near one another become one mark that counts them."""

MOST_ENDS = 3
"""Of fewer, only more ends than this on one spot do."""

NEAR, APART = 18.0, 19.0
"""Ends this near are one place in a crowd; marks this far apart do not touch, in pixels."""

FAR = 15.0
"""A mark moved further than this is tied to its place by a line."""

# Places round a spot in pixels, near ones first; sideways before up and down.
_FAN = sorted(
    ((x, y) for x in range(-60, 61, 12) for y in (-40, -20, 0, 20, 40)),
    key=lambda move: (math.hypot(move[0], 1.3 * move[1]), move),
)


def placed_marks(
    document: dict[str, Any], view: MapView, cover: Cover, scale: float = 1.0
) -> Iterator[Markup]:
    """Yield all marks, `scale` times their common size, and take their room.

    Merges and separations come first, so that they stand where they are.
    """
    taken = event_places(document, view, scale)
    events: list[Markup] = []
    for event, (left, top) in zip(document["events"], list(taken), strict=True):
        x, y = view.at(event["lon"], event["lat"])
        cover.add_box(_box(left, top, 12 * scale))
        yield from _tie(x, y, left, top, scale)
        events.append(
            fill(
                "static-event", x=f"{left:.1f}", y=f"{top:.1f}", scale=f"{scale:g}",
                icon=event["kind"], title=f"{event['name']}: {event['text']}",
            )
        )  # fmt: skip
    for end, fragment, word in (
        ("origin", "static-start", "from"),
        ("destination", "static-end", "to"),
    ):
        for (x, y), vehicles in _spots(document, end, view, scale):
            names = ", ".join(dict.fromkeys(vehicle[end]["name"] for vehicle in vehicles))
            letters = ", ".join(vehicle["letter"] for vehicle in vehicles)
            most = 1 if len(document["vehicles"]) > CROWD else MOST_ENDS
            faces = [(vehicle["colour"], vehicle["letter"]) for vehicle in vehicles]
            if len(vehicles) > most:
                faces = [(CROWD_COLOUR, f"{len(vehicles)}\u00d7")]
            for place, (colour, letter) in enumerate(faces):
                beside = x + 21 * scale * (place - (len(faces) - 1) / 2)
                left, top = _beside(beside, y, taken, scale)
                cover.add_box(_box(left, top, 10 * scale))
                yield from _tie(x, y, left, top, scale)
                yield fill(
                    fragment, x=f"{left:.1f}", y=f"{top:.1f}", scale=f"{scale:g}", colour=colour,
                    letter=letter, size=LETTER_SIZE[min(len(letter), 3)],
                    title=f"{letters} {word} {names}",
                )  # fmt: skip
    yield from events


def event_places(document: dict[str, Any], view: MapView, scale: float = 1.0) -> list[Point]:
    """Return where the mark of each event stands, in pixels."""
    taken: list[Point] = []
    for event in document["events"]:
        _beside(*view.at(event["lon"], event["lat"]), taken, scale)
    return taken


def _box(x: float, y: float, half: float) -> Box:
    return Box(x - half, y - half, 2 * half, 2 * half)


def _tie(x: float, y: float, left: float, top: float, scale: float) -> Iterator[Markup]:
    if math.hypot(left - x, top - y) > FAR * scale * 1.5:
        yield fill("static-leader", x1=f"{x:.1f}", y1=f"{y:.1f}", x2=f"{left:.1f}", y2=f"{top:.1f}")


def _spots(
    document: dict[str, Any], end: str, view: MapView, scale: float
) -> list[tuple[Point, list[dict[str, Any]]]]:
    """Return who starts or ends on one spot; in a crowd, near one another."""
    reach = NEAR * scale if len(document["vehicles"]) > CROWD else 0.01
    found: list[tuple[Point, list[dict[str, Any]]]] = []
    for vehicle in document["vehicles"]:
        at = view.at(vehicle[end]["lon"], vehicle[end]["lat"])
        near = next((who for spot, who in found if math.dist(spot, at) < reach), None)
        if near is None:
            found.append((at, [vehicle]))
        else:
            near.append(vehicle)
    return found


def _beside(x: float, y: float, taken: list[Point], scale: float) -> Point:
    """Return where a mark near (x, y) covers none before it; where it is, if all is taken."""
    room = APART * scale
    place = next(
        (
            (x + right * scale, y + down * scale)
            for right, down in _FAN
            if all(
                abs(x + right * scale - a) > room or abs(y + down * scale - b) > room
                for a, b in taken
            )
        ),
        (x, y),
    )
    taken.append(place)
    return place
