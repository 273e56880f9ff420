"""The table of plans of the same trips: their sums, and how each differs from one of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from ..document.alike_trips import AlikePlans, Difference, rests_s, under_way_s
from ..document.model import Document
from ..language.speech import number, say
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import (
    MINUS,
    clock_span,
    gain_or_loss,
    kilometres,
    litres,
    signed,
    true_minus,
)

__all__ = ["sums_table"]

NONE = "\u2013"


class _Cell(NamedTuple):
    """A figure, how it differs, and whether that is a gain."""

    text: str
    differs: str = ""
    sign: str = "even"


def sums_table(found: AlikePlans, plans: tuple[Document, ...], key: str) -> Piece:
    """Return the sums of plans of the same trips, a plan a row.

    Parameters
    ----------
    found : AlikePlans
        Which plans, and their differences.
    plans : tuple of Document
        All plans of the page.
    key : str
        Ends the ids, so that several tables stand on one page.

    Returns
    -------
    Piece
        A table; waiting, lateness and the law have columns where there are times, anybody late, or
        driving rules.
    """
    shown = [plans[place] for place in found.plans]
    keys = _keys(shown)
    labels = [say(key) for key in keys]
    rows = []
    for place, plan, difference in zip(found.plans, shown, found.differences, strict=True):
        known = _cells(plan, difference)
        cells = [known[key] for key in keys]
        is_base = place == found.baseline and len(shown) > 1
        rows.append(
            Piece(
                "comparison-row",
                {
                    "title": plan.title,
                    "base": Piece("comparison-base") if is_base else NOTHING,
                    "cells": tuple(map(_piece, cells, labels)),
                },
            )
        )
    against = say("compare.against", title=plans[found.baseline].title)
    return Piece(
        "comparison-sums",
        {
            "key": key,
            "unit": shown[0].cost_unit.label,
            "heads": tuple(Piece("comparison-sum-head", {"title": label}) for label in labels),
            "rows": tuple(rows),
            "against": Piece("item", {"text": against}) if len(shown) > 1 else NOTHING,
        },
    )


def _piece(cell: _Cell, label: str) -> Piece:
    differs: Tree = NOTHING
    if cell.differs:
        differs = Piece("comparison-differs", {"text": cell.differs, "sign": cell.sign})
    return Piece("comparison-cell", {"text": cell.text, "differs": differs, "label": label})


def _keys(plans: Sequence[Document]) -> list[str]:
    """Return the texts of the columns that these plans need."""
    timed = any(plan.schedule is not None for plan in plans)
    late = any(vehicle.is_late for plan in plans for vehicle in plan.vehicles)
    together = any(plan.platoons for plan in plans)
    ruled = any(plan.law is not None for plan in plans)
    return [
        "table.alone", "table.joint", "table.saving", "compare.distance",
        *(["compare.in-platoon"] if together else []),
        "compare.fuel",
        *(["compare.waiting"] if timed else []),
        *(["compare.rests", "compare.under-way", "compare.law"] if ruled else []),
        *(["compare.late"] if late else []),
    ]  # fmt: skip


def _cells(plan: Document, difference: Difference | None) -> dict[str, _Cell]:
    """Return the cells of all columns, by their texts."""
    totals, vehicles, d = plan.totals, plan.vehicles, difference
    late = sum(vehicle.is_late for vehicle in vehicles)
    waiting_s = None if plan.schedule is None else plan.schedule.waiting_s
    length_m = kilometres(sum(vehicle.length_m for vehicle in vehicles))
    fuel_l = litres(sum(vehicle.fuel_l for vehicle in vehicles))
    joint, saving = _Cell(totals.text.joint), _Cell(totals.text.share)
    if d is not None:
        points = say("compare.points", number=signed(number(d.saving * 100, 1)))
        saving = _Cell(totals.text.share, points, gain_or_loss(d.saving))
        if d.cost is not None:
            joint = _Cell(totals.text.joint, _cost(d.cost, plan), gain_or_loss(-d.cost))
    return {
        "table.alone": _Cell(totals.text.alone),
        "table.joint": joint,
        "table.saving": saving,
        "compare.distance": _Cell(length_m, _signed(kilometres(d.length_m)) if d else ""),
        "compare.in-platoon": _Cell(kilometres(totals.platoon_road_m)),
        "compare.fuel": _Cell(fuel_l, _signed(litres(d.fuel_l)) if d else ""),
        "compare.waiting": _time(waiting_s, d.waiting_s if d else None),
        "compare.rests": _time(rests_s(plan), d.rests_s if d else None),
        "compare.under-way": _time(under_way_s(plan), d.under_way_s if d else None),
        "compare.law": _Cell(_law(plan)),
        "compare.late": _Cell(say("compare.late-of", n=late, all=number(len(vehicles)))),
    }


def _law(plan: Document) -> str:
    if plan.law is None:
        return NONE
    kept = not any(clocks.excess for clocks in plan.law.vehicles)
    return say("compare.law-kept" if kept else "compare.law-broken")


def _time(seconds: float | None, differs_s: float | None) -> _Cell:
    if seconds is None:
        return _Cell(NONE)
    return _Cell(clock_span(seconds), "" if differs_s is None else _span(differs_s))


def _cost(cost: float, plan: Document) -> str:
    return signed(number(cost * plan.cost_unit.scale, plan.cost_unit.decimals))


def _signed(text: str) -> str:
    return signed(true_minus(text).replace(MINUS, "-"))


def _span(seconds: float) -> str:
    text = clock_span(abs(seconds))
    return signed(f"-{text}" if seconds < 0 else text)
