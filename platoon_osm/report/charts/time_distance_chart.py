"""The time-distance diagram on the page: distance to the right, time down, a line a vehicle."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from ...plans.clock import duration
from ..document.model import Document
from ..drawing.crowd import MOST_SPOKEN
from ..drawing.lines import Point
from ..drawing.palette import CASING, INK, LATE, MUTED, REST, TICK
from ..language.speech import say
from ..maps.pause_icons import NOUNS
from ..markup.fragments import NOTHING, Piece, Tree
from .axes import SIZE, letter_type
from .sentences import sentence
from .time_distance import Course, Diagram, Spot, Stand, diagram_of
from .time_distance_layout import DiagramLayout, Slot, laid_out_diagram

__all__ = ["time_distance_chart"]

FILLS = {
    "wait": "url(#hatch)",
    "break": CASING,
    "rest": REST,
    "ban": "url(#stripes)",
    "change": INK,
}
"""What fills the box of each kind of standing."""

NOTES = {
    "break": "diagram.break",
    "rest": "diagram.rest",
    "ban": "schedule.ban",
    "change": "diagram.change",
}

LEAST_ICON = 15.0
"""A pause so high bears its icon, in pixels."""

LEAST_WAIT = 3.0
"""A wait is drawn at least so high, in pixels, or it would not be seen."""

LINE, QUIET_LINE = 2.4, 1.2


def time_distance_chart(document: Document, members: Sequence[int], key: str = "") -> Tree:
    """Return the diagram of the vehicles of a platoon.

    Parameters
    ----------
    document : Document
        Whose vehicles they are.
    members : sequence of int
        Their positions; those alone are left out.
    key : str
        Ends the ids in the picture, so that several stand on one page.

    Returns
    -------
    Tree
        An SVG; nothing if there are no times, no company, or no common scale of distance.
    """
    diagram = diagram_of(document, members)
    if diagram is None:
        return NOTHING
    layout = laid_out_diagram(diagram)
    return Piece(
        "time-distance",
        {
            "key": key,
            "width": f"{layout.width:g}",
            "height": f"{layout.height:.0f}",
            "left": f"{layout.left:.1f}",
            "right": f"{layout.right:.1f}",
            "top": f"{layout.top:.1f}",
            "bottom": f"{layout.bottom:.1f}",
            "floor": f"{layout.floor:.1f}",
            "from": diagram.begin_s,
            "per_second": f"{layout.per_second:.9g}",
            "per_metre": f"{layout.per_metre:.9g}",
            "hours": tuple(_hours(layout)),
            "places": tuple(_places(layout)),
            "distances": tuple(_distances(layout)),
            "bands": tuple(_bands(layout)),
            "waits": tuple(_waits(document, layout)),
            "held": tuple(_held_crowd(layout)),
            # The guide's line lies uppermost.
            "lines": tuple(
                _course(document, layout, course)
                for course in sorted(diagram.courses, key=lambda one: one.vehicle == diagram.guide)
            ),
            "events": tuple(_events(document, diagram, layout)),
            "badges": tuple(_badges(document, layout)),
            "note": _note(document, layout),
        },
    )


def _hours(layout: DiagramLayout) -> Iterator[Piece]:
    for tick in layout.hours:
        texts = tuple(
            Piece(
                "time-distance-text",
                {
                    "x": f"{layout.left - 18:.1f}",
                    "y": f"{tick.place + SIZE * (0.35 + number):.1f}",
                    "anchor": "end",
                    "text": text,
                },
            )
            for number, text in enumerate(tick.texts)
        )
        yield Piece(
            "time-distance-hour",
            {
                "x1": f"{layout.left - 14:.1f}",
                "x2": f"{layout.width:g}",
                "y": f"{tick.place:.1f}",
                "colour": MUTED if tick.strong else TICK,
                "dash": "5 3" if tick.strong else "none",
                "texts": texts,
            },
        )


def _places(layout: DiagramLayout) -> Iterator[Piece]:
    for flag in layout.flags:
        y = layout.row_y(flag.row)
        yield Piece(
            "time-distance-place",
            {
                "x": f"{flag.x:.1f}",
                "y1": f"{y - SIZE + 3:.1f}",
                "y2": f"{layout.floor:.1f}",
                "text_x": f"{flag.text_x:.1f}",
                "y": f"{y:.1f}",
                "anchor": flag.anchor,
                "text": flag.text,
            },
        )


def _distances(layout: DiagramLayout) -> Iterator[Piece]:
    for tick in layout.distances:
        yield Piece(
            "time-distance-km",
            {
                "x": f"{layout.x(tick.at * 1000):.1f}",
                "y1": f"{layout.floor - 3:.1f}",
                "y2": f"{layout.floor:.1f}",
                "text": Piece(
                    "time-distance-text",
                    {
                        "x": f"{tick.place:.1f}",
                        "y": f"{layout.floor + SIZE + 2:.1f}",
                        "anchor": "middle",
                        "text": tick.text,
                    },
                ),
            },
        )


def _written(points: Sequence[Point]) -> str:
    return " ".join(f"{round(x, 2):g},{round(y, 2):g}" for x, y in points)


def _bands(layout: DiagramLayout) -> Iterator[Piece]:
    for band in layout.diagram.bands:
        width = layout.band_width(band)
        yield Piece(
            "time-distance-band",
            {
                "vehicles": _vehicles(band.vehicles),
                "points": _written(layout.points([band.leg])),
                "outer": f"{width + 1.2:.1f}",
                "width": f"{width:.1f}",
            },
        )


def _waits(document: Document, layout: DiagramLayout) -> Iterator[Piece]:
    for slot in layout.waits:
        stand = slot.stand
        x, top, bottom = _wait(layout, slot)
        yield Piece(
            "time-distance-wait",
            {
                "vehicles": _vehicles(stand.vehicles),
                "x": f"{x - 3.5:.1f}",
                "y": f"{min(top, bottom - LEAST_WAIT):.1f}",
                "height": f"{max(bottom - top, LEAST_WAIT):.1f}",
                "title": _standing(document, stand),
                "fill": FILLS[stand.kind],
            },
        )


def _wait(layout: DiagramLayout, slot: Slot) -> tuple[float, float, float]:
    """Return where a wait is drawn, and from where to where."""
    stand = slot.stand
    return layout.x(stand.at_m) + slot.aside, layout.y(stand.begin_s), layout.y(stand.end_s)


def _course(document: Document, layout: DiagramLayout, course: Course) -> Piece:
    vehicle = document.vehicles[course.vehicle]
    quiet = layout.crowded and course.vehicle != layout.diagram.guide
    look = {
        "colour": MUTED if quiet else vehicle.colour,
        "width": f"{QUIET_LINE if quiet else LINE:g}",
        "dash": "none" if layout.crowded else vehicle.stroke,
        "cap": vehicle.cap,
        "opacity": "0.6" if quiet else "1",
    }
    parts = list(_lines(layout, course.vehicle))
    if not quiet:
        parts += _held(layout, course)
    parts += _windows(layout, course, vehicle.day.is_late, quiet)
    return Piece(
        "time-distance-vehicle",
        {**look, "index": course.vehicle, "title": sentence(vehicle), "parts": tuple(parts)},
    )


def _held(layout: DiagramLayout, course: Course) -> Iterator[Piece]:
    """Yield the while in which a vehicle could have left, with an arrow if it began before."""
    if course.held_from_s is None:
        return
    piece = layout.lines[course.vehicle][0]
    x, down = piece.first[0], piece.by[1]
    top, bottom = layout.y(course.held_from_s) + down, layout.y(course.leaves_s) + down
    values = {"x": f"{x:.1f}", "y1": f"{top:.1f}", "y2": f"{bottom:.1f}"}
    yield Piece("time-distance-held", values)
    if course.earliest_s is not None and course.earliest_s < course.held_from_s - 1:
        tip, side = f"L{x:.1f} {top + 1:.1f}", f"{top + 6:.1f}"
        arrow = f"M{x - 4:.1f} {side}{tip}L{x + 4:.1f} {side}"
        yield Piece("time-distance-earlier", {"arrow": arrow})


def _windows(layout: DiagramLayout, course: Course, late: bool, quiet: bool) -> Iterator[Piece]:
    """Yield bars at the earliest departure and the latest arrival; in a crowd where it is late."""
    pieces, diagram = layout.lines[course.vehicle], layout.diagram
    for moment, end, by, colour in (
        (course.earliest_s, pieces[0].first, pieces[0].by, MUTED),
        (course.latest_s, pieces[-1].last, pieces[-1].by, LATE if late else MUTED),
    ):
        near = moment is not None and diagram.begin_s - 1 <= moment <= diagram.end_s + 1
        if moment is not None and near and (colour == LATE or not quiet):
            y = layout.y(moment) + by[1]
            if colour == LATE:
                # As long as it is late.
                values = {"x": f"{end[0]:.1f}", "y1": f"{y:.1f}", "y2": f"{end[1]:.1f}"}
                yield Piece("time-distance-late", values)
            yield Piece(
                "time-distance-window",
                {
                    "x1": f"{end[0] - 7:.1f}",
                    "x2": f"{end[0] + 7:.1f}",
                    "y": f"{y:.1f}",
                    "colour": colour,
                    "width": "2.6" if colour == LATE else "1.6",
                },
            )


def _held_crowd(layout: DiagramLayout) -> Iterator[Piece]:
    """Yield for each start of a crowd the longest while in which somebody could have left."""
    if not layout.crowded:
        return
    longest: dict[Point, Course] = {}
    for course in layout.diagram.courses:
        if course.held_from_s is not None and course.vehicle != layout.diagram.guide:
            at = layout.lines[course.vehicle][0].first
            other = longest.get(at)
            if other is None or course.held_from_s < (other.held_from_s or 0.0):
                longest[at] = course
    for course in longest.values():
        yield from _held(layout, course)


def _lines(layout: DiagramLayout, vehicle: int) -> Iterator[Piece]:
    """Yield the line of a vehicle piece by piece, and what ties each piece to the next."""
    pieces = layout.lines[vehicle]
    waits = [slot for slot in layout.waits if vehicle in slot.stand.vehicles]
    for before, after in itertools.pairwise(pieces):
        way = [before.last, after.first]
        for slot in waits:
            x, top, bottom = _wait(layout, slot)
            if abs(bottom - after.points[0][1]) < 1:
                way[1:1] = [(x, top), (x, bottom)]
        yield Piece("time-distance-tie", {"points": _written(way)})
    for one in pieces:
        move = " ".join(f"{round(by, 2):g}" for by in one.by)
        yield Piece("time-distance-line", {"points": _written(one.points), "move": move})


def _events(document: Document, diagram: Diagram, layout: DiagramLayout) -> Iterator[Piece]:
    for spot in diagram.spots:
        event = document.events[spot.event]
        x, y = layout.x(spot.at_m), layout.y(spot.at_s)
        if event.until_s is not None:
            # Where it is drawn beside others that stand there too.
            x += _aside(layout, event.vehicles, spot)
            if (event.until_s - (event.at_s or 0.0)) * layout.per_second < LEAST_ICON:
                continue
        yield Piece(
            "time-distance-pause" if event.stands else "time-distance-event",
            {
                "index": spot.event,
                "title": f"{event.name}: {event.text}",
                "icon": event.kind,
                "x": f"{x:.1f}",
                "y": f"{y:.1f}",
            },
        )


def _aside(layout: DiagramLayout, vehicles: Sequence[int], spot: Spot) -> float:
    """Return how far beside its true place a pause is drawn."""
    return next(
        (
            slot.aside
            for slot in layout.waits
            if slot.stand.begin_s < spot.at_s < slot.stand.end_s
            and not set(vehicles).isdisjoint(slot.stand.vehicles)
        ),
        0.0,
    )


def _badges(document: Document, layout: DiagramLayout) -> Iterator[Piece]:
    for badge in layout.badges:
        vehicle = document.vehicles[badge.vehicle]
        yield Piece(
            "time-distance-start" if badge.is_start else "time-distance-end",
            {
                "index": badge.vehicle,
                "x": f"{badge.at_x:.1f}",
                "y": f"{badge.at_y:.1f}",
                "tie": f"M{badge.x:.1f} {badge.y:.1f}L{badge.at_x:.1f} {badge.at_y:.1f}",
                "colour": vehicle.colour,
                "letter": vehicle.letter,
                "size": letter_type(vehicle.letter),
            },
        )


def _vehicles(vehicles: Sequence[int]) -> str:
    return " ".join(map(str, vehicles))


def _standing(document: Document, stand: Stand) -> str:
    letters = [document.vehicles[index].letter for index in stand.vehicles]
    who = ", ".join(letters[:MOST_SPOKEN]) + ("\u2026" if len(letters) > MOST_SPOKEN else "")
    time = duration(stand.end_s - stand.begin_s)
    if stand.kind == "wait":
        return say("diagram.waits", who=who, time=time)
    return say("diagram.stands", who=who, what=say(NOUNS[stand.kind][0]), time=time)


def _note(document: Document, layout: DiagramLayout) -> str:
    diagram = layout.diagram
    parts = [say("diagram.axes", vehicle=document.vehicles[diagram.guide].letter)]
    parts.append(say("schedule.yellow"))
    kinds = {stand.kind for stand in diagram.waits}
    if "wait" in kinds:
        parts.append(say("schedule.hatched"))
    parts += (say(key) for kind, key in NOTES.items() if kind in kinds)
    if any(course.held_from_s is not None for course in diagram.courses):
        parts.append(say("schedule.dotted"))
    asked = ((one.earliest_s, one.latest_s) for one in diagram.courses)
    if not layout.crowded and any(at is not None for pair in asked for at in pair):
        parts.append(say("diagram.bars"))
    if any(document.vehicles[one.vehicle].day.is_late for one in diagram.courses):
        parts.append(say("diagram.late"))
    parts.append(say("diagram.approach"))
    return " ".join(parts)
