"""Heights and slopes of GIS lines: third coordinates, and columns."""

import geopandas
import pytest
import shapely

from platoon_osm.network.grades import graded_share
from platoon_osm.sources.load import load_network


def load(tmp_path, lines, suffix=".gpkg", **columns):
    table = geopandas.GeoDataFrame(
        {"highway": "primary", **columns},
        geometry=[shapely.LineString(line) for line in lines],
        crs="EPSG:4326",
        index=range(len(lines)),
    )
    table.to_file(tmp_path / f"lines{suffix}")
    return load_network(tmp_path / f"lines{suffix}", classes=["primary"], country="IT")


@pytest.mark.parametrize("suffix", [".gpkg", ".geojson", ".shp"])
def test_third_coordinates_are_heights(tmp_path, suffix):
    net = load(tmp_path, [[(9, 45, 200), (9.01, 45, 230), (9.02, 45, 215)]], suffix)
    rises = sorted(zip(net.climb_m.tolist(), net.descent_m.tolist(), strict=True))
    assert rises == [(15, 30), (30, 15)]
    assert graded_share(net).tolist() == pytest.approx([1, 1], abs=1e-6)
    assert net.report().counts["nodes with a height"] == 3


def test_lines_that_all_lie_at_nought_tell_nothing(tmp_path):
    net = load(tmp_path, [[(9, 45, 0), (9.01, 45, 0)], [(9.01, 45, 5), (9.02, 45, 5)]])
    assert graded_share(net).min() == pytest.approx(0.5, abs=1e-3)
    assert not load(tmp_path, [[(9, 45), (9.01, 45)]], ".geojson").graded_m.any()


def test_a_column_of_inclines(tmp_path):
    net = load(tmp_path, [[(9, 45), (9.01, 45)]], incline=["5%"])
    assert sorted(net.climb_m.tolist()) == pytest.approx([0, 0.05 * net.length_m[0]])
