"""Columns that tell what a driver has behind it: driver_driven_today_h, drivers, ...

They are the keys of a trip's `driver` with that word before them; of `drivers` it is left out.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ...driving.state import STATE_KEYS
from .cell_values import number_in, truth_in, whole_in

__all__ = ["DRIVER_COLUMNS", "driver_of"]

UNITS = {"h": "hours", "min": "minutes", "s": "seconds"}
KEYS = {key if key == "drivers" else f"driver_{key}": key for key in STATE_KEYS}
DRIVER_COLUMNS = tuple(KEYS)
"""In the order of the fields of `DriverState`."""


def driver_of(where: str, given: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a row of a table says of its driver.

    Parameters
    ----------
    where : str
        The row, for messages: "trips.csv line 3".
    given : mapping
        Its cells by column, without blank ones.

    Returns
    -------
    dict
        By the keys of `driver`; empty if it says nothing.

    Raises
    ------
    ScenarioError
        A cell that is no number, or neither true nor false.
    """
    return {
        key: _reader(key)(f"{where}: {column}", given[column])
        for column, key in KEYS.items()
        if column in given
    }


def _reader(key: str) -> Callable[[str, Any], Any]:
    unit = UNITS.get(key.rpartition("_")[2])
    if unit:
        return lambda where, cell: number_in(where, cell, unit)
    return truth_in if key == "first_part_taken" else whole_in
