"""The one border where records become plain JSON types.

A record becomes an object with its fields in their order, a tuple an array, a line its short text;
texts and None stay what they are, numbers keep nine digits. A field marked as not meant for readers
is left out, and one marked so if it is None.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any

from ..drawing.lines import Line, Lines

__all__ = ["as_json"]


def as_json(value: object) -> Any:
    """Return a record, or anything in one, as plain JSON types.

    Parameters
    ----------
    value : object
        A record of a document, a tuple of such, a line, a number, a text or None.

    Returns
    -------
    dict, list, str, float, int, bool or None
        What `json.dumps` writes.
    """
    if isinstance(value, Line | Lines):
        return value.encoded()
    if is_dataclass(value):
        return {
            one.name: as_json(getattr(value, one.name))
            for one in fields(value)
            if one.metadata.get("json", True)
            and not (one.metadata.get("if there") and getattr(value, one.name) is None)
        }
    if isinstance(value, dict):
        return {name: as_json(item) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return [as_json(item) for item in value]
    # Beyond them is but the last digits of sums; degrees have six behind the point.
    return float(f"{value:.9g}") if isinstance(value, float) else value
