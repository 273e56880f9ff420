"""Why a vehicle cannot be in time within the law alone, and what would have to give.

Each answer is a search with one thing changed and all else kept: a later arrival, an earlier or a
later departure, a second driver, a driver who has rested, a day of longer driving or a shorter
daily rest that the driver has not left. So each of them alone would do, and by as much as is told.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from ....driving.limits import Limits
from ....driving.state import DriverState
from ....errors import ScenarioError
from .one_driver import farthest, fastest, least_late
from .road import Road
from .trip_question import TripQuestion

__all__ = ["REMEDIES", "WhyNot", "why_not"]

REMEDIES = ("rested", "long_day", "reduced_rest", "second_driver")
"""What may help besides other times: a driver with nothing behind it, one long day of driving more,
one reduced daily rest more, and a second driver."""


@dataclass(frozen=True, slots=True)
class WhyNot:
    """What would have to give for a vehicle to be in time within the law.

    Attributes
    ----------
    late_s : int or None
        By how much it is late at best [s]; 0 if only the latest departure stands in the way; None
        if it cannot arrive at any time.
    earlier_s : int or None
        By how much it would have to be allowed to leave earlier, in the state in which it is [s];
        None if that does not help.
    later_s : int or None
        By how much it would have to be allowed to leave later, to arrive when it has to [s]; None
        if that does not help.
    remedies : tuple of str
        Those of `REMEDIES` that would do.
    reached : int
        The farthest point of the road that can be reached within the law at all: the destination
        unless `late_s` is None.
    """

    late_s: int | None
    earlier_s: int | None
    later_s: int | None
    remedies: tuple[str, ...]
    reached: int


def why_not(
    road: Road,
    limits: Limits,
    team: Limits | None,
    state: DriverState,
    state_at_s: int | None,
    earliest_s: int | None,
    latest_s: int | None = None,
    arrival_s: int | None = None,
    monday_s: int = 0,
) -> WhyNot | None:
    """Return what would have to give.

    Parameters
    ----------
    road : Road
        The way.
    limits : Limits
        The law for this vehicle.
    team : Limits or None
        The law for two drivers; None if the rules know none, or there are two already.
    state : DriverState
        What the driver has behind it.
    state_at_s : int or None
        When that holds [s].
    earliest_s, latest_s, arrival_s : int or None
        The earliest and the latest departure, and the latest arrival [s].
    monday_s : int, optional
        A Monday 0:00 UTC [s].

    Returns
    -------
    WhyNot or None
        None if it can be in time.

    Raises
    ------
    ScenarioError
        Neither an earliest departure nor a latest arrival.
    """
    if earliest_s is None:
        earliest_s = state_at_s
    if earliest_s is None and arrival_s is None:
        raise ScenarioError("legal trip: no time is given; name a departure or an arrival")

    asked = TripQuestion(road, limits, state, state_at_s, earliest_s, latest_s, arrival_s, monday_s)

    def trip_by(limits: Limits, state: DriverState) -> bool:
        return fastest(replace(asked, limits=limits, state=state)) is not None

    if trip_by(limits, state):
        return None
    late = None
    if earliest_s is not None:
        late = least_late(asked)
        if late is not None:
            late = max(0, late - arrival_s) if arrival_s is not None else 0
    earlier = later = None
    if arrival_s is not None:
        free = replace(asked, state_at_s=None, earliest_s=None, latest_s=earliest_s)
        before = fastest(free, "leave")
        if before is not None and earliest_s is not None:
            earlier = earliest_s - before.departure_s
    if latest_s is not None and earliest_s is not None:
        after = fastest(replace(asked, latest_s=None))
        if after is not None:
            later = _least_later(asked, latest_s, after.departure_s)
    helps = tuple(name for name, law, who in _others(limits, team, state) if trip_by(law, who))
    reached = road.hops
    if late is None:
        begin = arrival_s if earliest_s is None else earliest_s
        assert begin is not None
        reached = farthest(replace(asked, earliest_s=begin))
    return WhyNot(late, earlier, later, helps, reached)


def _least_later(asked: TripQuestion, latest_s: int, known_s: int) -> int:
    """Return how much later a departure has to be allowed, to the second, from one that will do.

    Who may leave until a moment may leave until a later one, so halving finds it.
    """
    low, high = latest_s, known_s
    while high - low > 1:
        middle = (low + high) // 2
        if fastest(replace(asked, latest_s=middle)) is None:
            low = middle
        else:
            high = middle
    return high - latest_s


def _others(
    limits: Limits, team: Limits | None, state: DriverState
) -> list[tuple[str, Limits, DriverState]]:
    """Return remedies, each with the limits and the state that it means."""
    found = []
    rested = DriverState(drivers=state.drivers)
    if state != rested:
        found.append(("rested", limits, rested))
    if limits.long_days:
        found.append(("long_day", replace(limits, long_days=limits.long_days + 1), state))
    if limits.reduced_rests:
        more = replace(limits, reduced_rests=limits.reduced_rests + 1)
        found.append(("reduced_rest", more, state))
    if team is not None and state.drivers == 1:
        found.append(("second_driver", team, replace(state, drivers=2)))
    return found
