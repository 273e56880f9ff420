"""Saving against the value of a figure, as a drawing of a page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import ceil

from ...plans.what_if import WhatIf
from ..document.wording import plan_unit
from ..drawing.ticks import round_step
from ..language.speech import say
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import CostUnit
from .axes import plain
from .polylines import line_text
from .what_if_texts import figure_name, figure_unit, in_order, new_plans, value_said

__all__ = ["what_if_chart"]

LEFT, RIGHT, TOP, BOTTOM = 64.0, 500.0, 14.0, 176.0

MOST_NAMES = 9
"""Values by name that are written below the chart; of more, every second one, or third."""

UPWARD, ACROSS = 4, 6
"""Round numbers on the axes."""


def what_if_chart(study: WhatIf, key: str) -> Tree:
    """Return the chart of a figure that is varied.

    Parameters
    ----------
    study : WhatIf
        Of the figure.
    key : str
        What makes its ids differ from those of other charts.

    Returns
    -------
    Tree
        An SVG.
    """
    unit = plan_unit(study.plan)
    rows = in_order(study)
    by_name = isinstance(study.asked, str)
    values = [float(k) if by_name else float(row.value) for k, row in enumerate(rows)]
    saved = [row.saved for row in rows]
    most = [row.saved if row.most_saved is None else row.most_saved for row in rows]
    low, high = min(0.0, *saved), max(*most, *saved, 1e-9)
    first, last = values[0], values[-1]
    half = 0.5 if by_name or first == last else 0.0
    first, last = first - half, last + half

    def x(value: float) -> float:
        return LEFT + (value - first) * (RIGHT - LEFT) / (last - first)

    def y(cost: float) -> float:
        return BOTTOM - (cost - low) * (BOTTOM - TOP) / (high - low)

    line = [(x(at), y(cost)) for at, cost in zip(values, saved, strict=True)]
    edge = [(x(at), y(cost)) for at, cost in zip(values, most, strict=True)]
    names = [value_said(row.value) for row in rows]
    ticks = _names(names) if by_name else _numbers(first, last)
    moved = new_plans(rows)
    told = [f"{name}: {unit.full(cost)}" for name, cost in zip(names, saved, strict=True)]
    unit_text = figure_unit(study)
    return Piece(
        "what-if-chart",
        {
            "key": key,
            "label": say("what-if.chart", name=figure_name(study)),
            "across": tuple(
                Piece("what-if-across", {"x": f"{x(at):.1f}", "top": TOP, "bottom": BOTTOM,
                                         "text_y": BOTTOM + 17, "text": text})
                for at, text in ticks
            ),
            "upward": _upward(low, high, y, unit),
            "band": Piece("what-if-band", {"points": line_text([*line, *reversed(edge)])})
            if len(rows) > 1 and not by_name
            else tuple(
                Piece("what-if-range", {"x": f"{at:.1f}", "y": f"{a:.1f}", "to": f"{b:.1f}"})
                for (at, a), (_, b) in zip(line, edge, strict=True)
            ),
            "line": NOTHING if by_name else Piece("what-if-line", {"points": line_text(line)}),
            "dots": tuple(
                Piece("what-if-new" if k in moved else "what-if-dot",
                      {"x": f"{at:.1f}", "y": f"{up:.1f}", "text": told[k]})
                for k, (at, up) in enumerate(line)
            ),
            "asked": _asked(study, first, last, x),
            "name": ", ".join(filter(None, [figure_name(study), unit_text])),
            "saved": say("what-if.saved-in", unit=unit.label),
        },
    )  # fmt: skip


def _numbers(first: float, last: float) -> list[tuple[float, str]]:
    step = round_step((last - first) / ACROSS)
    begin = ceil(first / step - 1e-9)
    count = int((last - begin * step) / step + 1e-9)
    values = [round((begin + k) * step, 9) for k in range(count + 1)]
    return [(value, plain(value)) for value in values]


def _names(names: Sequence[str]) -> list[tuple[float, str]]:
    step = ceil(len(names) / MOST_NAMES)
    return [(float(at), names[at]) for at in range(0, len(names), step)]


def _upward(low: float, high: float, y: Callable[[float], float], unit: CostUnit) -> Tree:
    step = round_step((high - low) * unit.scale / UPWARD)
    begin = ceil(low * unit.scale / step - 1e-9)
    count = int((high * unit.scale - begin * step) / step + 1e-9)
    return tuple(
        Piece(
            "what-if-upward",
            {
                "left": LEFT, "right": RIGHT, "x": LEFT - 6,
                "y": f"{y(value / unit.scale):.1f}", "text_y": f"{y(value / unit.scale) + 4:.1f}",
                "text": plain(round(value, 9)),
            },
        )
        for value in ((begin + k) * step for k in range(count + 1))
    )  # fmt: skip


def _asked(study: WhatIf, first: float, last: float, x: Callable[[float], float]) -> Tree:
    if isinstance(study.asked, str) or not first <= study.asked <= last:
        return NOTHING
    return Piece("what-if-asked", {"x": f"{x(study.asked):.1f}", "top": TOP, "bottom": BOTTOM})
