"""Where the master may stop next, and what stops that are not decided yet may do.

A stop is a position and a length: a whole break, a first or a second part of one, a daily rest or a
reduced one, or a longer pause of a given length. Stops are decided in their order. A beginning of
them is worth going on with only if the master may drive to the next stop, and if the stops and the
time that are left can hold the breaks and rests that the rest of its way takes at least.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from . import platoon_kernel as kernel
from .platoon_numbers import StarNumbers
from .star_times import OPEN_S

__all__ = ["MasterStops", "Stops"]

Seconds = NDArray[np.int64]
Stops = tuple[tuple[int, int], ...]
"""(position, seconds) of each stop, in order."""

Clocks = tuple[int, int, int]
"""Driven since the last break, with no part of the next taken and with the first, and today."""

FAR = kernel.FAR


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
    """

    numbers: StarNumbers
    most: int
    rests: int
    lengths: tuple[int, ...] = ()
    places: Seconds = field(init=False)
    _row: Seconds = field(init=False)
    _tau: Seconds = field(init=False)

    def __post_init__(self) -> None:
        some = self.numbers
        last = len(some.tau) - 1
        self.places = np.flatnonzero(some.stay[1:last] > 0) + 1
        self._row, self._tau = some.vehicles[some.master], some.tau

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
        some = np.empty((2, 4), np.int64)
        if not kernel.entry_states(v, 0, departure, 0, False, some):
            return None
        free, parted, today, _ = some[0].tolist()
        at, spell = 0, int(v[kernel.SPELL])
        for position, length in stops:
            step = int(self._tau[position]) - at
            at, today = at + step, today + step
            free = free + step if free + step <= spell else FAR
            parted = parted + step if parted + step <= spell else FAR
            if min(free, parted) >= FAR or today > v[kernel.DAY]:
                return None
            if length >= v[kernel.REST]:
                free, parted, today = 0, 0, 0
            else:
                free, parted = map(int, kernel.paused(v, free, parted, length))
        return free, parted, today

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
        breaks = kernel.needed(int(v[kernel.SPELL]), driven, seconds)
        rests = kernel.needed(int(v[kernel.DAY]), today, seconds)
        stops = max(breaks, rests)
        if rests and v[kernel.REST] >= FAR:
            return stops, rests, FAR
        stood = rests * int(v[kernel.REST]) if rests else 0
        part = int(parted < FAR)
        return stops, rests, stood + int(kernel.breaks_s(v, max(0, breaks - rests), part))

    def can_end(self, stops: Stops, clocks: Clocks, budget: int) -> bool:
        """Whether what is left to drive can be driven with the stops and the time left.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        clocks : (int, int, int)
            After the last of them.
        budget : int
            How long the master may stand [s].

        Returns
        -------
        bool
            Whether it may be; for certain only if not.
        """
        at = stops[-1][0] if stops else 0
        count, rests, stood = self.left(clocks, int(self._tau[-1] - self._tau[at]))
        rested = sum(length >= self._row[kernel.REST] for _, length in stops)
        return count <= self.most - len(stops) and rests <= self.rests - rested and stood <= budget

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
        arrival = int(self._row[kernel.ARRIVAL])
        if arrival >= OPEN_S:
            return FAR
        return arrival - departure - int(self._tau[-1]) - sum(length for _, length in stops)

    def nexts(self, stops: Stops, clocks: Clocks, departure: int) -> list[tuple[int, int]]:
        """Return what the next stop may be.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        clocks : (int, int, int)
            After the last of them.
        departure : int
            When the master leaves [s].

        Returns
        -------
        list of (int, int)
            Positions and lengths [s].
        """
        if len(stops) >= self.most:
            return []
        v, some = self._row, self.numbers
        budget = self.budget(stops, departure)
        at = stops[-1][0] if stops else 0
        rested = sum(length >= v[kernel.REST] for _, length in stops)
        lengths = {int(v[kernel.BREAK])} | set(self.lengths)
        free, parted, today = clocks
        if free < parted:
            lengths.add(int(v[kernel.FIRST]))
        if parted < FAR:
            lengths.add(int(v[kernel.SECOND]))
        if rested < self.rests:
            lengths |= {int(v[kernel.REST]), int(v[kernel.SURE_REST])}
        reach = min(int(v[kernel.SPELL]) - min(free, parted), int(v[kernel.DAY]) - today)
        found = []
        for place in self.places[np.searchsorted(self.places, at, "right") :].tolist():
            if self._tau[place] - self._tau[at] > reach:
                break
            for length in sorted(lengths):
                if length >= FAR or length > some.stay[place] or length > budget:
                    continue
                if length >= v[kernel.REST] and rested >= self.rests:
                    continue
                found.append((place, length))
        return found

    def open_times(
        self, stops: Stops, clocks: Clocks, departure: int
    ) -> tuple[int, bool, Seconds, Seconds]:
        """Return what stops not decided yet may do to the timetable.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        clocks : (int, int, int)
            After the last of them.
        departure : int
            When the master leaves [s].

        Returns
        -------
        open_from : int
            The first point at which one may have been; the number of points if there is none.
        rests : bool
            Whether one may be a daily rest.
        ahead, later : ndarray of int, (n,)
            By how much the platoon is later at each point at least, and at most [s].
        """
        v, some = self._row, self.numbers
        n = len(some.pos)
        ahead, later = np.zeros(n, np.int64), np.zeros(n, np.int64)
        left = self.most - len(stops)
        at = stops[-1][0] if stops else 0
        begin = np.searchsorted(self.places, at, "right")
        budget = self.budget(stops, departure)
        if left <= 0 or begin >= len(self.places) or budget <= 0:
            return n, False, ahead, later
        rested = sum(length >= v[kernel.REST] for _, length in stops)
        rests = max(0, self.rests - rested)
        if budget < v[kernel.REST]:
            rests = 0
        open_from = int(np.searchsorted(some.pos, self.places[begin]))
        passed = np.searchsorted(self.places, some.pos, "right") - begin
        counts = np.minimum(left, np.maximum(0, passed))
        long = max(int(v[kernel.SURE_REST]), int(v[kernel.REST])) if rests else 0
        short = max((one for one in (int(v[kernel.BREAK]), *self.lengths) if one < FAR), default=0)
        resting = np.minimum(rests, counts)
        later[:] = resting * long + (counts - resting) * short
        if budget < FAR:
            later[:] = np.minimum(later, budget)
        drive = np.maximum(0, some.tau[some.pos] - some.tau[at])
        spell, day = int(v[kernel.SPELL]), int(v[kernel.DAY])
        free, parted, today = clocks
        # What is reached without another stop takes none.
        breaks = np.maximum(0, -(-(min(free, parted) + drive - spell) // spell))
        resets = np.maximum(0, -(-(today + drive - day) // day))
        least = resets * int(v[kernel.REST]) if resets.any() else np.zeros(n, np.int64)
        more = np.maximum(0, breaks - resets)
        if more.any():
            one = int(v[kernel.BREAK])
            half = one - min(one, int(v[kernel.SECOND])) if parted < FAR else 0
            least = least + more * one - np.where(more > 0, half, 0)
        ahead[:] = np.minimum(least, later)
        return open_from, rests > 0, ahead, later
