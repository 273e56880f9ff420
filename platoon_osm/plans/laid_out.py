"""A plan laid out for drawing: on a network cut where its ways begin and end.

The record of a plan names edges of the network that it was made on, and says where on the first
one a stretch begins and where on the last one it ends. Whoever draws lines or counts edges would
have to mind that everywhere. Here it is done once: the network is cut at those places and gets the
ways beside the road as edges, so that every stretch is whole edges again.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..network.geodesy import distance_m
from ..network.placed import PlacedNetwork
from ..network.preparing.placing import BesideRoad, Cut, placing
from ..network.road_network import RoadNetwork
from .plan import Plan
from .records import WHOLE, Line, PlannedTrip, SoloRoute, Span, Stop

__all__ = ["laid_out"]

Edges = tuple[int, ...]
Way = int | Cut
Beside = tuple[float, float, bool, Way]
"""A place beside the road, whether it is left, and where its way meets the road."""


def laid_out(plan: Plan, net: RoadNetwork) -> tuple[Plan, RoadNetwork]:
    """Return a plan whose stretches are whole edges, and the network that has them.

    Parameters
    ----------
    plan : Plan
        As it was planned.
    net : RoadNetwork
        The network it was made on.

    Returns
    -------
    plan : Plan
        The same plan in other edges; a way beside the road is one edge. What it says of its network
        is as before.
    net : RoadNetwork
        That network cut; both are the same objects if no way begins or ends inside an edge.
    """
    spans = [(one.edges, one.span) for one in plan.stretches]
    spans += [(trip.alone.edges, trip.alone.span) for trip in plan.trips]
    cuts = {
        cut
        for edges, (begin, end) in spans
        if edges
        for cut in ((edges[0], begin), (edges[-1], end))
        if 0 < cut[1] < 1
    }
    beside: dict[Beside, tuple[float, float]] = {}
    for trip, way in zip(plan.trips, plan.ways, strict=True):
        for place, k in enumerate(way):
            stretch = plan.stretches[k]
            if stretch.access is not None:
                key = _beside(net, trip, stretch.access, _road_beside(plan, way, place))
                beside.setdefault(key, (stretch.length_m, stretch.drive_s))
    if not cuts and not beside:
        return plan, net
    pace = next(iter(beside.values()), (1.0, 1.0))
    detour = _detour(plan)
    for trip in plan.trips:
        for line, road in _alone_lines(trip.alone):
            metres = detour * _straight_m(line)
            seconds = metres / (pace[0] / pace[1] if pace[1] else 1.0)
            beside.setdefault(_beside(net, trip, line, road), (metres, seconds))
    made = placing(net, sorted(cuts), [_place(key, *told) for key, told in beside.items()])
    laid = _Laid(net, made.net, dict(zip(beside, made.beside, strict=True)))
    stretches = list(plan.stretches)
    trips = []
    for trip, way in zip(plan.trips, plan.ways, strict=True):
        for place, k in enumerate(way):
            stretch = plan.stretches[k]
            if stretch.access is None:
                edges = laid.road(stretch.edges, stretch.span)
            else:
                edges = laid.access(trip, stretch.access, _road_beside(plan, way, place))
            stretches[k] = replace(stretch, edges=edges, span=WHOLE)
        alone = trip.alone
        lines = [laid.access(trip, *one) for one in _alone_lines(alone)]
        first = lines.pop(0) if alone.access[0] else ()
        edges = (*first, *laid.road(alone.edges, alone.span), *(lines[0] if lines else ()))
        trips.append(replace(trip, alone=replace(alone, edges=edges, span=WHOLE)))
    return replace(plan, stretches=tuple(stretches), trips=tuple(trips)), made.net


class _Laid:
    """Edges of a cut network by those of the network below it."""

    def __init__(self, net: RoadNetwork, cut: RoadNetwork, stops: dict[Beside, int]) -> None:
        self.net, self.cut, self.stops = net, cut, stops
        self.new = np.arange(net.m)
        self.pieces: dict[int, NDArray[np.int64]] = {}
        if isinstance(cut, PlacedNetwork):
            road = np.flatnonzero(cut.below_edge >= 0)
            whole = road[(cut.begins[road] == 0) & (cut.ends[road] == 1)]
            self.new[cut.below_edge[whole]] = whole
            for edge in np.unique(cut.place_edge[cut.place_edge >= 0]).tolist():
                own = np.flatnonzero(cut.below_edge == edge)
                self.pieces[edge] = own[np.argsort(cut.begins[own])]

    def road(self, edges: Edges, span: Span) -> Edges:
        found: list[int] = []
        for place, edge in enumerate(edges):
            if edge not in self.pieces:
                found.append(int(self.new[edge]))
                continue
            assert isinstance(self.cut, PlacedNetwork)
            pieces = self.pieces[edge]
            middle = (self.cut.begins[pieces] + self.cut.ends[pieces]) / 2
            begin = span[0] if place == 0 else 0.0
            end = span[1] if place == len(edges) - 1 else 1.0
            found += pieces[(middle > begin) & (middle < end)].tolist()
        return tuple(found)

    def access(self, trip: PlannedTrip, line: Line, road: Cut | None) -> Edges:
        key = _beside(self.net, trip, line, road)
        node = self.stops[key]
        if key[2]:
            return (int(self.cut.first_out[node]),)
        return (int(np.flatnonzero(self.cut.head == node)[0]),)


def _alone_lines(alone: SoloRoute) -> Iterator[tuple[Line, Cut | None]]:
    """Yield the ways beside the road of a route, each with where it meets the road."""
    ends: tuple[Cut | None, Cut | None] = (None, None)
    if alone.edges:
        ends = (alone.edges[0], alone.span[0]), (alone.edges[-1], alone.span[1])
    for line, end in zip(alone.access, ends, strict=True):
        if line is not None:
            yield line, end


def _road_beside(plan: Plan, way: tuple[int, ...], place: int) -> Cut | None:
    """Return where the road meets a way beside it: an edge and a share; None without road."""
    if place + 1 < len(way) and (after := plan.stretches[way[place + 1]]).access is None:
        return after.edges[0], after.span[0]
    if place > 0 and (before := plan.stretches[way[place - 1]]).access is None:
        return before.edges[-1], before.span[1]
    return None


def _beside(net: RoadNetwork, trip: PlannedTrip, line: Line, road: Cut | None) -> Beside:
    leaves = _is_beside(trip.origin) and line[0] == (trip.origin.lon, trip.origin.lat)
    place, there = line if leaves else line[::-1]
    return *place, leaves, _met(net, road, trip, there)


def _is_beside(stop: Stop) -> bool:
    return stop.node < 0 and stop.edge is None


def _met(net: RoadNetwork, road: Cut | None, trip: PlannedTrip, there: tuple[float, float]) -> Way:
    if road is None:
        # Nothing but ways beside the road: they meet at a node, or where the trip starts or ends.
        for stop in (trip.origin, trip.destination):
            if stop.edge is not None and stop.share is not None and (stop.lon, stop.lat) == there:
                road = stop.edge, stop.share
    if road is None:
        return int(np.argmin(distance_m(net.lon, net.lat, *there)))
    edge, share = road
    if share <= 0:
        return int(net.tail[edge])
    return int(net.head[edge]) if share >= 1 else (edge, share)


def _place(key: Beside, length_m: float, drive_s: float) -> BesideRoad:
    lon, lat, leaves, way = key
    speed = length_m / drive_s if drive_s > 0 else 1.0
    return BesideRoad(lon, lat, leaves, ((way, length_m),), speed)


def _straight_m(line: Line) -> float:
    (lon, lat), (to_lon, to_lat) = line
    return float(distance_m(lon, lat, to_lon, to_lat))


def _detour(plan: Plan) -> float:
    """Return how much longer ways beside the road are than straight lines."""
    ways = [one for one in plan.stretches if one.access is not None]
    straight = sum(_straight_m(one.access) for one in ways if one.access)
    return sum(one.length_m for one in ways) / straight if straight else 1.0
