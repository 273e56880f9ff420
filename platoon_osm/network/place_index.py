"""The names of a network's map: which junctions and towns a name may mean."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from .antimeridian import mean_longitude_deg
from .geodesy import distance_m
from .road_network import POINT_KINDS, RoadNetwork, format_position
from .spelling import fold, road_keys

__all__ = ["SAME_PLACE_M", "NamedPlace", "PlaceIndex", "clusters", "gap_m", "join_towns"]

SAME_PLACE_M = 6_000.0
"""Nodes of one name nearer than this are one place: its carriageways, ramps and toll gates."""

TOWN_AND_JUNCTION_M = 15_000.0
"""A junction named like a town and nearer to it than this is that town's junction."""


@dataclass(frozen=True, slots=True)
class NamedPlace:
    """One place that a name may mean: a cluster of nodes, or a town.

    Attributes
    ----------
    name : str
        As the map writes it.
    kind : str
        "junction", "exit", "road", or the kind of town.
    lon, lat : float
        Its middle [deg].
    nodes : tuple of int
        Nodes of a junction; none of a town.
    refs : frozenset of str
        Road numbers that meet there.
    where : str
        Region and country of a town that is not from the map.
    from_geonames : bool
        Whether the place, or a town in its name, is from GeoNames.
    """

    name: str
    kind: str
    lon: float
    lat: float
    nodes: tuple[int, ...]
    refs: frozenset[str]
    where: str = ""
    from_geonames: bool = False

    def roads(self) -> set[str]:
        """Return the road numbers as they are compared: "A 4;E 64" is the a4 and the e64.

        Returns
        -------
        set of str
            Folded, without spaces.
        """
        return road_keys(self.refs)

    def label(self) -> str:
        """Return how the place is told from others of its name.

        Returns
        -------
        str
            Name, roads or kind, and coordinates.
        """
        at = format_position(self.lon, self.lat)
        if self.where:
            return f"{self.name}, {self.where} ({at})"
        if self.kind in ("exit", "road"):
            return f"{self.name} at {at}"
        roads = ", ".join(sorted(self.refs)) or self.kind
        return f"{self.name} ({roads}) at {at}"


class PlaceIndex:
    """Junctions and towns of a network by name; kept with it by `net.attached`.

    Parameters
    ----------
    net : RoadNetwork
        Whose names.
    """

    def __init__(self, net: RoadNetwork) -> None:
        self._places: dict[str, list[NamedPlace]] = {}
        by_name: dict[int, list[int]] = {}
        for node in np.flatnonzero(net.node_name):
            by_name.setdefault(int(net.node_name[node]), []).append(int(node))
        for code, nodes in by_name.items():
            for group in clusters(net, nodes):
                refs = frozenset(ref for v in group for ref in net.incident_refs(v))
                lon, lat = mean_longitude_deg(net.lon[group]), float(net.lat[group].mean())
                self._add(NamedPlace(net.texts[code], "junction", lon, lat, tuple(group), refs))
        points = net.points
        for i in np.flatnonzero(points.kind >= POINT_KINDS.index("city")):
            name, kind = net.texts[points.name[i]], POINT_KINDS[points.kind[i]]
            at = float(points.lon[i]), float(points.lat[i])
            self._add(NamedPlace(name, kind, *at, (), frozenset()))

    def _add(self, place: NamedPlace) -> None:
        if key := fold(place.name):
            self._places.setdefault(key, []).append(place)

    def called(self, folded: str) -> list[NamedPlace]:
        """Return the places of a name.

        Parameters
        ----------
        folded : str
            A name as `fold` returns it.

        Returns
        -------
        list of NamedPlace
            Empty if there are none.
        """
        return self._places.get(folded, [])

    def containing(self, folded: str) -> list[NamedPlace]:
        """Return the places in whose name some words stand.

        Parameters
        ----------
        folded : str
            The words as `fold` returns them.

        Returns
        -------
        list of NamedPlace
            Empty if there are none.
        """
        return [
            item
            for key, items in self._places.items()
            if f" {folded} " in f" {key} "
            for item in items
        ]

    def nearest_spellings(self, folded: str) -> list[str]:
        """Return names that are spelt nearly like one.

        Parameters
        ----------
        folded : str
            A name as `fold` returns it.

        Returns
        -------
        list of str
            At most four, as the map writes them.
        """
        near = difflib.get_close_matches(folded, self._places, 4, 0.6)
        return [self._places[key][0].name for key in near]


def join_towns(matches: Iterable[NamedPlace]) -> list[NamedPlace]:
    """Leave out a town where a junction of the same name stands for it, and the reverse.

    Parameters
    ----------
    matches : iterable of NamedPlace
        Places of one name.

    Returns
    -------
    list of NamedPlace
        Those among which somebody must choose.
    """
    junctions = [item for item in matches if item.kind == "junction"]
    towns = [item for item in matches if item.kind != "junction"]
    lonely = [
        town
        for town in towns
        if all(
            distance_m(town.lon, town.lat, item.lon, item.lat) > TOWN_AND_JUNCTION_M
            for item in junctions
        )
    ]
    cities = [town for town in lonely if town.kind == "city"]
    # "Torino" means the city, even where some far exit carries the same name.
    return cities if len(cities) == 1 else junctions + lonely


def clusters(net: RoadNetwork, nodes: list[int]) -> list[list[int]]:
    """Split nodes of one name into places, each within `SAME_PLACE_M` of its first node.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    nodes : list of int
        Node positions.

    Returns
    -------
    list of list of int
        The nodes of each place.
    """
    groups: list[list[int]] = []
    for node in nodes:
        for group in groups:
            if gap_m(net, group[0], node) <= SAME_PLACE_M:
                group.append(node)
                break
        else:
            groups.append([node])
    return groups


def gap_m(net: RoadNetwork, one: int, other: int) -> float:
    """Return the distance [m] between two nodes as the crow flies.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    one, other : int
        Node positions.

    Returns
    -------
    float
        Metres.
    """
    return float(distance_m(net.lon[one], net.lat[one], net.lon[other], net.lat[other]))
