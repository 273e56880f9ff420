"""The searches of all trucks over some pairs under shares, from one set of shares to the next."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from .buckets import Buckets
from .crews import Crew, chunks_of
from .prices import Prices, Routes
from .schedules import cheapest, told_schedules
from .waiting import cheapest_waiting
from .ways import Ways, ways_of

__all__ = ["Searching"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

ROOM = 1 << 14
"""Labels that a truck's search has room for at first."""


class Searching:
    """The cheapest schedules of all trucks, over the listed pairs or over all.

    A pair that is not listed costs member - h at any instant of its window.

    Parameters
    ----------
    instance : Instance
        The fleet's problem.
    buckets : Buckets
        Listed pairs and their buckets.
    share : ndarray of float64, (S,)
        Their shares [grains]; searches keep to them as they change.
    every : bool
        Whether trucks may use pairs that are not listed.
    ways : Ways, optional
        The networks, if they are known.
    """

    def __init__(
        self,
        instance: Instance,
        buckets: Buckets,
        share: Floats,
        every: bool = False,
        ways: Ways | None = None,
    ) -> None:
        own = np.arange(instance.pairs) if every else buckets.pairs
        self.pairs, self.waiting = own, instance.waiting
        self.ways = ways_of(instance, own) if ways is None else ways
        first_bucket, counts = buckets.first_bucket, np.diff(buckets.first_share)
        starts = buckets.starts
        self.share = share
        first_share = buckets.first_share
        if every and len(buckets.pairs) < instance.pairs:
            # An unlisted pair has one bucket, which begins before all windows.
            listed = np.zeros(instance.pairs, np.bool_)
            listed[buckets.pairs] = True
            first_bucket = np.full(instance.pairs, len(starts), np.int64)
            first_bucket[listed] = buckets.first_bucket
            counts = np.ones(instance.pairs, np.int64)
            counts[listed] = np.diff(buckets.first_share)
            first_share = np.concatenate([[0], np.cumsum(counts)])
            unlisted = -instance.leader_saves[instance.pair_lane[~listed]]
            self.share = np.empty(first_share[-1], np.float64)
            of_listed = np.repeat(listed, counts)
            self.share[of_listed] = share
            self.share[~of_listed] = unlisted
            starts = np.append(starts, instance.opens.min() - 1)
        self.lane = instance.pair_lane[own]
        member = instance.member[self.lane].astype(np.float64)
        self.prices = Prices(member, first_bucket, first_share, starts, self.share)
        places = int(self.ways.first_place[-1])
        self.routes = Routes(
            np.zeros(places, np.int64), np.zeros(places, np.int64),
            np.full(instance.trucks, -1, np.int64), np.zeros(instance.trucks, np.float64),
        )  # fmt: skip
        self._chunks = chunks_of(first_share[self.ways.first] + np.arange(instance.trucks + 1))
        self._room = ROOM

    def search(self, crew: Crew, pruned: bool = True) -> float:
        """Find the cheapest schedules under the shares as they are.

        Parameters
        ----------
        crew : Crew
            Who does it.
        pruned : bool
            Whether to use what the search before found.

        Returns
        -------
        float
            What they cost together [grains]; exactly if shares are whole, for sums of whole
            numbers below 2^53 are exact in double precision.
        """

        def some(begin: int, end: int) -> float:
            room = self._room
            while begin >= 0:
                if self.waiting:
                    stopped = cheapest_waiting(
                        begin, end, room, pruned, self.waiting, self.ways, self.prices, self.routes
                    )
                else:
                    stopped = cheapest(
                        begin, end, room, pruned, self.ways, self.prices, self.routes
                    )
                begin, room = stopped, 4 * room
            self._room = max(self._room, room // 4)
            return 0.0

        crew.each(some, self._chunks)
        # numpy adds in an order that depends on nothing but their number.
        return float(self.routes.cost.sum())

    def used(self) -> Ints:
        """Return the pairs that the schedules use, each once, ascending."""
        own = self.ways.first_place
        inside = np.repeat(own[:-1], self.routes.length) + (
            np.arange(self.routes.length.sum())
            - np.repeat(np.cumsum(self.routes.length) - self.routes.length, self.routes.length)
        )
        return np.unique(self.pairs[self.routes.pair[inside]])

    def schedules(self) -> tuple[NDArray[np.int32], Ints, Ints]:
        """Return the schedules: lanes, departures [ticks], and how many lanes each has."""
        count = np.maximum(self.routes.length, 0)
        width = int(count.max()) if len(count) else 0
        lanes = np.zeros((len(count), width), np.int64)
        departs = np.zeros((len(count), width), np.int64)
        told_schedules(
            self.waiting > 0, self.ways, self.prices, self.routes, self.lane, lanes, departs
        )
        return lanes.astype(np.int32), departs, count
