"""The fastest legal trip on a given way, for one driver or two in one vehicle.

Earliest arrival, and among the trips that have it the latest departure; or the latest departure
that is in time. Found by labels (`label_search`), after Goel, "The minimum duration truck driver
scheduling problem" (EURO Journal on Transportation and Logistics, 2012).

It is the best among all trips in whole seconds that keep the limits and pause at the road's points,
on these conditions: no place with a limited stay is where a ban or an appointment has to be waited
for; where driving in a week can be too much, or a long day could lie on either side of Monday, what
would be driven before Monday is not moved beyond it by leaving later, but by waiting there; and
what docs/law.md says of two drivers. Without those it is legal all the same, and may be later than
the best.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from ....driving.limits import Limits
from ....driving.state import DriverState
from ....errors import ScenarioError
from .kernel import label_search
from .label import GONE, GONE_MOST, TIME, WEEK_S, WEEKLY_END
from .least_left import least_left
from .numbers import CALENDAR, CHANGE, FORTNIGHT, MOST_WEEK, WEEKLY_DUE, kinds_of, numbers_of
from .road import FREE, NO_LIMIT, IntArray, LegalTrip, Road
from .start import Start, starts_of
from .timed import chosen, timed
from .waiting import windows_of

__all__ = ["Aim", "farthest", "fastest", "least_late"]

Aim = Literal["arrive", "leave"]

MOST_WIDTH = 1500
"""How many labels of each point are kept at most, the most promising, lest a search runs for
minutes."""

WEEK_WIDTH = 1000
"""How many labels of each point are kept where the driving of a week is too much."""

FEWER = 300
"""How many once the arrival is known, and of trips that wait for more than a Monday."""

MANY_TO_SHARE = 8
"""Hops beyond which, where two drivers cannot share the driving of a trip that is the best for both
together, only some labels are kept."""

SHARED_WIDTH = 300
"""How many of each point those are."""

WIDTH = 12
"""Labels of each point that are kept in the first, narrow search."""

OPENINGS = 2
"""Windows that it tries for each pause."""

FIRST_LOOK_S = 900
"""How long after the least that is known of it an arrival is looked for at first [s]."""

LOOK_BACK = 3
"""How many times its driving time before the arrival a trip's departure is first looked for."""

FARTHEST_S = 60 * 86_400
"""No departure lies farther before the arrival [s]."""


def fastest(
    road: Road,
    limits: Limits,
    state: DriverState,
    state_at_s: int | None,
    earliest_s: int | None,
    latest_s: int | None = None,
    arrival_s: int | None = None,
    monday_s: int = 0,
    aim: Aim = "arrive",
    *,
    dominance: bool = True,
) -> LegalTrip | None:
    """Return the fastest legal trip.

    Parameters
    ----------
    road : Road
        The way.
    limits : Limits
        The law; those of two drivers if `state.drivers` is 2.
    state : DriverState
        What the driver has behind it.
    state_at_s : int or None
        When that holds [s]: from then until it leaves, the driver is at rest at the origin. None
        if it holds whenever it leaves.
    earliest_s : int or None
        The earliest departure [s]; None if there is none, and an arrival is named.
    latest_s : int, optional
        The latest departure [s].
    arrival_s : int, optional
        The latest arrival [s].
    monday_s : int, optional
        A Monday 0:00 UTC [s].
    aim : {"arrive", "leave"}, optional
        Whether to arrive as early as possible and, among such trips, to leave as late as possible;
        or to leave as late as possible and, among such trips, to arrive as early as possible.
    dominance : bool, optional
        False keeps every label, which is slow and gives the same.

    Returns
    -------
    LegalTrip or None
        None if no trip keeps the law and these times.

    Raises
    ------
    ScenarioError
        Neither an earliest departure nor, for "leave", a latest arrival.
    """
    if earliest_s is None and state_at_s is not None:
        earliest_s = state_at_s
    if arrival_s is None and (aim == "leave" or earliest_s is None):
        raise ScenarioError(
            "legal trip: no time is given; give an earliest departure or an arrival"
        )
    one = _Search(road, limits, state, monday_s, dominance)
    last = NO_LIMIT if latest_s is None else latest_s
    if earliest_s is not None:
        return one.best(state_at_s, earliest_s, last, arrival_s, aim)
    assert arrival_s is not None
    # Later departures are better: the first span that holds a trip holds the best.
    back = LOOK_BACK * int(road.drive_s.sum()) + 3600
    while True:
        begin = arrival_s - min(back, FARTHEST_S)
        found = one.best(state_at_s, begin, last, arrival_s, aim)
        if found is not None or back >= FARTHEST_S:
            return found
        back *= 2


def least_late(
    road: Road,
    limits: Limits,
    state: DriverState,
    state_at_s: int | None,
    earliest_s: int,
    latest_s: int | None = None,
    monday_s: int = 0,
) -> int | None:
    """Return the earliest arrival within the law, whatever the latest allowed.

    Parameters
    ----------
    road : Road
        The way.
    limits : Limits
        The law.
    state : DriverState
        What the driver has behind it.
    state_at_s : int or None
        When that holds [s].
    earliest_s : int
        The earliest departure [s].
    latest_s : int, optional
        The latest departure [s].
    monday_s : int, optional
        A Monday 0:00 UTC [s].

    Returns
    -------
    int or None
        Seconds; None if the law forbids the way altogether.
    """
    one = _Search(road, limits, state, monday_s, dominance=True)
    return one.arrival(state_at_s, earliest_s, NO_LIMIT if latest_s is None else latest_s)


def farthest(
    road: Road,
    limits: Limits,
    state: DriverState,
    state_at_s: int | None,
    earliest_s: int,
    latest_s: int | None = None,
    monday_s: int = 0,
) -> int:
    """Return how far a vehicle comes within the law.

    Parameters
    ----------
    road : Road
        The way.
    limits : Limits
        The law.
    state : DriverState
        What the driver has behind it.
    state_at_s : int or None
        When that holds [s].
    earliest_s : int
        The earliest departure [s].
    latest_s : int, optional
        The latest departure [s].
    monday_s : int, optional
        A Monday 0:00 UTC [s].

    Returns
    -------
    int
        The last point that it can reach.
    """
    one = _Search(road, limits, state, monday_s, dominance=True)
    return one.reached(state_at_s, earliest_s, NO_LIMIT if latest_s is None else latest_s)


Found = tuple[IntArray, IntArray, IntArray]
"""The labels of a search, how each came about, and where those of each point begin."""


class _Search:
    """The search on one road under one law."""

    def __init__(
        self, road: Road, limits: Limits, state: DriverState, monday_s: int, dominance: bool,
        pooled: bool = False, windows: tuple[IntArray, IntArray] | None = None,
    ) -> None:  # fmt: skip
        self.road, self.state, self.monday, self.dominance = road, state, monday_s, dominance
        self.asked = limits, state, monday_s, dominance
        self.pooled = pooled
        self.numbers = numbers_of(limits, pooled)
        self.kinds = kinds_of(self.numbers)
        self.windows = windows_of(road) if windows is None else windows
        self.kernel = label_search(road.hops)
        total = int(road.clock_s.sum())
        both = 2 if pooled else 1
        this, last = both * state.driven_this_week_s, both * state.driven_last_week_s
        fits = this + total <= self.numbers[MOST_WEEK]
        fits &= this + last + total <= self.numbers[FORTNIGHT]
        self.weeks = int(not fits)

    def best(
        self, state_at_s: int | None, earliest_s: int, latest_s: int, arrival_s: int | None,
        aim: Aim,
    ) -> LegalTrip | None:  # fmt: skip
        """Return the best trip that leaves within a span of time."""
        asked = (state_at_s, earliest_s, latest_s, arrival_s, aim)
        if self.numbers[CHANGE] < NO_LIMIT and self.dominance and not self.pooled:
            return self._of_two(*asked)
        return self._of_one(*asked)

    def _of_two(
        self, state_at_s: int | None, earliest_s: int, latest_s: int, arrival_s: int | None,
        aim: Aim,
    ) -> LegalTrip | None:  # fmt: skip
        """Return the best trip of two drivers.

        Whoever drives counts for the day and the week of both at first. If two drivers who pause
        nowhere else can share the driving of that trip, it is the best: no other is, for more was
        allowed. Only if not, who drives what is part of the search.
        """
        asked = (state_at_s, earliest_s, latest_s)
        both = _Search(self.road, *self.asked, pooled=True, windows=self.windows)
        bound = both._of_one(*asked, arrival_s, aim)
        if bound is None:
            return None
        same = _Search(_stopping(self.road, bound), *self.asked)
        found = same._of_one(*asked, arrival_s, aim)
        if found is None:
            return self._of_one(*asked, arrival_s, aim)
        if (found.departure_s, found.arrival_s) == (bound.departure_s, bound.arrival_s):
            return found
        if aim == "arrive":
            arrival_s = found.arrival_s
        else:
            asked = (state_at_s, max(earliest_s, found.departure_s), latest_s)
        return self._of_one(*asked, arrival_s, aim) or found

    def _of_one(
        self, state_at_s: int | None, earliest_s: int, latest_s: int, arrival_s: int | None,
        aim: Aim,
    ) -> LegalTrip | None:  # fmt: skip
        """Return the best trip, of all that the limits allow as they are counted.

        Where the driving of a week could be too much it is first not looked at: the best of more
        trips is the best if it keeps those limits too.
        """
        asked = (state_at_s, earliest_s, latest_s, arrival_s, aim)
        if self.weeks:
            self.weeks = 0
            found = self._best(*asked)
            self.weeks = 1
            if found is None or self._fits(found, state_at_s):
                return found
            return self._best(*asked, found.arrival_s)
        return self._best(*asked)

    def _fits(self, trip: LegalTrip, state_at_s: int | None) -> bool:
        """Return whether a trip keeps the limits of driving in a week."""
        if not self.numbers[CALENDAR]:
            return False
        drives = (0,) * self.road.hops if self.pooled or not trip.drives else trip.drives
        return all(
            self._fits_one(trip, state_at_s, [own == driver for own in drives])
            for driver in set(drives)
        )

    def _fits_one(self, trip: LegalTrip, state_at_s: int | None, drives: list[bool]) -> bool:
        """Return whether the hops that one driver drives keep its limits of a week."""
        since = trip.departure_s if state_at_s is None else state_at_s
        week = (since - self.monday) // WEEK_S
        state = self.state
        both = 2 if self.pooled else 1
        driven = {
            week - 1: both * state.driven_last_week_s, week: both * state.driven_this_week_s
        }  # fmt: skip
        stands = {one.point: one.end_s - one.start_s for one in trip.pauses}
        at = trip.departure_s
        for hop in range(self.road.hops):
            at += stands.get(hop, 0)
            seconds = int(self.road.drive_s[hop])
            clock = int(self.road.clock_s[hop]) if drives[hop] else 0
            week = (at - self.monday) // WEEK_S
            left = self.monday + (week + 1) * WEEK_S - at
            after = 0 if seconds <= left else clock - clock * left // seconds
            before = clock if seconds <= left else -(-clock * left // seconds)
            for one, own in ((week, before), (week + 1, after)):
                driven[one] = driven.get(one, 0) + own
                two = driven[one] + driven.get(one - 1, 0)
                if own and (driven[one] > self.numbers[MOST_WEEK] or two > self.numbers[FORTNIGHT]):
                    return False
            at += seconds
        return True

    def _best(
        self, state_at_s: int | None, earliest_s: int, latest_s: int, arrival_s: int | None,
        aim: Aim, at_least_s: int = 0,
    ) -> LegalTrip | None:  # fmt: skip
        """Return the best trip that leaves within a span of time; none arrives before a moment."""
        known = None
        if aim == "arrive":
            first, labels = self._arrival(state_at_s, earliest_s, latest_s, arrival_s, at_least_s)
            if first is None:
                return None
            arrival_s = first
            if labels is not None:
                known = self._latest_trip(labels, arrival_s, aim)
        assert arrival_s is not None
        if self.road.hops == 0:
            leaves = min(latest_s, arrival_s)
            return LegalTrip(leaves, leaves) if leaves >= earliest_s else None
        start = self._start(state_at_s, earliest_s, latest_s)
        least = -NO_LIMIT if known is None else known.departure_s
        narrow = self._run(start, arrival_s, late=True, width=WIDTH, leaves_s=least)
        known = self._latest_trip(narrow, arrival_s, aim) or known
        if self._is_whole(narrow):
            return known
        least = -NO_LIMIT if known is None else known.departure_s
        every = self._widest(start, arrival_s, late=True, leaves_s=least)
        return self._latest_trip(every, arrival_s, aim) or known

    def _is_whole(self, found: Found) -> bool:
        """Return whether a narrow search has left nothing out."""
        return len(self.windows[1]) == 0 and int(np.diff(found[2][1:]).max()) < WIDTH

    def _latest_trip(self, found: Found, arrival_s: int, aim: Aim) -> LegalTrip | None:
        """Return the trip of those found that leaves last."""
        labels, info, first = found
        low, high = int(first[-2]), int(first[-1])
        ends = labels[low:high]
        spare = arrival_s - ends[:, TIME]
        leaves = np.minimum(ends[:, GONE_MOST], ends[:, TIME] - ends[:, GONE] + spare)
        order = np.lexsort((ends[:, GONE], -leaves))
        for label in order[spare[order] >= 0]:
            choice = chosen(labels, info, low + int(label), self.road.hops, arrival_s)
            trip = timed(self.road, choice, self.numbers, arrival_s, aim == "leave")
            if trip is not None:
                return trip
        return None

    def arrival(self, state_at_s: int | None, earliest_s: int, latest_s: int) -> int | None:
        """Return the earliest arrival of those who leave within a span of time."""
        found = self.best(state_at_s, earliest_s, latest_s, None, "arrive")
        return None if found is None else found.arrival_s

    def _arrival(
        self, state_at_s: int | None, earliest_s: int, latest_s: int, arrival_s: int | None,
        at_least_s: int,
    ) -> tuple[int | None, Found | None]:  # fmt: skip
        """Return the earliest arrival, and the labels of which one has it."""
        bound = NO_LIMIT if arrival_s is None else arrival_s
        if self.road.hops == 0:
            return (earliest_s if earliest_s <= min(latest_s, bound) else None), None
        latest_s = min(latest_s, bound - int(self.road.drive_s.sum()))
        start = self._start(state_at_s, earliest_s, latest_s)
        narrow = self._run(start, bound, late=False, width=WIDTH)
        found = _first_arrival(narrow)
        if self._is_whole(narrow):
            return found, narrow
        if found is not None:
            bound = found
        # Where Monday or the end of a ban is waited for, most of what is in time is not among the
        # first: look for those alone, and for a little more each time.
        least, more = max(at_least_s, self._least_arrival(start)), WEEK_S
        if self.weeks:
            more = FIRST_LOOK_S
        elif found is None and len(self.windows[1]):
            free = _Search(_open(self.road), *self.asked, pooled=self.pooled)
            free.weeks = 0
            begin, _ = free._arrival(state_at_s, earliest_s, latest_s, arrival_s, least)
            if begin is None:
                return None, narrow
            least, more = max(least, begin), FIRST_LOOK_S
        while True:
            until = least + more if more < WEEK_S else bound
            few = more >= WEEK_S and bound > least + WEEK_S
            every = self._widest(start, min(bound, until), late=False, few=few)
            first = _first_arrival(every)
            if first is not None:
                return first, every
            if until >= bound:
                return found, narrow
            more *= 8

    def _least_arrival(self, start: Start) -> int:
        """Return a moment before which nobody arrives."""
        left = int(self.road.drive_s.sum()), int(self.road.clock_s.sum())
        return min(
            (
                int(one[TIME]) + least_left(one, *left, self.numbers, self.monday, self.weeks)
                for one in start.labels
            ),
            default=0,
        )

    def _widest(
        self, start: Start, arrival_s: int, late: bool, leaves_s: int = -NO_LIMIT,
        few: bool = False,
    ) -> Found:  # fmt: skip
        """Run with all labels, or as many as a long road lets one keep."""
        widths: tuple[int, ...] = (MOST_WIDTH if self.dominance else 0,)
        if self.weeks and self.dominance:
            widths = (FEWER if late or few else WEEK_WIDTH,)
        elif self.numbers[CHANGE] < NO_LIMIT and not self.pooled and self.road.hops > MANY_TO_SHARE:
            widths = (SHARED_WIDTH,)
        for width in widths:
            found = self._run(start, arrival_s, late, width, leaves_s)
            if found[2][-2] < found[2][-1]:
                break
        return found

    def reached(self, state_at_s: int | None, earliest_s: int, latest_s: int) -> int:
        """Return the last point that can be reached, whatever becomes of it then."""
        low, high = 0, self.road.hops
        while low < high:
            middle = (low + high + 1) // 2
            part = _Search(_until(self.road, middle), *self.asked)
            if part.arrival(state_at_s, earliest_s, latest_s) is None:
                high = middle - 1
            else:
                low = middle
        return low

    def _start(self, state_at_s: int | None, earliest_s: int, latest_s: int) -> Start:
        first, windows = self.windows
        if self.road.leave_s[0] != FREE:
            earliest_s = max(earliest_s, int(self.road.leave_s[0]))
            latest_s = min(latest_s, int(self.road.leave_s[0]))
        return starts_of(
            self.state, state_at_s, earliest_s, latest_s, windows[first[0] : first[1]],
            self.numbers, self.kinds, self.monday, self.weeks,
        )  # fmt: skip

    def _run(
        self, start: Start, arrival_s: int, late: bool, width: int, leaves_s: int = -NO_LIMIT
    ) -> Found:
        road = self.road
        first, windows = self.windows
        weekly = self.numbers[WEEKLY_DUE] < NO_LIMIT and (
            len(start.labels) == 0
            or arrival_s - int(start.labels[:, WEEKLY_END].min()) > self.numbers[WEEKLY_DUE]
        )
        found: Found = self.kernel(
            road.drive_s, road.clock_s, road.stay_s, road.leave_s, first, windows, self.numbers,
            self.kinds, start.labels, start.info, self.monday, start.fixed_weekly_end_s, arrival_s,
            leaves_s, late, self.weeks, int(weekly), width, OPENINGS if width == WIDTH else 0,
            self.dominance,
        )  # fmt: skip
        return found


def _first_arrival(found: Found) -> int | None:
    """Return the earliest arrival of the labels that a search found."""
    labels, _, first = found
    low, high = int(first[-2]), int(first[-1])
    return int(labels[low:high, TIME].min()) if low < high else None


def _open(road: Road) -> Road:
    """Return a road without bans."""
    return Road(
        road.drive_s, road.clock_s, road.stay_s, road.leave_s, np.zeros_like(road.forbidden_first),
        np.zeros((0, 2), dtype=np.int64),
    )  # fmt: skip


def _stopping(road: Road, trip: LegalTrip) -> Road:
    """Return a road with places only where a trip pauses."""
    stay = np.zeros_like(road.stay_s)
    points = [pause.point for pause in trip.pauses]
    stay[points] = road.stay_s[points]
    return Road(
        road.drive_s, road.clock_s, stay, road.leave_s, road.forbidden_first, road.forbidden_s
    )


def _until(road: Road, point: int) -> Road:
    """Return the part of a road up to a point."""
    last = int(road.forbidden_first[point])
    return Road(
        road.drive_s[:point], road.clock_s[:point], road.stay_s[: point + 1],
        road.leave_s[: point + 1], road.forbidden_first[: point + 1], road.forbidden_s[:last],
    )  # fmt: skip
