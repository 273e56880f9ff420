"""Where a truck leaves the road for a stop beside it.

Of all roads within 1 km:

1. Ramps that end within 300 m of the stop, with no road between, lead to it: maps with few
   classes of road hold the ramp and not the lanes of the stop. The road is left where the ramp
   leaves it.
2. Else it is the nearest road. Ramps that begin at no road lead away from a stop, not to it. A ramp
   that leads from a road past the stop and back to the same road counts as that road.
3. A road with two sides serves the stop from the carriageway that has it on the side on which
   trucks drive; where the nearest has it on the other side, so does the one beyond, and both lead
   to it: it lies between them. A road without separation serves it in both directions, and where
   the nearest point is a junction, each road that ends there does.

Distances are those on a plane true to scale at the stop.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from .antimeridian import wrapped_deg
from .columns import ROAD_CLASSES
from .driving_side import keeps_left
from .geodesy import metres_per_degree
from .road_network import RoadNetwork
from .road_stop import StopAccess

__all__ = ["LINK_END_M", "REACH_M", "StopRoads"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

REACH_M = 1000.0
"""A stop farther from every road than this has no access [m]."""

LINK_END_M = 300.0
"""A ramp that ends nearer to a stop than this leads to it [m]."""

SAME_M = 0.5
"""Roads whose distances differ by less are drawn as one line [m]."""

MEDIAN_M = 250.0
"""Carriageways of one road with a stop between them are not farther from it than this [m]."""

LINKS = [code for code, name in enumerate(ROAD_CLASSES) if name.endswith("_link")]
FERRY = ROAD_CLASSES.index("ferry")


@dataclass(frozen=True, slots=True, eq=False)
class _Near:
    """The nearest point of each edge within reach of one stop, the nearest first.

    `left` is positive where the stop lies to the left; `east` and `north` lead from the stop to
    the point [m], `along` is the direction of travel there; `lon` and `lat` are the stop's.
    """

    lon: float
    lat: float
    edge: Index
    away_m: Floats
    share: Floats
    left: Floats
    east: Floats
    north: Floats
    along: Floats


class StopRoads:
    """The roads of a network, to be asked for what is near to a stop.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    """

    def __init__(self, net: RoadNetwork) -> None:
        import shapely

        self._net = net
        usable = ~net.inferred & (net.road_class != FERRY)
        self._link = np.isin(net.road_class, LINKS)
        tails, heads = (
            np.bincount(net.tail, minlength=net.n),
            np.bincount(net.head, minlength=net.n),
        )
        self._begins = heads[net.tail] == 0
        self._ends = tails[net.head] == 0
        usable &= ~(self._link & self._begins)
        size = np.diff(net.shape_first)
        owner = np.repeat(np.arange(net.m), size)
        inner = np.ones(len(owner), bool)
        inner[net.shape_first[1:] - 1] = False
        first = np.flatnonzero(inner & usable[owner])
        self._first, self._owner = first, owner[first]
        lon, lat = net.shape_lon, net.shape_lat
        # Across the antimeridian a piece goes on beyond 180 degrees.
        self._step = wrapped_deg(np.diff(lon, append=0.0)[first])
        x, y = lon[first], lat[first]
        x2, y2 = x + self._step, lat[first + 1]
        boxes = shapely.box(np.minimum(x, x2), np.minimum(y, y2), np.maximum(x, x2),
                            np.maximum(y, y2))  # fmt: skip
        self._tree = shapely.STRtree(boxes)

    def accesses(self, lon: Floats, lat: Floats) -> list[tuple[StopAccess, ...]]:
        """Return where trucks leave the road for stops.

        Parameters
        ----------
        lon, lat : ndarray of float, (k,)
            The stops [deg].

        Returns
        -------
        list of tuple of StopAccess
            Of each stop, none where no road is within reach; two where trucks reach it from both
            directions.
        """
        return [self._accesses(near) for near in self._near(lon, lat)]

    def on_road(self, lon: Floats, lat: Floats) -> list[tuple[StopAccess, ...]]:
        """Return the edges on which points of roads lie.

        Parameters
        ----------
        lon, lat : ndarray of float, (k,)
            The points [deg].

        Returns
        -------
        list of tuple of StopAccess
            Of each point the nearest edge, and that of the other direction where it is one line.
        """
        return [
            tuple(
                _access(near, k)
                for k in np.flatnonzero(near.away_m <= near.away_m[0] + SAME_M).tolist()
            )
            if len(near.edge)
            else ()
            for near in self._near(lon, lat)
        ]

    def _near(self, lon: Floats, lat: Floats) -> list[_Near]:
        import shapely

        per_lon, per_lat = metres_per_degree(lat)
        reach_x, reach_y = 1.001 * REACH_M / np.maximum(per_lon, 1.0), 1.001 * REACH_M / per_lat
        stops, pieces, turns = [], [], []
        for turn in (0.0, 360.0, -360.0):
            own = np.arange(len(lon)) if not turn else np.flatnonzero(np.abs(lon) > 179)
            west, east = lon[own] + turn - reach_x[own], lon[own] + turn + reach_x[own]
            south, north = lat[own] - reach_y[own], lat[own] + reach_y[own]
            boxes: Any = shapely.box(west, south, east, north)
            row, piece = self._tree.query(boxes)
            stops.append(own[row])
            pieces.append(piece)
            turns.append(np.full(len(row), turn))
        stop, piece, turned = (np.concatenate(found) for found in (stops, pieces, turns))
        net, first = self._net, self._first[piece]
        x = (net.shape_lon[first] - lon[stop] - turned) * per_lon[stop]
        y = (net.shape_lat[first] - lat[stop]) * per_lat[stop]
        dx = self._step[piece] * per_lon[stop]
        dy = (net.shape_lat[first + 1] - net.shape_lat[first]) * per_lat[stop]
        square = dx**2 + dy**2
        part = np.divide(-(x * dx + y * dy), square, out=np.zeros_like(dx), where=square > 0)
        part = np.clip(part, 0.0, 1.0)
        to_x, to_y = x + part * dx, y + part * dy
        away = np.hypot(to_x, to_y)
        edge = self._owner[piece]
        order = np.lexsort((piece, away, edge, stop))
        order = order[away[order] <= REACH_M]
        new = np.ones(len(order), bool)
        new[1:] = (np.diff(stop[order]) != 0) | (np.diff(edge[order]) != 0)
        order = order[new]
        # Now one row for each stop and edge: sorted by distance, each stop gets its own.
        order = order[np.lexsort((edge[order], away[order], stop[order]))]
        cuts = np.searchsorted(stop[order], np.arange(len(lon) + 1))
        found: list[_Near] = []
        for begin, end in zip(cuts[:-1].tolist(), cuts[1:].tolist(), strict=True):
            rows = order[begin:end]
            left = to_x[rows] * dy[rows] - to_y[rows] * dx[rows]
            found.append(
                _Near(
                    float(lon[len(found)]),
                    float(lat[len(found)]),
                    edge[rows],
                    away[rows],
                    self._shares(edge[rows], first[rows], part[rows]),
                    left,
                    to_x[rows],
                    to_y[rows],
                    np.column_stack([dx[rows], dy[rows]]),
                )
            )
        return found

    def _shares(self, edges: Index, first: Index, part: Floats) -> Floats:
        """Return how much of each edge lies before a point of one of its pieces."""
        net = self._net
        found = np.zeros(len(edges))
        for k, (edge, piece) in enumerate(zip(edges.tolist(), first.tolist(), strict=True)):
            begin, end = int(net.shape_first[edge]), int(net.shape_first[edge + 1])
            lat = net.shape_lat[begin:end]
            per_lon, per_lat = metres_per_degree((lat[1:] + lat[:-1]) / 2)
            step = wrapped_deg(np.diff(net.shape_lon[begin:end]))
            length = np.hypot(step * per_lon, np.diff(lat) * per_lat)
            at = piece - begin
            whole = length.sum()
            if at == len(length) - 1 and part[k] == 1.0:
                found[k] = 1.0  # exactly, whatever the sums round to
            elif whole:
                found[k] = (length[:at].sum() + part[k] * length[at]) / whole
        return np.clip(found, 0.0, 1.0)

    def _accesses(self, near: _Near) -> tuple[StopAccess, ...]:
        if not len(near.edge):
            return ()
        ending = np.flatnonzero(self._link[near.edge] & self._ends[near.edge])
        gaps = [(self._gap_m(near, int(edge)), int(edge)) for edge in near.edge[ending]]
        by_ramp: dict[int, StopAccess] = {}
        for gap, edge in sorted(gaps):
            if gap <= LINK_END_M:
                for access in self._before(edge, gap):
                    by_ramp.setdefault(access.edge, access)
        if by_ramp:
            return tuple(by_ramp.values())
        edge = int(near.edge[0])
        if self._link[edge]:
            if self._ends[edge] and (found := self._before(edge, float(near.away_m[0]))):
                return found
            if found := self._returning(edge, float(near.away_m[0]), near):
                return found
        return self._beside(near)

    def _gap_m(self, near: _Near, link: int) -> float:
        """Return how far a ramp ends from the stop; infinite with a road between."""
        net, head = self._net, int(self._net.head[link])
        per_lon, per_lat = metres_per_degree(near.lat)
        turn = float(wrapped_deg(float(net.lon[head]) - near.lon))
        east, north = turn * float(per_lon), (float(net.lat[head]) - near.lat) * float(per_lat)
        gap = float(np.hypot(east, north))
        roads = np.flatnonzero((near.away_m < gap) & ~self._link[near.edge])
        if any(_parts(near, j, east, north) for j in roads.tolist()):
            return np.inf
        return gap

    def _before(self, link: int, gap_m: float) -> tuple[StopAccess, ...]:
        """Return the ends of the edges from which a ramp leaves, followed back over ramps."""
        net = self._net
        ins, first_in = net.incoming()
        length = gap_m
        seen = {link}
        at = link
        while True:
            length += float(net.length_m[at])
            node = int(net.tail[at])
            before = ins[first_in[node] : first_in[node + 1]]
            roads = before[~self._link[before]]
            if len(roads):
                break
            roads = before[[int(e) not in seen for e in before]]
            if len(roads) != 1:
                break  # where ramps meet, each is a way to the stop
            at = int(roads[0])
            seen.add(at)
        side: Literal["right", "left"] = "left" if self._keeps_left(at) else "right"
        return tuple(StopAccess(e, 1.0, length, side, True) for e in sorted(roads.tolist()))

    def _returning(self, link: int, gap_m: float, near: _Near) -> tuple[StopAccess, ...]:
        """Return where a road is left for a ramp that leads back to it."""
        net = self._net
        ins, first_in = net.incoming()
        node = int(net.tail[link])
        before = [int(e) for e in ins[first_in[node] : first_in[node + 1]] if not self._link[e]]
        head = int(net.head[link])
        after = [
            int(e) for e in range(net.first_out[head], net.first_out[head + 1]) if not self._link[e]
        ]
        same = [e for e in before if any(net.ref[e] == net.ref[f] for f in after)]
        length = gap_m + float(near.share[0] * net.length_m[link])
        side: Literal["right", "left"] = "left" if near.left[0] > 0 else "right"
        return tuple(StopAccess(e, 1.0, length, side, True) for e in sorted(same))

    def _beside(self, near: _Near) -> tuple[StopAccess, ...]:
        """Return where a stop is reached from the road that is nearest to it."""
        same = np.flatnonzero(near.away_m <= near.away_m[0] + SAME_M)
        ending = same[near.share[same] >= 1.0]
        inner = same[(near.share[same] > 0.0) & (near.share[same] < 1.0)]
        # At a junction a truck leaves the edges that end there.
        best = [*(ending if near.share[0] in (0.0, 1.0) and len(ending) else inner[:1])]
        if not best:
            best = [same[0]]
        one = int(best[0])
        if 0.0 < near.share[one] < 1.0:
            best += [k for k in inner[1:] if self._is_opposite(int(near.edge[k]), near.edge[one])]
        if len(best) == 1 and (near.left[one] > 0) != self._keeps_left(int(near.edge[one])):
            between = (
                (near.away_m <= MEDIAN_M)
                & ~self._link[near.edge]
                & (near.along @ near.along[one] < 0)
                & ((near.left > 0) == (near.left[one] > 0))
            )
            beyond = [k for k in np.flatnonzero(between) if k != one]
            # Of edges that meet where it is nearest, the one that ends there.
            alike = [k for k in beyond if near.away_m[k] <= near.away_m[beyond[0]] + SAME_M]
            best += sorted(alike, key=lambda k: (near.share[k] <= 0.0, near.edge[k]))[:1]
        # First the direction that has it on its own side.
        best.sort(
            key=lambda k: ((near.left[k] > 0) != self._keeps_left(int(near.edge[k])), near.edge[k])
        )
        return tuple(_access(near, int(k)) for k in best)

    def _is_opposite(self, edge: int, other: int) -> bool:
        """Tell whether two edges are one line, driven in either direction."""
        net = self._net
        return all(
            net.lon[a] == net.lon[b] and net.lat[a] == net.lat[b]
            for a, b in ((net.tail[edge], net.head[other]), (net.head[edge], net.tail[other]))
        )

    def _keeps_left(self, edge: int) -> bool:
        return keeps_left(str(self._net.texts[self._net.country[edge]]))


def _access(near: _Near, k: int) -> StopAccess:
    side: Literal["right", "left"] = "left" if near.left[k] > 0 else "right"
    return StopAccess(int(near.edge[k]), float(near.share[k]), float(near.away_m[k]), side)


def _parts(near: _Near, j: int, east: float, north: float) -> bool:
    """Tell whether edge j, where it is nearest to the stop, has a point on its other side."""
    dx, dy = near.along[j]
    beyond = dx * (north - near.north[j]) - dy * (east - near.east[j])
    ahead = near.east[j] * east + near.north[j] * north
    return bool(ahead > 0 and beyond * near.left[j] < 0)
