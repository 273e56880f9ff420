"""How far a vehicle may be moved for company: its window, or a stated patience.

With e, l and a the earliest departure, latest departure and latest arrival that a trip names, d its
driving time alone and p the patience [s], company may not make it

    leave before e, else before min(l, a - d) - p,
    leave after l,
    arrive after max(a, e + d), else after l + d + p, else after e + d + p;

what is not named does not count. A trip that cannot be in time even alone (a < e + d) thus arrives
as early as it can, and one that names no time goes along with anybody. The rule is ours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime

from ...plans.clock import Clock
from ...plans.trip import TIMES, Trip
from ...plans.zones import in_order
from .flexibility import with_latest_arrivals

__all__ = ["NOTHING_ASKED", "PATIENCE_MIN", "Window", "first_named", "windows_of"]

PATIENCE_MIN = 120.0
"""By how much a vehicle without a window may be moved for company, unless the problem says."""


@dataclass(frozen=True, slots=True)
class Window:
    """When a vehicle leaves and arrives at the earliest and latest [s]; None where it may be any.

    Attributes
    ----------
    earliest, latest : float or None
        Of its departure [s].
    arrival : float or None
        Its latest arrival [s].
    """

    earliest: float | None
    latest: float | None
    arrival: float | None

    def leaves(self, start: float) -> float:
        """Return when the vehicle leaves if its first piece starts at some time.

        Parameters
        ----------
        start : float
            Start of the piece [s].

        Returns
        -------
        float
            The same, or its latest departure if that is earlier: then it waits at its origin [s].
        """
        return float(start) if self.latest is None else min(float(start), self.latest)

    def moved(self, by: float) -> Window:
        """Return the window by a clock that starts later.

        Parameters
        ----------
        by : float
            How much later [s].

        Returns
        -------
        Window
            The same moments.
        """
        every = (self.earliest, self.latest, self.arrival)
        return Window(*(None if at is None else at - by for at in every))


NOTHING_ASKED = Window(None, None, None)


def first_named(trips: Sequence[Trip]) -> datetime | None:
    """Return the first time that trips name; None if they name none.

    Parameters
    ----------
    trips : sequence of Trip
        Who goes where, and when.

    Returns
    -------
    datetime or None
        What the seconds of windows count from.
    """
    return min((at for trip in trips for at in trip.times.values()), key=in_order, default=None)


def windows_of(
    trips: Sequence[Trip], alone_s: Sequence[float], patience_s: float | None, first: datetime
) -> tuple[list[Window], list[Window]]:
    """Return when vehicles want to drive, and how far company may move them.

    Parameters
    ----------
    trips : sequence of Trip, (N,)
        Who goes where, and when.
    alone_s : sequence of float, (N,)
        Driving time alone [s].
    patience_s : float or None
        How far one without a window may be moved [s]; None for any distance, and then only what
        the trips name counts.
    first : datetime
        What seconds count from.

    Returns
    -------
    asked : list of Window, (N,)
        What the trips name.
    allowed : list of Window, (N,)
        What company must keep to, as the module's text says.
    """
    clock = Clock.at(first)
    asked = [
        Window(*(clock.seconds(trip.times[name]) if name in trip.times else None for name in TIMES))
        for trip in with_latest_arrivals(trips, alone_s)
    ]
    if patience_s is None:
        return asked, asked
    limited = zip(asked, alone_s, strict=True)
    return asked, [_allowed(window, drive_s, patience_s) for window, drive_s in limited]


def _allowed(asked: Window, drive_s: float, patience_s: float) -> Window:
    first, last, arrival = asked.earliest, asked.latest, asked.arrival
    in_time = [
        at for at in (last, None if arrival is None else arrival - drive_s) if at is not None
    ]
    if first is None and in_time:
        first = min(in_time) - patience_s
    return Window(first, last, _latest_arrival(asked, drive_s, patience_s))


def _latest_arrival(asked: Window, drive_s: float, patience_s: float) -> float | None:
    if asked.arrival is not None:
        first = asked.earliest
        return asked.arrival if first is None else max(asked.arrival, first + drive_s)
    leaves = asked.latest if asked.latest is not None else asked.earliest
    return None if leaves is None else leaves + drive_s + patience_s
