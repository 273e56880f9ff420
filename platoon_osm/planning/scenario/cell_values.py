"""What single cells of tables hold: texts, numbers with a comma or a point, yes and no."""

from __future__ import annotations

import re
from datetime import date, datetime, time
from typing import Any

from ...errors import ScenarioError, brief

__all__ = ["number_in", "text_in", "truth_in", "whole_in"]

NUMBER = re.compile(r"[+-]?\d+([.,]\d*)?([eE][+-]?\d+)?")
TRUTHS = {
    **dict.fromkeys(("true", "yes", "1", "x"), True),
    **dict.fromkeys(("false", "no", "0"), False),
}


def text_in(where: str, cell: Any) -> str:
    """Return a cell as the text that its reader sees; 12.0 is shown as 12.

    Parameters
    ----------
    where : str
        The cell, for messages.
    cell : Any
        What the table holds.

    Returns
    -------
    str
        Without blanks around it.

    Raises
    ------
    ScenarioError
        A date, or true and false.
    """
    if isinstance(cell, bool | date | datetime | time):
        raise ScenarioError(
            f"{where} = {cell} is no text; format the column as text in the spreadsheet"
        )
    if isinstance(cell, float) and cell.is_integer():
        cell = int(cell)
    return str(cell).strip()


def number_in(where: str, cell: Any, unit: str) -> float:
    """Return a cell as a number.

    Parameters
    ----------
    where : str
        The cell, for messages.
    cell : Any
        What the table holds; text may have a decimal comma.
    unit : str
        What is counted, for messages: "minutes".

    Returns
    -------
    float
        The number.

    Raises
    ------
    ScenarioError
        It is none.
    """
    if isinstance(cell, int | float) and not isinstance(cell, bool):
        return float(cell)
    text = cell.strip().replace("\u2212", "-") if isinstance(cell, str) else ""
    if not NUMBER.fullmatch(text):
        raise ScenarioError(f"{where} = {brief(cell)} must be a number of {unit}")
    return float(text.replace(",", "."))


def whole_in(where: str, cell: Any) -> int:
    """Return a cell as a whole number.

    Parameters
    ----------
    where : str
        The cell, for messages.
    cell : Any
        What the table holds.

    Returns
    -------
    int
        The number.

    Raises
    ------
    ScenarioError
        It is none.
    """
    if isinstance(cell, str) and re.fullmatch(r"\d{1,19}", cell.strip()):
        return int(cell)
    number = cell if isinstance(cell, int | float) and not isinstance(cell, bool) else 0.5
    if isinstance(number, float) and not number.is_integer():
        raise ScenarioError(f"{where} = {brief(cell)} must be a whole number")
    return int(number)


def truth_in(where: str, cell: Any) -> bool:
    """Return a cell as true or false.

    Parameters
    ----------
    where : str
        The cell, for messages.
    cell : Any
        What the table holds: true or false, yes or no, 1 or 0, or x.

    Returns
    -------
    bool
        Which.

    Raises
    ------
    ScenarioError
        Neither.
    """
    word = str(cell).strip().lower().removesuffix(".0")
    if word not in TRUTHS:
        raise ScenarioError(f"{where} = {brief(cell)} must be true or false")
    return TRUTHS[word]
