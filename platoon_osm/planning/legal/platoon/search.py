"""The cheapest stops and departure of a master for its members, best first.

A node of the search (`spans.py`) is a beginning of the master's stops and a span of its
departure. Bounds hold for pauses anywhere on the members' own ways, while every plan that is
returned has been driven with real places.

What is searched: departures in whole seconds; stops at places of the master's way, of the lengths
that the law names and those asked for; as many stops as its driving needs and `extra_stops` more,
and no more daily rests than it needs, one more if there is no plan else. Of equally cheap plans one
with few stops, whole breaks and an early departure is taken (`ties.py`). Then the master may stand
longer at its stops where that makes the members cheaper (`longer_stops.py`).
"""

from __future__ import annotations

import time
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .again import Again, joined_again
from .given_up import leaves, most_gained
from .longer_stops import longer_stops, waiting_bound
from .record import MemberTiming, PlatoonTiming, Real, Timetable, gained
from .spans import SpanSearch
from .star_searches import MOST_RESTS_MORE, StarSearches, departures_of
from .star_times import StarTimes
from .stops import Stops
from .tables import OwnRoads
from .ties import simplest

__all__ = ["PlatoonSearch", "choices_of", "cost_of", "search_platoon"]

Marks = NDArray[np.bool_]


def search_platoon(
    star: StarTimes,
    real: Real | None,
    time_limit_s: float = 10.0,
    *,
    most_spans: int = 10**9,
    roads: OwnRoads | None = None,
    again: Again | None = None,
    in_time: Marks | None = None,
    plain: Marks | None = None,
    extra_stops: int = 1,
    lengths: tuple[int, ...] = (),
    waits: bool = True,
    below: float = np.inf,
) -> PlatoonTiming:
    """Return when a master leaves and where it stops, so that its members pay least in all.

    Parameters
    ----------
    star : StarTimes
        The master and its members.
    real : callable or None
        Says how a vehicle really drives; None if it may pause anywhere on its own ways, and no
        trips are asked for.
    time_limit_s : float
        After which the best found is returned, with its bound [s].
    most_spans : int
        After so many spans of departures likewise, real trips counted by what they take; unlike
        time, that is the same on every machine.
    roads : OwnRoads, optional
        Says what lies on the members' own ways; it saves questions.
    again : Again, optional
        If given, members may join again after they stopped alone, with the timetable that is found.
    in_time : ndarray of bool, (M,), optional
        Which members may go alone: in time and within the law; by default those whose cost alone is
        finite.
    plain : ndarray of bool, (M,), optional
        Which members have no driving bans or closed hours on any of their ways; by default all.
    extra_stops : int
        How many more stops are searched than the master's driving needs.
    lengths : tuple of int
        Lengths of pauses that are tried besides those that the law names [s].
    waits : bool
        Whether the master may stand longer at its stops for its members.
    below : float
        A plan in which all together pay as much is of no interest; one that does may not be found.

    Returns
    -------
    PlatoonTiming
        Proved if nothing searched is better; else with a bound.
    """
    searches = StarSearches(star, real, roads, in_time, plain, extra_stops, lengths)
    return PlatoonSearch(searches, again, waits).go_on(most_spans, below, time_limit_s)


class PlatoonSearch:
    """A search for the best of one master that may be stopped, and go on.

    Parameters
    ----------
    searches : StarSearches
        Of the star.
    again : Again, optional
        As `search_platoon` takes it.
    waits : bool
        Likewise.
    """

    def __init__(
        self, searches: StarSearches, again: Again | None = None, waits: bool = True
    ) -> None:
        self._searches, self._again, self._waits = searches, again, waits
        self._departures = departures_of(searches.star)
        self._needs = searches.needs(self._departures[1])
        self._more = 0
        self._search = searches.search(self._needs)
        self._stopped = False

    def go_on(
        self, most_spans: int = 10**9, below: float = np.inf, time_limit_s: float = np.inf
    ) -> PlatoonTiming:
        """Search on, and return the best that was found so far.

        Parameters
        ----------
        most_spans : int
            After so many more spans it stops, real trips counted by what they take.
        below : float
            As `search_platoon` takes it; no more than before.
        time_limit_s : float
            After so much more time it stops, too [s].

        Returns
        -------
        PlatoonTiming
            Proved if it came to its end.
        """
        began = time.perf_counter()
        found = PlatoonTiming(np.inf, np.inf, np.inf, True, None, None)
        while self._search is not None:
            search, star = self._search, self._searches.star
            search.deadline, search.most_spans = began + time_limit_s, search.work + most_spans
            most = below - star.master_alone + most_gained(search)
            if most < search.best:
                search.best, search.found = most, None
            ended = search.go_on() if self._stopped else search.run(*self._departures)
            self._stopped = not ended
            found = _result(search, ended, began, self._again, self._waits)
            if found.timetable is not None or not ended or self._more == MOST_RESTS_MORE:
                break
            if below < np.inf and leaves(self._searches, self._needs, self._more):
                break  # it can drive, only not so cheaply
            self._more += 1
            self._search = self._searches.search(self._needs, self._more)
        return found


def _result(
    search: SpanSearch, ended: bool, began: float, again: Again | None, waits: bool
) -> PlatoonTiming:
    star, some = search.star, search.numbers
    alone = float(star.alone.sum()) + star.master_alone
    bound, span = search.bound, departures_of(star)
    waiting = min(waiting_bound(search, *span), bound) if waits else bound
    chosen, longer = None, None
    if search.found is not None:
        stops, departure = search.found
        priced = search.choices(stops, departure, with_trips=False)
        if priced is not None:
            pays = sum(one[0] for one in priced)
            if ended:
                stops, departure = simplest(search, stops, departure, pays, *span)
            if waiting < pays - search.tolerance:
                longer = longer_stops(search, stops, departure, pays, *span)
            stops, departure = longer or (stops, departure)
            chosen = choices_of(search, stops, departure)
    counts = (search.values.computed, len(search.trips.asked), search.spans, search.work)
    if search.found is None or chosen is None:
        gains = most_gained(search)
        return PlatoonTiming(
            np.inf, bound + star.master_alone - gains, waiting + star.master_alone - gains,
            ended, None, None, (), alone, True, False, *counts, time.perf_counter() - began,
        )  # fmt: skip
    pays = _paid(search, chosen)
    table, complete = Timetable.of(star, departure, stops), True
    if again is not None:
        chosen, complete = joined_again(some, table, chosen, again)
    cost = cost_of(star, chosen)
    trip = search.trips.trip(some.master, 0, len(some.pos) - 1, stops, departure, 0)
    return PlatoonTiming(
        cost, cost - (0.0 if ended else max(0.0, pays - bound)), cost - max(0.0, pays - waiting),
        ended, table, trip, tuple(chosen), alone, complete, longer is not None, *counts,
        time.perf_counter() - began,
    )  # fmt: skip


def _paid(search: SpanSearch, chosen: Sequence[MemberTiming]) -> float:
    return sum(one.cost if one.possible else search.numbers.penalty for one in chosen)


def choices_of(search: SpanSearch, stops: Stops, departure: int) -> list[MemberTiming] | None:
    """Return what members do at a departure.

    Parameters
    ----------
    search : SpanSearch
        Of the star.
    stops : tuple of (int, int)
        The master's.
    departure : int
        When it leaves [s].

    Returns
    -------
    list of MemberTiming, (M,), or None
        None if the master cannot leave then.
    """
    chosen = search.choices(stops, departure)
    if chosen is None:
        return None
    shift, penalty = search.numbers.first_node, search.numbers.penalty
    found = []
    for alone, (cost, i, j, trip) in zip(search.star.alone.tolist(), chosen, strict=True):
        if i >= 0:
            found.append(MemberTiming(cost, i - shift, j - shift, trip))
        else:
            able = cost < penalty
            found.append(MemberTiming(alone if able else np.inf, possible=able))
    return found


def cost_of(star: StarTimes, members: Sequence[MemberTiming]) -> float:
    """Return what all pay together.

    Parameters
    ----------
    star : StarTimes
        The master and its members.
    members : sequence of MemberTiming, (M,)
        How each member drives.

    Returns
    -------
    float
        Of master and members; what the master gains from company counts once.
    """
    gain = gained(star.gain, (one.stretches for one in members))
    return sum(one.cost for one in members) + star.master_alone - gain
