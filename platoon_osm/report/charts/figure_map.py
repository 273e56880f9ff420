"""The map of a plan as a figure: the still map of the page, drawn in its pixels."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..document.model import Document
from ..drawing.lines import Point
from ..drawing.palette import FRAME, INK, LATE, MUTED, NETWORK, PAPER, PLATOON, PLATOON_CASING
from ..drawing.vehicle_styles import letter_size
from ..maps.beside import simplified
from ..maps.lanes import band_lines, band_width
from ..maps.map_texts import NAME_SIZE
from .figure_layout import CREDIT_SIZE, Layout, layout_of
from .paper import WIDTH_IN, axes_of, dash_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..maps.map_texts import Callout
    from ..maps.static_marks import Mark

__all__ = ["corridor"]

# What lies over what.
TIES, MARKS, CALLOUTS = 4, 5, 6

SIGNS: dict[str, Sequence[Sequence[Point]]] = {
    "break": [
        [(-6.4, -2.4), (3.2, -2.4), (3.2, 3), (0.2, 6), (-3.4, 6), (-6.4, 3), (-6.4, -2.4)],
        [(3.2, -1.2), (6.2, -0.6), (6.2, 2.6), (3.2, 3.2)],
        [(-3.6, -5), (-3.6, -7.2)],
        [(0.4, -5), (0.4, -7.2)],
    ],
    "rest": [
        [(-7, -5.4), (-7, 6)],
        [(-7, 3.2), (7.2, 3.2), (7.2, 6)],
        [(7.2, 3.2), (7.2, -2.4), (-0.4, -2.4), (-0.4, 3.2)],
        [(-4.4, -1.6), (-2.8, -1.6)],
    ],
    "ban": [[(-5.4, 0), (5.4, 0)]],
    "change": [
        [(-6, -3.2), (5.4, -3.2)],
        [(2.4, -6.2), (5.6, -3.2), (2.4, -0.2)],
        [(6, 3.4), (-5.4, 3.4)],
        [(-2.4, 0.4), (-5.6, 3.4), (-2.4, 6.4)],
    ],
    "wait": [[(-2.7, -4.4), (-2.7, 4.4)], [(2.7, -4.4), (2.7, 4.4)]],
}
"""Lines of the icon of each kind of pause, as the page has them: a cup, a bed, no entry."""

FACES = {"ban": (LATE, PAPER)}


def corridor(document: Document) -> Figure:
    """Return the map of a plan.

    Parameters
    ----------
    document : Document
        What is drawn.

    Returns
    -------
    Figure
        Of matplotlib.
    """
    layout = layout_of(document)
    figure, axes = axes_of(WIDTH_IN * layout.view.height / layout.view.width, layout="none")
    axes.set_position((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(0, layout.view.width)
    axes.set_ylim(layout.view.height, 0)
    drawing = _Drawing(axes, layout)
    drawing.roads(document)
    for mark in layout.marks:
        drawing.mark(mark)
    for one in layout.callouts:
        drawing.callout(one)
    for text, box in layout.names:
        drawing.text(box.left + box.width / 2, box.top + 9, text, NAME_SIZE, MUTED)
    text, box = layout.credit
    drawing.text(box.left + box.width / 2, box.top + box.height / 2, text, CREDIT_SIZE, MUTED)
    return figure


class _Drawing:
    """Axes whose units are the pixels of a layout."""

    def __init__(self, axes: Any, layout: Layout) -> None:
        self.axes, self.layout = axes, layout

    def points(self, pixels: float) -> float:
        """Return a width in points of paper that is so many pixels of the view."""
        return pixels * 72 * WIDTH_IN / self.layout.view.width

    def line(self, points: Sequence[Point], colour: str, pixels: float, **options: Any) -> None:
        """Draw a line so many pixels wide."""
        xs, ys = zip(*points, strict=True)
        options.setdefault("solid_capstyle", "butt")
        self.axes.plot(xs, ys, color=colour, linewidth=self.points(pixels), **options)

    def text(self, x: float, y: float, text: str, size: float, colour: str, **options: Any) -> None:
        """Write a text whose type is so many pixels high, round a point unless told otherwise."""
        options = {"ha": "center", "va": "center_baseline", **options}
        self.axes.text(x, y, text, size=self.points(size), color=colour, **options)

    def roads(self, document: Document) -> None:
        """Draw the network, roads driven alone, and bands of platoons."""
        from matplotlib.collections import LineCollection

        background = [simplified(self.layout.view.pixels(line)) for line in document.basemap.known]
        self.axes.add_collection(
            LineCollection(background, colors=NETWORK, linewidths=self.points(1.6))
        )
        for solo, points in zip(document.solos, self.layout.solos, strict=True):
            vehicle = document.vehicles[solo.vehicle]
            self.line(points, PAPER, 7.0)
            dashes = {"linestyle": (0, (0.1, 2.2)), "dash_capstyle": "round"}
            self.line(points, vehicle.colour, 3.6, **(dashes if solo.access else dash_of(vehicle)))
        for section, band in zip(document.platoons, self.layout.bands, strict=True):
            inner = band_width(len(section.vehicles))
            _, width = band_lines(len(section.vehicles))
            self.line(band.middle, PLATOON_CASING, inner + 2)
            self.line(band.middle, PLATOON, inner)
            for index, points in zip(section.vehicles, band.lanes, strict=True):
                vehicle = document.vehicles[index]
                self.line(points, vehicle.colour, width, **dash_of(vehicle))

    def mark(self, mark: Mark) -> None:
        """Draw a start, destination, merge or separation, as the page has them."""
        if mark.is_tied:
            self.line([mark.spot, (mark.x, mark.y)], MUTED, 1.0, zorder=TIES)
        if mark.is_event:
            self._event(mark)
            return
        self._face(mark, mark.kind == "start", 9.5, mark.colour, PAPER)
        self.text(
            mark.x, mark.y, mark.letter, float(letter_size(mark.letter)), PAPER,
            weight="bold", zorder=MARKS,
        )  # fmt: skip

        if mark.is_late:
            self._badge(mark.x + 9.5, mark.y - 9)

    def _badge(self, x: float, y: float) -> None:
        """Draw what tells that someone arrives too late."""
        from matplotlib.patches import Circle

        rim = self.points(1.2)
        badge = Circle((x, y), 5.6, facecolor=LATE, edgecolor=PAPER, linewidth=rim, zorder=MARKS)
        self.axes.add_patch(badge)
        self.text(x, y, "!", 9.5, PAPER, weight="bold", zorder=MARKS)

    def _face(self, mark: Mark, is_round: bool, half: float, colour: str, rim: str) -> None:
        from matplotlib.patches import Circle, FancyBboxPatch

        look: dict[str, Any] = {
            "facecolor": colour, "edgecolor": rim, "linewidth": self.points(1.6), "zorder": MARKS,
        }  # fmt: skip
        if is_round:
            self.axes.add_patch(Circle((mark.x, mark.y), half, **look))
            return
        corner = (mark.x - half + 0.5, mark.y - half + 0.5)
        side = 2 * half - 1
        self.axes.add_patch(
            FancyBboxPatch(corner, side, side, boxstyle="round,pad=0,rounding_size=3", **look)
        )

    def _event(self, mark: Mark) -> None:
        """Draw a disc with two lines that become one, or a diamond with one that becomes two."""
        from matplotlib.patches import Polygon

        def arrow(lines: Sequence[Sequence[Point]], heads: Sequence[Sequence[Point]]) -> None:
            ink = PAPER if mark.kind == "merge" else INK
            for points in lines:
                moved = [(mark.x + x, mark.y + y) for x, y in points]
                self.line(moved, ink, 2.0, zorder=MARKS, solid_capstyle="round")
            for points in heads:
                moved = [(mark.x + x, mark.y + y) for x, y in points]
                self.axes.add_patch(Polygon(moved, facecolor=ink, linewidth=0, zorder=MARKS))

        if mark.kind in SIGNS:
            self._face(mark, mark.kind == "ban", 10.5, *FACES.get(mark.kind, (PAPER, INK)))
            for points in SIGNS[mark.kind]:
                moved = [(mark.x + x, mark.y + y) for x, y in points]
                ink, width = (PAPER, 3.4) if mark.kind == "ban" else (INK, 1.7)
                self.line(moved, ink, width, zorder=MARKS, solid_capstyle="round")
            if not mark.has_parking:
                self.text(mark.x + 10, mark.y - 9, "?", 11, INK, weight="bold", zorder=MARKS)
            return
        if mark.kind == "merge":
            self._face(mark, True, 11.0, INK, PAPER)
            arrow(
                [[(-5.4, -4.8), (-0.8, 0), (-5.4, 4.8)], [(-0.8, 0), (3.4, 0)]],
                [[(2.8, -3.4), (7.6, 0), (2.8, 3.4)]],
            )
            return
        corners = [(0, -11.6), (11.6, 0), (0, 11.6), (-11.6, 0)]
        self.axes.add_patch(
            Polygon(
                [(mark.x + x, mark.y + y) for x, y in corners], facecolor=PAPER, edgecolor=INK,
                linewidth=self.points(1.8), joinstyle="round", zorder=MARKS,
            )
        )  # fmt: skip
        arrow(
            [[(-6.6, 0), (-2, 0)], [(2.2, -2.9), (-2, 0), (2.2, 2.9)]],
            [[(1.2, -4.6), (5.2, -5), (3.5, -1.4)], [(1.2, 4.6), (5.2, 5), (3.5, 1.4)]],
        )

    def callout(self, one: Callout) -> None:
        """Draw a box with a text beside an event."""
        from matplotlib.patches import FancyBboxPatch

        if one.near:
            self.line([(one.x, one.y), one.near], MUTED, 1.0, zorder=TIES)
        box = one.box
        self.axes.add_patch(
            FancyBboxPatch(
                (box.left, box.top), box.width, box.height, zorder=CALLOUTS, facecolor=PAPER,
                edgecolor=FRAME, linewidth=0.6, boxstyle="round,pad=0,rounding_size=4",
            )
        )  # fmt: skip
        left: dict[str, Any] = {"ha": "left", "va": "baseline", "zorder": CALLOUTS}
        self.text(box.left + 8, box.top + 14, one.head, 11.5, INK, weight="bold", **left)
        self.text(box.left + 8, box.top + 28, one.line, 11, MUTED, **left)
