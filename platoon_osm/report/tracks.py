"""Routes for other programs: a GPX file per vehicle, and the legs as CSV."""

from __future__ import annotations

import csv
import os
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

from ..network.road_network import RoadNetwork
from ..planning.plans import JointPlan, VehiclePlan
from ..whole_file import whole_file
from .document import check_plan
from .gis import leg_table
from .provenance import credits
from .quantities import kilometres
from .shown_text import shown
from .vehicle_styles import vehicle_styles

__all__ = ["write_csv", "write_gpx"]

GPX = "http://www.topografix.com/GPX/1/1"

FORMULA_SIGNS = ("=", "+", "-", "@", "\t", "\r")


def write_gpx(plan: JointPlan, net: RoadNetwork, folder: str | os.PathLike[str]) -> list[Path]:
    """Write a GPX file for each vehicle into a folder that exists; return their paths.

    Each holds the start, the merge, the separation and the destination as waypoints, and the
    joint route as one track with a segment for each leg. There are no times in it. Files are
    named by the letters of the report: `vehicle-A.gpx`.

    Raises
    ------
    ScenarioError
        A plan of another network, or a folder that cannot be written to.
    """
    check_plan(plan, net)
    ElementTree.register_namespace("", GPX)
    styles = vehicle_styles([vehicle.vehicle for vehicle in plan.vehicles])
    written: list[Path] = []
    for vehicle, style in zip(plan.vehicles, styles, strict=True):
        path = Path(folder) / f"vehicle-{style.letter}.gpx"
        tree = ElementTree.ElementTree(_gpx(plan, net, vehicle))
        ElementTree.indent(tree, "")
        with whole_file(path, suffix=".gpx") as draft:
            tree.write(draft, encoding="utf-8", xml_declaration=True)
        written.append(path)
    return written


def _gpx(plan: JointPlan, net: RoadNetwork, vehicle: VehiclePlan) -> ElementTree.Element:
    root = ElementTree.Element(
        f"{{{GPX}}}gpx", version="1.1", creator=f"platoon_osm {shown(plan.version)}".strip()
    )
    about = _child(root, "metadata")
    _child(about, "name", f"{shown(vehicle.vehicle)}: {_ends(vehicle)}")
    _child(about, "desc", " \u00b7 ".join(credits(plan, net)))
    points: list[tuple[str, Any]] = [("Start", vehicle.origin)]
    if vehicle.merge is not None:
        points.append(("Merge", vehicle.merge))
    if vehicle.separation is not None:
        points.append(("Separation", vehicle.separation))
    points.append(("Destination", vehicle.destination))
    for kind, place in points:
        point = _child(root, "wpt", lat=_degrees(place.lat), lon=_degrees(place.lon))
        _child(point, "name", f"{kind}: {shown(place.name)}")
        _child(point, "type", kind.lower())
    track = _child(root, "trk")
    _child(track, "name", f"{shown(vehicle.vehicle)}: {_ends(vehicle)}")
    _child(track, "desc", "; ".join(
        f"{kilometres(leg.length_m)} {'in platoon' if leg.role == 'platoon' else 'alone'}"
        for leg in vehicle.legs
    ))  # fmt: skip
    for leg in vehicle.legs:
        if leg.edges:
            segment = _child(track, "trkseg")
            for lon, lat in net.path_shape(leg.edges):
                _child(segment, "trkpt", lat=_degrees(lat), lon=_degrees(lon))
    return root


def _ends(vehicle: VehiclePlan) -> str:
    return f"{shown(vehicle.origin.name)} \u2013 {shown(vehicle.destination.name)}"


def _degrees(value: float) -> str:
    return f"{float(value):.6f}"


def _child(
    parent: ElementTree.Element, name: str, text: str | None = None, **attributes: str
) -> ElementTree.Element:
    made = ElementTree.SubElement(parent, f"{{{GPX}}}{name}", attributes)
    made.text = text
    return made


def write_csv(plan: JointPlan, net: RoadNetwork, path: str | os.PathLike[str]) -> None:
    """Write the legs of a plan as CSV in UTF-8, with the columns of `to_geodataframe`.

    A text that a spreadsheet would run as a formula gets an apostrophe in front of it.

    Raises
    ------
    ScenarioError
        A plan of another network, or a file that cannot be written.
    """
    columns, _ = leg_table(plan, net)
    with (
        whole_file(path, suffix=".csv") as draft,
        draft.open("w", encoding="utf-8", newline="") as handle,
    ):
        writer = csv.writer(handle, lineterminator="\n")
        writer.writerow(columns)
        for row in zip(*columns.values(), strict=True):
            writer.writerow([_cell(value) for value in row])


def _cell(value: Any) -> Any:
    if isinstance(value, str) and value.startswith(FORMULA_SIGNS):
        return f"'{value}"
    return f"{value:.6g}" if isinstance(value, float) else value
