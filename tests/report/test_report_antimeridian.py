"""Plans across 180 degrees: one line on every map, cut lines in files for other programs."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import pytest
import shapely
from icalendar import Calendar
from plan_kinds import timed
from po_valley import THREE, make_plan, po_valley
from test_report_data import compare_tracks, compared, saved, zoned

import platoon_osm as po
from platoon_osm.network.antimeridian import wrapped_deg
from platoon_osm.network.preparing.unrolled import unrolled
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.plans.plan import JointPlan
from platoon_osm.report.document.document import document_of
from platoon_osm.report.document.flows import flow_document_of
from platoon_osm.report.ground.patches import ground_under
from platoon_osm.report.maps.map_view import MapView

SHIFT = 169.0
"""Brescia then lies at 179.2 degrees east and Verona at 179.9, Vicenza at 179.4 west."""

GPX = "{http://www.topografix.com/GPX/1/1}"


def moved(net: RoadNetwork, shift: float) -> RoadNetwork:
    """Return a network moved round the globe, with its towns."""
    there = net.with_columns(
        lon=wrapped_deg(net.lon + shift), shape_lon=wrapped_deg(net.shape_lon + shift)
    )
    points = replace(net.points, lon=wrapped_deg(net.points.lon + shift))
    return replace(there, points=points)


@pytest.fixture(scope="module")
def far() -> tuple[JointPlan, RoadNetwork]:
    net = moved(po_valley(), SHIFT)
    return zoned(timed(make_plan(net, THREE))), net


def lines(document: Any) -> list[Any]:
    stretches = (*document.platoons, *document.solos)
    return [np.array(part.line.degrees()) for one in stretches for part in one.parts]


def test_the_document_is_that_of_any_other_place(
    far: tuple[JointPlan, RoadNetwork], net: RoadNetwork
) -> None:
    here, there = document_of(timed(make_plan(net, THREE)), net), document_of(*far)
    assert len(lines(here)) == len(lines(there)) > 0
    for own, other in zip(lines(here), lines(there), strict=True):
        # A point more or less where a line is simplified at the edge of what may be left out.
        assert np.abs(own[[0, -1]] + (SHIFT, 0.0) - other[[0, -1]]).max() < 1e-4
        assert np.abs(np.diff(other[:, 0])).max() < 1
    pairs = [*zip(here.events, there.events, strict=True)]
    for one, same in zip(here.vehicles, there.vehicles, strict=True):
        pairs += [(one.origin, same.origin), (one.destination, same.destination)]
    for own, other in pairs:
        assert (own.lon + SHIFT, own.lat) == pytest.approx((other.lon, other.lat), abs=2e-6)
    assert [(one.name, one.lat) for one in here.junctions] == [
        (one.name, one.lat) for one in there.junctions
    ]
    assert len(here.basemap.known) == len(there.basemap.known)
    assert MapView([there]).metres_per_pixel == pytest.approx(
        MapView([here]).metres_per_pixel, rel=1e-3
    )


def test_lines_of_flows_are_not_drawn_across_the_world(far: tuple[JointPlan, RoadNetwork]) -> None:
    flows = flow_document_of(*far).flows
    steps = [np.diff(np.array(line.degrees())[:, 0]) for flow in flows for line in flow.lines]
    assert steps
    assert max(np.abs(one).max() for one in steps) < 1


def test_ground_lies_under_roads_on_both_sides() -> None:
    # Chukotka, which the antimeridian crosses.
    at = [(178.0, 67.0), (179.5, 67.2), (-179.5, 67.3), (-178.5, 67.0)]
    lon, lat = np.array(at).T
    net = RoadNetwork.from_edges([0, 1, 2], [1, 2, 3], lon=lon, lat=lat)
    ground = ground_under(unrolled(net), [(178.0, 67.0), (181.5, 67.0)])
    assert ground is not None
    frame = ground.patches[2].frame
    assert frame.west < 178.0 < 181.5 < frame.east < 183.0


def test_files_for_gis_are_cut_there(far: tuple[JointPlan, RoadNetwork], tmp_path: Path) -> None:
    plan, net = far
    frame = po.to_geodataframe(plan, net)
    kinds = set(frame.geometry.geom_type)
    assert kinds == {"LineString", "MultiLineString"}
    po.write_geopackage(plan, net, tmp_path / "plan.gpkg")
    for layer in ("routes", "platoons", "network"):
        found = geopandas.read_file(tmp_path / "plan.gpkg", layer=layer)
        assert set(found.geometry.geom_type) == {"MultiLineString"}
        lines = shapely.get_parts(found.geometry.values)
        west, _, east, _ = shapely.bounds(lines).T
        assert (east - west).max() < 5
        assert np.abs([west, east]).max() == 180
    degrees = sum(
        np.hypot(*(wrapped_deg(np.diff(net.shape(edge), axis=0))).T).sum() for edge in range(net.m)
    )
    assert shapely.length(found.geometry.values).sum() == pytest.approx(degrees)


def test_tracks_stay_on_the_globe_and_their_times_go_on(
    far: tuple[JointPlan, RoadNetwork], tmp_path: Path
) -> None:
    plan, net = far
    for path in po.write_gpx(plan, net, tmp_path):
        for segment in ElementTree.parse(path).getroot().iter(f"{GPX}trkseg"):
            points = list(segment)
            lon = np.array([float(point.get("lon")) for point in points])
            assert lon.min() >= -180
            assert lon.max() < 180
            stamps = [
                np.datetime64(str(point.findtext(f"{GPX}time")).rstrip("Z")) for point in points
            ]
            steps = np.diff(stamps).astype(float)
            # No step takes most of the time, as one across the world would.
            assert len(points) < 9 or steps.max() < 0.5 * steps.sum()


def test_sheets_draw_and_print_it(far: tuple[JointPlan, RoadNetwork], tmp_path: Path) -> None:
    po.write_sheets(*far, tmp_path / "sheets.html")
    text = (tmp_path / "sheets.html").read_text("utf-8")
    assert ", 18" not in text.replace(", 180.", "")
    po.write_sheets(*far, tmp_path / "folder")
    for path in (tmp_path / "folder").glob("*.ics"):
        for event in Calendar.from_ical(path.read_bytes()).walk("VEVENT"):
            assert abs(event["geo"].longitude) <= 180


def test_the_page_saves_what_python_exports(
    visit: Callable[..., Any], far: tuple[JointPlan, RoadNetwork], tmp_path: Path
) -> None:
    plan, net = far
    path = tmp_path / "page.html"
    po.write_html(plan, net, path, title="Torino: Monday")
    opened = visit(path, accept_downloads=True)
    compared(plan, net, opened, tmp_path)
    compare_tracks(plan, net, opened, tmp_path)
    _, data = saved(opened, "ics")
    for event in Calendar.from_ical(data).walk("VEVENT"):
        assert abs(event["geo"].longitude) <= 180
    opened.check(path)
