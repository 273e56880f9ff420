"""What vehicles pay for what, who gets what is saved, and where all figures are from, as tables.

All amounts are whole cents and printed as such, so rows, columns and sums add up as printed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ...plans.bill import Bill
from ...plans.gain import GainSharing
from ..document.bill_parts import term_name
from ..document.model import Document
from ..document.wording import joined
from ..drawing.crowd import CROWD
from ..language.speech import number, say
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import cost_unit, gain_or_loss, signed, true_minus
from .page_pieces import badge

__all__ = ["money_tables"]

RULES = {"equal": "gain.equal", "shapley": "gain.shapley", "least-core": "gain.least-core"}

MANNERS = {"planned anew": "gain.anew", "on the planned roads": "gain.on-roads"}

DIGITS = 6
"""Of a figure of a bill, at most."""


def money_tables(document: Document) -> tuple[Piece, ...]:
    """Return the sections of a plan in money.

    Parameters
    ----------
    document : Document
        Of a plan.

    Returns
    -------
    tuple of Piece
        None where costs are no money.
    """
    bill, gain = document.bill, document.gain
    parts: list[Piece] = []
    if bill is not None:
        parts.append(_bill(document, bill))
    if gain is not None:
        parts.append(_gain(document, gain))
    return tuple(parts)


def _amount(cents: int) -> str:
    return true_minus(number(cents / 100, 2))


def _bill(document: Document, bill: Bill) -> Piece:
    paid = [k for k, term in enumerate(bill.terms) if any(bill.of_term(term))]
    unpaid = [term_name(term) for k, term in enumerate(bill.terms) if k not in paid]
    together = bool(document.platoons)
    notes = [say("money.note")] if together else []
    if unpaid:
        notes.append(say("money.nothing", terms=", ".join(unpaid)))
    rows = [
        _row(document, index, _amounts(one.joint_cents, one.alone_cents, paid, together))
        for index, one in enumerate(bill.vehicles)
    ]
    alone, joint = (
        [bill.of_term(term)[planned] for term in bill.terms] for planned in (False, True)
    )
    heads = [*(term_name(bill.terms[k]) for k in paid), say("money.all")]
    return Piece(
        "money-bill",
        {
            "heading": say("money.heading", unit=_unit(bill.currency)),
            "table": _table(heads, rows, _amounts(joint, alone, paid, together), "h-bill"),
            "note": " ".join(notes),
            "emissions": _emissions(document, bill, together),
            "figures": _figures(bill),
        },
    )


def _unit(currency: str) -> str:
    return cost_unit(currency).label


def _amounts(joint: Sequence[int], alone: Sequence[int], paid: list[int], both: bool) -> Tree:
    pairs = [*((joint[k], alone[k]) for k in paid), (sum(joint), sum(alone))]
    return tuple(_pair(_amount(now), _amount(before) if both else "") for now, before in pairs)


def _pair(now: str, before: str) -> Piece:
    small = Piece("money-small", {"text": before}) if before else NOTHING
    return Piece("money-cell", {"text": now, "small": small})


def _emissions(document: Document, bill: Bill, together: bool) -> Piece:
    rows, sums = [], [0.0] * 6
    for index, one in enumerate(bill.vehicles):
        values = [
            one.joint_fuel_l, one.alone_fuel_l,
            one.joint_kg[1], one.alone_kg[1], one.joint_kg[0], one.alone_kg[0],
        ]  # fmt: skip
        sums = [before + value for before, value in zip(sums, values, strict=True)]
        rows.append(_row(document, index, _physical(values, together)))
    heads = [say("money.litres"), say("money.well"), say("money.wheel")]
    return Piece(
        "money-emissions",
        {"table": _table(heads, rows, _physical(sums, together), "h-emissions")},
    )


def _physical(values: Sequence[float], both: bool) -> Tree:
    return tuple(
        _pair(number(values[k], 1), number(values[k + 1], 1) if both else "") for k in (0, 2, 4)
    )


def _table(heads: Iterable[str], rows: Sequence[Piece], total: Tree, label: str) -> Piece:
    return Piece(
        "money-table",
        {
            "label": label,
            "density": " compact" if len(rows) > CROWD else "",
            "heads": tuple(Piece("money-head", {"text": text}) for text in heads),
            "rows": tuple(rows),
            "total": total,
        },
    )


def _row(document: Document, index: int, cells: Tree) -> Piece:
    vehicle = document.vehicles[index]
    return Piece(
        "money-row",
        {"index": index, "badge": badge(vehicle), "name": vehicle.called, "cells": cells},
    )


def _gain(document: Document, gain: GainSharing) -> Piece:
    rows = []
    for index, one in enumerate(gain.vehicles):
        cells = (
            _signed(one.saved_cents),
            _signed(one.payment_cents),
            _strong(one.share_cents),
        )
        rows.append(_row(document, index, cells))
    saved = sum(one.saved_cents for one in gain.vehicles)
    paid = sum(one.payment_cents for one in gain.vehicles)
    heads = [say("gain.saves"), say("gain.pays"), say("gain.has")]
    rule = say(RULES[gain.rule]) if gain.rule in RULES else say("gain.rule", rule=gain.rule)
    total = (_signed(saved), _signed(paid), _strong(gain.gain_cents))
    fine = gain.nobody_is_worse_off and (gain.worst_cents is None or gain.worst_cents < 1)
    return Piece(
        "money-gain",
        {
            "heading": say("gain.heading", unit=_unit(gain.currency)),
            "table": _table(heads, rows, total, "h-gain"),
            "rule": rule,
            "kind": "good" if fine else "plain",
            "proof": _proof(document, gain),
            "remark": Piece("money-note", {"text": gain.remark}) if gain.remark else NOTHING,
        },
    )


def _signed(cents: int) -> Piece:
    return _pair(signed(number(cents / 100, 2)), "")


def _strong(cents: int) -> Piece:
    text = signed(number(cents / 100, 2))
    return Piece("money-strong", {"text": text, "sign": gain_or_loss(cents)})


def _proof(document: Document, gain: GainSharing) -> str:
    """Return whether everybody can say yes, in a sentence."""
    worse = [
        vehicle.letter
        for vehicle, one in zip(document.vehicles, gain.vehicles, strict=True)
        if one.share_cents < 0
    ]
    parts = [say("gain.worse", who=joined(worse)) if worse else say("gain.none-worse")]
    worst = gain.worst_cents
    if worst is not None:
        if worst >= 1:
            cost = cost_unit(gain.currency, to_the_cent=True).full(worst / 100)
            told = say("gain.better", cost=cost)
        elif worst > 0:
            told = say("gain.by-a-cent")
        elif gain.coalitions:
            told = say("gain.none-better", n=gain.coalitions)
        else:
            told = say("gain.none-better-at-all")
        if gain.manner:
            manner = MANNERS.get(gain.manner)
            told += f" ({say(manner) if manner else gain.manner})"
        parts.append(told)
    return f"{'; '.join(parts)}."


def _figures(bill: Bill) -> Tree:
    """Return all figures of a bill with their sources, folded."""
    rows = tuple(
        Piece(
            "money-figure",
            {
                "name": one.name,
                "value": _plain(one.value),
                "unit": one.unit,
                "source": one.source,
            },
        )
        for one in bill.figures
    )
    return Piece("money-figures", {"rows": rows}) if rows else NOTHING


def _plain(value: float) -> str:
    """Return a figure with as many decimals as it needs."""
    short = f"{value:.{DIGITS}g}"
    if "e" in short or "n" in short:
        return true_minus(short)
    return true_minus(number(value, len(short.partition(".")[2])))
