"""From a name to a place: a junction, an exit, a town of the map or of the table.

The map comes first: its junctions and towns of that very name, its exits, names in which the words
stand; then the towns of GeoNames in reach of the roads; then what the program itself prints for
nodes without a name. The first of these that knows the text decides, and if it knows several places
of that name, they are listed.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

from ..errors import NetworkError
from .access import STANDARD_ACCESS, Access
from .coordinate_text import printed_position
from .exit_numbers import has_exit_word
from .exit_places import exit_places, exits_of_that_number, place_of
from .location import Location, Role
from .naming import towns_around
from .nearest_road import MOST_CANDIDATES, located_at
from .place_index import NamedPlace, PlaceIndex, join_towns
from .printed_names import nodes_printed_as
from .road_network import RoadNetwork
from .spelling import bracket_apart, fold
from .towns.surroundings import GEONAMES, Town
from .usable_nodes import UsableNodes

__all__ = ["located_by_name"]

MOST_LISTED = 6
"""So many places are named where somebody must choose."""

LONGEST_LIST = 300
"""Characters of such a list, for a message stays a line that can be read."""


def located_by_name(
    net: RoadNetwork,
    text: str,
    role: Role,
    access: Access = STANDARD_ACCESS,
    usable: UsableNodes | None = None,
) -> Location:
    """Find a place by its name.

    Parameters
    ----------
    net : RoadNetwork
        Where to look.
    text : str
        The name of a junction or town, or an exit.
    role : {"origin", "destination", "any"}
        What its nodes are to be.
    access : Access
        How far from the road a position may be, if the text prints one.
    usable : UsableNodes, optional
        The nodes and edges that are open to a vehicle; by default those of all.

    Returns
    -------
    Location
        The place.

    Raises
    ------
    NetworkError
        No such place, or several.
    """
    shown = f"place {text[:80]!r}"
    name, bracket = _folded_apart(text)
    if not re.search(r"\w", name) and not net.attached(PlaceIndex).called(fold(text)):
        raise NetworkError(f"{shown}: an empty name; give a junction, a town or (lon, lat)")
    places = _meant(net, text, name, bracket)
    if not places and (at := printed_position(text)) is not None:
        return located_at(net, *at, role, None, access, usable)
    if not places:
        raise NetworkError(f"{shown}: {_why_none(net, text, name, bracket)}")
    if len(places) > 1:
        raise NetworkError(f"{shown} is ambiguous: {_listed(places)}; {_how_to_choose(places)}")
    return _location(net, places[0], role, text, usable or net.attached(UsableNodes))


def _folded_apart(text: str) -> tuple[str, str]:
    name, bracket = bracket_apart(text)
    return fold(name), fold(bracket).replace(" ", "")


def _meant(net: RoadNetwork, text: str, name: str, bracket: str) -> list[NamedPlace]:
    index = net.attached(PlaceIndex)

    def told_apart(places: list[NamedPlace]) -> list[NamedPlace]:
        if bracket:
            places = [item for item in places if bracket in item.roads() | {item.kind}]
        return join_towns(places)

    # The brackets may belong to the name, as in "Frankfurt (Oder)".
    if places := join_towns(index.called(fold(text))):
        return places
    if has_exit_word(text) and (places := exit_places(net, text)):
        return places
    if places := told_apart(index.called(name)) or exit_places(net, text):
        return places
    inside = told_apart(index.containing(name))
    if len(inside) == 1:
        return inside
    if places := [_named(town) for town in _towns(net, text)] or inside:
        return places
    return [place_of(net, nodes, "road") for nodes in nodes_printed_as(net, text)]


def _towns(net: RoadNetwork, text: str) -> list[Town]:
    """Return towns of the table: by name, or by name and what they lie in."""
    around = towns_around(net)
    if found := around.called(fold(text)):
        return found
    for name, *others in _qualified(text):
        lies_in = {fold(other) for other in others}
        if found := [town for town in around.called(fold(name)) if lies_in <= town.lies_in]:
            return found
    return []


def _qualified(text: str) -> list[list[str]]:
    """Read "Springfield, Illinois", "Springfield (IL)" and "Springfield, IL, USA" as such."""
    parts = [part.strip() for part in re.split(r"[,()]", text) if part.strip()]
    return [parts] if len(parts) > 1 else []


def _named(town: Town) -> NamedPlace:
    return NamedPlace(
        town.name, GEONAMES, town.lon, town.lat, (), frozenset(), town.where, from_geonames=True
    )


def _location(
    net: RoadNetwork, match: NamedPlace, role: Role, text: str, usable: UsableNodes
) -> Location:
    fits = usable.of(role)
    nodes = [node for node in match.nodes if fits[node]]
    if nodes:
        candidates = _ranked(net, nodes)
        found = Location(candidates[0][0], match.name, match.lon, match.lat, 0.0, candidates)
    else:
        found = located_at(net, match.lon, match.lat, role, match.name, STANDARD_ACCESS, usable)
    return replace(found, note=_note(match, text), from_geonames=match.from_geonames)


def _note(match: NamedPlace, text: str) -> str:
    """Say what a text was taken for, where the name found does not say it by itself."""
    own, (name, _) = " ".join(text.split())[:80], _folded_apart(text)
    if match.where:
        return f"{own!r} is taken for {match.label()}, from {GEONAMES}"
    found = fold(match.name)
    if match.kind not in ("exit", "road") and name != found and f" {name} " in f" {found} ":
        return f"{own!r} is taken for {match.label()}"
    return ""


def _ranked(net: RoadNetwork, nodes: list[int]) -> tuple[tuple[int, float], ...]:
    """Nodes of a junction with zero access distance, those where ramps begin and end first."""
    link = (net.road_class % 2 == 1).astype(np.int64)
    ramps = np.bincount(net.tail, link, net.n) + np.bincount(net.head, link, net.n)
    own = np.bincount(net.tail, 1 - link, net.n) + np.bincount(net.head, 1 - link, net.n)
    # A gate, touched by ramps alone, serves both directions, so it is the best place to start.
    ranked = sorted(nodes, key=lambda v: (own[v] > 0, ramps[v] == 0, v))
    return tuple((int(node), 0.0) for node in ranked[:MOST_CANDIDATES])


def _listed(places: list[NamedPlace]) -> str:
    labels: list[str] = []
    for place in places[:MOST_LISTED]:
        labels.append(place.label())
        if len("; ".join(labels)) > LONGEST_LIST and len(labels) > 1:
            labels.pop()
            break
    more = f"; and {len(places) - len(labels)} more" if len(places) > len(labels) else ""
    return "; ".join(labels) + more


def _how_to_choose(places: list[NamedPlace]) -> str:
    first = places[0]
    if first.where:
        return f'add region or country, as in "{first.name}, {first.where}", or give (lon, lat)'
    if first.kind in ("exit", "road"):
        return f'add road and town, as in "{first.name}", or give (lon, lat)'
    road = next(iter(sorted(first.refs)), "A1")
    return f'add the road in brackets, as in "{first.name} ({road})", or give (lon, lat)'


def _why_none(net: RoadNetwork, text: str, name: str, bracket: str) -> str:
    index, around = net.attached(PlaceIndex), towns_around(net)
    if bracket and (others := index.called(name) or index.containing(name)):
        return f"not on that road; there is {_listed(others)}"
    if has_exit_word(text) and (exits := exits_of_that_number(net, text)):
        return f"no such exit there; there is {_listed(exits)}"
    what = "exit of that number, nor " if has_exit_word(text) else ""
    missing = f"no {what}junction or town of that name in {net.source.name}"
    digits = text.strip()
    if re.fullmatch(r"-?[0-9]{1,18}", digits) and (net.node_id == int(digits)).any():
        return f"{missing}; for the OpenStreetMap id, give osmid={int(digits)}"
    for town, *_ in _qualified(text):
        if elsewhere := around.called(fold(town)):
            return f"no such town there, but {_listed([_named(item) for item in elsewhere])}"
    near = [*index.nearest_spellings(name), *around.nearest_spellings(name)]
    if near:
        return f"{missing}; did you mean {', '.join(dict.fromkeys(near[:4]))}?"
    if (far := around.called_elsewhere(name)) is not None:
        return f"{missing}; {far.label()} is not within reach of its roads"
    return f"{missing}; give (lon, lat) instead"
