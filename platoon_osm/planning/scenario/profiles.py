"""Vehicles that a scenario describes: `profile = "eu-40t"`, and `[profiles.low]` of its own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...errors import ScenarioError, brief
from ...vehicles.profile import Vehicle, vehicle_of

__all__ = ["profiles_of"]


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
        found[name] = vehicle_of({"name": name, **given}, where, found)
    return found
