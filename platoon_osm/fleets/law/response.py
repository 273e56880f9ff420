"""The lawful trip of one truck on its way that costs the fleet least, given all others."""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...planning.legal.driver.label import TIME, WEEKLY_END
from ...planning.legal.driver.numbers import WEEKLY_DUE
from ...planning.legal.driver.one_driver import fastest
from ...planning.legal.driver.road import FREE, NO_LIMIT, LegalTrip, Road
from ...planning.legal.driver.start import Start, starts_of
from ...planning.legal.driver.timed import chosen, timed
from ...planning.legal.driver.trip_question import TripQuestion
from ...planning.legal.driver.trip_search import TripSearch
from ...planning.legal.platoon.star_times import Span, VehicleRules
from .compiled import HOP_S, JOINING
from .driven import Occupied, Scheduled, left_at
from .search_joining import PRICED, WITH
from .ways import LaneWay

__all__ = ["WIDTH", "Truck"]

Ints = NDArray[np.int64]

WIDTH = 300
"""How many labels of each point are kept."""

FAR = 1 << 60


@dataclass(frozen=True, slots=True, eq=False)
class _Offers:
    """Companies that may be joined, lane by lane; arrays as in `search_joining`."""

    first: Ints
    cost: Ints
    first_moment: Ints
    moments: Ints
    to_go: Ints


class Truck:
    """One truck on its way, under its law.

    Parameters
    ----------
    number : int
        Position in the plan.
    way : LaneWay
        Its way.
    rules : VehicleRules
        Its law.
    span : Span
        When it may drive.
    monday_s : int
        A Monday 0:00 UTC [s].
    """

    def __init__(
        self, number: int, way: LaneWay, rules: VehicleRules, span: Span, monday_s: int
    ) -> None:
        self.number, self.way, self.rules, self.span = number, way, rules, span
        self._search = TripSearch(
            way.road, rules.limits, rules.state, monday_s, True, windows=way.windows
        )
        self._starts: dict[int, Start] = {}

    def fastest(self) -> Scheduled | None:
        """Return its fastest lawful trip alone; None if there is none in time."""
        span, search = self.span, self._search
        asked = TripQuestion(
            self.way.road, self.rules.limits, self.rules.state, self.rules.state_at_s,
            span.earliest_s, span.latest_s, span.arrival_s, search.monday,
        )  # fmt: skip
        trip = fastest(asked)
        if trip is None:
            return None
        free = np.full(self.way.road.hops, FREE)
        return Scheduled(self.way, left_at(self.way, trip, free), trip)

    def best(
        self,
        occupied: Occupied,
        below: int = FAR,
        apart: Container[int] = (),
        *,
        waiting: int = 0,
        stands_s: int = 0,
        width: int = WIDTH,
        dominance: bool = True,
    ) -> Scheduled | None:
        """Return its lawful trip that costs least beside the others.

        Parameters
        ----------
        occupied : Occupied
            What the others drive; the truck itself is not in it.
        below : int
            Only a trip that costs less is of use [grains].
        apart : container of int
            Trucks that it must not drive with.
        waiting : int
            What each second costs that it stands longer than `stands_s` [grains/s].
        stands_s : int
            How long it stands for nothing [s].
        width : int
            How many labels of each point are kept; 0 for all.
        dominance : bool
            False keeps every label, which is slow and gives the same.

        Returns
        -------
        Scheduled or None
            None if there is no such trip.
        """
        way, search, span = self.way, self._search, self.span
        road = way.road
        offers = self._offers(occupied, apart)
        alone = np.array([occupied.alone[lane] for lane in way.lanes.tolist()], np.int64)
        begins, infos, with_whom = self._begins(offers)
        if not len(begins):
            return None
        fixed = max(self._starts[FREE].fixed_weekly_end_s, -NO_LIMIT)
        weekly = search.numbers[WEEKLY_DUE] < NO_LIMIT and (
            span.arrival_s - int(begins[:, WEEKLY_END].min()) > search.numbers[WEEKLY_DUE]
        )
        first_windows, windows = way.windows
        kernel = JOINING.ready(road.hops * HOP_S)
        labels, info, paid, first = kernel(
            road.drive_s, road.clock_s, road.stay_s, way.lane_of, way.first_hop, first_windows,
            windows, search.numbers, search.kinds, begins, infos, with_whom, offers.first,
            offers.cost, offers.first_moment, offers.moments, alone, offers.to_go, below, waiting,
            stands_s, search.monday, fixed, span.arrival_s, search.weeks, int(weekly), width,
            dominance,
        )  # fmt: skip
        low, high = int(first[-2]), int(first[-1])
        for label in np.lexsort((labels[low:high, TIME], paid[low:high, PRICED])):
            found = self._driven(labels, info, paid, low + int(label), offers)
            if found is not None:
                return found
        return None

    def _offers(self, occupied: Occupied, apart: Container[int]) -> _Offers:
        """Return the companies that it may join in time and that save something."""
        way, span = self.way, self.span
        first, first_moment = [0], [0]
        cost: list[int] = []
        moments: list[int] = []
        least: list[int] = []
        before, drive_s = way.before_s.tolist(), way.road.drive_s.tolist()
        hops = way.first_hop.tolist()
        whole = before[-1]
        for place, lane in enumerate(way.lanes.tolist()):
            begin, end = hops[place], hops[place + 1]
            cheapest = occupied.alone[lane]
            opens = span.earliest_s + before[begin]
            closes = span.arrival_s - whole + before[end - 1]
            departs = span.latest_s if place == 0 else FAR
            for leaves, company in sorted(occupied.by_lane.get(lane, {}).items()):
                if (
                    not opens <= leaves[0] <= departs
                    or leaves[-1] > closes
                    or len(leaves) != end - begin
                ):
                    continue
                more = occupied.more_for(lane, len(company))
                if more >= occupied.alone[lane] or any(one in apart for one in company):
                    continue
                if any(
                    after < leaves[k] + drive_s[begin + k] for k, after in enumerate(leaves[1:])
                ):
                    continue
                cost.append(more)
                moments += leaves
                first_moment.append(len(moments))
                cheapest = min(cheapest, more)
            first.append(len(cost))
            least.append(cheapest)
        to_go = np.concatenate([np.cumsum(least[::-1])[::-1], [0]]).astype(np.int64)
        return _Offers(
            np.array(first, np.int64), np.array(cost, np.int64), np.array(first_moment, np.int64),
            np.array(moments, np.int64), to_go,
        )  # fmt: skip

    def _begins(self, offers: _Offers) -> tuple[Ints, Ints, Ints]:
        """Return the labels that leave the origin, alone and with each company there."""
        starts, whose = [self._start(FREE)], [-1]
        for offer in range(int(offers.first[1])):
            starts.append(self._start(int(offers.moments[offers.first_moment[offer]])))
            whose.append(offer)
        return (
            np.concatenate([one.labels for one in starts]),
            np.concatenate([one.info for one in starts]),
            np.repeat(whose, [len(one.labels) for one in starts]).astype(np.int64),
        )

    def _start(self, moment: int) -> Start:
        """Return how it may begin, at a moment or at any."""
        found = self._starts.get(moment)
        if found is None:
            search, span, road = self._search, self.span, self.way.road
            last = min(span.latest_s, span.arrival_s - int(road.drive_s.sum()))
            first, windows = self.way.windows
            begin, end = (span.earliest_s, last) if moment == FREE else (moment, moment)
            found = self._starts[moment] = starts_of(
                self.rules.state, self.rules.state_at_s, begin, end,
                windows[first[0] : first[1]], search.numbers, search.kinds, search.monday,
                search.weeks,
            )  # fmt: skip
        return found

    def _driven(
        self, labels: Ints, info: Ints, paid: Ints, label: int, offers: _Offers
    ) -> Scheduled | None:
        """Return the timetable that led to a label."""
        way, search = self.way, self._search
        road = way.road
        with_whom, at = np.full(road.hops, -1), label
        for hop in range(road.hops - 1, -1, -1):
            with_whom[hop] = paid[at, WITH]
            at = int(info[at, 0])
        appointed = _appointed(way, with_whom.tolist(), offers)
        named = _with_appointments(road, appointed)
        arrival = int(labels[label, TIME])
        choice = chosen(labels, info, label, road.hops, arrival)
        trip: LegalTrip | None = timed(named, choice, search.numbers, arrival, True)
        if trip is None:
            return None
        return Scheduled(way, left_at(way, trip, appointed), trip)


def _appointed(way: LaneWay, with_whom: Sequence[int], offers: _Offers) -> Ints:
    """Return when points have to be left to drive with some companies."""
    found = np.full(way.road.hops, FREE)
    for hop, offer in enumerate(with_whom):
        if offer >= 0:
            within = hop - int(way.first_hop[way.lane_of[hop]])
            found[hop] = offers.moments[offers.first_moment[offer] + within]
    return found


def _with_appointments(road: Road, appointed: Ints) -> Road:
    return replace(road, leave_s=np.append(appointed, FREE))
