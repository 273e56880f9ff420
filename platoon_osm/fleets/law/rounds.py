"""Lawful timetables for a whole fleet: each truck answers the others, round after round.

The search without law tells each truck's way and whom it should meet, when. From these instants on,
in whole seconds, each truck takes its lawful trip that costs the fleet least beside what the others
drive (`response`), those with the longest pauses first; what the others do not have lawful yet
counts as they would drive it. Then all are asked again until no truck finds a better trip: whoever
is due a break finds where its company stands, and stands there with it. At last neighbourhoods of
trucks are taken out and put in again, in other orders, and kept so where that costs less.

Where waiting has a price, each pays it for what it stands longer on its way than on its lawful trip
alone.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..lanes import TICK_S
from ..model import FleetModel
from .driven import Occupied, Scheduled
from .response import FAR, Truck
from .ways import LaneWays

__all__ = ["LawfulFleet"]

Ints = NDArray[np.int64]

ROUNDS = 20
"""All trucks are asked at most so often; few are left to answer after five."""

AROUND = 8
"""Trucks of a neighbourhood at most."""

NEAR_S = 5400
"""Trucks that enter a lane within this time of each other are neighbours [s]."""

TICKS = round(1 / TICK_S)
"""Ticks of a second."""


class LawfulFleet:
    """The timetables of a fleet under driving rules.

    Parameters
    ----------
    model : FleetModel
        The problem, with its law.
    apart : sequence of set of int, (N,)
        Trucks that each must not drive with.
    seed : int
        Of the draws.
    waiting : int, optional
        What a second costs that one stands longer than on its lawful trip alone [grains/s].

    Attributes
    ----------
    schedules : list of Scheduled, (N,)
        What each drives; before anything was planned its lawful trip alone.
    cost : int
        What all pay [grains].
    """

    def __init__(
        self, model: FleetModel, apart: Sequence[set[int]], seed: int, waiting: int = 0
    ) -> None:
        legal = model.legal
        assert legal is not None
        self.model, self.legal, self.apart, self.waiting = model, legal, apart, waiting
        self._ways = LaneWays(legal, model.lanes)
        self._trucks: dict[tuple[int, bytes], Truck] = {}
        self._rng = np.random.default_rng(seed)
        self._free: list[bool] = []
        self.alone = [self._alone(k) for k in range(model.instance.trucks)]
        self.schedules = list(self.alone)
        costs = model.instance
        self.occupied = Occupied(costs.alone, costs.member, costs.extra, costs.largest)
        for k, own in enumerate(self.alone):
            self._put(k, self._kept_apart(k, own))
        self._paused = [own.trip.paused_s if own.trip is not None else 0 for own in self.alone]
        self._order = sorted(range(len(self.alone)), key=lambda k: (-self._paused[k], k))

    @property
    def cost(self) -> int:
        """What all pay [grains]."""
        return self.occupied.cost() + sum(
            self._waits(k, own) for k, own in enumerate(self.schedules)
        )

    def start(self, lanes: Sequence[Ints], departs: Sequence[Ints]) -> None:
        """Make the schedules of the search without law lawful, one truck after the other.

        Parameters
        ----------
        lanes, departs : sequence of ndarray of int64, (N, ...)
            The lanes of each truck in driving order, and when it enters them [ticks].
        """
        wanted = self._in_seconds(lanes, departs)
        for k, own in enumerate(wanted):
            self._take(k)
            self._put(k, own)
        for k in self._order:
            self._answer(k, self._take(k), FAR)

    def improve(self, stop: Callable[[], bool]) -> None:
        """Ask all trucks again until none finds a better trip.

        Parameters
        ----------
        stop : callable
            Whether it has to end.
        """
        for _ in range(ROUNDS):
            better = False
            for k in self._order:
                if stop():
                    return
                own = self._take(k)
                before = self._price(k, own)
                better |= self._answer(k, own, before) < before
            if not better:
                return

    def vary(self, tries: int, stop: Callable[[], bool]) -> None:
        """Take neighbourhoods of trucks out and put them in again, where that costs less.

        Parameters
        ----------
        tries : int
            How many neighbourhoods.
        stop : callable
            Whether it has to end.
        """
        trucks = [k for k, free in enumerate(self._free) if free]
        for _ in range(tries if len(trucks) > 1 else 0):
            if stop():
                return
            chosen = self._neighbours(int(self._rng.choice(trucks)))
            old, before = [], 0
            for k in chosen:
                own = self._take(k)
                before += self._price(k, own)
                old.append(own)
            after = 0
            for at in self._rng.permutation(len(chosen)).tolist():
                after += self._answer(chosen[at], old[at], FAR)
            if after > before:
                for k in chosen:
                    self._take(k)
                for k, own in zip(chosen, old, strict=True):
                    self._put(k, own)

    def _neighbours(self, truck: int) -> list[int]:
        """Return a truck with some that it could meet."""
        own, near = self.schedules[truck], set()
        for lane, moments in own.entries():
            for others, company in self.occupied.by_lane[lane].items():
                if abs(others[0] - moments[0]) <= NEAR_S:
                    near |= company
        near.discard(truck)
        some = [k for k in sorted(near) if self._free[k]]
        count = min(len(some), int(self._rng.integers(1, AROUND)))
        return [truck, *(some[at] for at in self._rng.permutation(len(some))[:count].tolist())]

    def _put(self, k: int, schedule: Scheduled) -> None:
        self.schedules[k] = schedule
        self.occupied.enter(k, schedule)

    def _take(self, k: int) -> Scheduled:
        own = self.schedules[k]
        self.occupied.leave(k, own)
        return own

    def _answer(self, k: int, own: Scheduled, below: int) -> int:
        """Put a truck in with its best trip that costs less than a limit; return what it costs."""
        best = own if below < FAR else None
        if self._free[k]:
            ways = {one.way.lanes.tobytes(): one.way.lanes for one in (own, self.alone[k])}
            for lanes in ways.values():
                found = self._truck(k, lanes).best(
                    self.occupied, below, self.apart[k], waiting=self.waiting,
                    stands_s=self._paused[k],
                )  # fmt: skip
                if found is None:
                    continue
                found = self._kept_apart(k, found)
                if (price := self._price(k, found)) < below:
                    best, below = found, price
        if best is None:
            best = self._kept_apart(k, self.alone[k])
        self._put(k, best)
        if below < FAR:
            return below
        self.occupied.leave(k, best)
        price = self._price(k, best)
        self.occupied.enter(k, best)
        return price

    def _price(self, k: int, schedule: Scheduled) -> int:
        """Return what all pay more once a truck that is taken out drives a timetable."""
        return self.occupied.price(schedule) + self._waits(k, schedule)

    def _waits(self, k: int, schedule: Scheduled) -> int:
        """Return what a truck pays for standing longer than alone."""
        if not self.waiting or schedule.trip is None:
            return 0
        return self.waiting * max(0, schedule.trip.paused_s - self._paused[k])

    def _kept_apart(self, k: int, schedule: Scheduled) -> Scheduled:
        """Return a timetable that is with nobody it must not be with, even by chance."""
        if not self.apart[k]:
            return schedule
        marks = {
            place: -1 - k
            for place, (lane, moments) in enumerate(schedule.entries())
            if self.apart[k] & self.occupied.by_lane.get(lane, {}).get(moments, set())
        }
        return replace(schedule, apart_on=marks) if marks else schedule

    def _truck(self, k: int, lanes: Ints) -> Truck:
        key = k, lanes.tobytes()
        found = self._trucks.get(key)
        if found is None:
            legal = self.legal
            found = self._trucks[key] = Truck(
                k, self._ways.of(k, lanes), legal.rules[k], legal.spans[k], legal.monday_s
            )
        return found

    def _alone(self, k: int) -> Scheduled:
        """Return a truck's lawful trip alone, and note whether it may have company."""
        legal, lanes = self.legal, self.model.routes[k]
        rules, span = legal.rules[k], legal.spans[k]
        found = self._truck(k, lanes).fastest()
        # Two drivers are planned alone, and who can be in time by no more than a few seconds.
        self._free.append(found is not None and rules.limits.change_s == 0)
        if found is not None:
            return found
        for way in (self._ways.of(k, lanes, 0.0), self._ways.kept_whole(k, lanes)):
            found = Truck(k, way, rules, span, legal.monday_s).fastest()
            if found is not None:
                return found
        raise AssertionError("a trip that is lawful alone is lawful with more places to stand")

    def _in_seconds(self, lanes: Sequence[Ints], departs: Sequence[Ints]) -> list[Scheduled]:
        """Return schedules in whole seconds, companies kept, whatever the law says of them."""
        ways = [
            self._truck(k, own).way if self._free[k] else self.alone[k].way
            for k, own in enumerate(lanes)
        ]
        entries = sorted(
            (int(at), int(lane), k, place)
            for k, (own, when) in enumerate(zip(lanes, departs, strict=True))
            if self._free[k]
            for place, (lane, at) in enumerate(zip(own, when, strict=True))
        )
        ready = [span.earliest_s for span in self.legal.spans]
        begun: dict[tuple[int, int], list[tuple[int, int]]] = {}
        for at, lane, k, place in entries:
            begun.setdefault((at, lane), []).append((k, place))
        leaves = [np.zeros(way.road.hops, np.int64) for way in ways]
        for (at, _), company in begun.items():
            start = max(at // TICKS, *(ready[k] for k, _ in company))
            for k, place in company:
                begin, end = (int(one) for one in ways[k].first_hop[place : place + 2])
                before = ways[k].before_s
                leaves[k][begin:end] = start + before[begin:end] - before[begin]
                ready[k] = start + int(before[end] - before[begin])
        return [
            Scheduled(ways[k], leaves[k], None) if self._free[k] else self.alone[k]
            for k in range(len(ways))
        ]
