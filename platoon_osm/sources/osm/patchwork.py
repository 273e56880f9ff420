"""Files in which an object stands in several versions, or nodes behind the ways that use them.

Histories (.osh) and change files (.osc) hold every version of an object; the last one counts, and a
way whose last version is deleted or is no road any more is none. Extracts put one after another
hold nodes behind ways. Such files are read once more for what the first pass could not know.
"""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .file_kind import osm_file

__all__ = ["fill_in", "has_versions", "last_states", "newest", "node_index"]

SUFFIXES = (".osh", ".osc")


def has_versions(path: Path, header: Any) -> bool:
    """Tell whether a file may hold an object in several versions.

    Parameters
    ----------
    path : Path
        The file.
    header : osmium.io.Header
        What it says of itself.

    Returns
    -------
    bool
        By its head, or by its name.
    """
    suffixes = {suffix.lower() for suffix in path.suffixes[-2:]}
    return bool(header.has_multiple_object_versions) or bool(suffixes & set(SUFFIXES))


def node_index(path: Path) -> Any:
    """Return an index of where each node of a file is, by its last version.

    Parameters
    ----------
    path : Path
        An OSM file.

    Returns
    -------
    osmium.index.LocationTable
        To be given to `NodeLocationsForWays`.
    """
    import osmium

    # Of several places for one node this kind of table keeps the last.
    index = osmium.index.create_map("sparse_mem_map")
    with osmium.io.Reader(osm_file(path), osmium.osm.NODE) as reader:
        osmium.apply(reader, osmium.NodeLocationsForWays(index))
    return index


def fill_in(path: Path, ref: NDArray[np.int64], lon: NDArray[Any], lat: NDArray[Any]) -> None:
    """Fill in the places of nodes that stand behind the ways that use them.

    Parameters
    ----------
    path : Path
        The file.
    ref : ndarray of int64, (k,)
        Node ids along the ways.
    lon, lat : ndarray of float, (k,)
        Degrees; NaN where the first pass met no such node.
    """
    missing = np.flatnonzero(np.isnan(lon) & (ref > 0))
    if not len(missing):
        return
    index = node_index(path)
    for k in missing.tolist():
        try:
            place = index.get(int(ref[k]))
        except KeyError:
            continue
        if place.valid():
            lon[k], lat[k] = place.lon, place.lat


def last_states(path: Path, tags: Collection[tuple[str, str]]) -> dict[int, str]:
    """Return the ways whose last version is no road any more, and why.

    Parameters
    ----------
    path : Path
        A file with versions.
    tags : collection of (str, str)
        What makes a way one that is wanted.

    Returns
    -------
    dict of int to str
        By way id: "deleted" or "no such road any more".
    """
    import osmium

    last: dict[int, tuple[int, str]] = {}
    ways: Any = osmium.FileProcessor(osm_file(path), osmium.osm.WAY)
    for way in ways:
        version = int(way.version)
        if way.id in last and last[way.id][0] > version:
            continue
        wanted = any((tag.k, tag.v) in tags for tag in way.tags)
        gone = "deleted" if way.deleted or not way.visible else "no such road any more"
        last[way.id] = version, "" if wanted and gone != "deleted" else gone
    return {way: gone for way, (_, gone) in last.items() if gone}


def newest(way_id: NDArray[np.int64], version: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Mark ways that another of the same id comes after: by its version, else by its place.

    Parameters
    ----------
    way_id : ndarray of int64, (w,)
        Ids in the order of the file.
    version : ndarray of int64, (w,)
        Of each; 0 where the file does not tell.

    Returns
    -------
    ndarray of bool, (w,)
        Those that are not the newest of their id.
    """
    if not (np.diff(way_id) <= 0).any():
        return np.zeros(len(way_id), bool)
    order = np.lexsort((np.arange(len(way_id)), version, way_id))
    older = np.zeros(len(way_id), bool)
    older[order[:-1]] = way_id[order[:-1]] == way_id[order[1:]]
    return older
