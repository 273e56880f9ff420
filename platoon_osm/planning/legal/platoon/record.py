"""When a platoon drives, and who is in it: what the search for its times returns."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..driver.road import LegalTrip
from .star_times import StarTimes

__all__ = ["MASTER", "MemberTiming", "PlatoonTiming", "Real", "Timetable", "gained"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]

MASTER = -1
"""As a member: the master itself."""


@dataclass(frozen=True, slots=True, eq=False)
class Timetable:
    """When the master passes the positions of its way.

    Attributes
    ----------
    departure_s : int
        When it leaves [s].
    stops : tuple of (int, int)
        Position and length [s] of each stop, in order.
    arrive_s, leave_s : ndarray of int, (P + 1,)
        When it reaches each position and leaves it [s].
    slack_s : int
        Of a question about a span of departures, see `Real`; else 0 [s].
    """

    departure_s: int
    stops: tuple[tuple[int, int], ...]
    arrive_s: Seconds
    leave_s: Seconds
    slack_s: int = 0

    @classmethod
    def of(
        cls, star: StarTimes, departure_s: int, stops: tuple[tuple[int, int], ...], slack_s: int = 0
    ) -> Timetable:
        """Return the timetable of a departure and stops.

        Parameters
        ----------
        star : StarTimes
            The master and its members.
        departure_s : int
            When the master leaves [s].
        stops : tuple of (int, int)
            Position and length [s] of each stop, in order.
        slack_s : int
            As the attribute.

        Returns
        -------
        Timetable
            Stops last as long as given, and the master stands nowhere else.
        """
        tau = np.concatenate([[0], np.cumsum(star.road.drive_s)]).astype(np.int64)
        stood = np.zeros(len(tau), np.int64)
        for position, length in stops:
            stood[position] += length
        leave = departure_s + tau + np.cumsum(stood)
        return cls(departure_s, stops, leave - stood, leave, slack_s)


Real = Callable[[int, int, int, Timetable], "LegalTrip | None"]
"""Says how a vehicle really drives with the platoon, or None if it cannot.

It is asked with a member, the nodes i and j of the master's route where it merges and separates,
and a timetable; or with `MASTER`, 0 and the last node. The member has to leave node i, and every
position up to j at which the platoon stands, when the platoon does, and be in time and within the
law with pauses at real places. With a slack w it says whether it can for a span of departures:

- w > 0: for some departure from `departure_s` - w to `departure_s`. It may arrive w later than its
  window, its limits of elapsed time are longer by w, and from node i on what is closed over (a, b)
  is so over (a + w, b). If node i is its origin it may leave w later, too.
- w < 0: for every departure from `departure_s` to `departure_s` - w, in the same words.
"""


@dataclass(frozen=True, slots=True)
class MemberTiming:
    """How a member drives.

    Attributes
    ----------
    cost : float
        What it pays.
    merge, separate : int
        Nodes of the master's route; -1 if it drives alone.
    trip : LegalTrip or None
        When, on its joint way; None if it drives alone.
    possible : bool
        Whether it is in time and within the law at all, alone or in company.
    stretches : tuple of (int, int)
        Where it drives with the master: one from `merge` to `separate`, or two if it joins again.
    """

    cost: float
    merge: int = -1
    separate: int = -1
    trip: LegalTrip | None = None
    possible: bool = True
    stretches: tuple[tuple[int, int], ...] = ()

    def __post_init__(self) -> None:
        if self.merge >= 0 and not self.stretches:
            object.__setattr__(self, "stretches", ((self.merge, self.separate),))

    @property
    def is_alone(self) -> bool:
        """Whether it stays alone."""
        return self.merge < 0


@dataclass(frozen=True, slots=True)
class PlatoonTiming:
    """The best that was found for one master.

    Attributes
    ----------
    cost : float
        Of all vehicles; inf if the master has no legal timetable.
    bound : float
        No other departure or stops of those searched make the members cheaper in all than `cost`
        less `bound`.
    waiting_bound : float
        Likewise, whatever the master's stops last.
    proved : bool
        Whether nothing is better of what was searched: where the master stands for its law alone.
    timetable : Timetable or None
        The master's; None if it has none.
    master_trip : LegalTrip or None
        The master's times, with the purposes of its pauses.
    members : tuple of MemberTiming, (M,)
        How each member drives.
    alone_cost : float
        What all would pay alone.
    again_complete : bool
        Whether all ways in which members could join again were compared, if they may.
    waits : bool
        Whether the master stands longer than was searched, which is cheaper than all that was.
    evaluations : int
        Values of members computed.
    asked : int
        Questions of real trips.
    spans : int
        Spans of departures looked at.
    work : int
        The same with what real trips took, counted as spans.
    seconds : float
        How long the search took.
    """

    cost: float
    bound: float
    waiting_bound: float
    proved: bool
    timetable: Timetable | None
    master_trip: LegalTrip | None
    members: tuple[MemberTiming, ...] = ()
    alone_cost: float = float("nan")
    again_complete: bool = True
    waits: bool = False
    evaluations: int = 0
    asked: int = 0
    spans: int = 0
    work: int = 0
    seconds: float = field(default=0.0, compare=False)

    @property
    def departure_s(self) -> int | None:
        """When the master leaves [s]."""
        return None if self.timetable is None else self.timetable.departure_s

    @property
    def stops(self) -> tuple[tuple[int, int], ...]:
        """Position and length [s] of each stop of the master."""
        return () if self.timetable is None else self.timetable.stops

    @property
    def gap(self) -> float:
        """How much more could be saved, as a share of the most that could be."""
        most = self.alone_cost - self.bound
        return 0.0 if self.proved or most <= 0 else (self.cost - self.bound) / most


def gained(gain: Floats, together: Iterable[Iterable[tuple[int, int]]]) -> float:
    """Return what a master saves by its company.

    Parameters
    ----------
    gain : ndarray of float, (K,)
        What it saves on each edge of its route if it has company there.
    together : iterable of iterable of (int, int), (M, ...)
        Between which nodes of the route each member drives with it.

    Returns
    -------
    float
        Once for each edge on which it has any.
    """
    met = np.zeros(len(gain), bool)
    for some in together:
        for i, j in some:
            met[i:j] = True
    return float(gain[met].sum())
