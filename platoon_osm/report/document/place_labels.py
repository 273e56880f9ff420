"""Names that give orientation on the map: towns, and junctions once each."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...network.geodesy import distance_m
from ...network.road_network import POINT_KINDS, RoadNetwork
from ..markup.shown_text import shortened, shown

__all__ = ["junction_labels", "town_labels"]

LONGEST_NAME = 60
MOST_TOWNS = 1_500
MOST_JUNCTIONS = 4_000

ONE_JUNCTION_M = 3_000.0
"""Nodes of one name nearer than this are one junction: carriageways, ramps, gates."""

COORDINATE_STEPS = 10_000


def town_labels(net: RoadNetwork) -> list[list[Any]]:
    """Return cities, towns and villages, the most important first.

    Each is [lon, lat, name, rank]: coordinates in 1e-4 degrees; rank 0 city, 1 town, 2 village.
    """
    city = POINT_KINDS.index("city")
    rows = [
        (int(kind) - city, -int(people), shown(net.texts[int(name)]), float(lon), float(lat))
        for lon, lat, kind, name, people in zip(
            net.points.lon, net.points.lat, net.points.kind, net.points.name,
            net.points.population, strict=True,
        )
        if kind >= city
    ]  # fmt: skip
    return [
        [_steps(lon), _steps(lat), shortened(name, LONGEST_NAME), rank]
        for rank, _, name, lon, lat in sorted(rows)[:MOST_TOWNS]
        if name
    ]


def junction_labels(net: RoadNetwork) -> list[list[Any]]:
    """Return signed junctions, each [lon, lat, name], coordinates in 1e-4 degrees.

    Interchanges, where several roads meet, come first. A junction with an exit number alone is
    named by it.
    """
    rows: list[tuple[int, str, float, float]] = []
    kept: dict[str, list[tuple[float, float]]] = {}
    for node in np.flatnonzero((net.node_name != 0) | (net.node_ref != 0)):
        name = shown(net.junction_name(int(node)) or net.texts[int(net.node_ref[node])])
        lon, lat = float(net.lon[node]), float(net.lat[node])
        same = kept.setdefault(name, [])
        if not name or any(float(distance_m(lon, lat, *at)) < ONE_JUNCTION_M for at in same):
            continue
        same.append((lon, lat))
        roads = len(net.incident_refs(int(node)))
        rows.append((-roads, name, lon, lat))
    return [
        [_steps(lon), _steps(lat), shortened(name, LONGEST_NAME)]
        for _, name, lon, lat in sorted(rows)[:MOST_JUNCTIONS]
    ]


def _steps(degrees: float) -> int:
    return round(degrees * COORDINATE_STEPS)
