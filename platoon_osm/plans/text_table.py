"""Tables of plain text: columns stay straight whatever script names are written in."""

from __future__ import annotations

import unicodedata
from collections.abc import Collection, Sequence

from ..shown_text import shown

__all__ = ["MOST_NAMES", "MOST_ROWS", "WIDEST_CELL", "listed", "named", "table_lines", "width_of"]

MOST_ROWS = 12
"""Vehicles that a text tells of one by one."""

MOST_NAMES = 8
"""Names of one company that a text tells."""

WIDEST_CELL = 40
"""Columns of a terminal that a cell may take."""

WIDE = ("W", "F")
"""Letters of Chinese, Japanese and Korean take two columns."""

INVISIBLE = ("Mn", "Me", "Cf")


def width_of(text: str) -> int:
    """Return how many columns of a terminal a text takes.

    Parameters
    ----------
    text : str
        Without control characters.

    Returns
    -------
    int
        Letters of East Asia count twice, marks and joiners not at all.
    """
    return sum(_columns(character) for character in text)


def _columns(character: str) -> int:
    if unicodedata.category(character) in INVISIBLE:
        return 0
    return 2 if unicodedata.east_asian_width(character) in WIDE else 1


def named(name: object, most: int = WIDEST_CELL) -> str:
    """Return somebody's name fit for a line of text.

    Parameters
    ----------
    name : object
        Other people's text.
    most : int
        Columns that it may take.

    Returns
    -------
    str
        On one line, without what moves its neighbours; its beginning if it is long.
    """
    text = shown(name)
    if width_of(text) <= most:
        return text
    kept, taken = [], 1
    for character in text:
        taken += _columns(character)
        if taken > most:
            break
        kept.append(character)
    return "".join(kept).rstrip() + "\u2026"


def listed(names: Sequence[object], most: int = MOST_NAMES) -> str:
    """Return names as a list that can be read: "A, B and C", or "A, B, ... and 499 more".

    Parameters
    ----------
    names : sequence
        Other people's texts.
    most : int
        How many are told.

    Returns
    -------
    str
        All of them, or the first and how many more there are.
    """
    told = [named(name) for name in names[:most]]
    if len(names) > most:
        return f"{', '.join(told)} and {len(names) - most:,} more"
    return " and ".join(filter(None, [", ".join(told[:-1]), *told[-1:]]))


def table_lines(rows: Sequence[Sequence[str]], right: Collection[int]) -> list[str]:
    """Return rows as lines with straight columns, without blanks at their ends.

    Parameters
    ----------
    rows : sequence of sequence of str
        As many cells each, each fit for a line.
    right : collection of int
        Columns that stand to the right.

    Returns
    -------
    list of str
        One line a row.
    """
    widths = [max(map(width_of, column)) for column in zip(*rows, strict=True)]
    lines = []
    for row in rows:
        cells = []
        for place, (text, width) in enumerate(zip(row, widths, strict=True)):
            blank = " " * (width - width_of(text))
            cells.append(blank + text if place in right else text + blank)
        lines.append("  ".join(cells).rstrip())
    return lines
