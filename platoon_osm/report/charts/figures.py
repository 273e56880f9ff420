"""Figures for papers with matplotlib, from the same document as the page.

Every text is drawn as it stands: matplotlib would read `$` as the beginning of a formula.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...atomic_file import all_or_none, whole_file
from ...costs.weights import EdgeWeights
from ...csv_tables import write_table
from ...errors import ScenarioError, brief
from ...network.road_network import RoadNetwork
from ...output_paths import checked_folder
from ...plans.plan import Plan
from ...shown_text import shortened
from ..document.checks import check_path
from ..document.document import document_of
from ..document.model import Document
from ..document.model_day import DaySchedule, JourneyScale
from ..document.model_vehicle import Vehicle
from ..drawing.palette import MUTED, PAPER, PLATOON, PLATOON_CASING
from ..language.speech import number, say, speaking
from .bill_figure import bill_figure
from .figure_map import corridor
from .paper import METADATA, axes_of, dash_of, drawing
from .schedule_figure import COLUMNS, draw_schedule, schedule_rows
from .time_distance_figure import diagrams

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["write_figures"]

FORMATS = ("png", "svg", "pdf")

DIGITS = 6
"""Of seconds in the table."""


def write_figures(
    plan: Plan,
    net: RoadNetwork,
    folder: str | os.PathLike[str],
    *,
    formats: Sequence[str] = FORMATS,
    weights: EdgeWeights | None = None,
    language: str | None = None,
    clock: int | None = None,
) -> list[Path]:
    """Write the figures of a plan into a folder, which is made if it is missing.

    They are `corridor` (the map), `costs` (bars of cost alone and as planned), of a plan in money
    `bill` (what is paid for what, alone and as planned, and what is saved of it), `way` (who drives
    with whom, by distance; left out where the plan has no common scale of distance) and, for a
    plan with times, `schedule` (who drives when), with its numbers in `schedule.csv`, and
    `time-distance` (where each vehicle of a platoon is when; of several platoons one each,
    `time-distance-2` and on). The same plan gives the same bytes.

    Parameters
    ----------
    plan : Plan
        What is drawn.
    net : RoadNetwork
        The network the plan was made on.
    folder : path-like
        Where they are written.
    formats : sequence of str
        Of "png" (300 dpi), "svg" and "pdf".
    weights : EdgeWeights or None
        Those the plan was made with; see `report_document`.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

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
    checked_folder(folder)
    written: list[Path] = []
    with speaking(language, clock), all_or_none(), drawing():
        document = document_of(plan, net, weights=weights)
        for name, figure in _figures(document):
            for kind in formats:
                path = folder / f"{name}.{kind}"
                with whole_file(path, suffixes=(f".{kind}",)) as draft:
                    figure.savefig(draft, dpi=300, metadata=METADATA[kind])
                written.append(path)
        if document.schedule is not None:
            path = folder / "schedule.csv"
            write_table(path, COLUMNS, schedule_rows(document, document.schedule), DIGITS)
            written.append(path)
    return written


def _check_formats(formats: object) -> None:
    if isinstance(formats, str) or not isinstance(formats, Iterable):
        raise ScenarioError(
            f'figures: formats {brief(formats)} is no list; give one such as ["png", "pdf"]'
        )
    for wanted in formats:
        if wanted not in FORMATS:
            raise ScenarioError(f"figures: format {brief(wanted)} is unknown; use png, svg or pdf")


def _figures(document: Document) -> Iterator[tuple[str, Figure]]:
    yield "corridor", corridor(document)
    yield "costs", _costs(document)
    if (bill := bill_figure(document)) is not None:
        yield "bill", bill
    if document.journey is not None:
        yield "way", _way(document, document.journey)
    if document.schedule is not None:
        yield "schedule", _schedule(document, document.schedule)
    yield from diagrams(document)


def _costs(document: Document) -> Figure:
    vehicles = document.vehicles
    figure, axes = axes_of(0.9 + 0.42 * len(vehicles))
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
    axes.set_xlabel(say("figures.costs", unit=label))
    # Costs of the document are in the plan's unit; the axis is read in that of the page.
    axes.xaxis.set_major_formatter(_in_unit(document))
    return figure


def _in_unit(document: Document) -> Any:
    from matplotlib.ticker import FuncFormatter

    scale = document.cost_unit.scale
    return FuncFormatter(lambda value, _: number(value * scale))


def _who(vehicle: Vehicle) -> str:
    first, last = (shortened(stop.brief, 16) for stop in (vehicle.origin, vehicle.destination))
    return f"{vehicle.letter}  {first} \u2013 {last}"


def _way(document: Document, scale: JourneyScale) -> Figure:
    vehicles = document.vehicles
    figure, axes = axes_of(0.9 + 0.34 * len(vehicles))
    for row, vehicle in enumerate(vehicles):
        at = start = scale.starts_m[row] / 1000
        for kind, piece in vehicle.way:
            km = document.piece_m(kind, piece) / 1000
            if kind == "platoon":
                axes.barh(
                    row, km, 0.6, left=at, color=PLATOON, edgecolor=PLATOON_CASING, linewidth=0.4
                )
            at += km
        axes.plot([start, at], [row, row], color=vehicle.colour, linewidth=2, **dash_of(vehicle))
        axes.plot([at], [row], "s", color=vehicle.colour, markersize=5)
    for event in document.events:
        if event.at_m is not None:
            axes.axvline(event.at_m / 1000, color=MUTED, linewidth=0.6)
    axes.set_yticks(range(len(vehicles)), [_who(vehicle) for vehicle in vehicles])
    axes.invert_yaxis()
    axes.set_xlabel(say("along.axis-platoon" if document.platoons else "along.axis"))
    return figure


def _schedule(document: Document, schedule: DaySchedule) -> Figure:
    vehicles = document.vehicles
    figure, axes = axes_of(0.9 + 0.46 * len(vehicles))
    draw_schedule(axes, document, schedule, [dash_of(vehicle) for vehicle in vehicles])
    axes.set_yticks(range(len(vehicles)), [_who(vehicle) for vehicle in vehicles])
    axes.set_ylim(len(vehicles) - 0.4, -0.6)
    return figure
