"""The legs of a plan as the rows of a table, for GIS and spreadsheets."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError, brief
from ...network.road_network import RoadNetwork
from ...plans.laid_out import laid_out
from ...plans.plan import Plan
from ...shown_text import shown
from ..document.checks import check_plan
from ..document.provenance import credits
from ..document.roads import roads_of

__all__ = ["TABLES", "Cell", "LegRow", "check_table", "leg_columns", "leg_rows"]

Cell = str | int | float | None

TABLES = ("legs", "pauses")
"""What the journeys of a plan are written as: driving, and standing."""

TIMED = ("start_time", "end_time", "waiting_s", "break_before_min")


@dataclass(frozen=True, slots=True)
class LegRow:
    """One leg of one vehicle; each field but the last is a column.

    Attributes
    ----------
    vehicle, vehicle_role : str
        Who drives it, and as what.
    leg : int
        Its number among the vehicle's, from 1.
    role : str
        "solo", "platoon", or "access" for a way between the road and a place beside it.
    partners : str
        The other vehicles on it.
    origin, destination : str
        Of the vehicle.
    roads : str
        Road numbers in driving order, each once.
    length_m, time_s, fuel_l, cost : float
        Of this vehicle on the leg.
    cost_unit : str
        The plan's.
    inferred_m : float
        Of road that the loader inferred.
    attribution : str
        Whom to name with the map.
    start_time, end_time : str or None
        ISO 8601; None without times.
    waiting_s : float or None
        How long the vehicle stands before it, for whatever reason; None without times.
    break_before_min : float or None
        How long of that are breaks and rests of driving rules; None without times.
    line : ndarray of float, (k, 2)
        Longitude and latitude of the road it follows [deg].
    """

    vehicle: str
    vehicle_role: str
    leg: int
    role: str
    partners: str
    origin: str
    destination: str
    roads: str
    length_m: float
    time_s: float
    fuel_l: float
    cost: float
    cost_unit: str
    inferred_m: float
    attribution: str
    start_time: str | None
    end_time: str | None
    waiting_s: float | None
    break_before_min: float | None
    line: NDArray[np.float64]


def check_table(what: object) -> None:
    """Refuse a table that is none.

    Parameters
    ----------
    what : object
        Its name.

    Raises
    ------
    ScenarioError
        Not one of `TABLES`.
    """
    if not isinstance(what, str) or what not in TABLES:
        raise ScenarioError(f"table {brief(what)} is unknown; use one of {', '.join(TABLES)}")


def leg_rows(plan: Plan, net: RoadNetwork) -> list[LegRow]:
    """Return the legs of all vehicles; those without road are left out.

    Parameters
    ----------
    plan : Plan
        Whose legs they are.
    net : RoadNetwork
        The network it was made on.

    Returns
    -------
    list of LegRow
        Vehicle by vehicle, in driving order.

    Raises
    ------
    ScenarioError
        A plan of another network.
    """
    check_plan(plan, net)
    return list(_rows(*laid_out(plan, net)))


def _rows(plan: Plan, net: RoadNetwork) -> Iterator[LegRow]:
    credit = " \u00b7 ".join(credits(plan, net))
    for vehicle, times in zip(plan.vehicles, plan.times, strict=True):
        for number, leg in enumerate(vehicle.legs, 1):
            if not leg.edges:
                continue
            start = end = waiting = breaks = None
            if plan.timetable is not None and times is not None:
                start, end = (plan.timetable.clock.iso(at) for at in times.legs[number - 1])
                waiting = times.waits[number - 1]
                own = (one for one in times.pauses if one.before == number - 1 and one.is_break)
                breaks = sum(one.duration_s for one in own) / 60
            yield LegRow(
                vehicle=shown(vehicle.vehicle),
                vehicle_role=vehicle.role,
                leg=number,
                role=leg.role,
                partners=", ".join(shown(name) for name in leg.partners),
                origin=shown(vehicle.origin.name),
                destination=shown(vehicle.destination.name),
                roads=roads_of(net, leg.edges) if leg.access is None else "",
                length_m=leg.length_m,
                time_s=leg.time_s,
                fuel_l=leg.fuel_l,
                cost=leg.cost,
                cost_unit=shown(plan.unit),
                inferred_m=leg.inferred_m,
                attribution=credit,
                start_time=start,
                end_time=end,
                waiting_s=waiting,
                break_before_min=breaks,
                line=net.path_shape(leg.edges),
            )


def leg_columns(plan: Plan, rows: Sequence[LegRow]) -> dict[str, list[Cell]]:
    """Return rows as columns; those of times only for a plan that has times.

    Parameters
    ----------
    plan : Plan
        Whose legs they are.
    rows : sequence of LegRow
        Its legs.

    Returns
    -------
    dict of str to list
        The values of each column by its name.
    """
    left_out = ("line", *(TIMED if plan.timetable is None else ()))
    names = [one.name for one in fields(LegRow) if one.name not in left_out]
    return {name: [getattr(row, name) for row in rows] for name in names}
