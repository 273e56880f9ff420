"""One driver's sheet as a piece of a page: its head, the strip, the steps, the map."""

from __future__ import annotations

import re

from ...shown_text import fitted, shortened
from ..language.speech import day_and_date, say, zone_text
from ..maps.pause_icons import PAUSE_KINDS
from ..markup.fragments import NOTHING, Piece, Tree
from ..pages.page_pieces import badge
from .head import Journey, alerts_of, counted_of, facts_of, notes_of, saved_of
from .layout import CROWDED, MAP_WIDTH_MM, Layout, layout_of, lines_of
from .route_map import own_document, route_map
from .steps import Step, Way
from .strip import strip
from .words import StepWords

__all__ = ["Journey", "sheet"]

LONGEST_HEAD = 90
LONGEST_NAME = 26

FEW_FACES = 8
"""Vehicles that are drawn in the order of driving; of more, their letters are listed."""

LATER_DAY = re.compile(r"([+-]\d+) ")
"""Of a time of another day; its number stays with its unit."""

MAP_PX = 720.0
"""Width of a map in its own pixels."""

HEAD_MM = 62.0
"""Heading, facts, strip and credits of a sheet that has one line of each."""


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
    alerts, notes = alerts_of(journey), notes_of(journey)
    told = [text for text in (counted_of(journey), saved_of(journey)) if text]
    lines = [*alerts, *notes, *told]
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
            "facts": facts_of(journey),
            "law": tuple(Piece("sheet-law", {"text": text}) for text in told),
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
    return Piece("sheet-figure", {"map": route_map(own, key, (MAP_PX, height), journey.background)})


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
            "time": LATER_DAY.sub("\\1\u00a0", words.time) or words.km,
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
    if kind in ("merge", "separation", *PAUSE_KINDS):
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
