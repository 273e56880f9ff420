"""How edges of an OSMnx graph rise: by heights of nodes, OSMnx' own grades, or tags of roads."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Sequence
from math import isfinite, isnan, nan

import numpy as np
from numpy.typing import NDArray

from ..slopes import INCLINE_TAGS, STEEPEST, read_height_m, slope_along
from .graph_arrays import Attributes, EdgeRow
from .graph_values import flag, number, parts

__all__ = ["edge_rises"]

Floats = NDArray[np.float64]

OWN = ("climb_m", "descent_m", "graded_m")
"""What a network of ours tells of its edges itself."""

HEIGHTS_READ = "nodes with a height"
HEIGHTS_UNREAD = "heights of nodes not understood, or of no road"
STEEP = f"edges of more than {100 * STEEPEST:g} % by heights or grade, ignored"
SEVERAL = "edges with several inclines or grades, not read"


def edge_rises(
    nodes: Iterable[tuple[Hashable, Attributes]],
    edges: Sequence[EdgeRow],
    length_m: Floats,
    counts: Counter[str],
) -> dict[str, Floats]:
    """Return how far directed edges rise and fall.

    The heights of an edge's ends win (`elevation`, as OSMnx' `add_node_elevations_raster` has it,
    else the tag `ele`), then `grade` (of `add_edge_grades`), then `incline` as the way is drawn.

    Parameters
    ----------
    nodes : iterable of tuple[Hashable, Attributes]
        Key and attributes of each.
    edges : sequence of EdgeRow
        Ends and attributes of each.
    length_m : ndarray of float, (m,)
        Their lengths [m].
    counts : Counter
        Counts what was read and ignored.

    Returns
    -------
    dict of str to ndarray
        The columns `climb_m`, `descent_m` and `graded_m`.
    """
    used = {key for u, v, _ in edges for key in (u, v)}
    heights = {key: _height_m(data) for key, data in nodes if key in used}
    for height in heights.values():
        if height is not None:
            counts[HEIGHTS_READ if isfinite(height) else HEIGHTS_UNREAD] += 1
    known = {
        key: height for key, height in heights.items() if height is not None and isfinite(height)
    }
    rows = np.zeros((len(edges), 3))
    for row, (u, v, data), length in zip(rows, edges, length_m.tolist(), strict=True):
        own = [number(data.get(name)) for name in OWN]
        if None not in own:
            row[:] = own
            continue
        slope = nan
        if u in known and v in known and length > 0:
            slope = (known[v] - known[u]) / length
            if abs(slope) > STEEPEST:
                counts[STEEP] += 1
                slope = nan
        if isnan(slope):
            slope = _own_slope(data, counts)
        if not isnan(slope):
            row[:] = max(slope, 0.0) * length, max(-slope, 0.0) * length, length
    return dict(zip(OWN, rows.T, strict=True))


def _height_m(data: Attributes) -> float | None:
    """Return the height of a node; None if nothing is said, not finite if it is none."""
    told = parts(data.get("elevation")) or parts(data.get("ele"))
    if not told:
        return None
    return read_height_m(";".join(str(one) for one in told))


def _own_slope(data: Attributes, counts: Counter[str]) -> float:
    """Return the slope of an edge by what it says itself; NaN if that is nothing."""
    grades = parts(data.get("grade"))
    tags = {key: parts(data.get(key)) for key in INCLINE_TAGS if parts(data.get(key))}
    if len(grades) > 1 or any(len(values) > 1 for values in tags.values()):
        counts[SEVERAL] += 1
        return nan
    grade = number(grades)
    if grade is not None and abs(grade) <= STEEPEST:
        return grade
    if grade is not None:
        counts[STEEP] += 1
    slope, remark = slope_along({key: str(values[0]) for key, values in tags.items()})
    counts.update([remark] if remark else [])
    backwards = parts(data.get("reversed"))
    if len(set(map(flag, backwards))) > 1:
        # One edge of ways drawn against each other: no tag of them says which way it leans.
        return nan
    return -slope if backwards and flag(backwards) else slope
