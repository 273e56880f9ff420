"""Roads and places of an OSM file, filtered and decoded in C++, before anyone interprets them.

libosmium filters the file, writes what is left as OPL, its line format, and gives the coordinates
of each way in one piece; numpy then reads all node lists in one go. That is faster than touching
each node and tag from Python, and no Python runs for objects that are not roads or named places.
"""

from __future__ import annotations

import hashlib
import re
import tempfile
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import compress
from math import nan
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import MapDataError
from ...network.load_report import Source
from ...vehicles.access import BARRIERS, CHAIN
from ..file_identity import osm_source
from ..stops.features import STOP_TAGS, is_for_others
from .areas import area_outlines, lines_of
from .borders import BORDER, Border, borders_of, code_of
from .file_kind import osm_file
from .josm import deleted_ways, new_node_positions, xml_items
from .patchwork import fill_in, has_versions, last_states, newest, node_index

__all__ = ["OsmNameError", "RawMap", "TagReader", "read_raw"]

NODE_TAGS = (
    ("highway", "motorway_junction"), *STOP_TAGS, ("place", "city"), ("place", "town"),
    *(("barrier", kind) for kind in (*BARRIERS, "yes") if kind),
)  # fmt: skip

TURN_TAGS = tuple(
    ("type", kind)
    for kind in ("restriction", *(f"restriction:{whom}" for whom in (*CHAIN, "conditional")))
)
"""Relations that forbid turns, to all or to some."""
TURN = "type=restriction"
"""What the tags of such a relation have, as OPL writes them."""

UNDEFINED_COORDINATE = 2**31 - 1
"""What libosmium stores where a file has no coordinate."""

CUT_SHORT = ("EOF", "read close", "truncated", "Unexpected end", "zlib", "bzip2")
"""What libosmium and its readers say of files that end too early."""

WKB_HEADER = 18
"""Hex digits of a WKB line before its points: byte order, type and number of points."""

ESCAPE = re.compile(r"%([0-9a-f]{1,6})%")


class OsmNameError(MapDataError):
    """A file whose name tells libosmium nothing, nor do its first bytes."""


@dataclass(frozen=True, slots=True, eq=False)
class RawMap:
    """Ways and named nodes as they stand in the file.

    Attributes
    ----------
    way_id : ndarray of int64, (w,)
        Ids of the ways.
    way_tags : tuple of str, (w,)
        Each way's tags, still as OPL text; equal tags are equal texts.
    first : ndarray of int64, (w + 1,)
        Where each way's nodes begin.
    ref : ndarray of int64, (k,)
        Node ids along the ways.
    lon, lat : ndarray of float, (k,)
        Degrees; NaN where the file lacks the node.
    nodes : tuple[tuple[int, str, float, float], ...]
        Id, tags as OPL text, lon and lat of each tagged node.
    turns : tuple[tuple[int, str, tuple[tuple[str, int, str], ...]], ...]
        Id, tags as OPL text and members (kind, id, role) of each relation that forbids turns.
    areas : tuple[tuple[int, str, ndarray], ...]
        Id, tags as OPL text and outline (k, 2) of each relation that is an area where trucks stop.
    borders : tuple of Border
        Areas of countries and states whose border is whole.
    left_out : mapping of str to int
        How many ways were left out, by reason.
    height_of : ndarray of int64, (h,)
        Ids of the nodes that have an `ele`, rising.
    heights : tuple of str, (h,)
        What it says.
    """

    source: Source
    way_id: NDArray[np.int64]
    way_tags: tuple[str, ...]
    first: NDArray[np.int64]
    ref: NDArray[np.int64]
    lon: NDArray[np.float64]
    lat: NDArray[np.float64]
    nodes: tuple[tuple[int, str, float, float], ...]
    turns: tuple[tuple[int, str, tuple[tuple[str, int, str], ...]], ...]
    areas: tuple[tuple[int, str, NDArray[np.float64]], ...]
    borders: tuple[Border, ...]
    left_out: Mapping[str, int]
    height_of: NDArray[np.int64]
    heights: tuple[str, ...]


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
        source=osm_source(path.name, _sha256(path), found.extracted),
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
        raw = _left_out(raw, gone, f"ways left out: {reason}")
    deleted = found.deleted | (deleted_ways(path) if found.generator == "JOSM" else set())
    if deleted:
        gone = np.isin(raw.way_id, np.fromiter(deleted, np.int64, len(deleted)))
        version = version[~gone]
        raw = _left_out(raw, gone, "ways left out: deleted")
    again = newest(raw.way_id, version)
    return _left_out(raw, again, "ways left out: listed again further on")


def _place_new_nodes(path: Path, raw: RawMap) -> None:
    """Fill in the coordinates of nodes with negative ids."""
    at = np.flatnonzero(np.isnan(raw.lon) & (raw.ref < 0))
    if len(at):
        places = new_node_positions(path, raw.ref[at])
        for k, node in zip(at.tolist(), raw.ref[at].tolist(), strict=True):
            if node in places:
                raw.lon[k], raw.lat[k] = _on_the_globe(path, node, *places[node])


def _left_out(raw: RawMap, gone: NDArray[np.bool_], reason: str) -> RawMap:
    """Return the map without some ways, and their number among `left_out`."""
    if not gone.any():
        return raw
    size = np.diff(raw.first)
    points = np.repeat(~gone, size)
    return replace(
        raw,
        way_id=raw.way_id[~gone],
        way_tags=tuple(compress(raw.way_tags, (~gone).tolist())),
        first=np.concatenate([[0], np.cumsum(size[~gone])]).astype(np.int64),
        ref=raw.ref[points],
        lon=raw.lon[points],
        lat=raw.lat[points],
        left_out={**raw.left_out, reason: int(gone.sum())},
    )


class TagReader:
    """Reads the tags of OPL lines, `key=value` pairs with special characters as %hex%.

    Most pairs of a map are repeated thousands of times and most keys say nothing about driving, so
    each distinct pair is decoded once, and only if its key is wanted.

    Parameters
    ----------
    wanted : callable
        Says whether a key is wanted.
    """

    def __init__(self, wanted: Callable[[str], bool]) -> None:
        self._wanted = wanted
        self._pairs: dict[str, tuple[str, str] | None] = {}

    def __call__(self, text: str) -> dict[str, str]:
        """Return the wanted tags of one object."""
        known = self._pairs
        tags = {}
        for part in text.split(","):
            try:
                pair = known[part]
            except KeyError:
                pair = known[part] = self._decode(part)
            if pair is not None:
                tags[pair[0]] = pair[1]
        return tags

    def _decode(self, part: str) -> tuple[str, str] | None:
        key, _, value = part.partition("=")
        if not self._wanted(_unescape(key)):
            return None
        return _unescape(key), _unescape(value)


def _unescape(text: str) -> str:
    return ESCAPE.sub(lambda found: chr(int(found.group(1), 16)), text)


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
        if is_for_others(way.tags):
            return
        if self.deleted:
            self.deleted.discard(way.id)
        self._add_way(way)
        self.versions.append(way.version)
        try:
            self.shapes.append(self._line(way, self._all)[WKB_HEADER:])
        except self._unfit:
            if any(_off_the_globe(node.location) for node in way.nodes):
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


def _off_the_globe(location: Any) -> bool:
    """Tell a place that is none on earth from one that is merely not known."""
    return location.x != UNDEFINED_COORDINATE and not location.valid()


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
            f"{path}: {_bad_node(path)} has coordinates that are no place on earth ({error}); "
            "correct or remove it"
        ) from error
    except (RuntimeError, ValueError) as error:
        misnamed, said = _misnamed(path), " ".join(str(error).split())[:200]
        if not misnamed and "file format" in said:
            raise OsmNameError(
                f"{path}: not an OSM file by its name; use .osm.pbf, .osm, .osm.gz or .osm.bz2"
            ) from error
        raise MapDataError(f"{path}: {misnamed or _why(said)}") from error
    return collector


BEGINNINGS = (
    (0, b"\x1f\x8b", "packed with gzip", (".gz",)),
    (0, b"BZh", "packed with bzip2", (".bz2",)),
    (0, b"<?xml", "XML", (".osm", ".xml")),
    (0, b"<osm", "XML", (".osm", ".xml")),
    (6, b"OSMHeader", "PBF", (".pbf",)),
)
"""What stands at which place of a file, what the file then is, and how its name should end."""


def _misnamed(path: Path) -> str:
    """Say so if the content of a file is of another kind than its name tells libosmium."""
    with path.open("rb") as handle:
        begin = handle.read(16)
    for at, marker, kind, suffixes in BEGINNINGS:
        if begin[at:].startswith(marker) and path.suffix.lower() not in suffixes:
            name = suffixes[0] if suffixes[0] == ".osm" else f".osm{suffixes[0]}"
            return f"its content is {kind}, its name says otherwise; rename it to end in {name}"
    return ""


def _why(said: str) -> str:
    """Say in one line what libosmium found wrong, and what to do."""
    if any(word in said for word in CUT_SHORT):
        return f"the file is cut short or damaged ({said}); download it again"
    if "Write failed" in said or "No space" in said:
        # What is read is filtered into a temporary file first.
        return (
            f"cannot be read, for there is no room for temporary files in {tempfile.gettempdir()} "
            f"({said}); free some, or name another folder in TMPDIR"
        )
    return f"not a readable OSM file ({said}); download the extract again"


def _bad_node(path: Path) -> str:
    """Name the first node off the globe, for the error message only."""
    import osmium

    last = 0
    nodes: Any = osmium.FileProcessor(osm_file(path), osmium.osm.NODE)
    try:
        for node in nodes:
            if _off_the_globe(node.location):
                return f"node {node.id}"
            last = node.id
    except (osmium.InvalidLocationError, RuntimeError):
        # The reader itself stumbles over a coordinate that is no number.
        return _bad_xml_node(path) or (f"the node after node {last}" if last else "a node")
    return "a node"


def _bad_xml_node(path: Path) -> str:
    """Name the first node of an XML file whose coordinates are no numbers within the globe."""
    try:
        for item in xml_items(path):
            if item.tag == "node":
                try:
                    lon, lat = float(item.get("lon", "0")), float(item.get("lat", "0"))
                except ValueError:
                    return f"node {item.get('id')}"
                if not (abs(lon) <= 180 and abs(lat) <= 90):
                    return f"node {item.get('id')}"
    except (OSError, EOFError, LookupError, ElementTree.ParseError):
        pass
    return ""


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
            members.append((place[0], int(place[1:]), _unescape(role)))
    return int(line[0][1:]), line[1][1:], tuple(members)


def _on_the_globe(path: Path, node: int, lon: float, lat: float) -> tuple[float, float]:
    if abs(lon) > 180 or abs(lat) > 90:
        raise MapDataError(
            f"{path}: node {node} has coordinates that are no place on earth (lon {lon:g}, lat "
            f"{lat:g}); correct or remove it"
        )
    return lon, lat


def _sha256(path: Path) -> str:
    with path.open("rb") as handle:
        return hashlib.file_digest(handle, "sha256").hexdigest()
