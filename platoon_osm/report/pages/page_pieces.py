"""What the pages of a plan, of its flows and of several plans have in common."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict

from ..document.model import Document, Figure, Status
from ..document.model_vehicle import CostTexts, Vehicle
from ..language.speech import say
from ..maps.pause_icons import pause_icons
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import gain_or_loss

__all__ = [
    "about",
    "badge",
    "costs_of",
    "credit_lines",
    "figures",
    "heading",
    "items",
    "late_mark",
    "opening",
    "status_lines",
    "unit_note",
]


def opening(document: Document) -> Piece:
    """Return what stands before the map: icons, and the title that is only printed.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Piece
        The beginning of the body.
    """
    return Piece(
        "opening",
        {"icons": Piece("icons", {"more": pause_icons([document])}), "title": document.title},
    )


def heading(document: Document) -> Piece:
    """Return title, subtitle, what a reader should know first, and figures.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Piece
        The head of the panel.
    """
    return Piece(
        "heading",
        {
            "title": document.title,
            "subtitle": document.subtitle,
            "status": status_lines(document.status),
            "figures": figures(document.totals.figures),
        },
    )


def status_lines(found: Iterable[Status]) -> Tree:
    """Return what a reader should know of a plan first.

    Parameters
    ----------
    found : iterable of Status
        Of the document.

    Returns
    -------
    Tree
        A line each.
    """
    return tuple(Piece("status", {**asdict(one)}) for one in found)


def late_mark(vehicle: Vehicle) -> Tree:
    """Return by how much a vehicle is late.

    Parameters
    ----------
    vehicle : Vehicle
        Of the document.

    Returns
    -------
    Tree
        In a few words; nothing if it is in time.
    """
    if not vehicle.is_late:
        return NOTHING
    return Piece("late-by", {"text": say("script.mark-late", time=vehicle.day.text.late)})


def figures(found: Iterable[Figure]) -> Tree:
    """Return the large figures at the head of a page.

    Parameters
    ----------
    found : iterable of Figure
        Of the document's sums.

    Returns
    -------
    Tree
        Side by side.
    """
    return tuple(Piece("figure", {**asdict(figure)}) for figure in found)


def costs_of(text: CostTexts, saved: float, late: bool = False) -> dict[str, str]:
    """Return printed costs as what fragments call them.

    Parameters
    ----------
    text : CostTexts
        Of a vehicle, a group or all.
    saved : float
        What they save, which gives it its colour.
    late : bool
        Whether it is no success, as somebody is late for it.

    Returns
    -------
    dict of str to str
        `sign`, `alone`, `joint`, `saved` and `share`.
    """
    return {
        "sign": "even" if late and saved > 0 else gain_or_loss(saved),
        "alone": text.alone,
        "joint": text.joint,
        "saved": text.saved,
        "share": text.share,
    }


def items(texts: Iterable[str]) -> Tree:
    """Return texts as the items of a list.

    Parameters
    ----------
    texts : iterable of str
        Of the document.

    Returns
    -------
    Tree
        One item each.
    """
    return tuple(Piece("item", {"text": text}) for text in texts)


def credit_lines(document: Document) -> Tree:
    """Return the credits that stand on the map.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Tree
        One line each.
    """
    return tuple(Piece("credit", {"text": text}) for text in document.provenance.credits)


def unit_note(document: Document) -> Tree:
    """Return what the unit of the costs means, if that needs saying.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Tree
        A note, or nothing.
    """
    note = document.cost_unit.note
    return Piece("unit-note", {"note": note}) if note else NOTHING


def about(document: Document, rows: Tree, remarks: Sequence[str] = ()) -> Piece:
    """Return where a plan comes from.

    Parameters
    ----------
    document : Document
        What is shown.
    rows : Tree
        What stands after the proof.
    remarks : sequence of str
        What stands before the credits.

    Returns
    -------
    Piece
        Proof, rows, remarks and credits.
    """
    provenance = document.provenance
    proof: Tree = NOTHING
    if provenance.proof:
        # The cheapest of plans is no success if somebody is late.
        late = any(vehicle.is_late for vehicle in document.vehicles)
        proof = Piece("proof", {"text": provenance.proof, "kind": "plain" if late else "good"})
    return Piece(
        "about",
        {
            "proof": proof,
            "rows": rows,
            "remarks": Piece("remarks", {"items": items(remarks)}) if remarks else NOTHING,
            "credit_items": items(provenance.credits),
        },
    )


def badge(vehicle: Vehicle) -> Piece:
    """Return a vehicle's letter in a disc of its colour.

    Parameters
    ----------
    vehicle : Vehicle
        Whose letter it is.

    Returns
    -------
    Piece
        An SVG.
    """
    return Piece(
        "badge", {"colour": vehicle.colour, "letter": vehicle.letter, "size": vehicle.letter_size}
    )
