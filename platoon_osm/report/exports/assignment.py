"""A fleet's plan for its dispatchers: who drives with whom, from where to where, and when.

A part is what a vehicle drives in one company without a break between: it begins where the company
forms or changes and ends where it changes again. Who drives alone all the way has one row without
company.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta

from ...costs.share import Share
from ...csv_tables import write_table
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...plans.records import Stretch
from ...shown_text import shown
from ..document.checks import check_path, check_plan

__all__ = [
    "CompanyPart", "company_parts", "write_assignment", "write_frame", "write_unserved",
]  # fmt: skip

DIGITS = 6
"""Of numbers; more would say more than a plan knows."""

MIDDLE = 0.5

Cell = str | int | float | None


@dataclass(frozen=True, slots=True)
class CompanyPart:
    """What a vehicle drives in one company.

    Attributes
    ----------
    vehicle : int
        Its position in the plan.
    first, last : int
        Its legs from which to which it goes, counted from 0.
    company : tuple of int
        All vehicles in the order in which they drive.
    """

    vehicle: int
    first: int
    last: int
    company: tuple[int, ...]

    @property
    def position(self) -> int:
        """Where it drives, 1 in front."""
        return self.company.index(self.vehicle) + 1


def company_parts(plan: Plan) -> list[CompanyPart]:
    """Return what vehicles drive in company.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    list of CompanyPart
        Vehicle by vehicle, in driving order.
    """
    found: list[CompanyPart] = []
    for vehicle, way in enumerate(plan.ways):
        before: tuple[int, ...] = ()
        for leg, stretch in enumerate(way):
            company = plan.stretches[stretch].vehicles
            if len(company) > 1 and company == before:
                part = found.pop()
                found.append(CompanyPart(vehicle, part.first, leg, company))
            elif len(company) > 1:
                found.append(CompanyPart(vehicle, leg, leg, company))
            before = company
    return found


def write_assignment(plan: Plan, net: RoadNetwork, path: str | os.PathLike[str]) -> None:
    """Write who drives with whom as CSV: a row for each vehicle and part in company.

    Columns are vehicle, origin, destination, departs, arrives, with, position, merges_at,
    merges_time, waits_min (before the merge), separates_at, separates_time, km and the saving in
    the plan's unit. Who drives alone has one row; its columns of company are empty.

    Parameters
    ----------
    plan : Plan
        What is written.
    net : RoadNetwork
        The network it was made on.
    path : path-like
        Of the file; missing folders are made.

    Raises
    ------
    ScenarioError
        A plan of another network, or a file that cannot be written.
    """
    check_plan(plan, net)
    header = (
        "vehicle", "origin", "destination", "departs", "arrives", "with", "position", "merges_at",
        "merges_time", "waits_min", "separates_at", "separates_time", "km", f"saving_{_unit(plan)}",
    )  # fmt: skip
    write_table(check_path(path), header, _assignment(plan, net), DIGITS)


def write_frame(plan: Plan, what: str, path: str | os.PathLike[str]) -> None:
    """Write a table of a plan as CSV: the columns of `plan.to_frame(what)`.

    Parameters
    ----------
    plan : Plan
        What is written.
    what : str
        As `to_frame` has it: "vehicles", "platoons", ...
    path : path-like
        Of the file; missing folders are made. Moments are written to the second.

    Raises
    ------
    ScenarioError
        A table that the plan does not have, or a file that cannot be written.
    """
    frame = plan.to_frame(what)
    columns = [map(_told, frame[column].tolist()) for column in frame.columns]
    write_table(check_path(path), list(frame.columns), zip(*columns, strict=True), DIGITS)


def write_unserved(plan: Plan, path: str | os.PathLike[str]) -> None:
    """Write as CSV which trips could not be planned, and why.

    Parameters
    ----------
    plan : Plan
        A fleet's.
    path : path-like
        Of the file; missing folders are made.

    Raises
    ------
    ScenarioError
        A file that cannot be written.
    """
    unserved = plan.fleet.unserved if plan.fleet is not None else ()
    rows = ((shown(one.vehicle), shown(one.reason)) for one in unserved)
    write_table(check_path(path), ("vehicle", "reason"), rows, DIGITS)


def _unit(plan: Plan) -> str:
    return "m_eq" if plan.unit == "m" else plan.unit


def _assignment(plan: Plan, net: RoadNetwork) -> Iterator[list[Cell]]:
    parts: dict[int, list[CompanyPart]] = {}
    for part in company_parts(plan):
        parts.setdefault(part.vehicle, []).append(part)
    for vehicle, trip in enumerate(plan.trips):
        times = plan.times[vehicle]
        head: list[Cell] = [
            shown(trip.vehicle), shown(trip.origin.name), shown(trip.destination.name),
            _moment(plan, None if times is None else times.departure_s),
            _moment(plan, None if times is None else times.arrival_s),
        ]  # fmt: skip
        if vehicle not in parts:
            yield [*head, *[None] * 9]
        for part in parts.get(vehicle, ()):
            waits = times.waits[part.first] / 60 if times is not None else None
            place, moment = _begin(plan, net, part), _end(plan, net, part)
            others = "; ".join(
                shown(plan.trips[one].vehicle) for one in part.company if one != vehicle
            )
            yield [
                *head, others, part.position, *place, waits, *moment,
                _length_km(plan, part), _saving(plan, part),
            ]  # fmt: skip


def _length_km(plan: Plan, part: CompanyPart) -> float:
    way = plan.ways[part.vehicle][part.first : part.last + 1]
    return sum(plan.stretches[stretch].length_m for stretch in way) / 1000


def _saving(plan: Plan, part: CompanyPart) -> float | None:
    way = plan.ways[part.vehicle][part.first : part.last + 1]
    return _gain([plan.stretches[stretch].share_of(part.vehicle) for stretch in way])


def _gain(shares: Sequence[Share]) -> float | None:
    """Return what company saves in all; None if that is not known of some."""
    gains = [share.gain for share in shares if share.gain is not None]
    return sum(gains) if len(gains) == len(shares) else None


def _begin(plan: Plan, net: RoadNetwork, part: CompanyPart) -> tuple[Cell, Cell]:
    """Return where and when a part begins."""
    times = plan.times[part.vehicle]
    at = None if times is None else times.legs[part.first][0]
    if part.first == 0:
        return shown(plan.trips[part.vehicle].origin.name), _moment(plan, at)
    stretch = plan.stretches[plan.ways[part.vehicle][part.first]]
    return _place(net, stretch, 0), _moment(plan, at)


def _end(plan: Plan, net: RoadNetwork, part: CompanyPart) -> tuple[Cell, Cell]:
    """Return where and when a part ends."""
    times = plan.times[part.vehicle]
    at = None if times is None else times.legs[part.last][1]
    way = plan.ways[part.vehicle]
    if part.last == len(way) - 1:
        return shown(plan.trips[part.vehicle].destination.name), _moment(plan, at)
    return _place(net, plan.stretches[way[part.last]], -1), _moment(plan, at)


def _place(net: RoadNetwork, stretch: Stretch, end: int) -> str:
    """Return what the node nearest to an end of a stretch is called."""
    if not stretch.edges:
        return shown(stretch.access_at)
    ends_late = stretch.span[end] > MIDDLE
    edge = stretch.edges[end]
    return shown(net.place_name(int((net.head if ends_late else net.tail)[edge])))


def _moment(plan: Plan, seconds: float | None) -> str | None:
    if plan.timetable is None or seconds is None:
        return None
    return plan.timetable.clock.iso(seconds)


def _told(cell: object) -> object:
    """Return a cell of a frame as a table has it."""
    if isinstance(cell, datetime):
        whole = (cell + timedelta(microseconds=500_000)).replace(microsecond=0)
        return whole.isoformat(timespec="seconds")
    return shown(cell) if isinstance(cell, str) else cell
