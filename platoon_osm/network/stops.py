"""Where trucks may stop beside the roads: what is there, and where they leave the road for it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .columns import POINT_KINDS, STOP_KINDS
from .making import checked_edges
from .restrictions import decode
from .road_network import RoadNetwork
from .road_stop import RoadStop, StopAccess
from .stop_access import StopRoads
from .stop_tags import fee_of, fuels_of, max_stay_s, offers_of, power_kw_of

__all__ = ["PassedStop", "Stops", "road_stops", "stops_along", "tunnels_along"]

Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class PassedStop:
    """A stop on the way.

    Attributes
    ----------
    stop : RoadStop
        The stop.
    access : StopAccess
        Where the road is left for it.
    place : int
        Position of the edge in the path.
    at_m : float
        How far from the start of the path the road is left [m].
    """

    stop: RoadStop
    access: StopAccess
    place: int
    at_m: float


class Stops:
    """The stops and tunnels of a network; `net.attached(Stops)` keeps them.

    Parameters
    ----------
    net : RoadNetwork
        Whose points.
    """

    def __init__(self, net: RoadNetwork) -> None:
        kinds = np.array([POINT_KINDS.index(kind) for kind in STOP_KINDS])
        points = net.points
        own = np.flatnonzero(np.isin(points.kind, kinds))
        bored = np.flatnonzero(points.kind == POINT_KINDS.index("tunnel"))
        roads = StopRoads(net) if len(own) + len(bored) else None
        self.stops: tuple[RoadStop, ...] = ()
        self.tunnels: tuple[RoadStop, ...] = ()
        if roads is not None:
            beside = roads.accesses(points.lon[own], points.lat[own])
            on = roads.on_road(points.lon[bored], points.lat[bored])
            self.stops = tuple(_stop(net, *pair) for pair in zip(own.tolist(), beside, strict=True))
            self.tunnels = tuple(_stop(net, *pair) for pair in zip(bored.tolist(), on, strict=True))
        self._line = _lines(net)
        self._at: dict[int, list[tuple[RoadStop, StopAccess]]] = {}
        for stop in (*self.stops, *self.tunnels):
            for access in stop.accesses:
                self._at.setdefault(int(self._line[access.edge]), []).append((stop, access))
        for rows in self._at.values():
            rows.sort(key=lambda row: row[1].share)

    def on(self, edge: int) -> list[tuple[RoadStop, StopAccess]]:
        """Return the stops and tunnels for which an edge is left.

        Parameters
        ----------
        edge : int
            Edge id.

        Returns
        -------
        list of (RoadStop, StopAccess)
            In the order in which they are passed.
        """
        return self._at.get(int(self._line[edge]), [])


def road_stops(net: RoadNetwork) -> tuple[RoadStop, ...]:
    """Return where trucks may stop beside the roads of a network.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    tuple of RoadStop
        In the order of its points.
    """
    return net.attached(Stops).stops


def stops_along(
    net: RoadNetwork, edges: Iterable[int], span: tuple[float, float] = (0.0, 1.0)
) -> tuple[PassedStop, ...]:
    """Return the stops for which a truck on a path may leave the road.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges are named.
    edges : iterable of int
        Edge ids, each beginning where the one before ends.
    span : (float, float), optional
        Where on the first edge the path begins and on the last it ends, as shares of them.

    Returns
    -------
    tuple of PassedStop
        In the order of the way.

    Raises
    ------
    NetworkError
        An edge that is none.
    """
    return tuple(_along(net, edges, span, STOP_KINDS))


def tunnels_along(
    net: RoadNetwork, edges: Iterable[int], span: tuple[float, float] = (0.0, 1.0)
) -> tuple[PassedStop, ...]:
    """Return the tunnels with a category for dangerous goods on a path.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges are named.
    edges : iterable of int
        Edge ids, each beginning where the one before ends.
    span : (float, float), optional
        Where on the first edge the path begins and on the last it ends, as shares of them.

    Returns
    -------
    tuple of PassedStop
        In the order of the way.

    Raises
    ------
    NetworkError
        An edge that is none.
    """
    return tuple(_along(net, edges, span, ("tunnel",)))


def _along(
    net: RoadNetwork, edges: Iterable[int], span: tuple[float, float], kinds: Sequence[str]
) -> list[PassedStop]:
    ids = checked_edges(list(edges), net.m).tolist()
    if not np.isin(net.points.kind, [POINT_KINDS.index(kind) for kind in kinds]).any():
        return []
    stops = net.attached(Stops)
    begin, end = span
    found: list[PassedStop] = []
    start = -begin * float(net.length_m[ids[0]]) if ids else 0.0
    for place, edge in enumerate(ids):
        length = float(net.length_m[edge])
        for stop, access in stops.on(edge):
            late = place == 0 and access.share < begin
            early = place == len(ids) - 1 and access.share > end
            if stop.kind in kinds and not late and not early:
                found.append(PassedStop(stop, access, place, start + access.share * length))
        start += length
    return found


def _stop(net: RoadNetwork, point: int, accesses: tuple[StopAccess, ...]) -> RoadStop:
    points = net.points
    tags = str(net.texts[points.tags[point]])
    kind = POINT_KINDS[points.kind[point]]
    # Points of other sources than a map have a kind and no tags.
    layers = decode(tags) or ({},)
    told = offers_of(layers)
    own = {"services": "parking", "rest_area": "parking"}.get(kind, kind)
    if not tags and own != "tunnel":
        told = (own,)
    capacity = int(points.capacity[point])
    return RoadStop(
        str(net.texts[points.name[point]]),
        kind,
        float(points.lon[point]),
        float(points.lat[point]),
        told,
        None if capacity < 0 else capacity,
        fuels_of(layers),
        power_kw_of(layers),
        fee_of(layers),
        max_stay_s(layers),
        accesses,
        tags,
    )


def _lines(net: RoadNetwork) -> Index:
    """Return a number for each edge, equal for copies of one that a turn restriction made."""
    ends = np.column_stack(
        [net.lon[net.tail], net.lat[net.tail], net.lon[net.head], net.lat[net.head], net.length_m]
    )
    _, number = np.unique(ends, axis=0, return_inverse=True)
    return np.asarray(number, np.int64).reshape(-1)
