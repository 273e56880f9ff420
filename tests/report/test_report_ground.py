"""The ground under maps: how its table is made, how it is cut, and where there is none."""

from __future__ import annotations

import importlib.util
import io
import json
import sys
import tarfile
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from places import ROOT
from po_valley import THREE, make_plan, po_valley
from random_networks import network as made_network

from platoon_osm.errors import NetworkError
from platoon_osm.network.towns.surroundings import GEONAMES_CREDIT
from platoon_osm.report.document.document import document_of
from platoon_osm.report.ground.clipping import Frame, cut_lines, cut_ring
from platoon_osm.report.ground.patches import ground_under
from platoon_osm.report.ground.table import FILE, GroundTable, bundled_ground
from platoon_osm.report.maps.ground_paths import ground_piece
from platoon_osm.report.maps.map_view import MapView
from platoon_osm.report.markup.fragments import written

TABLE = bundled_ground()

# Two countries side by side share the arc 0; a lake in the eastern one; an isle, and a rock.
TOPOLOGY = {
    "type": "Topology",
    "transform": {"scale": [0.01, 0.01], "translate": [10.0, 40.0]},
    "arcs": [
        [[100, 0], [0, 100]],
        [[100, 100], [-100, 0], [0, -100], [100, 0]],
        [[100, 0], [100, 0], [0, 100], [-100, 0]],
        [[140, 40], [20, 0], [0, 20], [-20, 0], [0, -20]],
        [[300, 0], [0, 20], [20, 0], [0, -20], [-20, 0]],
        [[400, 0], [0, 0], [0, 0], [0, 0], [0, 0]],
    ],
    "objects": {
        "countries": {"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "arcs": [[0, 1]]},
            {"type": "MultiPolygon", "arcs": [[[2, ~0], [3]], [[4]], [[5]]]},
            {"type": None},
        ]},
        "land": {"type": "GeometryCollection", "geometries": [
            {"type": "MultiPolygon", "arcs": [[[2, 1], [3]], [[4]], [[5]]]}]},
    },
}  # fmt: skip


@pytest.fixture(scope="module")
def command() -> ModuleType:
    spec = importlib.util.spec_from_file_location("build_ground", ROOT / "maps" / "build_ground.py")
    assert spec
    assert spec.loader
    made = importlib.util.module_from_spec(spec)
    sys.modules["build_ground"] = made
    spec.loader.exec_module(made)
    return made


def packed(path: Path) -> Path:
    with tarfile.open(path, "w:gz") as package:
        for name, data in (("package.json", {"version": "9"}), ("countries-10m.json", TOPOLOGY)):
            text = json.dumps(data).encode()
            row = tarfile.TarInfo(f"package/{name}")
            row.size = len(text)
            package.addfile(row, io.BytesIO(text))
    return path


def signed_area(ring: Any) -> float:
    x, y = np.asarray(ring).T
    return float(np.sum(x[1:] * y[:-1] - x[:-1] * y[1:]) / 2)


def test_the_command_makes_a_table_of_topojson(command: ModuleType, tmp_path: Path) -> None:
    table, left_out = command.from_package(packed(tmp_path / "w.tgz"))
    assert left_out == 1
    assert [round(signed_area(ring), 6) for ring in table.land] == [2.0, -0.04, 0.04]
    assert [line.tolist() for line in table.borders] == [[[11.0, 40.0], [11.0, 41.0]]]
    assert table.about["package"] == "world-atlas 9"
    for name in ("a", "b"):
        command.from_package(tmp_path / "w.tgz")[0].write(tmp_path / f"{name}.npz")
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()
    again = GroundTable.read(tmp_path / "a.npz")
    assert [ring.tolist() for ring in again.land] == [ring.tolist() for ring in table.land]


def test_what_is_broken_is_said_in_a_line(tmp_path: Path) -> None:
    whole = FILE.read_bytes()
    ragged = {**TABLE._columns, "land_size": TABLE._columns["land_size"][1:]}
    np.savez(tmp_path / "ragged.npz", **ragged)
    (tmp_path / "half.npz").write_bytes(whole[: len(whole) // 2])
    for name in ("ragged", "half", "none"):
        with pytest.raises(NetworkError, match="table of coasts cannot be read") as caught:
            GroundTable.read(tmp_path / f"{name}.npz")
        assert "\n" not in str(caught.value)


def test_the_bundled_table_knows_land_from_sea() -> None:
    assert FILE.stat().st_size < 700_000
    land, water = (
        np.array([shapely.Polygon(ring) for ring in TABLE.land if sign * signed_area(ring) > 0])
        for sign in (1, -1)
    )
    places = {
        "Milan": (9.19, 45.46, True), "Sacramento": (-121.49, 38.58, True),
        "Gulf of Genoa": (9.0, 43.9, False), "Caspian": (50.5, 42.0, False),
        "Null Island": (0.0, 0.0, False), "Pole": (100.0, -82.0, True),
    }  # fmt: skip
    for name, (lon, lat, expected) in places.items():
        at = shapely.Point(lon, lat)
        dry = shapely.contains(land, at).any() and not shapely.contains(water, at).any()
        assert dry == expected, name
    assert (FILE.parent / "NOTICE.md").read_text("utf-8").count("public domain")
    assert TABLE.about["package"] in (FILE.parent / "NOTICE.md").read_text("utf-8")


coordinate = st.floats(-10, 10, allow_nan=False).map(lambda x: round(x, 2))


@given(
    st.lists(st.tuples(coordinate, coordinate), min_size=3, max_size=12),
    st.tuples(coordinate, coordinate, st.floats(0.5, 8), st.floats(0.5, 8)),
)
def test_cut_rings_are_what_geos_cuts(points: list[Any], box: tuple[float, ...]) -> None:
    """Around the middle points are sorted by their angle, so that no ring crosses itself."""
    west, south, wide, high = box
    frame = Frame(west, south, west + wide, south + high)
    flat = np.unique(np.array(points), axis=0)
    turn = np.arctan2(*(flat - flat.mean(axis=0)).T)
    ring = flat[np.argsort(turn, kind="stable")]
    ring = np.vstack([ring, ring[:1]])
    polygon = shapely.Polygon(ring) if len(ring) > 3 else None
    if polygon is None or not polygon.is_valid or polygon.area < 1e-3:
        return
    expected = polygon.intersection(shapely.box(*frame)).area
    cut = cut_ring(ring, frame)
    found = signed_area(cut) if len(cut) else 0.0
    assert found == pytest.approx(np.sign(signed_area(ring)) * expected, abs=1e-6)
    if len(cut):
        assert (cut[0] == cut[-1]).all()
        assert cut.min(axis=0) == pytest.approx(np.maximum(cut.min(axis=0), (west, south)))
        assert (cut.max(axis=0) <= (frame.east + 1e-9, frame.north + 1e-9)).all()


def test_land_of_a_patch_is_the_land_there() -> None:
    """Generalised as it is, Italy's patch has the land of the table within two per cent."""
    net = po_valley()
    ground = ground_under(net, [])
    assert ground is not None
    for patch, near in zip(ground.patches, (0.2, 0.03, 0.01), strict=True):
        frame = shapely.box(*patch.frame)
        rings = [shapely.Polygon(ring) for ring in TABLE.land if signed_area(ring) > 0]
        whole = shapely.make_valid(np.array(rings))
        expected = sum(shapely.area(shapely.intersection(whole, frame)))
        found = sum(signed_area([*line.degrees(), line.degrees()[0]]) for line in patch.land)
        assert found == pytest.approx(expected, rel=near)
        for line in (*patch.land, *patch.borders):
            lon, lat = np.array(line.degrees()).T
            step = 1 / patch.steps
            assert lon.min() >= patch.frame.west - step
            assert lon.max() <= patch.frame.east + step
            assert lat.min() >= patch.frame.south - step
            assert lat.max() <= patch.frame.north + step


def grid(lon: float, lat: float, wide: float = 2.0) -> Any:
    """A road of 30 nodes."""
    xs = lon + np.linspace(0, wide, 30)
    xs = (xs + 180) % 360 - 180
    n = np.arange(29)
    return made_network(
        n, n + 1, np.full(29, 5e3), xs, np.full(30, lat) + 0.01 * (np.arange(30) % 3)
    )


@pytest.mark.parametrize(
    ("lon", "lat", "wide"),
    [(0.0, 0.0, 2.0), (-30.0, 40.0, 5.0), (0.0, 0.0, 0.0), (-140.0, -40.0, 9.0), (0.0, -60.0, 1.0)],
)
def test_no_ground_where_there_is_no_land(lon: float, lat: float, wide: float) -> None:
    assert ground_under(grid(lon, lat, wide), [(lon, lat)]) is None


@pytest.mark.parametrize("lon", [177.5, 179.5, -179.9, -177.5])
def test_no_line_runs_across_the_map_at_the_date_line(lon: float) -> None:
    """Chukotka lies on both sides of the date line: it is one land, and no border follows it."""
    ground = ground_under(grid(lon, 66.9, 1.0), [])
    assert ground is not None
    for patch in ground.patches:
        frame = patch.frame
        assert frame.east - frame.west <= 360
        land = shapely.union_all(
            [shapely.make_valid(shapely.Polygon(r.degrees())) for r in patch.land]
        )
        line = 180.0 if frame.west < 180 < frame.east else -180.0
        if frame.west < line < frame.east and patch.steps > 10:
            # No seam: just beside the date line and on it there is land.
            for x in (line - 0.01, line, line + 0.01):
                assert land.buffer(1e-6).contains(shapely.Point(x, 66.9)), (x, frame)
        for border in patch.borders:
            assert np.ptp(np.array(border.degrees())[:, 0]) < 60


def test_ground_at_the_poles_ends_where_the_map_does() -> None:
    ground = ground_under(grid(20.0, -79.0), [])
    assert ground is not None
    assert all(abs(line.degrees()[0][1]) <= 86 for patch in ground.patches for line in patch.land)
    assert all(patch.frame.south >= -85 for patch in ground.patches)


def test_a_plan_has_ground_towns_and_credit_and_the_same_again() -> None:
    net = po_valley()
    plan = make_plan(net, THREE)
    document = document_of(plan, net)
    assert document.ground is not None
    assert GEONAMES_CREDIT in document.provenance.credits
    assert any("Natural Earth" in row.text for row in document.provenance.rows)
    names = [town.name for town in document.towns]
    assert len(set(names)) == len(names)
    assert [town.rank for town in document.towns] == sorted(town.rank for town in document.towns)
    drawn = [written(ground_piece(document_of(plan, net), MapView([document]))) for _ in range(2)]
    assert drawn[0] == drawn[1]
    assert len(drawn[0]) < 16_000


def test_lines_are_cut_at_the_frame() -> None:
    line = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
    cut = cut_lines([line], Frame(1.0, -1.0, 3.0, 5.0))
    assert sorted(part.tolist() for part in cut) == [
        [[1.0, 0.0], [3.0, 0.0]], [[3.0, 4.0], [1.0, 4.0]],
    ]  # fmt: skip
    assert cut_lines([], Frame(0.0, 0.0, 1.0, 1.0)) == []
