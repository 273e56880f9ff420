"""The tables of plans of the same trips: their sums, and how each differs from one of them.

One is of costs and ways, the other of the day: rules, breaks and rests, waits, hours, who is late.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from ...shown_text import fitted
from ..document.alike_trips import AlikePlans, Difference
from ..document.model import Document
from ..document.side_sums import SideSums
from ..language.speech import late_by, number, say
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import (
    MINUS,
    clock_span,
    gain_or_loss,
    kilometres,
    litres,
    percent,
    signed,
    true_minus,
)

__all__ = ["day_table", "sums_table"]

NONE = "\u2013"
"""Where there is nothing to tell."""

RULES = {"eu561": "compare.rules-eu561", "us395": "compare.rules-us395"}
LAW = {
    "late": "compare.law-late",
    "leaves late": "compare.law-held",
    "beyond": "compare.law-beyond",
}


class _Cell(NamedTuple):
    """A figure, how it differs, and whether that, or the figure itself, is a gain."""

    text: str
    differs: str = ""
    sign: str = "even"


@dataclass(frozen=True, slots=True)
class _Row:
    """A plan, what it is set against others by, and how it differs; None where that is unknown."""

    plan: Document
    sums: SideSums | None
    gap: float | None
    differs: Difference | None


class _Column(NamedTuple):
    """What a column is called, and what it holds of a plan."""

    key: str
    cell: Callable[[_Row], _Cell]


def sums_table(found: AlikePlans, plans: tuple[Document, ...], key: str) -> Piece:
    """Return costs, ways and proof of plans of the same trips, a plan a row.

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
        A table; the road in platoon has a column where there is any.
    """
    rows = _rows(found, plans)
    columns = [
        _Column("table.alone", lambda row: _Cell(row.plan.totals.text.alone)),
        _Column("table.joint", _joint),
        _Column("table.saving", _saving),
        _Column("compare.distance", _distance),
    ]
    if any(row.plan.platoons for row in rows):
        columns.append(
            _Column(
                "compare.in-platoon",
                lambda row: _Cell(kilometres(row.plan.totals.platoon_road_m)),
            )
        )
    columns += [_Column("compare.fuel", _fuel), _Column("compare.proved", _proved)]
    notes = [say("compare.proved-note")] if any(row.gap is not None for row in rows) else []
    if len(rows) > 1:
        notes.insert(0, say("compare.against", title=plans[found.baseline].title))
    heading = say("compare.costs-of-all"), rows[0].plan.cost_unit.label
    return _table(found, rows, columns, f"costs{key}", heading, notes)


def day_table(found: AlikePlans, plans: tuple[Document, ...], key: str) -> Tree:
    """Return rules, breaks, waits and hours of plans of the same trips, a plan a row.

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
    Tree
        A table; rules have columns where a plan has any, and lateness where anybody is late.
        Nothing without times.
    """
    rows = _rows(found, plans)
    sums = [row.sums for row in rows if row.sums is not None]
    if not sums:
        return NOTHING
    columns = []
    if any(one.rules for one in sums):
        columns.append(_Column("compare.rules", _rules))
    if any(one.law for one in sums):
        columns += [
            _Column("compare.law", _law),
            _Column("compare.breaks", _breaks),
            _Column("compare.rests", _rests),
        ]
    columns += [_Column("compare.waiting", _waiting), _Column("compare.under-way", _hours)]
    if any(vehicle.is_late for row in rows for vehicle in row.plan.vehicles):
        columns.append(_Column("compare.late", _late))
    return _table(found, rows, columns, f"day{key}", (say("compare.day"), ""), ())


def _rows(found: AlikePlans, plans: tuple[Document, ...]) -> list[_Row]:
    parts = zip(found.plans, found.sums, found.gaps, found.differences, strict=True)
    return [_Row(plans[place], sums, gap, differs) for place, sums, gap, differs in parts]


def _table(
    found: AlikePlans,
    rows: Sequence[_Row],
    columns: Sequence[_Column],
    key: str,
    heading: tuple[str, str],
    notes: Sequence[str],
) -> Piece:
    labels = [say(column.key) for column in columns]
    base = [place == found.baseline and len(rows) > 1 for place in found.plans]
    return Piece(
        "comparison-sums",
        {
            "key": key,
            "heading": heading[0],
            "unit": heading[1],
            "heads": tuple(Piece("comparison-sum-head", {"title": label}) for label in labels),
            "rows": tuple(
                Piece(
                    "comparison-row",
                    {
                        "title": row.plan.title,
                        "base": Piece("comparison-base") if is_base else NOTHING,
                        "cells": tuple(
                            _piece(column.cell(row), label)
                            for column, label in zip(columns, labels, strict=True)
                        ),
                    },
                )
                for row, is_base in zip(rows, base, strict=True)
            ),
            "notes": tuple(Piece("item", {"text": note}) for note in notes),
        },
    )


def _piece(cell: _Cell, label: str) -> Piece:
    differs: Tree = NOTHING
    if cell.differs:
        differs = Piece("comparison-differs", {"text": cell.differs, "sign": cell.sign})
    return Piece("comparison-cell", {"text": cell.text, "differs": differs, "label": label})


def _joint(row: _Row) -> _Cell:
    text = row.plan.totals.text.joint
    if row.differs is None or (cost := row.differs.cost) is None:
        return _Cell(text)
    unit = row.plan.cost_unit
    return _Cell(text, signed(number(cost * unit.scale, unit.decimals)), gain_or_loss(-cost))


def _saving(row: _Row) -> _Cell:
    text = row.plan.totals.text.share
    if row.differs is None:
        return _Cell(text)
    points = signed(number(row.differs.saving * 100, 1))
    return _Cell(text, say("compare.points", number=points), gain_or_loss(row.differs.saving))


def _distance(row: _Row) -> _Cell:
    text = kilometres(sum(vehicle.length_m for vehicle in row.plan.vehicles))
    return _Cell(text, _signed(kilometres(row.differs.length_m)) if row.differs else "")


def _fuel(row: _Row) -> _Cell:
    text = litres(sum(vehicle.fuel_l for vehicle in row.plan.vehicles))
    return _Cell(text, _signed(litres(row.differs.fuel_l)) if row.differs else "")


def _proved(row: _Row) -> _Cell:
    if row.gap is None:
        return _Cell(NONE)
    return _Cell(
        say("compare.within", share=percent(row.gap)) if row.gap else say("compare.optimal")
    )


def _rules(row: _Row) -> _Cell:
    rules = row.sums.rules if row.sums else ""
    return _Cell(say(RULES[rules]) if rules in RULES else fitted(rules) or NONE)


def _law(row: _Row) -> _Cell:
    if row.sums is None or not row.sums.law:
        return _Cell(NONE)
    if row.sums.law == "kept":
        return _Cell(say("compare.law-kept"))
    verdict = "compare.law-broken" if row.sums.law == "beyond" else "compare.law-not"
    return _Cell(say(verdict), say(LAW[row.sums.law], time=late_by(row.sums.by_s)), "loss")


def _breaks(row: _Row) -> _Cell:
    if row.sums is None:
        return _Cell(NONE)
    return _often(row.sums.breaks, row.sums.breaks_s, row.differs.breaks_s if row.differs else None)


def _rests(row: _Row) -> _Cell:
    if row.sums is None:
        return _Cell(NONE)
    return _often(row.sums.rests, row.sums.rests_s, row.differs.rests_s if row.differs else None)


def _waiting(row: _Row) -> _Cell:
    if row.plan.schedule is None:
        return _Cell(NONE)
    return _span(row.plan.schedule.waiting_s, row.differs.waiting_s if row.differs else None)


def _hours(row: _Row) -> _Cell:
    if row.sums is None:
        return _Cell(NONE)
    return _span(row.sums.under_way_s, row.differs.under_way_s if row.differs else None)


def _late(row: _Row) -> _Cell:
    late = sum(vehicle.is_late for vehicle in row.plan.vehicles)
    return _Cell(say("compare.late-of", n=late, all=number(len(row.plan.vehicles))))


def _often(times: int, seconds: float, differs_s: float | None) -> _Cell:
    """Return how often vehicles pause, and how long in all."""
    cell = _span(seconds, differs_s)
    return cell._replace(text=f"{number(times)} \u00b7 {cell.text}" if times else number(times))


def _span(seconds: float, differs_s: float | None) -> _Cell:
    if differs_s is None:
        return _Cell(clock_span(seconds))
    text = clock_span(abs(differs_s))
    return _Cell(clock_span(seconds), signed(f"-{text}" if differs_s < 0 else text))


def _signed(text: str) -> str:
    return signed(true_minus(text).replace(MINUS, "-"))
