"""Whether a finished trip keeps the limits of driving in a week and in two.

Weeks run from Monday 0:00 to Sunday 24:00 UTC; driving that passes their end is shared between
both. Of two drivers each is counted on its own, unless what both drive is counted together.
"""

from __future__ import annotations

from ....driving.state import DriverState
from .label import WEEK_S
from .numbers import CALENDAR, FORTNIGHT, MOST_WEEK, POOLED
from .road import IntArray, LegalTrip, Road

__all__ = ["keeps_weeks"]


def keeps_weeks(
    trip: LegalTrip, road: Road, state: DriverState, state_at_s: int | None, numbers: IntArray,
    monday_s: int,
) -> bool:  # fmt: skip
    """Return whether a trip keeps the limits of driving in a week.

    Parameters
    ----------
    trip : LegalTrip
        The trip.
    road : Road
        What it drives.
    state : DriverState
        What the driver has behind it.
    state_at_s : int or None
        When that holds [s]; None if when it leaves.
    numbers : int64 array
        The limits.
    monday_s : int
        A Monday 0:00 UTC [s].

    Returns
    -------
    bool
        False, too, where weeks are not those of the calendar, which is not looked at here.
    """
    if not numbers[CALENDAR]:
        return False
    drives = (0,) * road.hops if numbers[POOLED] or not trip.drives else trip.drives
    since = trip.departure_s if state_at_s is None else state_at_s
    return all(
        _keeps(trip, road, state, since, numbers, monday_s, [own == driver for own in drives])
        for driver in set(drives)
    )


def _keeps(
    trip: LegalTrip, road: Road, state: DriverState, since_s: int, numbers: IntArray,
    monday_s: int, drives: list[bool],
) -> bool:  # fmt: skip
    """Return whether the hops that one driver drives keep its limits of a week."""
    week = (since_s - monday_s) // WEEK_S
    both = 2 if numbers[POOLED] else 1
    driven = {
        week - 1: both * state.driven_last_week_s, week: both * state.driven_this_week_s
    }  # fmt: skip
    stands = {one.point: one.end_s - one.start_s for one in trip.pauses}
    at = trip.departure_s
    for hop in range(road.hops):
        at += stands.get(hop, 0)
        seconds = int(road.drive_s[hop])
        clock = int(road.clock_s[hop]) if drives[hop] else 0
        week = (at - monday_s) // WEEK_S
        left = monday_s + (week + 1) * WEEK_S - at
        after = 0 if seconds <= left else clock - clock * left // seconds
        before = clock if seconds <= left else -(-clock * left // seconds)
        for one, own in ((week, before), (week + 1, after)):
            driven[one] = driven.get(one, 0) + own
            two = driven[one] + driven.get(one - 1, 0)
            if own and (driven[one] > numbers[MOST_WEEK] or two > numbers[FORTNIGHT]):
                return False
        at += seconds
    return True
