"""The schedule as a static chart: a row for each vehicle on the axis of the clock."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from ...plans.clock import Clock
from ..drawing.vehicle_styles import letter_size
from ..markup.fragments import NOTHING, Markup, fill, join

__all__ = ["BEYOND", "LATE", "clock_text", "hour_ticks", "late_note", "schedule_chart"]

LEFT, RIGHT = 38.0, 358.0
CROWDED_RIGHT = 282.0
ROW, CROWDED_ROW = 36, 24
TOP, CROWDED_TOP = 8, 22

CROWD = 8
"""More vehicles than this get narrow rows, each with its first and last time at the end."""

MOST_TICKS = 7
STEPS_H = (0.25, 0.5, 1, 2, 3, 4, 6, 12, 24, 48, 96, 168, 336, 672)
LABEL_WIDTH = 36.0
LATE = "#a3260a"

BEYOND = 0.25
"""Latest arrivals are drawn up to this share of the day after the last arrival."""


def clock_text(schedule: dict[str, Any], seconds: float) -> str:
    """Return the time of day of a moment: "08:21", with the day from the second day on."""
    return Clock.from_text(schedule["start"]).text(seconds)


def hour_ticks(schedule: dict[str, Any], begin_s: float, end_s: float) -> list[tuple[float, str]]:
    """Return whole hours, or parts of one, within a span, few enough to be read [s, text]."""
    hours = (end_s - begin_s) / 3600
    step = next((h for h in STEPS_H if hours / h <= MOST_TICKS), math.ceil(hours / 168) * 24) * 3600
    midnight = schedule["since_midnight_s"]
    first = math.ceil((midnight + begin_s) / step - 1e-9)
    last = math.floor((midnight + end_s) / step + 1e-9)
    moments = [k * step - midnight for k in range(first, last + 1)]
    return [(moment, clock_text(schedule, moment)) for moment in moments]


def schedule_chart(document: dict[str, Any], members: Sequence[int], key: str = "") -> Markup:
    """Return the day of some vehicles; nothing if the plan has no times."""
    schedule = document["schedule"]
    if schedule is None or not members:
        return NOTHING
    vehicles = [document["vehicles"][index] for index in members]
    begin = min(vehicle["times"]["departure_s"] for vehicle in vehicles)
    last = max(vehicle["times"]["arrival_s"] for vehicle in vehicles)
    # A latest arrival far off would leave no room for the day itself.
    near = last + (last - begin) * BEYOND
    latest = (vehicle["times"]["latest_arrival_s"] for vehicle in vehicles)
    end = max([last, *(at for at in latest if at is not None and at <= near)])
    crowded = len(members) > CROWD
    right = CROWDED_RIGHT if crowded else RIGHT
    per_second = (right - LEFT) / max(end - begin, 1.0)
    axis = _Axis(begin, end, per_second)
    height = CROWDED_ROW if crowded else ROW
    # A crowd scrolls, so its hours stand above it too.
    top = CROWDED_TOP if crowded else TOP
    bottom = top + height * len(members)
    rows = [
        _row(document, index, axis, top + height * place, crowded)
        for place, index in enumerate(members)
    ]
    return fill(
        "schedule",
        key=key,
        day=schedule["text"]["day"],
        zone=schedule["zone"],
        crowd=" crowd" if crowded else "",
        height=bottom + 16,
        bottom=bottom,
        zero=LEFT,
        end=right,
        **{"from": begin},
        per_second=f"{per_second:.9g}",
        ticks=join(
            fill(
                "schedule-tick",
                x=axis.at(moment),
                top=top - 4,
                bottom=bottom,
                text_y=text_y,
                text=text,
            )
            for moment, text in hour_ticks(schedule, begin, end)
            for text_y in (bottom + 12, *([12] if crowded else []))
        ),
        rows=join(rows),
        description="; ".join(_sentence(vehicle) for vehicle in vehicles[:12])
        + (f"; and {len(vehicles) - 12} more" if len(vehicles) > 12 else ""),
        late=_late(vehicles),
        note=_note(vehicles),
    )


class _Axis:
    """Where on the chart a moment lies."""

    def __init__(self, begin: float, end: float, per_second: float) -> None:
        self.begin, self.end, self.per_second = begin, end, per_second

    def x(self, moment: float) -> float:
        return LEFT + (moment - self.begin) * self.per_second

    def at(self, moment: float) -> str:
        return f"{self.x(moment):.1f}"


def _sentence(vehicle: dict[str, Any]) -> str:
    text = vehicle["times"]["text"]
    parts = [f"{vehicle['letter']} leaves {text['departure']}"]
    if vehicle["times"]["waiting_s"] >= 30:
        parts.append(f"waits {text['waiting']}")
    parts.append(f"arrives {text['arrival']}")
    if text["late"]:
        parts.append(f"{text['late']} late")
    return ", ".join(parts)


def _late(vehicles: Sequence[dict[str, Any]]) -> Markup:
    who = _late_ones(vehicles)
    return fill("schedule-late", text=f"Too late, at best: {who}.") if who else NOTHING


def _late_ones(vehicles: Sequence[dict[str, Any]]) -> str:
    return ", ".join(
        f"{vehicle['letter']} by {vehicle['times']['text']['late']}"
        for vehicle in vehicles
        if vehicle["times"] and vehicle["times"]["text"]["late"]
    )


def _note(vehicles: Sequence[dict[str, Any]]) -> str:
    times = [vehicle["times"] for vehicle in vehicles]
    parts = ["Yellow: in the platoon."]
    if any(one["waiting_s"] >= 30 for one in times):
        parts.append("Hatched: waiting for others.")
    if any(one["text"]["held"] for one in times):
        parts.append("Dotted: could have left, but leaves later so that nobody waits.")
    if any(one["latest_arrival_s"] is not None for one in times):
        parts.append("Upright bar: latest arrival.")
    return " ".join(parts)


def _row(document: dict[str, Any], index: int, axis: _Axis, y: float, crowded: bool) -> Markup:
    vehicle = document["vehicles"][index]
    times = vehicle["times"]
    return fill(
        "schedule-row",
        y=f"{y:g}",
        title=_sentence(vehicle),
        colour=vehicle["colour"],
        letter=vehicle["letter"],
        size=letter_size(vehicle["letter"]),
        shapes=join(_shapes(document, index, axis)),
        labels=_span(times) if crowded else join(_labels(document, index, axis)),
    )


def _shapes(document: dict[str, Any], index: int, axis: _Axis) -> Iterator[Markup]:
    vehicle = document["vehicles"][index]
    times = vehicle["times"]
    pieces = list(zip(vehicle["way"], times["spans"], strict=True))
    if times["text"]["held"]:
        # What lies before the chart is cut off.
        first = max(times["earliest_departure_s"], axis.begin)
        if times["departure_s"] - first > 60:
            x2 = axis.x(times["departure_s"]) - 6
            yield fill("schedule-held", x1=axis.at(first), x2=f"{x2:.1f}")
    for (kind, _), (begin, end) in pieces:
        if kind == "platoon":
            yield fill("schedule-band", x=axis.at(begin), width=_width(axis, begin, end))
    for begin, end in _driven(times):
        yield fill(
            "schedule-line", x1=axis.at(begin), x2=axis.at(end), colour=vehicle["colour"],
            dash=vehicle["dash"] or "none", cap=vehicle["cap"],
        )  # fmt: skip
    for begin, end in _waits(times):
        yield fill("schedule-wait", x=axis.at(begin), width=_width(axis, begin, end))
    yield fill("schedule-start", x=axis.at(times["departure_s"]), colour=vehicle["colour"])
    yield fill("schedule-end", x=f"{axis.x(times['arrival_s']) - 4:.1f}", colour=vehicle["colour"])
    for event in document["events"]:
        if index in event["vehicles"] and event["at_s"] is not None:
            # Within the band: a wait ends where it begins, and would be covered.
            aside = 7 if event["kind"] == "merge" else -7
            x = axis.x(event["at_s"]) + aside
            yield fill("schedule-point", x=f"{x:.1f}", icon=event["kind"])
    latest = times["latest_arrival_s"]
    if latest is not None and axis.begin <= latest <= axis.end:
        late = bool(times["text"]["late"])
        yield fill(
            "schedule-deadline", x=axis.at(latest), colour=LATE if late else "#5a6675",
            width="2.4" if late else "1.4",
        )  # fmt: skip


def _width(axis: _Axis, begin: float, end: float) -> str:
    return f"{max((end - begin) * axis.per_second, 0.6):.1f}"


def _driven(times: dict[str, Any]) -> list[list[float]]:
    """Return the spans of driving, joined where nothing lies between."""
    found: list[list[float]] = []
    for begin, end in times["spans"]:
        if found and begin - found[-1][1] < 30:
            found[-1][1] = end
        else:
            found.append([begin, end])
    return found


def _waits(times: dict[str, Any]) -> list[tuple[float, float]]:
    ends = [times["departure_s"], *(end for _, end in times["spans"])]
    starts = (begin for begin, _ in times["spans"])
    return [(end, begin) for end, begin in zip(ends, starts, strict=False) if begin - end >= 30]


def _labels(document: dict[str, Any], index: int, axis: _Axis) -> Iterator[Markup]:
    """Yield the times under a row: departure and arrival first, then points where there is room."""
    vehicle = document["vehicles"][index]
    times = vehicle["times"]
    late = bool(times["text"]["late"])
    wanted = [
        (times["departure_s"], times["text"]["departure"], "#17202b", "700"),
        (times["arrival_s"], times["text"]["arrival"], LATE if late else "#17202b", "700"),
    ]
    wanted += [
        (event["at_s"], clock_text(document["schedule"], event["at_s"]), "#5a6675", "400")
        for event in document["events"]
        if index in event["vehicles"] and event["at_s"] is not None
    ]
    taken: list[tuple[float, float]] = []
    for moment, text, colour, weight in wanted:
        half = LABEL_WIDTH / 2 * max(len(text) / 5, 1)
        spot = axis.x(moment)
        for x in (spot, spot + 6, spot - 6, spot + 12, spot - 12, spot + 20, spot - 20, spot + 27):
            x = min(max(x, 22 + half), 372 - half)
            if all(x + half < low or x - half > high for low, high in taken):
                taken.append((x - half, x + half))
                yield fill(
                    "schedule-label", x=f"{x:.1f}", y=28, text=text, colour=colour, weight=weight
                )
                break


def _span(times: dict[str, Any]) -> Markup:
    late = bool(times["text"]["late"])
    text = f"{times['text']['departure']} \u2013 {times['text']['arrival']}"
    return fill(
        "schedule-span", text=text, colour=LATE if late else "#5a6675",
        weight="700" if late else "400",
    )  # fmt: skip


def late_note(document: dict[str, Any]) -> list[Markup]:
    """Return a note of who arrives too late, and by how much; none if all are in time."""
    who = _late_ones(document["vehicles"])
    return [fill("note-late", text=f"Not feasible in time. Late, at best: {who}.")] if who else []
