"""Outlines of areas that are relations, such as a service area with a hole in it.

Their ways stand before them in the file, most without a tag, so that the first pass does not know
that they are wanted. Where there is such a relation, the file is read once more for these ways.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..stops.features import STOP_TAGS
from .file_kind import osm_file

__all__ = ["area_outlines", "areas_of", "lines_of"]

STOPS = frozenset(f"{key}={value}" for key, value in STOP_TAGS)
AREAS = frozenset({"type=multipolygon", "type=boundary", "type=site"})
"""As OPL writes these tags."""

Floats = NDArray[np.float64]
Relation = tuple[int, str, tuple[tuple[str, int, str], ...]]
Area = tuple[int, str, Floats]


def area_outlines(path: Path, relations: Sequence[Relation]) -> tuple[Area, ...]:
    """Return the outline of each area.

    Parameters
    ----------
    path : Path
        An OSM file.
    relations : sequence of tuple
        Id, tags as OPL text and members (kind, id, role) of each.

    Returns
    -------
    tuple of tuple[int, str, ndarray]
        Id, tags and points (k, 2) of its largest ring; of an area that is not whole all points
        that are there, and none where none is.
    """
    return areas_of(relations, lambda wanted: lines_of(path, wanted))


def areas_of(
    relations: Sequence[Relation], ways_of: Callable[[set[int]], Mapping[int, Floats]]
) -> tuple[Area, ...]:
    """Return the outline of each area among relations.

    Parameters
    ----------
    relations : sequence of tuple
        Id, tags as OPL text and members (kind, id, role) of each.
    ways_of : callable
        Returns the points (k, 2) of ways by their ids; asked only if there is an area.

    Returns
    -------
    tuple of tuple[int, str, ndarray]
        As `area_outlines`.
    """
    wanted = [
        (number, tags, [ref for kind, ref, role in members if kind == "w" and role != "inner"])
        for number, tags, members in relations
        if not STOPS.isdisjoint(tags.split(",")) and not AREAS.isdisjoint(tags.split(","))
    ]
    ways = ways_of({ref for _, _, refs in wanted for ref in refs}) if wanted else {}
    return tuple(
        (number, tags, _outline([ways[ref] for ref in refs if ref in ways]))
        for number, tags, refs in wanted
    )


def lines_of(path: Path, ids: set[int]) -> dict[int, Floats]:
    """Read the points of some ways.

    Parameters
    ----------
    path : Path
        An OSM file.
    ids : set of int
        Of the ways.

    Returns
    -------
    dict of int to ndarray of float, (k, 2)
        Longitude and latitude [deg] of the nodes that the file has.
    """
    import osmium

    found: dict[int, Floats] = {}
    entities: Any = (
        osmium.FileProcessor(osm_file(path), osmium.osm.NODE | osmium.osm.WAY)
        .with_locations()
        .with_filter(osmium.filter.EntityFilter(osmium.osm.WAY))
        .with_filter(osmium.filter.IdFilter(ids))
    )
    for way in entities:
        places = [(node.lon, node.lat) for node in way.nodes if node.location.valid()]
        found[way.id] = np.array(places, np.float64).reshape(-1, 2)
    return found


def _outline(lines: list[Floats]) -> Floats:
    """Return the largest ring that lines make, or else all their points."""
    import shapely

    drawn = [shapely.LineString(line) for line in lines if len(line) > 1]
    rings: Any = shapely.get_parts(shapely.polygonize(drawn)) if drawn else []
    if len(rings):
        largest = max(rings, key=lambda ring: float(ring.area))
        return np.asarray(largest.exterior.coords, np.float64)[:, :2]
    return np.concatenate(lines) if lines else np.zeros((0, 2))
