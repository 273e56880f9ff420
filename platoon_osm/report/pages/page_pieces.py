"""What the pages of a plan, of its flows and of several plans have in common."""

from __future__ import annotations

from typing import Any

from ..drawing.vehicle_styles import letter_size
from ..markup.fragments import NOTHING, Markup, fill, join

__all__ = ["about", "badge", "credit_lines", "heading", "opening", "unit_note"]


def opening(document: dict[str, Any]) -> Markup:
    """Return what stands before the map: icons, and the title that is only printed."""
    return fill("opening", icons=fill("icons"), title=document["title"])


def heading(document: dict[str, Any]) -> Markup:
    """Return title, subtitle and figures."""
    return fill(
        "heading",
        title=document["title"],
        subtitle=document["subtitle"],
        figures=join(fill("figure", **figure) for figure in document["totals"]["figures"]),
    )


def credit_lines(document: dict[str, Any]) -> Markup:
    """Return the credits that stand on the map."""
    return join(fill("credit", text=text) for text in document["provenance"]["credits"])


def unit_note(document: dict[str, Any]) -> Markup:
    """Return what the unit of the costs means, if that needs saying."""
    note = document["cost_unit"]["note"]
    return fill("unit-note", note=note) if note else NOTHING


def about(document: dict[str, Any], rows: Markup, remarks: Markup = NOTHING) -> Markup:
    """Return proof, the given rows and remarks, and credits."""
    provenance = document["provenance"]
    return fill(
        "about",
        proof=fill("proof", text=provenance["proof"]) if provenance["proof"] else NOTHING,
        rows=rows,
        remarks=remarks,
        credit_items=join(fill("item", text=text) for text in provenance["credits"]),
    )


def badge(vehicle: dict[str, Any]) -> Markup:
    """Return a vehicle's letter in a disc of its colour."""
    letter = vehicle["letter"]
    return fill("badge", colour=vehicle["colour"], letter=letter, size=letter_size(letter))
