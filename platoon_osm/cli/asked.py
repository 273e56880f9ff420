"""What to plan, as it is typed: a scenario, a table of trips, and options that come before both."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ..errors import ScenarioError, brief
from .options import FILE, LIMITER, SectionOption, classes_of, rules_named

if TYPE_CHECKING:
    from ..planning.scenario.record import Scenario

__all__ = [
    "NETWORK_KEYS", "asked_options", "asked_scenario", "costs_option", "costs_typed",
    "network_typed",
    "section_option", "shared_option", "taken",
]  # fmt: skip

Run = TypeVar("Run", bound=Callable[..., Any])

WHAT = "What to plan (before the scenario's)"
WHERE = "On which network (before the scenario's)"

NETWORK_KEYS = ("classes", "country", "limiter_kmh", "infer_links")
OPTION_KEYS = (
    "case", "master", "optimum", "method", "company", "lead", "max_platoon", "patience_min",
    "access_limit_km", "rules", "task_relief", "robust", "share", "profile", "close",
)  # fmt: skip


SHARED: dict[str, dict[str, Any]] = {
    "--patience-min": {
        "type": float, "help": "Minutes by which company may move who names no window.",
    },
    "--access-limit-km": {
        "type": float, "help": "How far from every road a place may be; else 50.",
    },
    "--profile": {
        "help": "Vehicle of trips that name none: eu-40t, eu-lng, us-80k-lb, van-3.5t, ...",
    },
    "--close": {
        "multiple": True, "metavar": "ROAD",
        "help": 'A road that counts as closed: "way 123", "lon, lat", "A 22"; as often as needed.',
    },
}  # fmt: skip
"""Options that every verb has which plans trips."""


def asked_options(verb: Run) -> Run:
    """Add the options that say what to plan to a verb, which hands them to `asked_scenario`.

    Parameters
    ----------
    verb : callable
        What the verb does.

    Returns
    -------
    callable
        The same, with the options.
    """
    options = (
        section_option(WHAT, "--trips", type=FILE, help="Table of trips: .csv, .xlsx or .gpkg."),
        section_option(WHAT, "--sheet", help="Sheet or layer of that table; else the first."),
        section_option(WHAT, "--case", help="A, B, C, D or best."),
        section_option(
            WHAT, "--master", help="Vehicle that keeps its route, or longest; else the best.",
        ),
        section_option(WHAT, "--optimum", help="Whose cost is least: member or system."),
        section_option(WHAT, "--method", help="dijkstra (exact) or astar (the paper's)."),
        section_option(WHAT, "--company", help="Platoons anywhere, or with the master alone."),
        section_option(WHAT, "--lead", help="Who leads: master, or rotated for all in turns."),
        section_option(WHAT, "--max-platoon", type=int, help="Vehicles of the largest platoon."),
        shared_option(WHAT, "--patience-min"),
        shared_option(WHAT, "--access-limit-km"),
        shared_option(WHAT, "--profile"),
        shared_option(WHAT, "--close"),
        section_option(
            WHAT, "--rules", type=rules_named,
            help="Driving rules by which breaks and rests are planned; they stand below.",
        ),
        section_option(
            WHAT, "--task-relief", type=float,
            help="How much a follower's clock slows under them: 0, as in law, to 1.",
        ),
        section_option(
            WHAT, "--objective", "--preset", "preset",
            help="What is to be least: eu, us, fuel, paper, ...; they stand below.",
        ),
        section_option(
            WHAT, "--delay-spread-min", type=float,
            help="Spread of a vehicle's delay [min]; the chance of each merge is then told.",
        ),
        section_option(
            WHAT, "--robust", is_flag=True, default=None,
            help="Take the plan that is expected to save most with delays, not the cheapest.",
        ),
        section_option(
            WHAT, "--share",
            help="How a gain in money is shared: equal, shapley or least-core.",
        ),
        costs_option(WHAT),
        *network_typed(WHERE, required=False),
    )  # fmt: skip
    for add in reversed(options):
        verb = add(verb)
    return verb


def section_option(section: str, *names: str, **more: Any) -> Callable[[Run], Run]:
    """Return what adds an option to a section of a verb's help.

    Parameters
    ----------
    section : str
        Title of the section.
    *names : str
        Of the option.
    **more : object
        As `click.option` takes it; a value is called by its type unless it is one of some words.

    Returns
    -------
    callable
        Takes the verb and returns it.
    """
    kind = more.get("type")
    if kind is not None and "metavar" not in more and not isinstance(kind, click.Choice):
        more["metavar"] = {FILE: "FILE", float: "NUMBER", int: "NUMBER"}.get(kind, "TEXT")
    return click.option(*names, cls=SectionOption, section=section, **more)


def shared_option(section: str, name: str) -> Callable[[Run], Run]:
    """Return what adds an option that every verb has which plans trips.

    Parameters
    ----------
    section : str
        Title of the section.
    name : str
        One of `SHARED`.

    Returns
    -------
    callable
        Takes the verb and returns it.
    """
    return section_option(section, name, **SHARED[name])


def costs_option(section: str) -> Callable[[Run], Run]:
    """Return what adds the option of single figures of an objective; see `costs_typed`.

    Parameters
    ----------
    section : str
        Title of the section.

    Returns
    -------
    callable
        Takes the verb and returns it.
    """
    return section_option(
        section, "--cost", "costs", multiple=True, metavar="NAME=VALUE",
        help="A figure of the objective, as fuel_per_l=1.5; as often as needed.",
    )  # fmt: skip


def network_typed(section: str, *, required: bool) -> tuple[Callable[[Run], Run], ...]:
    """Return what adds the options that say on which network trips are planned.

    Parameters
    ----------
    section : str
        Title of the section.
    required : bool
        Whether nothing else names the network.

    Returns
    -------
    tuple of callable
        Each takes the verb and returns it.
    """
    return (
        section_option(
            section, "--network", required=required, help="A bundled map's name or a file."
        ),
        section_option(
            section, "--classes", type=classes_of, help="Highway values to load, with commas."
        ),
        section_option(
            section, "--country", help="Whose truck speed limit applies: IT, de, US-CA, ..."
        ),
        section_option(section, *LIMITER, type=float, help="Speed limiter of the trucks [km/h]."),
        section_option(
            section, "--infer-links", is_flag=True, default=None,
            help="Add likely connectors where the map lacks ramps; they are marked inferred.",
        ),
    )  # fmt: skip


def asked_scenario(scenario: Path | None, given: dict[str, Any]) -> Scenario:
    """Return what to plan, and take the options that say so from those given.

    Parameters
    ----------
    scenario : Path or None
        A TOML file.
    given : dict
        All options of the verb; those of `asked_options` are taken out.

    Returns
    -------
    Scenario
        The scenario with the options before its own values, or one made of the options.

    Raises
    ------
    ScenarioError
        Neither a scenario nor trips with a network, or a value that is none.
    """
    from ..planning.scenario.changes import changed
    from ..planning.scenario.objective_table import OPTIMA
    from ..planning.scenario.reading import read_scenario

    table, sheet, preset = (given.pop(name) for name in ("trips", "sheet", "preset"))
    if preset in OPTIMA:
        # What --optimum was called before there were objectives to choose from.
        given["optimum"], preset = given["optimum"] or preset, None
    if sheet is not None and table is None:
        raise ScenarioError("--sheet names a sheet of --trips; give that too")
    network = _named({"source": given.pop("network")}) | taken(given, NETWORK_KEYS)
    options = taken(given, OPTION_KEYS)
    spread = given.pop("delay_spread_min")
    if spread is not None:
        options["delays"] = {"spread_min": spread}
    if not options.get("close"):
        options.pop("close", None)
    costs = costs_typed(given.pop("costs"))
    read = None if scenario is None else read_scenario(scenario, table, sheet)
    return changed(
        read, table, sheet, network=network, options=options, preset=preset, costs=costs
    )  # fmt: skip


def taken(given: dict[str, Any], names: tuple[str, ...]) -> dict[str, Any]:
    """Take options out of those given.

    Parameters
    ----------
    given : dict
        All options of a verb, None for those that nobody typed.
    names : tuple of str
        Which to take out.

    Returns
    -------
    dict
        Those of them that were typed.
    """
    return _named({name: given.pop(name) for name in names})


def _named(given: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in given.items() if value is not None}


def costs_typed(typed: tuple[str, ...]) -> dict[str, Any]:
    """Read figures of an objective.

    Parameters
    ----------
    typed : tuple of str
        As "tau=0.5".

    Returns
    -------
    dict
        Values by name.

    Raises
    ------
    ScenarioError
        A text that is no such figure, or a name twice.
    """
    costs: dict[str, Any] = {}
    for text in typed:
        name, is_told, value = text.partition("=")
        if not (is_told and name.strip() and value.strip()):
            raise ScenarioError(f"--cost {brief(text)}: write a name and a value, as tau=0.5")
        if name.strip() in costs:
            raise ScenarioError(f"--cost {name.strip()} is given twice; give it once")
        costs[name.strip()] = _value(value.strip())
    return costs


def _value(text: str) -> Any:
    """Return a value as TOML would read it; what is none of TOML is a text without its quotes."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except ValueError:
        return text
