"""Marks on a still map: starts, destinations, merges and separations, clear of one another."""

from __future__ import annotations

import math
from collections.abc import Iterator

from ..document.model import Document
from ..document.model_vehicle import Stop, Vehicle
from ..drawing.crowd import CROWD
from ..drawing.lines import Point
from ..drawing.palette import CROWD as CROWD_COLOUR
from ..drawing.vehicle_styles import letter_size
from ..markup.fragments import Piece
from .map_view import MapView
from .placement import Box, Cover

__all__ = ["event_places", "placed_marks"]

MOST_ENDS = 3
"""More ends than this on one spot become one mark that counts them; in a crowd, any two near."""

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
    document: Document, view: MapView, cover: Cover, scale: float = 1.0
) -> Iterator[Piece]:
    """Yield all marks, and take their room.

    Merges and separations are placed first, so that they stand where they are.

    Parameters
    ----------
    document : Document
        Whose marks they are.
    view : MapView
        Where on the drawing things lie.
    cover : Cover
        What is taken already.
    scale : float
        How much larger than common they are.

    Yields
    ------
    Piece
        Each mark, those of events last, so that they lie on top.
    """
    taken = event_places(document, view, scale)
    events: list[Piece] = []
    for event, (left, top) in zip(document.events, list(taken), strict=True):
        x, y = view.at(event.lon, event.lat)
        cover.add_box(_box(left, top, 12 * scale))
        yield from _tie(x, y, left, top, scale)
        events.append(
            Piece(
                "static-event",
                {
                    "x": f"{left:.1f}",
                    "y": f"{top:.1f}",
                    "scale": f"{scale:g}",
                    "icon": event.kind,
                    "title": f"{event.name}: {event.text}",
                },
            )
        )
    for end, fragment, word in (
        ("origin", "static-start", "from"),
        ("destination", "static-end", "to"),
    ):
        for (x, y), vehicles in _spots(document, end, view, scale):
            names = ", ".join(dict.fromkeys(_end(vehicle, end).name for vehicle in vehicles))
            letters = ", ".join(vehicle.letter for vehicle in vehicles)
            most = 1 if len(document.vehicles) > CROWD else MOST_ENDS
            faces = [(vehicle.colour, vehicle.letter) for vehicle in vehicles]
            if len(vehicles) > most:
                faces = [(CROWD_COLOUR, f"{len(vehicles)}\u00d7")]
            for place, (colour, letter) in enumerate(faces):
                beside = x + 21 * scale * (place - (len(faces) - 1) / 2)
                left, top = _beside(beside, y, taken, scale)
                cover.add_box(_box(left, top, 10 * scale))
                yield from _tie(x, y, left, top, scale)
                yield Piece(
                    fragment,
                    {
                        "x": f"{left:.1f}",
                        "y": f"{top:.1f}",
                        "scale": f"{scale:g}",
                        "colour": colour,
                        "letter": letter,
                        "size": letter_size(letter),
                        "title": f"{letters} {word} {names}",
                    },
                )
    yield from events


def event_places(document: Document, view: MapView, scale: float = 1.0) -> list[Point]:
    """Return where the mark of each event stands.

    Parameters
    ----------
    document : Document
        Whose events they are.
    view : MapView
        Where on the drawing things lie.
    scale : float
        How much larger than common the marks are.

    Returns
    -------
    list of tuple of float
        In pixels.
    """
    taken: list[Point] = []
    for event in document.events:
        _beside(*view.at(event.lon, event.lat), taken, scale)
    return taken


def _end(vehicle: Vehicle, end: str) -> Stop:
    return vehicle.origin if end == "origin" else vehicle.destination


def _box(x: float, y: float, half: float) -> Box:
    return Box(x - half, y - half, 2 * half, 2 * half)


def _tie(x: float, y: float, left: float, top: float, scale: float) -> Iterator[Piece]:
    if math.hypot(left - x, top - y) > FAR * scale * 1.5:
        yield Piece(
            "static-leader",
            {"x1": f"{x:.1f}", "y1": f"{y:.1f}", "x2": f"{left:.1f}", "y2": f"{top:.1f}"},
        )


def _spots(
    document: Document, end: str, view: MapView, scale: float
) -> list[tuple[Point, list[Vehicle]]]:
    """Return who starts or ends on one spot; in a crowd, near one another."""
    reach = NEAR * scale if len(document.vehicles) > CROWD else 0.01
    found: list[tuple[Point, list[Vehicle]]] = []
    for vehicle in document.vehicles:
        stop = _end(vehicle, end)
        at = view.at(stop.lon, stop.lat)
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
