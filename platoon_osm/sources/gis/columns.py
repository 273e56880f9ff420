"""Tags in the columns of a table: each in its own, or all of them in one text.

Three forms are about. Tools that convert OpenStreetMap give common tags a column each and put the
rest into one text, `other_tags`, as hstore: `"maxheight"=>"3.8","hgv"=>"no"`; others keep all tags
as JSON or as a map in a column `tags`; and Geofabrik's shapefiles call the class `fclass` and tell
the direction by F, T and B. Some write an underscore where a key has a colon.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping
from functools import cache
from itertools import chain, product
from typing import Any

from ..restricting_tags import ALONE
from ..slopes import INCLINE_TAGS
from ..speeds.of_road import KIND_KEYS
from ..stops.features import is_stop_tag
from ..truck import is_driving_tag

__all__ = ["IDS", "holds_roads", "id_of", "tags_of"]

TOGETHER = ("other_tags", "tags", "all_tags", "hstore")
CLASS = ("highway", "fclass")
NAMES = INCLINE_TAGS | {
    "name", "ref", "destination", "place", "population", "ele", "route", "duration"
}  # fmt: skip
ONE_WAY = {"F": "yes", "T": "-1", "B": "no"}
IDS = ("osm_id", "osm_way_id", "osmid", "@id", "full_id")
"""Columns that hold an id of OpenStreetMap, the surest first."""

MOST_PARTS = 5
KNOWN = ALONE | KIND_KEYS | NAMES
"""Keys that are read as they are, whatever others begin like them."""

PAIR = re.compile(r'"((?:[^"\\]|\\.)*)"\s*=>\s*(?:"((?:[^"\\]|\\.)*)"|NULL)', re.DOTALL)
ESCAPED = re.compile(r"\\(.)", re.DOTALL)
NUMBER = re.compile(r"(?:[nwr]|(?:node|way|relation)/)?(-?\d{1,18})(?:\.0)?$")


def holds_roads(names: Iterable[str]) -> bool:
    """Tell whether a table with these columns may hold roads.

    Parameters
    ----------
    names : iterable of str
        Of its columns.

    Returns
    -------
    bool
        By a column for the class of a road, or for all tags.
    """
    return not {name.lower() for name in names}.isdisjoint({*CLASS, *TOGETHER})


def id_of(row: Mapping[str, Any]) -> int:
    """Return the OpenStreetMap id of a row.

    Parameters
    ----------
    row : mapping of str to object
        Column to value.

    Returns
    -------
    int
        0 if it has none.
    """
    for name in IDS:
        found = NUMBER.match(_text(row.get(name)))
        if found:
            return int(found.group(1))
    return 0


def tags_of(row: Mapping[str, Any]) -> dict[str, str]:
    """Return the tags of a row, those that this package may read.

    Parameters
    ----------
    row : mapping of str to object
        Column, in lower case, to value.

    Returns
    -------
    dict of str to str
        Those in a column of their own win over those in a common one.
    """
    tags: dict[str, str] = {}
    for name in TOGETHER:
        tags |= _common(row.get(name))
    for name, value in row.items():
        text = _text(value)
        if text and name not in TOGETHER:
            tags[_key(name)] = text
    if "fclass" in row:
        tags.setdefault("highway", _text(row["fclass"]))
        tags["oneway"] = ONE_WAY.get(tags.get("oneway", ""), tags.get("oneway", ""))
        # There 0 says that nothing is known, and 1 and 0 are true and false.
        if tags.get("maxspeed") == "0":
            del tags["maxspeed"]
    return {key: value for key, value in tags.items() if value and _is_read(key)}


def _is_read(key: str) -> bool:
    return key in NAMES or key in ("barrier", "locked") or is_driving_tag(key) or is_stop_tag(key)


@cache
def _key(name: str) -> str:
    """Return the key that a column is named after, where it was written without its colons."""
    parts = name.split("_")
    if len(parts) > MOST_PARTS:
        return name
    # A key may hold both signs: hazmat:adr_tunnel_cat.
    keys = [
        "".join(chain.from_iterable(zip(parts, (*signs, ""), strict=True)))
        for signs in product(":_", repeat=len(parts) - 1)
    ]
    known = [key for key in keys if key in KNOWN] or [key for key in keys if _is_read(key)]
    return known[0] if known else name


def _common(value: Any) -> dict[str, str]:
    """Read all tags in one value: a mapping, pairs, JSON or hstore."""
    if isinstance(value, str):
        if not value.lstrip().startswith("{"):
            return {
                ESCAPED.sub(r"\1", key): ESCAPED.sub(r"\1", text)
                for key, text in PAIR.findall(value)
            }
        try:
            value = json.loads(value)
        except ValueError:
            return {}
    if isinstance(value, Mapping):
        return {str(key): _text(item) for key, item in value.items()}
    if value is None or isinstance(value, float):
        return {}
    try:
        return {str(key): _text(item) for key, item in value}
    except (TypeError, ValueError):
        return {}


def _plain(text: str) -> str:
    """Return a text of hstore without its backslashes."""
    return ESCAPED.sub(r"\1", text)


def _text(value: Any) -> str:
    """Return a value as a tag has it; empty if there is none."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    if isinstance(value, bool) or type(value).__name__ == "bool_":
        return "yes" if value else "no"
    if isinstance(value, float) and value == int(value):
        return str(int(value))
    text = str(value).strip()
    return "" if text in ("<NA>", "NaT", "None") else text
