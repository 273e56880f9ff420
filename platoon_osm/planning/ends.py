"""From places to nodes: each trip takes the carriageways that suit its direction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import NoRouteError, PlatoonError, ScenarioError
from ..network.access import STANDARD_ACCESS, Access
from ..network.locate import locate
from ..network.location import Location, Place, PlaceLike, Role
from ..network.road_network import RoadNetwork
from ..plans.trip import Trip
from ..search.changing_weights import ChangingWeights
from ..search.trees import Trees
from ..sources.spellings import CLASSES, INFER_LINKS
from ..vehicles.profile import DEFAULT_VEHICLE, Vehicle
from ..vehicles.usable import VehicleNodes
from .fleet import Fleet
from .places import PlacedEnd, placed

__all__ = ["PlaceSearch", "TripEnds", "located", "refused_trips", "resolve_trips"]

ACCESS_DETOUR = STANDARD_ACCESS.detour
"""Way to a node against the straight distance, where only the latter is known."""

Ends = tuple[Location, Location]


@dataclass(frozen=True, slots=True)
class TripEnds:
    """Nodes of a trip.

    Attributes
    ----------
    vehicle : str
        Who drives.
    origin, destination : int
        The chosen nodes.
    origins, destinations : frozenset of int
        All nodes that are the same place.
    origin_name, destination_name : str
        As people know them.
    """

    vehicle: str
    origin: int
    destination: int
    origins: frozenset[int]
    destinations: frozenset[int]
    origin_name: str
    destination_name: str


def located(
    net: RoadNetwork,
    trips: Sequence[Trip],
    access: Access = STANDARD_ACCESS,
    profile: Vehicle | None = None,
) -> list[Ends]:
    """Find the places of trips on a network.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    trips : sequence of Trip, (N,)
        Places as names, coordinates, nodes, locations or `Place`.
    access : Access
        What counts as on the road, and how far beside it a place may be.
    profile : Vehicle, optional
        The vehicle of trips that name none: places are looked for on roads that are open to it.

    Returns
    -------
    list of tuple of Location, (N, 2)
        Origin and destination of each.

    Raises
    ------
    PlatoonError
        A place that is not there, with trip and end; or a trip that ends where it starts.
    """
    search = PlaceSearch(net, access, profile)
    return [search.of(trip) for trip in trips]


class PlaceSearch:
    """Finds the places of trips; of many trips between few places each place is found once.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    access : Access
        What counts as on the road, and how far beside it a place may be.
    profile : Vehicle, optional
        The vehicle of trips that name none.
    """

    def __init__(
        self, net: RoadNetwork, access: Access = STANDARD_ACCESS, profile: Vehicle | None = None
    ) -> None:
        self._net, self._access, self._profile = net, access, profile or DEFAULT_VEHICLE
        self._nodes = net.attached(VehicleNodes)
        self._known: dict[tuple[type, PlaceLike, Role, Vehicle], Location | PlatoonError] = {}

    def of(self, trip: Trip) -> Ends:
        """Find the places of a trip.

        Parameters
        ----------
        trip : Trip
            Who goes where.

        Returns
        -------
        tuple of Location
            Origin and destination.

        Raises
        ------
        PlatoonError
            A place that is not there, with trip and end.
        """
        vehicle = trip.profile or self._profile
        return (
            self._at(trip, trip.origin, "origin", vehicle),
            self._at(trip, trip.destination, "destination", vehicle),
        )

    def _at(self, trip: Trip, asked: PlaceLike, end: Role, vehicle: Vehicle) -> Location:
        _check_on(self._net, trip, asked, end)
        # With its type, for 1.0 would be found as 1.
        key = type(asked), asked, end, vehicle
        if key not in self._known:
            usable = self._nodes.of(self._net, vehicle)
            try:
                found = locate(self._net, asked, end, access=self._access, usable=usable)
            except PlatoonError as error:
                self._known[key] = error
            else:
                self._known[key] = found
        known = self._known[key]
        if isinstance(known, PlatoonError):
            raise type(known)(f"trip {trip.vehicle!r}, {end}: {known}") from known
        return known


def _check_on(net: RoadNetwork, trip: Trip, asked: PlaceLike, end: Role) -> None:
    """Refuse a location of another network."""
    place = asked.at if isinstance(asked, Place) else asked
    if isinstance(place, Location):
        for node, _ in place.candidates:
            if not 0 <= node < net.n:
                raise ScenarioError(
                    f"trip {trip.vehicle!r}, {end}: {place.name} is at node {node}, the network "
                    f"has nodes 0 to {net.n - 1}; locate it on this network"
                )


def resolve_trips(
    net: RoadNetwork,
    fleet: Fleet,
    trees: Sequence[Trees],
    trips: Sequence[Trip],
    places: Sequence[tuple[PlacedEnd, PlacedEnd]] | None = None,
) -> list[TripEnds]:
    """Choose for each trip the pair of nodes with the least way in all, access included.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    fleet : Fleet
        What edges cost each vehicle.
    trees : sequence of Trees, (N,)
        Each one's searches alone.
    trips : sequence of Trip, (N,)
        Who goes where.
    places : sequence of tuple of PlacedEnd, (N, 2), optional
        Their ends, as `placed` puts them on the network; without them no place may lie between two
        junctions.

    Returns
    -------
    list of TripEnds, (N,)
        Nodes and names.

    Raises
    ------
    ScenarioError
        A trip that ends where it starts, or a place that is not yet on the network.
    NoRouteError
        A trip without any route.
    """
    if places is None:
        found = placed(net, located(net, trips))
        if found.net is not net:
            raise ScenarioError(
                "plan: a place lies between two junctions; put the places on the network with "
                "`placed` first"
            )
        places = found.ends
    per_metre = _per_metre(net, fleet)
    return [
        _resolve(net, fleet, index, *found)
        for index, found in enumerate(zip(trees, trips, places, per_metre, strict=True))
    ]


def refused_trips(
    net: RoadNetwork,
    fleet: Fleet,
    trees: Sequence[Trees],
    trips: Sequence[Trip],
    places: Sequence[tuple[PlacedEnd, PlacedEnd]],
) -> dict[int, PlatoonError]:
    """Return which trips `resolve_trips` would refuse, and why.

    Parameters
    ----------
    net, fleet, trees, trips, places : see `resolve_trips`
        The same.

    Returns
    -------
    dict
        By position.
    """
    refused: dict[int, PlatoonError] = {}
    per_metre = _per_metre(net, fleet)
    for index, found in enumerate(zip(trees, trips, places, per_metre, strict=True)):
        try:
            _resolve(net, fleet, index, *found)
        except PlatoonError as error:
            refused[index] = error
    return refused


def _per_metre(net: RoadNetwork, fleet: Fleet) -> list[float]:
    """Return what a metre beside the road counts to each vehicle in the choice of nodes."""
    length = float(net.length_m.sum())
    if not length:
        return [0.0] * len(fleet)
    by_kind = {
        kind: ACCESS_DETOUR * float(fleet[kind_[0]].solo.sum()) / length
        for kind, kind_ in enumerate(fleet.kinds)
    }
    return [by_kind[kind] for kind in fleet.kind]


def _resolve(
    net: RoadNetwork,
    fleet: Fleet,
    index: int,
    trees: Trees,
    trip: Trip,
    places: tuple[PlacedEnd, PlacedEnd],
    per_metre: float,
) -> TripEnds:
    start, end = places
    starts, ends = ([node for node, _ in place.nodes] for place in (start, end))
    same_spot = (start.lon, start.lat) == (end.lon, end.lat)
    same_name = start.name == end.name and set(starts) & set(ends)
    if starts[0] == ends[0] or same_spot or same_name:
        raise ScenarioError(
            f"trip {trip.vehicle!r}: origin and destination are the same place ({start.name}); "
            "give two different ones"
        )
    access, egress = (np.array([away for _, away in place.nodes]) for place in (start, end))
    total = (
        trees.table(starts, ends)
        + per_metre * (access[:, None] + egress)
        # Two places so near that they share a node must not meet in it.
        + np.where(np.equal.outer(starts, ends), np.inf, 0.0)
    )
    if not np.isfinite(total).any():
        links = "" if net.inferred.any() else f", or add connectors ({INFER_LINKS})"
        barred = _barred(net, fleet, index, starts, ends)
        if barred:
            raise NoRouteError(
                f"trip {trip.vehicle!r}: no route from {start.name} to {end.name} for this "
                f"vehicle: {barred}; give another profile or other places"
            )
        raise NoRouteError(
            f"trip {trip.vehicle!r}: no route from {start.name} to {end.name} in "
            f"{net.source.name}; choose other places, load more roads ({CLASSES}){links}"
        )
    i, j = np.unravel_index(int(np.argmin(total)), total.shape)
    return TripEnds(
        trip.vehicle, starts[i], ends[j], start.same, end.same, start.name, end.name
    )  # fmt: skip


def _barred(
    net: RoadNetwork, fleet: Fleet, vehicle: int, starts: Sequence[int], ends: Sequence[int]
) -> str:
    """Return what is closed on the way that a vehicle would take if nothing were; or nothing."""
    searches = net.attached(ChangingWeights)
    for start in starts:
        searched = searches.search(fleet[vehicle].solo, start)
        others = [node for node in ends if node != start]
        end = min(others, key=searched.dist.__getitem__, default=-1)
        if end >= 0 and np.isfinite(searched.dist[end]):
            return fleet.why_closed(vehicle, searched.path(end))
    return ""
