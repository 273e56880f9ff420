"""Vehicles that a scenario describes: `profile = "eu-40t"`, and `[profiles.low]` of its own."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from ...errors import ScenarioError, brief
from ...vehicles.profile import VEHICLES, Vehicle, vehicle_of
from .keys import hint

__all__ = ["NO_PROFILES", "profile_of", "profiles_of"]

Profiles = Mapping[str, Vehicle]
NO_PROFILES: Profiles = MappingProxyType({})


def profiles_of(value: Any) -> dict[str, Vehicle]:
    """Return the vehicles of a scenario's table `[profiles]`.

    Parameters
    ----------
    value : Any
        What TOML holds.

    Returns
    -------
    dict of str to Vehicle
        By their names; a vehicle may be based on one that stands before it.

    Raises
    ------
    ScenarioError
        No table of tables, or a vehicle that is none.
    """
    if not isinstance(value, Mapping):
        raise ScenarioError("profiles must be tables, as [profiles.low] with height_m = 3.4")
    found: dict[str, Vehicle] = {}
    for name, given in value.items():
        where = f"[profiles.{name}]"
        if not isinstance(given, Mapping):
            raise ScenarioError(f"{where} is {brief(given)}; give a table of sizes and masses")
        found[name] = profile_of(where, {"name": name, **given}, found)
    return found


def profile_of(where: str, value: Any, profiles: Profiles = NO_PROFILES) -> Vehicle:
    """Return the vehicle that a scenario names or describes.

    Parameters
    ----------
    where : str
        Whose it is, for messages.
    value : Any
        A name, or a table of fields with `base`.
    profiles : mapping of str to Vehicle
        The scenario's own.

    Returns
    -------
    Vehicle
        The one meant.

    Raises
    ------
    ScenarioError
        An unknown name or field, or a value that is none.
    """
    if isinstance(value, str):
        return _named(where, value, profiles)
    if isinstance(value, Mapping) and "base" in value:
        base = value["base"]
        if not isinstance(base, str):
            raise ScenarioError(f"{where}: base is {brief(base)}; give the name of a vehicle")
        own = {**_named(where, base, profiles).to_dict(), "rating_t": None}
        rest = {key: item for key, item in value.items() if key != "base"}
        if not rest:
            return _named(where, base, profiles)
        kept = _named(where, base, profiles).rating_t
        if "mass_t" not in rest:
            own["rating_t"] = kept
        return vehicle_of({**own, "name": f"like {base}", **rest}, where)
    return vehicle_of(value, where)


def _named(where: str, name: str, profiles: Profiles) -> Vehicle:
    if name in profiles:
        return profiles[name]
    if name in VEHICLES:
        return VEHICLES[name]
    raise ScenarioError(
        f"{where}: vehicle {brief(name)} is unknown; {hint(name, [*profiles, *VEHICLES])}"
    )
