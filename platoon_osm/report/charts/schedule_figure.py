"""The schedule for papers: its picture on given axes, and the numbers behind it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from textwrap import fill
from typing import TYPE_CHECKING, Any

from ...plans.clock import MENTIONED_S, Clock
from ..document.model import Document
from ..document.model_day import DaySchedule
from ..document.model_law import Standing
from ..drawing.palette import CROWD, INK, LATE, MUTED, PAPER, PLATOON, PLATOON_CASING
from ..drawing.ticks import hour_ticks
from ..language.speech import clock_time, say
from .schedule_chart import BEYOND, schedule_notes, stands_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["COLUMNS", "LOOKS", "draw_schedule", "draw_stand", "schedule_rows"]

Row = tuple[str | float, ...]

HEIGHTS = {"wait": 0.42, "break": 0.5, "rest": 0.4, "ban": 0.42, "change": 0.5}
LOOKS: dict[str, dict[str, Any]] = {
    "wait": {"color": PAPER, "edgecolor": MUTED, "hatch": "//////", "linewidth": 0.6},
    "break": {"color": PAPER, "edgecolor": INK, "linewidth": 1.0},
    "rest": {"color": CROWD, "edgecolor": CROWD, "linewidth": 0.6},
    "ban": {"color": PAPER, "edgecolor": LATE, "hatch": "||||||", "linewidth": 0.6},
    "change": {"color": INK, "edgecolor": INK, "linewidth": 0.6},
}
"""What each kind of standing looks like, here and in the diagram of time and distance."""

LONGEST_LINE = 95
"""Characters of the legend in a line, where it tells of positions too."""

LEAST_TEXT = 0.035
"""A box at least this share of the axis wide bears its text."""

DOES = {
    "wait": "waits",
    "break": "takes a break",
    "rest": "rests",
    "ban": "stands for a driving ban",
    "change": "changes drivers",
}

COLUMNS = ("vehicle", "does", "with", "begin", "end", "begin_s", "end_s")


def draw_schedule(
    axes: Axes, document: Document, schedule: DaySchedule, dashes: Sequence[dict[str, Any]]
) -> None:
    """Draw a row for each vehicle, from the top, on an axis of hours of the clock.

    Parameters
    ----------
    axes : Axes
        Of matplotlib.
    document : Document
        Whose vehicles they are.
    schedule : DaySchedule
        Its day.
    dashes : sequence of dict
        How each vehicle's line is dashed, as options of matplotlib.
    """
    vehicles = document.vehicles
    for row, (vehicle, dash) in enumerate(zip(vehicles, dashes, strict=True)):
        times, colour = vehicle.day, vehicle.colour
        for (kind, _), (begin, end) in zip(vehicle.way, times.spans, strict=True):
            if kind == "platoon":
                axes.barh(
                    row,
                    end - begin,
                    0.56,
                    left=begin,
                    color=PLATOON,
                    edgecolor=PLATOON_CASING,
                    linewidth=0.4,
                )
            axes.plot([begin, end], [row, row], color=colour, linewidth=2, **dash)
        for one in times.stands:
            if one.lasts_s >= MENTIONED_S:
                draw_stand(axes, one, row, schedule.end_s - schedule.begin_s)
        for place in document.positions[row]:
            if place.end_s - place.begin_s >= LEAST_TEXT * (schedule.end_s - schedule.begin_s):
                leads = place.position == 1
                axes.text(
                    (place.begin_s + place.end_s) / 2,
                    row,
                    str(place.position),
                    ha="center",
                    va="center_baseline",
                    fontsize=6.5,
                    fontweight="bold",
                    color=PAPER if leads else INK,
                    zorder=3,
                    bbox={
                        "boxstyle": "round,pad=0.2",
                        "facecolor": INK if leads else PAPER,
                        "edgecolor": INK,
                        "linewidth": 0.6,
                    },
                )
        axes.plot([times.departure_s], [row], "o", color=colour, markersize=5)
        axes.plot([times.arrival_s], [row], "s", color=colour, markersize=5)
        late = times.is_late
        for moment, text, ink in (
            (times.departure_s, times.text.departure, MUTED),
            (times.arrival_s, times.text.arrival, LATE if late else MUTED),
        ):
            axes.annotate(
                text,
                (moment, row),
                (0, -11),
                textcoords="offset points",
                ha="center",
                va="center",
                fontsize=6.5,
                color=ink,
            )
        latest = times.latest_arrival_s
        span = schedule.end_s - schedule.begin_s
        if latest is not None and latest <= schedule.end_s + BEYOND * span:
            axes.plot(
                [latest] * 2, [row - 0.3, row + 0.3], linewidth=1, color=LATE if late else MUTED
            )
    ticks = hour_ticks(schedule.clock, schedule.begin_s, schedule.end_s)
    # A day stands below its hour, so that labels keep apart.
    texts = [clock_time(schedule.clock, moment).replace(" ", "\n", 1) for moment, _ in ticks]
    axes.set_xticks([moment for moment, _ in ticks], texts)
    zone = schedule.zone_of(schedule.begin_s, schedule.end_s)
    legend = schedule_notes(document, range(len(vehicles)))
    if any(document.positions):
        legend = fill(legend, LONGEST_LINE)
    axes.set_xlabel(say("schedule.axis", day=schedule.text.day, zone=zone) + f"\n{legend}")


def draw_stand(axes: Axes, one: Standing, row: float, span_s: float) -> None:
    """Draw a while in which a vehicle stands, by its kind.

    Parameters
    ----------
    axes : Axes
        Of matplotlib, with time to the right.
    one : Standing
        What for.
    row : float
        Of the vehicle.
    span_s : float
        Of the whole axis: a box that is wide enough tells how long.
    """
    axes.barh(row, one.lasts_s, HEIGHTS[one.kind], left=one.begin_s, zorder=2.5, **LOOKS[one.kind])
    if one.kind in ("break", "rest") and one.lasts_s >= LEAST_TEXT * span_s:
        axes.text(
            one.begin_s + one.lasts_s / 2,
            row,
            stands_text(one),
            ha="center",
            va="center_baseline",
            fontsize=6.5,
            fontweight="bold",
            color=INK if one.kind == "break" else PAPER,
            zorder=3,
        )


def schedule_rows(document: Document, schedule: DaySchedule) -> Iterator[Row]:
    """Yield what each vehicle does from when to when.

    Parameters
    ----------
    document : Document
        Whose vehicles they are.
    schedule : DaySchedule
        Its day.

    Yields
    ------
    tuple of str and float
        In the order of `COLUMNS`.
    """
    clock, vehicles = schedule.clock, document.vehicles
    for index, vehicle in enumerate(vehicles):
        letter, times = vehicle.letter, vehicle.day
        last = times.departure_s
        if times.text.held and times.earliest_departure_s is not None:
            yield _row(clock, (letter, "could have left", ""), times.earliest_departure_s, last)
        for (kind, piece), (begin, end) in zip(vehicle.way, times.spans, strict=True):
            for one in times.stands:
                if last - 0.1 <= one.begin_s < begin:
                    yield _row(clock, (letter, DOES[one.kind], ""), one.begin_s, one.end_s)
            company = document.platoons[piece].vehicles if kind == "platoon" else ()
            others = " ".join(vehicles[i].letter for i in company if i != index)
            does = "in platoon" if others else "alone"
            yield _row(clock, (letter, does, others), begin, end)
            last = end


def _row(clock: Clock, what: tuple[str, str, str], begin: float, end: float) -> Row:
    moments = (clock.moment(round(at)).isoformat() for at in (begin, end))
    return (*what, *moments, float(begin), float(end))
