"""Tables of vehicles that must not drive together, or must: CSV with names, a pair or group a row.

A first row that begins with `vehicle` names the columns and counts as none.
"""

from __future__ import annotations

import csv
import io
import os

from ..errors import ScenarioError, brief
from ..planning.scenario.text_file import path_of, read_text

__all__ = ["read_apart", "read_together"]

WHAT = "a table of vehicles apart (CSV)"
GROUPS = "a table of vehicles together (CSV)"
DELIMITERS = ",;\t|"


def read_apart(path: str | os.PathLike[str]) -> tuple[tuple[str, str], ...]:
    """Read which vehicles must not drive together.

    Parameters
    ----------
    path : path-like
        CSV with commas, semicolons, tabs or bars.

    Returns
    -------
    tuple of (str, str)
        For `Limits.apart`.

    Raises
    ------
    ScenarioError
        The file cannot be read, or has a row of other than two names.
    """
    found = []
    for where, names in _rows(path, WHAT):
        if len(names) != 2:
            raise ScenarioError(
                f"{where}: {brief(', '.join(names))} is no pair; give two vehicles a row"
            )
        found.append((names[0], names[1]))
    return tuple(found)


def read_together(path: str | os.PathLike[str]) -> tuple[tuple[str, ...], ...]:
    """Read which vehicles must drive together.

    Parameters
    ----------
    path : path-like
        CSV with commas, semicolons, tabs or bars; a group a row.

    Returns
    -------
    tuple of tuple of str
        For `Limits.together`.

    Raises
    ------
    ScenarioError
        The file cannot be read, or has a row of one name.
    """
    found = []
    for where, names in _rows(path, GROUPS):
        if len(names) < 2:
            raise ScenarioError(
                f"{where}: {brief(names[0])} is no group; give two or more vehicles a row"
            )
        found.append(tuple(names))
    return tuple(found)


def _rows(path: str | os.PathLike[str], what: str) -> list[tuple[str, list[str]]]:
    """Return where each row stands, and its names."""
    file = path_of(path, what)
    text = read_text(file, what, None)
    header = text.partition("\n")[0]
    delimiter = max(DELIMITERS, key=header.count)
    found: list[tuple[str, list[str]]] = []
    reader = csv.reader(io.StringIO(text), delimiter=delimiter)
    try:
        for cells in reader:
            names = [cell.strip() for cell in cells if cell.strip()]
            if not names or (not found and names[0].lower() == "vehicle"):
                continue
            found.append((f"{file.name} line {reader.line_num}", names))
    except csv.Error as error:
        raise ScenarioError(f"{file}: cannot be read ({error}); save it as CSV") from error
    return found
