"""The time-distance diagram for papers: the layout of the page, a point of paper for each pixel."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from ..document.model import Document
from ..drawing.lines import Point
from ..drawing.palette import FRAME, INK, LATE, MUTED, PAPER, PLATOON, PLATOON_CASING
from .paper import WIDTH_IN, axes_of, dash_of
from .schedule_figure import LOOKS
from .time_distance import Course, diagram_of
from .time_distance_layout import DiagramLayout, laid_out_diagram

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["diagrams"]

POINTS_PER_IN = 72.0

TYPE_SIZE = 8.0

GRID, ROADS, LINES, MARKS = 1, 2, 3, 4
"""What lies over what."""


def diagrams(document: Document) -> Iterator[tuple[str, Figure]]:
    """Yield the diagram of each platoon that has one, with its name.

    Parameters
    ----------
    document : Document
        Whose platoons they are.

    Yields
    ------
    tuple of str and Figure
        "time-distance" for the first, "time-distance-2" for the second, and on.
    """
    count = 0
    for group in document.groups:
        diagram = diagram_of(document, group.vehicles) if group.is_platoon else None
        if diagram is not None:
            count += 1
            layout = laid_out_diagram(diagram, WIDTH_IN * POINTS_PER_IN, TYPE_SIZE)
            yield (
                f"time-distance-{count}" if count > 1 else "time-distance",
                _drawn(document, layout),
            )


def _drawn(document: Document, layout: DiagramLayout) -> Figure:
    figure, axes = axes_of(layout.height / POINTS_PER_IN, layout="none")
    axes.set_position((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(0, layout.width)
    axes.set_ylim(layout.height, 0)
    pen = _Pen(axes, layout)
    pen.scales()
    for band in layout.diagram.bands:
        points, width = layout.points([band.leg]), layout.band_width(band)
        pen.line(points, PLATOON_CASING, width + 1, ROADS)
        pen.line(points, PLATOON, width, ROADS)
    for slot in layout.waits:
        x = layout.x(slot.stand.at_m) + slot.aside
        top, bottom = layout.y(slot.stand.begin_s), layout.y(slot.stand.end_s)
        pen.wait(x, top, bottom, slot.stand.kind)
    for course in layout.diagram.courses:
        pen.course(document, course)
    for spot in layout.diagram.spots:
        event = document.events[spot.event]
        if event.stands:
            continue
        kind = event.kind
        pen.spot(layout.x(spot.at_m), layout.y(spot.at_s), kind)
    for badge in layout.badges:
        vehicle = document.vehicles[badge.vehicle]
        pen.line([(badge.x, badge.y), (badge.at_x, badge.at_y)], vehicle.colour, 0.6, LINES)
        shape = "o" if badge.is_start else "s"
        axes.plot(
            [badge.at_x], [badge.at_y], shape, color=vehicle.colour, markersize=13, zorder=MARKS
        )
        axes.text(
            badge.at_x,
            badge.at_y,
            vehicle.letter,
            color=PAPER,
            fontsize=7.5 if len(vehicle.letter) < 3 else 5,
            fontweight="bold",
            ha="center",
            va="center_baseline",
            zorder=MARKS + 1,
        )
    return figure


class _Pen:
    """Axes whose units are the pixels of a layout, a point of paper each."""

    def __init__(self, axes: Any, layout: DiagramLayout) -> None:
        self.axes, self.layout = axes, layout

    def line(
        self, points: Sequence[Point], colour: str, width: float, order: float, **look: Any
    ) -> None:
        xs, ys = zip(*points, strict=True)
        options = {"solid_capstyle": "butt", **look}
        self.axes.plot(xs, ys, color=colour, linewidth=width, zorder=order, **options)

    def text(self, x: float, y: float, text: str, anchor: str, colour: str = MUTED) -> None:
        size = self.layout.size
        self.axes.text(x, y, text, ha=anchor, va="baseline", color=colour, fontsize=size)

    def scales(self) -> None:
        layout = self.layout
        for tick in layout.hours:
            ends = [(layout.left - 14, tick.place), (layout.width, tick.place)]
            dash = {"linestyle": (0, (5, 3))} if tick.strong else {}
            self.line(ends, MUTED if tick.strong else FRAME, 0.5, GRID, **dash)
            for number, text in enumerate(tick.texts):
                y = tick.place + layout.size * (0.35 + number)
                self.text(layout.left - 18, y, text, "right")
        for flag in layout.flags:
            y = layout.row_y(flag.row)
            self.line([(flag.x, y - layout.size + 3), (flag.x, layout.floor)], FRAME, 0.6, GRID)
            self.text(flag.text_x, y, flag.text, "left" if flag.anchor == "start" else "right", INK)
        self.line([(layout.left, layout.floor), (layout.width, layout.floor)], MUTED, 0.6, GRID)
        for tick in layout.distances:
            x = layout.x(tick.at * 1000)
            self.line([(x, layout.floor - 3), (x, layout.floor)], MUTED, 0.6, GRID)
            self.text(tick.place, layout.floor + layout.size + 2, tick.text, "center")

    def wait(self, x: float, top: float, bottom: float, kind: str) -> None:
        high = max(bottom - top, 2.5)
        self.axes.bar(x, high, 6, bottom - high, zorder=LINES, **LOOKS[kind])

    def course(self, document: Document, course: Course) -> None:
        layout = self.layout
        vehicle = document.vehicles[course.vehicle]
        quiet = layout.crowded and course.vehicle != layout.diagram.guide
        colour, width = (MUTED, 0.6) if quiet else (vehicle.colour, 1.6)
        order = LINES + (0.1 if quiet else 0.2)
        dash = {} if layout.crowded else dash_of(vehicle)
        pieces = layout.lines[course.vehicle]
        for before, after in itertools.pairwise(pieces):
            self.line([before.last, after.first], colour, width, order)
        for piece in pieces:
            moved = [(x + piece.by[0], y + piece.by[1]) for x, y in piece.points]
            self.line(moved, colour, width, order, **dash)
        if course.held_from_s is not None:
            (x, _), down = pieces[0].first, pieces[0].by[1]
            ends = [(x, layout.y(at) + down) for at in (course.held_from_s, course.leaves_s)]
            self.line(ends, MUTED, 1.2, LINES, linestyle=(0, (1, 2)))
        if course.latest_s is not None and course.latest_s <= layout.diagram.end_s + 1:
            (x, _), down = pieces[-1].last, pieces[-1].by[1]
            y = layout.y(course.latest_s) + down
            colour = LATE if vehicle.day.is_late else MUTED
            self.line([(x - 6, y), (x + 6, y)], colour, 1.4, LINES)

    def spot(self, x: float, y: float, kind: str) -> None:
        merge = kind == "merge"
        self.axes.plot(
            [x],
            [y],
            "o" if merge else "D",
            color=INK if merge else PAPER,
            markeredgecolor=PAPER if merge else INK,
            markersize=7 if merge else 6,
            markeredgewidth=0.9,
            zorder=MARKS,
        )
