"""Random networks for both engines: small and nasty, or larger and planar."""

import numpy as np
from hypothesis import strategies as st

from platoon_osm.network.road_network import RoadNetwork

# Few values, so that ties abound, and sums that floats hold exactly, so that ties are the same.
COSTS = st.sampled_from([0.0, 0.25, 1.0, 1.0, 2.0, 3.5, 1e6, float("inf")])


@st.composite
def networks(draw, most_nodes=12, most_edges=36):
    """Draw a directed multigraph with its weight: parallel edges, loops, islands, closed roads."""
    n = draw(st.integers(1, most_nodes))
    ends = st.tuples(st.integers(0, n - 1), st.integers(0, n - 1))
    pairs = draw(st.lists(ends, max_size=most_edges))
    if draw(st.booleans()):
        pairs += [(b, a) for a, b in pairs]
    xy = draw(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=n, max_size=n))
    net = RoadNetwork.from_edges(
        [a for a, _ in pairs],
        [b for _, b in pairs],
        draw(st.lists(st.sampled_from([0.0, 1.0, 2.0]), min_size=len(pairs), max_size=len(pairs))),
        lon=[x for x, _ in xy],
        lat=[y for _, y in xy],
    )
    weight = draw(st.lists(COSTS, min_size=len(pairs), max_size=len(pairs)))
    return net, np.array(weight, np.float64)


@st.composite
def tied_grids(draw):
    """Draw a grid whose steps cost alike, or nearly so, with some roads closed or free."""
    width, height = draw(st.integers(2, 4)), draw(st.integers(1, 3))
    node = np.arange(width * height).reshape(height, width)
    a = np.concatenate([node[:, :-1].ravel(), node[:-1].ravel()])
    b = np.concatenate([node[:, 1:].ravel(), node[1:].ravel()])
    net = RoadNetwork.from_edges(
        np.concatenate([a, b]), np.concatenate([b, a]), np.ones(2 * len(a)),
        lon=node.ravel() % width / 100, lat=node.ravel() // width / 100,
    )  # fmt: skip
    step = draw(st.sampled_from([1.0, 0.1, 1 / 3, 1e-9, 12345.678]))
    # Apart by far less, less, and more than what counts as equal.
    factor = st.sampled_from([1.0, 1.0, 1 + 1e-14, 1 + 3e-12, 1 + 1e-9, 2.0, 0.0, float("inf")])
    return net, step * np.array(draw(st.lists(factor, min_size=net.m, max_size=net.m)))


@st.composite
def road_like_networks(draw):
    """Draw a small strongly connected network whose weights never tie by accident."""
    n = draw(st.integers(3, 7))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    ring, extra = np.arange(n), draw(st.integers(0, 2 * n))
    tails = np.concatenate([ring, rng.integers(0, n, extra)])
    heads = np.concatenate([np.roll(ring, -1), rng.integers(0, n, extra)])
    lon, lat = rng.uniform(8, 12, n), rng.uniform(44, 46, n)
    net = RoadNetwork.from_edges(tails, heads, rng.uniform(1, 9e4, len(tails)), lon=lon, lat=lat)
    return net, net.length_m * rng.uniform(1, 3, net.m)


def planar(nodes, seed, real=True):
    """Make a triangulation with some roads left out, some one-way, some closed."""
    from scipy.spatial import Delaunay

    rng = np.random.default_rng(seed)
    xy = rng.random((nodes, 2))
    corners = Delaunay(xy).simplices
    pairs = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    pairs = pairs[rng.random(len(pairs)) < 0.5]
    net = RoadNetwork.from_edges(
        *pairs.T, rng.integers(0, 5, len(pairs)).astype(float), lon=xy[:, 0], lat=xy[:, 1]
    )
    weight = rng.random(net.m) if real else rng.integers(0, 9, net.m).astype(float)
    weight[rng.random(net.m) < 0.05] = np.inf
    return net, weight


def walk_cost(net, weight, edges, source, target):
    """Return the cost of a path after checking that it leads where it should."""
    nodes = net.path_nodes(edges)
    if len(edges):
        assert nodes[0] == source
        assert nodes[-1] == target
        assert (net.head[edges[:-1]] == net.tail[edges[1:]]).all()
        assert len(set(nodes.tolist())) == len(nodes), "a path returns to a node"
    else:
        assert source == target
    return float(weight[edges].sum())
