"""From a text that names an exit to the places it may mean."""

from __future__ import annotations

from collections.abc import Iterable

from .antimeridian import mean_longitude_deg
from .exit_numbers import ExitNumbers, ExitReading, exit_readings
from .geodesy import distance_m
from .naming import node_name, towns_around
from .place_index import SAME_PLACE_M, NamedPlace, gap_m
from .road_network import RoadNetwork
from .spelling import fold, road_keys
from .towns.surroundings import FARTHEST_TOWN_M

__all__ = ["exit_places", "exits_of_that_number", "place_of"]


def exit_places(net: RoadNetwork, text: str) -> list[NamedPlace]:
    """Return the exits that a text may mean.

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    text : str
        Such as "A 1 exit 4", "exit 4 (A 1)", "I 5 exit 519B, Sacramento" or "12A".

    Returns
    -------
    list of NamedPlace
        Nodes of one number and road near each other are one place. Empty if it means none.
    """
    for reading in exit_readings(text):
        if groups := _groups(net, reading):
            return [place_of(net, group, "exit") for group in groups]
    return []


def exits_of_that_number(net: RoadNetwork, text: str) -> list[NamedPlace]:
    """Return the exits whose number a text has, on whatever road, to say what there is.

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    text : str
        Such as "A 99 exit 4".

    Returns
    -------
    list of NamedPlace
        Empty if no exit has the number.
    """
    for reading in exit_readings(text):
        if groups := _groups(net, ExitReading(reading.number)):
            return [place_of(net, group, "exit") for group in groups]
    return []


def place_of(net: RoadNetwork, nodes: list[int], kind: str) -> NamedPlace:
    """Return the place that some nodes are, named as its first node is.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    nodes : list of int
        Node positions.
    kind : str
        "exit" or "road".

    Returns
    -------
    NamedPlace
        The place.
    """
    name = node_name(net, nodes[0])
    refs = frozenset(ref for node in nodes for ref in net.incident_refs(node))
    lon, lat = mean_longitude_deg(net.lon[nodes]), float(net.lat[nodes].mean())
    # An exit that has a name too is a junction of that name.
    kind = "junction" if net.junction_name(nodes[0]).strip() else kind
    return NamedPlace(
        name.text, kind, lon, lat, tuple(nodes), refs, from_geonames=name.from_geonames
    )


def _groups(net: RoadNetwork, reading: ExitReading) -> list[list[int]]:
    numbers = net.attached(ExitNumbers)
    nodes = numbers.carrying(reading.number)
    if roads := road_keys([reading.roads]):
        nodes = [node for node in nodes if roads <= numbers.roads(node)]
    elif reading.roads:
        return []
    groups = _on_one_road(net, numbers, nodes)
    return _near_town(net, groups, fold(reading.town)) if reading.town else groups


def _on_one_road(net: RoadNetwork, numbers: ExitNumbers, nodes: Iterable[int]) -> list[list[int]]:
    """Put nodes together that are near each other and share a road, or have none."""
    groups: list[list[int]] = []
    # Gates and ramps without a number of the road come last, to join the exit they belong to.
    for node in sorted(nodes, key=lambda node: not numbers.roads(node)):
        own = numbers.roads(node)
        for group in groups:
            theirs = numbers.roads(group[0])
            if (own & theirs or not own) and gap_m(net, group[0], node) <= SAME_PLACE_M:
                group.append(node)
                break
        else:
            groups.append([node])
    return groups


def _near_town(net: RoadNetwork, groups: list[list[int]], town: str) -> list[list[int]]:
    """Keep the exits that are known by a town, or else lie in its reach."""
    around = towns_around(net)
    known = []
    for group in groups:
        nearest = (around.nearest(float(net.lon[node]), float(net.lat[node])) for node in group)
        if any(near is not None and town in near.spellings for near in nearest):
            known.append(group)
    if known:
        return known
    at = around.positions(town)
    return [
        group
        for group in groups
        if any(
            float(distance_m(net.lon[group[0]], net.lat[group[0]], *place)) <= FARTHEST_TOWN_M
            for place in at
        )
    ]
