"""What the hour is worth, for papers: saving against a master's departure, and against delay.

Above, the share of the cost alone that is saved, as steps over the master's departures; below, a
row for each member that ever joins, filled where it drives with the master.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np

from ...atomic_file import whole_file
from ...errors import ScenarioError, brief
from ...plans.curves import DelayFrontier, DepartureCurve
from ...shown_text import shortened
from ..document.checks import check_path
from ..document.status import law_name
from ..drawing.palette import GAIN, INK, MUTED, PLATOON, PLATOON_CASING
from ..drawing.ticks import hour_ticks
from ..language.speech import clock_time, say, speaking
from .paper import METADATA, WIDTH_IN, axes_of, drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["write_curve"]

MOST_ROWS = 24
"""Members whose rows can be told apart; with more, only the saving is drawn."""


LEAST_GAP = 1e-6
"""A gap below this is none that can be seen."""


def write_curve(
    curve: DepartureCurve | DelayFrontier,
    path: str | os.PathLike[str],
    *,
    language: str | None = None,
    clock: int | None = None,
) -> None:
    """Write the figure of a departure curve or of a delay frontier.

    Parameters
    ----------
    curve : DepartureCurve or DelayFrontier
        What is drawn.
    path : path-like
        Of the file: .png (300 dpi), .svg or .pdf.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

    Raises
    ------
    ScenarioError
        Neither curve nor frontier, another kind of file, or one that cannot be written.
    """
    if not isinstance(curve, DepartureCurve | DelayFrontier):
        raise ScenarioError(
            f"figure: {brief(curve)} is no curve; give one from departure_curve or delay_frontier"
        )
    place = check_path(path)
    kind = place.suffix[1:].lower()
    if kind not in METADATA:
        raise ScenarioError(f"figure: {place.name}: use .png, .svg or .pdf")
    with speaking(language, clock), drawing():
        figure = _curve(curve) if isinstance(curve, DepartureCurve) else _frontier(curve)
        with whole_file(place, suffixes=(place.suffix,)) as draft:
            figure.savefig(draft, format=kind, dpi=300, metadata=METADATA[kind])


def _curve(curve: DepartureCurve) -> Figure:
    from matplotlib.figure import Figure

    joining = [k for k, spans in enumerate(curve.joins) if len(spans)]
    rows = joining if len(joining) <= MOST_ROWS else []
    height = 2.2 + 0.26 * len(rows) + (0.5 if curve.rules else 0.0)
    figure = Figure(figsize=(WIDTH_IN, height), layout="constrained")
    if rows:
        heights = [2.0, 0.3 + 0.26 * len(rows)]
        above, below = figure.subplots(2, 1, sharex=True, height_ratios=heights)
    else:
        above = below = figure.add_subplot()
    _saving(above, curve)
    for row, member in enumerate(rows):
        for begin, end in curve.joins[member]:
            below.barh(
                row, end - begin, 0.6, left=begin, color=PLATOON, edgecolor=PLATOON_CASING,
                linewidth=0.4,
            )  # fmt: skip
    if rows:
        below.set_yticks(range(len(rows)), [shortened(curve.members[k], 24) for k in rows])
        below.set_ylim(len(rows) - 0.4, -0.6)
        below.axvline(curve.best_s, color=INK, linewidth=0.8, linestyle=":")
    times = curve.clock
    ticks = hour_ticks(times, float(curve.begin_s[0]), float(curve.end_s[-1]))
    texts = [clock_time(times, at).replace(" ", "\n", 1) for at, _ in ticks]
    below.set_xticks([at for at, _ in ticks], texts)
    label = say("figures.departure", who=shortened(curve.master, 24))
    below.set_xlabel(_with_law(label, curve.rules))
    return figure


def _with_law(label: str, rules: str) -> str:
    """Tell below the name of an axis which driving rules hold."""
    return f"{label}\n{law_name(rules)}" if rules else label


def _saving(axes: Axes, curve: DepartureCurve) -> None:
    """Draw the share saved, a step at a time; where two steps meet, the line goes up or down."""
    whole = curve.solo_cost or 1.0
    # Nothing is drawn where steps do not meet, for the master cannot leave then.
    apart = np.append(curve.begin_s[1:] > curve.end_s[:-1] + 1, False)
    gap = np.where(apart, np.nan, curve.end_s)
    moments = np.column_stack([curve.begin_s, curve.end_s, gap]).ravel()
    saved = 100 * (
        1 - np.column_stack([curve.cost, curve.end_cost, curve.end_cost]).ravel() / whole
    )
    axes.plot(moments, saved, color=GAIN, linewidth=1.4)
    if curve.bound is not None:
        most = 100 * (1 - np.repeat(curve.bound, 3) / whole)
        axes.fill_between(moments, saved, most, color=MUTED, alpha=0.2, linewidth=0)
    axes.plot([curve.best_s], [100 * curve.best_saving], "o", color=INK, markersize=4)
    axes.axvline(curve.best_s, color=INK, linewidth=0.8, linestyle=":")
    axes.axhline(0, color=MUTED, linewidth=0.6)
    axes.set_ylabel(say("figures.saving"))


def _frontier(frontier: DelayFrontier) -> Figure:
    figure, axes = axes_of(2.8 if frontier.rules else 2.6)
    delay, saved = frontier.delay_min, 100 * frontier.saving_share
    most = 100 * (1 - frontier.bound / (frontier.solo_cost or 1.0))
    # Between two delays at least what the shorter one allows is saved.
    axes.fill_between(delay, saved, most, step="post", color=MUTED, alpha=0.2, linewidth=0)
    axes.step(delay, saved, "o-", where="post", color=GAIN, linewidth=1.4, markersize=4)
    axes.set_ylim(bottom=0)
    label = say("figures.delay" if frontier.gap.max() < LEAST_GAP else "figures.delay-gap")
    axes.set_xlabel(_with_law(label, frontier.rules))
    axes.set_ylabel(say("figures.saving"))
    return figure
