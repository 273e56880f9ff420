"""The page's static HTML from a document: figures, tables, charts, lists, legend."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ...plans.curves import DelayFrontier, DepartureCurve
from ..charts.along_chart import along_chart
from ..charts.driving_note import driving_note
from ..charts.fatigue_chart import fatigue_chart
from ..charts.law_chart import law_chart
from ..charts.schedule_chart import schedule_chart
from ..charts.time_distance_chart import time_distance_chart
from ..charts.time_worth import time_worth
from ..charts.waiting_bars import waiting_bars
from ..document.model import Document, Group
from ..document.model_vehicle import CostTexts, Vehicle
from ..drawing.crowd import CROWD
from ..language.speech import say
from ..maps.pause_icons import NOUNS
from ..maps.static_map import static_map
from ..markup.fragments import NOTHING, Piece, Tree
from .cost_bars import cost_bars
from .cost_table import cost_table, overview, wide_sums
from .legend import legend
from .money_tables import money_tables
from .page_pieces import about, badge, costs_of, credit_lines, heading, opening, unit_note

__all__ = ["page_body"]

OPEN_UP_TO = 12
"""Vehicles in a plan all of whose groups are open from the start."""


def page_body(
    document: Document,
    live_map: Tree,
    languages: Tree = NOTHING,
    curve: DepartureCurve | None = None,
    frontier: DelayFrontier | None = None,
) -> Piece:
    """Return all that stands in the page's body but its scripts.

    Parameters
    ----------
    document : Document
        What is shown.
    live_map : Tree
        The element that the script draws in.
    languages : Tree
        Links to the page in other languages.
    curve : DepartureCurve or None
        What is saved by when the master leaves.
    frontier : DelayFrontier or None
        What is saved by how late all may arrive.

    Returns
    -------
    Piece
        Map, legend and panel.
    """
    provenance = document.provenance
    return Piece(
        "body",
        {
            "opening": opening(document),
            "live_map": live_map,
            "static_map": static_map(document),
            "legend": legend(document),
            "credits": credit_lines(document),
            "heading": heading(document),
            "languages": languages,
            "journey": _journey(document),
            "vehicles": _vehicles(document),
            "fatigue": (
                *money_tables(document),
                law_chart(document),
                fatigue_chart(document),
                driving_note(document),
                time_worth(curve, frontier),
            ),
            "notes": _notes(document),
            "about": about(
                document,
                tuple(_about_row(label, text) for label, text in provenance.rows),
                provenance.remarks,
            ),
        },
    )


def _journey(document: Document) -> Tree:
    if (schedule := document.schedule) is not None:
        minutes = (schedule.end_s - schedule.begin_s) / 60
        return Piece("journey-by-clock", {"minutes": f"{minutes:.3f}"})
    scale = document.journey
    return NOTHING if scale is None else Piece("journey", {"km": f"{scale.length_m / 1000:.4f}"})


def _vehicles(document: Document) -> Piece:
    """Return table, bars, way and events: at once for one small group, else group by group."""
    groups, every = document.groups, range(len(document.vehicles))
    unit, note, totals = document.cost_unit.label, unit_note(document), document.totals
    unit_heading = say("page.unit-heading" if document.platoons else "page.cost-heading")
    if len(every) <= CROWD and sum(group.is_platoon for group in groups) <= 1:
        parts = _parts(document, every, (say("table.all"), totals.text, say("table.costs")))
        return Piece(
            "one-group", {"unit_heading": unit_heading, "unit": unit, "unit_note": note, **parts}
        )
    return Piece(
        "groups",
        {
            "unit_heading": unit_heading,
            "unit": unit,
            "unit_note": note,
            "overview": overview(document),
            "wide": wide_sums(totals.text),
            "density": " compact" if len(groups) > CROWD else "",
            "groups": tuple(_group(document, number, group) for number, group in enumerate(groups)),
            **costs_of(
                totals.text,
                totals.solo_cost - totals.joint_cost,
                any(vehicle.is_late for vehicle in document.vehicles),
            ),
        },
    )


def _group(document: Document, number: int, group: Group) -> Piece:
    members, key = group.vehicles, f"-{number}"
    together = group.is_platoon
    # A few groups are open from the start; of many, the first shows what the others hold.
    is_open = number == 0 or (len(document.vehicles) <= OPEN_UP_TO and together)
    table = say("table.together"), group.text, say("table.costs-of", group=group.name)
    return Piece(
        "group",
        {
            "open": Piece("group-open") if is_open else NOTHING,
            "name": group.name,
            "facts": group.facts,
            **_parts(document, members, table, key, together),
        },
    )


def _parts(
    document: Document,
    members: Sequence[int],
    table: tuple[str, CostTexts, str],
    key: str = "",
    together: bool = True,
) -> dict[str, Tree]:
    """Return what is told of vehicles that belong together; bars and way not of those alone."""
    bars: Tree = NOTHING
    if together:
        bars = (cost_bars(document, members, key), waiting_bars(document, members, key))
    return {
        "table": cost_table(document, members, *table),
        "day": (
            schedule_chart(document, members, key),
            time_distance_chart(document, members, key),
        ),
        "bars": bars,
        "along": _way(document, members, key) if together else NOTHING,
        "events": (_events(document, members, key), _leads(document, members, key)),
    }


def _way(document: Document, members: Sequence[int], key: str = "") -> Tree:
    """Return the way by distance; where there are times the schedule takes its place."""
    return NOTHING if document.schedule is not None else along_chart(document, members, key)


def _about_row(label: str, text: str) -> Piece:
    if label == "sha256" and re.fullmatch("[0-9a-fA-F]{64}", text):
        return Piece(
            "about-hash", {"label": label, "text": text, "short": text[:8], "end": text[-4:]}
        )
    return Piece("about-row", {"label": label, "text": text})


def _events(document: Document, members: Sequence[int], key: str = "") -> Tree:
    here = frozenset(members)
    found = [
        Piece(
            "event",
            {
                "index": index,
                "vehicles": " ".join(map(str, (*event.vehicles, *event.others))),
                "number": index + 1,
                "kind": say(NOUNS[event.kind][0]),
                "icon": event.kind,
                "name": event.name,
                "text": event.text,
                "detail": event.detail,
            },
        )
        for index, event in enumerate(document.events)
        if event.concerns(here)
    ]
    stands = any(event.stands for event in document.events)
    heading = say("events.with-pauses" if stands else "events.heading")
    if all(event.stands for event in document.events):
        heading = say("events.pauses")
    return (
        Piece("events", {"key": key, "heading": heading, "items": tuple(found)})
        if found
        else (NOTHING)
    )


def _leads(document: Document, members: Sequence[int], key: str = "") -> Tree:
    """Return who leads from where on, where the lead is handed on."""
    found = tuple(
        Piece(
            "lead",
            {
                "badge": badge(document.vehicles[one.vehicle]),
                "name": one.name,
                "text": one.text,
                "detail": one.detail,
            },
        )
        for one in document.leads
        if one.vehicle in members
    )
    return Piece("leads", {"key": key, "items": found}) if found else NOTHING


def _notes(document: Document) -> Tree:
    # Those of one reason share a note.
    alike: dict[tuple[bool, str], list[Vehicle]] = {}
    for vehicle in document.vehicles:
        alone = vehicle.role == "alone"
        if alone or vehicle.reason:
            alike.setdefault((alone, vehicle.reason), []).append(vehicle)
    notes: list[Piece] = []
    for (alone, reason), vehicles in alike.items():
        lead = ", ".join(vehicle.letter for vehicle in vehicles)
        if alone:
            lead = say("note.stays-alone", n=len(vehicles), who=lead)
        lead += ":" if reason else "."
        face = badge(vehicles[0]) if len(vehicles) == 1 else NOTHING
        notes.append(Piece("note-vehicle", {"badge": face, "lead": lead, "text": reason}))
    ways = [vehicle for vehicle in document.vehicles if vehicle.access_text]
    if ways:
        text = say("note.access")
        listed = "; ".join(f"{vehicle.letter} {vehicle.access_text}" for vehicle in ways)
        notes.append(Piece("note-access", {"text": text, "listed": listed}))
    guessed = [vehicle for vehicle in document.vehicles if vehicle.inferred_text]
    if guessed:
        listed = ", ".join(f"{v.letter} {v.inferred_text}" for v in guessed)
        text = say("note.inferred", listed=listed)
        notes.append(Piece("note-inferred", {"text": text}))
    return Piece("notes", {"items": tuple(notes)}) if notes else NOTHING
