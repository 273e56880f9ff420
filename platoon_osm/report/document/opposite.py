"""Roads driven both ways: which routes have another coming the other way beside them.

The two carriageways of a motorway are a few metres apart, less than a pixel on a map of a country.
Where both are driven, each is drawn right of the middle, and this finds where that is.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from ...network.shapes import ragged_order
from ..drawing.basemap import metre_scale

__all__ = ["opposite_gaps"]

FURTHEST_M = 300.0
"""Carriageways further apart than this are two roads."""

STEP_M = 800.0
LEAST_SAMPLES, MOST_SAMPLES = 3, 40
LOOK_M = 40.0
"""Half the stretch of road that its direction is taken from."""

PARALLEL = -0.85
"""Cosine of the angle between two directions that count as opposite, 150 degrees or more."""

GAP_STEP_M = 100
"""Gaps are told in steps of this, so that a line is not cut wherever they change a little."""


def opposite_gaps(net: RoadNetwork, edges: Iterable[int]) -> Mapping[int, int]:
    """Return how far away others of these edges run the other way.

    Parameters
    ----------
    net : RoadNetwork
        Whose edges they are.
    edges : iterable of int
        All that are driven.

    Returns
    -------
    mapping of int to int
        Metres by edge. Edges that have none beside them, along two of the places looked at or
        half of them, are left out.
    """
    import shapely

    ids = np.unique(np.fromiter(edges, np.int64))
    if len(ids) < 2:
        return {}
    points, first = ragged_order(net.shape_first, ids)
    flat = np.column_stack([net.shape_lon[points], net.shape_lat[points]]) * metre_scale(net)
    lines: Any = shapely.linestrings(flat, indices=np.repeat(np.arange(len(ids)), np.diff(first)))
    length = shapely.length(lines)
    samples = np.clip(length / STEP_M, LEAST_SAMPLES, MOST_SAMPLES).astype(np.int64)
    owner = np.repeat(np.arange(len(ids)), samples)
    rank = np.arange(len(owner)) - np.repeat(np.cumsum(samples) - samples, samples)
    along = length[owner] * (rank + 0.5) / samples[owner]
    places = shapely.line_interpolate_point(lines[owner], along)
    place, other = shapely.STRtree(lines).query(places, predicate="dwithin", distance=FURTHEST_M)
    elsewhere = owner[place] != other
    place, other = place[elsewhere], other[elsewhere]
    there = shapely.line_locate_point(lines[other], places[place])
    here_way = _directions(lines[owner[place]], along[place])
    there_way = _directions(lines[other], there)
    against = (here_way * there_way).sum(axis=1) < PARALLEL
    gap = np.full(len(owner), np.inf)
    np.minimum.at(
        gap, place[against], shapely.distance(lines[other[against]], places[place[against]])
    )
    found: dict[int, int] = {}
    for number, edge in enumerate(ids.tolist()):
        own = gap[owner == number]
        met = own[np.isfinite(own)]
        if len(met) >= min(2, len(own) / 2):
            found[edge] = GAP_STEP_M * round(float(np.median(met)) / GAP_STEP_M)
    return found


def _directions(lines: Any, along: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the unit vector that each line runs along at a distance from its start."""
    import shapely

    ends = np.clip(along[:, None] + [-LOOK_M, LOOK_M], 0.0, shapely.length(lines)[:, None])
    back, ahead = (
        shapely.get_coordinates(shapely.line_interpolate_point(lines, ends[:, k])) for k in (0, 1)
    )
    step = ahead - back
    unit: NDArray[np.float64] = step / np.maximum(np.hypot(*step.T), 1e-9)[:, None]
    return unit
