"""From a point to the roads near it: on the road, or beside it with a way to get there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import NetworkError
from .access import STANDARD_ACCESS, Access
from .geodesy import distance_m
from .location import Location, RoadPoint, Role
from .naming import NodeName, node_name, point_name
from .road_network import ROAD_CLASSES, RoadNetwork
from .road_points import DEGREE_M, RoadPoints, road_points
from .usable_nodes import UsableNodes

__all__ = ["MOST_CANDIDATES", "is_closed", "located_at"]

Index = NDArray[np.int64]

OTHER_CARRIAGEWAY_M = 1_500.0
"""How much farther than the nearest node another may be to count as a choice of carriageway."""

OTHER_JUNCTION = 1.5
"""How many times as far as the nearest node another may be to count as a choice of junction."""

NO_JUNCTION_M = 10_000.0
"""If the nearest junction is farther than the road by more than this, one gets onto the road
between junctions: by a service area, or a gate that the map does not have."""

FARTHEST_TOWN_KM = 200.0
"""A town farther than this from any road is not of this map."""

NEAR_DEG = 0.5
"""Junctions are looked for within so much latitude first, 55 km, and only then everywhere."""

MOST_CANDIDATES = 12

MOST_WAYS = 24
"""Ways from a place beside the road to the junctions near, at most."""

CLOSED_CLASSES = ("motorway", "motorway_link", "trunk", "trunk_link", "ferry")
"""Roads that one gets onto at junctions alone; from others there is a gate to every yard."""

CLOSED = tuple(ROAD_CLASSES.index(kind) for kind in CLOSED_CLASSES)

AT_A_NODE = 1e-9
"""Shares of an edge nearer to its ends than this are its ends."""


def located_at(
    net: RoadNetwork,
    lon: float,
    lat: float,
    role: Role,
    name: str | None,
    access: Access = STANDARD_ACCESS,
    usable: UsableNodes | None = None,
) -> Location:
    """Find where a trip may start or end that begins at a point, or in a town.

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    lon, lat : float
        The point [deg].
    role : {"origin", "destination", "any"}
        What the place is to be.
    name : str or None
        What the place is called, if it is a town: then its junctions stand for it, and the way to
        them does not count. None for a point, which stays where it is.
    access : Access
        What counts as on the road, and how far from it a place may be.
    usable : UsableNodes, optional
        The nodes and edges that are open to a vehicle; by default those of all.

    Returns
    -------
    Location
        With the nodes of both carriageways near the point, nearest first; and where the point lies
        on the road, or how it gets onto it.

    Raises
    ------
    NetworkError
        A network without roads, or a point far from all of them.
    """
    nodes = usable or net.attached(UsableNodes)
    fits = nodes.of(role)
    if not fits.any():
        raise NetworkError(
            f"place ({lon}, {lat}): {net.source.name} has no road to start or end on"
        )
    roads = road_points(net, nodes.edges(role), lon, lat)
    road_m = float(roads.away_m.min())
    limit_km = access.limit_km if name is None else FARTHEST_TOWN_KM
    if road_m > limit_km * 1000:
        _refuse(net, lon, lat, road_m, limit_km)
    fitting, away = _nearest_nodes(net, fits, lon, lat)
    nearest = float(away[0])

    def within(limit: float, most: int) -> tuple[tuple[int, float], ...]:
        return tuple(
            (int(fitting[i]), float(away[i])) for i in range(len(away[:most])) if away[i] <= limit
        )

    beside = nearest + OTHER_CARRIAGEWAY_M
    if name is not None:
        nodes_near = within(beside, MOST_CANDIDATES)
        return Location(nodes_near[0][0], name, lon, lat, road_m, nodes_near)
    limit = max(beside, nearest * OTHER_JUNCTION)
    candidates = within(limit, MOST_WAYS)
    node = candidates[0][0]
    mapped = ~net.inferred[roads.edges]
    on_road = _lowest(net, roads, mapped & (roads.away_m <= access.on_road_m))
    if on_road:
        own = _name_on_road(net, on_road[0], lon, lat)
        return Location(
            node, own.text, lon, lat, road_m, candidates, on_road=on_road,
            from_geonames=own.from_geonames,
        )  # fmt: skip
    enters: tuple[RoadPoint, ...] = ()
    if mapped.any():
        near = float(roads.away_m[mapped].min())
        closed = np.isin(net.road_class[roads.edges], CLOSED)
        if nearest > near + NO_JUNCTION_M:
            enters = _lowest(net, roads, mapped & (roads.away_m <= near + OTHER_CARRIAGEWAY_M))
        else:
            enters = _lowest(net, roads, mapped & ~closed & (roads.away_m <= limit))
    own = point_name(net, lon, lat)
    return Location(
        node, own.text, lon, lat, road_m, candidates, enters=enters, beside_road=True,
        from_geonames=own.from_geonames,
    )  # fmt: skip


def _nearest_nodes(
    net: RoadNetwork, fits: NDArray[np.bool_], lon: float, lat: float
) -> tuple[Index, NDArray[np.float64]]:
    """Return nodes and how far they are [m], nearest first, with all that may be a choice."""
    near = np.flatnonzero(fits & (np.abs(net.lat - lat) < NEAR_DEG))
    away = distance_m(net.lon[near], net.lat[near], lon, lat)
    reach = NEAR_DEG * DEGREE_M
    if not len(near) or away.min() * OTHER_JUNCTION + OTHER_CARRIAGEWAY_M > reach:
        near = np.flatnonzero(fits)
        away = distance_m(net.lon[near], net.lat[near], lon, lat)
    order = np.argsort(away, kind="stable")
    return near[order], away[order]


def is_closed(net: RoadNetwork, edge: int) -> bool:
    """Tell whether one gets onto a road at junctions alone.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edge : int
        Edge id.

    Returns
    -------
    bool
        Whether it is a motorway, a trunk road, or a ramp of one.
    """
    return int(net.road_class[edge]) in CLOSED


def _refuse(net: RoadNetwork, lon: float, lat: float, road_m: float, limit_km: float) -> None:
    exchanged = abs(lon) <= 90 and distance_m(net.lon, net.lat, lat, lon).min() < road_m / 10
    raise NetworkError(
        f"place ({lon:g}, {lat:g}): {road_m / 1000:,.0f} km from the nearest road of "
        f"{net.source.name}, more than {limit_km:g} km; "
        + (
            "give longitude first, then latitude"
            if exchanged
            else "load a map of that region, or allow more by access=Access(limit_km=...), "
            "--access-limit-km, or access_limit_km in a scenario"
        )
    )


def _lowest(
    net: RoadNetwork, roads: RoadPoints, chosen: NDArray[np.bool_]
) -> tuple[RoadPoint, ...]:
    """Return the points that are nearer than those beside them on the road, nearest first.

    Where two edges meet, the end of one is near a place that lies on the other, and is no point of
    its own.
    """
    at = np.flatnonzero(chosen)
    if not len(at):
        return ()
    share, edges = roads.share[at], roads.edges[at]
    begins, ends = share <= AT_A_NODE, share >= 1 - AT_A_NODE
    tail, head = net.tail[edges], net.head[edges]
    # A node is such a point if no edge at it has a nearer one.
    passed = set(tail[~begins].tolist()) | set(head[~ends].tolist())
    seen: set[int] = set()
    found = []
    for k in np.argsort(roads.away_m[at], kind="stable").tolist():
        node = int(tail[k]) if begins[k] else int(head[k]) if ends[k] else -1
        if node >= 0 and (node in passed or node in seen):
            continue
        seen.add(node)
        found.append(
            RoadPoint(int(edges[k]), float(np.round(share[k], 12)), float(roads.away_m[at[k]]))
        )
        if len(found) == MOST_WAYS:
            break
    return tuple(found)


def _name_on_road(net: RoadNetwork, point: RoadPoint, lon: float, lat: float) -> NodeName:
    for node, share in ((net.tail[point.edge], 0.0), (net.head[point.edge], 1.0)):
        if point.share == share:
            return node_name(net, int(node))
    return point_name(
        net, lon, lat, net.edge_ref(point.edge) or net.edge_name(point.edge) or "road"
    )
