"""Of equally cheap timetables of a master a plain one: few stops, whole breaks, an early departure.

A stop is left out, or two that follow each other become one whole break, as long as some departure
then costs no more; of that, the first such departure is taken.
"""

from __future__ import annotations

from collections.abc import Iterator

from . import clocks as clocks_of
from .spans import SpanSearch
from .stops import Stops

__all__ = ["first_departure", "simplest"]

MOST_SPANS = 300
"""Spans that are looked at for the first departure with some stops."""


def simplest(
    search: SpanSearch, stops: Stops, departure: int, cost: float, begin: int, end: int
) -> tuple[Stops, int]:
    """Return plainer stops and an earlier departure that cost no more.

    Parameters
    ----------
    search : SpanSearch
        Ended.
    stops : tuple of (int, int)
        The best found.
    departure : int
        Of the master with these [s].
    cost : float
        Of all vehicles with these.
    begin, end : int
        The first and last departure [s].

    Returns
    -------
    stops : tuple of (int, int)
        The same if none are plainer.
    departure : int
        The earliest with them that was found [s].
    """
    found = first_departure(search, stops, cost, begin, end)
    departure = departure if found is None else found
    plainer = True
    while plainer:
        plainer = False
        for fewer in _plainer(search, stops):
            found = first_departure(search, fewer, cost, begin, end)
            if found is not None:
                stops, departure, plainer = fewer, found, True
                break
    return stops, departure


def _plainer(search: SpanSearch, stops: Stops) -> Iterator[Stops]:
    row = search.numbers.vehicles[search.numbers.master]
    whole = int(row[clocks_of.BREAK])
    for k in range(len(stops)):
        yield stops[:k] + stops[k + 1 :]
    for k in range(len(stops) - 1):
        if stops[k][1] < whole and stops[k + 1][1] < whole:
            for place, _ in stops[k : k + 2]:
                if search.numbers.stay[place] >= whole:
                    yield (*stops[:k], (place, whole), *stops[k + 2 :])


def first_departure(
    search: SpanSearch, stops: Stops, cost: float, begin: int, end: int
) -> int | None:
    """Return the first departure at which some stops cost no more.

    Parameters
    ----------
    search : SpanSearch
        Ended.
    stops : tuple of (int, int)
        The master's.
    cost : float
        Of all vehicles, at most.
    begin, end : int
        The first and last departure [s].

    Returns
    -------
    int or None
        None if none is found [s].
    """
    most = cost + search.tolerance
    spans = search.stops.allowed(search.star.road, stops, begin, end)
    left = [search.start(stops, None, *span) for span in reversed(spans)]
    most_work = search.work + MOST_SPANS
    while search.work < most_work:
        if not left:
            return None
        for _, total, node in search.bounded([left.pop()], most):
            if total < most or not len(node.rows):
                return node.begin
            left += reversed(search.settled(node))
    return None
