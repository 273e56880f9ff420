"""Where everything of a time-distance diagram stands, in pixels: for the page and for papers."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ..drawing.crowd import CROWD
from ..drawing.lines import Point
from ..maps.placement import Box
from .axes import SIZE, WIDTH, Tick, day_scale, number_scale, text_width
from .beside import Moved, Ribbon, aside_of, normal
from .flags import Flag, Flagged, flags
from .time_distance import Band, Diagram, Leg, Stand

__all__ = ["Badge", "DiagramLayout", "Slot", "laid_out_diagram"]

RADIUS = 10.0
"""Of a disc with a letter, and half a square."""

HEAD, FOOT = 26.0, 26.0
"""Blank above the first departure and below the last arrival, for discs and squares."""

HEIGHTS = ((3, 250.0), (CROWD, 300.0), (math.inf, 360.0))
"""Of the drawing, by number of vehicles."""

PER_HOUR, TALLEST = 18.0, 640.0
"""An hour is drawn so high at least, as far as the drawing does not become higher than this."""

BESIDE = 14.0
"""Badges stand at most so far left of the scale of distance, clear of the hours."""

SLOT = 8.0
"""Waits at one place stand so far beside one another."""


@dataclass(frozen=True, slots=True)
class Badge:
    """A disc or a square with a vehicle's letter, tied to the end of its line.

    Attributes
    ----------
    vehicle : int
        Position in the document.
    x, y : float
        Of the end of the line.
    at_x, at_y : float
        Of the badge's middle.
    is_start : bool
        Whether the line begins there.
    """

    vehicle: int
    x: float
    y: float
    at_x: float
    at_y: float
    is_start: bool

    @property
    def far(self) -> bool:
        """Whether it stands so far from the end of its line that it is tied to it."""
        return math.hypot(self.at_x - self.x, self.at_y - self.y) > 1.8 * RADIUS


@dataclass(frozen=True, slots=True)
class Slot:
    """A wait with its place in the drawing.

    Attributes
    ----------
    stand : Stand
        Who waits, where and when.
    aside : float
        How far beside its true place it is drawn, in pixels.
    """

    stand: Stand
    aside: float


@dataclass(frozen=True, slots=True)
class DiagramLayout:
    """A diagram in pixels.

    Attributes
    ----------
    diagram : Diagram
        What is drawn.
    width, height : float
        Of the whole picture.
    left, right : float
        Ends of the scale of distance.
    top, bottom : float
        Ends of the scale of time.
    ceiling, floor : float
        Ends of the drawing, with room for letters.
    size : float
        Of the type.
    hours, distances : list of Tick
        Of the scales.
    flags : list of Flag
        Names of places.
    waits : list of Slot
        Waits, side by side where several are at one place.
    lines : dict of int to list of Moved
        The pieces of each vehicle's line.
    badges : list of Badge
        Letters at the ends of lines; in a crowd only those of the guide.
    """

    diagram: Diagram
    width: float
    height: float
    left: float
    right: float
    top: float
    bottom: float
    ceiling: float
    floor: float
    size: float
    hours: list[Tick]
    distances: list[Tick]
    flags: list[Flag]
    waits: list[Slot]
    lines: dict[int, list[Moved]]
    badges: list[Badge]

    @property
    def crowded(self) -> bool:
        """Whether vehicles are too many for a line each that can be followed."""
        return len(self.diagram.courses) > CROWD

    @property
    def per_metre(self) -> float:
        """Pixels."""
        return (self.right - self.left) / self.diagram.end_m

    @property
    def per_second(self) -> float:
        """Pixels."""
        return (self.bottom - self.top) / (self.diagram.end_s - self.diagram.begin_s)

    def x(self, metres: float) -> float:
        """Return where a place is.

        Parameters
        ----------
        metres : float
            On the scale of distance.

        Returns
        -------
        float
            In pixels from the left.
        """
        return self.left + metres * self.per_metre

    def y(self, seconds: float) -> float:
        """Return where a moment is.

        Parameters
        ----------
        seconds : float
            On the clock of the plan.

        Returns
        -------
        float
            In pixels from the top.
        """
        return self.top + (seconds - self.diagram.begin_s) * self.per_second

    def points(self, legs: Sequence[Leg]) -> tuple[Point, ...]:
        """Return a line through the ends of legs, upright where a vehicle waits between two.

        Parameters
        ----------
        legs : sequence of Leg
            One after another.

        Returns
        -------
        tuple of tuple of float
            In pixels.
        """
        found: list[Point] = []
        for leg in legs:
            for metres, seconds in ((leg.begin_m, leg.begin_s), (leg.end_m, leg.end_s)):
                spot = round(self.x(metres), 2), round(self.y(seconds), 2)
                if not found or spot != found[-1]:
                    found.append(spot)
        return tuple(found)

    def row_y(self, row: int) -> float:
        """Return the base line of the names in a row of flags.

        Parameters
        ----------
        row : int
            0 is the lowest.

        Returns
        -------
        float
            In pixels from the top.
        """
        return self.ceiling - 6.0 - row * (self.size + 3.0)

    def band_width(self, band: Band) -> float:
        """Return how wide a platoon is drawn.

        Parameters
        ----------
        band : Band
            The stretch.

        Returns
        -------
        float
            In pixels.
        """
        count = len(band.vehicles)
        return min(4.0 + 1.2 * count, 22.0) if self.crowded else 5.0 + LANE * count

    def lane(self, band: Band, vehicle: int) -> float:
        """Return how far beside the middle of a platoon one of its lines runs.

        Parameters
        ----------
        band : Band
            The stretch.
        vehicle : int
            Position in the document.

        Returns
        -------
        float
            In pixels to the right.
        """
        if self.crowded:
            return 0.0
        return (band.vehicles.index(vehicle) - (len(band.vehicles) - 1) / 2) * LANE


LANE = 3.2
"""Lines of vehicles in a platoon lie so far apart, in pixels."""


def laid_out_diagram(diagram: Diagram, width: float = WIDTH, size: float = SIZE) -> DiagramLayout:
    """Lay out a diagram.

    Parameters
    ----------
    diagram : Diagram
        What is drawn.
    width : float
        Of the picture, in pixels.
    size : float
        Of its type.

    Returns
    -------
    DiagramLayout
        Everything in its place.
    """
    count = len(diagram.courses)
    tall = next(height for most, height in HEIGHTS if count <= most)
    span = diagram.end_s - diagram.begin_s
    # A day with a night in it is drawn higher, or it would be squeezed into nothing.
    tall = min(max(tall, span / 3600 * PER_HOUR), TALLEST)
    hours = day_scale(
        diagram.clock,
        diagram.begin_s,
        diagram.end_s,
        lambda at: (at - diagram.begin_s) / span * tall,
        size=size,
    )
    labels = max((text_width(text, size) for tick in hours for text in tick.texts), default=0.0)
    left, right = labels + BESIDE + 7.0, width - RADIUS - 2.0
    per_metre = (right - left) / diagram.end_m
    hung = flags(
        [Flagged(left + one.at_m * per_metre, one.name, one.weight) for one in diagram.places],
        width,
        size,
    )
    rows = max((flag.row for flag in hung), default=-1) + 1
    ceiling = rows * (size + 3.0) + 8.0
    top = ceiling + HEAD
    bottom = top + tall
    floor = bottom + FOOT
    bare = DiagramLayout(
        diagram=diagram,
        width=width,
        height=floor + size + 8.0,
        left=left,
        right=right,
        top=top,
        bottom=bottom,
        ceiling=ceiling,
        floor=floor,
        size=size,
        hours=[Tick(t.at, t.place + top, t.text, t.below, t.strong) for t in hours],
        distances=number_scale(
            diagram.end_m / 1000, per_metre * 1000, left, (0.0, width), "km", size=size
        ),
        flags=hung,
        waits=[],
        lines={},
        badges=[],
    )
    bare.waits.extend(_slots(bare))
    bare.lines.update(_lines(bare))
    bare.badges.extend(_badges(bare))
    return bare


def _lines(layout: DiagramLayout) -> dict[int, list[Moved]]:
    """Return the pieces of each line, moved beside one another; the guide's keeps its place."""
    diagram = layout.diagram
    bands = {band.piece: band for band in diagram.bands}
    drawn = [
        Ribbon(layout.points([band.leg]), 0.0, layout.band_width(band) / 2)
        for band in diagram.bands
    ]
    found: dict[int, list[Moved]] = {}
    # In a crowd many drive alike; those lie on one another.
    alike: dict[tuple[Point, ...], float] = {}
    for course in sorted(diagram.courses, key=lambda one: one.vehicle != diagram.guide):
        pieces = found.setdefault(course.vehicle, [])
        for piece, legs in itertools.groupby(course.legs, key=lambda leg: leg.band):
            points = layout.points(list(legs))
            if piece is not None:
                aside = layout.lane(bands[piece], course.vehicle)
            else:
                if not (layout.crowded and points in alike):
                    is_guide = course.vehicle == diagram.guide
                    alike[points] = 0.0 if is_guide else aside_of(points, drawn)
                    drawn.append(Ribbon(points, alike[points], 0.0))
                aside = alike[points]
            across, up = normal(points)
            pieces.append(Moved(points, (across * aside, up * aside)))
    return found


def _slots(layout: DiagramLayout) -> Iterator[Slot]:
    """Yield waits so that those at one place and time stand side by side, the longest first."""
    if layout.crowded:
        yield from (Slot(stand, 0.0) for stand in _together(layout.diagram.waits))
        return
    taken: list[tuple[float, float, float]] = []
    for stand in sorted(layout.diagram.waits, key=lambda one: (one.begin_s - one.end_s, one.at_m)):
        x, top, bottom = layout.x(stand.at_m), layout.y(stand.begin_s), layout.y(stand.end_s)
        asides = (SLOT * k * sign for k in range(CROWD + 1) for sign in (-1, 1))
        aside = next(
            (
                one
                for one in asides
                if layout.left - SLOT <= x + one <= layout.width - SLOT / 2
                and all(
                    abs(x + one - other) >= SLOT - 0.1 or bottom < high or low < top
                    for other, high, low in taken
                )
            ),
            0.0,
        )
        taken.append((x + aside, top, bottom))
        yield Slot(stand, aside)


def _together(waits: Sequence[Stand]) -> Iterator[Stand]:
    """Yield one wait for all who wait at one place for one merge, as long as the longest."""
    found: dict[tuple[int, int], list[Stand]] = {}
    for wait in waits:
        found.setdefault((round(wait.at_m), round(wait.end_s)), []).append(wait)
    for some in found.values():
        first = min(some, key=lambda one: one.begin_s)
        who = tuple(sorted(vehicle for one in some for vehicle in one.vehicles))
        yield Stand(first.at_m, first.begin_s, first.end_s, who)


def _badges(layout: DiagramLayout) -> Iterator[Badge]:
    """Yield letters at both ends of each line, near them and apart from one another."""
    diagram = layout.diagram
    ends: list[tuple[int, float, float, bool]] = []
    for course in diagram.courses:
        if layout.crowded and course.vehicle != diagram.guide:
            continue
        pieces = layout.lines[course.vehicle]
        x, y = pieces[0].first
        # Where it could have left, or has left and waits at once.
        since = course.leaves_s if course.held_from_s is None else course.held_from_s
        y -= layout.y(course.legs[0].begin_s) - layout.y(since)
        ends.append((course.vehicle, x, y, True))
        ends.append((course.vehicle, *pieces[-1].last, False))
    taken = [
        Box(layout.x(spot.at_m) - 7, layout.y(spot.at_s) - 7, 14, 14) for spot in diagram.spots
    ]
    for vehicle, x, y, is_start in ends:
        box = next(
            (
                box
                for box in _around(x, y, is_start)
                if box.left >= layout.left - BESIDE
                and box.right <= layout.width
                and box.top >= layout.ceiling
                and box.bottom <= layout.floor
                and not any(_touch(box, other) for other in taken)
            ),
            None,
        )
        if box is not None:
            taken.append(box)
            middle = box.left + box.width / 2, box.top + box.height / 2
            yield Badge(vehicle, x, y, *middle, is_start)


def _around(x: float, y: float, is_start: bool) -> Iterator[Box]:
    """Yield boxes near the end of a line: first where the line does not run, then farther off."""
    up = -1 if is_start else 1
    turns = (90, 135, 180, 45, 0) if is_start else (90, 45, 0, 135, 180)
    for away, turn in itertools.product((13, 20, 24, 34, 46, 58, 72, 90, 110), turns):
        angle = math.radians(turn)
        middle_x = x + math.cos(angle) * away
        middle_y = y + up * math.sin(angle) * away
        yield Box(middle_x - RADIUS, middle_y - RADIUS, 2 * RADIUS, 2 * RADIUS)


def _touch(box: Box, other: Box) -> bool:
    return (
        box.left < other.right
        and other.left < box.right
        and box.top < other.bottom
        and other.top < box.bottom
    )
