"""When a vehicle may start from the points at which it can wait.

A hop that follows a point without a place is driven at once. So when it may not be started is when
the last point before it at which the vehicle can wait may not be left: earlier by the driving time
between the two. The union over the hops up to the next such point is what is forbidden there, and
the rest are the closed windows in which it is left.
"""

from __future__ import annotations

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
    closed: list[list[tuple[int, int]]] = [[] for _ in range(road.hops)]
    point, away = 0, 0
    for hop in range(road.hops):
        if hop == 0 or road.stay_s[hop] > 0 or road.leave_s[hop] != FREE:
            point, away = hop, 0
        closed[point] += [(int(a) - away, int(b) - away) for a, b in road.forbidden(hop)]
        away += int(road.drive_s[hop])
    first = np.zeros(road.hops + 1, dtype=np.int64)
    windows: list[tuple[int, int]] = []
    for hop, own in enumerate(closed):
        windows += _left_open(own) if own else []
        first[hop + 1] = len(windows)
    return first, np.array(windows, dtype=np.int64).reshape(-1, 2)


def _left_open(closed: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return the closed windows that open intervals leave."""
    windows = []
    at = -NO_LIMIT
    for begin, end in sorted(one for one in closed if one[0] < one[1]):
        if begin >= at:
            windows.append((at, begin))
        at = max(at, end)
    return [*windows, (at, NO_LIMIT)]
