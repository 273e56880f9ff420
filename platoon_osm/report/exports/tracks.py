"""Routes for other programs: a GPX file per vehicle, and the legs as CSV."""

from __future__ import annotations

import os
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator, Sequence
from datetime import UTC
from itertools import groupby
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...atomic_file import all_or_none, whole_file
from ...csv_tables import write_table
from ...network.antimeridian import wrapped_deg
from ...network.road_network import RoadNetwork
from ...output_paths import checked_folder
from ...plans.clock import duration
from ...plans.laid_out import laid_out
from ...plans.plan import Plan
from ...plans.records import PlatoonPoint, Stop
from ...plans.timetable import VehicleTimes
from ...plans.vehicles import VehiclePlan
from ...shown_text import shown
from ..document.checks import check_path, check_plan
from ..document.halts import Halt, halts_of
from ..document.provenance import credits
from ..markup.quantities import kilometres
from .file_names import file_stems
from .legs import check_table, leg_columns, leg_rows
from .pauses import pause_columns, pause_rows

__all__ = ["write_csv", "write_gpx"]

Waypoint = tuple[str, Stop | PlatoonPoint | Halt, float | None, str]
"""Kind, place, moment [s] and comment."""

GPX = "http://www.topografix.com/GPX/1/1"

TIMES_LEFT_OUT = "times left out: those of the plan name no time zone, and GPX wants UTC"

DIGITS = 6
"""Of numbers in CSV; more would say more than a plan knows."""

DIGITS_OF_PLACES = 9
"""With degrees among them: 1e-6 of one is a tenth of a metre."""

IN_WORDS = {"platoon": "in platoon", "access": "between the road and a place beside it"}

PAUSES = {
    "weekly_rest": "Weekly rest", "reduced_weekly_rest": "Reduced weekly rest",
    "daily_rest": "Daily rest", "reduced_daily_rest": "Reduced daily rest",
    "break": "Break", "second_part": "Second part of a break",
    "first_part": "First part of a break",
    "change": "Change of drivers", "ban": "Driving ban", "company": "Wait",
}  # fmt: skip
"""What waypoints call a pause, by its purpose."""

BESIDE_M = 50.0
"""A place no farther from the road is at it."""


def write_gpx(plan: Plan, net: RoadNetwork, folder: str | os.PathLike[str]) -> list[Path]:
    """Write a GPX file for each vehicle into a folder, which is made if it is missing.

    Each holds the start, the merge, the separation, planned pauses and the destination as
    waypoints, and the joint route as one track with a segment for each leg. A pause has a comment:
    from when to when by the plan's clock, how far beside the road, and whether parking is known.
    Times are in UTC, as GPX wants them, so they are there if those of the plan have a zone; else a
    line of the description says that they are left out. Files are named as the vehicles are, as far
    as every system takes it: "Torino" is in `torino.gpx`. All appear, or none.

    Parameters
    ----------
    plan : Plan
        What is written.
    net : RoadNetwork
        The network it was made on.
    folder : path-like
        Where they are written.

    Returns
    -------
    list of Path
        What was written.

    Raises
    ------
    ScenarioError
        A plan of another network, or a folder that cannot be written to.
    """
    folder = check_path(folder)
    checked_folder(folder)
    check_plan(plan, net)
    plan, net = laid_out(plan, net)
    halts = halts_of(plan, net)
    ElementTree.register_namespace("", GPX)
    stems = file_stems([vehicle.vehicle for vehicle in plan.vehicles])
    written: list[Path] = []
    with all_or_none():
        for k, (vehicle, stem) in enumerate(zip(plan.vehicles, stems, strict=True)):
            path = folder / f"{stem}.gpx"
            tree = ElementTree.ElementTree(_gpx(plan, net, vehicle, plan.times[k], halts[k]))
            ElementTree.indent(tree, "")
            with whole_file(path, suffixes=(".gpx",)) as draft:
                tree.write(draft, encoding="utf-8", xml_declaration=True)
            written.append(path)
    return written


def _gpx(
    plan: Plan,
    net: RoadNetwork,
    vehicle: VehiclePlan,
    times: VehicleTimes | None,
    halts: Sequence[Halt],
) -> ElementTree.Element:
    stamp = _stamp(plan)
    root = ElementTree.Element(
        f"{{{GPX}}}gpx", version="1.1", creator=f"platoon_osm {shown(plan.version)}".strip()
    )
    about = _child(root, "metadata")
    _child(about, "name", f"{shown(vehicle.vehicle)}: {_ends(vehicle)}")
    left_out = [TIMES_LEFT_OUT] if times is not None and stamp is None else []
    _child(about, "desc", " \u00b7 ".join([*credits(plan, net), *left_out]))
    for kind, place, moment, comment in _waypoints(plan, vehicle, times, halts):
        point = _child(root, "wpt", lat=_degrees(place.lat), lon=_longitude(place.lon))
        if stamp and moment is not None:
            _child(point, "time", stamp(moment))
        name = shown(place.name)
        _child(point, "name", f"{kind}: {name}" if name or not comment else kind)
        if comment:
            _child(point, "cmt", comment)
        _child(point, "type", kind.lower())
    track = _child(root, "trk")
    _child(track, "name", f"{shown(vehicle.vehicle)}: {_ends(vehicle)}")
    _child(
        track,
        "desc",
        # A road that is cut at a pause is one road.
        "; ".join(
            f"{kilometres(sum(leg.length_m for leg in legs))} {IN_WORDS.get(role, 'alone')}"
            for (role, _), legs in groupby(vehicle.legs, key=lambda leg: (leg.role, leg.partners))
        ),
    )
    for number, leg in enumerate(vehicle.legs):
        if leg.edges:
            segment = _child(track, "trkseg")
            shape = net.path_shape(leg.edges)
            moments = None if times is None else _along(shape, *times.legs[number])
            for k, (lon, lat) in enumerate(shape):
                point = _child(segment, "trkpt", lat=_degrees(lat), lon=_longitude(lon))
                if stamp and moments is not None:
                    _child(point, "time", stamp(float(moments[k])))
    return root


def _stamp(plan: Plan) -> Callable[[float], str] | None:
    """Return what writes a moment [s] in UTC; None if the plan has no times or no zone."""
    if plan.timetable is None or plan.timetable.clock.start.utcoffset() is None:
        return None
    clock = plan.timetable.clock
    return lambda at: f"{clock.moment(round(at)).astimezone(UTC):%Y-%m-%dT%H:%M:%S}Z"


def _waypoints(
    plan: Plan, vehicle: VehiclePlan, times: VehicleTimes | None, halts: Sequence[Halt]
) -> Iterator[Waypoint]:
    """Yield kind, place, moment [s] and comment of what a driver looks for on the way."""
    together = [k for k, leg in enumerate(vehicle.legs) if leg.role == "platoon"]
    yield "Start", vehicle.origin, times.departure_s if times else None, ""
    between: list[Waypoint] = []
    if vehicle.merge is not None:
        merges = times.legs[together[0]][0] if times and together else None
        between.append(("Merge", vehicle.merge, merges, ""))
    if vehicle.separation is not None:
        leaves = times.legs[together[-1]][1] if times and together else None
        between.append(("Separation", vehicle.separation, leaves, ""))
    between += [
        (PAUSES[halt.purposes[0]], halt, halt.begin_s, _comment(plan, halt))
        for halt in halts
        if halt.is_planned
    ]
    yield from sorted(between, key=lambda one: one[2] or 0.0)
    yield "Destination", vehicle.destination, times.arrival_s if times else None, ""


def _comment(plan: Plan, halt: Halt) -> str:
    """Return when a pause is, in local time, and where."""
    assert plan.timetable is not None
    clock = plan.timetable.clock
    begin, end = clock.text(halt.begin_s), clock.text(halt.end_s)
    told = [f"{duration(halt.lasts_s)}, {begin} to {end}"]
    if halt.company:
        told.append("with " + ", ".join(shown(plan.trips[k].vehicle) for k in halt.company))
    if halt.beside_m >= BESIDE_M:
        told.append(f"{halt.beside_m / 1000:.1f} km beside the road")
    if halt.capacity is not None:
        told.append(f"{halt.capacity} spaces for trucks")
    if not halt.has_parking and halt.kind != "origin":
        told.append("no parking known here")
    told += [f"also {PAUSES[one].lower()}" for one in halt.purposes[1:]]
    return "; ".join(told)


def _along(shape: NDArray[np.float64], begin: float, end: float) -> NDArray[np.float64]:
    """Return a moment for each point of a leg's line, in proportion to the distance [s]."""
    step = np.diff(shape, axis=0)
    step[:, 0] = wrapped_deg(step[:, 0])
    step[:, 0] *= np.cos(np.radians(shape[:-1, 1]))
    reached = np.concatenate([[0.0], np.cumsum(np.hypot(step[:, 0], step[:, 1]))])
    return begin + (end - begin) * reached / (reached[-1] or 1.0)


def _ends(vehicle: VehiclePlan) -> str:
    return f"{shown(vehicle.origin.name)} \u2013 {shown(vehicle.destination.name)}"


def _degrees(value: float) -> str:
    return f"{float(value):.6f}"


def _longitude(value: float) -> str:
    """Return a longitude as GPX has it: from -180, and below 180."""
    text = _degrees(value)
    return "-180.000000" if text == "180.000000" else text


def _child(
    parent: ElementTree.Element, name: str, text: str | None = None, **attributes: str
) -> ElementTree.Element:
    made = ElementTree.SubElement(parent, f"{{{GPX}}}{name}", attributes)
    made.text = text
    return made


def write_csv(
    plan: Plan, net: RoadNetwork, path: str | os.PathLike[str], what: str = "legs"
) -> None:
    """Write the legs or the pauses of a plan as CSV in UTF-8.

    The columns are those of `to_geodataframe`; pauses have their place as lon and lat. Where a
    spreadsheet would run a text as a formula, it gets an apostrophe.

    Parameters
    ----------
    plan : Plan
        What is written.
    net : RoadNetwork
        The network it was made on.
    path : path-like
        Of the file; missing folders are made.
    what : {"legs", "pauses"}
        One row for each.

    Raises
    ------
    ScenarioError
        A plan of another network, an unknown table, or a file that cannot be written.
    """
    path = check_path(path)
    check_table(what)
    digits = DIGITS
    if what == "pauses":
        columns, digits = pause_columns(pause_rows(plan, net)), DIGITS_OF_PLACES
    else:
        columns = leg_columns(plan, leg_rows(plan, net))
    write_table(path, list(columns), zip(*columns.values(), strict=True), digits)
