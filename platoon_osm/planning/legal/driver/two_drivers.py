"""The best trip of two drivers: what both may drive together first, then who drives what."""

from __future__ import annotations

from .road import LegalTrip, stopping_where
from .trip_search import Aim, TripSearch

__all__ = ["best_of_two"]


def best_of_two(
    each: TripSearch, state_at_s: int | None, earliest_s: int, latest_s: int,
    arrival_s: int | None, aim: Aim,
) -> LegalTrip | None:  # fmt: skip
    """Return the best trip of two drivers.

    Whoever drives counts for the day and the week of both at first. If two drivers who pause
    nowhere else can share the driving of that trip, it is the best: no other is, for more was
    allowed. Only if not, who drives what is part of the search.

    Parameters
    ----------
    each : TripSearch
        In which each is counted on its own.
    state_at_s : int or None
        When the state of both holds [s]; None if whenever they leave.
    earliest_s, latest_s : int
        When they may leave [s].
    arrival_s : int or None
        The latest arrival [s].
    aim : {"arrive", "leave"}
        What is best.

    Returns
    -------
    LegalTrip or None
        None if there is none.
    """
    asked = (state_at_s, earliest_s, latest_s)
    bound = each.on(each.road, pooled=True).best(*asked, arrival_s, aim)
    if bound is None:
        return None
    found = each.on(stopping_where(each.road, bound)).best(*asked, arrival_s, aim)
    if found is None:
        return each.best(*asked, arrival_s, aim)
    if (found.departure_s, found.arrival_s) == (bound.departure_s, bound.arrival_s):
        return found
    if aim == "arrive":
        arrival_s = found.arrival_s
    else:
        asked = (state_at_s, max(earliest_s, found.departure_s), latest_s)
    return each.best(*asked, arrival_s, aim) or found
