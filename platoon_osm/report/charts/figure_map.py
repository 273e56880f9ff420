"""The map of a plan as a figure: the still map of the page, drawn in its pixels."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...shown_text import shortened
from ..document.model import Document
from ..drawing.lines import Point
from ..drawing.palette import FRAME, INK, MUTED, NETWORK, PAPER, PLATOON, PLATOON_CASING
from ..maps.lanes import band_aside, band_lines, band_width, solo_aside
from ..maps.map_texts import placed_callouts, placed_names
from ..maps.map_view import MapView
from ..maps.pixels import laid, simplified
from ..maps.placement import Box, Cover
from .paper import WIDTH_IN, axes_of, dash_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..maps.map_texts import Callout

__all__ = ["corridor"]


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
    from matplotlib.collections import LineCollection

    view = MapView([document], heights=(320.0, 980.0), margin=44.0)
    cover = Cover(view.width, view.height)
    figure, axes = axes_of(WIDTH_IN * view.height / view.width, layout="none")
    axes.set_position((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(0, view.width)
    axes.set_ylim(view.height, 0)
    background = [simplified(view.pixels(line)) for line in document.basemap.known]
    axes.add_collection(LineCollection(background, colors=NETWORK, linewidths=_points(1.6, view)))
    _routes(axes, document, view, cover)
    _marks(axes, document, view, cover)
    places = view.places(document)
    for one in placed_callouts(document, places.events, cover):
        _callout(axes, one, view)
    for text, box in placed_names(document, places.towns, cover):
        axes.text(
            box.left + box.width / 2,
            box.top + 9,
            text,
            size=_points(11.5, view),
            color=MUTED,
            ha="center",
            va="center_baseline",
        )
    credit = " \u00b7 ".join(document.provenance.credits)
    axes.text(
        view.width - 6, view.height - 6, shortened(credit, 140), ha="right", fontsize=5, color=MUTED
    )
    return figure


def _points(pixels: float, view: MapView) -> float:
    """Return a width in points of paper that is so many pixels of the view."""
    return pixels * 72 * WIDTH_IN / view.width


def _routes(axes: Axes, document: Document, view: MapView, cover: Cover) -> None:
    vehicles = document.vehicles

    def line(points: list[Point], colour: str, pixels: float, **options: Any) -> None:
        xs, ys = zip(*points, strict=True)
        options.setdefault("solid_capstyle", "butt")
        axes.plot(xs, ys, color=colour, linewidth=_points(pixels, view), **options)

    for solo in document.solos:
        vehicle = vehicles[solo.vehicle]
        points = laid(
            [(simplified(view.pixels(part.line)), solo_aside(part, view)) for part in solo.parts]
        )
        cover.add_line(points)
        line(points, PAPER, 7.0)
        dashes = {"linestyle": (0, (0.1, 2.2)), "dash_capstyle": "round"}
        line(points, vehicle.colour, 3.6, **(dashes if solo.access else dash_of(vehicle)))
    for section in document.platoons:
        step, width = band_lines(len(section.vehicles))
        roads = [
            (simplified(view.pixels(part.line)), band_aside(part, view)) for part in section.parts
        ]
        asides = [
            (place - (len(section.vehicles) - 1) / 2) * step
            for place in range(len(section.vehicles))
        ]
        middle, *lanes = (
            laid([(road, band + aside) for road, band in roads]) for aside in (0.0, *asides)
        )
        inner = band_width(len(section.vehicles))
        line(middle, PLATOON_CASING, inner + 2)
        line(middle, PLATOON, inner)
        for index, points in zip(section.vehicles, lanes, strict=True):
            cover.add_line(points, weight=4)
            line(points, vehicles[index].colour, width, **dash_of(vehicles[index]))


def _marks(axes: Axes, document: Document, view: MapView, cover: Cover) -> None:
    for vehicle in document.vehicles:
        for stop, shape in ((vehicle.origin, "o"), (vehicle.destination, "s")):
            x, y = view.at(stop.lon, stop.lat)
            cover.add_box(Box(x - 10, y - 10, 20, 20))
            axes.plot(
                x,
                y,
                shape,
                color=vehicle.colour,
                markersize=_points(20, view),
                markeredgecolor=PAPER,
            )
            axes.text(
                x,
                y,
                vehicle.letter,
                ha="center",
                va="center_baseline",
                color=PAPER,
                size=_points(11, view),
                weight="bold",
            )
    for event in document.events:
        x, y = view.at(event.lon, event.lat)
        cover.add_box(Box(x - 10, y - 10, 20, 20))
        merge = event.kind == "merge"
        axes.plot(
            x,
            y,
            "o" if merge else "D",
            color=INK if merge else PAPER,
            zorder=5,
            markersize=_points(18 if merge else 15, view),
            markeredgecolor=PAPER if merge else INK,
        )


def _callout(axes: Axes, one: Callout, view: MapView) -> None:
    from matplotlib.patches import FancyBboxPatch

    if one.near:
        xs, ys = zip((one.x, one.y), one.near, strict=True)
        axes.plot(xs, ys, color=MUTED, linewidth=0.5, zorder=4)
    box = one.box
    axes.add_patch(
        FancyBboxPatch(
            (box.left, box.top),
            box.width,
            box.height,
            zorder=6,
            facecolor=PAPER,
            edgecolor=FRAME,
            linewidth=0.6,
            boxstyle="round,pad=0,rounding_size=4",
        )
    )
    axes.text(
        box.left + 8, box.top + 14, one.head, size=_points(11.5, view), weight="bold", zorder=7
    )
    axes.text(box.left + 8, box.top + 28, one.line, size=_points(11, view), color=MUTED, zorder=7)
