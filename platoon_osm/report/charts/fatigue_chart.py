"""Fatigue of drivers along the day, alone and as planned, on one scale."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from ..document.model import Document
from ..document.model_day import FatigueCurve
from ..document.model_vehicle import Vehicle
from ..drawing.crowd import CROWD
from ..language.speech import number, say
from ..markup.fragments import NOTHING, Piece, Tree
from .along_chart import ticks_of
from .axes import SIZE, WIDTH, Tick, day_scale, letter_type, number_scale, plain, text_width
from .polylines import line_text

__all__ = ["fatigue_chart"]

ROW, HEIGHT = 46.0, 34.0
"""Of a row, and of the highest value in it."""

TOP = 24.0

BADGE = 24.0
"""Room for the disc at the left."""

COLUMN_GAP = 8.0

MARKS = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)
"""Of which round numbers the greatest that fits is marked: high enough above 0 for its label."""


@dataclass(frozen=True, slots=True)
class _Frame:
    """Where curves and columns stand."""

    left: float
    right: float
    alone: float
    per_hour: float
    per_point: float
    round_value: float


def fatigue_chart(document: Document) -> Tree:
    """Return fatigue along the day, alone and as planned, a row for each vehicle.

    The day is that of the clock where the plan has times, else hours of driving.

    Parameters
    ----------
    document : Document
        Whose drivers are meant.

    Returns
    -------
    Tree
        An SVG; nothing for a crowd, whose table would not be read.
    """
    vehicles = document.vehicles
    if len(vehicles) > CROWD:
        return NOTHING
    schedule = document.schedule
    begin_s = schedule.begin_s if schedule else 0.0
    leaves = [
        (vehicle.day.departure_s - begin_s) / 3600 if schedule else 0.0 for vehicle in vehicles
    ]
    hours = max(
        leave + curve.hours[-1]
        for leave, vehicle in zip(leaves, vehicles, strict=True)
        for curve in vehicle.fatigue.curves
    )
    most = max(max(one.fatigue.alone_peak, one.fatigue.joint_peak) for one in vehicles)
    if hours <= 0 or most <= 0:
        return NOTHING
    company = any(kind == "platoon" for vehicle in vehicles for kind, _ in vehicle.way)
    frame = _frame(hours, most, company)
    bottom = TOP + ROW * len(vehicles)
    rows = [
        _row(frame, company, index, vehicle, TOP + ROW * index, frame.left + leave * frame.per_hour)
        for index, (vehicle, leave) in enumerate(zip(vehicles, leaves, strict=True))
    ]
    ticks = _times(document, frame, begin_s, hours)
    two = any(tick.below for tick in ticks)
    per_unit = frame.per_hour / 3600 if schedule else frame.per_hour
    zero = frame.left - begin_s * per_unit
    return Piece(
        "fatigue",
        {
            "height": f"{bottom + SIZE * (1 + two) + 8:g}",
            "ticks": tuple(ticks_of(ticks, zero, per_unit, TOP - 4, bottom)),
            "heads": Piece("fatigue-heads", {"alone_x": f"{frame.alone:.1f}"})
            if company
            else Piece("fatigue-head"),
            "rows": tuple(rows),
            "heading": say("fatigue.by-clock" if schedule else "fatigue.by-hours"),
            "note": " ".join(_notes(document, company)),
            "title": say(
                "fatigue.title",
                who="; ".join(
                    say(
                        "fatigue.peaks" if company else "fatigue.peak",
                        vehicle=vehicle.letter,
                        alone=number(vehicle.fatigue.alone_peak),
                        joint=number(vehicle.fatigue.joint_peak),
                    )
                    for vehicle in vehicles
                ),
            ),
        },
    )


def _frame(hours: float, most: float, company: bool) -> _Frame:
    """Return a frame whose columns hold their heads, and whose scale holds its labels."""
    power = 10.0 ** math.floor(math.log10(most))
    value = max(mark * power for mark in MARKS if mark * power <= most)
    left = BADGE + text_width(plain(value), SIZE) + 6
    last = say("fatigue.joint" if company else "fatigue.highest")
    joint = max(text_width(last, SIZE, True), text_width("999", SIZE, True))
    alone = max(text_width(say("fatigue.alone"), SIZE), text_width("999", SIZE))
    right = WIDTH - joint - COLUMN_GAP - (alone + COLUMN_GAP) * company
    return _Frame(
        left, right, WIDTH - joint - COLUMN_GAP, (right - left) / hours, HEIGHT / most, value
    )


def _times(document: Document, frame: _Frame, begin_s: float, hours: float) -> list[Tick]:
    schedule = document.schedule
    limits = BADGE - 14, WIDTH
    if schedule is None:
        return number_scale(hours, frame.per_hour, frame.left, limits, "h")
    end_s = begin_s + hours * 3600
    return day_scale(
        schedule.clock,
        begin_s,
        end_s,
        lambda at: frame.left + (at - begin_s) / 3600 * frame.per_hour,
        limits,
    )


def _notes(document: Document, company: bool) -> Iterator[str]:
    """Yield what the drawing means; plans without a platoon do not speak of one."""
    yield say("fatigue.scale")
    if company:
        yield say("fatigue.coloured")
        yield say("fatigue.in-platoon-or-waiting" if document.schedule else "fatigue.in-platoon")
    if any(one.restarts for v in document.vehicles if v.times for one in v.times.stands):
        yield say("fatigue.restarts")
    if company:
        yield say("fatigue.dashed")
    yield say("fatigue.day-left-out")
    drawn = (v.fatigue.curves if company else (v.fatigue.joint,) for v in document.vehicles)
    if any(curve.beyond for curves in drawn for curve in curves):
        yield say("fatigue.beyond")


def _row(
    frame: _Frame, company: bool, index: int, vehicle: Vehicle, y: float, left: float
) -> Piece:
    fatigue = vehicle.fatigue
    base = HEIGHT

    def path(curve: FatigueCurve) -> str:
        return line_text(
            (left + hour * frame.per_hour, base - value * frame.per_point)
            for hour, value in zip(curve.hours, curve.values, strict=True)
        )

    joint = path(fatigue.joint)
    first, last = joint.split(" ")[0], joint.rsplit(" ", 1)[-1]
    alone: Tree = NOTHING
    if company:
        peak = number(fatigue.alone_peak)
        alone = Piece(
            "fatigue-alone",
            {"points": path(fatigue.alone), "x": f"{frame.alone:.1f}", "peak": peak},
        )
    mark = base - frame.round_value * frame.per_point
    return Piece(
        "fatigue-row",
        {
            "y": f"{y:g}",
            "index": index,
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": letter_type(vehicle.letter),
            "alone": alone,
            "joint": f"{first.split(',')[0]},{base:g} {joint} {last.split(',')[0]},{base:g}",
            "left": f"{frame.left:.1f}",
            "right": f"{frame.right:.1f}",
            "base": f"{base:g}",
            "mark": f"{mark:.1f}",
            "label_x": f"{frame.left - 4:.1f}",
            "zero": "0",
            "zero_y": f"{base + 1:g}",
            "round": plain(frame.round_value),
            "round_y": f"{mark + 4.2:.1f}",
            "peak": number(fatigue.joint_peak),
        },
    )
