"""One driver's sheet as a piece of a page: what comes first, the strip, the steps, the map."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...plans.clock import MENTIONED_S, duration
from ...plans.timetable import LATE_S, VehicleTimes
from ...shown_text import fitted, shortened
from ..document.findings import Findings
from ..document.model import Document
from ..language.speech import day_and_date, late_by, say, zone_text
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import kilometres
from ..pages.page_pieces import badge
from .layout import CROWDED, MAP_WIDTH_MM, Layout, layout_of, lines_of
from .route_map import own_document, route_map
from .steps import Step, Way
from .strip import strip
from .words import StepWords, Teller

__all__ = ["Journey", "sheet"]

LONGEST_HEAD = 90
LONGEST_NOTE = 260
LONGEST_NAME = 26

FEW_FACES = 8
"""Vehicles that are drawn in the order of driving; of more, their letters are listed."""

MAP_PX = 720.0
"""Width of a map in its own pixels."""

BREAK_AFTER_S, BREAK_S = 4.5 * 3600, 45 * 60.0
"""Driving beyond the first without the second is said, whatever the law of the land."""

HEAD_MM = 62.0
"""Heading, facts, strip and credits of a sheet that has one line of each."""


@dataclass(frozen=True, slots=True)
class Journey:
    """All that a sheet tells of one vehicle.

    Attributes
    ----------
    found : Findings
        Of the plan.
    document : Document
        Of the plan.
    index : int
        Position of the vehicle.
    steps : tuple of Step
        Of it.
    words : tuple of StepWords
        The same in words.
    """

    found: Findings
    document: Document
    index: int
    steps: tuple[Step, ...]
    words: tuple[StepWords, ...]

    @property
    def times(self) -> VehicleTimes | None:
        """When it drives."""
        return self.found.plan.times[self.index]


def sheet(journey: Journey) -> Piece:
    """Return the sheet of one vehicle, which fills one page of A4.

    Parameters
    ----------
    journey : Journey
        What it tells.

    Returns
    -------
    Piece
        A section of a page.
    """
    key = str(journey.index + 1)
    vehicle = journey.document.vehicles[journey.index]
    name = shortened(fitted(journey.found.plan.trips[journey.index].vehicle), LONGEST_HEAD)
    origin, destination = (
        shortened(stop.name, LONGEST_HEAD) for stop in (vehicle.origin, vehicle.destination)
    )
    alerts, notes = _alerts(journey), _notes(journey)
    lines = [*alerts, *notes]
    head_mm = HEAD_MM + sum(1.5 + 4.4 * lines_of(text, 12.5, 180.0) for text in lines)
    head_mm += 7.0 * (lines_of(name, 25.0, 125.0) - 1)
    head_mm += 5.0 * (lines_of(f"{origin} - {destination}", 14.5, 125.0) - 1)
    layout = layout_of(journey.words, head_mm)
    return Piece(
        "sheet",
        {
            "key": key,
            "density": layout.density,
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": vehicle.letter_size,
            "name": name,
            "origin": origin,
            "destination": destination,
            "day": _day(journey),
            "alerts": tuple(Piece("sheet-alert", {"text": text}) for text in alerts),
            "facts": _facts(journey),
            "strip": strip(vehicle, journey.steps, journey.words, key),
            "steps": _steps(journey, layout),
            "map": _map(journey, key, layout),
            "notes": tuple(Piece("sheet-note", {"text": text}) for text in notes),
            "credits": " \u00b7 ".join(journey.document.provenance.credits),
        },
    )


def _map(journey: Journey, key: str, layout: Layout) -> Piece:
    own = own_document(journey.found, journey.document, journey.index, journey.steps)
    height = layout.map_mm * MAP_PX / MAP_WIDTH_MM
    return Piece("sheet-figure", {"map": route_map(own, key, (MAP_PX, height))})


def _day(journey: Journey) -> Tree:
    times, table = journey.times, journey.found.plan.timetable
    if times is None or table is None:
        return Piece("sheet-day", {"date": say("sheet.no-times"), "zone": ""})
    clock = table.clock
    # Times of a later day than the clock's first are followed by "+1 d".
    return Piece(
        "sheet-day",
        {"date": day_and_date(clock.moment(0.0)), "zone": zone_text(clock)},
    )


# -- what comes first, and what comes last ---------------------------------------------------------


def _alerts(journey: Journey) -> list[str]:
    """Return what a driver has to know before all else: being late, and hours without a break."""
    found: list[str] = []
    plan, times = journey.found.plan, journey.times
    teller = Teller(journey.found, journey.index)
    if times is not None and times.late_s:
        first, latest = times.earliest_departure_s, times.latest_arrival_s
        assert latest is not None
        alone_s = plan.trips[journey.index].alone.time_s
        even_alone = first is not None and times.late_s <= first + alone_s - latest + LATE_S
        key = "sheet.late-alone" if even_alone else "sheet.late"
        found.append(say(key, by=late_by(times.late_s), latest=teller.time(latest)))
    longest = _longest_drive_s(journey.steps)
    if longest > BREAK_AFTER_S + MENTIONED_S:
        found.append(say("sheet.no-break", drive=duration(longest)))
    return found


def _longest_drive_s(steps: Sequence[Step]) -> float:
    longest = run = 0.0
    for step in steps:
        run = 0.0 if step.wait_s >= BREAK_S else run
        run += step.way.drive_s if step.way else 0.0
        longest = max(longest, run)
    return longest


def _notes(journey: Journey) -> list[str]:
    vehicle = journey.document.vehicles[journey.index]
    found: list[str] = []
    if vehicle.role == "alone":
        reason = shortened(vehicle.reason, LONGEST_NOTE)
        found.append(say("sheet.alone-for", reason=reason) if reason else say("sheet.alone"))
    if vehicle.inferred_text:
        found.append(say("sheet.inferred", km=vehicle.inferred_text))
    if vehicle.access_m:
        found.append(say("sheet.access"))
    return found


def _facts(journey: Journey) -> Tree:
    teller = Teller(journey.found, journey.index)
    own = journey.found.plan.vehicles[journey.index]
    times = journey.times
    told: list[tuple[str, str]] = []
    if times is not None:
        told.append((say("sheet.departure"), teller.time(times.departure_s)))
        told.append((say("sheet.arrival"), teller.time(times.arrival_s)))
        if times.latest_arrival_s is not None:
            told.append((say("sheet.latest"), teller.time(times.latest_arrival_s)))
    told.append((say("sheet.distance"), kilometres(own.length_m)))
    told.append((say("sheet.driving"), duration(own.time_s)))
    if own.platoon_m:
        told.append((say("sheet.together"), kilometres(own.platoon_m)))
    if times is not None and times.waiting_s >= MENTIONED_S:
        told.append((say("sheet.waits"), duration(times.waiting_s)))
    return tuple(Piece("sheet-fact", {"label": label, "text": text}) for label, text in told)


# -- the steps -------------------------------------------------------------------------------------


def _steps(journey: Journey, layout: Layout) -> Tree:
    if layout.density == CROWDED:
        return _table(journey, layout)
    last = len(journey.steps) - 1
    return Piece(
        "sheet-steps",
        {
            "steps": tuple(
                _step(journey, step, words, number, number == last)
                for number, (step, words) in enumerate(
                    zip(journey.steps, journey.words, strict=True)
                )
            )
        },
    )


def _step(journey: Journey, step: Step, words: StepWords, number: int, is_last: bool) -> Piece:
    following = NOTHING if is_last or not words.way else Piece("sheet-way", {"text": words.way})
    before = journey.steps[number - 1].way if number else None
    return Piece(
        "sheet-step",
        {
            "line": "last" if is_last else _line(step.way),
            "time": words.time or words.km,
            "km": words.km if words.time else "",
            "mark": _mark(journey, words.kind),
            "what": words.what,
            "place": shortened(words.place, LONGEST_HEAD),
            "at": words.at,
            "order": _order(journey, step, before),
            "wait": _said("sheet-wait", words.wait),
            "without": _said("sheet-without", words.without),
            "way": following,
        },
    )


def _said(fragment: str, text: str) -> Tree:
    return Piece(fragment, {"text": text}) if text else NOTHING


def _line(way: Way | None) -> str:
    if way is None or way.is_access:
        return "beside"
    return "together" if way.together else "apart"


def _mark(journey: Journey, kind: str) -> Piece:
    vehicle = journey.document.vehicles[journey.index]
    if kind in ("merge", "separation"):
        return Piece("sheet-icon", {"icon": kind})
    return Piece(
        f"sheet-mark-{kind}",
        {"colour": vehicle.colour, "letter": vehicle.letter, "size": vehicle.letter_size},
    )


def _order(journey: Journey, step: Step, before: Way | None) -> Tree:
    """Return in which order the company drives from here on, if that is news."""
    way = step.way
    if way is None or not way.together or (before is not None and before.order == way.order):
        return NOTHING
    vehicles = journey.document.vehicles
    label = say("sheet.order")
    if len(way.order) > FEW_FACES:
        letters = (
            say("sheet.you-letter", letter=vehicles[k].letter)
            if k == journey.index
            else vehicles[k].letter
            for k in way.order
        )
        return Piece("sheet-order-text", {"label": label, "text": ", ".join(letters)})
    faces = []
    for place, k in enumerate(way.order, 1):
        mine = k == journey.index
        name = say("sheet.you") if mine else shortened(vehicles[k].name, LONGEST_NAME)
        faces.append(
            Piece(
                "sheet-face",
                {
                    "own": " own" if mine else "",
                    "number": str(place),
                    "badge": badge(vehicles[k]),
                    "name": name,
                },
            )
        )
    return Piece("sheet-order", {"label": label, "faces": tuple(faces)})


def _table(journey: Journey, layout: Layout) -> Piece:
    """Return the steps as rows of one line each, for a journey with very many."""
    told, rest = journey.words[: layout.rows], journey.words[layout.rows :]
    if rest:  # The arrival is told in any case.
        told, rest = (*told[:-1], rest[-1]), (told[-1], *rest[:-1])
    timed = journey.times is not None
    rows = tuple(
        Piece(
            "sheet-row",
            {
                "time": words.time,
                "km": words.km,
                "mark": _mark(journey, words.kind),
                "what": words.what,
                "place": shortened(words.place, LONGEST_HEAD),
                "at": words.at,
                "until": words.until,
            },
        )
        for words in told
    )
    more = say("sheet.more-steps", n=len(rest)) if rest else ""
    return Piece(
        "sheet-table",
        {
            "rows": rows,
            "time": say("sheet.col-time") if timed else "",
            "km": say("sheet.col-km"),
            "what": say("sheet.col-what"),
            "place": say("sheet.col-place"),
            "until": say("sheet.col-until") if timed else "",
            "more": _said("sheet-note", more),
        },
    )
