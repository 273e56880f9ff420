"""Marks on a still map: starts, destinations, merges and separations, clear of one another.

No mark covers another as long as there is room within reach of its place: some hundred places are
tried round it, near ones first. Where all of them are taken, it stands where it belongs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from ..document.model import Document
from ..document.model_vehicle import Stop, Vehicle
from ..drawing.crowd import CROWD
from ..drawing.lines import Point
from ..drawing.palette import CROWD as CROWD_COLOUR
from ..drawing.vehicle_styles import letter_size
from ..language.speech import say
from ..markup.fragments import NOTHING, Piece, Tree
from .map_view import MapView
from .pause_icons import NOUNS
from .placement import Box

__all__ = ["Mark", "mark_pieces", "placed_marks"]

MOST_ENDS = 3
"""More ends than this on one spot become one mark that counts them; in a crowd, any two near."""

NEAR = 18.0
"""Ends this near are one place in a crowd, in pixels."""

MOST_TOLD = 4
"""Events that a mark which counts them names."""

END_HALF, EVENT_HALF = 10.3, 12.5
"""Half of what a mark covers, its rim included, in pixels."""

BADGE = 5.0
"""How far the badge of late arrivals sticks out of a mark, in pixels."""

FAR = 15.0
"""A mark moved further than this is tied to its place by a line."""

BESIDE = 21.0
"""How far from each other the ends of several vehicles on one spot stand, in pixels."""

# Places round a spot in pixels, near ones first; sideways before up and down.
_FAN = sorted(
    ((x, y) for x in range(-132, 133, 12) for y in range(-100, 101, 20)),
    key=lambda move: (math.hypot(move[0], 1.3 * move[1]), move),
)


@dataclass(frozen=True, slots=True)
class Mark:
    """A mark, and where it stands.

    Attributes
    ----------
    kind : str
        What is there: "start", "end", or the kind of an event.
    x, y : float
        Its middle, in pixels.
    spot : tuple of float
        Where it belongs.
    half : float
        Half of its width and height.
    title : str
        What it says of itself.
    colour, letter : str
        Of the vehicle. Of events the number that share the mark; empty for one.
    scale : float
        How much larger than common it is drawn.
    event : int or None
        Position of the event that has this mark for itself.
    is_late : bool
        Whether someone arrives too late here, which a badge tells.
    has_parking : bool
        Whether trucks are known to park there; if not, a badge tells.
    """

    kind: str
    x: float
    y: float
    spot: Point
    half: float
    title: str
    colour: str = ""
    letter: str = ""
    scale: float = 1.0
    event: int | None = None
    is_late: bool = False
    has_parking: bool = True

    @property
    def box(self) -> Box:
        """The room it takes."""
        return Box(self.x - self.half, self.y - self.half, 2 * self.half, 2 * self.half)

    @property
    def is_tied(self) -> bool:
        """Whether it stands so far from its place that a line ties it there."""
        far = math.hypot(self.x - self.spot[0], self.y - self.spot[1])
        return far > FAR * self.scale * 1.5

    @property
    def is_event(self) -> bool:
        """Whether vehicles merge, separate or stand there, rather than start or end."""
        return self.kind not in ("start", "end")


def placed_marks(
    document: Document, view: MapView, scale: float = 1.0, *, counted: bool = False
) -> list[Mark]:
    """Place all marks.

    Merges and separations are placed first, so that they stand where they are.

    Parameters
    ----------
    document : Document
        Whose marks they are.
    view : MapView
        The drawing.
    scale : float
        How much larger than common they are.
    counted : bool
        Whether events of a kind near one another share a mark that counts them.

    Returns
    -------
    list of Mark
        Those of events first, in their order; none covers another, as far as there is room.
    """
    places = view.places(document)
    marks: list[Mark] = []
    for spot, numbers in _event_spots(document, places.events, NEAR * scale if counted else 0.0):
        half, events = EVENT_HALF * scale, [document.events[number] for number in numbers]
        x, y = _beside(*spot, half, marks, view, scale)
        kind, one = events[0].kind, len(events) == 1
        title = "; ".join(f"{event.name}, {event.text}" for event in events[:MOST_TOLD])
        title = f"{_noun(kind, len(events))}: {title}"
        letter, number = ("", numbers[0]) if one else (str(len(events)), None)
        mark = Mark(
            kind, x, y, spot, half, title, letter=letter, scale=scale, event=number,
            has_parking=all(event.has_parking for event in events),
        )  # fmt: skip
        marks.append(mark)
    ends = (
        ("start", "origin", places.origins),
        ("end", "destination", places.destinations),
    )
    for kind, end, spots in ends:
        for spot, vehicles in _spots(document, spots, scale):
            names = ", ".join(dict.fromkeys(_end(vehicle, end).name for vehicle in vehicles))
            letters = ", ".join(vehicle.letter for vehicle in vehicles)
            most = 1 if len(document.vehicles) > CROWD else MOST_ENDS
            faces = [(vehicle.colour, vehicle.letter) for vehicle in vehicles]
            faced = [[vehicle] for vehicle in vehicles]
            if len(vehicles) > most:
                faces = [(CROWD_COLOUR, f"{len(vehicles)}\u00d7")]
                faced = [vehicles]
            title = say(f"script.mark-{kind}", n=len(vehicles), who=letters, place=names)
            title = ", ".join([title, *_late_texts(kind, vehicles)])
            for place, (colour, letter) in enumerate(faces):
                beside = spot[0] + BESIDE * scale * (place - (len(faces) - 1) / 2)
                late = kind == "end" and any(map(_is_late, faced[place]))
                half = (END_HALF + (BADGE if late else 0.0)) * scale
                x, y = _beside(beside, spot[1], half, marks, view, scale)
                marks.append(
                    Mark(kind, x, y, spot, half, title, colour, letter, scale, is_late=late)
                )
    return marks


def mark_pieces(marks: list[Mark]) -> list[Piece]:
    """Return marks as they are drawn, those of events last, so that they lie on top.

    Parameters
    ----------
    marks : list of Mark
        Of `placed_marks`.

    Returns
    -------
    list of Piece
        Each, after the line that ties it to its place.
    """
    below = [mark for mark in marks if not mark.is_event]
    above = [mark for mark in marks if mark.is_event]
    return [
        *(tie for mark in above for tie in _tie(mark)),
        *(piece for mark in below for piece in (*_tie(mark), _piece(mark))),
        *map(_piece, above),
    ]


def _piece(mark: Mark) -> Piece:
    common = {"x": f"{mark.x:.1f}", "y": f"{mark.y:.1f}", "scale": f"{mark.scale:g}"}
    if mark.is_event:
        count: Tree = Piece("static-count", {"count": mark.letter}) if mark.letter else NOTHING
        if not mark.has_parking:
            count = (count, Piece("static-unknown"))
        title = mark.title
        return Piece("static-event", {**common, "icon": mark.kind, "title": title, "count": count})
    late: dict[str, Tree] = {}
    if mark.kind == "end":
        late["late"] = Piece("static-late", {}) if mark.is_late else NOTHING
    return Piece(
        f"static-{mark.kind}",
        {
            **common,
            "colour": mark.colour,
            "letter": mark.letter,
            "size": letter_size(mark.letter),
            "title": mark.title,
            **late,
        },
    )


def _tie(mark: Mark) -> Iterator[Piece]:
    if mark.is_tied:
        x, y = mark.spot
        yield Piece(
            "static-leader",
            {"x1": f"{x:.1f}", "y1": f"{y:.1f}", "x2": f"{mark.x:.1f}", "y2": f"{mark.y:.1f}"},
        )


def _noun(kind: str, count: int) -> str:
    """Return what events of a kind are called, with their number if there are several."""
    return say(NOUNS[kind][0]) if count == 1 else say(NOUNS[kind][1], n=count)


def _is_late(vehicle: Vehicle) -> bool:
    return vehicle.times is not None and vehicle.times.is_late


def _late_texts(kind: str, vehicles: list[Vehicle]) -> Iterator[str]:
    """Yield how late those are who end somewhere, each named if they are several."""
    for vehicle in vehicles:
        if kind == "end" and _is_late(vehicle):
            text = say("script.mark-late", time=vehicle.day.text.late)
            yield f"{vehicle.letter}: {text}" if len(vehicles) > 1 else text


def _end(vehicle: Vehicle, end: str) -> Stop:
    return vehicle.origin if end == "origin" else vehicle.destination


def _event_spots(
    document: Document, spots: list[Point], reach: float
) -> list[tuple[Point, list[int]]]:
    """Return positions of events of one kind that lie within reach of the first of them."""
    found: list[tuple[Point, list[int]]] = []
    for number, (event, at) in enumerate(zip(document.events, spots, strict=True)):
        near = next(
            (
                numbers
                for spot, numbers in found
                if document.events[numbers[0]].kind == event.kind and math.dist(spot, at) < reach
            ),
            None,
        )
        if near is None:
            found.append((at, [number]))
        else:
            near.append(number)
    return found


def _spots(
    document: Document, spots: list[Point], scale: float
) -> list[tuple[Point, list[Vehicle]]]:
    """Return who starts or ends on one spot; in a crowd, near one another."""
    reach = NEAR * scale if len(document.vehicles) > CROWD else 0.01
    found: list[tuple[Point, list[Vehicle]]] = []
    for vehicle, at in zip(document.vehicles, spots, strict=True):
        near = next((who for spot, who in found if math.dist(spot, at) < reach), None)
        if near is None:
            found.append((at, [vehicle]))
        else:
            near.append(vehicle)
    return found


def _beside(
    x: float, y: float, half: float, marks: list[Mark], view: MapView, scale: float
) -> Point:
    """Return where a mark near (x, y) covers none before it; where it is, if all is taken."""
    for right, down in _FAN:
        a, b = x + right * scale, y + down * scale
        inside = half <= a <= view.width - half and half <= b <= view.height - half
        if inside and all(
            abs(a - mark.x) >= half + mark.half or abs(b - mark.y) >= half + mark.half
            for mark in marks
        ):
            return a, b
    return x, y
