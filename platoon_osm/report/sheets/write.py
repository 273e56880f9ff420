"""Drivers' sheets as files: one page a vehicle, in one file or one each, with a calendar each."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path

from ...atomic_file import all_or_none, whole_file
from ...errors import ScenarioError, brief
from ...kinds import is_number
from ...network.road_network import RoadNetwork
from ...output_paths import PAGES, checked_folder
from ...plans.plan import Plan
from ...shown_text import fitted
from ..document.checks import check_path, check_title
from ..document.document import document_of
from ..document.findings import Findings, find
from ..document.halts import halts_of
from ..document.model import Document
from ..exports.file_names import file_stems
from ..exports.geopackage import changed_at
from ..language.speech import say, speaking
from ..maps.background import Background
from ..maps.pause_icons import pause_icons
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.still_page import still_page
from .calendar import calendar
from .sheet import Journey, sheet
from .steps import steps_of
from .words import Teller

__all__ = ["write_sheets"]

STYLES = ("sheets.css",)
CALENDARS = (".ics",)


def write_sheets(
    plan: Plan,
    net: RoadNetwork,
    where: str | os.PathLike[str],
    *,
    title: str | None = None,
    patience_min: float | None = None,
    language: str | None = None,
    clock: int | None = None,
) -> list[Path]:
    """Write a sheet for each driver: when, where, whom to meet, and what to do if they do not come.

    Each sheet is one printed page of A4, with the journey as a strip, its steps in order, and a
    map of the vehicle's own route. A path that ends in `.html` becomes one file with all sheets;
    any other is a folder, which is made, and gets a sheet for each vehicle and, if the plan has
    times, a calendar (`.ics`). Files are named as the vehicles are; all appear, or none. Sheets
    have no script and ask for nothing from outside.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network it was made on.
    where : path-like
        A file ending in `.html`, or a folder.
    title : str or None
        Heads the browser's window; by default made from the first vehicle's journey.
    patience_min : float or None
        How long after the planned moment drivers wait for one another at most [min]. By default
        they wait as long as they still arrive in time; a vehicle without a latest arrival, as long
        as the patience goes that it was planned with. One whose plan knows none is told to ask.
    language : str or None
        Of all texts, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

    Returns
    -------
    list of Path
        What was written.

    Raises
    ------
    ScenarioError
        A plan of another network, a patience that is no number of minutes, an unknown language, or
        a place that cannot be written to.
    """
    path = check_path(where)
    check_title(title)
    if patience_min is not None and not (is_number(patience_min) and 0 <= patience_min < 1e6):
        raise ScenarioError(
            f"sheets: patience_min {brief(patience_min)} must be minutes, 0 or more, or none"
        )
    with speaking(language, clock):
        found = find(plan, net)
        document = document_of(plan, net, title=title)
        journeys = list(_journeys(found, document, patience_min))
        if path.suffix.lower() not in PAGES:
            checked_folder(path)
        with all_or_none():
            if path.suffix.lower() in PAGES:
                return [_written_page(path, document.title, journeys)]
            return _written_folder(path, document.title, journeys)


def _journeys(found: Findings, document: Document, patience_min: float | None) -> Iterator[Journey]:
    patience_s = None if patience_min is None else patience_min * 60.0
    halts = halts_of(found.plan, found.net)
    background = Background(document.basemap.known)
    for index, own in enumerate(halts):
        steps = steps_of(found.plan, found.net, index, patience_s, own)
        teller = Teller(found, index)
        words = tuple(teller.words(step, number) for number, step in enumerate(steps))
        yield Journey(found, document, index, steps, words, background)


def _written_page(path: Path, heading: str, journeys: Sequence[Journey]) -> Path:
    text = _page(say("sheet.title", title=heading), journeys)
    with whole_file(path, suffixes=PAGES) as draft:
        draft.write_text(text, encoding="utf-8", newline="\n")
    return path


def _written_folder(folder: Path, heading: str, journeys: Sequence[Journey]) -> list[Path]:
    plan = journeys[0].found.plan
    stems = file_stems([vehicle.vehicle for vehicle in plan.vehicles])
    stamp = _stamp(journeys[0].found)
    written: list[Path] = []
    for journey, stem in zip(journeys, stems, strict=True):
        name = fitted(plan.trips[journey.index].vehicle)
        text = _page(say("sheet.title", title=f"{name}, {heading}"), [journey])
        page = folder / f"{stem}.html"
        with whole_file(page, suffixes=PAGES) as draft:
            draft.write_text(text, encoding="utf-8", newline="\n")
        written.append(page)
        if journey.times is None:
            continue
        made = calendar(
            plan, journey.index, journey.steps, journey.words,
            journey.document.provenance.credits, stamp,
        )  # fmt: skip
        with whole_file(folder / f"{stem}.ics", suffixes=CALENDARS) as draft:
            draft.write_bytes(made)
        written.append(folder / f"{stem}.ics")
    return written


def _stamp(found: Findings) -> datetime:
    return changed_at(found.plan.network.extracted or found.net.source.extracted).astimezone(UTC)


def _page(title: str, journeys: Sequence[Journey]) -> str:
    body = Piece(
        "sheets",
        {
            "icons": Piece("icons", {"more": pause_icons([journeys[0].document])}),
            "contents": _contents(journeys) if len(journeys) > 1 else NOTHING,
            "sheets": tuple(map(sheet, journeys)),
        },
    )
    return still_page(title, body, STYLES)


def _contents(journeys: Sequence[Journey]) -> Tree:
    """Return links to all sheets, for the screen."""
    return Piece(
        "sheet-contents",
        {
            "label": say("sheet.contents"),
            "items": tuple(
                Piece(
                    "sheet-link",
                    {
                        "key": str(one.index + 1),
                        "text": Teller(one.found, one.index).name(one.index),
                    },
                )
                for one in journeys
            ),
        },
    )
