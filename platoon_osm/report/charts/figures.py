"""Figures for papers with matplotlib, from the same document as the page.

Every text is drawn as it stands: matplotlib would read `$` as the beginning of a formula.
"""

from __future__ import annotations

import csv
import os
import warnings
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...atomic_file import whole_file
from ...costs.weights import EdgeWeights
from ...errors import ScenarioError
from ...network.road_network import RoadNetwork
from ...plans.records import JointPlan
from ..document.checks import check_path
from ..document.document import document_of
from ..document.model import Document
from ..document.model_day import DaySchedule, JourneyScale
from ..document.model_vehicle import Vehicle
from ..drawing.palette import (
    FRAME,
    INK,
    MUTED,
    NETWORK,
    PAPER,
    PLATOON,
    PLATOON_CASING,
)
from ..maps.map_texts import placed_callouts, placed_names
from ..maps.map_view import (
    MapView,
    band_aside,
    band_lines,
    band_width,
    laid,
    solo_aside,
)
from ..maps.placement import Box, Cover
from ..markup.shown_text import shortened
from .schedule_figure import COLUMNS, draw_schedule, schedule_rows

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..drawing.lines import Point
    from ..maps.map_texts import Callout

__all__ = ["write_figures"]

FORMATS = ("png", "svg", "pdf")
WIDTH_IN = 7.2

STYLE: Any = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 8,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": MUTED,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "text.parse_math": False,
    "svg.hashsalt": "platoon_osm",
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
    "axes.formatter.use_mathtext": False,
    "axes.spines.top": False,
    "axes.spines.right": False,
}


def write_figures(
    plan: JointPlan,
    net: RoadNetwork,
    folder: str | os.PathLike[str],
    *,
    formats: Sequence[str] = FORMATS,
    weights: EdgeWeights | None = None,
) -> list[Path]:
    """Write the figures of a plan into a folder that exists.

    They are `corridor` (the map), `costs` (bars of cost alone and as planned), `way` (who drives
    with whom, by distance; left out where the plan has no common scale of distance) and, for a
    plan with times, `schedule` (who drives when), with its numbers in `schedule.csv`. The same
    plan gives the same bytes.

    Parameters
    ----------
    plan : JointPlan
        What is drawn.
    net : RoadNetwork
        The network the plan was made on.
    folder : path-like
        Where they are written.
    formats : sequence of str
        Of "png" (300 dpi), "svg" and "pdf".
    weights : EdgeWeights or None
        Those the plan was made with; see `report_document`.

    Returns
    -------
    list of Path
        What was written.

    Raises
    ------
    ScenarioError
        An unknown format, a plan of another network, or a folder that cannot be written to.
    """
    _check_formats(formats)
    folder = check_path(folder)
    document = document_of(plan, net, weights=weights)
    written: list[Path] = []
    with _drawing():
        for name, figure in _figures(document):
            for kind in formats:
                path = folder / f"{name}.{kind}"
                with whole_file(path, suffix=f".{kind}") as draft:
                    figure.savefig(draft, dpi=300, metadata=_METADATA[kind])
                written.append(path)
    if document.schedule is not None:
        path = folder / "schedule.csv"
        with (
            whole_file(path, suffix=".csv") as draft,
            draft.open("w", encoding="utf-8", newline="") as handle,
        ):
            table = csv.writer(handle, lineterminator="\n")
            table.writerows([COLUMNS, *schedule_rows(document, document.schedule)])
        written.append(path)
    return written


def _check_formats(formats: object) -> None:
    if isinstance(formats, str) or not isinstance(formats, Iterable):
        raise ScenarioError(
            f'figures: formats {formats!r} is no list; give one such as ["png", "pdf"]'
        )
    for wanted in formats:
        if wanted not in FORMATS:
            raise ScenarioError(f"figures: format {wanted!r} is unknown; use png, svg or pdf")


# A date would make two runs differ.
_METADATA: dict[str, dict[str, Any]] = {
    "png": {"Software": "platoon_osm"},
    "svg": {"Date": None, "Creator": "platoon_osm"},
    "pdf": {"CreationDate": None, "Creator": "platoon_osm", "Producer": "matplotlib"},
}


@contextmanager
def _drawing() -> Iterator[None]:
    import matplotlib

    with matplotlib.rc_context(STYLE), warnings.catch_warnings():
        # Letters that the font lacks are drawn as boxes; there is nothing to do about them.
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        warnings.filterwarnings("ignore", message="Matplotlib currently does not support")
        yield


def _figures(document: Document) -> Iterator[tuple[str, Figure]]:
    yield "corridor", _corridor(document)
    yield "costs", _costs(document)
    if document.journey is not None:
        yield "way", _way(document, document.journey)
    if document.schedule is not None:
        yield "schedule", _schedule(document, document.schedule)


def _axes(height_in: float, layout: Any = "constrained") -> tuple[Figure, Axes]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH_IN, height_in), layout=layout)
    return figure, figure.add_subplot()


# -- the map ---------------------------------------------------------------------------------------


def _corridor(document: Document) -> Figure:
    """Return the still map of the page, drawn in its pixels."""
    from matplotlib.collections import LineCollection

    view = MapView([document], heights=(320.0, 980.0), margin=44.0)
    cover = Cover(view.width, view.height)
    figure, axes = _axes(WIDTH_IN * view.height / view.width, layout="none")
    axes.set_position((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(0, view.width)
    axes.set_ylim(view.height, 0)
    background = [view.pixels(line) for line in document.basemap.known]
    axes.add_collection(LineCollection(background, colors=NETWORK, linewidths=_points(1.6, view)))
    _routes(axes, document, view, cover)
    _marks(axes, document, view, cover)
    for one in placed_callouts(document, view, cover):
        _callout(axes, one, view)
    for text, box in placed_names(document, view, cover):
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
        points = laid([(view.pixels(part.line), solo_aside(part, view)) for part in solo.parts])
        cover.add_line(points)
        line(points, PAPER, 7.0)
        line(points, vehicle.colour, 3.6, **_dash(vehicle))
    for section in document.platoons:
        step, width = band_lines(len(section.vehicles))
        roads = [(view.pixels(part.line), band_aside(part, view)) for part in section.parts]
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
            line(points, vehicles[index].colour, width, **_dash(vehicles[index]))


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


def _dash(vehicle: Vehicle) -> dict[str, Any]:
    # matplotlib counts dashes in line widths, the page in pixels of a line 3.6 wide.
    dash = [float(length) / 3.6 for length in vehicle.dash.split()]
    return {"linestyle": (0, tuple(dash)), "dash_capstyle": vehicle.cap} if dash else {}


# -- charts ----------------------------------------------------------------------------------------


def _costs(document: Document) -> Figure:
    vehicles = document.vehicles
    figure, axes = _axes(0.9 + 0.42 * len(vehicles))
    most = max((vehicle.solo_cost for vehicle in vehicles), default=1.0) or 1.0
    for row, vehicle in enumerate(vehicles):
        axes.barh(
            row - 0.19,
            vehicle.solo_cost,
            0.36,
            color=PAPER,
            edgecolor=MUTED,
            hatch="////",
            linewidth=0.6,
        )
        axes.barh(row + 0.19, vehicle.joint_cost, 0.36, color=vehicle.colour)
        axes.annotate(
            f"{vehicle.text.saved} ({vehicle.text.share})",
            (max(vehicle.solo_cost, vehicle.joint_cost), row),
            (5, 0),
            textcoords="offset points",
            va="center",
            fontsize=7,
        )
    axes.set_xlim(0, most * 1.22)
    axes.set_yticks(range(len(vehicles)), [_who(vehicle) for vehicle in vehicles])
    axes.invert_yaxis()
    label = document.cost_unit.label
    axes.set_xlabel(f"Cost, {label}: hatched alone, coloured as planned")
    # Costs of the document are in the plan's unit; the axis is read in that of the page.
    axes.xaxis.set_major_formatter(_in_unit(document))
    return figure


def _in_unit(document: Document) -> Any:
    from matplotlib.ticker import FuncFormatter

    scale = document.cost_unit.scale
    return FuncFormatter(lambda value, _: f"{value * scale:,.0f}")


def _who(vehicle: Vehicle) -> str:
    first, last = (shortened(stop.name, 16) for stop in (vehicle.origin, vehicle.destination))
    return f"{vehicle.letter}  {first} \u2013 {last}"


def _way(document: Document, scale: JourneyScale) -> Figure:
    vehicles = document.vehicles
    figure, axes = _axes(0.9 + 0.34 * len(vehicles))
    for row, vehicle in enumerate(vehicles):
        at = start = scale.starts_m[row] / 1000
        for kind, piece in vehicle.way:
            km = document.piece_m(kind, piece) / 1000
            if kind == "platoon":
                axes.barh(
                    row, km, 0.6, left=at, color=PLATOON, edgecolor=PLATOON_CASING, linewidth=0.4
                )
            at += km
        axes.plot([start, at], [row, row], color=vehicle.colour, linewidth=2, **_dash(vehicle))
        axes.plot([at], [row], "s", color=vehicle.colour, markersize=5)
    for event in document.events:
        if event.at_m is not None:
            axes.axvline(event.at_m / 1000, color=MUTED, linewidth=0.6)
    axes.set_yticks(range(len(vehicles)), [_who(vehicle) for vehicle in vehicles])
    axes.invert_yaxis()
    axes.set_xlabel("Distance, km; yellow: in the platoon; lines: merges and separations")
    return figure


def _schedule(document: Document, schedule: DaySchedule) -> Figure:
    vehicles = document.vehicles
    figure, axes = _axes(0.9 + 0.46 * len(vehicles))
    draw_schedule(axes, document, schedule, [_dash(vehicle) for vehicle in vehicles])
    axes.set_yticks(range(len(vehicles)), [_who(vehicle) for vehicle in vehicles])
    axes.set_ylim(len(vehicles) - 0.4, -0.6)
    return figure
