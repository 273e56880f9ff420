"""Trips from rows of keys and values, as TOML has them and tables are brought into."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from ...errors import PlatoonError, ScenarioError, brief
from ...kinds import is_number, is_whole
from ...network.coordinate_text import coordinates_in
from ...network.location import Place
from ...plans.trip import TIMES, Trip
from ...vehicles.profile import NO_VEHICLES, Vehicle, vehicle_of
from .clock_texts import moment
from .keys import DRIVER, FLEXIBILITY, PLACES, PROFILE, SPREAD, TRIP_KEYS, known, text_of

__all__ = ["trip_of"]

PLACE_KEYS = ("at", "osmid", "label")


def trip_of(where: str, row: Any, profiles: Mapping[str, Vehicle] = NO_VEHICLES) -> Trip:
    """Return the trip that a row tells.

    Parameters
    ----------
    where : str
        The row, for messages: "trip 2", "trips.csv line 3".
    row : Any
        Its values by the keys of `TRIP_KEYS`.
    profiles : mapping of str to Vehicle
        Vehicles by the names that the scenario gives them; those of `VEHICLES` need not be there.

    Returns
    -------
    Trip
        Its places as they are written.

    Raises
    ------
    ScenarioError
        A key that is unknown or missing, or a value that is none.
    """
    if not isinstance(row, Mapping):
        raise ScenarioError(f"{where} must be a table with vehicle, {', '.join(PLACES)}")
    known(where, row, TRIP_KEYS)
    for key in ("vehicle", *PLACES):
        if key not in row:
            raise ScenarioError(f"{where} has no {key}")
    vehicle = text_of(f"{where}: vehicle", row["vehicle"])
    origin, destination = (_place(f"{where}: {end}", row[end]) for end in PLACES)
    more: dict[str, Any] = {key: moment(f"{where}: {key}", row[key]) for key in TIMES if key in row}
    for key in (FLEXIBILITY, SPREAD):
        if key in row:
            more[key] = _minutes(f"{where}: {key}", row[key])
    if PROFILE in row:
        more[PROFILE] = vehicle_of(row[PROFILE], f"{where}: {PROFILE}", profiles)
    if DRIVER in row:
        more[DRIVER] = row[DRIVER]
    try:
        return Trip(vehicle, origin, destination, **more)
    except PlatoonError as error:
        # Of a table the line says more than the vehicle, which may stand in several.
        said = str(error)
        raise ScenarioError(said if where.startswith("trip ") else f"{where}: {said}") from error


def _place(where: str, value: Any) -> Any:
    if isinstance(value, Mapping):
        return _told_place(where, value)
    if isinstance(value, str) and value.strip():
        try:
            return coordinates_in(value) or value.strip()
        except PlatoonError as error:
            raise ScenarioError(f"{where}: {error}") from error
    pair = _pair(value)
    if pair is None:
        raise ScenarioError(
            f"{where} = {brief(value)} must be a name or a [lon, lat] pair in degrees, or "
            "{osmid = ...}"
        )
    return pair


def _pair(value: Any) -> tuple[float, float] | None:
    """Return two numbers as such; what lies off the globe is told when it is looked for."""
    if isinstance(value, str) or not isinstance(value, Sequence) or len(value) != 2:
        return None
    if not all((is_number(part) and abs(part) < 1e9) or _is_nan(part) for part in value):
        return None
    return float(value[0]), float(value[1])


def _is_nan(value: Any) -> bool:
    return isinstance(value, float) and math.isnan(value)


def _told_place(where: str, value: Mapping[str, Any]) -> Place:
    """Return a place of several keys: {at = [lon, lat], label = "Redding"}, {osmid = 123}."""
    known(where, value, PLACE_KEYS)
    if ("at" in value) == ("osmid" in value):
        raise ScenarioError(
            f"{where} must have one of at and osmid, as {{at = [lon, lat], label = ...}}"
        )
    label = text_of(f"{where}, label", value["label"]).strip() if "label" in value else None
    if "osmid" in value:
        osmid = value["osmid"]
        if not is_whole(osmid):
            raise ScenarioError(f"{where}, osmid = {brief(osmid)} must be a whole number")
        return Place(osmid=osmid, label=label)
    if isinstance(value["at"], Mapping):
        raise ScenarioError(f"{where}, at must be a name or a [lon, lat] pair in degrees")
    return Place(_place(f"{where}, at", value["at"]), label=label)


def _minutes(where: str, value: Any) -> float:
    if not is_number(value):
        raise ScenarioError(f"{where} = {brief(value)} must be a number of minutes")
    return float(value)
