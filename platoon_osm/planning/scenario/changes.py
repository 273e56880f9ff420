"""Scenarios with other values than their file has, and scenarios without a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from ...costs.presets import PRESETS
from ...errors import ScenarioError
from .keys import known
from .record import Scenario
from .trip_tables import read_trips

__all__ = ["changed"]


def changed(
    scenario: Scenario | None,
    table: Path | None = None,
    sheet: str | None = None,
    *,
    network: Mapping[str, Any],
    options: Mapping[str, Any],
    preset: str | None = None,
    costs: Mapping[str, Any],
) -> Scenario:
    """Return a scenario with what was given beside it, or one made of that alone.

    Parameters
    ----------
    scenario : Scenario or None
        What a file says.
    table : Path, optional
        Table of the trips, where there is no scenario.
    sheet : str, optional
        Sheet or layer of the table.
    network : mapping
        Keyword arguments of `load_network`, instead of the scenario's.
    options : mapping
        Of `OPTION_KEYS`, likewise.
    preset : str, optional
        Other costs than the scenario's, whose parameters then do not count.
    costs : mapping
        Parameters of the costs.

    Returns
    -------
    Scenario
        Of both; what was given beside counts.

    Raises
    ------
    ScenarioError
        No network, an unknown preset or parameter, or a table that cannot be read.
    """
    if scenario is None:
        if table is None:
            raise ScenarioError("no trips; give a scenario, or --trips with --network")
        if "source" not in network:
            raise ScenarioError(
                f"{table}: which network? add --network italy-motorways or a path to a map"
            )
        trips = tuple(read_trips(table, sheet))
        scenario = Scenario(table, table.stem, {}, trips, files=(Path(table),))
    chosen = PRESETS.find(scenario.preset if preset is None else preset)
    known("costs", costs, chosen.parameters)
    both = {**scenario.options, **options}
    if "delays" in options and isinstance(scenario.options.get("delays"), Mapping):
        both["delays"] = {**scenario.options["delays"], **options["delays"]}
    kept = scenario.costs if chosen.name == scenario.preset else {}
    return replace(
        scenario,
        network={**scenario.network, **network},
        options=both,
        costs={**kept, **costs},
        preset=chosen.name,
    )
