"""Breaks, rests and waits as the rows of a table, for GIS and spreadsheets."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields

from ...network.road_network import RoadNetwork
from ...plans.laid_out import laid_out
from ...plans.plan import Plan
from ...shown_text import shown
from ..document.checks import check_plan
from ..document.halts import halts_of
from ..document.provenance import credits
from .legs import Cell

__all__ = ["PauseRow", "pause_columns", "pause_rows"]


@dataclass(frozen=True, slots=True)
class PauseRow:
    """A while in which one vehicle stands on its way; each field is a column.

    Attributes
    ----------
    vehicle : str
        Who stands.
    leg : int
        The leg that follows, its number among the vehicle's, from 1.
    purpose : str
        What the pause is for, as plans call it; "company" is a wait for others.
    also : str
        What else it is for.
    start_time, end_time : str
        ISO 8601.
    minutes : float
        How long it lasts.
    place : str
        Name of the place; empty if it has none.
    kind : str
        What is there; empty if nothing is known.
    parking : bool
        Whether trucks are known to park there.
    beside_m : float
        How far it is from the road.
    spaces : int or None
        For trucks; None where not known.
    with_vehicles : str
        Who stands there meanwhile.
    lon, lat : float
        Degrees.
    attribution : str
        Whom to name with the map.
    """

    vehicle: str
    leg: int
    purpose: str
    also: str
    start_time: str
    end_time: str
    minutes: float
    place: str
    kind: str
    parking: bool
    beside_m: float
    spaces: int | None
    with_vehicles: str
    lon: float
    lat: float
    attribution: str


def pause_rows(plan: Plan, net: RoadNetwork) -> list[PauseRow]:
    """Return where and why the vehicles of a plan stand.

    Parameters
    ----------
    plan : Plan
        Whose vehicles.
    net : RoadNetwork
        The network it was made on.

    Returns
    -------
    list of PauseRow
        Vehicle by vehicle, in order of time; none for a plan without times.

    Raises
    ------
    ScenarioError
        A plan of another network.
    """
    check_plan(plan, net)
    return list(_rows(*laid_out(plan, net)))


def _rows(plan: Plan, net: RoadNetwork) -> Iterator[PauseRow]:
    if plan.timetable is None:
        return
    clock, credit = plan.timetable.clock, " \u00b7 ".join(credits(plan, net))
    names = [shown(vehicle.vehicle) for vehicle in plan.vehicles]
    for name, halts in zip(names, halts_of(plan, net), strict=True):
        for halt in halts:
            yield PauseRow(
                vehicle=name,
                leg=halt.before + 1,
                purpose=halt.purposes[0],
                also=", ".join(halt.purposes[1:]),
                start_time=clock.iso(halt.begin_s),
                end_time=clock.iso(halt.end_s),
                minutes=round(halt.lasts_s / 60, 2),
                place=shown(halt.name),
                kind=shown(halt.kind),
                parking=halt.has_parking,
                beside_m=round(halt.beside_m, 1),
                spaces=halt.capacity,
                with_vehicles=", ".join(names[one] for one in halt.company),
                lon=round(halt.lon, 6),
                lat=round(halt.lat, 6),
                attribution=credit,
            )


def pause_columns(rows: Sequence[PauseRow]) -> dict[str, list[Cell]]:
    """Return rows as columns.

    Parameters
    ----------
    rows : sequence of PauseRow
        As of `pause_rows`.

    Returns
    -------
    dict of str to list
        The values of each column by its name.
    """
    names = [one.name for one in fields(PauseRow)]
    return {name: [getattr(row, name) for row in rows] for name in names}
