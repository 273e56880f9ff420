"""What the pages of a plan, of its flows and of several plans have in common."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict

from ..document.model import Document, Figure
from ..document.model_vehicle import CostTexts, Vehicle
from ..markup.fragments import NOTHING, Markup, fill, join

__all__ = [
    "about",
    "badge",
    "costs_of",
    "credit_lines",
    "figures",
    "heading",
    "items",
    "opening",
    "unit_note",
]


def opening(document: Document) -> Markup:
    """Return what stands before the map: icons, and the title that is only printed.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Markup
        The beginning of the body.
    """
    return fill("opening", icons=fill("icons"), title=document.title)


def heading(document: Document) -> Markup:
    """Return title, subtitle and figures.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Markup
        The head of the panel.
    """
    return fill(
        "heading",
        title=document.title,
        subtitle=document.subtitle,
        figures=figures(document.totals.figures),
    )


def figures(found: Iterable[Figure]) -> Markup:
    """Return the large figures at the head of a page.

    Parameters
    ----------
    found : iterable of Figure
        Of the document's sums.

    Returns
    -------
    Markup
        Side by side.
    """
    return join(fill("figure", **asdict(figure)) for figure in found)


def costs_of(text: CostTexts) -> dict[str, str]:
    """Return printed costs as what fragments call them.

    Parameters
    ----------
    text : CostTexts
        Of a vehicle, a group or all.

    Returns
    -------
    dict of str to str
        `alone`, `joint`, `saved` and `share`.
    """
    return {"alone": text.alone, "joint": text.joint, "saved": text.saved, "share": text.share}


def items(texts: Iterable[str]) -> Markup:
    """Return texts as the items of a list.

    Parameters
    ----------
    texts : iterable of str
        Of the document.

    Returns
    -------
    Markup
        One item each.
    """
    return join(fill("item", text=text) for text in texts)


def credit_lines(document: Document) -> Markup:
    """Return the credits that stand on the map.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Markup
        One line each.
    """
    return join(fill("credit", text=text) for text in document.provenance.credits)


def unit_note(document: Document) -> Markup:
    """Return what the unit of the costs means, if that needs saying.

    Parameters
    ----------
    document : Document
        What is shown.

    Returns
    -------
    Markup
        A note, or nothing.
    """
    note = document.cost_unit.note
    return fill("unit-note", note=note) if note else NOTHING


def about(document: Document, rows: Markup, remarks: Markup = NOTHING) -> Markup:
    """Return where a plan comes from.

    Parameters
    ----------
    document : Document
        What is shown.
    rows, remarks : Markup
        What stands between proof and credits.

    Returns
    -------
    Markup
        Proof, rows, remarks and credits.
    """
    provenance = document.provenance
    return fill(
        "about",
        proof=fill("proof", text=provenance.proof) if provenance.proof else NOTHING,
        rows=rows,
        remarks=remarks,
        credit_items=items(provenance.credits),
    )


def badge(vehicle: Vehicle) -> Markup:
    """Return a vehicle's letter in a disc of its colour.

    Parameters
    ----------
    vehicle : Vehicle
        Whose letter it is.

    Returns
    -------
    Markup
        An SVG.
    """
    return fill("badge", colour=vehicle.colour, letter=vehicle.letter, size=vehicle.letter_size)
