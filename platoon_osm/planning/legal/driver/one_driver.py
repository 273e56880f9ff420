"""The fastest legal trip on a given way, for one driver or two in one vehicle.

Earliest arrival, and among the trips that have it the latest departure; or the latest departure
that is in time. Found by labels (`trip_search`), after Goel, "The minimum duration truck driver
scheduling problem" (EURO Journal on Transportation and Logistics, 2012).

It is the best among all trips in whole seconds that keep the limits and pause at the road's points,
on these conditions: no place with a limited stay is where a ban or an appointment has to be waited
for; where driving in a week can be too much, or a long day could lie on either side of Monday, what
would be driven before Monday is not moved beyond it by leaving later, but by waiting there; and
what docs/law.md says of two drivers. Without those it is legal all the same, and may be later than
the best.
"""

from __future__ import annotations

from dataclasses import replace

from ....errors import ScenarioError
from .numbers import CHANGE
from .road import NO_LIMIT, LegalTrip, until
from .trip_question import TripQuestion
from .trip_search import Aim, TripSearch
from .two_drivers import best_of_two

__all__ = ["farthest", "fastest", "least_late"]

LOOK_BACK = 3
"""How many times its driving time before the arrival a trip's departure is first looked for."""

FARTHEST_S = 60 * 86_400
"""No departure lies farther before the arrival [s]."""


def fastest(
    asked: TripQuestion, aim: Aim = "arrive", *, dominance: bool = True
) -> LegalTrip | None:
    """Return the fastest legal trip.

    Parameters
    ----------
    asked : TripQuestion
        The way, the law, and the times.
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
    earliest_s, arrival_s = asked.earliest_s, asked.arrival_s
    if earliest_s is None and asked.state_at_s is not None:
        earliest_s = asked.state_at_s
    if arrival_s is None and (aim == "leave" or earliest_s is None):
        raise ScenarioError(
            "legal trip: no time is given; give an earliest departure or an arrival"
        )
    search = TripSearch(asked.road, asked.limits, asked.state, asked.monday_s, dominance)

    def best(begin_s: int) -> LegalTrip | None:
        times = (asked.state_at_s, begin_s, asked.last_s, arrival_s, aim)
        if dominance and search.numbers[CHANGE] < NO_LIMIT:
            return best_of_two(search, *times)
        return search.best(*times)

    if earliest_s is not None:
        return best(earliest_s)
    assert arrival_s is not None
    # Later departures are better: the first span that holds a trip holds the best.
    back = LOOK_BACK * int(asked.road.drive_s.sum()) + 3600
    while True:
        found = best(arrival_s - min(back, FARTHEST_S))
        if found is not None or back >= FARTHEST_S:
            return found
        back *= 2


def least_late(asked: TripQuestion) -> int | None:
    """Return the earliest arrival within the law, whatever the latest allowed.

    Parameters
    ----------
    asked : TripQuestion
        With an earliest departure; its latest arrival plays no part.

    Returns
    -------
    int or None
        Seconds; None if the law forbids the way altogether.
    """
    found = fastest(replace(asked, arrival_s=None))
    return None if found is None else found.arrival_s


def farthest(asked: TripQuestion) -> int:
    """Return how far a vehicle comes within the law, whatever becomes of it then.

    Parameters
    ----------
    asked : TripQuestion
        With an earliest departure; its latest arrival plays no part.

    Returns
    -------
    int
        The last point that it can reach.
    """
    low, high = 0, asked.road.hops
    while low < high:
        middle = (low + high + 1) // 2
        if least_late(replace(asked, road=until(asked.road, middle))) is None:
            high = middle - 1
        else:
            low = middle
    return low
