"""From which departure of a master on members can join, and until which they can leave in time.

Let the master leave at t0 and be at r_i after tau_i. A member that may leave from e on and is to
arrive by l, with a way to r_i of time T_i and one from r_j of time T'_j, may join at r_i and leave
at r_j iff

    a_i = e + T_i - tau_i  <=  t0  <=  b_j = l - T'_j - tau_j.

If it has to leave by d, it waits at r_i from c_i = d + T_i - tau_i on. It arrives at
t0 + tau_j + T'_j.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .departure_curve import Gains, MemberSteps
from .kernels import STEPS_OF_MEMBERS
from .limits import Window
from .member_ways import Ways

__all__ = ["HAIR_S", "Delays", "OpenPoints"]

Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]

HAIR_S = 5e-7
"""Sums of the same driving times may differ by less than this [s]; exits stay open for so long."""

EVENT_S = 2e-5
"""About what an event takes as the kernel stands [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class Delays:
    """What it costs members to arrive later than alone.

    Attributes
    ----------
    rate : ndarray of float, (M,)
        Price of a second.
    alone_s : ndarray of float, (M,)
        When each arrives alone, leaving as early as it may [s].
    """

    rate: Floats
    alone_s: Floats


@dataclass(frozen=True, slots=True, eq=False)
class OpenPoints:
    """Between which departures of a master members can join and leave.

    Attributes
    ----------
    entries, exits : Ways
        To the route, and from it onward.
    opens : ndarray of float, (W,)
        From which departure on each entry can be used [s].
    fades : ndarray of float, (W,)
        From which departure on it means waiting at the merging point [s]; inf if never.
    closes : ndarray of float, (V,)
        Until which departure each exit can be used [s].
    arrives : ndarray of float, (V,)
        How long after the master's departure who takes each exit arrives [s].
    earliest, latest : float
        Departures that the master itself allows [s].
    latest_waiting : float
        Its latest departure if it may also wait after leaving: what its latest arrival allows [s].
    """

    entries: Ways
    exits: Ways
    opens: Floats
    fades: Floats
    closes: Floats
    arrives: Floats
    earliest: float
    latest: float
    latest_waiting: float

    @classmethod
    def of(
        cls,
        master: Window,
        members: Sequence[Window],
        route_s: Floats,
        entries: Ways,
        exits: Ways,
        after_s: float = 0.0,
    ) -> OpenPoints:
        """Work out the moments from driving times.

        Parameters
        ----------
        master : Window
            Limits of the master.
        members : sequence of Window, (M,)
            Limits of the members.
        route_s : ndarray of float, (K + 1,)
            When the master is at each position, after its departure [s].
        entries, exits : Ways
            The members' ways to the route and from it.
        after_s : float
            How long the master drives beyond the last position [s].

        Returns
        -------
        OpenPoints
            Infinite where nothing is asked.
        """
        first = np.array([-np.inf if w.earliest is None else w.earliest for w in members])
        leave = np.array([np.inf if w.latest is None else w.latest for w in members])
        last = np.array([np.inf if w.arrival is None else w.arrival for w in members])
        late = np.inf if master.latest is None else master.latest
        whole = np.inf if master.arrival is None else master.arrival - float(route_s[-1]) - after_s
        reached = entries.time_s - route_s[entries.at]
        return cls(
            entries,
            exits,
            first[entries.member] + reached,
            leave[entries.member] + reached,
            last[exits.member] - exits.time_s - route_s[exits.at],
            exits.time_s + route_s[exits.at],
            -np.inf if master.earliest is None else master.earliest,
            min(late, whole),
            whole,
        )

    @property
    def first_moment(self) -> float:
        """A departure before which nothing opens or closes: the earliest, if there is one [s]."""
        if np.isfinite(self.earliest):
            return self.earliest
        moments = np.concatenate([self.opens, self.closes, [self.latest]])
        return float(moments[np.isfinite(moments)].min(initial=1.0)) - 1.0

    def exit_costs(self, delays: Delays | None) -> Floats:
        """Return what exits cost if the master leaves at 0.

        Parameters
        ----------
        delays : Delays or None
            Prices of delay; None if it is free.

        Returns
        -------
        ndarray of float, (V,)
            Each second later costs the member's rate more.
        """
        if delays is None:
            return self.exits.cost
        member = self.exits.member
        later: Floats = delays.rate[member] * (self.arrives - delays.alone_s[member])
        return self.exits.cost + later

    def at(
        self, departure: float, positions: int, price: float = 0.0, delays: Delays | None = None
    ) -> tuple[Floats, Floats]:
        """Return what joining and leaving cost if the master leaves at some moment.

        Parameters
        ----------
        departure : float
            When the master leaves [s].
        positions : int
            How many the route has.
        price : float
            Of a second's waiting.
        delays : Delays, optional
            Prices of delay.

        Returns
        -------
        entry, leave : ndarray of float, (M, K + 1)
            The least of the ways that are open; inf where there is none.
        """
        shape = (len(self.entries.first) - 1, positions)
        entry, leave = np.full(shape, np.inf), np.full(shape, np.inf)
        cost = self.entries.cost
        if price:
            cost = cost + price * np.maximum(departure - self.fades, 0.0)
        some = self.opens <= departure + HAIR_S
        np.minimum.at(entry, (self.entries.member[some], self.entries.at[some]), cost[some])
        some = self.closes >= departure - HAIR_S
        exits, cost = self.exits, self.exit_costs(delays)
        if delays is not None:
            cost = cost + delays.rate[exits.member] * departure
        np.minimum.at(leave, (exits.member[some], exits.at[some]), cost[some])
        return entry, leave

    def entry_way(self, member: int, position: int, departure: float) -> tuple[float, float]:
        """Return cost and time of the way that a member takes to a position.

        Parameters
        ----------
        member : int
            Which.
        position : int
            Where it merges.
        departure : float
            When the master leaves [s].

        Returns
        -------
        cost : float
            Of the cheapest way that is open.
        time_s : float
            How long it takes [s].
        """
        some = self.opens <= departure + HAIR_S
        return _cheapest(self.entries, self.entries.cost, member, position, some)

    def exit_way(
        self, member: int, position: int, departure: float, delays: Delays | None = None
    ) -> tuple[float, float]:
        """Return cost and time of the way that a member takes from a position.

        Parameters
        ----------
        member : int
            Which.
        position : int
            Where it separates.
        departure : float
            When the master leaves [s].
        delays : Delays, optional
            Prices of delay.

        Returns
        -------
        cost : float
            Of the way that is open and costs least with its delay, without that.
        time_s : float
            How long it takes [s].
        """
        some = self.closes >= departure - HAIR_S
        return _cheapest(self.exits, self.exit_costs(delays), member, position, some)

    def steps(
        self,
        platoon: Floats,
        alone: Floats,
        slack: Floats,
        gains: Gains | None = None,
        price: float = 0.0,
        latest: float | None = None,
        delays: Delays | None = None,
    ) -> MemberSteps:
        """Return what each member pays, by the master's departure.

        Parameters
        ----------
        platoon : ndarray of float, (M, K + 1)
            Each member's weight in the platoon along the route up to each position.
        alone : ndarray of float, (M,)
            What each pays alone.
        slack : ndarray of float, (M,)
            How far costs may differ and be equal.
        gains : Gains, optional
            What the master gains; then positions are found too.
        price : float
            Of a second's waiting.
        latest : float, optional
            The last departure to look at [s]; by default the master's own.
        delays : Delays, optional
            Prices of delay.

        Returns
        -------
        MemberSteps
            From the master's earliest departure to its latest.
        """
        ways, rest = self.entries, self.exits
        count = len(ways.at) + len(rest.at)
        kernel = STEPS_OF_MEMBERS.ready(count * EVENT_S)
        end = self.latest if latest is None else latest
        along = np.zeros(platoon.shape[1]) if gains is None else gains.along_m
        # What does not grow with the departure is kept apart from what does.
        rate = np.zeros(len(alone)) if delays is None else delays.rate
        level = np.full(len(alone), np.inf) if rate.any() else alone
        found = kernel(
            ways.first, ways.at, ways.cost - platoon[ways.member, ways.at],
            self.opens, self.fades if price else np.zeros(0),
            rest.first, rest.at, platoon[rest.member, rest.at] + self.exit_costs(delays),
            self.closes + HAIR_S, level, slack, along, self.earliest, end, price,
            gains is not None,
        )  # fmt: skip
        return MemberSteps(*found, len(alone), self.earliest, end, price, alone, rate)


def _cheapest(
    ways: Ways, costs: Floats, member: int, position: int, some: Marks
) -> tuple[float, float]:
    own = slice(int(ways.first[member]), int(ways.first[member + 1]))
    there = some[own] & (ways.at[own] == position)
    cost, time_s = costs[own][there], ways.time_s[own][there]
    best = int(np.lexsort((time_s, cost))[0])
    return float(ways.cost[own][there][best]), float(time_s[best])
