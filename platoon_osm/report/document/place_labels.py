"""Names that give orientation on the map: towns, and junctions once each."""

from __future__ import annotations

import numpy as np

from ...network.geodesy import distance_m
from ...network.road_network import POINT_KINDS, RoadNetwork
from ...shown_text import shortened, shown
from ..drawing.basemap import BASEMAP_STEPS, Frame
from .model_map import JunctionLabel, TownLabel

__all__ = ["junction_labels", "town_labels"]

LONGEST_NAME = 60
MOST_TOWNS = 1_500
MOST_JUNCTIONS = 4_000

ONE_JUNCTION_M = 3_000.0
"""Nodes of one name nearer than this are one junction: carriageways, ramps, gates."""


def town_labels(net: RoadNetwork) -> tuple[TownLabel, ...]:
    """Return cities, towns and villages.

    Parameters
    ----------
    net : RoadNetwork
        Whose points are named.

    Returns
    -------
    tuple of TownLabel
        The most important first.
    """
    city = POINT_KINDS.index("city")
    rows = [
        (int(kind) - city, -int(people), shown(net.texts[int(name)]), float(lon), float(lat))
        for lon, lat, kind, name, people in zip(
            net.points.lon,
            net.points.lat,
            net.points.kind,
            net.points.name,
            net.points.population,
            strict=True,
        )
        if kind >= city
    ]
    return tuple(
        TownLabel(_steps(lon), _steps(lat), shortened(name, LONGEST_NAME), rank)
        for rank, _, name, lon, lat in sorted(rows)[:MOST_TOWNS]
        if name
    )


def junction_labels(net: RoadNetwork, near: Frame) -> tuple[JunctionLabel, ...]:
    """Return signed junctions; one with an exit number alone is named by it.

    Parameters
    ----------
    net : RoadNetwork
        Whose nodes are named.
    near : Frame
        The part of it whose junctions are told.

    Returns
    -------
    tuple of JunctionLabel
        Interchanges, where several roads meet, first.
    """
    rows: list[tuple[int, str, float, float]] = []
    kept: dict[str, list[tuple[float, float]]] = {}
    west, south, east, north = near
    inside = (net.lon >= west) & (net.lon <= east) & (net.lat >= south) & (net.lat <= north)
    for node in np.flatnonzero(inside & ((net.node_name != 0) | (net.node_ref != 0))):
        name = shown(net.junction_name(int(node)) or net.texts[int(net.node_ref[node])])
        lon, lat = float(net.lon[node]), float(net.lat[node])
        same = kept.setdefault(name, [])
        if not name or any(float(distance_m(lon, lat, *at)) < ONE_JUNCTION_M for at in same):
            continue
        same.append((lon, lat))
        roads = len(net.incident_refs(int(node)))
        rows.append((-roads, name, lon, lat))
    return tuple(
        JunctionLabel(_steps(lon), _steps(lat), shortened(name, LONGEST_NAME))
        for _, name, lon, lat in sorted(rows)[:MOST_JUNCTIONS]
    )


def _steps(degrees: float) -> int:
    return round(degrees * BASEMAP_STEPS)
