"""The schedule as a static chart: a row for each vehicle on the axis of the clock."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...plans.clock import MENTIONED_S, Clock
from ..document.model import Document
from ..document.model_day import VehicleDay
from ..document.model_vehicle import Vehicle
from ..drawing.crowd import CROWD, MOST_SPOKEN
from ..drawing.palette import INK, LATE, MUTED
from ..drawing.ticks import hour_ticks
from ..markup.fragments import NOTHING, Piece, Tree

__all__ = ["BEYOND", "late_note", "schedule_chart"]

LEFT, RIGHT = 38.0, 358.0
CROWDED_RIGHT = 282.0
ROW, CROWDED_ROW = 36, 24
TOP, CROWDED_TOP = 8, 22

LABEL_WIDTH = 36.0

BEYOND = 0.25
"""Latest arrivals are drawn up to this share of the day after the last arrival."""


def schedule_chart(document: Document, members: Sequence[int], key: str = "") -> Tree:
    """Return the day of some vehicles.

    A crowd has narrow rows, each with its first and last time at the end.

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
        An SVG; nothing if the plan has no times.
    """
    schedule = document.schedule
    if schedule is None or not members:
        return NOTHING
    vehicles = [document.vehicles[index] for index in members]
    begin = min(vehicle.day.departure_s for vehicle in vehicles)
    last = max(vehicle.day.arrival_s for vehicle in vehicles)
    # A latest arrival far off would leave no room for the day itself.
    near = last + (last - begin) * BEYOND
    latest = (vehicle.day.latest_arrival_s for vehicle in vehicles)
    end = max([last, *(at for at in latest if at is not None and at <= near)])
    crowded = len(members) > CROWD
    right = CROWDED_RIGHT if crowded else RIGHT
    per_second = (right - LEFT) / max(end - begin, 1.0)
    axis = _Axis(begin, end, per_second, schedule.clock)
    height = CROWDED_ROW if crowded else ROW
    # A crowd scrolls, so its hours stand above it too.
    top = CROWDED_TOP if crowded else TOP
    bottom = top + height * len(members)
    rows = [
        _row(document, index, axis, top + height * place, crowded)
        for place, index in enumerate(members)
    ]
    return Piece(
        "schedule",
        {
            "key": key,
            "day": schedule.text.day,
            "zone": schedule.zone,
            "crowd": " crowd" if crowded else "",
            "height": bottom + 16,
            "bottom": bottom,
            "zero": LEFT,
            "end": right,
            "from": begin,
            "per_second": f"{per_second:.9g}",
            "ticks": tuple(
                Piece(
                    "schedule-tick",
                    {
                        "x": axis.at(moment),
                        "top": top - 4,
                        "bottom": bottom,
                        "text_y": text_y,
                        "text": text,
                    },
                )
                for moment, text in hour_ticks(axis.clock, begin, end)
                for text_y in (bottom + 12, *([12] if crowded else []))
            ),
            "rows": tuple(rows),
            "description": "; ".join(_sentence(vehicle) for vehicle in vehicles[:MOST_SPOKEN])
            + (f"; and {len(vehicles) - MOST_SPOKEN} more" if len(vehicles) > MOST_SPOKEN else ""),
            "late": _late(vehicles),
            "note": _note(vehicles),
        },
    )


class _Axis:
    """Where on the chart a moment lies, and what time it is then."""

    def __init__(self, begin: float, end: float, per_second: float, clock: Clock) -> None:
        self.begin, self.end, self.per_second, self.clock = begin, end, per_second, clock

    def x(self, moment: float) -> float:
        return LEFT + (moment - self.begin) * self.per_second

    def at(self, moment: float) -> str:
        return f"{self.x(moment):.1f}"


def _sentence(vehicle: Vehicle) -> str:
    text = vehicle.day.text
    parts = [f"{vehicle.letter} leaves {text.departure}"]
    if vehicle.day.waiting_s >= MENTIONED_S:
        parts.append(f"waits {text.waiting}")
    parts.append(f"arrives {text.arrival}")
    if text.late:
        parts.append(f"{text.late} late")
    return ", ".join(parts)


def _late(vehicles: Sequence[Vehicle]) -> Tree:
    who = _late_ones(vehicles)
    return Piece("schedule-late", {"text": f"Too late, at best: {who}."}) if who else NOTHING


def _late_ones(vehicles: Sequence[Vehicle]) -> str:
    return ", ".join(
        f"{vehicle.letter} by {vehicle.times.text.late}"
        for vehicle in vehicles
        if vehicle.times is not None and vehicle.times.is_late
    )


def _note(vehicles: Sequence[Vehicle]) -> str:
    times = [vehicle.day for vehicle in vehicles]
    parts = ["Yellow: in the platoon."]
    if any(one.waiting_s >= MENTIONED_S for one in times):
        parts.append("Hatched: waiting for others.")
    if any(one.text.held for one in times):
        parts.append("Dotted: could have left, but leaves later so that nobody waits.")
    if any(one.latest_arrival_s is not None for one in times):
        parts.append("Upright bar: latest arrival.")
    return " ".join(parts)


def _row(document: Document, index: int, axis: _Axis, y: float, crowded: bool) -> Piece:
    vehicle = document.vehicles[index]
    times = vehicle.day
    return Piece(
        "schedule-row",
        {
            "y": f"{y:g}",
            "title": _sentence(vehicle),
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": vehicle.letter_size,
            "shapes": tuple(_shapes(document, index, axis)),
            "labels": _span(times) if crowded else tuple(_labels(document, index, axis)),
        },
    )


def _shapes(document: Document, index: int, axis: _Axis) -> Iterator[Piece]:
    vehicle = document.vehicles[index]
    times = vehicle.day
    pieces = list(zip(vehicle.way, times.spans, strict=True))
    if times.text.held and times.earliest_departure_s is not None:
        # What lies before the chart is cut off.
        first = max(times.earliest_departure_s, axis.begin)
        if times.departure_s - first > 60:
            x2 = axis.x(times.departure_s) - 6
            yield Piece("schedule-held", {"x1": axis.at(first), "x2": f"{x2:.1f}"})
    for (kind, _), (begin, end) in pieces:
        if kind == "platoon":
            yield Piece("schedule-band", {"x": axis.at(begin), "width": _width(axis, begin, end)})
    for begin, end in _driven(times):
        yield Piece(
            "schedule-line",
            {
                "x1": axis.at(begin),
                "x2": axis.at(end),
                "colour": vehicle.colour,
                "dash": vehicle.stroke,
                "cap": vehicle.cap,
            },
        )
    for begin, end in _waits(times):
        yield Piece("schedule-wait", {"x": axis.at(begin), "width": _width(axis, begin, end)})
    yield Piece("schedule-start", {"x": axis.at(times.departure_s), "colour": vehicle.colour})
    yield Piece(
        "schedule-end", {"x": f"{axis.x(times.arrival_s) - 4:.1f}", "colour": vehicle.colour}
    )
    for event in document.events:
        if index in event.vehicles and event.at_s is not None:
            # Within the band: a wait ends where it begins, and would be covered.
            aside = 7 if event.kind == "merge" else -7
            x = axis.x(event.at_s) + aside
            yield Piece("schedule-point", {"x": f"{x:.1f}", "icon": event.kind})
    latest = times.latest_arrival_s
    if latest is not None and axis.begin <= latest <= axis.end:
        late = times.is_late
        yield Piece(
            "schedule-deadline",
            {
                "x": axis.at(latest),
                "colour": LATE if late else MUTED,
                "width": "2.4" if late else "1.4",
            },
        )


def _width(axis: _Axis, begin: float, end: float) -> str:
    return f"{max((end - begin) * axis.per_second, 0.6):.1f}"


def _driven(times: VehicleDay) -> list[list[float]]:
    """Return the spans of driving, joined where nothing lies between."""
    found: list[list[float]] = []
    for begin, end in times.spans:
        if found and begin - found[-1][1] < MENTIONED_S:
            found[-1][1] = end
        else:
            found.append([begin, end])
    return found


def _waits(times: VehicleDay) -> list[tuple[float, float]]:
    ends = [times.departure_s, *(end for _, end in times.spans)]
    starts = (begin for begin, _ in times.spans)
    return [
        (end, begin) for end, begin in zip(ends, starts, strict=False) if begin - end >= MENTIONED_S
    ]


def _labels(document: Document, index: int, axis: _Axis) -> Iterator[Piece]:
    """Yield the times under a row: departure and arrival first, then points where there is room."""
    vehicle = document.vehicles[index]
    times = vehicle.day
    late = times.is_late
    wanted = [
        (times.departure_s, times.text.departure, INK, "700"),
        (times.arrival_s, times.text.arrival, LATE if late else INK, "700"),
    ]
    wanted += [
        (event.at_s, axis.clock.text(event.at_s), MUTED, "400")
        for event in document.events
        if index in event.vehicles and event.at_s is not None
    ]
    taken: list[tuple[float, float]] = []
    for moment, text, colour, weight in wanted:
        half = LABEL_WIDTH / 2 * max(len(text) / 5, 1)
        spot = axis.x(moment)
        for x in (spot, spot + 6, spot - 6, spot + 12, spot - 12, spot + 20, spot - 20, spot + 27):
            x = min(max(x, 22 + half), 372 - half)
            if all(x + half < low or x - half > high for low, high in taken):
                taken.append((x - half, x + half))
                yield Piece(
                    "schedule-label",
                    {"x": f"{x:.1f}", "y": 28, "text": text, "colour": colour, "weight": weight},
                )
                break


def _span(times: VehicleDay) -> Piece:
    late = times.is_late
    text = f"{times.text.departure} \u2013 {times.text.arrival}"
    return Piece(
        "schedule-span",
        {"text": text, "colour": LATE if late else MUTED, "weight": "700" if late else "400"},
    )


def late_note(document: Document) -> list[Piece]:
    """Return a note of who arrives too late, and by how much.

    Parameters
    ----------
    document : Document
        Whose vehicles they are.

    Returns
    -------
    list of Piece
        One note, or none if all are in time.
    """
    who = _late_ones(document.vehicles)
    return (
        [Piece("note-late", {"text": f"Not feasible in time. Late, at best: {who}."})]
        if who
        else []
    )
