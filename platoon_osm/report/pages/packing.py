"""Records of one kind as columns, each value that repeats itself said once.

A plan of 500 vehicles says the name of each field 500 times, and a few values of many fields again
and again. A page holds its document so, with the marks below, and its script (assets/unpacked.js)
puts it back as it was.

    {"=": {name: column, ...}}          records of the same fields
    {"*": value, "n": count}            a column of one value
    {"|": [value, ...], "i": [k, ...]}  a column of few values: positions among them
    {"#": [size, ...], "of": column}    a column of arrays, one behind another
"""

from __future__ import annotations

import json
from typing import Any

__all__ = ["packed"]


def packed(value: Any) -> Any:
    """Return plain JSON types written shorter.

    Parameters
    ----------
    value : dict, list, str, float, int, bool or None
        What `json.dumps` writes; no field has the name of a mark.

    Returns
    -------
    dict, list, str, float, int, bool or None
        What the script of the page makes the same of.
    """
    if isinstance(value, dict):
        return {name: packed(item) for name, item in value.items()}
    if isinstance(value, list):
        return _records(value) if _alike(value) else [packed(item) for item in value]
    # A whole number says as much without its point and zero.
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _alike(items: list[Any]) -> bool:
    """Return whether all are records of the same fields."""
    return len(items) > 1 and all(
        isinstance(item, dict) and item and item.keys() == items[0].keys() for item in items
    )


def _records(items: list[dict[str, Any]]) -> dict[str, Any]:
    return {"=": {name: _column([item[name] for item in items]) for name in items[0]}}


def _column(values: list[Any]) -> Any:
    if _alike(values):
        return _records(values)
    kinds = {_text(value): value for value in values}
    if len(kinds) == 1:
        return {"*": packed(values[0]), "n": len(values)}
    plain = [packed(value) for value in values]
    found: list[Any] = [plain]
    if all(isinstance(value, list) for value in values):
        every = [item for value in values for item in value]
        found.append({"#": _column([len(value) for value in values]), "of": _column(every)})
    places = {text: place for place, text in enumerate(kinds)}
    found.append(
        {"|": [packed(value) for value in kinds.values()], "i": [places[_text(v)] for v in values]}
    )
    return min(found, key=lambda form: len(_text(form)))


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))
