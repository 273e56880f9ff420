"""Synthetic road networks of any size: planar, as sparse as real ones, numbered along a curve."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from platoon_osm.network.road_network import RoadNetwork

__all__ = ["road_like", "shuffled"]

EDGES_PER_NODE = 1.22
"""Undirected; 1.22 in the DIMACS USA graph, 1.18 in its Europe."""
ONE_WAY = 0.1


def road_like(nodes: int, seed: int = 0) -> RoadNetwork:
    """Return a connected planar network: a Delaunay triangulation thinned to a road's density.

    A least spanning tree keeps it in one piece; further edges are drawn at random, short ones
    before long ones. A tenth of these are one-way. Nodes are numbered along a Morton curve, for
    that is the order in which scipy and other engines are fastest too.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import minimum_spanning_tree
    from scipy.spatial import Delaunay

    rng = np.random.default_rng(seed)
    xy = rng.random((nodes, 2))
    xy = xy[np.argsort(_morton(xy))]
    corners = Delaunay(xy).simplices
    pairs = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [0, 2]]]))
    key = np.unique(pairs[:, 0].astype(np.int64) * nodes + pairs[:, 1])
    a, b = key // nodes, key % nodes
    away = np.hypot(*(xy[a] - xy[b]).T) + 1e-12
    tree = minimum_spanning_tree(csr_array((away, (a, b)), shape=(nodes, nodes))).tocoo()
    in_tree = np.isin(
        key, np.minimum(*tree.coords).astype(np.int64) * nodes + np.maximum(*tree.coords)
    )
    rest = np.flatnonzero(~in_tree)
    wanted = max(0, int(EDGES_PER_NODE * nodes) - int(in_tree.sum()))
    luck = rng.random(len(rest)) * away[rest]
    extra = rest[np.argsort(luck)[:wanted]]
    one_way = extra[rng.random(len(extra)) < ONE_WAY]
    forth = np.concatenate([np.flatnonzero(in_tree), extra])
    both = np.setdiff1d(forth, one_way)
    side_m = 1000.0 * np.sqrt(nodes)
    degrees = side_m / 111_000.0
    return RoadNetwork.from_edges(
        np.concatenate([a[forth], b[both]]),
        np.concatenate([b[forth], a[both]]),
        np.concatenate([away[forth], away[both]]) * side_m * 1.2,
        lon=(xy[:, 0] - 0.5) * min(degrees, 60.0),
        lat=(xy[:, 1] - 0.5) * min(degrees, 60.0),
        speed_mps=rng.choice([50 / 3.6, 80 / 3.6, 90 / 3.6], len(forth) + len(both)),
    )


def shuffled(net: RoadNetwork, seed: int = 0) -> RoadNetwork:
    """Return the same network with its nodes numbered at random."""
    number = np.random.default_rng(seed).permutation(net.n)
    node = np.argsort(number)
    return RoadNetwork.from_edges(
        number[net.tail], number[net.head], net.length_m, lon=net.lon[node], lat=net.lat[node],
        speed_mps=net.speed_mps,
    )  # fmt: skip


def _morton(xy: NDArray[np.float64]) -> NDArray[np.uint64]:
    spread = (xy * (1 << 20)).astype(np.uint64)
    for shift, mask in ((16, 0x0000FFFF0000FFFF), (8, 0x00FF00FF00FF00FF),
                        (4, 0x0F0F0F0F0F0F0F0F), (2, 0x3333333333333333),
                        (1, 0x5555555555555555)):  # fmt: skip
        spread = (spread | (spread << np.uint64(shift))) & np.uint64(mask)
    return spread[:, 0] | (spread[:, 1] << np.uint64(1))
