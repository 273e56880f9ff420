"""Trips of a study on a real network, drawn by distance or by truck flows."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import MapDataError, ScenarioError, brief
from ..fleets.day.flow_files import SEGMENTS, positions_in, volumes_in
from ..kinds import is_whole
from ..network.antimeridian import near_deg
from ..network.geodesy import distance_m, east_north_m
from ..network.preparing.unrolled import centre_longitude_deg
from ..network.road_network import RoadNetwork
from .random_network import Draw

__all__ = ["FARTHEST_PLACE_M", "Flows", "RoadTrips", "read_flows"]

FARTHEST_PLACE_M = 50_000.0
"""How far a place of the flows may lie from the network's nearest node to count as on it."""

Floats = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Flows:
    """Truck volumes between places of a network.

    Attributes
    ----------
    origin, destination : ndarray of int, (f,)
        Nodes.
    volume : ndarray of float, (f,)
        Trucks a year.
    name : str
        Of the file they came from.
    left_out : float
        Trucks a year between places of which one is not on the network, or both are at one node of
        it.
    """

    origin: Index
    destination: Index
    volume: Floats
    name: str
    left_out: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class RoadTrips:
    """Vehicles on a loaded network, as `RandomNetwork` has them on a random one.

    Attributes
    ----------
    net : RoadNetwork
        Trips stay in its largest strongly connected part.
    vehicles : int
        With the one at the centre.
    spawn_diameter_m : float
        Diameter of the circle in which vehicles start, around a random node.
    min_route_m : float
        Minimum route length by road.
    flows : Flows, optional
        If given, origins and destinations are drawn by volume; else uniformly.
    max_redraws : int
        Draws thrown away before giving up.
    """

    net: RoadNetwork
    vehicles: int = 10
    spawn_diameter_m: float = 2e5
    min_route_m: float = 5e5
    flows: Flows | None = None
    max_redraws: int = 1000

    def __post_init__(self) -> None:
        if not isinstance(self.net, RoadNetwork):
            raise ScenarioError(
                f"road trips: net is {brief(self.net)}; give a network, from load_network"
            )
        if self.flows is not None and not isinstance(self.flows, Flows):
            raise ScenarioError(f"flows = {brief(self.flows)} must be Flows, or None")
        for name, low in (("vehicles", 2), ("max_redraws", 0)):
            value = getattr(self, name)
            if not is_whole(value) or value < low:
                raise ScenarioError(
                    f"{name} = {brief(value)} must be a whole number, {low} or more"
                )
        for name in ("spawn_diameter_m", "min_route_m"):
            value = getattr(self, name)
            if not (isinstance(value, int | float) and math.isfinite(value) and value >= 0):
                raise ScenarioError(
                    f"{name} = {brief(value)} must be a number of metres, 0 or more"
                )

    def to_dict(self) -> dict[str, Any]:
        """Return the plain JSON form, with the identity of the network in place of its arrays.

        Returns
        -------
        dict
            Text and numbers only.
        """
        return {
            "kind": "road", "source": self.net.source.name, "identity": self.net.identity(),
            "attribution": self.net.source.attribution, "licence": self.net.source.licence,
            "vehicles": self.vehicles, "spawn_diameter_m": self.spawn_diameter_m,
            "min_route_m": self.min_route_m, "flows": self.flows.name if self.flows else None,
            "flow_volume": float(self.flows.volume.sum()) if self.flows else None,
            "flow_volume_left_out": self.flows.left_out if self.flows else None,
            "max_redraws": self.max_redraws,
        }  # fmt: skip

    def draw(self, rng: np.random.Generator) -> Draw:
        """Draw trips until each vehicle has a destination far enough.

        Parameters
        ----------
        rng : numpy.random.Generator
            Where chance comes from.

        Returns
        -------
        Draw
            The first possible one; no edge of it is an access edge.

        Raises
        ------
        ScenarioError
            No draw was possible within `max_redraws`.
        """
        for impossible in range(self.max_redraws + 1):
            found = self._by_distance(rng) if self.flows is None else self._by_flows(rng)
            if found is not None:
                net = self.net
                lon = near_deg(net.lon, centre_longitude_deg(net))
                x, y = east_north_m(lon, net.lat, float(net.lat.mean()))
                access = np.zeros(net.m, bool)
                return Draw(net, *found, access, x - x.min(), y - y.min(), 0, impossible)
        raise ScenarioError(
            f"{self.net.source.name}: none of {self.max_redraws + 1} draws gave {self.vehicles} "
            f"routes of {self.min_route_m / 1000:g} km or more; take a shorter minimum"
        )

    def _by_distance(self, rng: np.random.Generator) -> tuple[Index, Index] | None:
        net = self.net
        inside = np.flatnonzero(net.strong_component() == 0)
        centre = int(rng.choice(inside))
        near = inside[self._away(inside, centre) <= self.spawn_diameter_m / 2]
        origins = np.append(centre, rng.choice(near, self.vehicles - 1)).astype(np.int64)
        allowed = self._lengths(origins)[:, inside] >= self.min_route_m
        allowed &= inside != origins[:, None]
        if not allowed.any(axis=1).all():
            return None
        return origins, inside[(rng.random(allowed.shape) * allowed).argmax(axis=1)]

    def _by_flows(self, rng: np.random.Generator) -> tuple[Index, Index] | None:
        flows = self.flows
        assert flows is not None
        share = flows.volume / flows.volume.sum()
        first = int(rng.choice(len(share), p=share))
        centre = int(flows.origin[first])
        near = self._away(flows.origin, centre) <= self.spawn_diameter_m / 2
        # A flow that starts in the circle is as likely as its volume, if it goes far enough.
        starts, row = np.unique(flows.origin[near], return_inverse=True)
        rows = np.flatnonzero(near)
        far = self._lengths(starts)[row, flows.destination[rows]] >= self.min_route_m
        rows = rows[far & (flows.destination[rows] != flows.origin[rows])]
        if first not in rows:
            return None
        weight = flows.volume[rows] / flows.volume[rows].sum()
        chosen = np.append(first, rng.choice(rows, self.vehicles - 1, p=weight))
        return flows.origin[chosen], flows.destination[chosen]

    def _away(self, nodes: Index, centre: int) -> Floats:
        net = self.net
        return distance_m(net.lon[nodes], net.lat[nodes], net.lon[centre], net.lat[centre])

    def _lengths(self, origins: Index) -> Floats:
        from ..search.dijkstra import ReferenceEngine

        return ReferenceEngine(self.net, self.net.length_m).distances(origins)


def read_flows(path: Path, net: RoadNetwork) -> Flows:
    """Read truck volumes (`origin,destination,volume`) and place them on a network.

    Places are ids whose coordinates stand in `segments.csv` beside the file (`source`,
    `position_x`, `position_y`), as in the ETISplus sets; each goes to the nearest node of the
    network's largest connected part, if that is within `FARTHEST_PLACE_M`. Flows from and to other
    places are left out, and counted.

    Parameters
    ----------
    path : Path
        The CSV file of volumes.
    net : RoadNetwork
        On which the places are looked for.

    Returns
    -------
    Flows
        Those with both ends on the network.

    Raises
    ------
    MapDataError
        A file is missing or has other columns, or no flow has both ends on the network.
    """
    volumes = volumes_in(path)
    inside = np.flatnonzero(net.strong_component() == 0)
    places: dict[str, int | None] = {}
    for key, (lon, lat) in positions_in(path.with_name(SEGMENTS)).items():
        away = distance_m(net.lon[inside], net.lat[inside], lon, lat)
        nearest = int(away.argmin())
        known = away[nearest] <= FARTHEST_PLACE_M
        places[key] = int(inside[nearest]) if known else None
    left_out = 0.0
    ends, kept = [], []
    for origin, destination, volume in volumes:
        pair = places.get(origin), places.get(destination)
        if None not in pair and pair[0] != pair[1] and volume > 0:
            ends.append(pair)
            kept.append(volume)
        else:
            left_out += volume
    if not ends:
        raise MapDataError(
            f"{path.name}: no flow has both of its ends within {FARTHEST_PLACE_M / 1000:g} km of "
            f"{net.source.name}; give flows of its region"
        )
    places_of = np.array(ends, np.int64)
    return Flows(places_of[:, 0], places_of[:, 1], np.array(kept), path.name, left_out)
