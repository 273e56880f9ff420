"""What each truck drives in whole seconds, and who is with whom: companies lane by lane.

Trucks are together on a lane if they leave all of its points at the same instants; so whoever
stands within a lane does so with all of its company, or is alone there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ...planning.legal.driver.road import LegalTrip
from .ways import LaneWay

__all__ = ["Occupied", "Scheduled", "left_at"]

Ints = NDArray[np.int64]
Moments = tuple[int, ...]

NOWHERE: Mapping[int, int] = MappingProxyType({})
"""With all that are there."""


@dataclass(frozen=True, slots=True, eq=False)
class Scheduled:
    """A truck's timetable.

    Attributes
    ----------
    way : LaneWay
        Its way.
    leaves : ndarray of int64, (n,)
        When it leaves each point but the last [s].
    trip : LegalTrip or None
        Its pauses; None where they are not known to be lawful.
    apart_on : dict of int to int
        Lanes of its way, by their places, on which it is not with those who are there at the same
        instants, with a mark of its own.
    """

    way: LaneWay
    leaves: Ints
    trip: LegalTrip | None
    apart_on: Mapping[int, int] = field(default_factory=lambda: NOWHERE)

    def entries(self) -> list[tuple[int, Moments]]:
        """Return each lane with the instants at which its points are left.

        Returns
        -------
        list of (int, tuple of int), (M,)
            Seconds; where it is apart from others there its mark follows them.
        """
        first, leaves = self.way.first_hop.tolist(), self.leaves.tolist()
        found = [
            (lane, tuple(leaves[first[i] : first[i + 1]]))
            for i, lane in enumerate(self.way.lanes.tolist())
        ]
        for place, mark in self.apart_on.items():
            lane, moments = found[place]
            found[place] = lane, (*moments, mark)
        return found


def left_at(way: LaneWay, trip: LegalTrip, appointed: Ints) -> Ints:
    """Return when a truck leaves each point of its way.

    Parameters
    ----------
    way : LaneWay
        Its way.
    trip : LegalTrip
        When it departs, and its pauses.
    appointed : ndarray of int64, (n,)
        When points have to be left [s]; `FREE` where that is open.

    Returns
    -------
    ndarray of int64, (n,)
        Seconds.
    """
    leaves = np.empty(way.road.hops, np.int64)
    ends = {pause.point: pause.end_s for pause in trip.pauses}
    at = trip.departure_s
    for point, drive_s in enumerate(way.road.drive_s.tolist()):
        at = max(at, ends.get(point, at), int(appointed[point]))
        leaves[point] = at
        at += drive_s
    return leaves


class Occupied:
    """Who is on which lane, and when.

    Parameters
    ----------
    alone, member, extra : ndarray of int64, (L,)
        What lanes cost one vehicle alone, each of a platoon, and a platoon once more [grains].
    largest : int
        Vehicles of the largest platoon; 0 for any.
    """

    def __init__(self, alone: Ints, member: Ints, extra: Ints, largest: int) -> None:
        self.alone: list[int] = alone.tolist()
        self.member: list[int] = member.tolist()
        self.extra: list[int] = extra.tolist()
        self.largest = largest
        self.by_lane: dict[int, dict[Moments, set[int]]] = {}

    def enter(self, truck: int, schedule: Scheduled) -> None:
        """Note what a truck drives.

        Parameters
        ----------
        truck : int
            Position in the plan.
        schedule : Scheduled
            Its timetable.
        """
        for lane, moments in schedule.entries():
            self.by_lane.setdefault(lane, {}).setdefault(moments, set()).add(truck)

    def leave(self, truck: int, schedule: Scheduled) -> None:
        """Forget what a truck drives.

        Parameters
        ----------
        truck : int
            Position in the plan.
        schedule : Scheduled
            As it was noted.
        """
        for lane, moments in schedule.entries():
            own = self.by_lane[lane]
            own[moments].discard(truck)
            if not own[moments]:
                del own[moments]

    def cost_of(self, lane: int, count: int) -> int:
        """Return what a company pays on a lane.

        Parameters
        ----------
        lane : int
            The lane.
        count : int
            How many are together.

        Returns
        -------
        int
            Grains, as the text of `fleets.instance` says.
        """
        if count <= 1:
            return int(count * self.alone[lane])
        if not self.largest:
            return int(count * self.member[lane] + self.extra[lane])
        if self.largest == 2 and count % 2:
            rest = count - 1
            return int(rest * self.member[lane] + self.extra[lane] * (rest // 2) + self.alone[lane])
        platoons = -(-count // self.largest)
        return int(count * self.member[lane] + self.extra[lane] * platoons)

    def more_for(self, lane: int, count: int) -> int:
        """Return what a company pays more with one more.

        Parameters
        ----------
        lane : int
            The lane.
        count : int
            How many are together without it.

        Returns
        -------
        int
            Grains.
        """
        return self.cost_of(lane, count + 1) - self.cost_of(lane, count)

    def price(self, schedule: Scheduled) -> int:
        """Return what all pay more once a truck drives a timetable beside them.

        Parameters
        ----------
        schedule : Scheduled
            Of a truck that is not noted.

        Returns
        -------
        int
            The sum over its lanes [grains].
        """
        return sum(
            self.more_for(lane, len(self.by_lane.get(lane, {}).get(moments, ())))
            for lane, moments in schedule.entries()
        )

    def cost(self) -> int:
        """Return what all pay [grains]."""
        return sum(
            self.cost_of(lane, len(company))
            for lane, own in self.by_lane.items()
            for company in own.values()
        )
