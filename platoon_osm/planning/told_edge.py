"""An edge as remarks tell of it: its road, and the place where it begins."""

from __future__ import annotations

from ..network.road_network import RoadNetwork

__all__ = ["place_of", "road_of"]


def road_of(net: RoadNetwork, edge: int) -> str:
    """Return what the road of an edge is called.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edge : int
        Edge id.

    Returns
    -------
    str
        Its number, else its name; "a road" where the map tells neither.
    """
    return net.edge_ref(edge) or net.edge_name(edge) or "a road"


def place_of(net: RoadNetwork, edge: int) -> str:
    """Return the place where an edge begins.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edge : int
        Edge id.

    Returns
    -------
    str
        Name of its tail.
    """
    return net.place_name(int(net.tail[edge]))
