"""The best trip on one road by labels: first a narrow search, then all that may be better.

The earliest arrival is found first, then the latest departure that has it. Where Mondays or bans
are waited for, or days are many, only the most promising labels of each point are kept.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from ....driving.limits import Limits
from ....driving.state import DriverState
from .kernel import label_search
from .label import GONE, GONE_MOST, TIME, WEEK_S, WEEKLY_END
from .least_left import least_left
from .looked import LOOKED, SEARCH_LABELS
from .numbers import CHANGE, FORTNIGHT, MOST_WEEK, WEEKLY_DUE, kinds_of, numbers_of
from .road import FREE, NO_LIMIT, IntArray, LegalTrip, Road, without_bans
from .start import Start, starts_of
from .timed import chosen, timed
from .waiting import windows_of
from .weeks import keeps_weeks

__all__ = ["MANY_TO_SHARE", "Aim", "TripSearch"]

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


Found = tuple[IntArray, IntArray, IntArray]
"""The labels of a search, how each came about, and where those of each point begin."""


class TripSearch:
    """The search on one road under one law, as it is counted.

    Parameters
    ----------
    road : Road
        The way.
    limits : Limits
        The law.
    state : DriverState
        What the driver has behind it.
    monday_s : int
        A Monday 0:00 UTC [s].
    dominance : bool
        False keeps every label.
    pooled : bool
        Whether the driving of two in a day and in a week is counted together.
    windows : pair of int64 array, optional
        Of `waiting.windows_of` on the road, where they are known.
    """

    def __init__(
        self, road: Road, limits: Limits, state: DriverState, monday_s: int, dominance: bool,
        pooled: bool = False, windows: tuple[IntArray, IntArray] | None = None,
    ) -> None:  # fmt: skip
        self.road, self.state, self.monday, self.dominance = road, state, monday_s, dominance
        self.limits = limits
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

    def on(self, road: Road, pooled: bool = False) -> TripSearch:
        """Return the search under the same law on another road.

        Parameters
        ----------
        road : Road
            The way; or the same one.
        pooled : bool
            Whether the driving of two in a day and in a week is counted together.

        Returns
        -------
        TripSearch
            Otherwise as this.
        """
        same = self.windows if road is self.road else None
        return TripSearch(road, self.limits, self.state, self.monday, self.dominance, pooled, same)

    def _keeps_weeks(self, trip: LegalTrip, state_at_s: int | None) -> bool:
        return keeps_weeks(trip, self.road, self.state, state_at_s, self.numbers, self.monday)

    def best(
        self, state_at_s: int | None, earliest_s: int, latest_s: int, arrival_s: int | None,
        aim: Aim,
    ) -> LegalTrip | None:  # fmt: skip
        """Return the best trip that leaves within a span of time.

        Where the driving of a week could be too much it is first not looked at: the best of more
        trips is the best if it keeps those limits too.

        Parameters
        ----------
        state_at_s : int or None
            When the driver's state holds [s]; None if whenever it leaves.
        earliest_s, latest_s : int
            When it may leave [s].
        arrival_s : int or None
            The latest arrival [s].
        aim : {"arrive", "leave"}
            What is best.

        Returns
        -------
        LegalTrip or None
            None if there is none.
        """
        asked = (state_at_s, earliest_s, latest_s, arrival_s, aim)
        if self.weeks:
            self.weeks = 0
            found = self._best(*asked)
            self.weeks = 1
            if found is None or self._keeps_weeks(found, state_at_s):
                return found
            return self._best(*asked, found.arrival_s)
        return self._best(*asked)

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
            free = self.on(without_bans(self.road), self.pooled)
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
        LOOKED.labels += SEARCH_LABELS + int(found[2][-1])
        return found


def _first_arrival(found: Found) -> int | None:
    """Return the earliest arrival of the labels that a search found."""
    labels, _, first = found
    low, high = int(first[-2]), int(first[-1])
    return int(labels[low:high, TIME].min()) if low < high else None
