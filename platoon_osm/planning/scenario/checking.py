"""Whether a file says what to plan, found out without the network."""

from __future__ import annotations

from pathlib import Path

from ...errors import ScenarioError
from ...sources.catalog import bundled_path
from .reading import read_scenario
from .trip_tables import TABLE_SUFFIXES, read_trips

__all__ = ["checked"]


def checked(file: Path) -> str:
    """Check a scenario, or a table of trips, as far as that goes without its network.

    Parameters
    ----------
    file : Path
        A TOML file, or a table.

    Returns
    -------
    str
        One line that says what it holds.

    Raises
    ------
    ScenarioError
        Anything that would be refused when it is planned, up to places that are not on the map.
    """
    if file.suffix.lower() in TABLE_SUFFIXES:
        return f"{file}: {_counted(len(read_trips(file)))}"
    scenario = read_scenario(file)
    scenario.check()
    source = scenario.network["source"]
    if bundled_path(source) is None and not Path(source).is_file():
        raise ScenarioError(
            f"{file}: network source {source!r} is no file and no bundled map; correct it, or "
            "write its path as seen from the scenario"
        )
    case = scenario.options.get("case", "best")
    rules = scenario.options.get("rules", "none")
    law = "" if rules == "none" else f", rules {rules}"
    return f"{file}: {_counted(len(scenario.trips))} on {source}, case {case}{law}"


def _counted(count: int) -> str:
    return f"{count} trip{'s' if count > 1 else ''}"
