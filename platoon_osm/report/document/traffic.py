"""A crowd's traffic: roads by how many vehicles drive them alone and in which platoons.

Fifty lines side by side bury what they should show. A crowd is drawn as ribbons instead, as wide as
the traffic is, and a vehicle's own line only where one asks for that vehicle.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping

import numpy as np

from ..drawing.basemap import BASEMAP_STEPS, BASEMAP_TOLERANCE_M, basemap_lines
from ..drawing.crowd import CROWD
from ..drawing.lines import Lines
from .findings import Findings
from .model_map import Traffic, TrafficRoads

__all__ = ["traffic"]

_Kind = tuple[int, tuple[int, ...], int | None]


def traffic(found: Findings) -> Traffic | None:
    """Return what a crowd's routes are drawn as.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Returns
    -------
    Traffic or None
        None of few vehicles, whose lines are drawn one by one. Ways between the road and a place
        beside it are no traffic.
    """
    if len(found.plan.vehicles) <= CROWD:
        return None
    kinds = _kinds(found)
    # A band for each platoon on a road would be wider than the country.
    bundled = any(len(bands) > 1 for _, bands, _ in kinds.values())
    roads: dict[_Kind, list[int]] = defaultdict(list)
    for edge, (alone, bands, opposite_m) in kinds.items():
        if bundled:
            bands = (sum(bands),) if bands else ()
        # A ribbon keeps right of its road by itself; only what lies beside bands must know.
        roads[alone, bands, None if bundled or not bands else opposite_m].append(edge)
    return Traffic(
        bundled=bundled,
        most=max((max(alone, sum(bands)) for alone, bands, _ in roads), default=0),
        roads=tuple(
            TrafficRoads(*kind, lines=_lines(found, roads[kind]))
            for kind in sorted(roads, key=lambda kind: (kind[0], kind[1], kind[2] or 0))
        ),
    )


def _kinds(found: Findings) -> Mapping[int, _Kind]:
    """Return the traffic of each edge; lanes of the drawing know who else is there."""
    kinds: dict[int, _Kind] = {}
    for pieces in found.platoon_parts:
        for band in pieces:
            kinds |= dict.fromkeys(band.edges, (0, band.beside, band.opposite_m))
    for stretch, parts in zip(found.solos, found.solo_parts, strict=True):
        if stretch.access is None:
            for part in parts:
                kinds |= dict.fromkeys(part.edges, (part.slots, part.bands, part.opposite_m))
    return kinds


def _lines(found: Findings, edges: list[int]) -> Lines:
    ids = np.array(sorted(edges), np.int64)
    lines = basemap_lines(found.net, ids, BASEMAP_TOLERANCE_M, directed=True)
    return Lines.rounded(lines, BASEMAP_STEPS)
