"""From a point to the roads near it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import NetworkError
from .geodesy import distance_m, metres_per_degree
from .location import Location, Role
from .road_network import RoadNetwork
from .usable_nodes import UsableNodes

__all__ = ["MOST_CANDIDATES", "located_at", "road_distance_m"]

OTHER_CARRIAGEWAY_M = 1_500.0
"""How much farther than the nearest node another may be to count as a choice of carriageway."""

FARTHEST_ROAD_M = 200_000.0
"""A place farther than this from any road is not on this map: latitude and longitude exchanged,
another country, or nought and nought."""

MOST_CANDIDATES = 12


def located_at(net: RoadNetwork, lon: float, lat: float, role: Role, name: str | None) -> Location:
    """Find the nodes near a point where a trip may start or end.

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    lon, lat : float
        The point [deg].
    role : {"origin", "destination", "any"}
        What the nodes are to be.
    name : str or None
        What the place is called; None for the name of the nearest node.

    Returns
    -------
    Location
        The nodes of both carriageways near the point, nearest first.

    Raises
    ------
    NetworkError
        A network without roads, or a point far from all of them.
    """
    fits = net.attached(UsableNodes).of(role)
    usable = np.flatnonzero(fits)
    if not len(usable):
        raise NetworkError(
            f"place ({lon}, {lat}): {net.source.name} has no road to start or end on"
        )
    away = distance_m(net.lon[usable], net.lat[usable], lon, lat)
    order = np.argsort(away, kind="stable")
    limit = away[order[0]] + OTHER_CARRIAGEWAY_M
    chosen = [i for i in order[:MOST_CANDIDATES] if away[i] <= limit]
    candidates = tuple((int(usable[i]), float(away[i])) for i in chosen)
    node = candidates[0][0]
    road_m = road_distance_m(net, fits[net.tail] | fits[net.head], lon, lat)
    if road_m > FARTHEST_ROAD_M:
        exchanged = abs(lon) <= 90 and distance_m(net.lon, net.lat, lat, lon).min() < road_m / 10
        raise NetworkError(
            f"place ({lon:g}, {lat:g}): {road_m / 1000:,.0f} km from the nearest road of "
            f"{net.source.name}; "
            + ("give longitude first, then latitude" if exchanged else "load a map of that region")
        )
    return Location(node, name or net.place_name(node), lon, lat, road_m, candidates)


def road_distance_m(net: RoadNetwork, edges: NDArray[np.bool_], lon: float, lat: float) -> float:
    """Return how far a point is from the nearest of some edges, on a plane true to scale there.

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    edges : ndarray of bool, (m,)
        The edges.
    lon, lat : float
        The point [deg].

    Returns
    -------
    float
        Distance [m].
    """
    per_lon, per_lat = metres_per_degree(lat)
    x, y = (net.shape_lon - lon) * per_lon, (net.shape_lat - lat) * per_lat
    ax, ay, dx, dy = x[:-1], y[:-1], np.diff(x), np.diff(y)
    joint = net.shape_first[1:-1] - 1
    dx[joint] = dy[joint] = 0.0
    square = dx**2 + dy**2
    share = np.divide(-(ax * dx + ay * dy), square, out=np.zeros_like(square), where=square > 0)
    share = np.clip(share, 0, 1)
    away = (ax + share * dx) ** 2 + (ay + share * dy) ** 2
    # An edge has one point more than straight pieces: the last "piece" leads to the next edge.
    return float(np.sqrt(away[np.repeat(edges, np.diff(net.shape_first))[:-1]].min()))
