"""Tables as text: with commas, semicolons as European spreadsheets write them, tabs or bars."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from pathlib import Path

from ...errors import ScenarioError
from .cells import COLUMNS, column_named
from .rows import Row, rows_under
from .text_file import read_text

__all__ = ["read_csv"]

DELIMITERS = (",", ";", "\t", "|")


def read_csv(file: Path, content: bytes | None) -> list[Row]:
    """Read a table of text; the delimiter is the one that makes most sense of the header.

    Parameters
    ----------
    file : Path
        The file.
    content : bytes or None
        What it holds, if that was read before.

    Returns
    -------
    list of Row
        Its rows.

    Raises
    ------
    ScenarioError
        It cannot be read, has no header, or a quotation that does not end.
    """
    text = read_text(file, "a table of trips (CSV)", content)
    first = 1
    told = text.partition("\n")[0].strip().strip('"')
    delimiter = None
    if told.lower().startswith("sep=") and len(told) == 5:
        # Excel's own line, which says what separates cells.
        delimiter, text, first = told[4], text.partition("\n")[2], 2
    lines = _lines(file, text, delimiter or _delimiter(text), first)
    number, header = next(lines, (first, []))
    if not header:
        raise ScenarioError(f"{file}: has no rows under its header; it is empty")
    named = ((f"{file.name} line {at}", cells) for at, cells in lines)
    return rows_under(header, named, f"{file.name} line {number}")


def _delimiter(text: str) -> str:
    header = next((line for line in text.split("\n") if line.strip()), "")

    def sense(delimiter: str) -> tuple[int, int]:
        titles = [column_named(title) for title in header.split(delimiter)]
        return sum(title in COLUMNS for title in titles), len(titles)

    return max(DELIMITERS, key=sense)


def _lines(file: Path, text: str, delimiter: str, first: int) -> Iterator[tuple[int, list[str]]]:
    """Yield rows that have cells, each with the line on which it begins."""
    # Strict, so that a quotation which swallows the rest of the file is told.
    reader = csv.reader(io.StringIO(text), delimiter=delimiter, strict=True)
    begin = first
    while True:
        try:
            cells = next(reader)
        except StopIteration:
            return
        except csv.Error as error:
            raise ScenarioError(
                f"{file.name} line {begin}: cannot be read ({error}); close its quotation marks"
            ) from error
        if cells:
            yield begin, cells
        begin = first + reader.line_num
