"""Real trips that are asked for once: at a departure of the master, throughout a span, at any."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from ..driver.looked import LOOKED
from ..driver.road import LegalTrip
from . import clocks as clocks_of
from .numbers import StarNumbers
from .record import MASTER, Real, Timetable
from .star_times import StarTimes
from .stops import Stops

__all__ = ["AskedTrips"]


@dataclass(slots=True, eq=False)
class AskedTrips:
    """The real trips of one star.

    Attributes
    ----------
    star : StarTimes
        The master and its members.
    numbers : StarNumbers
        The same in whole numbers.
    real : callable or None
        Says how a vehicle really drives; None if nobody is asked.
    asked : dict
        What was answered.
    labels : int
        Labels that searches for real trips have kept, and what beginning them counts for.
    """

    star: StarTimes
    numbers: StarNumbers
    real: Real | None
    asked: dict[tuple[Any, ...], LegalTrip | None] = field(default_factory=dict)
    labels: int = 0

    def never(self, row: int, i: int, j: int, stops: Stops, u: int, v: int) -> bool:
        """Tell whether a pair cannot be driven at any departure of a span.

        Parameters
        ----------
        row : int
            The vehicle.
        i, j : int
            Points where it merges and separates.
        stops : tuple of (int, int)
            The master's.
        u, v : int
            The span [s].

        Returns
        -------
        bool
            False, too, if that is not known.
        """
        if self.numbers.approach[row, i] == 0 and row != self.numbers.master:
            leaves = Timetable.of(self.star, v, stops).leave_s[self.numbers.pos[i]]
            if leaves > self.numbers.vehicles[row, clocks_of.LATEST]:
                return False  # it leaves its origin with the platoon, and might leave earlier
        return self.trip(row, i, j, stops, v, v - u) is None

    def trip(
        self, row: int, i: int, j: int, stops: Stops, departure: int, slack: int
    ) -> LegalTrip | None:
        """Ask for a real trip, once.

        Parameters
        ----------
        row : int
            The vehicle.
        i, j : int
            Points where it merges and separates.
        stops : tuple of (int, int)
            The master's.
        departure, slack : int
            When it leaves, and how much later or earlier it may, see `Real` [s].

        Returns
        -------
        LegalTrip or None
            None if it cannot be driven.
        """
        some = self.numbers
        if self.real is None:
            return None
        if row == some.master:
            between, key_at = stops, departure
        else:
            low, high = int(some.pos[i]), int(some.pos[j])
            between = tuple(stop for stop in stops if low <= stop[0] <= high)
            stood = sum(length for position, length in stops if position < low)
            key_at = departure + stood
        key = (row, i, j, between, key_at, slack)
        if key not in self.asked:
            table = Timetable.of(self.star, departure, stops, slack)
            before = LOOKED.labels
            if row == some.master:
                self.asked[key] = self.real(MASTER, 0, len(self.star.node_at) - 1, table)
            else:
                shift = some.first_node
                self.asked[key] = self.real(row, i - shift, j - shift, table)
            self.labels += LOOKED.labels - before
        return self.asked[key]
