"""From what people say, a name or a coordinate, to a node of the network."""

from __future__ import annotations

from collections.abc import Mapping
from collections.abc import Set as AnySet
from dataclasses import replace
from typing import Any, get_args

import numpy as np

from ..errors import NetworkError
from .access import STANDARD_ACCESS, Access
from .by_name import located_by_name
from .coordinate_text import coordinates_in
from .location import Location, Place, Role
from .naming import node_name
from .nearest_road import located_at
from .road_network import RoadNetwork, checked_network
from .usable_nodes import UsableNodes

__all__ = ["locate"]


class RoleError(NetworkError, ValueError):
    """A role in a trip that is none."""


def locate(
    net: RoadNetwork,
    place: Any = None,
    role: Role = "any",
    *,
    osmid: Any = None,
    label: Any = None,
    access: Access = STANDARD_ACCESS,
    usable: UsableNodes | None = None,
) -> Location:
    """Find a place on the network.

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    place : int, (float, float), Location, Place or str
        A node position; longitude and latitude in degrees; a `Location`, which stays what it is;
        a `Place`; a text such as "10.22, 45.54", longitude first; or the name of a junction or
        town, in any case and without accents if need be;
        "Novara Est (A4)" tells two of the same name apart.
    role : {"origin", "destination", "any"}
        "origin" takes nodes from which the main network can be reached, "destination" nodes
        that can be reached from it, "any" nodes that can do both.
    osmid : int, optional
        Id of an OpenStreetMap node, instead of `place`.
    label : str, optional
        What the place is to be called, instead of the name found for it.
    access : Access
        Of a point: what counts as on the road, and how far beside it a place may be.
    usable : UsableNodes, optional
        The nodes and edges that are open to a vehicle; by default those of all.

    Returns
    -------
    Location
        The place, with the nodes where a trip may start or end.

    Raises
    ------
    NetworkError
        No such node, id or name (with the nearest spellings), several places of that name
        (listed), coordinates off the globe or far from every road, or a role that is none.
    """
    net = checked_network(net)
    if not isinstance(access, Access):
        raise NetworkError(f"access {_shown(access)} is none; give an Access")
    if not isinstance(role, str) or role not in get_args(Role):
        raise RoleError(f"role {_shown(role)} is unknown; use {', '.join(get_args(Role))}")
    if osmid is not None or label is not None:
        if isinstance(place, Place):
            raise NetworkError("place: a Place says all; give no osmid or label beside it")
        place = Place(place, osmid=osmid, label=label)
    if isinstance(place, Place):
        if place.osmid is not None:
            found = _at_nodes(net, *_known_osmid(net, place.osmid))
        else:
            found = locate(net, place.at, role, access=access, usable=usable)
        return replace(found, name=place.label) if place.label else found
    if isinstance(place, str):
        pair = coordinates_in(place)
        if pair is None:
            return located_by_name(net, place, role, access, usable)
        place = pair
    if isinstance(place, Location):
        _check_location(net, place)
        return place
    if isinstance(place, int | np.integer) and not isinstance(place, bool):
        return _at_nodes(net, _node(net, place))
    lon, lat = _coordinates(place)
    return located_at(net, lon, lat, role, None, access, usable)


def _at_nodes(net: RoadNetwork, *nodes: int) -> Location:
    node = nodes[0]
    at = float(net.lon[node]), float(net.lat[node])
    name = node_name(net, node)
    candidates = tuple((own, 0.0) for own in nodes)
    return Location(node, name.text, *at, 0.0, candidates, from_geonames=name.from_geonames)


def _check_location(net: RoadNetwork, place: Location) -> None:
    for node, _ in ((place.node, 0.0), *place.candidates):
        _node(net, node)
    for point in (*place.on_road, *place.enters):
        if not 0 <= point.edge < net.m:
            raise NetworkError(
                f"{place.name} lies on edge {_shown(point.edge)}, the network has edges 0 to "
                f"{net.m - 1}; locate it on this network"
            )


def _shown(value: object) -> str:
    return " ".join(repr(value).split())[:80]


def _node(net: RoadNetwork, node: Any) -> int:
    if not 0 <= node < net.n:
        known = _nodes_of_osmid(net, int(node))
        raise NetworkError(
            f"node {_shown(node)}: the network has nodes 0 to {net.n - 1}"
            + (f"; for the OpenStreetMap id, give osmid={node}" if known else "")
        )
    return int(node)


def _nodes_of_osmid(net: RoadNetwork, osmid: int) -> list[int]:
    fits = -(2**63) <= osmid < 2**63
    return np.flatnonzero(net.node_id == osmid).tolist() if fits else []


def _known_osmid(net: RoadNetwork, osmid: int) -> list[int]:
    if nodes := _nodes_of_osmid(net, osmid):
        return nodes
    if osmid in net.way_id and osmid:
        remedy = "that is the id of a way; give one of its junctions"
    else:
        remedy = "only junctions and ends of roads are kept; give (lon, lat) instead"
    raise NetworkError(
        f"osmid {_shown(osmid)}: no node of {net.source.name} has that OpenStreetMap id; {remedy}"
    )


def _coordinates(place: Any) -> tuple[float, float]:
    try:
        # Neither has an order in which longitude comes first, though Python would make one.
        if isinstance(place, Mapping | AnySet | bytes | bytearray):
            raise TypeError
        lon, lat = (float(value) for value in place)
    except (TypeError, ValueError, OverflowError):
        raise NetworkError(
            f"place {_shown(place)}: give a node, a (lon, lat) pair in degrees or a name"
        ) from None
    if not (abs(lon) <= 180 and abs(lat) <= 90):
        raise NetworkError(
            f"place ({lon}, {lat}): longitude comes first and must lie within [-180, 180], "
            "latitude within [-90, 90]"
        )
    return lon, lat
