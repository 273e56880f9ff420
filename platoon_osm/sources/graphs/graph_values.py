"""Attribute values of OSMnx-style graphs: single values, lists after simplification, or strings."""

from __future__ import annotations

import ast
import math
from numbers import Real
from typing import Any

__all__ = ["flag", "joined", "number", "parts", "tag_text", "whole_number"]


def parts(value: Any) -> list[Any]:
    """Return the values of an attribute, without missing ones; those of a list in sorted order.

    OSMnx's simplification puts the differing values of merged edges into a list, in no stable
    order, and its files keep that list as a string ("['80', '100']").

    Parameters
    ----------
    value : object
        An attribute, as a graph or a file has it.

    Returns
    -------
    list of Any
        Single values.
    """
    if isinstance(value, str) and value[:1] + value[-1:] in {"[]", "{}"}:
        try:
            value = ast.literal_eval(value)
        except (SyntaxError, ValueError, MemoryError, RecursionError):
            return [value]
    if isinstance(value, (list, tuple, set, frozenset)):
        distinct = {str(part): part for item in value for part in parts(item)}
        return [distinct[text] for text in sorted(distinct)]
    if value is None or (isinstance(value, Real) and math.isnan(value)) or value == "":
        return []
    return [value]


def joined(value: Any) -> str:
    """Return a name or road number as text; several are joined by ";" as OpenStreetMap does.

    A plain string comes back as it is, even "None", which is a town with a motorway exit.

    Parameters
    ----------
    value : object
        An attribute, as a graph or a file has it.

    Returns
    -------
    str
        The text.
    """
    # A list in a file holds two strings or more; "[x]" and "[1]" are somebody's names.
    if isinstance(value, str) and not (len(parts(value)) > 1 and "'" in value):
        return value
    return ";".join(str(part) for part in parts(value))


def tag_text(value: Any) -> str:
    """Return a value as OpenStreetMap writes it; a table's or GraphML's way of "missing" as "".

    Parameters
    ----------
    value : object
        A single value.

    Returns
    -------
    str
        The text.
    """
    text = str(value)
    if text in {"True", "False"}:
        return "yes" if text == "True" else "no"
    return "" if text in {"nan", "None", "<NA>"} else text


def number(value: Any) -> float | None:
    """Return a plain number, also from text; the lowest of a list; None if there is none.

    Parameters
    ----------
    value : object
        An attribute, as a graph or a file has it.

    Returns
    -------
    float or None
        The number.
    """
    found = []
    for part in parts(value):
        try:
            found.append(float(part))
        except (TypeError, ValueError):
            return None
    return min((item for item in found if not math.isnan(item)), default=None)


def whole_number(value: Any) -> int | None:
    """Return a whole number of 64 bits, also from text, the lowest of a list; else None.

    Not through `number`: ids above 2**53 would be rounded to another node's.

    Parameters
    ----------
    value : object
        An attribute, as a graph or a file has it.

    Returns
    -------
    int or None
        The number.
    """
    found = []
    for part in parts(value):
        try:
            found.append(int(part))
        except (TypeError, ValueError, OverflowError):
            try:
                found.append(int(float(part)))  # "12.0", as spreadsheets and files write it
            except (TypeError, ValueError, OverflowError):
                return None
    lowest = min(found, default=None)
    return None if lowest is None or not -(2**63) <= lowest < 2**63 else lowest


def flag(value: Any) -> bool:
    """Return whether any of the values says yes.

    Parameters
    ----------
    value : object
        An attribute, as a graph or a file has it.

    Returns
    -------
    bool
        Whether it does.
    """
    return any(str(part).strip().lower() in {"true", "yes", "1", "1.0"} for part in parts(value))
