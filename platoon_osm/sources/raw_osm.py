"""Roads and places of an OSM file, filtered and decoded in C++, before anyone interprets them.

libosmium filters the file and writes what is left as OPL, its line format, with the coordinates of
nodes on the ways; numpy then reads all node lists in one go. That is faster than touching each
node and tag from Python, and no Python runs for objects that are not roads or named places.
"""

from __future__ import annotations

import hashlib
import re
import tempfile
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import MapDataError
from ..network.load_report import Source

__all__ = ["RawMap", "TagReader", "read_raw"]

NODE_TAGS = (
    ("highway", "motorway_junction"), ("highway", "services"), ("highway", "rest_area"),
    ("place", "city"), ("place", "town"), ("barrier", "toll_booth"),
)  # fmt: skip

ESCAPE = re.compile(r"%([0-9a-f]{1,6})%")


@dataclass(frozen=True, slots=True, eq=False)
class RawMap:
    """Ways and named nodes as they stand in the file.

    Attributes
    ----------
    way_id : (w,) int64
    way_tags : (w,) each way's tags, still as OPL text; equal tags are equal texts.
    first : (w + 1,) where each way's nodes begin.
    ref, lon, lat : (k,) node ids and degrees along the ways; NaN where the file lacks the node.
    nodes : id, tags as OPL text, lon and lat of each tagged node.
    """

    source: Source
    way_id: NDArray[np.int64]
    way_tags: tuple[str, ...]
    first: NDArray[np.int64]
    ref: NDArray[np.int64]
    lon: NDArray[np.float64]
    lat: NDArray[np.float64]
    nodes: tuple[tuple[int, str, float, float], ...]


def read_raw(path: Path, classes: Sequence[str]) -> RawMap:
    """Read the roads of some classes, and the places that give them names.

    Raises
    ------
    MapDataError
        The file is missing, not OSM, cut short, or has coordinates off the globe.
    """
    if not path.is_file():
        raise MapDataError(f"{path}: no such file; give an OSM extract or a name from `maps`")
    tags = [("highway", name) for name in classes]
    with tempfile.TemporaryDirectory(prefix="platoon-osm-") as folder:
        opl = Path(folder) / "roads.opl"
        extracted = _filter_to_opl(path, tags, opl)
        ways, nodes = _split_lines(opl)
    source = Source(
        name=path.name,
        sha256=_sha256(path),
        extracted=extracted,
        licence="ODbL 1.0",
        attribution="© OpenStreetMap contributors",
    )
    lists = [line[2] for line in ways]
    count = np.fromiter((part.count("n") for part in lists), np.int64, len(lists))
    first = np.zeros(len(ways) + 1, np.int64)
    np.cumsum(count, out=first[1:])
    values = _numbers(lists)
    return RawMap(
        source=source,
        way_id=np.fromiter((int(line[0][1:]) for line in ways), np.int64, len(ways)),
        way_tags=tuple(line[1][1:] for line in ways),
        first=first,
        ref=values[0::3].astype(np.int64),
        lon=values[1::3],
        lat=values[2::3],
        nodes=tuple(_node(line) for line in nodes),
    )


class TagReader:
    """Reads the tags of OPL lines, `key=value` pairs with special characters as %hex%.

    Most pairs of a map are repeated thousands of times and most keys say nothing about driving, so
    each distinct pair is decoded once, and only if its key is wanted.
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


def _filter_to_opl(path: Path, tags: list[tuple[str, str]], opl: Path) -> str:
    """Write the wanted objects as OPL and return when the data was extracted."""
    import osmium

    form = osmium.io.File(str(opl), "opl,locations_on_ways=true,add_metadata=false")
    writer = osmium.SimpleWriter(form)
    try:
        objects = (
            osmium.FileProcessor(str(path), osmium.osm.NODE | osmium.osm.WAY)
            .with_locations()
            .with_filter(osmium.filter.TagFilter(*tags, *NODE_TAGS))
        )
        for item in objects:
            writer.add(item)
        header: str = objects.header.get("timestamp")
    except osmium.InvalidLocationError as error:
        raise MapDataError(
            f"{path}: {_bad_node(path)} has coordinates that are no place on earth ({error}); "
            "correct or remove it"
        ) from error
    except (RuntimeError, ValueError) as error:
        raise MapDataError(f"{path}: {_why(str(error))}") from error
    finally:
        writer.close()
    return header


def _why(message: str) -> str:
    """Say in one line what libosmium found wrong, and what to do."""
    said = " ".join(message.split())
    if "file format" in said:
        return "not an OSM file by its name; use .osm.pbf, .osm, .osm.gz or .osm.bz2"
    if any(word in said for word in ("EOF", "read close", "truncated", "Unexpected end", "zlib")):
        return f"the file is cut short or damaged ({said}); download it again"
    return f"not a readable OSM file ({said}); download the extract again"


def _bad_node(path: Path) -> str:
    """Name the first node off the globe in an XML file, for the error message only."""
    import bz2
    import gzip

    opener: Any = {".gz": gzip.open, ".bz2": bz2.open}.get(path.suffix, open)
    try:
        with opener(path, "rb") as handle:
            for _, item in ElementTree.iterparse(handle, events=("start",)):
                if item.tag == "node":
                    try:
                        lon, lat = float(item.get("lon", "nan")), float(item.get("lat", "nan"))
                    except ValueError:
                        return f"node {item.get('id')}"
                    if not (abs(lon) <= 180 and abs(lat) <= 90):
                        return f"node {item.get('id')}"
    except (OSError, ElementTree.ParseError):
        pass
    return "a node"


def _split_lines(opl: Path) -> tuple[list[list[str]], list[list[str]]]:
    ways: list[list[str]] = []
    nodes: list[list[str]] = []
    with opl.open(encoding="utf-8", newline="\n") as lines:
        for line in lines:
            (ways if line[0] == "w" else nodes).append(line.split(" "))
    return ways, nodes


def _numbers(lists: list[str]) -> NDArray[np.float64]:
    """Read "Nn1x7.5y45.1,n2x..." of all ways at once: id, lon, lat, id, lon, lat, ..."""
    text = ",".join(part[1:] for part in lists if "n" in part)
    if "xy" in text:
        text = text.replace("xy", "xnanynan")
    table = str.maketrans("xy", ",,", "N\n")
    # After the translation only the n of node ids is left to remove, but not that of nan.
    text = text.translate(table).replace("nan", "?").replace("n", "").replace("?", "nan")
    return np.fromstring(text, np.float64, sep=",") if text else np.zeros(0)


def _node(line: list[str]) -> tuple[int, str, float, float]:
    lon, lat = line[2][1:].rstrip("\n"), line[3][1:].rstrip("\n")
    return int(line[0][1:]), line[1][1:], float(lon or "nan"), float(lat or "nan")


def _sha256(path: Path) -> str:
    with path.open("rb") as handle:
        return hashlib.file_digest(handle, "sha256").hexdigest()
