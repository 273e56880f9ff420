"""From places to nodes: each trip takes the carriageways that suit its direction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..costs.weights import EdgeWeights
from ..errors import NoRouteError, ScenarioError
from ..network.location import Location
from ..network.road_network import RoadNetwork
from ..plans.trip import Trip
from ..search.dijkstra import ReferenceEngine

__all__ = ["TripEnds", "resolve_trips"]

ACCESS_DETOUR = 1.4
"""Way to a node against the straight distance, where only the latter is known."""


@dataclass(frozen=True, slots=True)
class TripEnds:
    """Nodes of a trip.

    Attributes
    ----------
    origin, destination : the chosen nodes.
    origins, destinations : all nodes that are the same place.
    origin_name, destination_name : as people know them.
    """

    vehicle: str
    origin: int
    destination: int
    origins: frozenset[int]
    destinations: frozenset[int]
    origin_name: str
    destination_name: str


def resolve_trips(
    net: RoadNetwork, weights: EdgeWeights, engine: ReferenceEngine, trips: Sequence[Trip]
) -> list[TripEnds]:
    """Choose for each trip the pair of nodes with the least way in all, access included.

    Raises
    ------
    ScenarioError
        Two vehicles of one name, or a trip that ends where it starts.
    NoRouteError
        A trip without any route.
    """
    names = [trip.vehicle for trip in trips]
    for name in names:
        if (times := names.count(name)) > 1:
            raise ScenarioError(f"vehicle {name!r} has {times} trips; names must differ")
    length = float(net.length_m.sum())
    per_metre = ACCESS_DETOUR * float(weights.solo.sum()) / length if length else 0.0
    return [_resolve(net, engine, trip, per_metre) for trip in trips]


def _resolve(net: RoadNetwork, engine: ReferenceEngine, trip: Trip, per_metre: float) -> TripEnds:
    start, end = (
        place if isinstance(place, Location) else net.locate(place)
        for place in (trip.origin, trip.destination)
    )
    starts, ends = ([node for node, _ in place.candidates] for place in (start, end))
    same_spot = (start.lon, start.lat) == (end.lon, end.lat)
    same_name = start.name == end.name and set(starts) & set(ends)
    if start.node == end.node or same_spot or same_name:
        raise ScenarioError(
            f"trip {trip.vehicle!r}: origin and destination are the same place ({start.name}); "
            "give two different ones"
        )
    access, egress = (np.array([away for _, away in place.candidates]) for place in (start, end))
    total = (
        engine.distances(starts)[:, ends]
        + per_metre * (access[:, None] + egress)
        # Two places so near that they share a node must not meet in it.
        + np.where(np.equal.outer(starts, ends), np.inf, 0.0)
    )
    if not np.isfinite(total).any():
        raise NoRouteError(
            f"trip {trip.vehicle!r}: no route from {start.name} to {end.name} in "
            f"{net.source.name}; choose other places, load more roads, or try --infer-links"
        )
    i, j = np.unravel_index(int(np.argmin(total)), total.shape)
    return TripEnds(
        trip.vehicle, starts[i], ends[j], frozenset(starts), frozenset(ends), start.name, end.name
    )
