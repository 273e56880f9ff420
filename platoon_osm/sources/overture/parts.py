"""Segments cut into parts on which one rule holds, as ways over nodes.

A segment is cut at its connectors, where others may be reached, and where a rule begins or ends.
Its other points are nodes of its own: segments that cross there without a connector do not meet.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np

from ...network.antimeridian import continued_deg, wrapped_deg
from ..osm.tables import MapNode, MapWay
from .rules import access_tags, speed_tags
from .segments import Segment

__all__ = ["Part", "Parts", "cut"]

KINDS = ("access_restrictions", "speed_limits", "road_flags", "subclass_rules", "routes")
CLOSED = {"is_under_construction": "under construction", "is_abandoned": "abandoned"}
SAME = 1e-9


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a segment: its way, where it begins and ends, and its first and last node."""

    way: int
    low: float
    high: float
    first: int
    last: int


@dataclass(slots=True)
class Parts:
    """Ways and nodes of all segments.

    Attributes
    ----------
    ways : list of MapWay
        With negative ids, for Overture's are no numbers.
    nodes : dict of int to MapNode
        Likewise.
    of : dict of str to list of Part
        The parts of each segment, in their order.
    connector : dict of str to int
        The node of each connector.
    counts : Counter
        What was left out, and why.
    """

    ways: list[MapWay] = field(default_factory=list)
    nodes: dict[int, MapNode] = field(default_factory=dict)
    of: dict[str, list[Part]] = field(default_factory=dict)
    connector: dict[str, int] = field(default_factory=dict)
    counts: Counter[str] = field(default_factory=Counter)

    def node(self, lon: float, lat: float) -> int:
        """Add a node.

        Parameters
        ----------
        lon, lat : float
            Degrees.

        Returns
        -------
        int
            Its number.
        """
        number = -1 - len(self.nodes)
        self.nodes[number] = MapNode(lon, lat, {})
        return number


def cut(segments: Sequence[Segment]) -> Parts:
    """Return all segments as ways over nodes.

    Parameters
    ----------
    segments : sequence of Segment
        Of one file.

    Returns
    -------
    Parts
        The ways, and which parts of which segment they are.
    """
    parts = Parts()
    for segment in segments:
        breaks = segment.breaks(KINDS)
        known = {
            at: parts.connector[name] for at, name in segment.connectors if name in parts.connector
        }
        ends = [known[at] if at in known else parts.node(*_place(segment, at)) for at in breaks]
        for at, name in segment.connectors:
            # Two connectors may lie at one place: then they are one node.
            parts.connector.setdefault(name, ends[breaks.index(at)])
        own = parts.of[segment.name] = []
        for (low, first), (high, last) in pairwise(zip(breaks, ends, strict=True)):
            inside = np.flatnonzero((segment.share > low + SAME) & (segment.share < high - SAME))
            between = [parts.node(*place) for place in segment.points[inside].tolist()]
            tags = _tags(segment, low, high, parts.counts)
            if tags is not None:
                way = -1 - len(parts.ways)
                parts.ways.append(MapWay(way, [first, *between, last], tags))
                own.append(Part(way, low, high, first, last))
    return parts


def _place(segment: Segment, at: float) -> tuple[float, float]:
    """Return longitude and latitude of a place along a segment; its own point if one is there."""
    near = int(np.argmin(np.abs(segment.share - at)))
    if abs(segment.share[near] - at) < SAME:
        lon, lat = segment.points[near].tolist()
        return lon, lat
    lon, lat = segment.points.T
    along = np.interp(at, segment.share, continued_deg(lon))
    return float(wrapped_deg(along)), float(np.interp(at, segment.share, lat))


def _tags(segment: Segment, low: float, high: float, counts: Counter[str]) -> dict[str, str] | None:
    """Return the tags of a part; None if nobody may drive there."""
    about = segment.about
    flags = {flag for rule in segment.rules("road_flags", low, high) for flag in rule["values"]}
    for flag, told in CLOSED.items():
        if flag in flags:
            counts[f"parts of segments left out: {told}"] += 1
            return None
    kind = str(about.get("class") or "unknown")
    subclasses = {rule["value"] for rule in segment.rules("subclass_rules", low, high)}
    if "link" in (about.get("subclass"), *subclasses) or "is_link" in flags:
        kind = f"{kind}_link"
    tags = {"highway": kind}
    name = (about.get("names") or {}).get("primary")
    ref = ";".join(dict.fromkeys(map(_ref, segment.rules("routes", low, high)))).strip(";")
    tags |= {key: str(value) for key, value in (("name", name), ("ref", ref)) if value}
    tags |= speed_tags(segment.rules("speed_limits", low, high), counts)
    tags |= access_tags(segment.rules("access_restrictions", low, high), counts)
    return tags


def _ref(route: Mapping[str, Any]) -> str:
    """Return a route's number as it stands on signs: "I 5" of the network US:I."""
    ref = str(route.get("ref") or "")
    network = str(route.get("network") or "").split(":")
    return f"{network[1]} {ref}" if ref.isdecimal() and network[0] == "US" and network[1:] else ref
