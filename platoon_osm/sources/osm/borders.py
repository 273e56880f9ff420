"""Borders of countries and states that the map itself has, more exact than the bundled outlines.

A boundary relation counts where its lines make rings: an extract that cuts a border open leaves
that country to the outlines. Of a state only the code counts that a table of laws knows.

Source: https://wiki.openstreetmap.org/wiki/Tag:boundary=administrative, Key:ISO3166-1.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..country.law import laws

__all__ = ["BORDER", "Border", "borders_of", "code_of", "within_borders"]

BORDER = ("type", "boundary")
COUNTRY, STATE = "2", "4"
COUNTRY_KEYS = ("ISO3166-1:alpha2", "ISO3166-1", "country_code_iso3166_1_alpha_2")
COUNTRY_CODE = re.compile("[A-Z]{2}")

Floats = NDArray[np.float64]
Relation = tuple[int, str, tuple[tuple[str, int, str], ...]]


class Border(NamedTuple):
    """Code of a country or state, and the area within its border, a shapely geometry."""

    code: str
    area: Any


def code_of(tags: Any) -> str:
    """Return the code of a country or state that a relation bounds.

    Parameters
    ----------
    tags : mapping of str to str
        Of the relation.

    Returns
    -------
    str
        "IT", "US-CA"; empty if it bounds none.
    """
    if tags.get("type") != BORDER[1] or tags.get("boundary") != "administrative":
        return ""
    level = tags.get("admin_level")
    if level == COUNTRY:
        codes = [str(tags.get(key, "")).strip().upper() for key in COUNTRY_KEYS]
        return next((code for code in codes if COUNTRY_CODE.fullmatch(code)), "")
    code = str(tags.get("ISO3166-2", "")).strip().upper()
    return code if level == STATE and code in laws() else ""


def borders_of(
    relations: Sequence[Relation],
    read_tags: Callable[[str], Mapping[str, str]],
    ways_of: Callable[[set[int]], Mapping[int, Floats]],
) -> tuple[Border, ...]:
    """Return the borders among relations, those that are whole.

    Parameters
    ----------
    relations : sequence of tuple
        Id, tags as OPL text and members (kind, id, role) of each.
    read_tags : callable
        Decodes tags.
    ways_of : callable
        Returns the points (k, 2) of ways by their ids; asked only if there is a border.

    Returns
    -------
    tuple of Border
        Countries first, then states.
    """
    import shapely

    wanted = [
        (code, [ref for kind, ref, _ in members if kind == "w"])
        for _, text, members in relations
        for code in (code_of(read_tags(text)) if "boundary=administrative" in text else "",)
        if code
    ]
    lines = ways_of({ref for _, refs in wanted for ref in refs}) if wanted else {}
    found = []
    for code, refs in sorted(wanted, key=lambda one: len(one[0])):
        drawn = [shapely.LineString(lines[ref]) for ref in refs if len(lines.get(ref, ())) > 1]
        area = shapely.build_area(shapely.union_all(drawn)) if drawn else None
        if area is not None and not area.is_empty:
            found.append(Border(code, area))
    return tuple(found)


def within_borders(
    borders: Sequence[Border], lon: Floats, lat: Floats, outlined: Sequence[str]
) -> list[str]:
    """Return the country of points: by a border that the map has, else as outlined.

    Parameters
    ----------
    borders : sequence of Border
        Of the map.
    lon, lat : ndarray of float, (k,)
        Degrees; NaN where no point is known.
    outlined : sequence of str, (k,)
        Codes by the bundled outlines; a state of the same country stays.

    Returns
    -------
    list of str, (k,)
        Codes; empty where there is none.
    """
    import shapely

    found = list(outlined)
    known = np.flatnonzero(np.isfinite(lon) & np.isfinite(lat))
    for border in borders:
        shapely.prepare(border.area)
        inside = known[shapely.contains_xy(border.area, lon[known], lat[known])]
        for place in inside.tolist():
            if not found[place].startswith(f"{border.code}-"):
                found[place] = border.code
    return found
