"""The schedule for papers: its picture on given axes, and the numbers behind it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from ...plans.clock import MENTIONED_S, Clock
from ..document.model import Document
from ..document.model_day import DaySchedule
from ..drawing.palette import LATE, MUTED, PAPER, PLATOON, PLATOON_CASING
from ..drawing.ticks import hour_ticks
from ..language.speech import clock_time, say
from .schedule_chart import BEYOND, schedule_notes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["COLUMNS", "draw_schedule", "schedule_rows"]

Row = tuple[str | float, ...]

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
        last = times.departure_s
        for (kind, _), (begin, end) in zip(vehicle.way, times.spans, strict=True):
            if begin - last >= MENTIONED_S:
                axes.barh(
                    row,
                    begin - last,
                    0.42,
                    left=last,
                    color=PAPER,
                    edgecolor=MUTED,
                    hatch="//////",
                    linewidth=0.6,
                )
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
            last = end
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
    axes.set_xlabel(say("schedule.axis", day=schedule.text.day, zone=zone) + f"\n{legend}")


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
            if begin - last > 0:
                yield _row(clock, (letter, "waits", ""), last, begin)
            company = document.platoons[piece].vehicles if kind == "platoon" else ()
            others = " ".join(vehicles[i].letter for i in company if i != index)
            does = "in platoon" if others else "alone"
            yield _row(clock, (letter, does, others), begin, end)
            last = end


def _row(clock: Clock, what: tuple[str, str, str], begin: float, end: float) -> Row:
    moments = (clock.moment(round(at)).isoformat() for at in (begin, end))
    return (*what, *moments, float(begin), float(end))
