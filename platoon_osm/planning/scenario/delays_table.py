"""The table [delays] of a scenario: how late vehicles may be."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...chance.delays import Delays
from ...errors import ScenarioError, brief
from .keys import known

__all__ = ["DELAY_KEYS", "delays_of"]

DELAY_KEYS = ("spread_min", "correlation", "kind", "shape", "own", "pairs")


def delays_of(table: object) -> Delays:
    """Return what a table says of delays.

    Parameters
    ----------
    table : object
        What TOML holds below [delays], or options say.

    Returns
    -------
    Delays
        Without the spreads that trips name themselves.

    Raises
    ------
    ScenarioError
        No table, a key that is unknown or missing, or a value that is none.
    """
    if not isinstance(table, Mapping):
        raise ScenarioError("delays must be a table, [delays], with spread_min")
    known("[delays]", table, DELAY_KEYS)
    if "spread_min" not in table:
        raise ScenarioError("[delays] has no spread_min; give the spread of a delay in minutes")
    given: dict[str, Any] = dict(table)
    if "pairs" in given:
        given["pairs"] = _pairs(given["pairs"])
    return Delays(**given)


def _pairs(rows: object) -> dict[tuple[str, str], float]:
    """Return correlations by pair, of rows ["A", "B", 0.8]."""
    found: dict[tuple[str, str], float] = {}
    for row in rows if isinstance(rows, list) else [rows]:
        if not (isinstance(row, list) and len(row) == 3):
            raise ScenarioError(
                f'[delays] pairs has {brief(row)}; write rows ["A", "B", 0.8]: two vehicles and '
                "the correlation of their delays"
            )
        one, other, value = row
        if (one, other) in found:
            raise ScenarioError(f"[delays] pairs names {brief((one, other))} twice; name it once")
        found[one, other] = value
    return found
