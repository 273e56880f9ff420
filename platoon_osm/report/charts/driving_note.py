"""Who drives beyond 4 h 30 without a break, as a list: plans set no breaks yet."""

from __future__ import annotations

from ...plans.clock import duration
from ..document.model import Document
from ..document.model_day import LongDrive
from ..drawing.crowd import MOST_SPOKEN
from ..language.speech import clock_time, say
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import kilometres
from .axes import letter_type

__all__ = ["driving_note"]


def driving_note(document: Document) -> Tree:
    """Return who drives too long, how long, and where a break falls due.

    Parameters
    ----------
    document : Document
        Whose drivers are meant.

    Returns
    -------
    Tree
        A list; nothing if nobody does.
    """
    drives = document.long_drives
    if not drives:
        return NOTHING
    rows = tuple(_row(document, drive) for drive in drives[:MOST_SPOKEN])
    more = len(drives) - MOST_SPOKEN
    return Piece(
        "driving",
        {
            "rows": rows,
            "note": say("driving.note" if document.platoons else "driving.note-alone"),
            "more": Piece("driving-more", {"text": say("driving.more", n=more)})
            if more > 0
            else NOTHING,
        },
    )


def _row(document: Document, drive: LongDrive) -> Piece:
    vehicle = document.vehicles[drive.vehicle]
    fields = {
        "length": kilometres(drive.at_m),
        "origin": vehicle.origin.brief,
        "place": drive.place,
    }
    where = say("driving.near" if drive.place else "driving.after", **fields)
    parts = [say("driving.drives", time=duration(drive.drive_s)), where]
    if drive.at_s is not None and document.schedule is not None:
        parts.insert(1, say("driving.due", time=clock_time(document.schedule.clock, drive.at_s)))
    return Piece(
        "driving-row",
        {
            "index": drive.vehicle,
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": letter_type(vehicle.letter),
            "text": ", ".join(parts),
        },
    )
