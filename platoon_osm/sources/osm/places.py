"""Places beside the roads of an OSM file: stops for trucks, and tunnels with a category."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...network.antimeridian import middle_longitude_deg, near_deg, wrapped_deg
from ...network.restrictions import encode
from ...vehicles.judgement import TUNNEL
from ..stops.features import STOP_TAGS, is_stop_tag, read_stop
from ..stops.merging import StopPlace, merged_stops
from ..stops.sides import RoadSides
from .raw_map import RawMap, TagReader

__all__ = ["MapPoint", "map_stops", "map_tunnels"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

STOP_TEXTS = tuple(f"{key}={value}" for key, value in STOP_TAGS)
"""One of these is in the tags of a stop, as OPL writes them; most nodes are junctions."""

CATEGORIES = frozenset("ABCDE")
NO_TUNNEL = ("tunnel=no", "tunnel=culvert", "tunnel=building_passage")


@dataclass(frozen=True, slots=True)
class MapPoint:
    """A named point as a network keeps it.

    Attributes
    ----------
    kind : str
        Of `POINT_KINDS`.
    lon, lat : float
        Degrees.
    name : str
        Empty if it has none.
    population : int
        Inhabitants, 0 where not known.
    capacity : int
        Spaces for trucks, -1 where not known.
    tags : str
        In the form of `network.restrictions`.
    """

    kind: str
    lon: float
    lat: float
    name: str
    population: int = 0
    capacity: int = -1
    tags: str = ""


def map_stops(raw: RawMap, areas: Index, roads: Floats, counts: Counter[str]) -> list[MapPoint]:
    """Return the stops for trucks of a file, each with its parts.

    Parameters
    ----------
    raw : RawMap
        The file.
    areas : ndarray of int64
        Its ways that are no roads.
    roads : ndarray of float, (s, 4)
        Lon, lat, lon, lat of pieces of road between whose sides no truck changes.
    counts : Counter
        Counts what is no stop, and what could not be read.

    Returns
    -------
    list of MapPoint
        The most telling kinds first.
    """
    read_tags = TagReader(is_stop_tag)
    places = []
    # On one plane, so that an area on the antimeridian has an outline and a middle.
    centre = middle_longitude_deg(raw.lon[np.isfinite(raw.lon)])
    roads = np.column_stack([near_deg(roads[:, 0::2], centre), roads[:, 1::2]])[:, [0, 2, 1, 3]]

    def add(kind: str, number: int, text: str, points: Floats) -> None:
        known = points[np.isfinite(points).all(1)]
        known = np.column_stack([near_deg(known[:, 0], centre), known[:, 1]])
        reading = read_stop(read_tags(text), counts) if len(known) else None
        if reading is not None:
            closed = len(known) > 3 and bool((known[0] == known[-1]).all())
            lon, lat = _middle(known[:-1] if closed else known, known if closed else None)
            ring = known[:-1] if closed else np.zeros((0, 2))
            places.append(StopPlace(reading, lon, lat, (kind, number), ring))

    for number, text, lon, lat in raw.nodes:
        if any(tag in text for tag in STOP_TEXTS):
            add("node", number, text, np.array([[lon, lat]]))
    for way in areas.tolist():
        part = slice(raw.first[way], raw.first[way + 1])
        points = np.column_stack([raw.lon[part], raw.lat[part]])
        add("way", int(raw.way_id[way]), raw.way_tags[way], points)
    for number, text, outline in raw.areas:
        add("relation", number, text, outline)
    return [
        MapPoint(
            stop.kind,
            float(wrapped_deg(stop.lon)),
            stop.lat,
            stop.name,
            0,
            stop.capacity,
            stop.tags,
        )
        for stop in merged_stops(places, RoadSides(roads))
    ]


def _middle(points: Floats, ring: Floats | None) -> tuple[float, float]:
    """Return the mean of points, or where that is not within their ring, a place that is."""
    lon, lat = points.mean(0).tolist()
    if ring is not None:
        import shapely

        area = shapely.Polygon(ring)
        if area.is_valid and not area.contains(shapely.Point(lon, lat)):
            inside = area.representative_point()
            return float(inside.x), float(inside.y)
    return lon, lat


def map_tunnels(raw: RawMap, ways: Index, counts: Counter[str]) -> list[MapPoint]:
    """Return tunnels that have a category for dangerous goods.

    Parameters
    ----------
    raw : RawMap
        The file.
    ways : ndarray of int64
        Its roads.
    counts : Counter
        Counts tunnels without a category, and categories that are none.

    Returns
    -------
    list of MapPoint
        One for each row of ways of one name and category that follow each other, in its middle.
    """
    read_tags = TagReader(lambda key: key in TUNNEL or key in ("name", "tunnel:name"))
    rows: dict[tuple[str, str], list[int]] = {}
    for way in ways.tolist():
        text = raw.way_tags[way]
        if "tunnel" not in text:
            continue
        tags = read_tags(text)
        told = next((tags[key].strip().upper() for key in TUNNEL if key in tags), "")
        if told in CATEGORIES:
            name = tags.get("tunnel:name") or tags.get("name", "")
            rows.setdefault((name, told), []).append(way)
        elif told:
            counts["categories of tunnels not understood"] += 1
        elif "tunnel=" in text and not any(other in text for other in NO_TUNNEL):
            counts["ways in tunnels without an ADR category"] += 1
    found = []
    for (name, category), members in rows.items():
        for row in _joined(raw, members):
            way = row[len(row) // 2]
            part = slice(raw.first[way], raw.first[way + 1])
            known = np.flatnonzero(np.isfinite(raw.lon[part]))
            if len(known):
                at = int(raw.first[way] + known[len(known) // 2])
                kept = encode([{TUNNEL[0]: category}])
                place = float(raw.lon[at]), float(raw.lat[at])
                found.append(MapPoint("tunnel", *place, name, tags=kept))
    return found


def _joined(raw: RawMap, ways: list[int]) -> list[list[int]]:
    """Return ways in rows, each of which shares a node with one before it."""
    rows: list[tuple[set[int], list[int]]] = []
    for way in ways:
        nodes = {int(raw.ref[k]) for k in (raw.first[way], raw.first[way + 1] - 1)}
        touched = [row for row in rows if row[0] & nodes]
        rows = [row for row in rows if not row[0] & nodes]
        nodes = nodes.union(*(own for own, _ in touched))
        rows.append((nodes, [*(one for _, members in touched for one in members), way]))
    return [members for _, members in rows]
