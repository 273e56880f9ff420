"""How ways rise and fall, by the heights of their nodes and by their own slope.

Between two nodes of a way with known heights, the road is taken to rise evenly along it. Where no
two nodes have one on either side, the way's own `incline` holds. Heights win where both are there:
their differences add up along a route, while a slope is mostly that of a sign at the steepest
place. A stretch between nodes that would be steeper than any road is a slip, and not counted on.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...network.geodesy import distance_m
from ..slopes import STEEPEST, read_height_m
from .raw_map import RawMap

__all__ = ["Climbs", "drawn_slopes"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

HEIGHTS_READ = "nodes with a height"
UNREAD = "ele not understood"
ABSURD = "ele too high or too low for a road, ignored"
STEEP = f"stretches of more than {100 * STEEPEST:g} % between nodes with ele, ignored"


@dataclass(frozen=True, slots=True, eq=False)
class Climbs:
    """Slope of each segment as it is drawn.

    Attributes
    ----------
    slope : ndarray of float, (s,)
        Rise over length; NaN where it is not known.
    length_m : ndarray of float, (s,)
        Length [m].
    """

    slope: Floats
    length_m: Floats

    def of(self, segments: NDArray[np.bool_]) -> Climbs:
        """Return those of some segments.

        Parameters
        ----------
        segments : ndarray of bool, (s,)
            Which ones.

        Returns
        -------
        Climbs
            In the same order.
        """
        return Climbs(self.slope[segments], self.length_m[segments])

    def columns(self, forward: NDArray[np.bool_], backward: NDArray[np.bool_]) -> dict[str, Floats]:
        """Return what a network keeps of the directed segments.

        Parameters
        ----------
        forward, backward : ndarray of bool, (s,)
            In which directions each segment is driven.

        Returns
        -------
        dict of str to ndarray
            `climb_m`, `descent_m` and `graded_m` of those driven forward, then of the others.
        """
        known = np.isfinite(self.slope)
        rise = np.where(known, self.slope, 0.0) * self.length_m
        rises = np.concatenate([rise[forward], -rise[backward]])
        graded = np.where(known, self.length_m, 0.0)
        return {
            "climb_m": np.maximum(rises, 0.0),
            "descent_m": np.maximum(-rises, 0.0),
            "graded_m": np.concatenate([graded[forward], graded[backward]]),
        }


def drawn_slopes(
    raw: RawMap, start: Index, way: Index, way_slope: Floats, counts: Counter[str]
) -> Climbs | None:
    """Return how the segments of kept ways rise.

    Parameters
    ----------
    raw : RawMap
        The file.
    start : ndarray of int64, (s,)
        Where each segment begins, as a position in the raw map's nodes; it ends at the next one.
    way : ndarray of int64, (s,)
        The way that each is on.
    way_slope : ndarray of float, (w,)
        Slope of each way by its own tags; NaN where it is not known.
    counts : Counter
        Counts heights read and ignored.

    Returns
    -------
    Climbs or None
        None if nothing is known anywhere.
    """
    height_m = _heights(raw, start, counts)
    if height_m is None and not np.isfinite(way_slope).any():
        return None
    lon, lat, stop = raw.lon, raw.lat, start + 1
    length = distance_m(lon[start], lat[start], lon[stop], lat[stop])
    slope = way_slope[way]
    if height_m is not None:
        between = _between_heights(height_m, way, start, length, counts)
        slope = np.where(np.isfinite(between), between, slope)
    return Climbs(slope, length)


def _heights(raw: RawMap, start: Index, counts: Counter[str]) -> Floats | None:
    """Return the height at each position of the raw map's nodes; NaN where it is not known."""
    if not len(raw.height_of) or not len(start):
        return None
    at = np.searchsorted(raw.height_of, raw.ref)
    at[at == len(raw.height_of)] = 0
    told = np.flatnonzero(raw.height_of[at] == raw.ref)
    on_road = np.zeros(len(raw.ref), bool)
    on_road[start] = on_road[start + 1] = True
    told = told[on_road[told]]
    nodes, back = np.unique(at[told], return_inverse=True)
    known = {raw.heights[node] for node in nodes.tolist()}
    read = {text: read_height_m(text) for text in known}
    metres = np.array([read[raw.heights[node]] for node in nodes.tolist()], np.float64)
    for name, those in (
        (HEIGHTS_READ, np.isfinite(metres)), (UNREAD, np.isnan(metres)), (ABSURD, np.isinf(metres)),
    ):  # fmt: skip
        if those.any():
            counts[name] += int(those.sum())
    metres[~np.isfinite(metres)] = np.nan
    height_m = np.full(len(raw.ref), np.nan)
    height_m[told] = metres[back]
    return height_m


def _between_heights(
    height_m: Floats, way: Index, start: Index, length: Floats, counts: Counter[str]
) -> Floats:
    """Return the slope of each segment between two heights of its way."""
    slope = np.full(len(start), np.nan)
    # The first and the last segment of each unbroken run along a way.
    begins = np.ones(len(start), bool)
    begins[1:] = (start[1:] != start[:-1] + 1) | (way[1:] != way[:-1])
    run = np.cumsum(begins) - 1
    along = np.concatenate([[0.0], np.cumsum(length)])
    # Places with a height, each as the number of segments before it: a run's beginnings, and ends.
    at_start, at_stop = np.isfinite(height_m[start]), np.isfinite(height_m[start + 1])
    number = np.arange(len(start))
    opening = number[at_start & begins]
    closing = number[at_stop]
    place = np.concatenate([opening, closing + 1])
    own_run = np.concatenate([run[opening], run[closing]])
    height = np.concatenate([height_m[start[opening]], height_m[start[closing] + 1]])
    order = np.lexsort((place, own_run))
    place, own_run, height = place[order], own_run[order], height[order]
    pair = np.flatnonzero(own_run[1:] == own_run[:-1])
    first, last = place[pair], place[pair + 1]
    metres, rise = along[last] - along[first], height[pair + 1] - height[pair]
    steep = np.abs(rise) > STEEPEST * metres
    if steep.any():
        counts[STEEP] += int(steep.sum())
    good = ~steep & (metres > 0)
    first, size = first[good], (last - first)[good]
    ends = np.cumsum(size)
    within = np.arange(int(size.sum())) + np.repeat(first - (ends - size), size)
    slope[within] = np.repeat(rise[good] / metres[good], size)
    return slope
