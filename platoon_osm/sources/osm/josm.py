"""What editors' drafts have and published maps have not: new objects, and deleted ones."""

from __future__ import annotations

import bz2
import gzip
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import MapDataError
from .file_kind import osm_file

__all__ = ["deleted_ways", "new_node_positions", "xml_items"]


def xml_items(path: Path) -> Iterator[ElementTree.Element]:
    """Yield the elements of an OSM XML file as they begin, packed or not.

    Parameters
    ----------
    path : Path
        The file.

    Yields
    ------
    Element
        Elements, each as it begins.

    Raises
    ------
    OSError, ElementTree.ParseError
        The file is not such a file, or breaks off.
    """
    opener: Any = {".gz": gzip.open, ".bz2": bz2.open}.get(path.suffix.lower(), open)
    with opener(path, "rb") as handle:
        root = None
        for _, item in ElementTree.iterparse(handle, events=("start",)):
            if root is None:
                root = item
            yield item
            # What was yielded stays in memory under the root until it is taken off.
            if item.tag in ("node", "way", "relation"):
                root.clear()


def deleted_ways(path: Path) -> frozenset[int]:
    """Return the ways that a draft marks to be deleted; JOSM keeps them until it uploads.

    Parameters
    ----------
    path : Path
        The file.

    Returns
    -------
    frozenset of int
        Way ids.

    Raises
    ------
    MapDataError
        The file holds more than its XML, as a packed file with garbage after its end.
    """
    try:
        ways = (item for item in xml_items(path) if item.tag == "way")
        return frozenset(int(way.get("id", "0")) for way in ways if way.get("action") == "delete")
    except (OSError, EOFError, ValueError, LookupError, ElementTree.ParseError) as error:
        raise MapDataError(f"{path}: damaged behind its end ({error}); save it again") from error


def new_node_positions(path: Path, wanted: NDArray[np.int64]) -> dict[int, tuple[float, float]]:
    """Return lon and lat, as they stand, of nodes with a negative id: not uploaded yet.

    libosmium's index of node locations holds positive ids only.

    Parameters
    ----------
    path : Path
        The file.
    wanted : ndarray of int64
        Node ids.

    Returns
    -------
    mapping of int, tuple[float to float]
        Longitude and latitude by node id.
    """
    import osmium

    ids = set(wanted.tolist())
    nodes: Any = osmium.FileProcessor(osm_file(path), osmium.osm.NODE)
    return {
        node.id: (node.location.lon_without_check(), node.location.lat_without_check())
        for node in nodes
        if node.id in ids
    }
