"""Charts of a report: the way of each vehicle by distance, and its fatigue along the day."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from ..drawing.vehicle_styles import letter_size
from ..markup.fragments import NOTHING, Markup, fill, join
from .schedule_chart import hour_ticks

__all__ = ["along_chart", "fatigue_chart"]

LEFT, RIGHT = 34.0, 364.0
ALONG_TOP, ALONG_ROW = 30, 25
MOST_TICKS = 6

MOST_CURVES = 8
"""More vehicles than this get no fatigue chart: the table of a crowd would not be read."""

CURVE_ROW, CURVE_HEIGHT = 48, 36
FITTED_H = 4.5

ICON_WIDTH = 15.0


def along_chart(document: dict[str, Any], members: Sequence[int], key: str = "") -> Markup:
    """Return the way of some vehicles by distance: platoon in yellow, merges and separations."""
    scale = document["journey"]
    if scale is None or not members:
        return NOTHING
    vehicles = document["vehicles"]
    starts = scale["starts_m"]
    end_m = max(starts[i] + vehicles[i]["length_m"] for i in members)
    per_metre = (RIGHT - LEFT) / max(end_m, 1.0)
    bottom = ALONG_TOP + ALONG_ROW * len(members)
    rows = [
        _along_row(document, index, ALONG_TOP + ALONG_ROW * place, per_metre)
        for place, index in enumerate(members)
    ]
    events = [event for event in document["events"] if set(event["vehicles"]) & set(members)]
    return fill(
        "along",
        key=key,
        height=bottom + 20,
        zero=LEFT,
        end=RIGHT,
        per_metre=f"{per_metre:.9g}",
        bottom=bottom,
        rows=join(rows),
        ticks=join(_ticks(end_m / 1000, per_metre * 1000, bottom)),
        events=join(_event_marks(events, per_metre, bottom)),
        title="; ".join(
            f"{vehicles[i]['letter']} {vehicles[i]['length_text']}" for i in members[:12]
        ),
    )


def _along_row(document: dict[str, Any], index: int, y: float, per_metre: float) -> Markup:
    vehicle = document["vehicles"][index]
    at = document["journey"]["starts_m"][index]
    first = LEFT + at * per_metre
    bands: list[Markup] = []
    for kind, piece in vehicle["way"]:
        length = document["platoons" if kind == "platoon" else "solos"][piece]["length_m"]
        if kind == "platoon":
            x = f"{LEFT + at * per_metre:.1f}"
            bands.append(fill("along-band", x=x, width=f"{length * per_metre:.1f}"))
        at += length
    return fill(
        "along-row", y=f"{y:g}", colour=vehicle["colour"], letter=vehicle["letter"],
        size=letter_size(vehicle["letter"]), bands=join(bands),
        x1=f"{first:.1f}", x2=f"{LEFT + at * per_metre:.1f}",
        square=f"{LEFT + at * per_metre - 3.5:.1f}", dash=vehicle["dash"] or "none",
        cap=vehicle["cap"],
    )  # fmt: skip


def _ticks(last: float, per_unit: float, bottom: float, unit: str = "km") -> Iterator[Markup]:
    """Yield marks of a scale that begins at 0, at most `MOST_TICKS` and the first of them."""
    step = _round_step(last / MOST_TICKS)
    count = int(last / step + 1e-9)
    for k in range(count + 1):
        text = f"{k * step:g}"
        yield fill(
            "tick", x=f"{LEFT + k * step * per_unit:.1f}", bottom=bottom, text_y=bottom + 14,
            text=f"{text} {unit}" if k == count else text,
        )  # fmt: skip


def _round_step(least: float) -> float:
    """Return the least of 1, 2, 5, 10, 20, ... that is no less than `least`."""
    power = 10 ** math.floor(math.log10(max(least, 1e-9)))
    return float(next(k * power for k in (1, 2, 5, 10) if k * power >= least * (1 - 1e-9)))


def _event_marks(
    events: Sequence[dict[str, Any]], per_metre: float, bottom: float
) -> Iterator[Markup]:
    last = -math.inf
    for event in sorted(events, key=lambda one: one["at_m"]):
        x = LEFT + event["at_m"] * per_metre
        # Icons of points near each other stand side by side; their lines tell the true place.
        icon = max(x, last + ICON_WIDTH)
        last = icon
        yield fill(
            "along-event", x=f"{x:.1f}", icon_x=f"{icon:.1f}", icon=event["kind"], bottom=bottom,
            title=f"{event['name']}: {event['text']}",
        )  # fmt: skip


def fatigue_chart(document: dict[str, Any]) -> Markup:
    """Return fatigue along the day, alone and as planned, a row for each vehicle.

    The day is that of the clock where the plan has times, else hours of driving.
    """
    vehicles = document["vehicles"]
    if len(vehicles) > MOST_CURVES:
        return NOTHING
    curves = [vehicle["fatigue"] for vehicle in vehicles]
    schedule = document["schedule"]
    begin_s = schedule["begin_s"] if schedule else 0.0
    leaves = [
        (vehicle["times"]["departure_s"] - begin_s) / 3600 if schedule else 0.0
        for vehicle in vehicles
    ]
    hours = max(
        leave + curve[which]["hours"][-1]
        for leave, curve in zip(leaves, curves, strict=True)
        for which in ("alone", "joint")
    )
    most = max(max(curve["alone_peak"], curve["joint_peak"]) for curve in curves)
    if hours <= 0 or most <= 0:
        return NOTHING
    per_hour, per_point = (RIGHT - 30 - LEFT) / hours, CURVE_HEIGHT / most
    bottom = 6 + CURVE_ROW * len(vehicles)
    rows = [
        _curve_row(vehicle, 6 + CURVE_ROW * place, LEFT + leave * per_hour, per_hour, per_point)
        for place, (vehicle, leave) in enumerate(zip(vehicles, leaves, strict=True))
    ]
    beyond = any(curve[which]["beyond"] for curve in curves for which in ("alone", "joint"))
    return fill(
        "fatigue",
        height=bottom + 20,
        rows=join(rows),
        ticks=join(
            (
                fill(
                    "tick",
                    x=f"{LEFT + (moment - begin_s) / 3600 * per_hour:.1f}",
                    bottom=bottom,
                    text_y=bottom + 14,
                    text=text,
                )
                for moment, text in hour_ticks(schedule, begin_s, begin_s + hours * 3600)
            )
            if schedule
            else _ticks(hours, per_hour, bottom, "h")
        ),
        heading=fill("fatigue-by-clock" if schedule else "fatigue-by-hours"),
        waits=fill("fatigue-waits") if schedule else NOTHING,
        held=fill("fatigue-held") if beyond else NOTHING,
        title="; ".join(
            f"{v['letter']}: {v['fatigue']['alone_peak']:.0f} alone, "
            f"{v['fatigue']['joint_peak']:.0f} as planned"
            for v in vehicles
        ),
    )


def _curve_row(
    vehicle: dict[str, Any], y: float, left: float, per_hour: float, per_point: float
) -> Markup:
    curve = vehicle["fatigue"]
    base = float(CURVE_HEIGHT)

    def path(which: str) -> str:
        values = curve[which]["values"]
        # Where the curve is level its ends are enough.
        level = [0 < k < len(values) - 1 and values[k - 1] == values[k] == values[k + 1]
                 for k in range(len(values))]  # fmt: skip
        return " ".join(
            f"{left + hour * per_hour:.1f},{base - value * per_point:.1f}"
            for hour, value, skip in zip(curve[which]["hours"], values, level, strict=True)
            if not skip
        )

    joint = path("joint")
    first, last = joint.split(" ")[0], joint.rsplit(" ", 1)[-1]
    return fill(
        "fatigue-row", y=f"{y:g}", colour=vehicle["colour"], letter=vehicle["letter"],
        size=letter_size(vehicle["letter"]), alone=path("alone"), joint=joint,
        area=f"{first.split(',')[0]},{base:g} {joint} {last.split(',')[0]},{base:g}",
        base=f"{base:g}", right=f"{RIGHT - 30:g}", peak=f"{curve['joint_peak']:.0f}",
        alone_peak=f"{curve['alone_peak']:.0f}",
    )  # fmt: skip
