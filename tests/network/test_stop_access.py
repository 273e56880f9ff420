"""Where a truck leaves the road for a stop: against brute force, and case by case."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import degrees, network
from places import ROOT

import platoon_osm as po
from platoon_osm.network.columns import POINT_KINDS, ROAD_CLASSES
from platoon_osm.network.driving_side import keeps_left
from platoon_osm.network.geodesy import metres_per_degree
from platoon_osm.network.road_network import NamedPoints, RoadNetwork
from platoon_osm.network.stop_access import MEDIAN_M, REACH_M, SAME_M, StopRoads
from platoon_osm.network.stops import stops_along
from platoon_osm.sources.osm.extract import read_osm

MOTORWAY, LINK, TRUNK = (
    ROAD_CLASSES.index(name) for name in ("motorway", "motorway_link", "trunk")
)


def drawn(lines, stops=(), classes=None, countries=None, kind="rest_area", **columns):
    """Return a network of lines [m] (x to the east, y to the north), with stops beside them."""
    nodes, tail, head, lon, lat, first = {}, [], [], [], [], [0]
    for line in lines:
        for x, y in line:
            a, b = degrees(np.array([x], float), np.array([y], float))
            lon.append(float(a[0]))
            lat.append(float(b[0]))
        first.append(len(lon))
        tail.append(nodes.setdefault(tuple(line[0]), len(nodes)))
        head.append(nodes.setdefault(tuple(line[-1]), len(nodes)))
    x, y = np.array(list(nodes), float).T
    node_lon, node_lat = degrees(x, y)
    at = degrees(*np.array(stops, float).reshape(-1, 2).T)
    points = NamedPoints(
        *at, np.full(len(stops), POINT_KINDS.index(kind), np.uint8),
        np.zeros(len(stops), np.int32), np.zeros(len(stops), np.int64),
    )  # fmt: skip
    return RoadNetwork.from_edges(
        tail, head, lon=node_lon, lat=node_lat, shape_first=first, shape_lon=lon, shape_lat=lat,
        road_class=[MOTORWAY] * len(lines) if classes is None else classes, points=points,
        country=["IT"] * len(lines) if countries is None else countries, **columns,
    )  # fmt: skip


def edges_of(stop):
    return [access.edge for access in stop.accesses]


def edge_of(net, begin, end):
    """Return the edge between two places [m]."""
    places = np.column_stack([net.lon, net.lat])
    ends = [
        int(np.argmin(np.hypot(*(places - np.column_stack(degrees(*np.array([at], float).T))).T)))
        for at in (begin, end)
    ]
    (edge,) = np.flatnonzero((net.tail == ends[0]) & (net.head == ends[1])).tolist()
    return edge


# -- against brute force -----------------------------------------------------------------------


def brute(net, lon, lat):
    """Return the accesses of a stop by shapely alone: (edge, share, metres, left)."""
    per_lon, per_lat = (float(one) for one in metres_per_degree(lat))
    stop = shapely.Point(0, 0)
    rows = []
    for edge in range(net.m):
        points = (net.shape(edge) - [lon, lat]) * [per_lon, per_lat]
        line = shapely.LineString(points)
        along = line.project(stop)
        before, after = (
            line.interpolate(float(np.clip(along + step, 0, line.length))) for step in (-0.01, 0.01)
        )
        left = shapely.LinearRing([before, after, stop]).is_ccw
        going = np.array([after.x - before.x, after.y - before.y])
        # As shares are: by length on the ellipsoid, where these few kilometres are flat.
        rows.append((line.distance(stop), edge, along / line.length, left, going))
    rows.sort(key=lambda row: row[:2])
    nearest = rows[0]
    if nearest[0] > REACH_M:
        return []
    same = [row for row in rows if row[0] <= nearest[0] + SAME_M]
    at_node = nearest[2] in (0.0, 1.0)
    ending = [row for row in same if row[2] == 1.0]
    inner = [row for row in same if 0 < row[2] < 1]
    if at_node:
        chosen = ending or [same[0]]
    else:
        first = inner[0]
        mirror = [
            row for row in inner[1:]
            if net.tail[row[1]] == net.head[first[1]] and net.head[row[1]] == net.tail[first[1]]
        ]  # fmt: skip
        chosen = [first, *mirror]
    country = net.texts[net.country[chosen[0][1]]]
    if len(chosen) == 1 and chosen[0][3] != (country == "GB"):
        across = [
            row for row in rows
            if row[0] <= MEDIAN_M and row[3] == chosen[0][3] and row[4] @ chosen[0][4] < 0
            and row is not chosen[0]
        ]  # fmt: skip
        alike = [row for row in across if row[0] <= across[0][0] + SAME_M]
        chosen += sorted(alike, key=lambda row: (row[2] == 0.0, row[1]))[:1]
    chosen.sort(key=lambda row: (row[3] != (net.texts[net.country[row[1]]] == "GB"), row[1]))
    return [(row[1], row[2], row[0], row[3]) for row in chosen]


@st.composite
def maps(draw):
    """Draw roads with and without separation that share junctions, and stops near them."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    lines, countries = [], []
    for _ in range(draw(st.integers(1, 4))):
        turn = rng.normal(0, 0.5, 5).cumsum() + rng.uniform(0, 6.3)
        steps = rng.uniform(200, 900, 5)
        path = rng.uniform(-800, 800, 2) + np.cumsum(
            np.column_stack([np.cos(turn), np.sin(turn)]) * steps[:, None], axis=0
        )
        path = [tuple(point) for point in path.round(1)]
        country = draw(st.sampled_from(["IT", "GB", ""]))
        cut = draw(st.integers(1, 3))
        parts = [path[: cut + 1], path[cut:]]
        kind = draw(st.sampled_from(["dual", "single", "one way"]))
        own = list(parts)
        if kind == "single":
            own += [part[::-1] for part in parts]
        elif kind == "dual":
            side = 1 if country == "GB" else -1
            beside = shapely.LineString(path).offset_curve(-side * rng.uniform(10, 40))
            if beside.geom_type == "LineString" and len(beside.coords) > 1:
                own.append([tuple(np.round(point, 1)) for point in beside.coords][::-1])
        lines += own
        countries += [country] * len(own)
    stops = rng.uniform(-2500, 2500, (6, 2))
    close = [np.array(lines[rng.integers(len(lines))][1]) + rng.normal(0, 60, 2) for _ in range(6)]
    return lines, countries, np.vstack([stops, close]).round(1)


@settings(max_examples=40)
@given(maps())
def test_accesses_are_those_of_brute_force(drawing):
    lines, countries, stops = drawing
    net = drawn(lines, stops, countries=countries)
    for stop in net.stops():
        expected = brute(net, stop.lon, stop.lat)
        found = [(a.edge, a.share, a.beside_m, a.side == "left") for a in stop.accesses]
        assert [row[0] for row in found] == [row[0] for row in expected], (stop, expected)
        for one, other in zip(found, expected, strict=True):
            assert one[1:3] == pytest.approx(other[1:3], abs=2e-3)
            # Right behind the end of a road neither side is right or wrong.
            assert one[3] == other[3] or one[1] in (0.0, 1.0)


@pytest.mark.parametrize("path", ["italy-motorways.osm", "california-corridor.osm.pbf"])
def test_on_the_bundled_maps_the_nearest_road_is_that_of_brute_force(path):
    net = read_osm(ROOT / "maps" / path)
    rng = np.random.default_rng(13)
    nodes = rng.integers(0, net.n, 25)
    lon, lat = net.lon[nodes] + rng.normal(0, 2e-3, 25), net.lat[nodes] + rng.normal(0, 2e-3, 25)
    owner = np.repeat(np.arange(net.m), np.diff(net.shape_first))
    points = np.column_stack([net.shape_lon, net.shape_lat])
    boxes = shapely.STRtree(shapely.linestrings(points, indices=owner))
    links = {code for code, name in enumerate(ROAD_CLASSES) if name.endswith("_link")}
    for place, found in zip(
        zip(lon, lat, strict=True), StopRoads(net).accesses(lon, lat), strict=True
    ):
        near = boxes.query(shapely.Point(place).buffer(0.015))
        per_lon, per_lat = (float(one) for one in metres_per_degree(place[1]))
        away = {
            int(edge): shapely.LineString((net.shape(edge) - place) * [per_lon, per_lat]).distance(
                shapely.Point(0, 0)
            )
            for edge in near
        }
        for access in found:
            assert not net.inferred[access.edge]
            if not access.by_link:
                assert access.beside_m == pytest.approx(away[access.edge], abs=0.01)
                nearer = [e for e, d in away.items() if d < access.beside_m - SAME_M - 0.01]
                # Nearer are ramps that lead away alone, or the carriageway on the other side.
                assert len(found) == 2 or all(int(net.road_class[e]) in links for e in nearer)


# -- case by case ------------------------------------------------------------------------------

EAST = [(0, 0), (2000, 0), (4000, 0)]
WEST = [(4000, 30), (2000, 30), (0, 30)]


def test_a_stop_at_a_dual_carriageway_is_reached_from_its_own_side():
    net = drawn([EAST, WEST], [(1000, -60), (1000, 90), (1000, -1100), (3000, -999)])
    south, north, far, near = net.stops()
    assert (edges_of(south), edges_of(north)) == ([edge_of(net, (0, 0), (4000, 0))],
                                                  [edge_of(net, (4000, 30), (0, 30))])  # fmt: skip
    assert (south.share, south.beside_m) == pytest.approx((0.25, 60), abs=0.01)
    assert (north.share, north.beside_m) == pytest.approx((0.75, 60), abs=0.01)
    assert (south.side, north.side) == ("right", "right")
    assert (far.accesses, far.access_edge, far.share, far.beside_m, far.side) == ((), *[None] * 4)
    assert near.beside_m == pytest.approx(999, abs=0.1)


def test_between_the_carriageways_it_is_reached_from_both():
    lines = [EAST, [(4000, 200), (2000, 200), (0, 200)]]
    (stop,) = drawn(lines, [(1000, 90)]).stops()
    assert sorted((a.side, round(a.beside_m)) for a in stop.accesses) == [
        ("left", 90),
        ("left", 110),
    ]
    # Where people drive on the left, the same drawing has it outside of both.
    (stop,) = drawn(lines, [(1000, 90)], countries=["GB", "GB"]).stops()
    assert [(a.side, round(a.beside_m)) for a in stop.accesses] == [("left", 90)]
    # Right in the middle both carriageways are equally near.
    (stop,) = drawn(lines, [(1000, 100)]).stops()
    assert len({a.edge for a in stop.accesses}) == 2


def test_a_road_of_one_direction_serves_a_stop_on_either_side():
    stops = drawn([EAST], [(1000, -60), (1000, 60)]).stops()
    assert [(len(stop.accesses), stop.side) for stop in stops] == [(1, "right"), (1, "left")]


def test_a_road_without_separation_serves_both_directions():
    net = drawn([EAST, EAST[::-1]], [(1000, -60)], classes=[TRUNK] * 2)
    (stop,) = net.stops()
    assert [(a.side, round(a.share, 3)) for a in stop.accesses] == [("right", 0.25), ("left", 0.75)]
    assert len({a.edge for a in stop.accesses}) == 2


def test_where_the_nearest_point_is_a_junction_the_edges_that_end_there_serve_it():
    lines = [[(0, 0), (1000, 0)], [(1000, 0), (2000, 500)], [(2000, 500), (3000, 500)]]
    net = drawn(lines, [(1020, -100)])
    (stop,) = net.stops()
    assert (edges_of(stop), stop.share) == ([edge_of(net, (0, 0), (1000, 0))], 1.0)


RAMPS = [
    [(0, 0), (1000, 0)], [(1000, 0), (2000, 0)], [(2000, 0), (4000, 0)],  # eastward, with forks
    WEST,
]  # fmt: skip


def with_ramp(*ramps, stop, ref=None):
    lines = [*RAMPS, *ramps]
    classes = [MOTORWAY] * len(RAMPS) + [LINK] * len(ramps)
    net = drawn(lines, [stop], classes=classes, ref=["A 1"] * len(lines))
    return net, net.stops()[0]


def test_a_ramp_that_ends_at_a_stop_leads_to_it_though_another_road_is_nearer():
    off = [(1000, 0), (1200, -60), (1300, -100)]
    net, stop = with_ramp(off, [(1700, -100), (2000, 0)], stop=(1480, -60))
    (access,) = stop.accesses
    assert (access.edge, access.share) == (edge_of(net, (0, 0), (1000, 0)), 1.0)
    assert (access.by_link, access.side) == (True, "right")
    along = 208.8 + 107.7 + np.hypot(180, 40)
    assert access.beside_m == pytest.approx(along, abs=1)


def test_ramps_from_both_directions_lead_to_a_stop_behind_an_exit():
    off, over = [(1000, 0), (1300, -100)], [(2000, 30), (1600, 200), (1350, -150)]
    lines = [*RAMPS[:3], [(4000, 30), (2000, 30)], [(2000, 30), (0, 30)], off, over]
    net = drawn(lines, [(1400, -200)], classes=[MOTORWAY] * 5 + [LINK] * 2)
    (stop,) = net.stops()
    assert sorted(edges_of(stop)) == sorted(
        [edge_of(net, (0, 0), (1000, 0)), edge_of(net, (4000, 30), (2000, 30))]
    )
    assert all(access.by_link for access in stop.accesses)


def test_a_ramp_beyond_a_road_leads_to_another_stop():
    # On the north side a ramp ends nearer to the southern stop than anything but its own road.
    off = [(2500, 30), (2200, 100)]
    lines = [[(0, 0), (4000, 0)], [(4000, 30), (2500, 30)], [(2500, 30), (0, 30)], off]
    net = drawn(lines, [(2150, -50), (2150, 150)], classes=[MOTORWAY] * 3 + [LINK])
    south, north = net.stops()
    assert edges_of(south) == [edge_of(net, (0, 0), (4000, 0))]
    assert not south.accesses[0].by_link
    assert edges_of(north) == [edge_of(net, (4000, 30), (2500, 30))]
    assert north.accesses[0].by_link


def test_a_ramp_behind_a_ramp_is_followed_back_to_the_road():
    net, stop = with_ramp(
        [(1000, 0), (1200, -60)], [(1200, -60), (1300, -100)], [(1200, -60), (1500, -400)],
        stop=(1400, -120),
    )  # fmt: skip
    assert edges_of(stop) == [edge_of(net, (0, 0), (1000, 0))]


def test_a_ramp_past_a_stop_and_back_to_the_road_is_left_where_it_leaves_the_road():
    net, stop = with_ramp([(1000, 0), (1500, -80), (2000, 0)], stop=(1500, -110))
    assert edges_of(stop) == [edge_of(net, (0, 0), (1000, 0))]
    assert stop.accesses[0].by_link


def test_a_ramp_that_begins_at_no_road_leads_away_from_a_stop():
    net, stop = with_ramp([(1500, -90), (2000, 0)], stop=(1500, -100))
    assert edges_of(stop) == [edge_of(net, (1000, 0), (2000, 0))]
    assert not stop.accesses[0].by_link


def test_across_the_date_line_nothing_changes():
    net = RoadNetwork.from_edges(
        [0], [1], lon=[179.99, -179.99], lat=[-17.0, -17.0], road_class=[MOTORWAY],
        points=NamedPoints(
            np.array([-179.995]), np.array([-17.001]), np.array([0], np.uint8),
            np.array([0], np.int32), np.array([0]),
        ),
    )  # fmt: skip
    (stop,) = net.stops()
    assert stop.share == pytest.approx(0.75, abs=1e-6)
    assert stop.side == "right"


def test_stops_on_a_path_come_in_its_order():
    net = drawn(
        [[(0, 0), (1000, 0)], [(1000, 0), (2000, 0)], WEST],
        [(1500, -50), (250, -50), (750, -50), (500, 90)],
    )
    path = [edge_of(net, (0, 0), (1000, 0)), edge_of(net, (1000, 0), (2000, 0))]
    found = stops_along(net, path)
    assert [round(one.at_m) for one in found] == [250, 750, 1500]
    assert [one.place for one in found] == [0, 0, 1]
    assert [round(one.at_m) for one in stops_along(net, path, (0.5, 0.4))] == [250]
    assert stops_along(net, []) == ()
    with pytest.raises(po.NetworkError, match="edge 99"):
        stops_along(net, [99])


def test_copies_of_an_edge_pass_the_same_stops():
    net = drawn([EAST, WEST], [(1000, -60)])
    twice = net.take([0, 0, 1])
    assert len(twice.stops()) == 1
    for edge in np.flatnonzero(twice.tail == net.tail[net.stops()[0].access_edge]).tolist():
        assert len(stops_along(twice, [edge])) == 1


def test_a_network_without_stops_has_none():
    net = network([(0, 0), (1000, 0)], [(0, 1)])
    assert net.stops() == ()
    assert stops_along(net, [0]) == ()


def test_countries_that_keep_left():
    assert [
        one for one in ("GB", "IE", "MT", "CY", "JP", "AU", "NZ", "IN", "ZA") if not keeps_left(one)
    ] == []
    assert [one for one in ("", "IT", "US-CA", "DE", "CN", "BR", "FR") if keeps_left(one)] == []
