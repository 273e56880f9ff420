"""From the places of trips to a network on which each of them is a node.

A place between two junctions is a node where its edge is cut; one beside the road is a node with
ways of its own to the junctions near. Where every place is at a node, the network is what it was.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..network.access import STANDARD_ACCESS, Access
from ..network.location import Location, RoadPoint
from ..network.preparing.placing import BesideRoad, Cut, placing
from ..network.road_network import RoadNetwork

__all__ = ["PlacedEnd", "PlacedEnds", "placed"]

Way = int | Cut
"""Where a place gets onto the road: a node, or a point on an edge."""


@dataclass(frozen=True, slots=True)
class PlacedEnd:
    """Where a trip may start, or end.

    Attributes
    ----------
    name : str
        As people know it.
    lon, lat : float
        The place asked for [deg].
    nodes : tuple of (int, float)
        Nodes a trip may start or end at, with the distance that counts in the choice of one [m].
    same : frozenset of int
        All nodes that count as the place: these, and of a place beside the road those that its ways
        lead to.
    """

    name: str
    lon: float
    lat: float
    nodes: tuple[tuple[int, float], ...]
    same: frozenset[int]


@dataclass(frozen=True, slots=True, eq=False)
class PlacedEnds:
    """A network with the places of some trips.

    Attributes
    ----------
    net : RoadNetwork
        The network asked for, or one with places between its junctions.
    ends : list of tuple of PlacedEnd, (N, 2)
        Origin and destination of each trip.
    """

    net: RoadNetwork
    ends: list[tuple[PlacedEnd, PlacedEnd]]


def placed(
    net: RoadNetwork,
    locations: Sequence[tuple[Location, Location]],
    access: Access = STANDARD_ACCESS,
) -> PlacedEnds:
    """Put the places of trips on a network.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    locations : sequence of tuple of Location, (N, 2)
        Origin and destination of each trip.
    access : Access
        How long the ways to places beside the road are, and how fast they are driven.

    Returns
    -------
    PlacedEnds
        With the network itself where every place is at a node.
    """
    cuts: list[Cut] = []
    beside: dict[tuple[object, ...], BesideRoad] = {}
    for origin_and_destination in locations:
        for leaves, one in zip((True, False), origin_and_destination, strict=True):
            if one.beside_road:
                key = _key(one, leaves)
                beside.setdefault(key, _beside(net, one, leaves, access))
            cuts += [way for point in one.on_road if not isinstance(way := _way(net, point), int)]
    if not cuts and not beside:
        return PlacedEnds(net, [(_at_nodes(start), _at_nodes(end)) for start, end in locations])
    made = placing(net, cuts, list(beside.values()))
    stops = dict(zip(beside, made.beside, strict=True))

    def place(one: Location, leaves: bool) -> PlacedEnd:
        if one.beside_road:
            key = _key(one, leaves)
            ways = [way for way, _ in beside[key].ways]
            near = {way if isinstance(way, int) else made.node_of[way] for way in ways}
            own = stops[key]
            return PlacedEnd(one.name, one.lon, one.lat, ((own, 0.0),), frozenset(near | {own}))
        if one.on_road:
            ways = [_way(net, point) for point in one.on_road]
            on = dict.fromkeys(way if isinstance(way, int) else made.node_of[way] for way in ways)
            nodes = tuple((node, 0.0) for node in on)
            return PlacedEnd(one.name, one.lon, one.lat, nodes, frozenset(on))
        return _at_nodes(one)

    ends = [(place(start, True), place(end, False)) for start, end in locations]
    return PlacedEnds(made.net, ends)


def _at_nodes(one: Location) -> PlacedEnd:
    nodes = one.candidates
    return PlacedEnd(one.name, one.lon, one.lat, nodes, frozenset(node for node, _ in nodes))


def _key(one: Location, leaves: bool) -> tuple[object, ...]:
    # Two trips from one place share its node, so that they can start together.
    return one.lon, one.lat, one.candidates, one.enters, leaves


def _beside(net: RoadNetwork, one: Location, leaves: bool, access: Access) -> BesideRoad:
    away: dict[Way, float] = dict(one.candidates)
    away |= {_way(net, point): point.distance_m for point in one.enters}
    ways = tuple((way, metres * access.detour) for way, metres in away.items())
    return BesideRoad(one.lon, one.lat, leaves, ways, access.speed_mps)


def _way(net: RoadNetwork, point: RoadPoint) -> Way:
    """Return the node that a point of the road is at, else its cut."""
    if point.share <= 0.0:
        return int(net.tail[point.edge])
    return int(net.head[point.edge]) if point.share >= 1.0 else (point.edge, point.share)
