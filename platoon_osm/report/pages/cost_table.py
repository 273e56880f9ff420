"""Tables of costs: vehicles one a row and their sum, or groups."""

from __future__ import annotations

from collections.abc import Sequence

from ..document.model import Document, Group
from ..document.model_vehicle import CostTexts
from ..drawing.crowd import CROWD
from ..markup.fragments import NOTHING, Piece, Tree
from .page_pieces import badge, costs_of, late_mark

__all__ = ["cost_table", "overview", "wide_sums"]

MOST_LETTERS = 25
"""Letters of three sums that leave room for a vehicle beside them on a phone."""


def cost_table(
    document: Document, members: Sequence[int], total: str, text: CostTexts, label: str
) -> Piece:
    """Return the costs of some vehicles, one a row, and their sum.

    Parameters
    ----------
    document : Document
        Whose vehicles they are.
    members : sequence of int
        Their positions.
    total : str
        Heads the sum.
    text : CostTexts
        The sum.
    label : str
        What the table is called.

    Returns
    -------
    Piece
        A table; that of a crowd is narrow and scrolls.
    """
    vehicles = [document.vehicles[index] for index in members]
    # Where nobody drives in company, what it costs alone is what it costs.
    cells, table = ("costs-cells", "table") if document.platoons else ("cost-cell", "table-alone")
    rows = []
    for index, vehicle in zip(members, vehicles, strict=True):
        facts = f"{vehicle.role_text}, {vehicle.length_text}"
        if vehicle.times is not None:
            clock = vehicle.times.text
            facts = f"{clock.departure}\u2060\u2013\u2060{clock.arrival}, {facts}"
        rows.append(
            Piece(
                "table-row",
                {
                    "index": index,
                    "badge": badge(vehicle),
                    "name": Piece("vehicle-name", {"name": vehicle.name})
                    if vehicle.name
                    else NOTHING,
                    "origin": vehicle.origin.brief,
                    "destination": vehicle.destination.brief,
                    "facts": facts,
                    "late": late_mark(vehicle),
                    "costs": Piece(cells, costs_of(vehicle.text, vehicle.saved, vehicle.is_late)),
                },
            )
        )
    return Piece(
        table,
        {
            "rows": tuple(rows),
            "total": total,
            "label": label,
            "density": (" compact" if len(rows) > CROWD else "") + wide_sums(text),
            **costs_of(
                text,
                sum(vehicle.saved for vehicle in vehicles),
                any(vehicle.is_late for vehicle in vehicles),
            ),
        },
    )


def _is_late(document: Document, group: Group) -> bool:
    return any(document.vehicles[index].is_late for index in group.vehicles)


def wide_sums(text: CostTexts) -> str:
    """Return the class of a table whose sums are so long that they stand below their vehicle.

    Parameters
    ----------
    text : CostTexts
        The sum of all.

    Returns
    -------
    str
        Empty where they fit beside it.
    """
    letters = len(text.alone) + len(text.joint) + len(text.saved)
    return " wide-sums" if letters > MOST_LETTERS else ""


def overview(document: Document) -> Tree:
    """Return the costs of all groups, one a row.

    Parameters
    ----------
    document : Document
        Whose groups they are.

    Returns
    -------
    Tree
        Rows of a table.
    """
    return tuple(
        Piece(
            "overview-row",
            {
                "number": number,
                "name": group.name,
                "facts": group.facts,
                **costs_of(group.text, group.saved, _is_late(document, group)),
            },
        )
        for number, group in enumerate(document.groups)
    )
