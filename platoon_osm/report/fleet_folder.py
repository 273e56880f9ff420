"""A fleet's plan as a folder: a page, tables for its dispatchers, sheets for its drivers."""

from __future__ import annotations

import os
from pathlib import Path

from ..atomic_file import all_or_none
from ..errors import ScenarioError, brief
from ..network.road_network import RoadNetwork
from ..plans.plan import Plan
from .document.checks import check_path, check_plan, check_title
from .exports.assignment import write_assignment, write_frame, write_unserved
from .pages.fleet import write_fleet_html
from .sheets.write import write_sheets

__all__ = ["SHEETS_UP_TO", "write_fleet_folder"]

TABLES = ("assignment.csv", "platoons.csv", "vehicles.csv", "unserved.csv")
PAGE = "fleet.html"
SHEETS = "sheets"
SHEETS_UP_TO = 100
"""So many drivers get sheets without asking; each takes some hundredths of a second."""


def write_fleet_folder(
    plan: Plan,
    net: RoadNetwork,
    folder: str | os.PathLike[str],
    *,
    title: str | None = None,
    language: str | None = None,
    sheets: bool | None = None,
) -> list[Path]:
    """Write a fleet's plan into a folder: all of it appears, or nothing.

    There are `fleet.html`, the page of the fleet; `assignment.csv`, a row for each vehicle and part
    in company; `platoons.csv` and `vehicles.csv`, a row for each; `unserved.csv`, the trips that
    could not be planned and why; and in `sheets` a page and a calendar for each driver. The
    plan itself with its certificate is written by `plan_fleet`.

    Parameters
    ----------
    plan : Plan
        Of `plan_fleet`.
    net : RoadNetwork
        The network it was made on.
    folder : path-like
        Made if it is missing.
    title : str or None
        Heads page and sheets.
    language : str or None
        Of page and sheets, such as "de"; by default English.
    sheets : bool or None
        Whether drivers get sheets; by default those of fleets of up to 100.

    Returns
    -------
    list of Path
        What was written; of the sheets their folder.

    Raises
    ------
    ScenarioError
        A plan of no fleet or of another network, or a folder that cannot be written.
    """
    place = check_path(folder)
    check_plan(plan, net)
    check_title(title)
    if plan.fleet is None:
        raise ScenarioError("fleet: the plan is not one of a whole fleet; make it with plan_fleet")
    if not (sheets is None or isinstance(sheets, bool)):
        raise ScenarioError(f"fleet: sheets is {brief(sheets)}; give True, False or None")
    with all_or_none():
        write_assignment(plan, net, place / "assignment.csv")
        write_frame(plan, "platoons", place / "platoons.csv")
        write_frame(plan, "vehicles", place / "vehicles.csv")
        write_unserved(plan, place / "unserved.csv")
        write_fleet_html(plan, net, place / PAGE, title=title, language=language)
        written = [place / name for name in (*TABLES, PAGE)]
        if len(plan.trips) <= SHEETS_UP_TO if sheets is None else sheets:
            write_sheets(plan, net, place / SHEETS, title=title, language=language)
            written.append(place / SHEETS)
    return written
