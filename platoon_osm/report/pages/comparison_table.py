"""The table of plans of the same trips: their sums, and how each differs from one of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..document.alike_trips import AlikePlans, Difference
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
        A table; waiting and lateness have a column where there is any time, or anybody late.
    """
    shown = [plans[place] for place in found.plans]
    timed = any(plan.schedule is not None for plan in shown)
    late = any(vehicle.is_late for plan in shown for vehicle in plan.vehicles)
    together = any(plan.platoons for plan in shown)
    keys = ["table.alone", "table.joint", "table.saving", "compare.distance"]
    keys += ["compare.in-platoon"] * together + ["compare.fuel"]
    keys += ["compare.waiting"] * timed + ["compare.late"] * late
    labels = [say(key) for key in keys]
    rows = []
    for place, plan, difference in zip(found.plans, shown, found.differences, strict=True):
        wanted = (True, True, True, True, together, True, timed, late)
        cells = [
            cell
            for cell, is_shown in zip(_cells(plan, difference), wanted, strict=True)
            if is_shown
        ]
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


def _cells(plan: Document, difference: Difference | None) -> Iterator[_Cell]:
    totals, vehicles = plan.totals, plan.vehicles
    length_m = sum(vehicle.length_m for vehicle in vehicles)
    fuel_l = sum(vehicle.fuel_l for vehicle in vehicles)
    late = sum(vehicle.is_late for vehicle in vehicles)
    waiting_s = None if plan.schedule is None else plan.schedule.waiting_s
    waiting = "\u2013" if waiting_s is None else clock_span(waiting_s)
    platoon = kilometres(totals.platoon_road_m)
    of_all = say("compare.late-of", n=late, all=number(len(vehicles)))
    if difference is None:
        yield _Cell(totals.text.alone)
        yield _Cell(totals.text.joint)
        yield _Cell(totals.text.share)
        yield _Cell(kilometres(length_m))
        yield _Cell(platoon)
        yield _Cell(litres(fuel_l))
        yield _Cell(waiting)
        yield _Cell(of_all)
        return
    yield _Cell(totals.text.alone)
    cost = difference.cost
    yield _Cell(
        totals.text.joint,
        "" if cost is None else _cost(cost, plan),
        "even" if cost is None else gain_or_loss(-cost),
    )
    points = signed(number(difference.saving * 100, 1))
    yield _Cell(
        totals.text.share, say("compare.points", number=points), gain_or_loss(difference.saving)
    )
    yield _Cell(kilometres(length_m), _signed(kilometres(difference.length_m)))
    yield _Cell(platoon)
    yield _Cell(litres(fuel_l), _signed(litres(difference.fuel_l)))
    yield _Cell(waiting, "" if difference.waiting_s is None else _span(difference.waiting_s))
    yield _Cell(of_all)


def _cost(cost: float, plan: Document) -> str:
    return signed(number(cost * plan.cost_unit.scale, plan.cost_unit.decimals))


def _signed(text: str) -> str:
    return signed(true_minus(text).replace(MINUS, "-"))


def _span(seconds: float) -> str:
    text = clock_span(abs(seconds))
    return signed(f"-{text}" if seconds < 0 else text)
