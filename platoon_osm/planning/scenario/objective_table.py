"""The objective of a scenario: `[objective]`, a name, or what older scenarios say.

Before costs in money, `[costs]` was the table of the objective, and `objective` said whose cost is
least, which is `optimum` now. Both are still read.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...costs.presets import DEFAULT_PRESET, PRESETS
from ...errors import ScenarioError, brief
from .keys import known, text_of

__all__ = ["OPTIMA", "objective_of"]

OPTIMA = ("member", "system")
"""Words of `optimum` that older scenarios have as `objective`."""


def objective_of(data: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, str]]:
    """Return the objective that a scenario asks for.

    Parameters
    ----------
    data : mapping
        What its TOML holds.

    Returns
    -------
    costs : dict of str to object
        "preset" if it names one, and the parameters.
    options : dict of str to str
        The optimum, where an older scenario has it as its objective.

    Raises
    ------
    ScenarioError
        An objective that is none, told twice, or with a parameter that is unknown.
    """
    given, options = data.get("objective", {}), {}
    if isinstance(given, str) and given in OPTIMA:
        if "optimum" in data:
            raise ScenarioError(
                f"objective = {given!r} and optimum say the same; give optimum alone"
            )
        options = {"optimum": given}
        given = {}
    elif not isinstance(given, dict):
        given = {"preset": text_of("objective", given)}
    costs, where = data.get("costs", {}), "[costs]"
    if not isinstance(costs, dict):
        raise ScenarioError("costs must be a table, [costs]")
    if given and costs:
        raise ScenarioError("[objective] and [costs] are the same table; give [objective] alone")
    if given:
        costs, where = given, "[objective]"
    preset = costs.get("preset", DEFAULT_PRESET)
    if not isinstance(preset, str):
        raise ScenarioError(f"{where}: preset = {brief(preset)} must be a text in quotes")
    known(where, costs, ("preset", *PRESETS.find(preset).parameters))
    return dict(costs), options
