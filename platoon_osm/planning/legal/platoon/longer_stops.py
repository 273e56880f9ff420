"""A master that stands longer at its stops than it must, lest members miss it.

The search lets a master stand for the lengths that its law names. Here breaks may be longer by some
waits, too, and all stops are searched again for something cheaper than the best that is known, up
to a number of spans. From the best, each stop is lengthened by finer waits; with these stops all
departures are searched, and what is cheaper is lengthened again. Then each wait is made as short as
it may be. So a plan is never dearer for it; how much cheaper yet it could be is bounded by what
members pay whatever the stops that are not decided last.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .clocks import BREAK, FAR, REST
from .spans import SpanSearch
from .stops import MasterStops, Stops
from .ties import first_departure

__all__ = ["WAITS_S", "longer_stops", "waiting_bound"]

WAITS_S = tuple(60 * minutes for minutes in (5, 10, 15, 20, 30, 45, 60, 90, 120, 180))
"""By how much stops are lengthened."""

LONGER_BREAKS_S = tuple(60 * minutes for minutes in (15, 30, 60, 120))
"""By how much breaks may be longer while all stops are searched."""

MOST_ROUNDS = 4
"""How often the best is lengthened again."""

MOST_SPANS = 200
"""Spans of departures that are looked at with all stops, and for each of these rounds."""

MEMBER_SPANS = 2_000
"""But no more than so many, counted for each member."""

MOST_MEMBERS = 200
"""With more members nothing is looked for: one round would take as long as the search itself."""


def waiting_bound(search: SpanSearch, begin: int, end: int) -> float:
    """Return what members pay at least if the master may stand for any time at its stops.

    Parameters
    ----------
    search : SpanSearch
        Of a star.
    begin, end : int
        The first and last departure of the master [s].

    Returns
    -------
    float
        Of all members together; -inf where the master cannot leave.
    """
    clocks = search.stops.states((), end)
    if clocks is None or begin > end:
        return -np.inf
    rows = search.start((), clocks, begin, end).rows
    any_length = np.array([*search.stops.plan[:2], FAR, FAR], np.int64)
    got = search.values.of(rows, [((), clocks, begin, end)], plan=any_length)
    return float(got.bound[0])


def longer_stops(
    search: SpanSearch, stops: Stops, departure: int, cost: float, begin: int, end: int
) -> tuple[Stops, int] | None:
    """Return stops that last longer, and a departure, with which members pay less.

    Parameters
    ----------
    search : SpanSearch
        Of a star, which has come to its end.
    stops : tuple of (int, int)
        The best found: position and length [s].
    departure : int
        Of the master with these [s].
    cost : float
        Of all members with these.
    begin, end : int
        The first and last departure of the master [s].

    Returns
    -------
    (tuple of (int, int), int) or None
        Stops and departure; None if none of those looked at is cheaper.
    """
    members = max(len(search.star.alone), 1)
    if members > MOST_MEMBERS:
        return None
    spans = min(MOST_SPANS, MEMBER_SPANS // members)
    kept, search.heap = search.heap, []
    most, best = search.most_spans, (search.best, search.found)
    search.best, search.found = cost, (stops, departure)
    _with_longer_breaks(search, begin, end, spans)
    for _ in range(MOST_ROUNDS):
        before = search.best
        search.most_spans = search.work + spans
        assert search.found is not None
        search.run(begin, end, list(_longer(search, search.found[0])))
        search.heap = []
        if search.best >= before - search.tolerance:
            break
    found = None
    if search.best < cost - search.tolerance:
        found = _shorter(search, *search.found, search.best, begin, end)
    search.heap, search.most_spans = kept, most
    search.best, search.found = best
    return found


def _with_longer_breaks(search: SpanSearch, begin: int, end: int, spans: int) -> None:
    """Search all stops with longer breaks for something cheaper than what is known."""
    asked = search.stops
    row = search.numbers.vehicles[search.numbers.master]
    if row[BREAK] >= FAR:
        return
    more = tuple(int(row[BREAK]) + wait for wait in LONGER_BREAKS_S)
    search.values.stops = MasterStops(
        search.numbers, asked.most, asked.rests, (*asked.lengths, *more), asked.next_stops
    )
    search.most_spans = search.work + spans
    search.run(begin, end)
    search.heap = []
    search.values.stops = asked


def _longer(search: SpanSearch, stops: Stops) -> Iterator[Stops]:
    """Yield stops of which one lasts longer, where one may stand so long."""
    row = search.numbers.vehicles[search.numbers.master]
    for k, (place, length) in enumerate(stops):
        for wait in WAITS_S:
            # A break that becomes a rest is another plan, and one that was searched.
            if length < row[REST] <= length + wait or length + wait > search.numbers.stay[place]:
                break
            yield (*stops[:k], (place, length + wait), *stops[k + 1 :])


def _shorter(
    search: SpanSearch, stops: Stops, departure: int, cost: float, begin: int, end: int
) -> tuple[Stops, int]:
    """Return stops no longer than they have to be for what members pay, and a departure."""
    named = search.stops.held
    for k, (place, length) in enumerate(stops):
        low, high = int(named[named <= length][-1]), length
        while low < high:
            middle = (low + high) // 2
            tried = (*stops[:k], (place, middle), *stops[k + 1 :])
            at = first_departure(search, tried, cost, begin, end)
            if at is None:
                low = middle + 1
            else:
                high, stops, departure = middle, tried, at
    return stops, departure
