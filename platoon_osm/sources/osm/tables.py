"""Maps that are not OSM files, given as ways, nodes and turns with tags, to be read as one is.

Whatever a road comes from, an answer of Overpass, a table of lines or Overture's segments: once it
is ways over nodes with tags, it is read by the same code, and a tag means the same everywhere.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...errors import MapDataError
from ...network.load_report import Source
from ..stops.features import is_for_others
from .areas import areas_of
from .borders import borders_of
from .raw_map import NODE_TAGS, TURN_TAGS, RawMap, TagReader

__all__ = ["MapNode", "MapTurn", "MapWay", "raw_map"]

Tags = Mapping[str, str]

SPECIAL = re.compile(r"[^\w.:/+*()<>;&!?'\"|-]")


class MapWay(NamedTuple):
    """A way: its id, the ids of its nodes in order, its tags."""

    number: int
    nodes: list[int]
    tags: Tags


class MapNode(NamedTuple):
    """A node: longitude and latitude [deg], and its tags."""

    lon: float
    lat: float
    tags: Tags


class MapTurn(NamedTuple):
    """A relation that forbids a turn: its id, its members (kind, id, role), its tags."""

    number: int
    members: tuple[tuple[str, int, str], ...]
    tags: Tags


def raw_map(
    what: str,
    source: Source,
    ways: Iterable[MapWay],
    nodes: Mapping[int, MapNode],
    turns: Iterable[MapTurn] = (),
    *,
    classes: Collection[str],
    left_out: Mapping[str, int],
    others: Mapping[str, int] | None = None,
) -> RawMap:
    """Return a map in the form in which OSM files are read.

    Parameters
    ----------
    what : str
        The file, to begin messages with.
    source : Source
        Where it is from.
    ways : iterable of MapWay
        An id may stand for several, where no turn names it.
    nodes : mapping of int to MapNode
        By id; one that a way names may be missing.
    turns : iterable of MapTurn
        Relations; those that forbid no turn and are no area where trucks stop are left out.
    classes : collection of str
        Values of `highway` to keep, besides ferries and places.
    left_out : mapping of str to int
        What was left out already, by reason.
    others : mapping of str to int, optional
        Roads of other classes that were left out already, by class.

    Returns
    -------
    RawMap
        Ready for `extract.network_of`.

    Raises
    ------
    MapDataError
        No road of these classes; the message names those there are.
    """
    counts, found = Counter(left_out), Counter(others or {})
    kept: list[MapWay] = []
    ways, turns = list(ways), list(turns)
    for way in ways:
        highway = way.tags.get("highway", "")
        found.update([highway] if highway else [])
        of_wish = highway in classes or way.tags.get("route") == "ferry"
        if of_wish or _is_wanted(way.tags):
            kept.append(way)
    other = sum(number for kind, number in found.items() if kind not in classes)
    counts.update({"ways left out: other road class": other} if other else {})
    if not any(found[kind] for kind in classes):
        told = ", ".join(f"{kind} ({count:,})" for kind, count in found.most_common(8))
        raise MapDataError(
            f"{what}: no road of class {', '.join(classes)}; found: {told or 'no road at all'}; "
            "choose other classes or a larger area"
        )
    related = [(turn.number, _text(turn.tags), turn.members) for turn in turns]

    def lines_of(wanted: set[int]) -> dict[int, NDArray[np.float64]]:
        return {
            way.number: np.array(
                [nodes[node][:2] for node in way.nodes if node in nodes], np.float64
            ).reshape(-1, 2)
            for way in ways
            if way.number in wanted
        }

    high = sorted(number for number, node in nodes.items() if "ele" in node.tags)
    sizes = [len(way.nodes) for way in kept]
    refs = [node for way in kept for node in way.nodes]
    nowhere = MapNode(np.nan, np.nan, {})
    places = np.array([nodes.get(node, nowhere)[:2] for node in refs], np.float64).reshape(-1, 2)
    return RawMap(
        source=source,
        way_id=np.array([way.number for way in kept], np.int64),
        way_tags=tuple(_text(way.tags) for way in kept),
        first=np.concatenate([[0], np.cumsum(sizes, dtype=np.int64)]).astype(np.int64),
        ref=np.array(refs, np.int64),
        lon=places[:, 0].copy(),
        lat=places[:, 1].copy(),
        nodes=tuple(
            (number, _text(node.tags), node.lon, node.lat)
            for number, node in nodes.items()
            if _is_wanted(node.tags)
        ),
        turns=tuple(one for one, turn in zip(related, turns, strict=True) if _forbids(turn.tags)),
        areas=areas_of(related, lines_of),
        borders=borders_of(related, TagReader(bool), lines_of),
        left_out=dict(counts),
        height_of=np.array(high, np.int64),
        heights=tuple(nodes[number].tags["ele"] for number in high),
    )


def _forbids(tags: Tags) -> bool:
    return ("type", tags.get("type", "")) in TURN_TAGS


def _is_wanted(tags: Tags) -> bool:
    return not is_for_others(tags) and any(pair in NODE_TAGS for pair in tags.items())


def _text(tags: Tags) -> str:
    """Return tags as OPL has them: pairs with commas between, special characters as %hex%."""
    return ",".join(f"{_escaped(key)}={_escaped(value)}" for key, value in tags.items())


def _escaped(text: str) -> str:
    return SPECIAL.sub(lambda found: f"%{ord(found.group()):x}%", text)
