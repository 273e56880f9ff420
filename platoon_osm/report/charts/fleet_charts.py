"""Charts of a fleet's plan: gap over time, vehicle-km by size, who drives a corridor when."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from ...plans.clock import Clock
from ...plans.fleet import FleetRecord, Moment
from ..document.corridor import Corridor, Run
from ..drawing.palette import FLOWS, MUTED
from ..drawing.ticks import hour_ticks, round_step
from ..language.speech import number, say
from ..maps.map_texts import clipped
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import percent, true_minus
from .axes import plain
from .polylines import line_text

__all__ = [
    "corridor_chart", "fine_percent", "gap_chart", "gap_percent", "size_chart", "size_colour",
]  # fmt: skip

LEFT, RIGHT, TOP, BOTTOM = 46.0, 440.0, 14.0, 190.0

BOUND_ROOM = 2.2
"""The chart of the gap ends at so many times the last bound; an earlier, weaker one is cut off."""

SMALL_GAP = 0.01
"""Below it a gap is told with three decimals."""

LATE_START = 0.2
"""Where the first plan took longer than this share of the search, the chart begins with it."""

MOST_SIZES = 8
"""Bars of sizes; larger platoons share the last."""

WIDE_LEFT, WIDE_RIGHT, WIDE_TOP, WIDE_BOTTOM = 236.0, 1120.0, 14.0, 436.0
PLACE_APART, PLACE_WIDEST = 22.0, 214.0
MOST_WIDE_HOURS = 13
THICK = (0.9, 2.0, 3.2, 4.6, 6.2)
"""Lines of 1, 2, 3, 4 and more vehicles, in pixels."""


def fine_percent(share: float) -> str:
    """Return a share with two decimals, for savings of a few per cent.

    Parameters
    ----------
    share : float
        Of 1.

    Returns
    -------
    str
        In percent.
    """
    return say("form.percent", number=true_minus(number(share * 100, 2)))


def gap_percent(gap: float) -> str:
    """Return a gap, never less than it is: with as many decimals as a small one needs.

    Parameters
    ----------
    gap : float
        Of 1.

    Returns
    -------
    str
        In percent, rounded up.
    """
    decimals = 1 if gap >= SMALL_GAP or gap <= 0 else 3
    part = 10**decimals
    told = math.ceil(gap * 100 * part - 1e-6) / part
    return say("form.percent", number=number(told, decimals))


def gap_chart(record: FleetRecord) -> Tree:
    """Return how saving and bound moved over the time of the search, as shares of the cost alone.

    Parameters
    ----------
    record : FleetRecord
        Of the plan.

    Returns
    -------
    Tree
        An SVG; nothing without a history.
    """
    cost = record.alone_cost
    moments = sorted(record.history, key=lambda one: one.seconds)
    if len(moments) < 2 or not cost or record.most <= 0:
        return NOTHING
    last = moments[-1]
    moments.append(Moment(max(record.seconds, last.seconds), record.saving, record.most))
    end = moments[-1].seconds or 1.0
    first = moments[0].seconds
    begin = first if first > LATE_START * end else 0.0
    top = min(max(one.bound for one in moments), BOUND_ROOM * record.most) / cost

    def x(seconds: float) -> float:
        return LEFT + (RIGHT - LEFT) * (seconds - begin) / max(end - begin, 1e-9)

    def y(share: float) -> float:
        return BOTTOM - (BOTTOM - TOP) * max(share, 0.0) / top

    seen = [one for one in moments if one.bound / cost <= top * (1 + 1e-9)]
    bounds = _steps([(x(one.seconds), y(one.bound / cost)) for one in seen])
    savings = _steps([(x(one.seconds), y(one.saving / cost)) for one in moments])
    inside = _steps([(x(one.seconds), y(one.saving / cost)) for one in seen])
    return Piece(
        "fleet-gap",
        {
            "label": say(
                "fleet.gap-chart", saved=fine_percent(record.saving / cost),
                bound=fine_percent(record.most / cost), gap=gap_percent(record.gap),
            ),
            "upward": tuple(
                Piece("what-if-upward", {"left": LEFT, "right": RIGHT, "x": LEFT - 6,
                                         "y": f"{y(at):.1f}", "text_y": f"{y(at) + 4:.1f}",
                                         "text": percent(at) if at else "0"})
                for at in _round_values(top, 4)
            ),
            "across": tuple(
                Piece("what-if-across", {"x": f"{x(at):.1f}", "top": TOP, "bottom": BOTTOM,
                                         "text_y": BOTTOM + 17, "text": plain(at)})
                for at in _round_values(end, 6, begin)
            ),
            "band": line_text([*inside, *reversed(bounds)]),
            "bounds": line_text(bounds),
            "savings": line_text(savings),
        },
    )  # fmt: skip


def _round_values(end: float, most: int, begin: float = 0.0) -> list[float]:
    step = round_step((end - begin) / most)
    first = math.ceil(begin / step - 1e-9)
    return [round(k * step, 12) for k in range(first, int(end / step + 1e-9) + 1)]


def _steps(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return a line that keeps its height until the next point."""
    found = list(points[:1])
    for at, up in points[1:]:
        found += [(at, found[-1][1]), (at, up)]
    return found


def size_colour(vehicles: int) -> str:
    """Return the colour of companies of a size.

    Parameters
    ----------
    vehicles : int
        1 or more.

    Returns
    -------
    str
        Of the palette.
    """
    return MUTED if vehicles < 2 else FLOWS[min(vehicles, len(FLOWS)) - 1]


def size_chart(sizes: Sequence[tuple[int, float]]) -> Piece:
    """Return how far vehicles drive in companies of each size, a bar each.

    Parameters
    ----------
    sizes : sequence of (int, float)
        Vehicle-metres by vehicles of the company.

    Returns
    -------
    Piece
        An SVG.
    """
    total = sum(metres for _, metres in sizes) or 1.0
    largest = max((size for size, _ in sizes), default=1)
    known = dict(sizes)
    rows = [(str(k), k, known.get(k, 0.0)) for k in range(1, min(largest, MOST_SIZES) + 1)]
    if largest > MOST_SIZES:
        rest = sum(metres for size, metres in sizes if size >= MOST_SIZES)
        rows[-1] = (say("fleet.or-more", n=MOST_SIZES), MOST_SIZES, rest)
    longest = max(metres for _, _, metres in rows) or 1.0
    bars = []
    for place, (label, size, metres) in enumerate(rows):
        width = 230 * metres / longest
        bars.append(
            Piece(
                "fleet-size",
                {
                    "y": 8 + 24 * place, "text_y": 22 + 24 * place, "label": label,
                    "width": f"{max(width, 0.6):.1f}", "colour": size_colour(size),
                    "text_x": f"{92 + width:.1f}",
                    "text": say("fleet.size-share", km=number(metres / 1000),
                                share=percent(metres / total)),
                },
            )
        )  # fmt: skip
    return Piece("fleet-sizes", {"height": 14 + 24 * len(rows), "bars": tuple(bars)})


def corridor_chart(found: Corridor, clock: Clock) -> Tree:
    """Return the time-distance diagram of a corridor: a line a stretch, companies thick.

    Parameters
    ----------
    found : Corridor
        Of the document.
    clock : Clock
        Of the plan.

    Returns
    -------
    Tree
        An SVG; nothing if nobody drives there.
    """
    if not found.runs or not found.length_m:
        return NOTHING
    begin = min(one.begin_s for one in found.runs)
    end = max(max(one.end_s for one in found.runs), begin + 60.0)

    def x(seconds: float) -> float:
        return WIDE_LEFT + (WIDE_RIGHT - WIDE_LEFT) * (seconds - begin) / (end - begin)

    def y(metres: float) -> float:
        return WIDE_BOTTOM - (WIDE_BOTTOM - WIDE_TOP) * metres / found.length_m

    classes = [
        [one for one in found.runs if min(one.vehicles, len(THICK)) == size]
        for size in range(1, len(THICK) + 1)
    ]
    lines = tuple(
        Piece(
            "fleet-runs",
            {
                "path": _runs_path(own, x, y), "colour": size_colour(size),
                "width": f"{THICK[size - 1]:g}", "text": _together(size),
            },
        )
        for size, own in enumerate(classes, 1)
        if own
    )  # fmt: skip
    return Piece(
        "fleet-corridor",
        {
            "label": say("fleet.corridor-chart", begin=found.places[0][1],
                         end=found.places[-1][1], n=found.vehicles),
            "hours": tuple(
                Piece("what-if-across", {"x": f"{x(at):.1f}", "top": WIDE_TOP,
                                         "bottom": WIDE_BOTTOM, "text_y": WIDE_BOTTOM + 18,
                                         "text": text})
                for at, text in hour_ticks(clock, begin, end, MOST_WIDE_HOURS)
            ),
            "places": tuple(
                Piece("fleet-place", {"y": f"{y(at):.1f}", "text_y": f"{y(at) + 4:.1f}",
                                      "text": clipped(name, 12.5, widest=PLACE_WIDEST),
                                      "km": number(at / 1000)})
                for at, name in _apart(found, y)
            ),
            "lines": lines,
            "keys": tuple(
                Piece("fleet-key", {"colour": size_colour(size),
                                    "width": f"{THICK[size - 1]:g}", "text": _together(size)})
                for size, own in enumerate(classes, 1)
                if own
            ),
        },
    )  # fmt: skip


def _together(size: int) -> str:
    if size == 1:
        return say("fleet.one-alone")
    return say("fleet.together" if size < len(THICK) else "fleet.together-more", n=size)


def _runs_path(
    runs: Sequence[Run], x: Callable[[float], float], y: Callable[[float], float]
) -> str:
    return "".join(
        f"M{x(one.begin_s):.1f} {y(one.begin_m):.1f}L{x(one.end_s):.1f} {y(one.end_m):.1f}"
        for one in runs
    )


def _apart(found: Corridor, y: Callable[[float], float]) -> list[tuple[float, str]]:
    """Return both ends, and the places between whose names stand apart."""
    first, *middle, last = found.places
    kept = [first, last]
    for place in middle:
        if all(abs(y(place[0]) - y(at)) >= PLACE_APART and place[1] != name for at, name in kept):
            kept.append(place)
    return sorted(kept)
