"""Longitudes across 180 degrees: wherever a network lies on the globe, it is the same network."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pyproj import Geod

from platoon_osm import Access, PaperCosts, Problem, Trip, paper_weights, plan_joint
from platoon_osm.network.antimeridian import (
    continued_deg,
    cut_at_antimeridian,
    mean_longitude_deg,
    middle_longitude_deg,
    near_deg,
    wrapped_deg,
)
from platoon_osm.network.geodesy import bearing_deg
from platoon_osm.network.place_index import PlaceIndex
from platoon_osm.network.preparing.inferred_links import infer_links
from platoon_osm.network.preparing.placing import BesideRoad, placing
from platoon_osm.network.preparing.simplify import merge_chains
from platoon_osm.network.preparing.split import split_edges
from platoon_osm.network.preparing.unrolled import unrolled
from platoon_osm.network.road_network import RoadNetwork, format_position
from platoon_osm.network.road_points import road_points
from platoon_osm.network.texts import TextTable
from platoon_osm.search.hierarchy.preparing.order import contraction_order, neighbours
from platoon_osm.study.road_trips import RoadTrips

GEOD = Geod(ellps="WGS84")
SHIFTS = st.one_of(st.floats(-360, 360), st.floats(166, 174), st.floats(-196, -186))
"""Networks lie between 8 and 12 degrees east: the last two put them on the antimeridian."""


def turned(net, shift):
    """Return a network moved round the globe."""
    return net.with_columns(
        lon=wrapped_deg(net.lon + shift), shape_lon=wrapped_deg(net.shape_lon + shift)
    )


@st.composite
def shaped_networks(draw):
    """Strongly connected, with bends, lengths measured along them."""
    n = draw(st.integers(4, 8))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    lon, lat = rng.uniform(8, 12, n), rng.uniform(-20, -16, n)
    ring = np.arange(n)
    tails = np.concatenate([ring, rng.integers(0, n, n)])
    heads = np.concatenate([np.roll(ring, -1), rng.integers(0, n, n)])
    loops = tails == heads
    tails, heads = tails[~loops], heads[~loops]
    shapes = []
    for tail, head in zip(tails, heads, strict=True):
        bends = rng.uniform((8, -20), (12, -16), (rng.integers(0, 4), 2))
        shapes.append(np.vstack([(lon[tail], lat[tail]), bends, (lon[head], lat[head])]))
    points = np.vstack(shapes)
    return RoadNetwork.from_edges(
        tails, heads, lon=lon, lat=lat, shape_lon=points[:, 0], shape_lat=points[:, 1],
        shape_first=np.concatenate([[0], np.cumsum([len(shape) for shape in shapes])]),
    )  # fmt: skip


def same_roads(own, moved, shift):
    assert (own.n, own.m) == (moved.n, moved.m)
    assert np.array_equal(own.head, moved.head)
    assert np.allclose(own.length_m, moved.length_m, rtol=1e-9, atol=1e-5)
    assert np.array_equal(own.shape_first, moved.shape_first)
    for before, after in ((own.lon, moved.lon), (own.shape_lon, moved.shape_lon)):
        assert np.abs(after).max() <= 180
        assert np.allclose(wrapped_deg(after - before - shift), 0, atol=1e-9)
    assert np.allclose(own.shape_lat, moved.shape_lat, atol=1e-9)


@settings(max_examples=40, deadline=None)
@given(shaped_networks(), SHIFTS, st.integers(0, 2**32 - 1))
def test_a_network_moved_round_the_globe_stays_the_same(net, shift, seed):
    moved = turned(net, shift)
    rng = np.random.default_rng(seed)
    lengths = RoadNetwork.from_edges(
        moved.tail, moved.head, lon=moved.lon, lat=moved.lat, shape_first=moved.shape_first,
        shape_lon=moved.shape_lon, shape_lat=moved.shape_lat,
    ).length_m  # fmt: skip
    assert np.allclose(lengths, net.length_m, rtol=1e-9)

    edges = rng.integers(0, net.m, 5)
    along = rng.uniform(0.05, 0.95, 5) * net.length_m[edges]
    (own, own_nodes), (other, other_nodes) = (
        split_edges(one, edges, along) for one in (net, moved)
    )
    assert np.array_equal(own_nodes, other_nodes)
    same_roads(own, other, shift)

    cuts = list(zip(edges.tolist(), rng.uniform(0.05, 0.95, 5).round(6).tolist(), strict=True))
    place = float(rng.uniform(8, 12)), float(rng.uniform(-20, -16))
    beside = [
        BesideRoad(float(lon), place[1], True, ((cuts[0], 2_000.0), (0, 3_000.0)), 10.0)
        for lon in (place[0], wrapped_deg(place[0] + shift))
    ]
    same_roads(placing(net, cuts, beside[:1]).net, placing(moved, cuts, beside[1:]).net, shift)

    usable = np.ones(net.m, bool)
    near = road_points(net, usable, *place)
    there = road_points(moved, usable, float(wrapped_deg(place[0] + shift)), place[1])
    assert np.array_equal(near.edges, there.edges)
    assert near.away_m == pytest.approx(there.away_m, rel=1e-6, abs=1e-3)
    assert near.share == pytest.approx(there.share, abs=1e-6)

    same_roads(merge_chains(net), merge_chains(moved), shift)

    plane = unrolled(moved)
    assert np.abs(np.diff(plane.shape_lon)).max() < 180
    assert np.allclose(np.ptp(plane.lon), np.ptp(net.lon), atol=1e-9)
    assert np.allclose(np.diff(plane.shape_lon), np.diff(net.shape_lon), atol=1e-9)


@settings(max_examples=12, deadline=None)
@given(shaped_networks(), SHIFTS)
def test_plans_cost_the_same_wherever_the_network_lies(net, shift):
    moved = turned(net, shift)
    points = [(9.0, -17.0), (11.0, -19.0), (8.5, -18.5), (11.5, -16.5)]
    costs = []
    for one, by in ((net, 0.0), (moved, shift)):
        places = [(float(wrapped_deg(lon + by)), lat) for lon, lat in points]
        weights = paper_weights(one, PaperCosts())
        trips = [Trip("A", places[0], places[1]), Trip("B", places[2], places[3])]
        plan = plan_joint(Problem(one, trips, weights, access=Access(limit_km=2_000.0)))
        costs.append((plan.solo_cost, plan.joint_cost))
    assert costs[0] == pytest.approx(costs[1], rel=1e-6)


@settings(max_examples=100, deadline=None)
@given(st.floats(-180, 180), st.floats(-60, 60), st.floats(0, 360), st.floats(100, 20_000))
def test_bearings_point_the_short_way_round(lon, lat, azimuth, length):
    lon2, lat2, _ = GEOD.fwd(lon, lat, azimuth, length)
    off = (bearing_deg(lon, lat, lon2, lat2) - azimuth + 180) % 360 - 180
    assert abs(off) < 0.5


@given(st.lists(st.floats(-180, 180), min_size=1, max_size=8))
def test_the_band_round_the_middle_is_the_narrowest(lon):
    middle = middle_longitude_deg(lon)
    band = near_deg(lon, middle)
    # Brute force: begin the band at each of the points.
    narrowest = min(max((np.array(lon) - west) % 360) for west in lon)
    assert np.ptp(band) <= narrowest + 1e-9
    assert np.allclose((band - lon) % 360 % 360, 0, atol=1e-9) or np.allclose(
        np.minimum((band - lon) % 360, 360 - (band - lon) % 360), 0, atol=1e-9
    )


@given(st.lists(st.floats(-89, 89), min_size=1, max_size=8))
def test_longitudes_away_from_the_antimeridian_are_not_touched(lon):
    assert np.array_equal(near_deg(lon, middle_longitude_deg(lon)), lon)
    assert np.array_equal(continued_deg(lon), lon)
    assert mean_longitude_deg(lon) == np.mean(lon)


def test_each_line_is_counted_on_from_its_own_beginning():
    lon = np.array([179.0, -179.0, 178.0, -179.0, 179.0, -170.0])
    assert continued_deg(lon, np.array([0, 3, 6])).tolist() == [179, 181, 178, -179, -181, -170]
    assert mean_longitude_deg([179.0, -178.0]) == -179.5


@given(
    st.lists(
        st.tuples(st.integers(-720, 720), st.integers(-50, 50)), min_size=2, max_size=8, unique=True
    )
)
def test_a_cut_line_has_all_of_the_line_and_stays_on_the_globe(points):
    steps = np.array(points, float)
    # Half degrees, so that points lie on the antimeridian itself too; steps of less than a turn.
    line = np.column_stack([170 + steps[:, 0].cumsum() / 40 % 25, steps[:, 1]])
    pieces = cut_at_antimeridian(line)
    assert all(np.abs(piece[:, 0]).max() <= 180 and len(piece) > 1 for piece in pieces)
    for before, after in pairwise(pieces):
        assert (before[-1, 0], abs(after[0, 0])) == (-after[0, 0], 180)
        assert before[-1, 1] == after[0, 1]
    length = sum(np.hypot(*np.diff(piece, axis=0).T).sum() for piece in pieces)
    assert length == pytest.approx(np.hypot(*np.diff(line, axis=0).T).sum())


def test_a_line_is_cut_where_it_crosses_and_only_there():
    crossing = cut_at_antimeridian([(179.0, 0.0), (-179.0, 2.0)])
    assert [piece.tolist() for piece in crossing] == [
        [[179.0, 0.0], [180.0, 1.0]], [[-180.0, 1.0], [-179.0, 2.0]],
    ]  # fmt: skip
    for whole in ([(179.0, 0.0), (180.0, 1.0)], [(-180.0, 0.0), (-179.0, 1.0)]):
        assert [piece.tolist() for piece in cut_at_antimeridian(whole)] == [list(map(list, whole))]


def test_positions_are_printed_within_the_globe():
    assert format_position(180.25, -17.0) == format_position(-179.75, -17.0)
    assert format_position(180.0, -17.0) == "17.000 S 180.000 E"


def around_180(shift=0.0):
    """Return two carriageways whose ends do not meet, a crossing road, and named junctions."""
    lon = wrapped_deg(np.array([179.9, 179.9995, 180.0005, 180.1, 179.99985, 180.00015]) + shift)
    return RoadNetwork.from_edges(
        [0, 2, 4], [1, 3, 5], lon=lon, lat=[-17.0, -17.0, -17.0, -17.0, -17.1, -16.9],
        node_name=[0, 1, 1, 0, 0, 0], texts=TextTable.from_strings(["", "Date Line"]),
        speed_mps=20.0,
    )  # fmt: skip


@pytest.mark.parametrize("shift", [0.0, -0.04, 0.0003])
def test_connectors_are_inferred_across_it(shift):
    here, away = infer_links(around_180(shift)), infer_links(around_180(-60.0))
    assert here.inferred.sum() == away.inferred.sum() > 0
    assert np.allclose(wrapped_deg(here.lon - away.lon - 60.0 - shift), 0, atol=1e-8)


def test_a_junction_on_both_sides_has_one_place_between():
    (place,) = PlaceIndex(around_180()).called("date line")
    assert abs(place.lon) == pytest.approx(180.0)


def grid(shift):
    x, y = (part.ravel() for part in np.meshgrid(np.arange(60), np.arange(20)))
    at = np.arange(len(x)).reshape(20, 60)
    pairs = np.vstack([
        np.column_stack([at[:, :-1].ravel(), at[:, 1:].ravel()]),
        np.column_stack([at[:-1].ravel(), at[1:].ravel()]),
    ])  # fmt: skip
    return pairs, wrapped_deg(x / 16 - 2 + shift), y / 16


def test_nodes_are_contracted_in_the_same_order_and_lie_in_the_same_plane():
    orders = []
    for shift in (0.0, 180.0):
        pairs, lon, lat = grid(shift)
        orders.append(contraction_order(*neighbours(len(lon), *pairs.T.astype(np.int32)), lon, lat))
    assert np.array_equal(*orders)
    places = []
    for shift in (0.0, 180.0):
        pairs, lon, lat = grid(shift)
        net = RoadNetwork.from_edges(*np.vstack([pairs, pairs[:, ::-1]]).T, lon=lon, lat=lat)
        trips = RoadTrips(net, 3, spawn_diameter_m=50_000.0, min_route_m=50_000.0)
        draw = trips.draw(np.random.default_rng(1))
        places.append((draw.x_m, draw.y_m))
    assert np.allclose(places[0], places[1], atol=1e-3)
