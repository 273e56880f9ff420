"""Tables as CSV: the same numbers give the same bytes, and no text is run by who opens them.

A spreadsheet runs a cell that begins with an equals sign or its like as a formula. Names are other
people's text, so such a cell gets an apostrophe in front of it. A cell begins at the commas we
write, but where the comma is the decimal sign a file is parted at semicolons, and by choice at tabs
or bars, and quotes inside a line hold nothing together then: what follows such a sign counts as
the beginning of a cell too. So does what stands behind blanks, quotes and characters without
width, which some programs drop.
"""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Iterable, Sequence

from .atomic_file import whole_file
from .shown_text import well_formed

__all__ = ["safe_cell", "write_table"]

PARTS = ";|\t\n\v\f\r\x85\u2028\u2029"
"""What may part cells besides the comma."""

SIGNS = "=+\\-@\uff1d\uff0b\uff0d\uff20\ufe66\ufe62\ufe63\ufe6b"
"""What makes a formula; wide and small forms count in some spreadsheets."""

UNSEEN = (
    '\x00-\x08\x0e-\x20"\x7f-\x84\x86-\xa0\xad\u034f\u061c\u115f\u1160\u1680\u17b4\u17b5'
    "\u180b-\u180f\u2000-\u200f\u202a-\u202f\u205f-\u206f\u2800\u3000\u3164\ufe00-\ufe0f\ufeff"
    "\uffa0\ufff0-\ufffd\U0001d173-\U0001d17a\U000e0000-\U000e0fff"
)
"""Blanks, quotes, controls, and all that has no width or no shape."""

_FORMULA = re.compile(f"^(?=[{PARTS}{UNSEEN}]*[{SIGNS}])|(?<=[{PARTS}])(?=[{UNSEEN}]*[{SIGNS}])")


def safe_cell(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula, however it parts the line.

    Parameters
    ----------
    text : str
        Anybody's.

    Returns
    -------
    str
        The same, with an apostrophe before each place where a formula would begin, and U+FFFD for
        halves of characters, which UTF-8 has no bytes for.
    """
    return _FORMULA.sub("'", well_formed(text))


def write_table(
    path: str | os.PathLike[str],
    header: Sequence[str],
    rows: Iterable[Sequence[object]],
    digits: int,
) -> None:
    """Write a table as CSV in UTF-8, whole or not at all.

    Parameters
    ----------
    path : path-like
        Of the file.
    header : sequence of str
        Names of the columns.
    rows : iterable of sequence
        As many values each as there are columns: texts, numbers, or None for an empty cell.
    digits : int
        Significant ones of numbers that are not whole.

    Raises
    ------
    ScenarioError
        The file cannot be written.
    """

    def cell(value: object) -> object:
        if isinstance(value, float):
            return f"{value:.{digits}g}"
        return safe_cell(value) if isinstance(value, str) else value

    with (
        whole_file(path, suffixes=(".csv",)) as draft,
        draft.open("w", encoding="utf-8", newline="") as handle,
    ):
        writer = csv.writer(handle, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([cell(value) for value in row] for row in rows)
