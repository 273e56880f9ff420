"""Break-even, for papers: kilometres together against detour and against waiting.

A line for each objective. They are straight and begin at nothing, so one point of each tells it;
what never pays has no line, and says so.
"""

from __future__ import annotations

import math
import os
from typing import TYPE_CHECKING

from ...atomic_file import whole_file
from ...costs.break_even import BreakEven
from ...errors import ScenarioError, brief
from ...shown_text import shortened
from ..document.checks import check_path
from ..drawing.palette import TICK, VEHICLES
from ..language.speech import say, speaking
from .paper import METADATA, WIDTH_IN, drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["write_break_even"]

DETOUR_KM, WAITING_MIN = 20.0, 30.0
"""How far the axes go."""

DASHES = ("-", "--", "-.", ":")
"""Beside colours, so that lines are told apart in grey."""


def write_break_even(
    found: BreakEven,
    path: str | os.PathLike[str],
    *,
    language: str | None = None,
    clock: int | None = None,
) -> None:
    """Write the figure of what has to be driven together for a detour, or for a wait, to pay.

    Parameters
    ----------
    found : BreakEven
        What is drawn.
    path : path-like
        Of the file: .png (300 dpi), .svg or .pdf.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; no time of day is on the figure.

    Raises
    ------
    ScenarioError
        No break-even, another kind of file, or one that cannot be written.
    """
    if not isinstance(found, BreakEven):
        raise ScenarioError(f"figure: {brief(found)} is no break-even; give one from break_even")
    place = check_path(path)
    kind = place.suffix[1:].lower()
    if kind not in METADATA:
        raise ScenarioError(f"figure: {place.name}: use .png, .svg or .pdf")
    with speaking(language, clock), drawing():
        figure = _figure(found)
        with whole_file(place, suffixes=(place.suffix,)) as draft:
            figure.savefig(draft, format=kind, dpi=300, metadata=METADATA[kind])


def _figure(found: BreakEven) -> Figure:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH_IN, 2.8), layout="constrained")
    detour, waiting = figure.subplots(1, 2, sharey=True)
    _lines(detour, found, DETOUR_KM, [row.km_per_detour_km for row in found.table])
    _lines(waiting, found, WAITING_MIN, [row.km_per_waiting_min for row in found.table])
    detour.set_xlabel(say("figures.detour"))
    waiting.set_xlabel(say("figures.waited"))
    detour.set_ylabel(say("figures.together"))
    handles, labels = waiting.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside right upper", frameon=False, handlelength=2.6)
    return figure


def _lines(axes: Axes, found: BreakEven, most: float, slopes: list[float]) -> None:
    """Draw a line through nothing for each row that pays at all."""
    for place, (row, slope) in enumerate(zip(found.table, slopes, strict=True)):
        name = shortened(row.name, 24)
        pays = math.isfinite(slope)
        axes.plot(
            [0, most] if pays else [], [0, most * slope] if pays else [],
            color=VEHICLES[place % len(VEHICLES)], linestyle=DASHES[place % len(DASHES)],
            linewidth=1.4, label=name if pays else say("figures.never-pays", name=name),
        )  # fmt: skip
    axes.set_xlim(0, most)
    axes.set_ylim(bottom=0)
    axes.grid(color=TICK, linewidth=0.6)
    axes.set_axisbelow(True)
