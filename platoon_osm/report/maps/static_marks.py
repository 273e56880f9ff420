"""Marks on a still map: starts, destinations, merges and separations, clear of one another."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from ..document.model import Document
from ..document.model_vehicle import Stop, Vehicle
from ..drawing.crowd import CROWD
from ..drawing.lines import Point
from ..drawing.palette import CROWD as CROWD_COLOUR
from ..drawing.vehicle_styles import letter_size
from ..markup.fragments import Piece
from .map_view import Places
from .placement import Box

__all__ = ["Marks", "placed_marks"]

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


class Marks(NamedTuple):
    """The marks of a drawing.

    Attributes
    ----------
    pieces : list of Piece
        As they are drawn, those of events last, so that they lie on top.
    boxes : list of Box
        The room they take.
    events : list of tuple of float
        Where the mark of each event stands, in pixels.
    """

    pieces: list[Piece]
    boxes: list[Box]
    events: list[Point]


def placed_marks(document: Document, places: Places, scale: float = 1.0) -> Marks:
    """Place all marks.

    Merges and separations are placed first, so that they stand where they are.

    Parameters
    ----------
    document : Document
        Whose marks they are.
    places : Places
        Where on the drawing they belong.
    scale : float
        How much larger than common they are.

    Returns
    -------
    Marks
        None touching another, as far as there is room.
    """
    taken: list[Point] = []
    for x, y in places.events:
        _beside(x, y, taken, scale)
    stand = list(taken)
    pieces: list[Piece] = []
    boxes: list[Box] = []
    events: list[Piece] = []
    for event, (x, y), (left, top) in zip(document.events, places.events, stand, strict=True):
        boxes.append(_box(left, top, 12 * scale))
        pieces.extend(_tie(x, y, left, top, scale))
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
        for (x, y), vehicles in _spots(document, end, places, scale):
            names = ", ".join(dict.fromkeys(_end(vehicle, end).name for vehicle in vehicles))
            letters = ", ".join(vehicle.letter for vehicle in vehicles)
            most = 1 if len(document.vehicles) > CROWD else MOST_ENDS
            faces = [(vehicle.colour, vehicle.letter) for vehicle in vehicles]
            if len(vehicles) > most:
                faces = [(CROWD_COLOUR, f"{len(vehicles)}\u00d7")]
            for place, (colour, letter) in enumerate(faces):
                beside = x + 21 * scale * (place - (len(faces) - 1) / 2)
                left, top = _beside(beside, y, taken, scale)
                boxes.append(_box(left, top, 10 * scale))
                pieces.extend(_tie(x, y, left, top, scale))
                pieces.append(
                    Piece(
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
                )
    return Marks([*pieces, *events], boxes, stand)


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
    document: Document, end: str, places: Places, scale: float
) -> list[tuple[Point, list[Vehicle]]]:
    """Return who starts or ends on one spot; in a crowd, near one another."""
    reach = NEAR * scale if len(document.vehicles) > CROWD else 0.01
    found: list[tuple[Point, list[Vehicle]]] = []
    spots = places.origins if end == "origin" else places.destinations
    for vehicle, at in zip(document.vehicles, spots, strict=True):
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
