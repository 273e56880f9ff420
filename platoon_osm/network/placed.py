"""A network with places between its junctions: edges cut there, and ways from beside the road.

Nodes and edges of the network below keep what they are. Every node has the position it had, places
come behind them. An edge that was cut lives on in its pieces, and every edge here knows which one
of the network below it is a piece of, and which part.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from .road_network import RoadNetwork

__all__ = ["PlacedNetwork", "access_of", "is_beside", "network_below", "whole_edges"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class PlacedNetwork(RoadNetwork):
    """A network with places between its junctions.

    Attributes
    ----------
    below : RoadNetwork or None
        The network without them.
    below_edge : ndarray of int64, (m,)
        The edge of the network below that each edge is a piece of; -1 for a way from beside the
        road, or to there.
    begins, ends : ndarray of float, (m,)
        Which part of that edge it is, as shares of its length.
    place_edge : ndarray of int64, (p,)
        The edge of the network below on which each place lies; -1 beside the road.
    place_share : ndarray of float, (p,)
        How much of that edge lies before the place.
    """

    below: RoadNetwork | None = None
    below_edge: Index = field(default_factory=lambda: np.zeros(0, np.int64))
    begins: Floats = field(default_factory=lambda: np.zeros(0))
    ends: Floats = field(default_factory=lambda: np.zeros(0))
    place_edge: Index = field(default_factory=lambda: np.zeros(0, np.int64))
    place_share: Floats = field(default_factory=lambda: np.zeros(0))


def network_below(net: RoadNetwork) -> RoadNetwork:
    """Return the network without places between its junctions.

    Parameters
    ----------
    net : RoadNetwork
        With or without them.

    Returns
    -------
    RoadNetwork
        The same network if it has none.
    """
    if isinstance(net, PlacedNetwork) and net.below is not None:
        return net.below
    return net


def is_beside(net: RoadNetwork, node: int) -> bool:
    """Tell whether a node is a place beside the road.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    node : int
        Node position.

    Returns
    -------
    bool
        False for every node of a network without places.
    """
    if not isinstance(net, PlacedNetwork) or net.below is None or node < net.below.n:
        return False
    return bool(net.place_edge[node - net.below.n] < 0)


def access_of(net: RoadNetwork, edges: Index) -> NDArray[np.bool_]:
    """Mark the edges that are ways between the road and places beside it.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edges : ndarray of int64, (k,)
        Edge ids.

    Returns
    -------
    ndarray of bool, (k,)
        None of a network without places.
    """
    if isinstance(net, PlacedNetwork) and net.below is not None:
        marked: NDArray[np.bool_] = net.below_edge[edges] < 0
        return marked
    return np.zeros(len(edges), bool)


def whole_edges(net: RoadNetwork, edges: Index) -> tuple[tuple[int, ...], tuple[float, float]]:
    """Return the edges of the network below along a path, pieces of one joined again.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edges : ndarray of int64, (k,)
        A path of one or more edges, none of them a way from beside the road.

    Returns
    -------
    edges : tuple of int
        Edge ids of the network below.
    span : tuple of float, (2,)
        Where the path begins on the first of them, and ends on the last, as shares of their
        lengths.
    """
    if not isinstance(net, PlacedNetwork) or net.below is None:
        return tuple(edges.tolist()), (0.0, 1.0)
    own = net.below_edge[edges]
    # A piece goes on where the one before it ends; a road driven round and again does not.
    same = (own[1:] == own[:-1]) & (net.begins[edges[1:]] == net.ends[edges[:-1]])
    starts = np.concatenate([[True], ~same])
    span = float(net.begins[edges[0]]), float(net.ends[edges[-1]])
    return tuple(own[starts].tolist()), span
