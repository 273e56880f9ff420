"""A plan as GIS layers: a GeoDataFrame, and a GeoPackage that any GIS opens."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...atomic_file import whole_file
from ...network.road_network import ROAD_CLASSES, RoadNetwork
from ...plans.events import platoon_events
from ...plans.records import JointPlan
from ...plans.stretches import platoon_sections
from ..document.document import check_plan
from ..document.provenance import credits, proof_text
from ..document.solo_costs import sum_over
from ..document.timeline import event_time
from ..markup.quantities import cost_unit
from ..markup.shown_text import shown

if TYPE_CHECKING:
    import geopandas

__all__ = ["leg_table", "to_geodataframe", "write_geopackage"]

CRS = "EPSG:4326"


def to_geodataframe(plan: JointPlan, net: RoadNetwork) -> geopandas.GeoDataFrame:
    """Return the legs of all vehicles, one a row, as lines in EPSG:4326.

    Columns: vehicle, vehicle_role, leg (from 1), role, partners, origin, destination, roads,
    length_m, time_s, fuel_l, cost, cost_unit, inferred_m, attribution. A plan with times adds
    start_time and end_time (ISO 8601) and waiting_s, the wait before the leg. Legs without road
    are left out.

    Raises
    ------
    ScenarioError
        A plan of another network.
    """
    columns, lines = leg_table(plan, net)
    return _lines_frame(columns, lines)


def leg_table(plan: JointPlan, net: RoadNetwork) -> tuple[dict[str, list[Any]], list[Any]]:
    """Return the columns of `to_geodataframe` and the line of each row, (k, 2) lon and lat."""
    check_plan(plan, net)
    credit = " \u00b7 ".join(credits(plan, net))
    columns: dict[str, list[Any]] = {
        name: []
        for name in (
            "vehicle", "vehicle_role", "leg", "role", "partners", "origin", "destination", "roads",
            "length_m", "time_s", "fuel_l", "cost", "cost_unit", "inferred_m", "attribution",
        )
    }  # fmt: skip
    if plan.timetable is not None:
        columns |= {name: [] for name in ("start_time", "end_time", "waiting_s")}
    lines: list[Any] = []
    for vehicle, times in zip(plan.vehicles, plan.times, strict=True):
        for number, leg in enumerate(vehicle.legs, 1):
            if not leg.edges:
                continue
            lines.append(net.path_shape(leg.edges))
            row: tuple[Any, ...] = (
                shown(vehicle.vehicle), vehicle.role, number, leg.role,
                ", ".join(shown(name) for name in leg.partners), shown(vehicle.origin.name),
                shown(vehicle.destination.name), _roads(net, leg.edges), leg.length_m, leg.time_s,
                leg.fuel_l, leg.cost, shown(plan.unit), leg.inferred_m, credit,
            )  # fmt: skip
            if plan.timetable is not None and times is not None:
                moments = (plan.timetable.clock.iso(at) for at in times.legs[number - 1])
                row += (*moments, times.waits[number - 1])
            for values, value in zip(columns.values(), row, strict=True):
                values.append(value)
    return columns, lines


def write_geopackage(plan: JointPlan, net: RoadNetwork, path: str | os.PathLike[str]) -> None:
    """Write a plan as a GeoPackage; it appears whole or not at all.

    Layers: `routes` (as `to_geodataframe`), `platoons` (stretches of one company), `points`
    (starts, destinations, merges, separations), `network` (all edges), `about` (a table: network,
    method, proof, parameters, attribution).

    Raises
    ------
    ScenarioError
        A plan of another network, or a file that cannot be written.
    """
    import pandas as pd
    import pyogrio

    layers: list[tuple[str, Any, str | None]] = [
        ("routes", to_geodataframe(plan, net), "LineString"),
        ("platoons", _platoons(plan, net), "LineString"),
        ("points", _points(plan), "Point"),
        ("network", _network(net), "LineString"),
        ("about", pd.DataFrame(_about(plan, net), columns=["item", "text"]), None),
    ]
    with whole_file(path, suffix=".gpkg") as draft:
        for name, frame, kind in layers:
            try:
                pyogrio.write_dataframe(
                    frame, draft, layer=name, driver="GPKG", append=draft.exists(),
                    geometry_type=kind,
                )  # fmt: skip
            except pyogrio.errors.DataSourceError as error:
                # As an OSError it is told like any other failure to write.
                raise OSError(f"layer {name}: {str(error).splitlines()[0]}") from error


def _lines_frame(columns: Mapping[str, Any], lines: Iterable[Any]) -> geopandas.GeoDataFrame:
    import geopandas
    import shapely

    shapes = [shapely.linestrings(points) for points in lines]
    return geopandas.GeoDataFrame(
        dict(columns), geometry=geopandas.GeoSeries(shapes, crs=CRS), crs=CRS
    )


def _roads(net: RoadNetwork, edges: Sequence[int]) -> str:
    refs = dict.fromkeys(shown(net.edge_ref(edge)) for edge in edges)
    return ", ".join(ref for ref in refs if ref)


def _platoons(plan: JointPlan, net: RoadNetwork) -> geopandas.GeoDataFrame:
    sections = platoon_sections(plan)
    names = [shown(vehicle.vehicle) for vehicle in plan.vehicles]
    return _lines_frame(
        {
            "vehicles": [", ".join(names[i] for i in part.vehicles) for part in sections],
            "size": np.array([len(part.vehicles) for part in sections], np.int32),
            "roads": [_roads(net, part.edges) for part in sections],
            "length_m": np.array([sum_over(net.length_m, part.edges) for part in sections]),
        },
        [net.path_shape(part.edges) for part in sections],
    )


def _points(plan: JointPlan) -> geopandas.GeoDataFrame:
    import geopandas

    names = [shown(vehicle.vehicle) for vehicle in plan.vehicles]
    rows: list[tuple[str, str, str, str, int | None, float, float]] = []
    moments: list[float | None] = []
    for name, vehicle, times in zip(names, plan.vehicles, plan.times, strict=True):
        for kind, stop in (("start", vehicle.origin), ("destination", vehicle.destination)):
            rows.append((kind, shown(stop.name), name, "", None, stop.lon, stop.lat))
        moments += [times.departure_s, times.arrival_s] if times else [None, None]
    for event in platoon_events(plan, platoon_sections(plan)):
        at = event.point
        who, others = (", ".join(names[i] for i in group) for group in (event.movers, event.others))
        rows.append((event.kind, shown(at.name), who, others, at.osm_id, at.lon, at.lat))
        moments.append(event_time(plan, event))
    kinds, places, who_all, with_all, ids, lons, lats = zip(*rows, strict=True)
    import pandas as pd

    return geopandas.GeoDataFrame(
        {
            "kind": kinds,
            "name": places,
            "vehicles": who_all,
            "with_vehicles": with_all,
            "osm_id": pd.array(ids, dtype="Int64"),
            **_time_column(plan, moments),
        },
        geometry=geopandas.points_from_xy(lons, lats, crs=CRS),
    )


def _time_column(plan: JointPlan, moments: Sequence[float | None]) -> dict[str, list[str | None]]:
    if plan.timetable is None:
        return {}
    clock = plan.timetable.clock
    return {"time": [None if at is None else clock.iso(at) for at in moments]}


def _network(net: RoadNetwork) -> geopandas.GeoDataFrame:
    import geopandas
    import shapely

    owner = np.repeat(np.arange(net.m), np.diff(net.shape_first))
    texts = [shown(text) for text in net.texts]
    return geopandas.GeoDataFrame(
        {
            "edge": np.arange(net.m),
            "way_id": net.way_id,
            "ref": [texts[code] for code in net.ref],
            "name": [texts[code] for code in net.name],
            "road_class": [ROAD_CLASSES[code] for code in net.road_class],
            "length_m": net.length_m,
            "speed_mps": net.speed_mps,
            "toll": net.toll,
            "inferred": net.inferred,
        },
        geometry=shapely.linestrings(net.shape_lon, net.shape_lat, indices=owner),
        crs=CRS,
    )


def _about(plan: JointPlan, net: RoadNetwork) -> list[tuple[str, str]]:
    identity = plan.network
    rows: list[tuple[str, Any]] = [
        ("attribution", " \u00b7 ".join(credits(plan, net))),
        ("licence", identity.licence),
        ("network", identity.name),
        ("network_sha256", identity.sha256),
        ("network_extracted", identity.extracted),
        ("network_identity", identity.identity),
        ("case", plan.case),
        ("asked", plan.asked),
        ("objective", plan.objective),
        ("method", plan.method),
        ("cost_unit", plan.unit),
        ("proof", proof_text(plan.proof, cost_unit(plan.unit))),
        *(
            [("times", plan.timetable.clock.zone), ("feasible_in_time", plan.timetable.feasible)]
            if plan.timetable
            else []
        ),
        ("made_by", f"platoon_osm {plan.version}".strip()),
        *((f"parameter {name}", value) for name, value in plan.params.items()),
        *(("remark", remark) for remark in plan.remarks),
    ]
    return [(shown(item), shown(text)) for item, text in rows]
