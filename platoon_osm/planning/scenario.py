"""Scenarios: what to plan, as a TOML file that people write by hand."""

from __future__ import annotations

import csv
import difflib
import os
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from datetime import datetime
from pathlib import Path
from typing import Any

from ..costs.objective import Objective
from ..costs.presets import DEFAULT_PRESET, PRESETS
from ..costs.weights import EdgeWeights
from ..errors import PlatoonError, ScenarioError, brief
from ..kinds import is_number
from ..network.road_network import RoadNetwork
from ..plans.plan import Plan
from ..plans.trip import TIMES, Trip, check_one_clock
from .ends import located
from .joint import plan_joint

__all__ = ["Scenario", "read_scenario"]

NETWORK_KEYS = ("source", "classes", "country", "limiter_kmh", "infer_links")
TOP_KEYS = ("title", "network", "case", "objective", "method", "master", "costs", "trips")
TRIP_KEYS = ("vehicle", "origin", "destination")
ALL_TRIP_KEYS = (*TRIP_KEYS, *TIMES)


@dataclass(frozen=True, slots=True)
class Scenario:
    """A scenario file.

    Attributes
    ----------
    file : Path
        Where it was read.
    title : str
        Heads its pages.
    network : mapping
        Keyword arguments of `load_network`.
    trips : tuple of Trip
        Who goes where, places as they are written.
    options : mapping
        Keyword arguments of `plan_joint`.
    costs : mapping
        Parameters of the costs.
    preset : str
        Name of the costs in `PRESETS`.
    """

    file: Path
    title: str
    network: Mapping[str, Any]
    trips: tuple[Trip, ...]
    options: Mapping[str, Any] = field(default_factory=dict)
    costs: Mapping[str, Any] = field(default_factory=dict)
    preset: str = DEFAULT_PRESET

    def objective(self) -> Objective:
        """Return the costs the scenario asks for.

        Returns
        -------
        Objective
            Of the preset it names, with its parameters.

        Raises
        ------
        ScenarioError
            A parameter out of range, with the file.
        """
        with self._told():
            return PRESETS.find(self.preset).objective(self.costs)

    def weights(self, net: RoadNetwork) -> EdgeWeights:
        """Return the weights the scenario asks for.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        EdgeWeights
            Those of its objective.
        """
        return self.objective().weights(net)

    def located(self, net: RoadNetwork) -> list[Trip]:
        """Return the trips with their places found on a network.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        list of Trip
            Places are locations.

        Raises
        ------
        ScenarioError
            A place that is not there, with the file.
        """
        with self._told(PlatoonError):
            return [
                replace(trip, origin=origin, destination=destination)
                for trip, (origin, destination) in zip(
                    self.trips, located(net, self.trips), strict=True
                )
            ]

    def plan(self, net: RoadNetwork) -> Plan:
        """Plan the scenario on a network.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        Plan
            As `plan_joint` makes it.

        Raises
        ------
        PlatoonError
            Anything that cannot be planned.
        """
        trips, objective = self.located(net), self.objective()
        with self._told():
            return plan_joint(net, objective, trips, **self.options)

    @contextmanager
    def _told(self, kinds: type[PlatoonError] = ScenarioError) -> Iterator[None]:
        """Put the file's name before what goes wrong inside."""
        try:
            yield
        except kinds as error:
            raise ScenarioError(f"{self.file}: {error}") from error


def read_scenario(path: str | os.PathLike[str]) -> Scenario:
    """Read and check a scenario.

    Parameters
    ----------
    path : str or path
        A TOML file.

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
    file = Path(path)
    try:
        data = tomllib.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise ScenarioError(f"{file}: cannot be read ({error.strerror})") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ScenarioError(f"{file}: not a TOML file ({error}); see examples/") from error
    _known(file, "scenario", data, TOP_KEYS)
    network = data.get("network")
    if isinstance(network, str):
        network = {"source": network}
    if not isinstance(network, dict) or "source" not in network:
        raise ScenarioError(
            f'{file}: network is missing; write network = "italy-motorways" or a path to a map'
        )
    _known(file, "[network]", network, NETWORK_KEYS)
    network = {**network, "source": _beside(file, network["source"])}
    costs = data.get("costs", {})
    if not isinstance(costs, dict):
        raise ScenarioError(f"{file}: costs must be a table, [costs]")
    try:
        preset = PRESETS.find(costs.get("preset", DEFAULT_PRESET))
    except ScenarioError as error:
        raise ScenarioError(f"{file}: {error}") from error
    _known(file, "[costs]", costs, ("preset", *preset.parameters))
    options: dict[str, Any] = {
        key: _text(file, key, data[key])
        for key in ("case", "objective", "method", "master")
        if key in data
    }
    return Scenario(
        file=file,
        title=_text(file, "title", data.get("title", file.stem)),
        network=network,
        trips=_trips(file, data.get("trips")),
        options=options,
        costs={key: value for key, value in costs.items() if key != "preset"},
        preset=preset.name,
    )


def _known(file: Path, where: str, table: Mapping[str, Any], allowed: Sequence[str]) -> None:
    for key in table:
        if key not in allowed:
            near = difflib.get_close_matches(key, allowed, 1, 0.5)
            hint = f"did you mean {near[0]!r}?" if near else f"known are {', '.join(allowed)}"
            raise ScenarioError(f"{file}: {where} has no key {brief(key)}; {hint}")


def _text(file: Path, key: str, value: Any) -> str:
    if not isinstance(value, str) or not value.strip():
        raise ScenarioError(f"{file}: {key} = {brief(value)} must be a text in quotes")
    return value


def _beside(file: Path, source: Any) -> str:
    """Read a map's path as seen from the scenario, unless it is a name or found as it stands."""
    text = _text(file, "network source", source)
    beside = file.parent / text
    return str(beside) if beside.is_file() and not Path(text).is_file() else text


def _trips(file: Path, data: Any) -> tuple[Trip, ...]:
    if isinstance(data, str):
        rows = _csv_rows(file, Path(_beside(file, data)))
    elif isinstance(data, list) and data:
        rows = [(f"trip {number}", row) for number, row in enumerate(data, 1)]
    else:
        raise ScenarioError(f"{file}: no trips; add [[trips]] with vehicle, origin, destination")
    trips = tuple(_trip(file, where, row) for where, row in rows)
    try:
        check_one_clock(trips)
    except ScenarioError as error:
        raise ScenarioError(f"{file}: {error}") from error
    return trips


def _trip(file: Path, where: str, row: Any) -> Trip:
    if not isinstance(row, Mapping):
        raise ScenarioError(f"{file}: {where} must be a table with {', '.join(TRIP_KEYS)}")
    _known(file, where, row, ALL_TRIP_KEYS)
    for key in TRIP_KEYS:
        if key not in row:
            raise ScenarioError(f"{file}: {where} has no {key}")
    vehicle = _text(file, f"{where}: vehicle", row["vehicle"])
    origin, destination = (_place(file, where, end, row[end]) for end in TRIP_KEYS[1:])
    times = {key: _time(file, f"{where}: {key}", row[key]) for key in TIMES if key in row}
    try:
        return Trip(vehicle, origin, destination, **times)
    except ScenarioError as error:
        raise ScenarioError(f"{file}: {error}") from error


def _time(file: Path, where: str, value: Any) -> datetime:
    """Return a time of TOML as it is, one of CSV from its text."""
    try:
        # A day alone would be read as its midnight.
        found = datetime.fromisoformat(value) if isinstance(value, str) and ":" in value else value
    except ValueError:
        found = value
    if not isinstance(found, datetime):
        text = value if isinstance(value, str) else str(value)
        raise ScenarioError(
            f"{file}: {where} = {text} must be a day and a time, such as 2026-03-02T06:00:00"
        )
    return found


def _place(file: Path, where: str, key: str, value: Any) -> str | tuple[float, float]:
    if isinstance(value, str) and value.strip():
        return value
    numbers = isinstance(value, Sequence) and all(is_number(part) for part in value)
    if numbers and len(value) == 2:
        return float(value[0]), float(value[1])
    raise ScenarioError(
        f"{file}: {where}: {key} = {brief(value)} must be a name or a [lon, lat] pair in degrees"
    )


def _csv_rows(file: Path, table: Path) -> list[tuple[str, dict[str, Any]]]:
    """Read trips from CSV: vehicle, origin, destination, times; places as names or "lon lat"."""
    try:
        # Spreadsheets write a byte order mark, which is no part of the first key.
        with table.open(encoding="utf-8-sig", newline="") as handle:
            rows = list(csv.DictReader(handle))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise ScenarioError(f"{file}: trips file {table} cannot be read ({error})") from error
    if not rows:
        raise ScenarioError(f"{file}: trips file {table} has no rows under its header")
    return [(f"{table.name} line {number}", _csv_trip(row)) for number, row in enumerate(rows, 2)]


def _csv_trip(row: Mapping[str | None, Any]) -> dict[str, Any]:
    trip: dict[str, Any] = {}
    for key, value in row.items():
        if key in TIMES:
            # A trip may leave its times open.
            if value and value.strip():
                trip[key] = value.strip()
        else:
            # Cells beyond the header's come under the key None.
            name = key or "a cell beyond the header"
            trip[name] = value if key == "vehicle" else _maybe_pair(value)
    return trip


def _maybe_pair(text: Any) -> Any:
    if not isinstance(text, str):
        return ""
    parts = text.split()
    try:
        return [float(part) for part in parts] if len(parts) == 2 else text
    except ValueError:
        return text
