"""Roads and places of an OSM file, filtered and decoded in C++, before anyone interprets them.

libosmium filters the file, writes what is left as OPL, its line format, and gives the coordinates
of each way in one piece; numpy then reads all node lists in one go. That is faster than touching
each node and tag from Python, and no Python runs for objects that are not roads or named places.
"""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from math import nan
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import MapDataError
from ..file_identity import file_digest, osm_source
from ..stops.features import is_for_others
from .areas import area_outlines, lines_of
from .borders import BORDER, borders_of, code_of
from .file_faults import bad_node, misnamed, off_the_globe, why
from .file_kind import osm_file
from .josm import deleted_ways, new_node_positions
from .patchwork import fill_in, has_versions, last_states, newest, node_index
from .raw_map import NODE_TAGS, TURN, TURN_TAGS, RawMap, TagReader, unescaped, without_ways

__all__ = ["OsmNameError", "read_raw"]

WKB_HEADER = 18
"""Hex digits of a WKB line before its points: byte order, type and number of points."""


class OsmNameError(MapDataError):
    """A file whose name tells libosmium nothing, nor do its first bytes."""


def read_raw(path: Path, classes: Sequence[str]) -> RawMap:
    """Read the roads of some classes, and the places that give them names.

    Parameters
    ----------
    path : Path
        The file.
    classes : sequence of str
        Values of `highway` to keep.

    Returns
    -------
    RawMap
        What the file holds.

    Raises
    ------
    MapDataError
        The file is missing, not OSM, cut short, or has coordinates off the globe.
    """
    if not path.is_file():
        raise MapDataError(f"{path}: no such file; give an OSM extract or a name from `maps`")
    tags = [*(("highway", name) for name in classes), ("route", "ferry")]
    with tempfile.TemporaryDirectory(prefix="platoon-osm-") as folder:
        opl = Path(folder) / "roads.opl"
        found = _filter_to_opl(path, tags, opl)
        ways, nodes, relations = _split_lines(opl)
    coordinates = found.coordinates()
    lists = [line[2] for line in ways]
    count = np.fromiter((part.count("n") for part in lists), np.int64, len(lists))
    first = np.zeros(len(ways) + 1, np.int64)
    np.cumsum(count, out=first[1:])
    related = [_relation(line) for line in relations]
    raw = RawMap(
        source=osm_source(path.name, file_digest(path), found.extracted),
        way_id=np.fromiter((int(line[0][1:]) for line in ways), np.int64, len(ways)),
        way_tags=tuple(line[1][1:] for line in ways),
        first=first,
        ref=_node_ids(lists),
        lon=coordinates[:, 0].copy(),
        lat=coordinates[:, 1].copy(),
        nodes=tuple(_node(path, line) for line in nodes),
        turns=tuple(one for one in related if TURN in one[1]),
        areas=area_outlines(path, [one for one in related if TURN not in one[1]]),
        borders=borders_of(related, TagReader(bool), lambda wanted: lines_of(path, wanted)),
        left_out={},
        height_of=np.fromiter(sorted(found.heights), np.int64, len(found.heights)),
        heights=tuple(found.heights[node] for node in sorted(found.heights)),
    )
    fill_in(path, raw.ref, raw.lon, raw.lat)
    _place_new_nodes(path, raw)
    version = np.array(found.versions, np.int64)
    for reason in dict.fromkeys(found.gone.values()):
        ids = [way for way, why in found.gone.items() if why == reason]
        gone = np.isin(raw.way_id, np.array(ids, np.int64))
        version = version[~gone]
        raw = without_ways(raw, gone, f"ways left out: {reason}")
    deleted = found.deleted | (deleted_ways(path) if found.generator == "JOSM" else set())
    if deleted:
        gone = np.isin(raw.way_id, np.fromiter(deleted, np.int64, len(deleted)))
        version = version[~gone]
        raw = without_ways(raw, gone, "ways left out: deleted")
    again = newest(raw.way_id, version)
    return without_ways(raw, again, "ways left out: listed again further on")


def _place_new_nodes(path: Path, raw: RawMap) -> None:
    """Fill in the coordinates of nodes with negative ids."""
    at = np.flatnonzero(np.isnan(raw.lon) & (raw.ref < 0))
    if len(at):
        places = new_node_positions(path, raw.ref[at])
        for k, node in zip(at.tolist(), raw.ref[at].tolist(), strict=True):
            if node in places:
                raw.lon[k], raw.lat[k] = _on_the_globe(path, node, *places[node])


class _Collector:
    """Takes wanted objects from libosmium: tags and node ids as OPL, coordinates as they are.

    Both are written in C++; only the rare way whose nodes the file lacks is looked at in Python.

    Attributes
    ----------
    deleted : ways whose last version is a deletion, as in files with history.
    gone : ways whose last version is no road, and why.
    versions : those of the ways, in their order.
    extracted, generator : what the file's head says of itself.
    heights : what nodes say of their height, by their id.
    """

    def __init__(self, writer: Any) -> None:
        import osmium

        self._add_node, self._add_relation = writer.add_node, writer.add_relation
        self._add_way = writer.add_way
        self._line = osmium.geom.WKBFactory().create_linestring
        self._all = osmium.geom.ALL
        self._unfit: tuple[type[Exception], ...] = (osmium.InvalidLocationError, RuntimeError)
        self.shapes: list[str] = []
        self.deleted: set[int] = set()
        self.gone: dict[int, str] = {}
        self.versions: list[int] = []
        self.extracted = self.generator = ""
        self.heights: dict[int, str] = {}

    def node(self, node: Any) -> None:
        if not is_for_others(node.tags):
            self._add_node(node)

    def relation(self, relation: Any) -> None:
        # Boundaries are many, of parishes and parks too.
        bounds = relation.tags.get(BORDER[0]) == BORDER[1] and "highway" not in relation.tags
        if not is_for_others(relation.tags) and (not bounds or code_of(relation.tags)):
            self._add_relation(relation)

    def way(self, way: Any) -> None:
        if way.deleted:
            self.deleted.add(way.id)
            return
        tags = way.tags
        # Asked first, for most ways are roads.
        if "amenity" in tags and is_for_others(tags):
            return
        if self.deleted:
            self.deleted.discard(way.id)
        self._add_way(way)
        self.versions.append(way.version)
        try:
            self.shapes.append(self._line(way, self._all)[WKB_HEADER:])
        except self._unfit:
            if any(off_the_globe(node.location) for node in way.nodes):
                raise
            points = [
                (node.location.lon, node.location.lat) if node.location.valid() else (nan, nan)
                for node in way.nodes
            ]
            self.shapes.append(np.array(points, "<f8").tobytes().hex())

    def coordinates(self) -> NDArray[np.float64]:
        """Return longitude and latitude (k, 2) of all nodes of all ways."""
        return np.frombuffer(bytes.fromhex("".join(self.shapes)), "<f8").reshape(-1, 2)


class _Heights:
    """Notes `ele` of every node that has one, on the road or not, before others are dropped."""

    def __init__(self, heights: dict[int, str]) -> None:
        self._heights = heights

    def node(self, node: Any) -> None:
        text = node.tags.get("ele")
        if text is not None:
            self._heights[node.id] = text
        elif self._heights:
            # A later version of a node may have lost it.
            self._heights.pop(node.id, None)


def _filter_to_opl(path: Path, tags: list[tuple[str, str]], opl: Path) -> _Collector:
    """Write the wanted objects as OPL; return what was collected besides."""
    import osmium

    try:
        writer = osmium.SimpleWriter(osmium.io.File(str(opl), "opl,add_metadata=false"))
        # The writer is called object by object and not handed to apply() itself: after a read
        # error that would end the process.
        collector = _Collector(writer)
        kinds = osmium.osm.NODE | osmium.osm.WAY | osmium.osm.RELATION
        with osmium.io.Reader(osm_file(path), kinds) as reader:
            wanted = osmium.filter.TagFilter(*tags, *NODE_TAGS, *TURN_TAGS, BORDER)
            # Only nodes that may say anything are looked at from Python.
            telling = osmium.filter.KeyFilter("ele", *dict.fromkeys(key for key, _ in NODE_TAGS))
            telling.enable_for(osmium.osm.NODE)
            versions = has_versions(path, reader.header())
            # A later version of a node may say nothing any more, and counts all the same.
            before = () if versions else (telling,)
            chosen = (*before, _Heights(collector.heights), wanted, collector)
            index = node_index(path) if versions else osmium.index.create_map("flex_mem")
            locations = osmium.NodeLocationsForWays(index)
            locations.ignore_errors()
            if versions:
                collector.gone = last_states(path, {*tags, *NODE_TAGS})
            # Where ways tell their places themselves, the nodes are not in the file.
            told = reader.header().get("pbf_optional_feature_0") == "LocationsOnWays"
            osmium.apply(reader, *(chosen if told else (locations, *chosen)))
            collector.extracted = reader.header().get("timestamp")
            collector.generator = reader.header().get("generator")
        # Writing happens in another thread; what goes wrong there may show only on closing.
        writer.close()
    except osmium.InvalidLocationError as error:
        raise MapDataError(
            f"{path}: {bad_node(path)} has coordinates that are no place on earth ({error}); "
            "correct or remove it"
        ) from error
    except (RuntimeError, ValueError) as error:
        other_kind, said = misnamed(path), " ".join(str(error).split())[:200]
        if not other_kind and "file format" in said:
            raise OsmNameError(
                f"{path}: not an OSM file by its name; use .osm.pbf, .osm, .osm.gz or .osm.bz2"
            ) from error
        raise MapDataError(f"{path}: {other_kind or why(said)}") from error
    return collector


def _split_lines(opl: Path) -> tuple[list[list[str]], list[list[str]], list[list[str]]]:
    kinds: dict[str, list[list[str]]] = {"w": [], "n": [], "r": []}
    with opl.open(encoding="utf-8", newline="\n") as lines:
        for line in lines:
            kinds[line[0]].append(line.split(" "))
    return kinds["w"], kinds["n"], kinds["r"]


def _node_ids(lists: list[str]) -> NDArray[np.int64]:
    """Read "Nn1,n2,n3" of all ways at once."""
    text = ",".join(part[1:] for part in lists if "n" in part)
    data = text.encode("ascii").translate(None, delete=b"n\n")
    return np.fromstring(data, np.int64, sep=",") if data else np.zeros(0, np.int64)


def _node(path: Path, line: list[str]) -> tuple[int, str, float, float]:
    node = int(line[0][1:])
    lon, lat = (float(part[1:].rstrip("\n") or "nan") for part in line[2:4])
    return node, line[1][1:], *_on_the_globe(path, node, lon, lat)


def _relation(line: list[str]) -> tuple[int, str, tuple[tuple[str, int, str], ...]]:
    """Read "r12 Ttype=restriction Mw1@from,n2@via,w3@to"."""
    members = []
    for part in line[2][1:].rstrip("\n").split(","):
        place, _, role = part.partition("@")
        if place:
            members.append((place[0], int(place[1:]), unescaped(role)))
    return int(line[0][1:]), line[1][1:], tuple(members)


def _on_the_globe(path: Path, node: int, lon: float, lat: float) -> tuple[float, float]:
    if abs(lon) > 180 or abs(lat) > 90:
        raise MapDataError(
            f"{path}: node {node} has coordinates that are no place on earth (lon {lon:g}, lat "
            f"{lat:g}); correct or remove it"
        )
    return lon, lat
