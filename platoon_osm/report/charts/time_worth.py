"""What the hour is worth: saving against the master's departure, and against the delay allowed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ...plans.clock import duration
from ...plans.curves import DelayFrontier, DepartureCurve
from ...shown_text import fitted
from ..document.status import law_name
from ..drawing.lines import Point
from ..drawing.ticks import round_step
from ..language.plan_sentences import in_language
from ..language.speech import clock_time, number, say
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import percent
from .along_chart import ticks_of
from .axes import SIZE, WIDTH, day_scale, number_scale
from .polylines import line_text

__all__ = ["time_worth"]

LEFT, RIGHT = 52.0, WIDTH - 14
TOP, BOTTOM = 18.0, 138.0

MOST_ROWS = 40
"""Steps of a curve that its table tells; of more, those that save most."""

SAME = 1e-9
"""Shares that differ by less are equal."""


def time_worth(curve: DepartureCurve | None, frontier: DelayFrontier | None) -> Tree:
    """Return the section on time of a page, as far as anything is known for it.

    Parameters
    ----------
    curve : DepartureCurve or None
        What is saved by when the master leaves.
    frontier : DelayFrontier or None
        What is saved by how late all may arrive.

    Returns
    -------
    Tree
        Charts, each with a table of its numbers; nothing without either.
    """
    parts: list[Tree] = []
    if curve is not None and len(curve):
        parts.append(_curve(curve))
    if frontier is not None and len(frontier):
        parts.append(_frontier(frontier))
    if not parts:
        return NOTHING
    rules = (curve.rules if curve is not None else "") or (frontier.rules if frontier else "")
    law = Piece("unit-note", {"note": say("time.law", rules=law_name(rules))}) if rules else NOTHING
    return Piece("time-worth", {"law": law, "parts": tuple(parts)})


def _curve(curve: DepartureCurve) -> Piece:
    clock = curve.clock
    begin, end = float(curve.begin_s[0]), float(curve.end_s[-1])
    per_second = (RIGHT - LEFT) / max(end - begin, 1.0)
    zero = LEFT - begin * per_second
    steps = range(len(curve))
    saved = [
        (_share(curve.cost[k], curve.solo_cost), _share(curve.end_cost[k], curve.solo_cost))
        for k in steps
    ]
    bound = [] if curve.bound is None else [_share(one, curve.solo_cost) for one in curve.bound]
    scale = _Scale(max([*(max(pair) for pair in saved), *bound]))
    lines: list[list[Point]] = []
    bounds: list[list[Point]] = []
    for k, (first, last) in zip(steps, saved, strict=True):
        if not k or curve.begin_s[k] > curve.end_s[k - 1] + 1:
            lines.append([])
            bounds.append([])
        x = [zero + float(at[k]) * per_second for at in (curve.begin_s, curve.end_s)]
        lines[-1] += zip(x, (scale.y(first), scale.y(last)), strict=True)
        bounds[-1] += [(at, scale.y(one)) for at in x for one in bound[k : k + 1]]
    ticks = day_scale(clock, begin, end, lambda at: zero + at * per_second, (0.0, WIDTH))
    master = fitted(curve.master)
    kept = sorted(sorted(steps, key=lambda k: (-max(saved[k]), k))[:MOST_ROWS])
    rows = [
        (
            _span(*(clock_time(clock, float(at[k])) for at in (curve.begin_s, curve.end_s))),
            percent(max(saved[k])),
            number(int(curve.company[k])),
        )
        for k in kept
    ]
    told = [_best(curve, master)]
    if not curve.is_exact:
        told.append(say("time.bound" if bound else "time.not-exact"))
    elif len(lines) > 1:
        told.append(say("time.no-line", vehicle=master))
    return _chart(
        "curve",
        say("time.curve", vehicle=master),
        " ".join(told),
        ticks_of(ticks, zero, per_second, TOP - 4, BOTTOM),
        any(tick.below for tick in ticks),
        scale,
        [line_text(points) for points in lines],
        (zero + curve.best_s * per_second, scale.y(curve.best_saving)),
        tuple(_dashed(line_text(points)) for points in bounds if points),
        (say("time.departure"), say("time.saved"), say("time.with")),
        rows,
        curve.conditions,
    )


def _best(curve: DepartureCurve, master: str) -> str:
    """Tell when to leave: any time of a level step, or a moment."""
    clock, share = curve.clock, percent(curve.best_saving)
    on = (curve.begin_s <= curve.best_s) & (curve.best_s <= curve.end_s)
    level = on & (curve.cost == curve.end_cost) & (curve.cost <= curve.best_cost)
    for step in np.flatnonzero(level).tolist():
        begin, end = (clock_time(clock, float(at[step])) for at in (curve.begin_s, curve.end_s))
        if begin != end:
            return say("time.best-between", vehicle=master, begin=begin, end=end, share=share)
    return say("time.best", vehicle=master, time=clock_time(clock, curve.best_s), share=share)


def _frontier(frontier: DelayFrontier) -> Piece:
    delays = frontier.delay_min.tolist()
    last = max(delays[-1], 1.0)
    per_minute = (RIGHT - LEFT) / last
    saved = frontier.saving_share.tolist()
    bound = [_share(one, frontier.solo_cost) for one in frontier.bound]
    scale = _Scale(max(*saved, *bound, 0.0))

    def stairs(values: Sequence[float]) -> str:
        """Hold each value until the next delay."""
        points: list[Point] = []
        for k, value in enumerate(values):
            until = delays[k + 1] if k + 1 < len(delays) else last
            points += [(LEFT + at * per_minute, scale.y(value)) for at in (delays[k], until)]
        return line_text(points)

    proved = bool(np.allclose(saved, bound, atol=5e-4))
    rows = [
        (
            duration(60 * delay),
            percent(saved[k]),
            *(() if proved else (percent(bound[k]),)),
            number(int(frontier.company[k])),
        )
        for k, delay in enumerate(delays)
    ]
    heads = (say("time.delay"), say("time.saved"), say("time.at-most"), say("time.with"))
    ticks = number_scale(last, per_minute, LEFT, (0.0, WIDTH), "min")
    # The least delay with which as much is saved as with the longest.
    most = delays[next(k for k, share in enumerate(saved) if share >= saved[-1] - SAME)]
    told = say("time.most", time=duration(60 * most), share=percent(saved[-1]))
    return _chart(
        "frontier",
        say("time.frontier"),
        told if proved else f"{told} {say('time.bound')}",
        ticks_of(ticks, LEFT, per_minute, TOP - 4, BOTTOM),
        False,
        scale,
        [stairs(saved)],
        (LEFT + most * per_minute, scale.y(saved[-1])),
        NOTHING if proved else _dashed(stairs(bound)),
        heads[:2] + heads[3:] if proved else heads,
        rows,
        frontier.conditions,
    )


def _dashed(points: str) -> Piece:
    """Draw what no plan saves more than."""
    return Piece("time-worth-bound", {"points": points})


def _share(cost: float, solo: float) -> float:
    return 1.0 - float(cost) / solo if solo else 0.0


def _span(begin: str, end: str) -> str:
    return begin if begin == end else f"{begin} \u2013 {end}"


class _Scale:
    """Shares upward, with a few round ones named."""

    def __init__(self, most: float) -> None:
        self.most = max(most, 1e-3)
        self.per_unit = (BOTTOM - TOP) / self.most

    def y(self, share: float) -> float:
        return BOTTOM - max(share, 0.0) * self.per_unit

    def pieces(self) -> Iterator[Piece]:
        step = round_step(self.most / 3)
        for k in range(int(self.most / step + 1e-9) + 1):
            y = self.y(k * step)
            text = percent(k * step)
            values = {"x": f"{LEFT - 4:g}", "y": f"{y:.1f}", "text_y": f"{y + 4:.1f}"}
            yield Piece("time-worth-share", {**values, "left": LEFT, "right": RIGHT, "text": text})


def _chart(
    key: str,
    heading: str,
    told: str,
    ticks: Iterator[Piece],
    two: bool,
    scale: _Scale,
    lines: Sequence[str],
    best: Point,
    bound: Tree,
    heads: Sequence[str],
    rows: Sequence[Sequence[str]],
    conditions: Sequence[str],
) -> Piece:
    return Piece(
        "time-worth-chart",
        {
            "key": key,
            "heading": heading,
            "told": told,
            "height": f"{BOTTOM + SIZE * (1 + two) + 8:g}",
            "ticks": tuple(ticks),
            "shares": tuple(scale.pieces()),
            "lines": tuple(Piece("time-worth-line", {"points": line}) for line in lines),
            "bound": bound,
            "x": f"{best[0]:.1f}",
            "y": f"{best[1]:.1f}",
            "heads": tuple(Piece("time-worth-head", {"text": text}) for text in heads),
            "rows": tuple(
                Piece(
                    "time-worth-row",
                    {"cells": tuple(Piece("time-worth-cell", {"text": text}) for text in row)},
                )
                for row in rows
            ),
            "conditions": _conditions(conditions),
        },
    )


def _conditions(conditions: Sequence[str]) -> Tree:
    told = "; ".join(fitted(in_language(one)) for one in conditions)
    return Piece("unit-note", {"note": say("time.holds", what=told)}) if told else NOTHING
