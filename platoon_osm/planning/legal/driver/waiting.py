"""When a vehicle may start from the points at which it can wait.

A hop that follows a point without a place is driven at once. So when it may not be started is when
the last point before it at which the vehicle can wait may not be left: earlier by the driving time
between the two. The union over the hops up to the next such point is what is forbidden there, and
the rest are the closed windows in which it is left.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from .road import FREE, NO_LIMIT, IntArray, Road

__all__ = ["windows_of"]


def windows_of(road: Road) -> tuple[IntArray, IntArray]:
    """Return in which windows each point may be left.

    Parameters
    ----------
    road : Road
        With forbidden starts.

    Returns
    -------
    int64 array, (n + 1,)
        Where the windows of each point begin; those without any may be left at any time.
    int64 array, (m, 2)
        Begin and end of each [s], both in it; the first begins at -`NO_LIMIT`, the last ends at
        `NO_LIMIT`.
    """
    first = np.zeros(road.hops + 1, dtype=np.int64)
    if not len(road.forbidden_s):
        return first, np.zeros((0, 2), dtype=np.int64)
    begins = np.concatenate([[0], np.cumsum(road.drive_s)])
    hop = np.repeat(np.arange(road.hops), np.diff(road.forbidden_first))
    waits = (road.stay_s[:-1] > 0) | (road.leave_s[:-1] != FREE)
    waits[0] = True
    points = np.flatnonzero(waits)
    point = points[np.searchsorted(points, hop, side="right") - 1]
    closed = road.forbidden_s - (begins[hop] - begins[point])[:, None]
    groups = np.flatnonzero(np.diff(point, prepend=-1))
    windows: list[tuple[int, int]] = []
    for low, high in pairwise([*groups.tolist(), len(point)]):
        own = _left_open(closed[low:high].tolist())
        first[point[low] + 1] = len(own)
        windows += own
    return np.cumsum(first), np.array(windows, dtype=np.int64).reshape(-1, 2)


def _left_open(closed: list[list[int]]) -> list[tuple[int, int]]:
    """Return the closed windows that open intervals leave."""
    windows = []
    at = -NO_LIMIT
    for begin, end in sorted(closed):
        if begin >= end:
            continue
        if begin >= at:
            windows.append((at, begin))
        at = max(at, end)
    return [*windows, (at, NO_LIMIT)]
