"""Trips from a table: CSV, a sheet of a workbook, or a layer of a GeoPackage."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from ...errors import PlatoonError, ScenarioError, brief
from ...plans.fleet import Unserved
from ...plans.trip import Trip, check_one_clock
from ...vehicles.profile import NO_VEHICLES, Vehicle
from .cell_values import text_in
from .cells import row_of
from .csv_table import read_csv
from .geopackage_table import read_geopackage
from .keys import CARRIER
from .rows import Row
from .text_file import MOST_BYTES, beginning_of, kind_by_content, path_of
from .trip_rows import trip_of
from .xlsx_table import read_xlsx

__all__ = ["TABLE_SUFFIXES", "FleetTable", "read_fleet_table", "read_trips"]

A_TABLE = "a table of trips (.csv, .xlsx, .gpkg)"
TABLE_SUFFIXES = (".csv", ".tsv", ".txt", ".xlsx", ".xlsm", ".gpkg")

OTHER_FILES = {
    ".toml": "is a scenario, not a table of trips; give it to plan as SCENARIO",
    ".xls": "is a workbook of old Excel; save it as .xlsx or CSV UTF-8",
    ".ods": "is an OpenDocument sheet; save it as .xlsx or CSV UTF-8",
    ".numbers": "is a sheet of Numbers; export it as .xlsx or CSV",
}


def read_trips(
    path: str | os.PathLike[str],
    sheet: str | None = None,
    profiles: Mapping[str, Vehicle] = NO_VEHICLES,
) -> list[Trip]:
    """Read trips from a table.

    Columns are vehicle, origin and destination, and if wanted earliest_departure,
    latest_departure, latest_arrival, flexibility_min, profile (the name of a vehicle) and sizes of
    its own as height_m or mass_t. A place is a name or "lon, lat", or stands
    in origin_lon and origin_lat, or in origin_osmid; origin_label gives it a name of its own. In a
    GeoPackage points are origins, and lines run from origin to destination.

    Parameters
    ----------
    path : str or path-like
        CSV with commas, semicolons or tabs, in UTF-8 or UTF-16; a workbook (.xlsx); a GeoPackage.
    sheet : str, optional
        Sheet of the workbook or layer of the GeoPackage; by default the first sheet, or the only
        layer.
    profiles : mapping of str to Vehicle
        Vehicles that rows may name besides those of `VEHICLES`.

    Returns
    -------
    list of Trip
        In the order of the table; places are not looked for yet.

    Raises
    ------
    ScenarioError
        The file cannot be read, or has a column or cell that is none; with line and remedy.
    """
    file, rows = _table(path, sheet)
    trips = []
    for row, found in _read(rows, profiles):
        if isinstance(found, ScenarioError):
            raise found
        if CARRIER in row.cells:
            raise ScenarioError(
                f"{row.where}: {CARRIER} counts in fleets alone; plan them with fleet, or remove "
                "the column"
            )
        trips.append(found)
    try:
        check_one_clock(trips)
    except PlatoonError as error:
        raise ScenarioError(f"{file}: {error}") from error
    return trips


@dataclass(frozen=True, slots=True)
class FleetTable:
    """A table of a fleet's trips, as far as it can be read.

    Attributes
    ----------
    trips : tuple of Trip
        Of the rows that can be read, in their order.
    unserved : tuple of Unserved
        The other rows, by vehicle or, where a row names none, by where it stands.
    carriers : dict of str to str
        Who sends the vehicles of trips, of rows that say so in a column `carrier`.
    """

    trips: tuple[Trip, ...]
    unserved: tuple[Unserved, ...]
    carriers: dict[str, str]


def read_fleet_table(
    path: str | os.PathLike[str],
    sheet: str | None = None,
    profiles: Mapping[str, Vehicle] = NO_VEHICLES,
) -> FleetTable:
    """Read trips from a table, and list the rows that cannot be read instead of refusing all.

    Parameters
    ----------
    path, sheet, profiles : see `read_trips`
        The same; a column `carrier` may say who sends the vehicle.

    Returns
    -------
    FleetTable
        Trips, what could not be read, and carriers. Trips whose times have a zone where the
        first one's have none, or the other way round, are among what could not be read.

    Raises
    ------
    ScenarioError
        The file cannot be read, has no rows, or a column that is none.
    """
    _, rows = _table(path, sheet)
    trips: list[Trip] = []
    unserved: list[Unserved] = []
    carriers: dict[str, str] = {}
    timed: list[Trip] = []
    for row, found in _read(rows, profiles):
        try:
            if isinstance(found, ScenarioError):
                raise found
            carrier = text_in(f"{row.where}: {CARRIER}", row.cells.get(CARRIER, ""))
            if found.times:
                check_one_clock([*timed, found])
                timed = timed or [found]
        except PlatoonError as error:
            named = row.cells.get("vehicle")
            unserved.append(Unserved(row.where if named is None else str(named), str(error)))
            continue
        trips.append(found)
        if carrier:
            carriers[found.vehicle] = carrier
    return FleetTable(tuple(trips), tuple(unserved), carriers)


def _table(path: str | os.PathLike[str], sheet: str | None) -> tuple[Path, list[Row]]:
    """Return a file and its rows."""
    file = path_of(path, A_TABLE)
    if sheet is not None and not (isinstance(sheet, str) and sheet.strip()):
        raise ScenarioError(f"sheet {brief(sheet)} must be the name of a sheet or layer")
    rows = _rows(file, sheet)
    if not rows:
        raise ScenarioError(f"{file}: has no rows under its header; add a trip a row")
    return file, rows


def _read(
    rows: list[Row], profiles: Mapping[str, Vehicle]
) -> Iterator[tuple[Row, Trip | ScenarioError]]:
    """Yield the trip of each row, or why there is none."""
    seen: dict[str, str] = {}
    for row in rows:
        try:
            if row.fault:
                raise ScenarioError(row.fault)
            trip = trip_of(row.where, row_of(row.where, row.cells), profiles)
            if trip.vehicle in seen:
                raise ScenarioError(
                    f"{row.where}: vehicle {brief(trip.vehicle)} has a trip already "
                    f"({seen[trip.vehicle]}); names must differ"
                )
        except ScenarioError as error:
            yield row, error
            continue
        seen[trip.vehicle] = row.where
        yield row, trip


def _rows(file: Path, sheet: str | None) -> list[Row]:
    """Read the rows of a file by its content, for names may say otherwise."""
    suffix = file.suffix.lower()
    # What comes through a pipe can be read once.
    content = None if file.is_file() else beginning_of(file, MOST_BYTES + 1)
    found = kind_by_content(beginning_of(file, 64) if content is None else content)
    kind = found[0] if found else ""
    if kind == "zip" and suffix not in OTHER_FILES:
        return read_xlsx(file, sheet, content)
    if kind == "gpkg":
        return read_geopackage(file, sheet, content)
    if suffix in OTHER_FILES:
        raise ScenarioError(f"{file}: {OTHER_FILES[suffix]}")
    if kind == "ole":
        raise ScenarioError(
            f"{file}: is a workbook of old Excel, or one with a password; save it as .xlsx without"
        )
    if suffix in (".xlsx", ".xlsm", ".gpkg") and not found:
        what = "a GeoPackage" if suffix == ".gpkg" else "a workbook"
        raise ScenarioError(f"{file}: is not {what} by its content; save it again")
    if sheet is not None:
        raise ScenarioError(f"{file}: has no sheets; leave {sheet!r} out")
    return read_csv(file, content)
