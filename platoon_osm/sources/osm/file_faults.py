"""What is wrong with an OSM file that libosmium refuses, in one line with a remedy."""

from __future__ import annotations

import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

from .file_kind import osm_file
from .josm import xml_items

__all__ = ["bad_node", "misnamed", "off_the_globe", "why"]

UNDEFINED_COORDINATE = 2**31 - 1
"""What libosmium stores where a file has no coordinate."""

CUT_SHORT = ("EOF", "read close", "truncated", "Unexpected end", "zlib", "bzip2")
"""What libosmium and its readers say of files that end too early."""

BEGINNINGS = (
    (0, b"\x1f\x8b", "packed with gzip", (".gz",)),
    (0, b"BZh", "packed with bzip2", (".bz2",)),
    (0, b"<?xml", "XML", (".osm", ".xml")),
    (0, b"<osm", "XML", (".osm", ".xml")),
    (6, b"OSMHeader", "PBF", (".pbf",)),
)
"""What stands at which place of a file, what the file then is, and how its name should end."""


def misnamed(path: Path) -> str:
    """Say so if the content of a file is of another kind than its name tells libosmium.

    Parameters
    ----------
    path : Path
        The file.

    Returns
    -------
    str
        Empty if name and content agree.
    """
    with path.open("rb") as handle:
        begin = handle.read(16)
    for at, marker, kind, suffixes in BEGINNINGS:
        if begin[at:].startswith(marker) and path.suffix.lower() not in suffixes:
            name = suffixes[0] if suffixes[0] == ".osm" else f".osm{suffixes[0]}"
            return f"its content is {kind}, its name says otherwise; rename it to end in {name}"
    return ""


def why(said: str) -> str:
    """Say in one line what libosmium found wrong, and what to do.

    Parameters
    ----------
    said : str
        Its own words.

    Returns
    -------
    str
        The end of a message.
    """
    if any(word in said for word in CUT_SHORT):
        return f"the file is cut short or damaged ({said}); download it again"
    if "Write failed" in said or "No space" in said:
        # What is read is filtered into a temporary file first.
        return (
            f"cannot be read, for there is no room for temporary files in {tempfile.gettempdir()} "
            f"({said}); free some, or name another folder in TMPDIR"
        )
    return f"not a readable OSM file ({said}); download the extract again"


def bad_node(path: Path) -> str:
    """Name the first node off the globe, for the error message only.

    Parameters
    ----------
    path : Path
        The file.

    Returns
    -------
    str
        "node 12", or what is known of it.
    """
    import osmium

    last = 0
    nodes: Any = osmium.FileProcessor(osm_file(path), osmium.osm.NODE)
    try:
        for node in nodes:
            if off_the_globe(node.location):
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


def off_the_globe(location: Any) -> bool:
    """Tell a place that is none on earth from one that is merely not known.

    Parameters
    ----------
    location : osmium.osm.Location
        Of a node.

    Returns
    -------
    bool
        Whether it is a place that cannot be.
    """
    return location.x != UNDEFINED_COORDINATE and not location.valid()
