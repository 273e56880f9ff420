"""Where the master may stop next, and what stops that are not decided yet may do.

A stop is a position and a length: a whole break, a first or a second part of one, a daily rest or a
reduced one, or a longer pause of a given length. Stops are decided in their order. A beginning of
them is worth going on with only if the master may drive to the next stop, and if the stops and the
time that are left can hold the breaks and rests that the rest of its way takes at least.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..driver.road import Road
from . import clocks as clocks_of
from .next_stops import next_stops
from .numbers import StarNumbers
from .star_times import OPEN_S

__all__ = ["OPEN", "Clocks", "MasterStops", "Night", "Stops"]

Seconds = NDArray[np.int64]
Stops = tuple[tuple[int, int], ...]
"""(position, seconds) of each stop, in order."""

Clocks = tuple[int, int, int]
"""Driven since the last break, with no part of the next taken and with the first, and today."""

Night = tuple[int, int, int]
"""Position and length [s] of the next daily rest, and how many stops come before it in all; the
position is behind the way if there is none."""

OPEN: Night = (-1, 0, 0)
"""Where the next daily rest lies is not decided."""

FAR = clocks_of.FAR


@dataclass(slots=True, eq=False)
class MasterStops:
    """The stops that a master may make.

    Attributes
    ----------
    numbers : StarNumbers
        The star.
    most : int
        Stops at most.
    rests : int
        Daily rests among them at most.
    lengths : tuple of int
        Further lengths of pauses [s].
    next_stops : callable
        The kernel, compiled or not.
    places : ndarray of int
        Positions where it may stop.
    held : ndarray of int
        What a stop may last, ascending [s].
    plan : ndarray of int, (4,)
        The most stops and rests, and the longest stop without a rest and with one [s].
    """

    numbers: StarNumbers
    most: int
    rests: int
    lengths: tuple[int, ...] = ()
    next_stops: Callable[..., int] = next_stops
    places: Seconds = field(init=False)
    held: Seconds = field(init=False)
    plan: Seconds = field(init=False)
    _row: Seconds = field(init=False)
    _tau: Seconds = field(init=False)

    def __post_init__(self) -> None:
        some = self.numbers
        last = len(some.tau) - 1
        self.places = np.flatnonzero(some.stay[1:last] > 0) + 1
        self._row, self._tau = some.vehicles[some.master], some.tau
        # What the master has no use for may be what members need.
        named = (
            clocks_of.BREAK,
            clocks_of.FIRST,
            clocks_of.SECOND,
            clocks_of.REST,
            clocks_of.SURE_REST,
        )
        lengths = {int(self._row[one]) for one in named} | set(self.lengths)
        self.held = np.array(sorted(one for one in lengths if one < FAR), np.int64)
        rest_s = int(self._row[clocks_of.REST])
        short = int(self.held[self.held < rest_s].max(initial=0))
        rest = max(int(self._row[clocks_of.SURE_REST]), rest_s, *self.lengths, 0)
        longest = rest if rest < FAR else short
        self.plan = np.array([self.most, self.rests, short, longest], np.int64)

    def states(self, stops: Stops, departure: int) -> Clocks | None:
        """Return the clocks after the last stop; None if that is not legal.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        departure : int
            When the master leaves [s].

        Returns
        -------
        (int, int, int) or None
            Driven, with no part of a break taken and with the first, and today [s].
        """
        v = self._row
        some = np.empty(4, np.int64)
        if not clocks_of.entry_state(v, 0, departure, some):
            return None
        free, parted, today, _ = some.tolist()
        clocks: Clocks | None = (free, parted, today)
        at = 0
        for stop in stops:
            if clocks is None:
                return None
            clocks, at = self.after(clocks, at, stop), stop[0]
        return clocks

    def left(self, clocks: Clocks, seconds: int) -> tuple[int, int, int]:
        """Return stops, rests and time standing that a way takes at least.

        Parameters
        ----------
        clocks : (int, int, int)
            After the last of them.
        seconds : int
            How long it is driven [s].

        Returns
        -------
        (int, int, int)
            The three of them, the last in seconds.
        """
        v = self._row
        free, parted, today = clocks
        driven = min(free, parted)
        breaks = clocks_of.needed(int(v[clocks_of.SPELL]), driven, seconds)
        rests = clocks_of.needed(int(v[clocks_of.DAY]), today, seconds)
        stops = max(breaks, rests)
        if rests and v[clocks_of.REST] >= FAR:
            return stops, rests, FAR
        stood = rests * int(v[clocks_of.REST]) if rests else 0
        part = int(parted < FAR)
        return stops, rests, stood + int(clocks_of.breaks_s(v, max(0, breaks - rests), part))

    def is_end(self, stops: Stops, clocks: Clocks) -> bool:
        """Whether no further stop is needed.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        clocks : (int, int, int)
            After the last of them.

        Returns
        -------
        bool
            Likewise.
        """
        at = stops[-1][0] if stops else 0
        return self.left(clocks, int(self._tau[-1] - self._tau[at]))[0] == 0

    def allows(self, stops: Stops) -> bool:
        """Tell whether stops are not too many, nor the daily rests among them.

        Parameters
        ----------
        stops : tuple of (int, int)
            All of them.

        Returns
        -------
        bool
            Whether a search may end with them.
        """
        return len(stops) <= self.most and self._rests_left(stops) >= 0

    def _rests_left(self, stops: Stops) -> int:
        """Return how many daily rests there may be besides those decided."""
        rest_s = int(self._row[clocks_of.REST])
        return self.rests - sum(length >= rest_s for _, length in stops)

    def after(self, clocks: Clocks, begin: int, stop: tuple[int, int]) -> Clocks | None:
        """Return the clocks after one stop more; None if that is not legal.

        Parameters
        ----------
        clocks : (int, int, int)
            Before it.
        begin : int
            The position to which these belong.
        stop : (int, int)
            The stop's position and length [s].

        Returns
        -------
        (int, int, int) or None
            As in `states`.
        """
        v = self._row
        spell = int(v[clocks_of.SPELL])
        free, parted, today = clocks
        position, length = stop
        step = int(self._tau[position] - self._tau[begin])
        free = free + step if free + step <= spell else FAR
        parted = parted + step if parted + step <= spell else FAR
        today += step
        if min(free, parted) >= FAR or today > v[clocks_of.DAY]:
            return None
        if length >= v[clocks_of.REST]:
            return 0, FAR, 0
        free, parted = clocks_of.paused(v, free, parted, length)
        return int(free), int(parted), today

    def budget(self, stops: Stops, departure: int) -> int:
        """Return how long the master may still stand.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        departure : int
            When the master leaves [s].

        Returns
        -------
        int
            Until it would be late [s].
        """
        arrival = int(self._row[clocks_of.ARRIVAL])
        if arrival >= OPEN_S:
            return FAR
        return arrival - departure - int(self._tau[-1]) - sum(length for _, length in stops)

    def nexts(
        self, stops: Stops, clocks: Clocks, departure: int, night: Night = OPEN
    ) -> list[tuple[tuple[int, int], Clocks]]:
        """Return what the next stop may be.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        clocks : (int, int, int)
            After the last of them.
        departure : int
            When the master leaves [s].
        night : (int, int, int)
            Its next daily rest.

        Returns
        -------
        list of ((int, int), (int, int, int))
            Position and length [s] of those after which the rest of the way can be driven with the
            stops and the time left, as far as that can be told; and the clocks after them.
        """
        left = self.most - len(stops)
        if left <= 0:
            return []
        v, some = self._row, self.numbers
        rests = self._rests_left(stops)
        found = np.empty((len(self.places) * len(self.held), 5), np.int64)
        count = self.next_stops(
            v, self.places, self._tau, some.stay, self.held, stops[-1][0] if stops else 0,
            np.array(clocks, np.int64), left, rests, self.budget(stops, departure), *night[:2],
            night[2] - len(stops), found,
        )  # fmt: skip
        return [((a, b), (c, d, e)) for a, b, c, d, e in found[:count].tolist()]

    def nights(self, stops: Stops, clocks: Clocks) -> list[Night]:
        """Return what the next daily rest may be, or that there is none.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        clocks : (int, int, int)
            After the last of them.

        Returns
        -------
        list of (int, int, int)
            Those that leave no more for the rest of the way than it may take.
        """
        v, tau = self._row, self._tau
        at, end, made = (stops[-1][0] if stops else 0), len(tau) - 1, len(stops)
        rests = self._rests_left(stops)
        day, spell = int(v[clocks_of.DAY]), int(v[clocks_of.SPELL])
        found = [(end + 1, 0, 0)] if clocks[2] + tau[end] - tau[at] <= day else []
        if rests <= 0:
            return found
        for before, place in enumerate(self.places[self.places > at].tolist()):
            if clocks[2] + tau[place] - tau[at] > day:
                break
            behind = int(tau[end] - tau[place])
            resets = clocks_of.needed(day, 0, behind)
            if resets >= rests:
                continue
            least = clocks_of.needed(spell, min(clocks[:2]), int(tau[place] - tau[at]))
            most = self.most - made - 1 - max(resets, clocks_of.needed(spell, 0, behind))
            found += [
                (place, length, made + count)
                for length in self.held[self.held >= v[clocks_of.REST]].tolist()
                if length <= self.numbers.stay[place]
                for count in range(least, min(most, before) + 1)
            ]
        return found

    def allowed(self, road: Road, stops: Stops, begin: int, end: int) -> list[tuple[int, int]]:
        """Return departures at which no hop starts while it is closed and the master is in time.

        Parameters
        ----------
        road : Road
            The master's way.
        stops : tuple of (int, int)
            All its stops.
        begin, end : int
            The span of its departure [s].

        Returns
        -------
        list of (int, int)
            Spans in order [s].
        """
        stood = sum(length for _, length in stops)
        end = min(end, int(self._row[clocks_of.ARRIVAL] - self._tau[-1] - stood))
        if begin > end:
            return []
        if not len(road.forbidden_s):
            return [(begin, end)]
        closed, _ = self._closed(road, stops)
        closed = closed[np.argsort(closed[:, 0], kind="stable")]
        found, low = [], begin
        for first, last in closed.tolist():
            if last <= low:
                continue
            if first >= end:
                break
            if first >= low:
                found.append((low, first))
            low = max(low, last)
        if low <= end:
            found.append((low, end))
        return found

    def reach(self, road: Road, stops: Stops, begin: int, end: int) -> int:
        """Return the last position to which the master may drive without a stop more.

        A hop that is closed at all departures is the end of that.

        Parameters
        ----------
        road : Road
            The master's way.
        stops : tuple of (int, int)
            Those decided.
        begin, end : int
            The span of its departure [s].

        Returns
        -------
        int
            That of its destination if no hop is.
        """
        if not len(road.forbidden_s):
            return road.hops
        closed, hops = self._closed(road, stops)
        shut = (closed[:, 0] < begin) & (closed[:, 1] > end)
        shut &= hops >= (stops[-1][0] if stops else 0)
        return int(hops[shut].min(initial=road.hops))

    def _closed(self, road: Road, stops: Stops) -> tuple[Seconds, Seconds]:
        """Return for which departures a hop is closed when it is reached, and which hop."""
        stands = np.zeros(len(self._tau), np.int64)
        for position, length in stops:
            stands[position] += length
        leave = (self._tau + np.cumsum(stands))[:-1]
        hops = np.repeat(np.arange(road.hops), np.diff(road.forbidden_first))
        return road.forbidden_s - leave[hops][:, None], hops
