"""How the searches of one star are set up: by the stops and rests that the master's driving needs.

What it needs depends on when it leaves: who leaves later has rested longer before. A search allows
a few stops more than that, and no more daily rests, or one more where there is no plan else.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from . import clocks as clocks_of
from .asked import AskedTrips
from .compiled import kernels_for
from .numbers import numbers_of_star
from .pairs import pairs_of_star
from .record import Real
from .spans import SpanSearch
from .star_times import OPEN_S, StarTimes
from .stops import MasterStops
from .tables import OwnRoads, OwnTables
from .values import StarValues

__all__ = ["MOST_RESTS_MORE", "StarSearches", "departures_of"]

Marks = NDArray[np.bool_]

SAME = 1e-9
"""Sums of costs that differ by less, relative to what all pay alone, are equal."""

HORIZON_S = 48 * 3600
"""How far beyond the members' windows a master without a window may leave [s]."""

MOST_RESTS_MORE = 2
"""Daily rests that are tried beyond those that the driving needs, while there is no plan."""


@dataclass(slots=True, eq=False)
class StarSearches:
    """The searches of one star.

    Attributes
    ----------
    star : StarTimes
        The master and its members.
    real : callable or None
        Says how a vehicle really drives; None if it may pause anywhere on its own ways.
    roads : OwnRoads or None
        Says what lies on the members' own ways.
    in_time : ndarray of bool, (M,), or None
        Which members may go alone: in time and within the law; by default those whose cost alone is
        finite.
    plain : ndarray of bool, (M,), or None
        Which members have no driving bans or closed hours on any of their ways; by default all.
    extra_stops : int
        How many more stops are searched than the master's driving needs.
    lengths : tuple of int
        Lengths of pauses that are tried besides those that the law names [s].
    """

    star: StarTimes
    real: Real | None
    roads: OwnRoads | None = None
    in_time: Marks | None = None
    plain: Marks | None = None
    extra_stops: int = 1
    lengths: tuple[int, ...] = ()
    _marks: tuple[Marks, Marks] = field(init=False)
    _probe: MasterStops = field(init=False)

    def __post_init__(self) -> None:
        own = self.star.alone
        self._marks = (
            np.isfinite(own) if self.in_time is None else self.in_time,
            np.ones(len(own), bool) if self.plain is None else self.plain,
        )
        self._probe = MasterStops(numbers_of_star(self.star, *self._marks, 0), 0, 0)

    def needs(self, departure_s: int) -> tuple[int, int]:
        """Return how many stops and daily rests the master's driving takes at least.

        Parameters
        ----------
        departure_s : int
            When it leaves [s].

        Returns
        -------
        (int, int)
            The later it leaves, the fewer.
        """
        probe = self._probe
        clocks = probe.states((), departure_s) or (0, clocks_of.FAR, 0)
        return probe.left(clocks, int(probe.numbers.tau[-1]))[:2]

    def search(self, needs: tuple[int, int], more: int = 0) -> SpanSearch | None:
        """Return a search that has not begun.

        Parameters
        ----------
        needs : (int, int)
            Stops and daily rests that the driving takes.
        more : int
            Daily rests that are allowed beyond these.

        Returns
        -------
        SpanSearch or None
            Without any limit of time; None if more rests are allowed than these rules know.
        """
        star, probe = self.star, self._probe
        if more and probe.numbers.vehicles[probe.numbers.master, clocks_of.REST] >= clocks_of.FAR:
            return None
        stops, rests = needs
        rests += more
        numbers = numbers_of_star(star, *self._marks, rests + 1)
        total = float(np.abs(star.alone[np.isfinite(star.alone)]).sum()) + 1.0
        kernels = kernels_for(len(star.alone) * len(numbers.pos))
        most = max(stops, rests) + self.extra_stops
        lengths, limits = self.lengths, star.rules.limits
        if limits.change_s > 0 and np.isfinite(limits.spell_s):
            # Two drivers change seats in less than the break that both may need.
            lengths = (*lengths, math.ceil(limits.beside_s))
        stopping = MasterStops(numbers, most, rests, lengths, kernels.next_stops)
        tables = OwnTables(
            numbers, None if self.real is None else self.roads, kernels.plain_ways,
            kernels.entries_by_places, kernels.exits_by_places,
        )  # fmt: skip
        values = StarValues(numbers, pairs_of_star(numbers), tables, stopping, kernels.evaluate)
        trips = AskedTrips(star, numbers, self.real)
        return SpanSearch(star, numbers, values, trips, np.inf, SAME * total)


def departures_of(star: StarTimes) -> tuple[int, int]:
    """Return the first and the last departure of a master that are searched.

    Parameters
    ----------
    star : StarTimes
        The master and its members.

    Returns
    -------
    (int, int)
        Its window; where that is open, what is near the windows of all [s].
    """
    window = star.window
    drive = int(star.road.drive_s.sum())
    last = min(window.latest_s, window.arrival_s - drive)
    known = [
        at
        for one in (*star.windows, window)
        for at in (one.earliest_s, one.latest_s, one.arrival_s)
        if abs(at) < OPEN_S // 2
    ]
    first = window.earliest_s
    if first <= -OPEN_S // 2:
        first = (min(known) - drive - HORIZON_S) if known else 0
        first = min(first, last)
    if last >= OPEN_S // 2:
        last = (max(known) + HORIZON_S) if known else first
        last = max(first, last)
    return first, last
