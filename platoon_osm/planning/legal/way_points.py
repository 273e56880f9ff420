"""The points of a way at which a vehicle may stand: truck parkings beside it, and its ends.

Where no parking is known for `NEAR_S` of driving, junctions on the way take its place, marked:
a truck can leave the road there, but nobody says that it may stand. Driving times to the points
are rounded up to whole seconds from the start of the way.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...network.placed import PlacedNetwork, network_below
from ...network.road_network import RoadNetwork
from ...network.stops import Stops
from ...plans.pauses import PausePlace
from ...vehicles.profile import Vehicle
from ...vehicles.stop_offers import offers_to
from ..timing.forbidden import Interval, Section, forbidden_starts
from ..timing.parking_before import parking_place
from .driver.road import NO_LIMIT, Road, joined_roads, road_of

__all__ = ["NEAR_S", "Closed", "WayPoint", "WayPoints", "joined", "part_of_way", "way_points"]

Floats = NDArray[np.float64]
Edges = NDArray[np.int64]

Closed = Callable[[int], Sequence[Interval]]
"""From an edge of the network to when it is closed [s]."""

NEAR_S = 60 * 60.0
"""Where parkings are farther apart than this, junctions between them may be stood at [s]."""

APART_S = 4 * 60.0
"""Of places nearer to each other than this one is enough [s]."""

HAIR_S = 1e-6
MARGIN_S = 1
"""Rounding moves a vehicle by less than this; closings are taken to be longer by it [s]."""


@dataclass(frozen=True, slots=True)
class WayPoint:
    """A point of a way.

    Attributes
    ----------
    at : int
        The position of an edge on the way; as many as there are edges for the destination.
    share : float
        How much of that edge lies before the point, at least 0 and below 1.
    place : PausePlace or None
        Where a vehicle stands there; None where it is not to rest.
    """

    at: int
    share: float
    place: PausePlace | None = None


@dataclass(frozen=True, slots=True, eq=False)
class WayPoints:
    """A way as the law sees it, and where its points are.

    Attributes
    ----------
    road : Road
        Hops between n + 1 points.
    points : tuple of WayPoint, (n + 1,)
        In driving order.
    """

    road: Road
    points: tuple[WayPoint, ...]

    def index_of(self, at: int) -> int:
        """Return the point at which an edge of the way begins.

        Parameters
        ----------
        at : int
            The edge's position; it must be a point.

        Returns
        -------
        int
            The point's position.
        """
        return next(k for k, one in enumerate(self.points) if (one.at, one.share) == (at, 0.0))


def way_points(
    net: RoadNetwork,
    edges: Edges,
    drive_s: Floats,
    vehicle: Vehicle,
    keep: Sequence[int] = (),
    closed: Closed | None = None,
    near_s: float = NEAR_S,
) -> WayPoints:
    """Return the points of a way.

    Parameters
    ----------
    net : RoadNetwork
        The network, with or without places between its junctions.
    edges : ndarray of int, (k,)
        Its edges in driving order.
    drive_s : ndarray of float, (k,)
        How long each takes [s].
    vehicle : Vehicle
        Who drives; what is closed to it is no place to stand.
    keep : sequence of int
        Positions of edges whose beginning is a point in any case.
    closed : callable, optional
        When edges are closed.
    near_s : float
        Where parkings are farther apart than this, junctions stand in [s].

    Returns
    -------
    WayPoints
        From the start of the way to its end.
    """
    starts = np.concatenate([[0.0], np.cumsum(drive_s)])
    found = _parkings(net, edges, starts, drive_s, vehicle)
    found += _junctions(net, edges, starts, [when for when, *_ in found], near_s)
    always = {(at, 0.0) for at in (0, len(edges), *keep)}
    rows = {(at, share): (when, place, stay) for when, at, share, place, stay in sorted(
        found, key=lambda row: row[0]
    )}  # fmt: skip
    for at, share in always - rows.keys():
        rows[at, share] = float(starts[at]), None, 0
    rows = _apart(rows, always)
    order = sorted(rows)
    at_s = np.array([math.ceil(rows[key][0] - HAIR_S) for key in order], np.int64)
    points = tuple(WayPoint(*key, rows[key][1]) for key in order)
    forbidden = None if closed is None else _forbidden(edges, starts, drive_s, points, closed)
    road = road_of(np.diff(at_s), [rows[key][2] for key in order], forbidden=forbidden)
    return WayPoints(road, points)


Row = tuple[float, int, float, PausePlace | None, int]
"""When a point is reached [s], its edge and share, the place, the longest stay [s]."""


def _parkings(
    net: RoadNetwork, edges: Edges, starts: Floats, drive_s: Floats, vehicle: Vehicle
) -> list[Row]:
    below = network_below(net)
    if not len(below.points.kind):
        return []
    stops = below.attached(Stops)
    found: list[Row] = []
    for at, edge in enumerate(edges.tolist()):
        own, begin, end = _part(net, edge)
        if own < 0:
            continue
        for stop, access in stops.on(own):
            inside = begin <= access.share < end or (access.share == end == 1.0)
            if stop.kind == "tunnel" or not inside or "parking" not in offers_to(stop, vehicle):
                continue
            share = (access.share - begin) / (end - begin)
            place = parking_place(stop, access)
            stay = NO_LIMIT if stop.max_stay_s is None else int(stop.max_stay_s)
            when = float(starts[at] + share * drive_s[at])
            where = (at, share) if share < 1.0 else (at + 1, 0.0)
            found.append((when, *where, place, stay))
    return found


def _part(net: RoadNetwork, edge: int) -> tuple[int, float, float]:
    """Return which edge of the network below an edge is a part of, and which part."""
    if isinstance(net, PlacedNetwork) and net.below is not None:
        return int(net.below_edge[edge]), float(net.begins[edge]), float(net.ends[edge])
    return edge, 0.0, 1.0


def _junctions(
    net: RoadNetwork, edges: Edges, starts: Floats, parkings: Sequence[float], near_s: float
) -> list[Row]:
    """Return junctions to stand at where no parking is near."""
    ends = [0.0, *sorted(parkings), float(starts[-1])]
    tails = net.tail[edges]
    ways_out = net.first_out[tails + 1] - net.first_out[tails]
    forks = [at for at in range(1, len(edges)) if ways_out[at] > 1]
    times = starts[forks]
    found: list[Row] = []
    for begin, end in pairwise(ends):
        if end - begin <= near_s:
            continue
        low, high = np.searchsorted(times, [begin + APART_S, end - APART_S])
        last = begin
        for at in forks[low:high]:
            if starts[at] - last < APART_S:
                continue
            last = float(starts[at])
            node = int(net.tail[edges[at]])
            place = PausePlace(
                net.place_name(node), "junction", float(net.lon[node]), float(net.lat[node])
            )
            found.append((last, at, 0.0, place, NO_LIMIT))
    return found


def _apart(
    rows: dict[tuple[int, float], tuple[float, PausePlace | None, int]],
    always: set[tuple[int, float]],
) -> dict[tuple[int, float], tuple[float, PausePlace | None, int]]:
    """Leave out places that are near to one before them with as long a stay."""
    kept: dict[tuple[int, float], tuple[float, PausePlace | None, int]] = {}
    last_s, last_stay = -math.inf, 0
    for key in sorted(rows):
        when, place, stay = rows[key]
        if place is not None:
            if when - last_s < APART_S and stay <= last_stay:
                if key not in always:
                    continue
            else:
                last_s, last_stay = when, stay
        kept[key] = when, place, stay
    return kept


def _forbidden(
    edges: Edges, starts: Floats, drive_s: Floats, points: Sequence[WayPoint], closed: Closed
) -> list[list[tuple[int, int]]]:
    """Return for each hop when it may not be started."""
    found = []
    for one, after in pairwise(points):
        begin_s = _time_at(starts, drive_s, one)
        end_s = _time_at(starts, drive_s, after)
        last = after.at if after.share > 0 else after.at - 1
        sections = []
        for at in range(one.at, last + 1):
            intervals = tuple(closed(int(edges[at])))
            if intervals:
                low = max(begin_s, float(starts[at])) - begin_s
                high = min(end_s, float(starts[at + 1])) - begin_s
                sections.append(Section(low, high, intervals))
        found.append(
            [
                (math.floor(low) - MARGIN_S, math.ceil(high) + MARGIN_S)
                for low, high in forbidden_starts(sections)
            ]
        )
    return [_merged(one) for one in found]


def _merged(intervals: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Join intervals that touch once they are rounded."""
    found: list[tuple[int, int]] = []
    for begin, end in intervals:
        if found and begin <= found[-1][1]:
            found[-1] = (found[-1][0], max(found[-1][1], end))
        else:
            found.append((begin, end))
    return found


def _time_at(starts: Floats, drive_s: Floats, point: WayPoint) -> float:
    begin = float(starts[point.at])
    return begin + (point.share * float(drive_s[point.at]) if point.share else 0.0)


def part_of_way(way: WayPoints, first: int, last: int) -> WayPoints:
    """Return what lies between two points of a way.

    Parameters
    ----------
    way : WayPoints
        The way.
    first, last : int
        Its points.

    Returns
    -------
    WayPoints
        With edges counted from the first point's.
    """
    road, begin = way.road, way.points[first].at
    hops, points = slice(first, last), slice(first, last + 1)
    part = road_of(
        road.drive_s[hops],
        road.stay_s[points],
        clock_s=road.clock_s[hops],
        leave_s=road.leave_s[points],
        forbidden=[[tuple(one) for one in road.forbidden(k).tolist()] for k in range(first, last)],
    )
    return WayPoints(part, tuple(replace(one, at=one.at - begin) for one in way.points[points]))


def joined(parts: Sequence[WayPoints]) -> WayPoints:
    """Return ways that follow each other as one; a point where two meet is one point.

    Parameters
    ----------
    parts : sequence of WayPoints
        In driving order; each ends, and all but the first begin, at the beginning of an edge.

    Returns
    -------
    WayPoints
        Where both know a place to stand, that of the later part.
    """
    some = [part for part in parts if part.road.hops]
    points = list(some[0].points)
    for part in some[1:]:
        offset = points[-1].at
        first = part.points[0]
        place = points[-1].place if first.place is None else first.place
        points[-1] = WayPoint(offset, 0.0, place)
        points += [replace(one, at=one.at + offset) for one in part.points[1:]]
    return WayPoints(joined_roads([part.road for part in some]), tuple(points))
