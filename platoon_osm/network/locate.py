"""From what people say, a name or a coordinate, to a node of the network."""

from __future__ import annotations

import difflib
import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, get_args

import numpy as np
from numpy.typing import NDArray

from ..errors import NetworkError
from .geodesy import distance_m, metres_per_degree
from .location import Location, Role
from .road_network import POINT_KINDS, RoadNetwork, format_position

__all__ = ["locate"]

SAME_PLACE_M = 6_000.0
"""Nodes of one name nearer than this are one place: its carriageways, ramps and toll gates."""

TOWN_AND_JUNCTION_M = 15_000.0
"""A junction named like a town and nearer to it than this is that town's junction."""

OTHER_CARRIAGEWAY_M = 1_500.0
"""How much farther than the nearest node another may be to count as a choice of carriageway."""

FARTHEST_ROAD_M = 200_000.0
"""A place farther than this from any road is not on this map: latitude and longitude exchanged,
another country, or nought and nought."""

MOST_CANDIDATES = 12

MOSTLY_CONNECTED = 0.5
"""Share of the road that the main component must hold to decide where trips may start and end."""


def locate(net: RoadNetwork, place: Any, role: Role = "any") -> Location:
    """Find a place on the network.

    Parameters
    ----------
    place : int (node position), (lon, lat) in degrees, a `Location`, or the name of a junction or
        town, in any case and without accents if need be; "Novara Est (A4)" tells two of the same
        name apart.
    role : "origin" takes nodes from which the main network can be reached, "destination" nodes
        that can be reached from it, "any" nodes that can do both.

    Raises
    ------
    NetworkError
        No such node or name (with the nearest spellings), several places of that name (listed),
        or coordinates off the globe or far from every road.
    """
    if role not in get_args(Role):
        raise ValueError(f"role {role!r} is unknown; use {', '.join(get_args(Role))}")
    if isinstance(place, Location):
        return place
    if isinstance(place, str):
        return _by_name(net, place, role)
    if isinstance(place, int | np.integer) and not isinstance(place, bool):
        node = int(place)
        if not 0 <= node < net.n:
            raise NetworkError(f"node {node}: the network has nodes 0 to {net.n - 1}")
        at = float(net.lon[node]), float(net.lat[node])
        return Location(node, net.place_name(node), *at, 0.0, ((node, 0.0),))
    try:
        lon, lat = (float(value) for value in place)
    except (TypeError, ValueError):
        raise NetworkError(
            f"place {repr(place)[:80]}: give a node, a (lon, lat) pair in degrees or a name"
        ) from None
    if not (abs(lon) <= 180 and abs(lat) <= 90):
        raise NetworkError(
            f"place ({lon}, {lat}): longitude comes first and must lie within [-180, 180], "
            "latitude within [-90, 90]"
        )
    return _by_coordinates(net, lon, lat, role, name=None)


def _usable(net: RoadNetwork, role: Role) -> NDArray[np.bool_]:
    """Mark nodes from which the main strong component is reached, or which it reaches, or both.

    Where most of the road is in no such component, as on a single motorway without a way back, it
    is no measure: then a trip may start wherever a road leads on, and end wherever one arrives.
    """
    key = f"usable {role}"
    if key not in net._kept:
        main = net.strong_component() == 0
        inside = float(net.length_m[main[net.tail] & main[net.head]].sum())
        if not inside or inside < MOSTLY_CONNECTED * float(net.length_m.sum()):
            leaves = np.diff(net.first_out) > 0
            arrives = np.bincount(net.head, minlength=net.n) > 0
            net._kept[key] = {
                "origin": leaves, "destination": arrives, "any": leaves | arrives
            }[role]  # fmt: skip
        elif role == "any":
            net._kept[key] = main
        else:
            net._kept[key] = _closure(net, main, backward=role == "origin")
    usable: NDArray[np.bool_] = net._kept[key]
    return usable


def _closure(net: RoadNetwork, inside: NDArray[np.bool_], backward: bool) -> NDArray[np.bool_]:
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import breadth_first_order

    # One extra node leads to the whole component, so that one walk finds all that hangs on it.
    start = np.flatnonzero(inside)
    ends = (net.head, net.tail) if backward else (net.tail, net.head)
    tails = np.concatenate([ends[0], np.full(len(start), net.n)])
    heads = np.concatenate([ends[1], start])
    graph = csr_array((np.ones(len(tails), np.int8), (tails, heads)), shape=(net.n + 1, net.n + 1))
    seen = np.zeros(net.n + 1, bool)
    seen[breadth_first_order(graph, net.n, return_predecessors=False)] = True
    return seen[: net.n]


def _by_coordinates(
    net: RoadNetwork, lon: float, lat: float, role: Role, name: str | None
) -> Location:
    fits = _usable(net, role)
    usable = np.flatnonzero(fits)
    if not len(usable):
        raise NetworkError(
            f"place ({lon}, {lat}): {net.source.name} has no road to start or end on"
        )
    away = distance_m(net.lon[usable], net.lat[usable], lon, lat)
    order = np.argsort(away, kind="stable")
    limit = away[order[0]] + OTHER_CARRIAGEWAY_M
    chosen = [i for i in order[:MOST_CANDIDATES] if away[i] <= limit]
    candidates = tuple((int(usable[i]), float(away[i])) for i in chosen)
    node = candidates[0][0]
    road_m = _road_distance_m(net, fits[net.tail] | fits[net.head], lon, lat)
    if road_m > FARTHEST_ROAD_M:
        exchanged = abs(lon) <= 90 and distance_m(net.lon, net.lat, lat, lon).min() < road_m / 10
        raise NetworkError(
            f"place ({lon:g}, {lat:g}): {road_m / 1000:,.0f} km from the nearest road of "
            f"{net.source.name}; "
            + ("give longitude first, then latitude" if exchanged else "load a map of that region")
        )
    return Location(node, name or net.place_name(node), lon, lat, road_m, candidates)


def _road_distance_m(net: RoadNetwork, edges: NDArray[np.bool_], lon: float, lat: float) -> float:
    """Distance [m] from a point to the nearest of some edges, on a plane true to scale there."""
    per_lon, per_lat = metres_per_degree(lat)
    x, y = (net.shape_lon - lon) * per_lon, (net.shape_lat - lat) * per_lat
    ax, ay, dx, dy = x[:-1], y[:-1], np.diff(x), np.diff(y)
    joint = net.shape_first[1:-1] - 1
    dx[joint] = dy[joint] = 0.0
    square = dx**2 + dy**2
    share = np.divide(-(ax * dx + ay * dy), square, out=np.zeros_like(square), where=square > 0)
    share = np.clip(share, 0, 1)
    away = (ax + share * dx) ** 2 + (ay + share * dy) ** 2
    # An edge has one point more than straight pieces: the last "piece" leads to the next edge.
    return float(np.sqrt(away[np.repeat(edges, np.diff(net.shape_first))[:-1]].min()))


# -- names ---------------------------------------------------------------------------------------


LETTERS = str.maketrans({"ł": "l", "ø": "o", "đ": "d", "ð": "d", "ı": "i", "æ": "ae", "œ": "oe"})
"""Letters that people without them on the keyboard write so; Unicode does not decompose them."""


def fold(text: str) -> str:
    """Reduce a name to what people remember of it: no case, accents, punctuation or spaces."""
    plain = unicodedata.normalize("NFKD", text.casefold().translate(LETTERS))
    return re.sub(r"[\W_]+", " ", "".join(c for c in plain if not unicodedata.combining(c))).strip()


@dataclass(frozen=True, slots=True)
class _Named:
    """One named place: a cluster of junction nodes, or a town."""

    name: str
    kind: str
    lon: float
    lat: float
    nodes: tuple[int, ...]
    refs: frozenset[str]

    def roads(self) -> set[str]:
        """Return the road numbers as they are compared: "A 4;E 64" is the a4 and the e64."""
        return {fold(part).replace(" ", "") for ref in self.refs for part in ref.split(";")}

    def label(self) -> str:
        """Return how the place is told from others of its name."""
        roads = ", ".join(sorted(self.refs)) or self.kind
        return f"{self.name} ({roads}) at {format_position(self.lon, self.lat)}"


def _by_name(net: RoadNetwork, text: str, role: Role) -> Location:
    found = re.fullmatch(r"\s*(.+?)\s*(?:\(([^()]*)\))?\s*", text, re.DOTALL)
    wanted = fold(found.group(1)) if found else ""
    road = fold(found.group(2) or "").replace(" ", "") if found else ""
    if not wanted:
        raise NetworkError(f"place {text!r}: an empty name; give a junction, a town or (lon, lat)")
    index = _name_index(net)
    if road and fold(text) in index:
        # The brackets belong to the name, as in "Frankfurt (Oder)".
        wanted, road = fold(text), ""
    matches = index.get(wanted) or [
        item for key, items in index.items() if f" {wanted} " in f" {key} " for item in items
    ]
    shown = f"place {text[:80]!r}"
    if road and matches:
        there = [item for item in matches if road in item.roads() | {item.kind}]
        if not there:
            listed = "; ".join(item.label() for item in matches[:6])
            raise NetworkError(f"{shown}: not on that road; there is {listed}")
        matches = there
    if not matches:
        near = difflib.get_close_matches(wanted, index, 4, 0.6)
        hint = ", ".join(index[key][0].name for key in near)
        raise NetworkError(
            f"{shown}: no junction or town of that name in {net.source.name}; "
            + (f"did you mean {hint}?" if hint else "give (lon, lat) instead")
        )
    matches = _join_towns(matches)
    if len(matches) > 1:
        listed = "; ".join(item.label() for item in matches[:6])
        more = f"; and {len(matches) - 6} more" if len(matches) > 6 else ""
        raise NetworkError(
            f"{shown} is ambiguous: {listed}{more}; add the road in brackets, as in "
            f'"{matches[0].name} ({next(iter(sorted(matches[0].refs)), "A1")})", or give (lon, lat)'
        )
    match = matches[0]
    usable = _usable(net, role)
    nodes = [node for node in match.nodes if usable[node]]
    if not nodes:
        return _by_coordinates(net, match.lon, match.lat, role, match.name)
    candidates = _ranked(net, nodes)
    return Location(candidates[0][0], match.name, match.lon, match.lat, 0.0, candidates)


def _ranked(net: RoadNetwork, nodes: list[int]) -> tuple[tuple[int, float], ...]:
    """Nodes of a junction with zero access distance, those where ramps begin and end first."""
    link = (net.road_class % 2 == 1).astype(np.int64)
    ramps = np.bincount(net.tail, link, net.n) + np.bincount(net.head, link, net.n)
    own = np.bincount(net.tail, 1 - link, net.n) + np.bincount(net.head, 1 - link, net.n)
    # A gate, touched by ramps alone, serves both directions, so it is the best place to start.
    ranked = sorted(nodes, key=lambda v: (own[v] > 0, ramps[v] == 0, v))
    return tuple((int(node), 0.0) for node in ranked[:MOST_CANDIDATES])


def _join_towns(matches: Iterable[_Named]) -> list[_Named]:
    """Leave out a town where a junction of the same name stands for it, and the reverse."""
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


def _name_index(net: RoadNetwork) -> dict[str, list[_Named]]:
    if "names" in net._kept:
        kept: dict[str, list[_Named]] = net._kept["names"]
        return kept
    index: dict[str, list[_Named]] = {}
    by_name: dict[int, list[int]] = {}
    for node in np.flatnonzero(net.node_name):
        by_name.setdefault(int(net.node_name[node]), []).append(int(node))
    for code, nodes in by_name.items():
        name = net.texts[code]
        for group in _clusters(net, nodes):
            refs = frozenset(ref for v in group for ref in net.incident_refs(v))
            lon, lat = float(net.lon[group].mean()), float(net.lat[group].mean())
            index.setdefault(fold(name), []).append(
                _Named(name, "junction", lon, lat, tuple(group), refs)
            )
    points = net.points
    for i in np.flatnonzero(points.kind >= POINT_KINDS.index("city")):
        name, kind = net.texts[points.name[i]], POINT_KINDS[points.kind[i]]
        index.setdefault(fold(name), []).append(
            _Named(name, kind, float(points.lon[i]), float(points.lat[i]), (), frozenset())
        )
    net._kept["names"] = index
    return index


def _clusters(net: RoadNetwork, nodes: list[int]) -> list[list[int]]:
    """Split nodes of one name into places, each within `SAME_PLACE_M` of its first node."""
    groups: list[list[int]] = []
    for node in nodes:
        for group in groups:
            first = group[0]
            gap = distance_m(net.lon[first], net.lat[first], net.lon[node], net.lat[node])
            if gap <= SAME_PLACE_M:
                group.append(node)
                break
        else:
            groups.append([node])
    return groups
