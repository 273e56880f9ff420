"""Between which places trucks go, and how many: from a file of flows, or by a gravity rule.

By the gravity rule as many trucks go from town i to town j as

    T_ij ~ p_i p_j / d_ij,

where p are inhabitants, as the map of the network tells them, and d_ij is the way by road. It has
no more figures than a map has, so it is a stand-in where no flows are known, not a measurement.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...errors import MapDataError, NetworkError, ScenarioError
from ...network.geodesy import distance_m
from ...network.locate import locate
from ...network.location import Location, Place, PlaceLike, Role
from ...network.road_network import POINT_KINDS, RoadNetwork
from ...planning.places import placed
from ...search.engine import many_to_many
from ...vehicles.closures import Closures
from ...vehicles.profile import DEFAULT_VEHICLE
from ...vehicles.usable import VehicleNodes
from .flow_files import SEGMENTS, positions_in, volumes_in

__all__ = ["Demand", "demand_in", "gravity_demand"]

SAME_PLACE_M = 50_000.0
"""A node whose id is that of a place but lies farther from it has the id by chance."""

FEWEST_TOWNS = 2

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Demand:
    """Trucks between places of a network.

    Attributes
    ----------
    places : tuple of PlaceLike, (P,)
        As trips name them.
    origin, destination : ndarray of int64, (F,)
        Positions in `places`.
    weight : ndarray of float, (F,)
        How many trucks, in any unit; above 0.
    length_m : ndarray of float, (F,)
        The shortest way of a truck by road [m].
    left_out : float
        Share of the weight between places of which one is not on the network, or has no route to
        the other.
    """

    places: tuple[PlaceLike, ...]
    origin: Ints
    destination: Ints
    weight: Floats
    length_m: Floats
    left_out: float


def demand_in(path: Path, net: RoadNetwork) -> Demand:
    """Read a file of flows and find its places on a network.

    A place is the id of a node of the network; or an id whose coordinates stand in `segments.csv`
    beside the file; or whatever `net.locate` finds by its text.

    Parameters
    ----------
    path : Path
        CSV with `origin`, `destination`, `volume`.
    net : RoadNetwork
        Where the places are looked for.

    Returns
    -------
    Demand
        Of flows with both ends on the network and a route.

    Raises
    ------
    MapDataError
        A file that cannot be read, or none of its flows is on the network.
    """
    volumes = volumes_in(path)
    beside = path.with_name(SEGMENTS)
    positions = positions_in(beside) if beside.is_file() else {}
    number: dict[str, int] = {}
    ends = [
        [number.setdefault(text, len(number)) for text in (origin, destination)]
        for origin, destination, _ in volumes
    ]
    places = [_place(net, text, positions) for text in number]
    origin, destination = np.array(ends, np.int64).reshape(-1, 2).T
    weight = np.array([volume for _, _, volume in volumes], np.float64)
    found = _reached(net, places, origin, destination, weight)
    if not len(found.weight):
        raise MapDataError(
            f"{path.name}: no flow has both of its ends on {net.source.name} and a route; give "
            f"flows of its region, with {SEGMENTS} beside if places are ids"
        )
    return found


def gravity_demand(net: RoadNetwork) -> Demand:
    """Return what trucks may go between the towns of a network, by the gravity rule.

    Parameters
    ----------
    net : RoadNetwork
        Whose map names towns with their inhabitants.

    Returns
    -------
    Demand
        Between all of them that are found by their names.

    Raises
    ------
    ScenarioError
        The map names fewer than two such towns.
    """
    points = net.points
    towns = (points.kind >= POINT_KINDS.index("city")) & (points.population > 0)
    names, first = np.unique(points.name[towns], return_index=True)
    people = points.population[towns][first].astype(np.float64)
    places: list[PlaceLike] = [net.texts[code] for code in names.tolist()]
    count = len(places)
    pairs = np.indices((count, count)).reshape(2, -1)
    found = _reached(net, places, pairs[0], pairs[1], (people[:, None] * people).ravel())
    if count < FEWEST_TOWNS or not len(found.weight):
        raise ScenarioError(
            f"{net.source.name} names no two towns with inhabitants and a route between them; "
            "give flows"
        )
    return Demand(
        found.places, found.origin, found.destination,
        found.weight / found.length_m, found.length_m, found.left_out,
    )  # fmt: skip


def _place(net: RoadNetwork, text: str, positions: dict[str, tuple[float, float]]) -> PlaceLike:
    at = positions.get(text)
    if text.isascii() and text.isdigit() and len(text) <= 18:
        for node in np.flatnonzero(net.node_id == int(text)).tolist():
            own = float(net.lon[node]), float(net.lat[node])
            if at is None or distance_m(*own, *at) <= SAME_PLACE_M:
                return Place(osmid=int(text))
    return at if at is not None else text


def _reached(
    net: RoadNetwork, places: list[PlaceLike], origin: Ints, destination: Ints, weight: Floats
) -> Demand:
    """Return the flows that have a route, with its length."""
    way = _lengths_m(net, places)[origin, destination]
    kept = np.isfinite(way) & (weight > 0)
    total = float(weight.sum())
    left_out = float(weight[~kept].sum()) / total if total else 0.0
    return Demand(tuple(places), origin[kept], destination[kept], weight[kept], way[kept], left_out)


def _lengths_m(net: RoadNetwork, places: list[PlaceLike]) -> Floats:
    """Return the shortest ways between places, whichever of their nodes is taken [m]."""
    lengths = np.full((len(places), len(places)), np.inf)
    usable = net.attached(VehicleNodes).of(net, DEFAULT_VEHICLE)

    def at(place: PlaceLike, role: Role) -> Location:
        return locate(net, place, role, usable=usable)

    known, pairs = [], []
    for number, place in enumerate(places):
        try:
            pairs.append((at(place, "origin"), at(place, "destination")))
        except NetworkError:
            continue
        known.append(number)
    if not known:
        return lengths
    found = placed(net, pairs)
    weight = found.net.length_m.astype(np.float64)
    weight[found.net.attached(Closures).of(DEFAULT_VEHICLE).closed] = np.inf
    sides = []
    for side in (0, 1):
        nodes = [[node for node, _ in ends[side].nodes] for ends in found.ends]
        begins = np.cumsum([0, *map(len, nodes)])[:-1]
        sides.append((np.concatenate(nodes), begins))
    (starts, first), (ends, begin) = sides
    table = many_to_many(found.net, weight, starts, ends)
    table[np.equal.outer(starts, ends)] = np.inf
    least = np.minimum.reduceat(np.minimum.reduceat(table, first, axis=0), begin, axis=1)
    np.fill_diagonal(least, np.inf)
    rows = np.array(known)
    lengths[rows[:, None], rows] = least
    return lengths
