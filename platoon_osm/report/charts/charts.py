"""Charts of a report: the way of each vehicle by distance, and its fatigue along the day."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from ..document.model import Document
from ..document.model_day import FatigueCurve
from ..document.model_map import EventMark
from ..document.model_vehicle import Vehicle
from ..drawing.crowd import CROWD, MOST_SPOKEN
from ..drawing.ticks import hour_ticks, round_step
from ..markup.fragments import NOTHING, Piece, Tree

__all__ = ["along_chart", "fatigue_chart"]

LEFT, RIGHT = 34.0, 364.0
ALONG_TOP, ALONG_ROW = 30, 25
MOST_TICKS = 6

CURVE_ROW, CURVE_HEIGHT = 48, 36
FITTED_H = 4.5

ICON_WIDTH = 15.0


def along_chart(document: Document, members: Sequence[int], key: str = "") -> Tree:
    """Return the way of some vehicles by distance: platoon in yellow, merges and separations.

    Parameters
    ----------
    document : Document
        Whose vehicles they are.
    members : sequence of int
        Their positions.
    key : str
        Ends the ids in the picture, so that several stand on one page.

    Returns
    -------
    Tree
        An SVG; nothing if there is no common scale.
    """
    scale = document.journey
    if scale is None or not members:
        return NOTHING
    vehicles, starts = document.vehicles, scale.starts_m
    end_m = max(starts[i] + vehicles[i].length_m for i in members)
    per_metre = (RIGHT - LEFT) / max(end_m, 1.0)
    bottom = ALONG_TOP + ALONG_ROW * len(members)
    rows = [
        _along_row(document, index, starts[index], ALONG_TOP + ALONG_ROW * place, per_metre)
        for place, index in enumerate(members)
    ]
    here = frozenset(members)
    events = [event for event in document.events if event.concerns(here)]
    return Piece(
        "along",
        {
            "key": key,
            "height": bottom + 20,
            "zero": LEFT,
            "end": RIGHT,
            "per_metre": f"{per_metre:.9g}",
            "bottom": bottom,
            "rows": tuple(rows),
            "ticks": tuple(_ticks(end_m / 1000, per_metre * 1000, bottom)),
            "events": tuple(_event_marks(events, per_metre, bottom)),
            "title": "; ".join(
                f"{vehicles[i].letter} {vehicles[i].length_text}" for i in members[:MOST_SPOKEN]
            ),
        },
    )


def _along_row(document: Document, index: int, at: float, y: float, per_metre: float) -> Piece:
    vehicle = document.vehicles[index]
    first = LEFT + at * per_metre
    bands: list[Piece] = []
    for kind, piece in vehicle.way:
        length = document.piece_m(kind, piece)
        if kind == "platoon":
            x = f"{LEFT + at * per_metre:.1f}"
            bands.append(Piece("along-band", {"x": x, "width": f"{length * per_metre:.1f}"}))
        at += length
    return Piece(
        "along-row",
        {
            "y": f"{y:g}",
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": vehicle.letter_size,
            "bands": tuple(bands),
            "x1": f"{first:.1f}",
            "x2": f"{LEFT + at * per_metre:.1f}",
            "square": f"{LEFT + at * per_metre - 3.5:.1f}",
            "dash": vehicle.stroke,
            "cap": vehicle.cap,
        },
    )


def _ticks(last: float, per_unit: float, bottom: float, unit: str = "km") -> Iterator[Piece]:
    """Yield marks of a scale that begins at 0, at most `MOST_TICKS` and the first of them."""
    step = round_step(last / MOST_TICKS)
    count = int(last / step + 1e-9)
    for k in range(count + 1):
        text = f"{k * step:g}"
        yield Piece(
            "tick",
            {
                "x": f"{LEFT + k * step * per_unit:.1f}",
                "bottom": bottom,
                "text_y": bottom + 14,
                "text": f"{text} {unit}" if k == count else text,
            },
        )


def _event_marks(events: Sequence[EventMark], per_metre: float, bottom: float) -> Iterator[Piece]:
    last = -math.inf
    placed = [(event.at_m, event) for event in events if event.at_m is not None]
    for at_m, event in sorted(placed, key=lambda one: one[0]):
        x = LEFT + at_m * per_metre
        # Icons of points near each other stand side by side; their lines tell the true place.
        icon = max(x, last + ICON_WIDTH)
        last = icon
        yield Piece(
            "along-event",
            {
                "x": f"{x:.1f}",
                "icon_x": f"{icon:.1f}",
                "icon": event.kind,
                "bottom": bottom,
                "title": f"{event.name}: {event.text}",
            },
        )


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
    fatigues = [vehicle.fatigue for vehicle in vehicles]
    curves = [curve for fatigue in fatigues for curve in fatigue.curves]
    schedule = document.schedule
    begin_s = schedule.begin_s if schedule else 0.0
    leaves = [
        (vehicle.day.departure_s - begin_s) / 3600 if schedule else 0.0 for vehicle in vehicles
    ]
    hours = max(
        leave + curve.hours[-1]
        for leave, fatigue in zip(leaves, fatigues, strict=True)
        for curve in fatigue.curves
    )
    most = max(max(fatigue.alone_peak, fatigue.joint_peak) for fatigue in fatigues)
    if hours <= 0 or most <= 0:
        return NOTHING
    per_hour, per_point = (RIGHT - 30 - LEFT) / hours, CURVE_HEIGHT / most
    bottom = 6 + CURVE_ROW * len(vehicles)
    rows = [
        _curve_row(vehicle, 6 + CURVE_ROW * place, LEFT + leave * per_hour, per_hour, per_point)
        for place, (vehicle, leave) in enumerate(zip(vehicles, leaves, strict=True))
    ]
    beyond = any(curve.beyond for curve in curves)
    return Piece(
        "fatigue",
        {
            "height": bottom + 20,
            "rows": tuple(rows),
            "ticks": tuple(
                (
                    Piece(
                        "tick",
                        {
                            "x": f"{LEFT + (moment - begin_s) / 3600 * per_hour:.1f}",
                            "bottom": bottom,
                            "text_y": bottom + 14,
                            "text": text,
                        },
                    )
                    for moment, text in hour_ticks(schedule.clock, begin_s, begin_s + hours * 3600)
                )
                if schedule
                else _ticks(hours, per_hour, bottom, "h")
            ),
            "heading": Piece("fatigue-by-clock" if schedule else "fatigue-by-hours"),
            "waits": Piece("fatigue-waits") if schedule else NOTHING,
            "held": Piece("fatigue-held") if beyond else NOTHING,
            "title": "; ".join(
                f"{vehicle.letter}: {one.alone_peak:.0f} alone, {one.joint_peak:.0f} as planned"
                for vehicle, one in zip(vehicles, fatigues, strict=True)
            ),
        },
    )


def _curve_row(vehicle: Vehicle, y: float, left: float, per_hour: float, per_point: float) -> Tree:
    fatigue = vehicle.fatigue
    base = float(CURVE_HEIGHT)

    def path(curve: FatigueCurve) -> str:
        values = curve.values
        # Where the curve is level its ends are enough.
        level = [
            0 < k < len(values) - 1 and values[k - 1] == values[k] == values[k + 1]
            for k in range(len(values))
        ]
        return " ".join(
            f"{left + hour * per_hour:.1f},{base - value * per_point:.1f}"
            for hour, value, skip in zip(curve.hours, values, level, strict=True)
            if not skip
        )

    joint = path(fatigue.joint)
    first, last = joint.split(" ")[0], joint.rsplit(" ", 1)[-1]
    return Piece(
        "fatigue-row",
        {
            "y": f"{y:g}",
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": vehicle.letter_size,
            "alone": path(fatigue.alone),
            "joint": joint,
            "area": f"{first.split(',')[0]},{base:g} {joint} {last.split(',')[0]},{base:g}",
            "base": f"{base:g}",
            "right": f"{RIGHT - 30:g}",
            "peak": f"{fatigue.joint_peak:.0f}",
            "alone_peak": f"{fatigue.alone_peak:.0f}",
        },
    )
