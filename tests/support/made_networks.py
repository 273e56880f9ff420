"""Small networks, made by hand and at random, for the tests of this folder."""

import numpy as np
from hypothesis import strategies as st

from platoon_osm.network.geodesy import metres_per_degree
from platoon_osm.network.road_network import POINT_KINDS, ROAD_CLASSES, NamedPoints, RoadNetwork
from platoon_osm.network.texts import TextTable

LON0, LAT0 = 10.0, 45.0
PER_LON, PER_LAT = (float(value) for value in metres_per_degree(LAT0))


def degrees(east_m, north_m):
    """Turn metres from a corner of the plain of the Po into degrees."""
    return LON0 + np.asarray(east_m) / PER_LON, LAT0 + np.asarray(north_m) / PER_LAT


def network(nodes, edges, **columns):
    """Make a network from nodes in metres (east, north) and edges (tail, head).

    An edge may have points between its ends: (tail, head, [(east, north), ...]).
    """
    shapes = [
        [nodes[edge[0]], *(edge[2] if len(edge) > 2 else []), nodes[edge[1]]] for edge in edges
    ]
    points = np.array([point for shape in shapes for point in shape], float).reshape(-1, 2)
    shape_lon, shape_lat = degrees(points[:, 0], points[:, 1])
    lon, lat = degrees(*np.array(nodes, float).reshape(-1, 2).T)
    return RoadNetwork.from_edges(
        [edge[0] for edge in edges],
        [edge[1] for edge in edges],
        columns.pop("length_m", None),
        lon=lon,
        lat=lat,
        shape_first=np.concatenate([[0], np.cumsum([len(shape) for shape in shapes])]),
        shape_lon=shape_lon,
        shape_lat=shape_lat,
        **columns,
    )


def both_ways(pairs):
    return [edge for a, b in pairs for edge in ((a, b), (b, a))]


def small_italy():
    """A two-way road of four towns, a dead end that leads out of it, one that leads in, an island.

    0 Verona - 1 Brescia - 2 Verona (another one, 60 km on) - 3 Agrate; 4 is reached from 1 and
    leads nowhere; 5 leads to 1 and is reached from nowhere; 6 - 7 stand alone.
    """
    nodes = [
        (0, 0), (20_000, 0), (60_000, 0), (90_000, 0), (20_000, 3_000), (20_000, -3_000),
        (50_000, 80_000), (52_000, 80_000),
    ]  # fmt: skip
    edges = [*both_ways([(0, 1), (1, 2), (2, 3), (6, 7)]), (1, 4), (5, 1)]
    texts = ["", "Verona", "Bréscia Ovest", "Agrate", "A4", "A 22;E 45", "Milano", "Łódź",
             "Agrate Brianza", "Frankfurt (Oder)"]  # fmt: skip
    node_name = [1, 2, 1, 3, 0, 0, 9, 0]
    ref = [4, 4, 5, 5, 5, 5, 0, 0, 4, 4]
    points_at = [(88_000, 1_000), (30_000, 500), (31_000, 30_000), (91_000, 2_000)]
    lon, lat = degrees(*np.array(points_at, float).T)
    points = NamedPoints(
        lon,
        lat,
        np.array([POINT_KINDS.index(k) for k in ("city", "services", "town", "town")], np.uint8),
        np.array([6, 1, 7, 3], np.int32),
        np.array([1_400_000, 0, 0, 15_000]),
    )
    return network(
        nodes, edges, node_name=node_name, node_ref=[0] * 8, ref=ref, name=[0] * len(edges),
        texts=TextTable.from_strings(texts), points=points, node_id=100 + np.arange(8),
    )  # fmt: skip


def same_network(one, other):
    """Compare two networks array by array, texts decoded."""
    from dataclasses import fields

    for item in fields(one):
        a, b = getattr(one, item.name), getattr(other, item.name)
        if isinstance(a, np.ndarray):
            np.testing.assert_array_equal(a, b, err_msg=item.name)
            assert a.dtype == b.dtype, item.name
    for item in fields(one.points):
        np.testing.assert_array_equal(
            getattr(one.points, item.name), getattr(other.points, item.name), err_msg=item.name
        )
    assert list(one.texts) == list(other.texts)
    assert one.source == other.source
    assert one.load_report.to_dict() == other.load_report.to_dict()


@st.composite
def random_networks(draw, max_nodes=8, max_edges=20, two_way=None):
    """Networks with parallel edges, self loops, nodes without edges, and shapes of their own."""
    n = draw(st.integers(1, max_nodes))
    node = st.integers(0, n - 1)
    pairs = draw(st.lists(st.tuples(node, node), max_size=max_edges))
    if two_way is None:
        two_way = draw(st.booleans())
    if two_way:
        pairs = both_ways(pairs)
    m = len(pairs)
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    nodes = [tuple(point) for point in rng.uniform(0, 9_000, (n, 2))]
    edges = [
        (a, b, [tuple(point) for point in rng.uniform(0, 9_000, (int(rng.integers(0, 3)), 2))])
        for a, b in pairs
    ]
    strings = ["", "A1", "A2", "Milano"]
    return network(
        nodes,
        edges,
        speed_mps=rng.choice([10.0, 15.0, 22.0], m),
        node_id=rng.permutation(n) + 1_000,
        node_name=rng.choice([0, 0, 0, 3], n),
        node_ref=np.zeros(n),
        road_class=rng.integers(0, len(ROAD_CLASSES), m),
        ref=rng.integers(0, 3, m),
        name=rng.integers(0, 4, m),
        toll=np.full(m, draw(st.booleans())),
        way_id=rng.integers(1, 50, m),
        texts=TextTable.from_strings(strings),
    )
