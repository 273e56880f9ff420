"""Scenarios from TOML."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from ...costs.presets import DEFAULT_PRESET, PRESETS
from ...errors import ScenarioError
from ...plans.trip import Trip, check_one_clock
from ...vehicles.profile import Vehicle
from .keys import known, text_of, told
from .network_table import beside, network_of
from .objective_table import objective_of
from .profiles import profiles_of
from .record import ACCESS_LIMIT, Scenario
from .text_file import path_of
from .toml_file import read_toml
from .trip_rows import trip_of
from .trip_tables import read_trips

__all__ = ["OPTION_KEYS", "read_scenario"]

TEXT_KEYS = ("case", "optimum", "method", "master", "company", "lead", "rules", "share")
NUMBER_KEYS = ("max_platoon", "patience_min", ACCESS_LIMIT, "task_relief")
OTHER_KEYS = ("profile", "close", "delays", "robust")
OPTION_KEYS = (*TEXT_KEYS, *NUMBER_KEYS, *OTHER_KEYS)
TOP_KEYS = ("title", "network", *OPTION_KEYS, "profiles", "objective", "costs", "trips")
TABLE_KEYS = ("file", "sheet")

OTHER_FILES = {
    **dict.fromkeys(
        (".csv", ".tsv", ".xlsx", ".xlsm", ".gpkg"),
        "is a table of trips, not a scenario; give it as --trips, with --network",
    ),
    **dict.fromkeys(
        (".osm", ".pbf", ".graphml", ".platoon"),
        "is a map, not a scenario; give it as --network, with --trips",
    ),
}


def read_scenario(
    path: str | os.PathLike[str],
    trips: str | os.PathLike[str] | None = None,
    sheet: str | None = None,
) -> Scenario:
    """Read and check a scenario.

    Parameters
    ----------
    path : str or path-like
        A TOML file.
    trips : str or path-like, optional
        A table of trips instead of the scenario's own.
    sheet : str, optional
        Which sheet or layer of that table.

    Returns
    -------
    Scenario
        What it says; places are not looked for yet.

    Raises
    ------
    ScenarioError
        The file cannot be read, is no TOML, or has a key that is unknown (the nearest one is
        named), missing or of the wrong kind.
    """
    file = path_of(path, "a TOML file")
    if file.suffix.lower() in OTHER_FILES:
        raise ScenarioError(f"{file}: {OTHER_FILES[file.suffix.lower()]}")
    data = read_toml(file)
    with told(file):
        profiles = profiles_of(data.get("profiles", {}))
    asked = None if trips is None else tuple(read_trips(trips, sheet, profiles))
    with told(file):
        found = _scenario(file, data, asked, profiles)
    table = _table(file, data.get("trips")) if trips is None else Path(trips)
    return replace(found, files=(file,) if table is None else (file, table))


def _scenario(
    file: Path,
    data: Mapping[str, Any],
    asked: tuple[Trip, ...] | None,
    profiles: Mapping[str, Vehicle],
) -> Scenario:
    known("scenario", data, TOP_KEYS)
    network = network_of(file.parent, data.get("network"))
    costs, older = objective_of(data)
    preset = PRESETS.find(costs.get("preset", DEFAULT_PRESET))
    return Scenario(
        file=file,
        title=text_of("title", data.get("title", file.stem)),
        network=network,
        trips=_trips(file, data.get("trips"), profiles) if asked is None else asked,
        options={
            key: text_of(key, data[key]) if key in TEXT_KEYS else data[key]
            for key in OPTION_KEYS
            if key in data
        }
        | older,
        costs={key: value for key, value in costs.items() if key != "preset"},
        preset=preset.name,
        profiles=profiles,
        names_costs=bool(costs),
    )


def _table(file: Path, data: Any) -> Path | None:
    """Return the table of trips that a scenario names; None if its trips stand in it."""
    if isinstance(data, str):
        data = {"file": data}
    if not (isinstance(data, dict) and data):
        return None
    known("trips", data, TABLE_KEYS)
    if "file" not in data:
        raise ScenarioError('trips has no file; write trips = "trips.csv"')
    return Path(beside(file.parent, "trips", data["file"]))


def _trips(file: Path, data: Any, profiles: Mapping[str, Vehicle]) -> tuple[Trip, ...]:
    if (table := _table(file, data)) is not None:
        named = isinstance(data, dict) and "sheet" in data
        sheet = text_of("trips, sheet", data["sheet"]) if named else None
        return tuple(read_trips(table, sheet, profiles))
    if not isinstance(data, list) or not data:
        raise ScenarioError(
            'no trips; add [[trips]] with vehicle, origin, destination, or trips = "trips.csv"'
        )
    trips = tuple(trip_of(f"trip {number}", row, profiles) for number, row in enumerate(data, 1))
    check_one_clock(trips)
    return trips
