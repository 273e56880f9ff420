"""What another figure would save, for papers: a small plot for each figure that is varied.

Saving is drawn against the value, with a band up to what no plan under the conditions of its proof
exceeds. A value whose plan is another than that of the value before has an open circle.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil
from typing import TYPE_CHECKING

from ...plans.what_if import WhatIf
from ...shown_text import shortened
from ..document.wording import plan_unit
from ..drawing.palette import GAIN, INK, MUTED, PAPER, TICK
from ..language.speech import say
from .paper import WIDTH_IN
from .what_if_texts import figure_name, figure_unit, in_order, new_plans

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["what_if_figure"]

BESIDE = 3
"""Plots in a row."""


def what_if_figure(studies: Sequence[WhatIf]) -> Figure:
    """Return the figure of one figure that is varied, or of several.

    Parameters
    ----------
    studies : sequence of WhatIf
        One or more.

    Returns
    -------
    Figure
        Of matplotlib, to be drawn within `paper.drawing`.
    """
    from matplotlib.figure import Figure

    columns = 2 if len(studies) == 4 else min(len(studies), BESIDE)
    rows = ceil(len(studies) / columns)
    figure = Figure(figsize=(WIDTH_IN, 0.4 + 2.3 * rows), layout="constrained")
    plots = figure.subplots(rows, columns, squeeze=False).ravel().tolist()
    for axes, study in zip(plots, studies, strict=False):
        _plot(axes, study)
    for axes in plots[len(studies) :]:
        axes.set_visible(False)
    figure.supxlabel(say("what-if.note"), fontsize=7, color=MUTED)
    return figure


def _plot(axes: Axes, study: WhatIf) -> None:
    unit = plan_unit(study.plan)
    by_name = isinstance(study.asked, str)
    rows = in_order(study)
    places = [float(k) if by_name else float(row.value) for k, row in enumerate(rows)]
    saved = [row.saved * unit.scale for row in rows]
    most = [(row.saved if row.most_saved is None else row.most_saved) * unit.scale for row in rows]
    axes.axhline(0, color=MUTED, linewidth=0.6)
    if by_name:
        axes.vlines(places, saved, most, color=MUTED, alpha=0.3, linewidth=5)
        axes.set_xticks(
            places, [shortened(str(row.value), 14) for row in rows], rotation=30, ha="right"
        )
    else:
        axes.fill_between(places, saved, most, color=MUTED, alpha=0.2, linewidth=0)
        if places[0] <= float(study.asked) <= places[-1]:
            axes.axvline(float(study.asked), color=INK, linewidth=0.8, linestyle=":")
    axes.plot(places, saved, "o" if by_name else "o-", color=GAIN, linewidth=1.4, markersize=3.5)
    moved = new_plans(rows)
    axes.plot(
        [places[k] for k in moved], [saved[k] for k in moved], "o", markersize=7,
        markerfacecolor=PAPER, markeredgecolor=INK, markeredgewidth=1.0,
    )  # fmt: skip
    told = ", ".join(filter(None, [figure_name(study), figure_unit(study)]))
    axes.set_xlabel(told)
    axes.set_ylabel(say("what-if.saved-in", unit=unit.label))
    axes.grid(color=TICK, linewidth=0.6)
    axes.set_axisbelow(True)
