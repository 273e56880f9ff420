"""A table of vehicles that must not drive together: CSV of two columns of names.

A first row that begins with `vehicle` names the columns and counts as none.
"""

from __future__ import annotations

import csv
import io
import os

from ..errors import ScenarioError, brief
from ..planning.scenario.text_file import path_of, read_text

__all__ = ["read_apart"]

WHAT = "a table of vehicles apart (CSV)"
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
    file = path_of(path, WHAT)
    text = read_text(file, WHAT, None)
    header = text.partition("\n")[0]
    delimiter = max(DELIMITERS, key=header.count)
    found: list[tuple[str, str]] = []
    reader = csv.reader(io.StringIO(text), delimiter=delimiter)
    try:
        for cells in reader:
            names = [cell.strip() for cell in cells if cell.strip()]
            if not names or (not found and names[0].lower() == "vehicle"):
                continue
            if len(names) != 2:
                raise ScenarioError(
                    f"{file.name} line {reader.line_num}: {brief(', '.join(names))} is no pair; "
                    "give two vehicles a row"
                )
            found.append((names[0], names[1]))
    except csv.Error as error:
        raise ScenarioError(f"{file}: cannot be read ({error}); save it as CSV") from error
    return tuple(found)
