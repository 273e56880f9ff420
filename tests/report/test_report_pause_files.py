"""Breaks, rests and waits in GPX, CSV, GeoPackage and GeoJSON: opened again, as in the plan."""

from __future__ import annotations

import csv
import sqlite3
import xml.etree.ElementTree as ElementTree
from contextlib import closing
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import pytest
from hostile_names import HOSTILE
from paused_plans import day_with_breaks, night
from plan_kinds import plan_kind

import platoon_osm as po
from platoon_osm.csv_tables import safe_cell
from platoon_osm.plans.pauses import PURPOSES
from platoon_osm.plans.plan import Plan
from platoon_osm.report.exporters import EXPORTERS
from platoon_osm.report.exports.qgis_styles import PAUSES
from platoon_osm.shown_text import shown

GPX = "{http://www.topografix.com/GPX/1/1}"
MADE = {"day": day_with_breaks, "night": night}


def told(plan: Plan) -> list[tuple[str, int, str, float]]:
    """What the plan itself says: vehicle, leg, purpose and minutes of each pause."""
    assert plan.timetable is not None
    return [
        (times.vehicle, one.before + 1, one.purposes[0], round((one.end_s - one.start_s) / 60, 2))
        for times in plan.timetable.vehicles
        for one in times.pauses
    ]


@pytest.mark.parametrize("name", MADE)
def test_pauses_as_a_frame_are_those_of_the_plan(name: str) -> None:
    plan, net = MADE[name]()
    assert plan.timetable is not None
    frame = plan.to_geodataframe(net, "pauses")
    assert frame.crs == "EPSG:4326"
    assert list(frame[["vehicle", "leg", "purpose", "minutes"]].itertuples(index=False)) == told(
        plan
    )
    pauses = [one for times in plan.timetable.vehicles for one in times.pauses]
    for row, pause in zip(frame.itertuples(), pauses, strict=True):
        begin = plan.timetable.clock.moment(round(pause.start_s))
        assert row.start_time == begin.isoformat()
        if pause.place is not None:
            assert row.place == shown(pause.place.name)
            assert row.kind == pause.place.kind
            assert row.parking is pause.place.has_parking
            assert row.geometry.x == pytest.approx(pause.place.lon, abs=1e-6)
            assert row.geometry.y == pytest.approx(pause.place.lat, abs=1e-6)
    # Who stands there too is told of both.
    both = frame[frame["with_vehicles"] != ""]
    assert sorted(zip(both["vehicle"], both["with_vehicles"], strict=True)) == [
        ("A", "B"),
        ("B", "A"),
    ]


def test_a_gap_without_a_record_is_a_wait() -> None:
    from datetime import datetime, timedelta

    from platoon_osm.planning.timing.schedule import with_times

    made, net = plan_kind("without times")
    six = datetime(2026, 3, 2, 6)
    trips = [po.Trip(one.vehicle, 0, 1, six, six, six + timedelta(hours=16)) for one in made.trips]
    plan = with_times(made, trips)
    assert plan.timetable is not None
    frame = plan.to_geodataframe(net, "pauses")
    assert set(frame["purpose"]) == {"company"}
    assert frame["minutes"].sum() * 60 == pytest.approx(
        plan.timetable.waiting_s, abs=31 * len(frame)
    )
    # Of one that the plan tells of in part, the rest is one.
    whole, net = day_with_breaks()
    assert whole.timetable is not None
    first, *others = whole.timetable.vehicles
    short = replace(first.pauses[0], start_s=first.pauses[0].start_s + 600)
    cut = replace(first, pauses=(short, *first.pauses[1:]))
    table = replace(whole.timetable, vehicles=(cut, *others))
    frame = replace(whole, timetable=table).to_geodataframe(net, "pauses")
    assert list(frame["purpose"])[:2] == ["company", "break"]
    assert list(frame["minutes"])[:2] == [10, 35]
    bare, net = plan_kind("without times")
    assert len(bare.to_geodataframe(net, "pauses")) == 0


@pytest.mark.parametrize("name", MADE)
def test_legs_tell_the_break_before_them(name: str) -> None:
    plan, net = MADE[name]()
    frame = plan.to_geodataframe(net).set_index(["vehicle", "leg"])
    rests = {"first_part", "second_part", "break", "daily_rest"}
    for vehicle, leg, purpose, minutes in told(plan):
        row = frame.loc[(vehicle, leg)]
        assert row["waiting_s"] / 60 == pytest.approx(minutes, abs=0.01)
        assert row["break_before_min"] == pytest.approx(minutes * (purpose in rests), abs=0.01)
    assert frame["break_before_min"].sum() == pytest.approx(
        sum(minutes for *_, purpose, minutes in told(plan) if purpose in rests), abs=0.05
    )


@pytest.mark.parametrize("name", MADE)
def test_tracks_and_lines_are_seamless_where_an_edge_is_cut(name: str, tmp_path: Path) -> None:
    plan, net = MADE[name]()
    before, _ = plan_kind("three vehicles")
    lines = plan.to_geodataframe(net)
    assert any(0 < share < 1 for one in plan.stretches for share in one.span)
    for vehicle, whole in zip(plan.vehicles, before.vehicles, strict=True):
        own = lines[lines["vehicle"] == vehicle.vehicle]
        for one, other in pairwise(own.geometry):
            assert one.coords[-1] == pytest.approx(other.coords[0], abs=1e-9)
        # Nothing is lost or driven twice.
        assert own["length_m"].sum() == pytest.approx(whole.length_m)
        uncut = before.to_geodataframe(net)
        uncut = uncut[uncut["vehicle"] == vehicle.vehicle]
        degrees = [sum(line.length for line in some.geometry) for some in (own, uncut)]
        assert degrees[0] == pytest.approx(degrees[1], rel=1e-9)
    for path in po.write_gpx(plan, net, tmp_path):
        (track,) = geopandas.read_file(path, layer="tracks").geometry
        for one, other in pairwise(track.geoms):
            assert one.coords[-1] == other.coords[0]


def waypoints(path: Path) -> list[dict[str, str]]:
    root = ElementTree.parse(path).getroot()
    return [
        {child.tag.removeprefix(GPX): child.text or "" for child in point}
        for point in root.iter(f"{GPX}wpt")
    ]


def test_waypoints_tell_when_where_and_with_whom(tmp_path: Path) -> None:
    plan, net = day_with_breaks()
    assert plan.timetable is not None
    zoned = replace(plan.timetable, start=f"{plan.timetable.start}+01:00")
    (path, *_) = po.write_gpx(replace(plan, timetable=zoned), net, tmp_path)
    points = waypoints(path)
    assert [one["name"] for one in points] == [
        "Start: Torino", "Break: Secchia Ovest", "First part of a break",
        "Second part of a break: Uscita 7", "Driving ban: A4 near Udine", "Destination: Trieste",
    ]  # fmt: skip
    assert points[1]["cmt"] == (
        "45 min, 10:16 to 11:01; with B; 1.2 km beside the road; 40 spaces for trucks; also wait"
    )
    assert points[3]["cmt"] == "30 min, 13:06 to 13:36; no parking known here"
    assert points[1]["time"] == "2026-03-02T09:15:54Z"
    assert [one["time"] for one in points] == sorted(one["time"] for one in points)
    # In the order that the schema of GPX asks for.
    assert list(points[1]) == ["time", "name", "cmt", "type"]
    (path, *_) = po.write_gpx(*night(), tmp_path / "night")
    assert waypoints(path)[2]["cmt"] == "11 h 00 min, 23:06 to 10:06 +1 d"


def test_a_geopackage_has_a_layer_with_a_style(tmp_path: Path) -> None:
    plan, net = day_with_breaks()
    path = tmp_path / "plan.gpkg"
    po.write_geopackage(plan, net, path)
    layer = geopandas.read_file(path, layer="pauses")
    assert list(layer.columns) == list(plan.to_geodataframe(net, "pauses").columns)
    assert list(layer["purpose"]) == [purpose for *_, purpose, _ in told(plan)]
    assert set(layer["attribution"]) == {"Made by hand for tests, CC0"}
    with closing(sqlite3.connect(path)) as file:
        ((qml,),) = file.execute(
            "SELECT styleQML FROM layer_styles WHERE f_table_name = 'pauses' AND useAsDefault"
        )
    root = ElementTree.fromstring(qml)
    # What a pause may be for, all of it has a look; not by colour alone.
    assert {one.get("value") for one in root.iter("category")} >= set(PURPOSES)
    assert len({drawn for *_, drawn in PAUSES}) == 5
    po.write_geopackage(plan, net, tmp_path / "again.gpkg")
    assert path.read_bytes() == (tmp_path / "again.gpkg").read_bytes()
    # Without pauses it is empty, and without times there is none.
    for name, layers in (("three vehicles", 1), ("without times", 0)):
        po.write_geopackage(*plan_kind(name), tmp_path / "other.gpkg")
        with closing(sqlite3.connect(tmp_path / "other.gpkg")) as file:
            for table in ("gpkg_contents", "layer_styles"):
                column = "table_name" if table == "gpkg_contents" else "f_table_name"
                found = file.execute(f"SELECT COUNT(*) FROM {table} WHERE {column} = 'pauses'")
                assert found.fetchone() == (layers,)


def test_geojson_keeps_them(tmp_path: Path) -> None:
    plan, net = night()
    path = tmp_path / "pauses.geojson"
    plan.to_geodataframe(net, "pauses").to_file(path, driver="GeoJSON")
    again = geopandas.read_file(path)
    assert list(again["purpose"]) == ["change", "daily_rest", "change"]


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as handle:
        return list(csv.DictReader(handle))


def test_pauses_as_csv(tmp_path: Path) -> None:
    plan, net = day_with_breaks()
    po.write_csv(plan, net, tmp_path / "one.csv", "pauses")
    rows = rows_of(tmp_path / "one.csv")
    assert [
        (row["vehicle"], int(row["leg"]), row["purpose"], float(row["minutes"])) for row in rows
    ] == told(plan)
    frame = plan.to_geodataframe(net, "pauses")
    for row, lon, lat in zip(rows, frame.geometry.x, frame.geometry.y, strict=True):
        assert (float(row["lon"]), float(row["lat"])) == pytest.approx((lon, lat), abs=2e-6)
    EXPORTERS["pauses"].write(plan, net, tmp_path / "other.csv")
    assert (tmp_path / "one.csv").read_bytes() == (tmp_path / "other.csv").read_bytes()
    for write in (po.write_csv, lambda *given: po.to_geodataframe(plan, net, given[3])):
        with pytest.raises(po.ScenarioError, match="table 'naps' is unknown; use one of legs"):
            write(plan, net, tmp_path / "no.csv", "naps")


@pytest.mark.parametrize("start", range(0, len(HOSTILE), 6))
def test_hostile_places_stay_names(start: int, tmp_path: Path) -> None:
    def spoiled(name: str) -> str:
        return HOSTILE[(start + len(name)) % len(HOSTILE)] + name

    plan, net = day_with_breaks(spoiled)
    names = [shown(spoiled(name)) for name in ("Secchia Ovest", "", "Uscita 7")]
    frame = plan.to_geodataframe(net, "pauses")
    assert list(frame["place"])[:3] == names
    po.write_csv(plan, net, tmp_path / "pauses.csv", "pauses")
    rows = rows_of(tmp_path / "pauses.csv")
    assert [row["place"] for row in rows][:3] == [safe_cell(name) for name in names]
    assert all(None not in row for row in rows), "a name made a cell of its own"
    po.write_geopackage(plan, net, tmp_path / "plan.gpkg")
    layer: Any = geopandas.read_file(tmp_path / "plan.gpkg", layer="pauses")
    assert list(layer["place"].fillna(""))[:3] == names
    (path, *_) = po.write_gpx(plan, net, tmp_path)
    texts = [one["name"] for one in waypoints(path)]
    assert texts[1].startswith("Break")
    assert names[0] in texts[1]


def test_along_a_leg_the_clock_runs_on_after_a_pause(tmp_path: Path) -> None:
    plan, net = night("+01:00")
    assert plan.timetable is not None
    (path, *_) = po.write_gpx(plan, net, tmp_path)
    moments = [
        np.array([np.datetime64(str(at.text).rstrip("Z")) for at in segment.iter(f"{GPX}time")])
        for segment in ElementTree.parse(path).getroot().iter(f"{GPX}trkseg")
    ]
    assert all((np.diff(own) >= np.timedelta64(0)).all() for own in moments)
    gaps = [float((b[0] - a[-1]) / np.timedelta64(1, "s")) for a, b in pairwise(moments)]
    times = plan.timetable.vehicles[0]
    assert gaps == pytest.approx(times.waits[1:], abs=1.1)
