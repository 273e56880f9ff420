"""Distances and bearings against pyproj's geodesics."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pyproj import Geod

from platoon_osm.network.geodesy import bearing_deg, distance_m, east_north_m, metres_per_degree

GEOD = Geod(ellps="WGS84")
LONGITUDES = st.floats(-180, 180)
LATITUDES = st.floats(-75, 75)


@settings(max_examples=300, deadline=None)
@given(LONGITUDES, LATITUDES, st.floats(0, 360), st.floats(0.1, 150_000))
def test_distance_is_geodesic_up_to_150_km(lon, lat, azimuth, length):
    lon2, lat2, _ = GEOD.fwd(lon, lat, azimuth, length)
    # A tenth of a millimetre: below it, the degrees themselves have no more digits.
    assert distance_m(lon, lat, lon2, lat2) == pytest.approx(length, rel=1e-6, abs=1e-4)


@settings(max_examples=200, deadline=None)
@given(LONGITUDES, st.floats(-60, 60), st.floats(0, 360), st.floats(150_000, 3_000_000))
def test_distance_is_nearly_geodesic_up_to_3000_km(lon, lat, azimuth, length):
    lon2, lat2, _ = GEOD.fwd(lon, lat, azimuth, length)
    assert distance_m(lon, lat, lon2, lat2) == pytest.approx(length, rel=5e-4)


def test_distance_of_known_cities():
    # Torino to Trieste as the crow flies.
    assert distance_m(7.6869, 45.0703, 13.7768, 45.6495) == pytest.approx(
        GEOD.inv(7.6869, 45.0703, 13.7768, 45.6495)[2], rel=1e-5
    )


def test_distance_of_a_point_to_itself_is_zero():
    assert distance_m(7.5, 45.1, 7.5, 45.1) == 0


def test_distance_broadcasts():
    assert distance_m(np.zeros((3, 1)), 0, np.ones(4), 0).shape == (3, 4)


def test_distance_across_the_date_line():
    assert distance_m(179.99, 0, -179.99, 0) == pytest.approx(
        GEOD.inv(179.99, 0, -179.99, 0)[2], rel=1e-6
    )


@pytest.mark.parametrize("lat", [-60, 0, 45.1, 70])
def test_metres_per_degree(lat):
    step = 1e-3
    across, along = metres_per_degree(lat)
    assert across == pytest.approx(GEOD.inv(0, lat, step, lat)[2] / step, rel=1e-6)
    assert along == pytest.approx(GEOD.inv(0, lat - step, 0, lat + step)[2] / (2 * step), rel=1e-6)


def test_flat_coordinates_measure_a_neighbourhood():
    east, north = east_north_m([10.0, 10.01], [45.0, 45.01], 45.005)
    assert np.hypot(np.diff(east), np.diff(north))[0] == pytest.approx(
        GEOD.inv(10.0, 45.0, 10.01, 45.01)[2], rel=1e-5
    )


@settings(max_examples=200, deadline=None)
@given(st.floats(-170, 170), st.floats(-65, 65), st.floats(0, 360), st.floats(10, 2_000))
def test_bearing_of_short_segments(lon, lat, azimuth, length):
    lon2, lat2, _ = GEOD.fwd(lon, lat, azimuth, length)
    bearing = float(bearing_deg(lon, lat, lon2, lat2))
    assert 0 <= bearing < 360
    assert abs((bearing - azimuth + 180) % 360 - 180) < 0.1


def test_bearings_of_the_compass():
    got = bearing_deg(10, 45, [10, 11, 10, 9], [46, 45, 44, 45])
    assert got == pytest.approx([0, 90, 180, 270])
