"""Cells of tables, brought into the form that trips have in TOML.

A table names a place in one cell, "Torino" or "7.69, 45.07", or in several: origin_lon and
origin_lat, or origin_osmid, each with origin_label.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from ...errors import ScenarioError
from ...plans.trip import TIMES
from .cell_values import number_in, text_in, whole_in
from .driver_cells import DRIVER_COLUMNS, driver_of
from .keys import CARRIER, DRIVER, FLEXIBILITY, PLACES, PROFILE, SPREAD

__all__ = ["COLUMNS", "MAIN_COLUMNS", "PARTS", "column_named", "is_blank", "row_of"]

PARTS = ("lon", "lat", "osmid", "label")
SIZES = ("height_m", "width_m", "length_m", "mass_t", "rating_t", "axle_load_t", "limiter_kmh")
"""What a row may say of its vehicle besides, or in place of, the name of a profile."""
MAIN_COLUMNS = (
    "vehicle", *PLACES, *TIMES, FLEXIBILITY, SPREAD, PROFILE, *SIZES,
    *(f"{end}_{part}" for end in PLACES for part in PARTS), "drivers",
)  # fmt: skip
"""Those that messages list."""
COLUMNS = (*dict.fromkeys((*MAIN_COLUMNS, *DRIVER_COLUMNS, CARRIER)),)
"""Columns there are; vehicle and both places must be given."""

UNITS = {"m": "metres", "t": "tonnes", "kmh": "kilometres an hour"}


def column_named(title: Any) -> str:
    """Return the column that a title means.

    Parameters
    ----------
    title : Any
        A cell of the header: "Earliest Departure ".

    Returns
    -------
    str
        In lower case and with underscores: "earliest_departure".
    """
    text = "" if title is None else str(title)
    return re.sub(r"[\s_-]+", "_", text.replace("\ufeff", "").strip().strip('"').strip()).lower()


def is_blank(cell: Any) -> bool:
    """Tell whether a cell holds nothing.

    Parameters
    ----------
    cell : Any
        What a table holds.

    Returns
    -------
    bool
        True for nothing, and for text of blanks alone.
    """
    return cell is None or (isinstance(cell, str) and not cell.strip())


def row_of(where: str, cells: Mapping[str, Any]) -> dict[str, Any]:
    """Return a row of a table as a trip of TOML has it.

    Parameters
    ----------
    where : str
        The row, for messages: "trips.csv line 3".
    cells : mapping
        Its cells by `COLUMNS`; blank ones may be missing.

    Returns
    -------
    dict
        By the keys of trips.

    Raises
    ------
    ScenarioError
        A place that is missing or told twice, or a cell that is no number.
    """
    given = {key: cell for key, cell in cells.items() if not is_blank(cell)}
    if "vehicle" not in given:
        raise ScenarioError(f"{where}: vehicle is empty; every trip has the name of its vehicle")
    row: dict[str, Any] = {"vehicle": text_in(f"{where}: vehicle", given["vehicle"])}
    for end in PLACES:
        row[end] = _place(where, end, given)
    row |= {key: given[key] for key in TIMES if key in given}
    for key in (FLEXIBILITY, SPREAD):
        if key in given:
            row[key] = number_in(f"{where}: {key}", given[key], "minutes")
    sizes = {
        key: number_in(f"{where}: {key}", given[key], UNITS[key.rpartition("_")[2]])
        for key in SIZES
        if key in given
    }
    if PROFILE in given:
        named = text_in(f"{where}: {PROFILE}", given[PROFILE])
        row[PROFILE] = {"base": named, **sizes} if sizes else named
    elif sizes:
        row[PROFILE] = sizes
    if driver := driver_of(where, given):
        row[DRIVER] = driver
    return row


def _place(where: str, end: str, given: Mapping[str, Any]) -> Any:
    lon, lat, osmid, label = (given.get(f"{end}_{part}") for part in PARTS)
    ways = [
        name
        for name, cell in (
            (end, given.get(end)),
            (f"{end}_lon", lat if lon is None else lon),
            (f"{end}_osmid", osmid),
        )
        if cell is not None
    ]
    if len(ways) > 1:
        raise ScenarioError(
            f"{where}: {' and '.join(ways)} both say where it is; keep one, and {end}_label for a "
            "name of your own"
        )
    if not ways:
        raise ScenarioError(f"{where}: {end} is empty; give a name or lon, lat")
    at: dict[str, Any]
    if osmid is not None:
        at = {"osmid": whole_in(f"{where}: {end}_osmid", osmid)}
    elif end in given:
        cell = given[end]
        # A pair comes from geometry, all else is text.
        at = {"at": cell if isinstance(cell, tuple) else text_in(f"{where}: {end}", cell)}
    else:
        if lon is None or lat is None:
            missing = f"{end}_lon" if lon is None else f"{end}_lat"
            raise ScenarioError(f"{where}: {missing} is empty; give longitude and latitude")
        at = {
            "at": (
                number_in(f"{where}: {end}_lon", lon, "degrees"),
                number_in(f"{where}: {end}_lat", lat, "degrees"),
            )
        }
    if label is not None:
        return {**at, "label": text_in(f"{where}: {end}_label", label)}
    return at.get("at", at)
