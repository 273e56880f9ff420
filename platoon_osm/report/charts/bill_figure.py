"""A figure of a plan's bill for papers: what is paid for what, alone and as planned, and saved.

A row a vehicle, and one for all where they are too many. Left, terms one behind another: above,
pale, alone, below as planned. Right, what is saved of each term; what is lost lies left of zero.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...shown_text import shortened
from ..document.bill_parts import term_name
from ..document.model import Document
from ..drawing.palette import MUTED, TERMS
from ..language.speech import number, say
from ..markup.quantities import cost_unit
from .paper import WIDTH_IN

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch

__all__ = ["bill_figure"]

MOST_ROWS = 24

PALE = 0.45

Amounts = tuple[int, ...]


def bill_figure(document: Document) -> Figure | None:
    """Return a plan's bill as a figure.

    Parameters
    ----------
    document : Document
        Of the plan.

    Returns
    -------
    Figure or None
        None where costs are no money.
    """
    from matplotlib.figure import Figure
    from matplotlib.ticker import FuncFormatter

    bill = document.bill
    if bill is None:
        return None
    rows: list[tuple[str, Amounts, Amounts]] = [
        (
            f"{vehicle.letter}  {shortened(vehicle.origin.brief, 14)} \u2013 "
            f"{shortened(vehicle.destination.brief, 14)}",
            own.alone_cents,
            own.joint_cents,
        )
        for vehicle, own in zip(document.vehicles, bill.vehicles, strict=True)
    ]
    if len(rows) > MOST_ROWS:
        alone, joint = (
            tuple(bill.of_term(term)[planned] for term in bill.terms) for planned in (0, 1)
        )
        rows = [(say("table.all"), alone, joint)]
    unit = cost_unit(bill.currency).label
    shown = [place for place, term in enumerate(bill.terms) if any(bill.of_term(term))]
    figure = Figure(figsize=(WIDTH_IN, 1.35 + 0.46 * len(rows)), layout="constrained")
    costs, saved = figure.subplots(1, 2, sharey=True, width_ratios=(3, 2))
    colours = [TERMS.get(term, MUTED) for term in bill.terms]
    for row, (_, alone, joint) in enumerate(rows):
        _stack(costs, row - 0.2, alone, colours, PALE)
        _stack(costs, row + 0.2, joint, colours, 1.0)
        less = tuple(one - other for one, other in zip(alone, joint, strict=True))
        _stack(saved, row, less, colours, 1.0)
        right = sum(cents for cents in less if cents > 0) / 100
        saved.annotate(
            number(sum(less) / 100, 2).replace("-", "\u2212"),
            (right, row),
            (4, 0),
            textcoords="offset points",
            va="center",
            fontsize=7,
        )
    costs.set_yticks(range(len(rows)), [name for name, _, _ in rows])
    costs.set_ylim(len(rows) - 0.45, -0.55)
    costs.set_xlabel(say("figures.bill", unit=unit))
    saved.set_xlabel(say("figures.bill-saved", unit=unit))
    saved.axvline(0, color=MUTED, linewidth=0.6)
    most, least = (
        max(
            sum(max(sign * (one - other), 0) for one, other in zip(a, j, strict=True))
            for _, a, j in rows
        )
        / 100
        for sign in (1, -1)
    )
    # Room for the figures behind the bars.
    saved.set_xlim(-1.04 * least, most + 0.24 * ((most + least) or 1.0))
    for axes in (costs, saved):
        axes.xaxis.set_major_formatter(
            FuncFormatter(lambda value, _: number(value, 0 if value == int(value) else 1))
        )
    handles = [_patch(colours[place]) for place in shown]
    names = [term_name(bill.terms[place]) for place in shown]
    figure.legend(
        handles, names, loc="outside upper center", ncols=len(shown) or 1, frameon=False, fontsize=7
    )
    return figure


def _patch(colour: str) -> Patch:
    from matplotlib.patches import Patch

    return Patch(color=colour)


def _stack(axes: Axes, y: float, cents: Amounts, colours: list[str], alpha: float) -> None:
    """Draw amounts one behind another, losses to the left."""
    right = left = 0.0
    for amount, colour in zip(cents, colours, strict=True):
        width = amount / 100
        start = right if width >= 0 else left
        axes.barh(y, width, 0.36, left=start, color=colour, alpha=alpha, linewidth=0)
        right, left = (right + width, left) if width >= 0 else (right, left + width)
