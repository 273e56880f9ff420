"""What to plan for a whole fleet, as it is typed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ..errors import ScenarioError
from .asked import (
    NETWORK_KEYS,
    costs_option,
    costs_typed,
    network_typed,
    section_option,
    shared_option,
    taken,
)
from .options import FILE, rules_named

if TYPE_CHECKING:
    from ..planning.scenario.record import Scenario
    from ..planning.scenario.trip_tables import FleetTable
    from ..plans.trip import Trip

__all__ = ["asked_fleet", "fleet_options", "limits_of"]

Run = TypeVar("Run", bound=Callable[..., Any])

WHAT, WHERE, HOW = "What to plan", "On which network", "How to search"

OPTION_KEYS = ("max_platoon", "rules", "patience_min", "access_limit_km", "profile", "close")
LIMIT_KEYS = ("time_s", "rounds", "seed", "threads", "routes", "per_trip", "min_gain")


def fleet_options(verb: Run) -> Run:
    """Add the options that say what to plan for a fleet, and how.

    Parameters
    ----------
    verb : callable
        What the verb does; it hands them to `asked_fleet` and `limits_of`.

    Returns
    -------
    callable
        The same, with the options.
    """
    options = (
        section_option(WHAT, "--sheet", help="Sheet or layer of the table; else the first."),
        section_option(
            WHAT, "--max-platoon", type=int,
            help="Vehicles of the largest platoon; else any.",
        ),
        section_option(
            WHAT, "--routes", type=click.Choice(("free", "given")), default="free",
            help="Whether trucks may leave their cheapest routes for company; else free.",
        ),
        section_option(
            WHAT, "--per-trip", type=click.Choice(("many", "one")), default="many",
            help="How many platoons a trip may have, one after the other; else many.",
        ),
        section_option(
            WHAT, "--min-gain", type=float, default=0.0,
            help="What a platoon has to save, in the unit of costs; else 0.",
        ),
        section_option(
            WHAT, "--flexibility", "flexibility_min", type=float,
            help="Minutes by which a trip that names no latest arrival may take longer than alone.",
        ),
        shared_option(WHAT, "--patience-min"),
        section_option(
            WHAT, "--apart", type=FILE,
            help="CSV of two columns: vehicles that must not drive together.",
        ),
        section_option(
            WHAT, "--rules", type=rules_named,
            help="Driving rules by which breaks and rests are planned, such as eu561; else none.",
        ),
        section_option(
            WHAT, "--together", type=FILE,
            help="CSV with a group a row: vehicles that must drive together.",
        ),
        shared_option(WHAT, "--profile"),
        shared_option(WHAT, "--close"),
        shared_option(WHAT, "--access-limit-km"),
        section_option(
            WHAT, "--objective", "preset", help="What is to be least: eu, us, fuel, paper.",
        ),
        costs_option(WHAT),
        *network_typed(WHERE, required=True),
        section_option(
            HOW, "--time-limit", "time_s", type=float,
            help="Seconds to search; else 60, or until --rounds are done.",
        ),
        section_option(
            HOW, "--rounds", type=int,
            help="Rounds to search; alone, the plan is the same on every machine.",
        ),
        section_option(HOW, "--seed", type=int, default=0, help="Of the draws; else 0."),
        section_option(
            HOW, "--threads", type=int,
            help="Cores to use, else all; the plan does not depend on it.",
        ),
    )  # fmt: skip
    for add in reversed(options):
        verb = add(verb)
    return verb


def asked_fleet(file: Path, table: FleetTable, given: dict[str, Any]) -> Scenario:
    """Return what to plan, and take the options that say so from those given.

    Parameters
    ----------
    file : Path
        The table of trips.
    table : FleetTable
        What it holds.
    given : dict
        All options of the verb; those of `fleet_options` that say what to plan are taken out.

    Returns
    -------
    Scenario
        Of all trips that can be read.

    Raises
    ------
    ScenarioError
        A value that is none.
    """
    from ..planning.scenario.changes import changed
    from ..planning.scenario.record import Scenario

    flexibility, preset = given.pop("flexibility_min"), given.pop("preset")
    network = {"source": given.pop("network"), **taken(given, NETWORK_KEYS)}
    options = taken(given, OPTION_KEYS)
    if not options.get("close"):
        options.pop("close", None)
    trips = tuple(_flexible(trip, flexibility) for trip in table.trips)
    if not trips:
        first = f"; first: {table.unserved[0].reason}" if table.unserved else ""
        raise ScenarioError(f"{file}: no trip can be read{first}")
    return changed(
        Scenario(file, file.stem, {}, trips, files=(file,)),
        network=network, options=options, preset=preset, costs=costs_typed(given.pop("costs")),
    )  # fmt: skip


def limits_of(table: FleetTable, given: dict[str, Any]) -> Any:
    """Return the limits of the search, and take the options that say so from those given.

    Parameters
    ----------
    table : FleetTable
        Whose vehicles and carriers they are.
    given : dict
        Options of the verb.

    Returns
    -------
    Limits
        For `plan_fleet`.

    Raises
    ------
    ScenarioError
        A value that is none, or a vehicle that is not in the table.
    """
    from ..fleets.apart_table import read_apart, read_together
    from ..fleets.limits import Limits

    limits = {name: given.pop(name) for name in LIMIT_KEYS}
    if limits["time_s"] is None and limits["rounds"] is None:
        limits["time_s"] = Limits().time_s
    apart, together = given.pop("apart"), given.pop("together")
    known = {trip.vehicle for trip in table.trips}
    unread = {one.vehicle for one in table.unserved} - known
    pairs = [] if apart is None else read_apart(apart)
    groups = [] if together is None else read_together(together)
    known_of = [tuple(name for name in group if name not in unread) for group in groups]
    found = Limits(
        **limits, carriers=table.carriers, apart=tuple(p for p in pairs if not unread & {*p}),
        together=tuple(group for group in known_of if len(group) > 1),
    )  # fmt: skip
    found.check_names(known)
    return found


def _flexible(trip: Trip, minutes: float | None) -> Trip:
    """Return a trip that names no latest arrival with some flexibility."""
    told = trip.flexibility_min is not None or trip.latest_arrival is not None
    if minutes is None or told or trip.earliest_departure is None:
        return trip
    return replace(trip, flexibility_min=minutes)
