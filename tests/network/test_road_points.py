"""Points of roads near a place, against shapely; and which of them a place may lie on."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import PER_LAT, PER_LON, both_ways, degrees, network, random_networks

from platoon_osm.errors import NetworkError
from platoon_osm.network.access import Access
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.road_points import points_along, road_points


def at(east, north):
    return tuple(float(value) for value in degrees(east, north))


def flat(net, edge, lat):
    """The line of an edge in metres, on a plane true to scale at a latitude."""
    scale = np.array([PER_LON * np.cos(np.radians(lat)) / np.cos(np.radians(45.0)), PER_LAT])
    return shapely.linestrings(net.shape(edge) * scale), scale


@settings(max_examples=80, deadline=None)
@given(random_networks(), st.floats(-20_000, 20_000), st.floats(-20_000, 20_000))
def test_every_edge_has_its_nearest_point(net, east, north):
    lon, lat = at(east, north)
    found = road_points(net, np.ones(net.m, bool), lon, lat)
    assert len(found.edges) == len(set(found.edges.tolist()))
    away = {}
    for edge in range(net.m):
        line, scale = flat(net, edge, lat)
        place = shapely.Point(np.array([lon, lat]) * scale)
        away[edge] = line.distance(place)
    for edge, share, metres in zip(found.edges.tolist(), found.share, found.away_m, strict=True):
        line, scale = flat(net, edge, lat)
        assert metres == pytest.approx(away[edge], rel=2e-3, abs=0.5)
        # The point at that share is as near as the nearest one.
        point = shapely.Point(points_along(net.shape(edge), np.array([share]))[0][0] * scale)
        place = shapely.Point(np.array([lon, lat]) * scale)
        assert point.distance(place) == pytest.approx(metres, rel=2e-2, abs=1.0)
    near = {edge for edge, metres in away.items() if metres < 5_000}
    assert near <= set(found.edges.tolist())


def test_a_cut_is_where_its_share_of_the_length_is():
    shape = np.array([[9.0, 45.0], [9.1, 45.0], [9.1, 45.2]])
    (first, second), position = points_along(shape, np.array([0.1, 0.9]))
    assert first[1] == pytest.approx(45.0)
    assert second[0] == pytest.approx(9.1)
    assert 0 < position[0] < 1 < position[1] < 2


def test_both_carriageways_and_no_end_of_the_edges_beside():
    # An edge ends 60 m from the place: its end is near, but the place lies on the other edge.
    nodes = [(0, 0), (5_000, 0), (10_000, 0), (10_000, 40), (5_000, 40), (0, 40)]
    net = network(nodes, [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0)])
    found = net.locate(at(5_060, 0))
    assert [net.tail[point.edge] for point in found.on_road] == [1, 3]
    assert [point.distance_m for point in found.on_road] == pytest.approx([0, 40], abs=0.1)
    assert found.on_road[0].share == pytest.approx(60 / 5_000, rel=1e-3)
    assert not found.beside_road


def test_many_short_edges_are_one_road():
    nodes = [(20 * k, 0) for k in range(40)]
    net = network(nodes, both_ways([(k, k + 1) for k in range(39)]))
    found = net.locate(at(405, 3))
    assert len(found.on_road) == 2
    shares = sorted(point.share for point in found.on_road)
    assert shares == pytest.approx([0.25, 0.75], abs=1e-3)


def test_beside_the_road_and_on_it():
    nodes = [(0, 0), (20_000, 0), (40_000, 0)]
    net = network(nodes, both_ways([(0, 1), (1, 2)]))
    assert net.locate(at(15_000, 99)).on_road
    beside = net.locate(at(15_000, 101))
    assert beside.beside_road
    assert not beside.on_road
    assert net.locate(at(15_000, 101), access=Access(on_road_m=200)).on_road
    far = at(15_000, 60_000)
    with pytest.raises(NetworkError, match="60 km from the nearest road of in memory"):
        net.locate(far)
    assert net.locate(far, access=Access(limit_km=70)).beside_road


def test_the_date_line_is_no_wall():
    net = RoadNetwork.from_edges([0, 1], [1, 0], lon=[179.9, -179.9], lat=[-17.0, -17.0])
    for lon in (179.95, -179.95, 180.0, -180.0):
        found = net.locate((lon, -17.0))
        assert found.distance_m < 1
        assert len(found.on_road) == 2
        share = {180.0: 0.5, -180.0: 0.5, 179.95: 0.25, -179.95: 0.75}[lon]
        shares = {point.edge: point.share for point in found.on_road}
        assert shares == pytest.approx({0: share, 1: 1 - share}, abs=1e-6)


@pytest.mark.parametrize("wrong", [None, 50, "near", Access])
def test_what_is_no_access(wrong):
    net = RoadNetwork.from_edges([0, 1], [1, 0], lon=[9.0, 9.1], lat=[45.0, 45.0])
    with pytest.raises(NetworkError, match="give an Access"):
        net.locate((9.05, 45.0), access=wrong)


@pytest.mark.parametrize(
    ("name", "value"),
    [("on_road_m", -1), ("on_road_m", 2_000), ("detour", 0.9), ("speed_kmh", 0), ("limit_km", "x"),
     ("limit_km", float("nan")), ("detour", True), ("speed_kmh", None)],
)  # fmt: skip
def test_numbers_that_are_none(name, value):
    with pytest.raises(NetworkError, match=f"access: {name} is .*; give "):
        Access(**{name: value})


def test_a_location_of_another_network_is_refused():
    net = network([(0, 0), (20_000, 0)], both_ways([(0, 1)]))
    large = network(
        [(20_000 * k, 0) for k in range(9)], both_ways([(k, k + 1) for k in range(8)])
    )  # fmt: skip
    found = large.locate(at(150_000, 0))
    with pytest.raises(NetworkError, match="node"):
        net.locate(found)
