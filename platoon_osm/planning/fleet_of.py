"""The fleet of a problem: what each trip's vehicle pays, may drive, and how fast it is."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..costs.placed_weights import placed_weights
from ..costs.weights import EdgeWeights
from ..driving.rules import spread_of
from ..network.road_network import RoadNetwork
from ..vehicles.access import Way
from ..vehicles.closures import Closures
from ..vehicles.pace import drive_times
from ..vehicles.profile import Vehicle
from .end_zones import EndZones
from .fleet import Fleet
from .places import PlacedEnds
from .problem import Problem
from .road_closures import without_roads
from .told_edge import place_of, road_of

__all__ = ["fleet_of"]

Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]


def fleet_of(problem: Problem, places: PlacedEnds, closed: Marks) -> Fleet:
    """Return the fleet of a problem on the network that has its places.

    Parameters
    ----------
    problem : Problem
        What is asked.
    places : PlacedEnds
        The network with the places of its trips.
    closed : ndarray of bool
        Edges of the network below that count as closed.

    Returns
    -------
    Fleet
        One vehicle a trip; those alike share what is theirs.
    """
    net = places.net
    kinds = [problem.profile_of(trip) for trip in problem.trips]
    vehicles = [problem.vehicle_of(trip) for trip in problem.trips]
    roads = _Roads(net, without_roads(net, closed))
    own: dict[Vehicle | None, EdgeWeights] = {}
    spread = spread_of(problem.rules)
    moving = {_pace_of(kind): drive_times(net, kind) for kind in kinds}
    # Rest that is spread over the driving makes all of it longer, alone and together.
    pace = {kind: times * (1 + spread) for kind, times in moving.items()}
    slowest = np.maximum.reduce(list(moving.values())) if len(moving) > 1 else None
    for kind in kinds:
        if kind not in own:
            own[kind] = _weights(problem, net, kind, slowest, own)
    return Fleet(
        [own[kind] for kind in kinds],
        [
            roads.closed_to(
                vehicle,
                [node for node, _ in start.nodes],
                [node for node, _ in end.nodes],
            )
            for vehicle, (start, end) in zip(vehicles, places.ends, strict=True)
        ],
        [pace[_pace_of(kind)] for kind in kinds],
        lambda vehicle, edge: roads.why(vehicles[vehicle], edge),
        spread,
    )


def _pace_of(kind: Vehicle | None) -> tuple[bool, float | None] | None:
    """Return what decides how fast a vehicle is."""
    return None if kind is None else (kind.heavy, kind.limiter_kmh)


def _weights(
    problem: Problem,
    net: RoadNetwork,
    kind: Vehicle | None,
    slowest_s: Floats | None,
    known: dict[Vehicle | None, EdgeWeights],
) -> EdgeWeights:
    """Return what edges cost a vehicle: the same object where it costs what another does."""
    made = placed_weights(problem.objective, net, "plan", kind)
    if slowest_s is not None:
        made = made.among(slowest_s)
    for other in known.values():
        if made is other or made.same(other):
            return other
    return made


class _Roads:
    """Which edges are closed to whom; equal answers are one object."""

    def __init__(self, net: RoadNetwork, closed: Marks) -> None:
        self._net, self._closed = net, closed
        self._zones: dict[Vehicle, EndZones | Marks] = {}
        self._known: dict[bytes, Marks | None] = {}

    def why(self, vehicle: Vehicle, edge: int) -> str:
        """Tell why an edge is closed to a vehicle."""
        road = road_of(self._net, edge)
        if self._closed[edge]:
            return f"{road} is to count as closed"
        judged = self._net.attached(Closures).on(edge, vehicle)
        who = "" if judged.way == Way.CLOSED else ", to through traffic"
        near = place_of(self._net, edge)
        return f"{road} near {near} is closed to {vehicle.name}{who}: {'; '.join(judged.reasons)}"

    def closed_to(
        self, vehicle: Vehicle, origins: Sequence[int], destinations: Sequence[int]
    ) -> Marks | None:
        if vehicle not in self._zones:
            judged = self._net.attached(Closures).of(vehicle)
            shut = judged.closed | self._closed
            ends = judged.ends & ~shut
            self._zones[vehicle] = EndZones(self._net, ends, shut) if ends.any() else shut
        zones = self._zones[vehicle]
        if isinstance(zones, EndZones):
            zones = zones.closed_to(origins, destinations)
        key = np.packbits(zones).tobytes()
        if key not in self._known:
            self._known[key] = zones if zones.any() else None
        return self._known[key]
