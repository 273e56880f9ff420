"""What is asked of a report, checked before anything is made: one line for the person who asked."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path

from ...errors import ScenarioError
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ..drawing.vehicle_styles import VehicleStyle

__all__ = [
    "check_is_plan",
    "check_path",
    "check_plan",
    "check_styles",
    "check_title",
    "check_titles",
]


def check_plan(plan: object, net: object) -> None:
    """Refuse anything but a plan with vehicles and the network it was made on.

    Parameters
    ----------
    plan : object
        Should be a plan.
    net : object
        Should be its network.

    Raises
    ------
    ScenarioError
        Not a plan, not a network, no vehicles, another network, or vehicles that drive off it.
    """
    if isinstance(plan, RoadNetwork) and isinstance(net, Plan):
        raise ScenarioError("report: plan and network are swapped; name the plan first")
    check_is_plan(plan)
    if not isinstance(net, RoadNetwork):
        raise ScenarioError(
            f"report: {_told(net)} is no network; hand in the one that the plan was made on"
        )
    assert isinstance(plan, Plan)
    if not plan.vehicles:
        raise ScenarioError("report: the plan has no vehicles; plan at least one trip")
    if plan.network.identity != net.identity():
        raise ScenarioError(
            f"report: the plan was made on {plan.network.name!r} ({plan.network.identity}), not "
            f"on {net.source.name!r} ({net.identity()}); load the network it was made on"
        )
    seen: set[str] = set()
    for vehicle in plan.vehicles:
        if vehicle.vehicle in seen:
            raise ScenarioError(
                f"report: two vehicles are named {vehicle.vehicle!r}; give each its own name"
            )
        seen.add(vehicle.vehicle)
        for edge in (*vehicle.edges, *vehicle.alone.edges):
            if not 0 <= edge < net.m:
                raise ScenarioError(
                    f"report: vehicle {vehicle.vehicle!r} drives edge {edge}, the network has "
                    f"0 to {net.m - 1}; plan again"
                )


def check_is_plan(plan: object) -> None:
    """Refuse anything but a plan.

    Parameters
    ----------
    plan : object
        Should be one.

    Raises
    ------
    ScenarioError
        It is not.
    """
    if not isinstance(plan, Plan):
        remedy = (
            "Plan.from_dict makes one of it"
            if isinstance(plan, dict)
            else ("hand in what plan_joint returned")
        )
        raise ScenarioError(f"report: {_told(plan)} is no plan; {remedy}")


def check_path(path: object) -> Path:
    """Return a path that can be written to, as far as its type tells.

    Parameters
    ----------
    path : object
        Should be text or a path.

    Returns
    -------
    Path
        The same.

    Raises
    ------
    ScenarioError
        It is neither, or no file system has such a name.
    """
    if isinstance(path, str | os.PathLike):
        found = os.fspath(path)
        if isinstance(found, str) and found and "\0" not in found:
            return Path(found)
    raise ScenarioError(f"report: path {_told(path)} names no file; give the name of one to write")


def check_title(title: object) -> None:
    """Refuse a title that is no text.

    Parameters
    ----------
    title : object
        Should be text or None.

    Raises
    ------
    ScenarioError
        It is neither.
    """
    if title is not None and not isinstance(title, str):
        raise ScenarioError(f"report: title {_told(title)} is no text; give text, or none")


def check_titles(titles: object, plans: Sequence[object]) -> None:
    """Refuse titles of plans unless they are as many texts as there are plans.

    Parameters
    ----------
    titles : object
        Should be a sequence of texts, or None.
    plans : sequence
        What they head.

    Raises
    ------
    ScenarioError
        They are not.
    """
    if titles is None:
        return
    if not isinstance(titles, list | tuple):
        raise ScenarioError(f"compare: titles {_told(titles)} are no list; give one text a plan")
    if len(titles) != len(plans):
        raise ScenarioError(f"compare: {len(titles)} titles for {len(plans)} plans; give one each")
    for title in titles:
        if not isinstance(title, str):
            raise ScenarioError(f"compare: title {_told(title)} is no text; give one text a plan")


def check_styles(styles: object, plan: Plan) -> None:
    """Refuse styles unless there is one for each vehicle.

    Parameters
    ----------
    styles : object
        Should be a mapping of names to styles, or None.
    plan : Plan
        Whose vehicles they are for.

    Raises
    ------
    ScenarioError
        They are something else, or one is missing.
    """
    if styles is None:
        return
    for vehicle in plan.vehicles:
        found = styles.get(vehicle.vehicle) if isinstance(styles, Mapping) else None
        if not isinstance(found, VehicleStyle):
            raise ScenarioError(
                f"report: vehicle {vehicle.vehicle!r} has no style; give a VehicleStyle for each "
                "name, or none at all"
            )


def _told(value: object) -> str:
    """Return what somebody handed in, short and in one line."""
    if value is None or isinstance(value, str | int | float):
        return repr(value)[:80]
    name = type(value).__name__
    return f"{'an' if name[:1].lower() in 'aeiou' else 'a'} {name}"
