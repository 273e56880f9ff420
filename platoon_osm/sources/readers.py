"""The kinds of map file, each found by its suffix or its first bytes; a user adds one from outside.

    from platoon_osm.sources.readers import READERS, Reader
    READERS.add(Reader("links", (".links",), "list of links, one a line", read_links))

From then on `load_network`, and with it every verb of the command, opens such files. Functions are
imported when they are called, so that reading this list costs nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from ..errors import MapDataError, ScenarioError
from ..network.saved.beginning import MAGIC
from ..registry import Registry

if TYPE_CHECKING:
    from ..network.road_network import RoadNetwork
    from .truck import TruckRules

__all__ = ["READERS", "Reader", "Reads", "reader_of", "supported_files"]

Classes = tuple[str, ...]


class Reads(Protocol):
    """A function that reads a map file."""

    def __call__(self, path: Path, classes: Classes, rules: TruckRules, /) -> RoadNetwork:
        """Read a map file.

        Parameters
        ----------
        path : Path
            A file that exists.
        classes : tuple of str
            Values of `highway` to read.
        rules : TruckRules
            The truck and the law that cap a speed.

        Returns
        -------
        RoadNetwork
            With its source and a report.
        """
        ...


@dataclass(frozen=True, slots=True)
class Reader:
    """One kind of map file.

    Attributes
    ----------
    name : str
        What it is called.
    suffixes : tuple of str
        How names of such files end, in lower case, with the dot.
    about : str
        What such a file is, in a few words.
    read : Reads
        Reads it; raises `MapDataError` where it cannot.
    begins : bytes
        What the file begins with, if that tells it whatever its name; else empty.
    follows_rules : bool
        Whether speeds come from the truck's rules; a saved network keeps its own.
    fits : callable or None
        Tells by its content whether a file is of this kind, where others have the same suffix.
    """

    name: str
    suffixes: tuple[str, ...]
    about: str
    read: Reads
    begins: bytes = b""
    follows_rules: bool = True
    fits: Callable[[Path], bool] | None = None

    def __post_init__(self) -> None:
        proper = isinstance(self.suffixes, tuple) and all(
            isinstance(suffix, str) and suffix.startswith(".") and suffix == suffix.lower()
            for suffix in self.suffixes
        )
        if not proper or not (self.suffixes or self.begins):
            raise ScenarioError(
                f"reader {self.name!r}: suffixes {self.suffixes!r} must be texts in lower case, "
                'with the dot, as (".links",)'
            )
        if not callable(self.read):
            raise ScenarioError(f"reader {self.name!r}: read must be a function")


def _osm(path: Path, classes: Classes, rules: TruckRules, /) -> RoadNetwork:
    from .osm.extract import read_osm
    from .osm.raw_osm import OsmNameError

    try:
        return read_osm(path, classes, rules)
    except OsmNameError as error:
        others = [item for reader in READERS.values() for item in reader.suffixes]
        raise MapDataError(
            f"{error}; other maps end in {', '.join(item for item in others if item not in OSM)}"
        ) from error


def _graphml(path: Path, classes: Classes, rules: TruckRules, /) -> RoadNetwork:
    from .graphs.osmnx_graph import read_graphml

    return read_graphml(path, classes, rules)


def _geopackage(path: Path, classes: Classes, rules: TruckRules, /) -> RoadNetwork:
    from .gis.lines import layers_of, read_lines
    from .graphs.osmnx_graph import read_geopackage

    read = read_geopackage if {"nodes", "edges"} & {*layers_of(path)} else read_lines
    return read(path, classes, rules)


def _lines(path: Path, classes: Classes, rules: TruckRules, /) -> RoadNetwork:
    from .gis.lines import read_lines

    return read_lines(path, classes, rules)


def _overpass(path: Path, classes: Classes, rules: TruckRules, /) -> RoadNetwork:
    from .overpass.answers import read_overpass_cache

    return read_overpass_cache(path, classes, rules)


def _overture(path: Path, classes: Classes, rules: TruckRules, /) -> RoadNetwork:
    from .overture.reader import read_overture

    return read_overture(path, classes, rules)


def _is_overture(path: Path) -> bool:
    from .overture.segments import is_overture

    return is_overture(path)


def _saved(path: Path, classes: Classes, rules: TruckRules, /) -> RoadNetwork:
    from ..network.saved.store import open_network
    from .osm.extract import MOTORWAY_CLASSES
    from .truck import TruckRules as Rules

    net = open_network(path)
    if classes == MOTORWAY_CLASSES and rules == Rules():
        return net
    remark = "opened as it was saved: classes, country and limiter were settled by `prepare`"
    return net.with_report(net.load_report.extended({}, remark))


OSM = (".osm.pbf", ".osm", ".osm.gz", ".osm.bz2", ".osh", ".osh.pbf", ".osh.gz", ".osc", ".osc.gz")

SEGMENTS = (".parquet", ".geoparquet", ".geojson", ".geojsonl", ".geojsons", ".geojsonseq")
LINES = (*SEGMENTS, ".fgb", ".shp")

READERS: Registry[Reader] = Registry(
    "reader",
    (
        Reader("osm", OSM, "OSM extract", _osm),
        Reader("graphml", (".graphml",), "GraphML saved by OSMnx, or of ETISplus", _graphml),
        Reader("geopackage", (".gpkg",), "GeoPackage of lines, or saved by OSMnx", _geopackage),
        Reader("lines", LINES, "lines with tags, as a GIS has them", _lines),
        Reader("overture", SEGMENTS, "segments of Overture", _overture, fits=_is_overture),
        Reader("overpass", (".json",), "answer of Overpass, as OSMnx caches it", _overpass),
        Reader("saved", (".platoon",), "network saved by this package", _saved, MAGIC, False),
    ),
)
"""In the order in which they are listed."""


def reader_of(path: Path) -> Reader:
    """Find the reader of a file: by its first bytes, else by the longest suffix that fits.

    Parameters
    ----------
    path : Path
        A file that exists.

    Returns
    -------
    Reader
        That of OSM files if none fits: libosmium knows more kinds than people use, and says what
        is wrong with the others.

    Raises
    ------
    MapDataError
        The file cannot be read.
    """
    most = max(len(reader.begins) for reader in READERS.values())
    try:
        with path.open("rb") as handle:
            start = handle.read(most)
    except OSError as error:
        raise MapDataError(
            f"{path}: cannot be read ({error.strerror}); check the path and its rights"
        ) from error
    name = path.name.lower()
    found, length = READERS["osm"], 0
    for reader in READERS.values():
        if reader.begins and start.startswith(reader.begins):
            return reader
        fits = [len(suffix) for suffix in reader.suffixes if name.endswith(suffix)]
        # Of two readers for one suffix the later one was added by the user, or looks inside.
        if fits and max(fits) >= length and (reader.fits is None or reader.fits(path)):
            found, length = reader, max(fits)
    return found


def supported_files() -> str:
    """List the kinds of file that can be loaded, for messages and help.

    Returns
    -------
    str
        One line: what each is, with its suffixes in brackets.
    """
    return ", ".join(
        f"{reader.about} ({', '.join(reader.suffixes)})" if reader.suffixes else reader.about
        for reader in READERS.values()
    )
