"""The schedule as a static chart: a row for each vehicle on the axis of the clock."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...plans.clock import MENTIONED_S, Clock, whole_minutes
from ..document.model import Document
from ..document.model_day import VehicleDay
from ..document.model_law import Standing
from ..drawing.crowd import CROWD
from ..drawing.palette import CASING, INK, LATE, MUTED, TICK
from ..language.speech import clock_time, say
from ..markup.fragments import NOTHING, Piece, Tree
from .axes import SIZE, WIDTH, Tick, day_scale, letter_type, plain, text_width
from .sentences import sentence, spoken_list

__all__ = [
    "BEYOND", "PAUSES", "drawn_kinds", "schedule_chart", "schedule_notes", "stands_text",
]  # fmt: skip

PAUSES = {
    "break": "schedule.break",
    "rest": "schedule.rest",
    "ban": "schedule.ban",
    "change": "schedule.change",
}
"""What is drawn apart from a wait for others, each by its own shape, and what says so."""

PAUSE_SIZE = 11.0
"""Of the type in a box."""

DISC = 7.0
"""What a disc has around the number in it."""

ICON = 7.5
"""Half of what the icon of a merge or a separation takes."""

SIGN = 11.0
"""A driving ban this wide bears its sign."""

LEFT, RIGHT = 38.0, WIDTH - 14
ROW, CROWDED_ROW = 38, 26
TOP, CROWDED_TOP = 8, 22

LABEL_Y = 32.0
"""Base line of the times under a row."""

BEYOND = 0.25
"""What was asked for is drawn up to this share of the day before its begin and after its end."""

LABEL_GAP = 3.0
"""Blank between times under a row."""

LEAST_WAIT = 3.0
"""A wait is drawn at least so wide, or it would not be seen."""


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
    begin, end = _span([vehicle.day for vehicle in vehicles])
    crowded = len(members) > CROWD
    right = RIGHT
    if crowded:
        right = (
            WIDTH
            - 10
            - max(text_width(_span_text(vehicle.day), SIZE, True) for vehicle in vehicles)
        )
    per_second = (right - LEFT) / max(end - begin, 1.0)
    axis = _Axis(begin, end, per_second, schedule.clock)
    height = CROWDED_ROW if crowded else ROW
    ticks = day_scale(axis.clock, begin, end, axis.x, (0.0, WIDTH if not crowded else right + 30))
    two = any(tick.below for tick in ticks)
    # A crowd scrolls, so its hours stand above it too.
    top = CROWDED_TOP + SIZE * two if crowded else TOP
    bottom = top + height * len(members)
    rows = [
        _row(document, index, axis, top + height * place, crowded)
        for place, index in enumerate(members)
    ]
    return Piece(
        "schedule",
        {
            "key": key,
            "heading": say(
                "schedule.heading", day=schedule.text.day, zone=schedule.zone_of(begin, end)
            ),
            "crowd": " crowd" if crowded else "",
            "height": f"{bottom + SIZE * (1 + two) + 6:g}",
            "bottom": f"{bottom:g}",
            "zero": LEFT,
            "end": f"{right:.1f}",
            "from": begin,
            "per_second": f"{per_second:.9g}",
            "ticks": tuple(
                _tick(tick, axis, top, bottom, (bottom, 0.0) if crowded else (bottom,))
                for tick in ticks
            ),
            "rows": tuple(rows),
            "description": spoken_list(vehicles),
            "note": schedule_notes(document, members),
        },
    )


def _span(days: Sequence[VehicleDay]) -> tuple[float, float]:
    """Return the time that is drawn: the day, and what was asked for near it."""
    first, last = min(day.departure_s for day in days), max(day.arrival_s for day in days)
    far = (last - first) * BEYOND
    # Windows far off would leave no room for the day itself.
    asked = (day.earliest_departure_s for day in days if day.text.held)
    latest = (day.latest_arrival_s for day in days)
    return (
        min([first, *(max(at, first - far) for at in asked if at is not None)]),
        max([last, *(at for at in latest if at is not None and at <= last + far)]),
    )


def _tick(tick: Tick, axis: _Axis, top: float, bottom: float, lines: tuple[float, ...]) -> Piece:
    texts = (
        Piece(
            "schedule-tick-text",
            {"x": f"{tick.place:.1f}", "y": f"{line + SIZE * (1 + number) + 2:g}", "text": text},
        )
        for line in lines
        for number, text in enumerate(tick.texts)
    )
    return Piece(
        "schedule-tick",
        {
            "x": axis.at(tick.at),
            "top": f"{top - 4:g}",
            "bottom": f"{bottom:g}",
            "colour": MUTED if tick.strong else TICK,
            "dash": "5 3" if tick.strong else "none",
            "texts": tuple(texts),
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


def schedule_notes(document: Document, members: Sequence[int]) -> str:
    """Return what the drawing means, as far as it shows it.

    Parameters
    ----------
    document : Document
        Whose vehicles they are.
    members : sequence of int
        Their positions.

    Returns
    -------
    str
        Sentences.
    """
    vehicles = [document.vehicles[index] for index in members]
    days = [vehicle.day for vehicle in vehicles]
    stands = drawn_kinds(days)
    shown = {
        "schedule.yellow": any(kind == "platoon" for one in vehicles for kind, _ in one.way),
        "schedule.hatched": "wait" in stands,
        **{key: kind in stands for kind, key in PAUSES.items()},
        "schedule.dotted": any(one.text.held for one in days),
        "schedule.position": any(document.positions[index] for index in members),
        "schedule.bar": any(one.latest_arrival_s is not None for one in days),
    }
    return " ".join(say(key) for key, is_shown in shown.items() if is_shown)


def drawn_kinds(days: Sequence[VehicleDay]) -> set[str]:
    """Return for what vehicles stand, as far as it is drawn.

    Parameters
    ----------
    days : sequence of VehicleDay
        Theirs.

    Returns
    -------
    set of str
        Kinds of `Standing`.
    """
    return {one.kind for day in days for one in day.stands if one.lasts_s >= MENTIONED_S}


def _row(document: Document, index: int, axis: _Axis, y: float, crowded: bool) -> Piece:
    vehicle = document.vehicles[index]
    times = vehicle.day
    return Piece(
        "schedule-row",
        {
            "y": f"{y:g}",
            "index": index,
            "title": sentence(vehicle),
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": letter_type(vehicle.letter),
            "shapes": tuple(_shapes(document, index, axis)),
            "labels": _span_label(times) if crowded else tuple(_labels(document, index, axis)),
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
            x1, x2 = axis.x(first), axis.x(times.departure_s) - 6
            # An arrow where it could have left still earlier, else a stop.
            cut = times.earliest_departure_s < first - 1
            mark = f"M{x1 + 5:.1f} 6L{x1:.1f} 10L{x1 + 5:.1f} 14" if cut else f"M{x1:.1f} 5V15"
            values = {"x1": f"{x1:.1f}", "x2": f"{max(x2, x1 + 1):.1f}", "mark": mark}
            yield Piece("schedule-held", values)
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
    for one in times.stands:
        if one.lasts_s >= MENTIONED_S:
            yield _stand(one, axis)
    yield from _positions(document, index, axis)
    yield Piece("schedule-start", {"x": axis.at(times.departure_s), "colour": vehicle.colour})
    yield Piece(
        "schedule-end", {"x": f"{axis.x(times.arrival_s) - 4:.1f}", "colour": vehicle.colour}
    )
    for icon, x in _points(document, index, axis):
        yield Piece("schedule-point", {"x": f"{x:.1f}", "icon": icon})
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


def _points(document: Document, index: int, axis: _Axis) -> Iterator[tuple[str, float]]:
    """Yield where a vehicle merges and separates: the icon, and where it is drawn."""
    for event in document.events:
        if index in event.vehicles and event.at_s is not None and not event.stands:
            # Within the band: a wait ends where it begins, and would be covered.
            yield event.kind, axis.x(event.at_s) + (7 if event.kind == "merge" else -7)


def _positions(document: Document, index: int, axis: _Axis) -> Iterator[Piece]:
    """Yield the position in the platoon where there is room for it; who leads is set off."""
    points = [x for _, x in _points(document, index, axis)] if document.positions[index] else []
    for one in document.positions[index]:
        text = str(one.position)
        room = text_width(text, PAUSE_SIZE, True) + DISC
        low, high = axis.x(one.begin_s), axis.x(one.end_s)
        for x in points:
            if low < x < high:
                low, high = (x + ICON, high) if x - low < high - x else (low, x - ICON)
        if high - low >= room:
            leads = one.position == 1
            yield Piece(
                "schedule-position",
                {
                    "x": f"{(low + high) / 2:.1f}",
                    "from": f"{-room / 2:.1f}",
                    "width": f"{room:.1f}",
                    "text": text,
                    "fill": INK if leads else CASING,
                    "colour": CASING if leads else INK,
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


def _stand(one: Standing, axis: _Axis) -> Piece:
    # A short one too ends where the vehicle goes on.
    width = max(one.lasts_s * axis.per_second, LEAST_WAIT)
    x = axis.x(one.end_s) - width
    values = {"x": f"{x:.1f}", "width": f"{width:.1f}"}
    middle = f"{x + width / 2:.1f}"
    told: Tree = NOTHING
    if one.kind in ("break", "rest"):
        text = stands_text(one)
        if width >= text_width(text, PAUSE_SIZE, True) + 2:
            colour = INK if one.kind == "break" else CASING
            told = Piece("schedule-stand-text", {"x": middle, "text": text, "colour": colour})
    elif one.kind == "ban" and width >= SIGN:
        told = Piece("schedule-sign", {"x": middle})
    return Piece(f"schedule-{one.kind}", {**values, "middle": middle, "told": told})


def stands_text(one: Standing) -> str:
    """Return how long a break or a rest is, as it stands in its box.

    Parameters
    ----------
    one : Standing
        Of a vehicle's day.

    Returns
    -------
    str
        Of a break its minutes; of a rest its hours.
    """
    if one.kind == "break":
        return str(whole_minutes(one.lasts_s))
    return f"{plain(round(one.lasts_s / 360) / 10)} h"


def _labels(document: Document, index: int, axis: _Axis) -> Iterator[Piece]:
    """Yield the times under a row: departure and arrival, then points where there is room.

    Departure and arrival stand as one text where two would not fit side by side.
    """
    times = document.vehicles[index].day
    ink = LATE if times.is_late else INK
    leaves, arrives = times.text.departure, times.text.arrival
    ends = [
        (axis.x(times.departure_s), text_width(leaves, SIZE, True) / 2, leaves, INK, "700"),
        (axis.x(times.arrival_s), text_width(arrives, SIZE, True) / 2, arrives, ink, "700"),
    ]
    ends = [(_within(x, half), half, text, look, bold) for x, half, text, look, bold in ends]
    if ends[0][0] + ends[0][1] + LABEL_GAP > ends[1][0] - ends[1][1]:
        text = _span_text(times)
        half = text_width(text, SIZE, True) / 2
        middle = (axis.x(times.departure_s) + axis.x(times.arrival_s)) / 2
        ends = [(_within(middle, half), half, text, ink, "700")]
    taken: list[tuple[float, float]] = []
    for x, half, text, colour, weight in ends:
        taken.append((x - half, x + half))
        yield _label(x, text, colour, weight)
    for event in document.events:
        if index not in event.vehicles or event.at_s is None or event.stands:
            continue
        text = clock_time(axis.clock, event.at_s)
        half, spot = text_width(text, SIZE) / 2, axis.x(event.at_s)
        for aside in (0, 6, -6, 12, -12, 20, -20, 27):
            x = _within(spot + aside, half)
            if all(
                x + half + LABEL_GAP < low or x - half - LABEL_GAP > high for low, high in taken
            ):
                taken.append((x - half, x + half))
                yield _label(x, text, MUTED, "400")
                break


def _within(x: float, half: float) -> float:
    return min(max(x, half), WIDTH - half)


def _label(x: float, text: str, colour: str, weight: str) -> Piece:
    values = {"x": f"{x:.1f}", "y": f"{LABEL_Y:g}", "text": text}
    return Piece("schedule-label", {**values, "colour": colour, "weight": weight})


def _span_text(times: VehicleDay) -> str:
    return f"{times.text.departure} \u2013 {times.text.arrival}"


def _span_label(times: VehicleDay) -> Piece:
    late = times.is_late
    return Piece(
        "schedule-span",
        {
            "text": _span_text(times),
            "colour": LATE if late else MUTED,
            "weight": "700" if late else "400",
        },
    )
