"""The ways of trucks as the law sees them: lane by lane, so that those who share a lane agree.

Driving times from place to place are rounded up to whole seconds, for every truck alike: so who
stands somewhere is not late for it. Where no parking is near, the beginnings of lanes take its
place, marked (`planning.legal.way_points`); there one may turn off.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...planning.legal.driver.road import NO_LIMIT, Road
from ...planning.legal.driver.waiting import windows_of
from ...planning.legal.legal_question import LegalQuestion
from ...planning.legal.way_points import APART_S, NEAR_S, WayPoints, joined
from ...plans.pauses import PausePlace
from ..lanes import Lanes

__all__ = ["LaneWay", "LaneWays"]

Ints = NDArray[np.int64]

HAIR_S = 1e-6
"""Last digits of driving times [s]."""


@dataclass(frozen=True, eq=False)
class LaneWay:
    """A truck's way over some lanes.

    Attributes
    ----------
    lanes : ndarray of int64, (M,)
        The lanes in driving order.
    points : WayPoints
        Its points and hops.
    first_hop : ndarray of int64, (M + 1,)
        Where the hops of each lane begin.
    """

    lanes: Ints
    points: WayPoints
    first_hop: Ints

    @property
    def road(self) -> Road:
        """The hops, and how long one may stand between them."""
        return self.points.road

    @cached_property
    def lane_of(self) -> Ints:
        """The lane of the way that each hop is a part of, (n,)."""
        return np.repeat(np.arange(len(self.lanes)), np.diff(self.first_hop))

    @cached_property
    def windows(self) -> tuple[Ints, Ints]:
        """When points may be left, as `windows_of` has it."""
        return windows_of(self.road)

    @cached_property
    def before_s(self) -> Ints:
        """Driving time from the origin to each point [s], (n + 1,)."""
        return np.concatenate([[0], np.cumsum(self.road.drive_s)])


class LaneWays:
    """What is known of all lanes, worked out once for vehicles that are alike.

    Parameters
    ----------
    legal : LegalQuestion
        Vehicles, closings and the network with places.
    lanes : Lanes
        The lanes of the fleet.
    """

    def __init__(self, legal: LegalQuestion, lanes: Lanes) -> None:
        self.legal, self.lanes = legal, lanes
        like: list[int] = []
        self._alike = []
        vehicles = legal.vehicles
        for index, vehicle in enumerate(vehicles):
            same = next((one for one in like if vehicles[one] == vehicle), None)
            if same is None:
                like.append(index)
            self._alike.append(index if same is None else same)
        self._parts: dict[tuple[int, int, int], WayPoints] = {}

    def part(self, truck: int, lane: int) -> WayPoints:
        """Return a lane as a truck drives it.

        Parameters
        ----------
        truck : int
            Position in the plan.
        lane : int
            One of its kind's.

        Returns
        -------
        WayPoints
            Parkings, and where they are far apart, junctions.
        """
        key = self._alike[truck], int(self.lanes.kind[truck]), lane
        found = self._parts.get(key)
        if found is None:
            first = self.lanes.first_edge
            edges = self.lanes.edges[first[lane] : first[lane + 1]]
            found = self._parts[key] = self._rounded(truck, edges, self.legal.way(truck, edges))
        return found

    def _rounded(self, truck: int, edges: Ints, points: WayPoints) -> WayPoints:
        """Return a lane whose hops are rounded up each: who stands between two is never late."""
        drive_s = self.legal.question.fleet.drive_s((truck,))[edges]
        before_s = np.concatenate([[0.0], np.cumsum(drive_s), [0.0]])
        lasts_s = np.append(drive_s, 0.0)
        at_s = [before_s[one.at] + one.share * lasts_s[one.at] for one in points.points]
        hops = np.ceil(np.diff(at_s) - HAIR_S).astype(np.int64)
        return WayPoints(replace(points.road, drive_s=hops, clock_s=hops), points.points)

    def of(self, truck: int, lanes: Ints, near_s: float = NEAR_S) -> LaneWay:
        """Return the way of a truck over some lanes.

        Parameters
        ----------
        truck : int
            Position in the plan.
        lanes : ndarray of int64, (M,)
            In driving order.
        near_s : float
            Where parkings are farther apart than this, lanes may be stood before [s].

        Returns
        -------
        LaneWay
            With places to stand.
        """
        parts = [self.part(truck, int(lane)) for lane in lanes]
        first = np.concatenate([[0], np.cumsum([part.road.hops for part in parts])])
        return LaneWay(lanes, self._with_junctions(lanes, joined(parts), first, near_s), first)

    def kept_whole(self, truck: int, lanes: Ints) -> LaneWay:
        """Return a way that is rounded from its origin on, as one that is driven alone may be.

        Parameters
        ----------
        truck : int
            Position in the plan.
        lanes : ndarray of int64, (M,)
            In driving order.

        Returns
        -------
        LaneWay
            Of the same edges; the truck stops wherever junctions allow.
        """
        first = self.lanes.first_edge
        edges = np.concatenate([self.lanes.edges[first[one] : first[one + 1]] for one in lanes])
        begins = np.concatenate([[0], np.cumsum(np.diff(first)[lanes])])
        points = self.legal.way(truck, edges, keep=begins[1:-1].tolist(), near_s=0.0)
        hops = [points.index_of(int(at)) for at in begins]
        return LaneWay(lanes, points, np.array(hops, np.int64))

    def _with_junctions(
        self, lanes: Ints, points: WayPoints, first_hop: Ints, near_s: float
    ) -> WayPoints:
        """Return a way on which one may stand before lanes, where no parking is near."""
        road, net = points.road, self.legal.question.net
        at_s = np.concatenate([[0], np.cumsum(road.drive_s)])
        stands = np.flatnonzero(road.stay_s > 0)
        ends = np.concatenate([[0], at_s[stands], at_s[-1:]])
        stay, own = road.stay_s.copy(), list(points.points)
        last, gap = -1, -1
        for place, point in enumerate(first_hop[1:-1].tolist(), 1):
            after = int(np.searchsorted(ends, at_s[point], side="right"))
            if after >= len(ends) or stay[point] > 0:
                continue
            begin, end = ends[after - 1], ends[after]
            since = at_s[point] - (last if gap == after else begin)
            if end - begin <= near_s or since < APART_S or end - at_s[point] < APART_S:
                continue
            node = int(self.lanes.nodes[self.lanes.tail[lanes[place]]])
            stay[point] = NO_LIMIT
            at = PausePlace(
                net.place_name(node), "junction", float(net.lon[node]), float(net.lat[node])
            )
            own[point] = replace(own[point], place=at)
            last, gap = int(at_s[point]), after
        return WayPoints(replace(road, stay_s=stay), tuple(own))
