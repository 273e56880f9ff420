"""What each truck of a fleet drives and when, and what all of them pay, counted from nothing.

Trucks that enter a lane at one instant are a company, and its cost is that of `instance.py`. The
count here shares nothing with the one that the search keeps up to date.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from ..instance import Instance

__all__ = ["Schedules", "company_cost"]

Ints = NDArray[np.int64]


def company_cost(
    size: Ints | int, alone: Ints, member: Ints, extra: Ints, largest: int
) -> Ints:  # fmt: skip
    """Return what companies of some sizes pay.

    Parameters
    ----------
    size : ndarray of int64 or int
        Trucks of each; at least one.
    alone, member, extra : ndarray of int64
        As of `Instance`, for the lane of each [grains].
    largest : int
        Vehicles of the largest platoon; 0 for any.

    Returns
    -------
    ndarray of int64
        The equation of `instance.py` [grains].
    """
    count = np.asarray(size, np.int64)
    platoons = -(-count // largest) if largest else np.ones_like(count)
    together = count * member + platoons * extra
    if largest == 2:
        # The odd one drives alone, and does not save what a leader saves.
        together = together + (count % 2) * (alone - member - extra)
    return np.where(count == 1, alone, together)


@dataclass(frozen=True, slots=True, eq=False)
class Schedules:
    """The lanes of each truck in their order, and the instants at which it enters them.

    Attributes
    ----------
    lanes : ndarray of int32, (N, w)
        Lanes; those beyond `count` mean nothing.
    departs : ndarray of int64, (N, w)
        When each is entered [ticks].
    count : ndarray of int64, (N,)
        How many lanes each truck drives.
    """

    lanes: NDArray[np.int32]
    departs: Ints
    count: Ints

    @classmethod
    def of(cls, lanes: Sequence[Ints], departs: Sequence[Ints]) -> Schedules:
        """Return the schedules of lists.

        Parameters
        ----------
        lanes, departs : sequence of ndarray of int64, (N, ...)
            The lanes of each truck in driving order, and when it enters them [ticks].

        Returns
        -------
        Schedules
            The same.
        """
        count = np.array([len(own) for own in lanes], np.int64)
        used = np.arange(int(count.max(initial=0)))[None, :] < count[:, None]
        one = cls(np.zeros(used.shape, np.int32), np.zeros(used.shape, np.int64), count)
        if used.any():
            one.lanes[used], one.departs[used] = np.concatenate(lanes), np.concatenate(departs)
        return one

    def driven(self) -> tuple[Ints, Ints, Ints]:
        """Return all that is driven, truck by truck.

        Returns
        -------
        truck, lane, depart : ndarray of int64
            Of each drive over a lane.
        """
        used = np.arange(self.lanes.shape[1])[None, :] < self.count[:, None]
        truck = np.repeat(np.arange(len(self.count), dtype=np.int64), self.count)
        return truck, self.lanes[used].astype(np.int64), self.departs[used]

    def ways(self) -> tuple[list[Ints], list[Ints]]:
        """Return what each truck drives, as lists of their own.

        Returns
        -------
        lanes, departs : list of ndarray of int64, (N, ...)
            In driving order, and when it enters them [ticks].
        """
        counts = self.count.tolist()
        return (
            [self.lanes[k, :n].astype(np.int64) for k, n in enumerate(counts)],
            [self.departs[k, :n] for k, n in enumerate(counts)],
        )

    def companies(self) -> tuple[Ints, Ints, Ints]:
        """Return all companies, of one truck too.

        Returns
        -------
        lane, depart, size : ndarray of int64
            Where and when each enters a lane, and how many trucks it has.
        """
        _, lane, depart = self.driven()
        if not len(lane):
            return lane, depart, lane
        order = np.lexsort((depart, lane))
        lane, depart = lane[order], depart[order]
        new = np.concatenate([[True], (np.diff(lane) != 0) | (np.diff(depart) != 0)])
        first = np.flatnonzero(new)
        size = np.diff(np.append(first, len(lane)))
        return lane[first], depart[first], size.astype(np.int64)

    def cost(self, instance: Instance) -> int:
        """Return what all trucks pay.

        Parameters
        ----------
        instance : Instance
            The problem.

        Returns
        -------
        int
            Counted from nothing [grains].
        """
        lane, _, size = self.companies()
        paid = company_cost(
            size, instance.alone[lane], instance.member[lane], instance.extra[lane],
            instance.largest,
        )  # fmt: skip
        return int(paid.sum()) + instance.waiting * self.waited(instance)

    def waited(self, instance: Instance) -> int:
        """Return how long all trucks wait on the road.

        Parameters
        ----------
        instance : Instance
            The problem.

        Returns
        -------
        int
            Between the end of a lane and entering the next [ticks].
        """
        truck, lane, depart = self.driven()
        between = depart[1:] - depart[:-1] - instance.drive[lane[:-1]]
        return int(between[truck[1:] == truck[:-1]].sum())

    def check(self, instance: Instance) -> None:
        """Refuse schedules that are no plan of an instance.

        Parameters
        ----------
        instance : Instance
            The problem.

        Raises
        ------
        ScenarioError
            A truck that jumps, is too early or too late, or uses another's lane.
        """
        for k in range(instance.trucks):
            count = int(self.count[k])
            lanes, departs = self.lanes[k, :count], self.departs[k, :count]
            at, now = int(instance.origin[k]), int(instance.earliest[k])
            fault = ""
            for lane, depart in zip(lanes.tolist(), departs.tolist(), strict=True):
                if instance.tail[lane] != at or instance.lane_kind[lane] != instance.kind[k]:
                    fault = fault or f"enters lane {lane} where it is not, or may not drive"
                if depart < now:
                    fault = fault or f"enters lane {lane} before it can be there"
                at, now = int(instance.head[lane]), depart + int(instance.drive[lane])
            if at != instance.destination[k]:
                fault = fault or "does not end at its destination"
            if count and departs[0] > instance.latest_departure[k]:
                fault = fault or "leaves after its latest departure"
            if now > instance.latest[k]:
                fault = fault or "arrives after its latest arrival"
            if instance.given:
                first, last = instance.first_pair[k], instance.first_pair[k + 1]
                own = instance.pair_lane[first:last][np.argsort(instance.opens[first:last])]
                if own.tolist() != lanes.tolist():
                    fault = fault or "leaves its given route"
            if fault:
                raise ScenarioError(f"fleet: truck {k} {fault}; the plan is not one of this fleet")
