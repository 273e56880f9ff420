"""What any node is called: its junction, its exit, its road and the nearest town."""

from __future__ import annotations

from typing import NamedTuple

from .location import format_position
from .placed import network_below
from .road_network import RoadNetwork
from .towns.surroundings import GEONAMES, TownsAround

__all__ = [
    "NodeName", "NodeNames", "node_name", "place_name", "point_name", "towns_around",
]  # fmt: skip


class NodeName(NamedTuple):
    """What a place is called, and whether GeoNames is to be credited for it."""

    text: str
    from_geonames: bool = False


class NodeNames:
    """Names of nodes that were asked for, each worked out once; kept with a network.

    Parameters
    ----------
    net : RoadNetwork
        Whose nodes.
    """

    def __init__(self, net: RoadNetwork) -> None:
        del net  # it holds this: both would outlive their use together
        self._names: dict[int, NodeName] = {}

    def of(self, net: RoadNetwork, node: int) -> NodeName:
        """Return what a node is called.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        node : int
            Node position.

        Returns
        -------
        NodeName
            As `node_name` says.
        """
        if node not in self._names:
            self._names[node] = _node_name(net, node)
        return self._names[node]

    def from_geonames(self) -> set[str]:
        """Return the names that were asked for and have a town of GeoNames in them.

        Returns
        -------
        set of str
            Names.
        """
        return {name.text for name in self._names.values() if name.from_geonames}


def place_name(net: RoadNetwork, node: int) -> str:
    """Return a name people understand for any node; see `node_name`.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    node : int
        Node position.

    Returns
    -------
    str
        A name.
    """
    return node_name(net, node).text


def node_name(net: RoadNetwork, node: int) -> NodeName:
    """Return a name people understand for any node.

    The junction's name; else road and exit number, with the nearest town; else the road near that
    town; else the coordinates. Towns are those of the map within reach, or else of GeoNames.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    node : int
        Node position.

    Returns
    -------
    NodeName
        `locate` finds the node again by it, or says that there are several of that name.
    """
    return net.attached(NodeNames).of(net, node)


def _node_name(net: RoadNetwork, node: int) -> NodeName:
    if name := net.junction_name(node).strip():
        return NodeName(name)
    at = float(net.lon[node]), float(net.lat[node])
    road = " / ".join(net.incident_refs(node)[:2])
    number = net.exit_number(node).strip()
    if not number:
        return _road_name(net, *at, road)
    town = towns_around(net).nearest(*at)
    if town is None:
        return NodeName(f"{road} exit {number}".strip())
    return NodeName(f"{road} exit {number}, {town.name}".strip(), town.source == GEONAMES)


def _road_name(net: RoadNetwork, lon: float, lat: float, road: str) -> NodeName:
    town = towns_around(net).nearest(lon, lat)
    if town is None:
        return NodeName(f"{road} at {format_position(lon, lat)}".strip())
    return NodeName(f"{road or 'road'} near {town.name}", town.source == GEONAMES)


def point_name(net: RoadNetwork, lon: float, lat: float, road: str = "") -> NodeName:
    """Return a name people understand for a point that is no node.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    lon, lat : float
        The point [deg].
    road : str
        Number or name of the road it lies on; empty for a point beside it.

    Returns
    -------
    NodeName
        With the nearest town, and coordinates by which `locate` finds it again.
    """
    town, position = towns_around(net).nearest(lon, lat), format_position(lon, lat)
    if town is None:
        return NodeName(f"{road} at {position}" if road else position)
    return NodeName(f"{road} near {town.name} ({position})".strip(), town.source == GEONAMES)


def towns_around(net: RoadNetwork) -> TownsAround:
    """Return the towns around a network, the same with places between its junctions as without.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    TownsAround
        Its towns.
    """
    return network_below(net).attached(TownsAround)
