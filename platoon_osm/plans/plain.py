"""Records as plain JSON types: what `json` would read back from what it writes of them."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from operator import attrgetter
from typing import Any

__all__ = ["plain"]

_ASIS = frozenset((bool, float, int, type(None)))
"""Types that JSON has."""

_FIELDS: dict[type, tuple[tuple[str, ...], Callable[[Any], Any]]] = {}
"""Names of the fields of each kind of record, and what reads them."""


def plain(value: Any) -> Any:
    """Return a record, or a container of records, as dictionaries, lists, texts and numbers.

    This is `json.loads(json.dumps(dataclasses.asdict(value)))` without the detour, which takes
    most of the time that a plan of thousands of vehicles needs to be written.

    Parameters
    ----------
    value : object
        Dataclasses, mappings, tuples, lists and what JSON has.

    Returns
    -------
    object
        Of JSON's types alone; nothing of it is shared with the record.

    Raises
    ------
    TypeError
        Something that JSON has no type for.
    """
    kind = type(value)
    if kind in _ASIS:
        return value
    if kind is str:
        # Two halves of a character become one on the way through JSON.
        return value if value.isascii() else json.loads(json.dumps(value))
    if kind is tuple or kind is list:
        return list(value) if _ASIS.issuperset(map(type, value)) else [plain(one) for one in value]
    if kind is dict and all(type(key) is str and key.isascii() for key in value):
        return {key: plain(one) for key, one in value.items()}
    if kind not in _FIELDS and is_dataclass(kind):
        names = tuple(one.name for one in fields(kind))
        _FIELDS[kind] = names, attrgetter(*names, "__class__")
    if kind in _FIELDS:
        names, values = _FIELDS[kind]
        return dict(zip(names, map(plain, values(value)[:-1]), strict=True))
    if isinstance(value, dict):
        value = {key: plain(one) for key, one in value.items()}
    elif isinstance(value, tuple | list):
        value = [plain(one) for one in value]
    return json.loads(json.dumps(value))
