"""A plan as GIS layers: a GeoDataFrame, and a GeoPackage that any GIS opens."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...atomic_file import whole_file
from ...network.road_network import ROAD_CLASSES, RoadNetwork
from ...plans.laid_out import laid_out
from ...plans.plan import Plan
from ...plans.records import Event, Stretch
from ...shown_text import shown
from ..document.checks import check_path
from ..document.findings import moment_of
from ..document.provenance import credits, proof_text
from ..document.roads import roads_of
from ..document.wording import plan_unit
from ..drawing.vehicle_styles import vehicle_styles
from .drawn_lines import drawn_edges, drawn_line, line_layer
from .geopackage import Layer, changed_at, write_layers
from .legs import check_table, leg_columns, leg_rows
from .pauses import pause_columns, pause_rows
from .qgis_styles import STYLES, style_rows

if TYPE_CHECKING:
    import geopandas

__all__ = ["to_geodataframe", "write_geopackage"]

CRS = "EPSG:4326"


def to_geodataframe(plan: Plan, net: RoadNetwork, what: str = "legs") -> geopandas.GeoDataFrame:
    """Return the legs of all vehicles as lines, or their pauses as points, in EPSG:4326.

    A leg that crosses the antimeridian is cut there into a MultiLineString, as RFC 7946 asks for.
    Columns: vehicle, vehicle_role, leg (from 1), role, partners, origin, destination, roads,
    length_m, time_s, fuel_l, cost, cost_unit, inferred_m, attribution. A plan with times adds
    start_time and end_time (ISO 8601), waiting_s, how long the vehicle stands before the leg, and
    break_before_min, how long of that are breaks and rests. Legs without road are left out.

    Pauses are breaks, rests, bans, changes of drivers and waits on the way. Columns: vehicle, leg
    (that follows), purpose, also (what else it is for), start_time, end_time, minutes, place, kind
    (of place), parking, beside_m, spaces, with_vehicles, attribution. A plan without times has
    none.

    Parameters
    ----------
    plan : Plan
        Whose legs they are.
    net : RoadNetwork
        The network it was made on.
    what : {"legs", "pauses"}
        One row for each.

    Returns
    -------
    geopandas.GeoDataFrame
        Shapes with their columns.

    Raises
    ------
    ScenarioError
        A plan of another network, or an unknown table.
    """
    check_table(what)
    if what == "pauses":
        return _pauses(pause_columns(pause_rows(plan, net)))
    rows = leg_rows(plan, net)
    return _lines_frame(leg_columns(plan, rows), [row.line for row in rows])


def write_geopackage(plan: Plan, net: RoadNetwork, path: str | os.PathLike[str]) -> None:
    """Write a plan as a GeoPackage; it appears whole or not at all, the same bytes each time.

    Layers: `routes` (as `to_geodataframe`), `platoons` (stretches of one company), `points`
    (starts, destinations, merges, separations), `pauses` (as `to_geodataframe`, of a plan with
    times), `network` (all edges), `about` (a table: network,
    method, proof, parameters, attribution). `layer_styles` tells QGIS how to show them: as the
    page does.

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
    import pandas as pd

    path = check_path(path)
    routes = to_geodataframe(plan, net)
    laid, cut = laid_out(plan, net)
    platoons = [stretch for stretch in laid.stretches if stretch.together]
    names = [shown(vehicle.vehicle) for vehicle in plan.vehicles]
    data_of = plan.network.extracted or net.source.extracted
    styles = style_rows(
        names, vehicle_styles(names), changed_at(data_of), pauses=plan.timetable is not None
    )
    layers = [
        line_layer("routes", routes),
        line_layer("platoons", _platoons(cut, platoons, names)),
        Layer("points", _points(plan, plan.events, names), "Point"),
        *_pause_layers(plan, net),
        line_layer("network", _network(net)),
        Layer("about", pd.DataFrame(_about(plan, net), columns=["item", "text"]), None),
        Layer(STYLES, styles, None, key="id"),  # QGIS calls it so
    ]
    with whole_file(path, suffixes=(".gpkg",)) as draft:
        write_layers(draft, layers, data_of)


def _lines_frame(columns: Mapping[str, Any], lines: Iterable[Any]) -> geopandas.GeoDataFrame:
    import geopandas

    shapes = [drawn_line(points) for points in lines]
    return geopandas.GeoDataFrame(
        dict(columns), geometry=geopandas.GeoSeries(shapes, crs=CRS), crs=CRS
    )


def _platoons(
    net: RoadNetwork, platoons: Sequence[Stretch], names: Sequence[str]
) -> geopandas.GeoDataFrame:
    return _lines_frame(
        {
            "vehicles": [", ".join(names[i] for i in part.company) for part in platoons],
            "size": np.array([len(part.vehicles) for part in platoons], np.int32),
            "roads": [roads_of(net, part.edges) for part in platoons],
            "length_m": np.array([part.length_m for part in platoons]),
        },
        [net.path_shape(part.edges) for part in platoons],
    )


def _points(plan: Plan, events: Sequence[Event], names: Sequence[str]) -> geopandas.GeoDataFrame:
    import geopandas

    rows: list[tuple[str, str, str, str, int | None, float, float]] = []
    moments: list[float | None] = []
    for name, vehicle, times in zip(names, plan.vehicles, plan.times, strict=True):
        for kind, stop in (("start", vehicle.origin), ("destination", vehicle.destination)):
            rows.append((kind, shown(stop.name), name, "", None, stop.lon, stop.lat))
        moments += [times.departure_s, times.arrival_s] if times else [None, None]
    for event in events:
        at = event.point
        who, others = (", ".join(names[i] for i in group) for group in (event.movers, event.others))
        rows.append((event.kind, shown(at.name), who, others, at.osm_id, at.lon, at.lat))
        moments.append(moment_of(plan, event))
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


def _pause_layers(plan: Plan, net: RoadNetwork) -> list[Layer]:
    if plan.timetable is None:
        return []
    return [Layer("pauses", to_geodataframe(plan, net, "pauses"), "Point")]


def _pauses(columns: Mapping[str, Any]) -> geopandas.GeoDataFrame:
    import geopandas
    import pandas as pd

    told = {name: values for name, values in columns.items() if name not in ("lon", "lat")}
    # Of no pauses, too, a column has its kind.
    typed = {"leg": "int64", "minutes": "float64", "parking": "bool", "beside_m": "float64"}
    return geopandas.GeoDataFrame(
        {
            name: pd.array(values, dtype="Int64")
            if name == "spaces"
            else pd.Series(values, dtype=typed.get(name, "object"))
            for name, values in told.items()
        },
        geometry=geopandas.points_from_xy(columns["lon"], columns["lat"], crs=CRS),
        crs=CRS,
    )


def _time_column(plan: Plan, moments: Sequence[float | None]) -> dict[str, list[str | None]]:
    if plan.timetable is None:
        return {}
    clock = plan.timetable.clock
    return {"time": [None if at is None else clock.iso(at) for at in moments]}


def _network(net: RoadNetwork) -> geopandas.GeoDataFrame:
    import geopandas

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
        geometry=drawn_edges(net),
        crs=CRS,
    )


def _about(plan: Plan, net: RoadNetwork) -> list[tuple[str, str]]:
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
        ("proof", proof_text(plan.proof, plan_unit(plan))),
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
