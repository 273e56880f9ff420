"""Rows under a header: which column each cell belongs to, whatever kind of file they come from."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from ...errors import ScenarioError, brief
from .cells import COLUMNS, MAIN_COLUMNS, PARTS, column_named, is_blank
from .keys import PLACES, hint

__all__ = ["Row", "rows_under"]


@dataclass(frozen=True, slots=True)
class Row:
    """One row of a table.

    Attributes
    ----------
    where : str
        For messages: "trips.csv line 3".
    cells : dict
        By column, blank ones left out.
    fault : str
        Why the row cannot be read; empty if it can.
    """

    where: str
    cells: dict[str, Any]
    fault: str = ""


def rows_under(
    header: Sequence[Any], lines: Iterable[tuple[str, Sequence[Any]]], where: str
) -> list[Row]:
    """Give every cell its column; rows that are blank are no rows.

    Parameters
    ----------
    header : sequence
        Titles of the columns, in any case and with blanks.
    lines : iterable of (str, sequence)
        What each row is called in messages, and its cells; an error stands for a cell that cannot
        be read.
    where : str
        What the header is called: "trips.csv line 1".

    Returns
    -------
    list of Row
        In their order.

    Raises
    ------
    ScenarioError
        A column that is unknown, missing or there twice.
    """
    if broken := next((cell for cell in header if isinstance(cell, ScenarioError)), None):
        raise broken
    columns = [column_named(title) for title in header]
    _check(columns, header, where)
    rows = []
    for name, cells in lines:
        if all(is_blank(cell) for cell in cells):
            continue
        pairs = list(zip(columns, cells, strict=False))
        kept = {key: cell for key, cell in pairs if key and not is_blank(cell)}
        rows.append(Row(name, kept, _fault(name, columns, cells)))
    return rows


def _fault(name: str, columns: Sequence[str], cells: Sequence[Any]) -> str:
    """Return why a row cannot be read; empty if it can."""
    for cell in cells:
        if isinstance(cell, ScenarioError):
            return str(cell)
    for column, cell in zip(columns, cells, strict=False):
        if not column and not is_blank(cell):
            return f"{name}: {brief(cell)} stands in a column without a title"
    if any(not is_blank(cell) for cell in cells[len(columns) :]):
        return (
            f"{name} has {len(cells)} cells, the header {len(columns)}; a cell that holds the "
            "delimiter, as a pair of coordinates may, stands in double quotes"
        )
    return ""


def _check(columns: Sequence[str], header: Sequence[Any], where: str) -> None:
    named = [column for column in columns if column]
    if not set(named) & set(COLUMNS):
        raise ScenarioError(
            f"{where} is no header ({brief(', '.join(str(title) for title in header if title))}); "
            f"the first line names the columns, at least vehicle, {', '.join(PLACES)}"
        )
    for column, title in zip(columns, header, strict=True):
        if column and column not in COLUMNS:
            remedy = hint(column, COLUMNS, MAIN_COLUMNS)
            raise ScenarioError(f"{where}: unknown column {brief(title)}; {remedy}")
        if column and columns.count(column) > 1:
            raise ScenarioError(f"{where}: column {column!r} stands there twice; keep one")
    for key in ("vehicle", *PLACES):
        parts = {key} if key == "vehicle" else {key, *(f"{key}_{part}" for part in PARTS[:3])}
        if not parts & set(named):
            raise ScenarioError(f"{where}: has no column {key}; add it")
