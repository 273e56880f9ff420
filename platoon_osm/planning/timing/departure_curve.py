"""What all pay together, as a function of the moment at which a master leaves that does not wait.

A member that joins at r_i and leaves at r_j, i < j, pays D_i + P_j - P_i + D'_j, P being the
platoon weight along the route: it leaves later, so nobody waits. So its least cost is a step
function of the master's departure t0: entries open at a_i, exits close at b_j (`open_points.py`).
Several ways to one position, of which none is both cheaper and quicker, are entries of their own.
If it has to leave by some time and a second's waiting costs w, an entry costs w (t0 - c_i) more
from some departure c_i on. If a second's delay costs d, company costs d t0 more, and each exit by
when the member then arrives. So a member pays the least of three lines: alone, slope 0; in company,
slope d; and in company after waiting, slope d + w.

The sum over members falls only where something opens; so a least value is found at the earliest
departure, or where an entry opens.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .kernels import MET_ON_ROUTE

__all__ = ["Gains", "MemberSteps", "StepCurve", "StraightSteps"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Gains:
    """What the choice of members changes beside their own cost.

    Attributes
    ----------
    gain : ndarray of float, (K,)
        What the master saves on each edge of its route where it has company; it counts once.
    along_m : ndarray of float, (K + 1,)
        Metres along the route up to each position.
    """

    gain: Floats
    along_m: Floats


@dataclass(frozen=True, slots=True, eq=False)
class MemberSteps:
    """What each member pays, by the master's departure: as the kernel tells it.

    Attributes
    ----------
    member, since, after, level, sloped, merge, leave : ndarray, (S,)
        As in `steps_of_members`.
    members : int
        How many there are.
    begin, end : float
        The departures between which they hold [s].
    price : float
        Of a second's waiting.
    alone, delay : ndarray of float, (M,)
        What each pays alone, and for a second's delay; `level` and `sloped` are those of departures
        at 0 where delay costs something, and `level` is of company only.
    """

    member: Longs
    since: Floats
    after: NDArray[np.int8]
    level: Floats
    sloped: Floats
    merge: Longs
    leave: Longs
    members: int
    begin: float
    end: float
    price: float
    alone: Floats
    delay: Floats

    @property
    def until(self) -> Floats:
        """When each step ends [s], (S,)."""
        return _until(self.member, self.since, self.end)

    def least(self) -> Floats:
        """Return what each member pays at the departure that suits it best, (M,).

        Returns
        -------
        ndarray of float, (M,)
            Costs.
        """
        at = np.where(np.isfinite(self.since), self.since, 0.0)
        later = self.delay[self.member] * at
        pays = np.minimum(self.level, self.sloped + self.price * at) + later
        found = self.alone.copy()
        np.minimum.at(found, self.member, pays)
        return found

    def curve(
        self, fixed: float = 0.0, gains: Gains | None = None, slope: float = 0.0
    ) -> StepCurve:
        """Return the sum over the members.

        Parameters
        ----------
        fixed : float
            What is added whenever the master leaves.
        gains : Gains, optional
            What the master gains, to be taken off; for steps that were found with it.
        slope : float
            What is added for each second that the master leaves later.

        Returns
        -------
        StepCurve
            In order of departures.
        """
        parts = self.straight()
        since, after, level, member = parts.since, parts.after, parts.level, parts.member
        head = np.concatenate([[True], member[1:] != member[:-1]]) if len(member) else (
            np.zeros(0, bool)
        )  # fmt: skip
        before = ~head
        change = np.where(before, level - np.roll(level, 1), level)
        tilt = np.where(before, parts.slope - np.roll(parts.slope, 1), parts.slope)
        order = np.lexsort((after, since))
        moments, kinds = since[order], after[order]
        total, slopes = np.cumsum(change[order]) + fixed, np.cumsum(tilt[order]) + slope
        if gains is not None:
            kernel = MET_ON_ROUTE.ready(len(order) * len(gains.gain) * 2e-7)
            rank = np.lexsort((self.after, self.since))
            met = kernel(
                self.member[rank], self.merge[rank], self.leave[rank], gains.gain, self.members
            )
            total = total - met
        if not len(order):
            moments, kinds = np.array([self.begin]), np.zeros(1, np.int8)
            total, slopes = np.array([fixed]), np.array([slope])
        last = np.ones(len(moments), bool)
        last[:-1] = (moments[1:] != moments[:-1]) | (kinds[1:] != kinds[:-1])
        return StepCurve(moments[last], kinds[last], total[last], slopes[last], self.end)

    def straight(self) -> StraightSteps:
        """Return the steps cut where another of their lines becomes the least.

        Returns
        -------
        StraightSteps
            The same steps where neither waiting nor delay costs anything.
        """
        if not self.price and not self.delay.any():
            return StraightSteps(
                self.member, self.since, self.after, self.level, np.zeros(len(self.level)),
                self.merge, self.end,
            )  # fmt: skip
        rate, until = self.delay[self.member], self.until
        lines = np.array([self.sloped, self.level, self.alone[self.member]])
        slopes = np.array([rate + self.price, rate, np.zeros(len(rate))])
        begins = [self.since]
        with np.errstate(invalid="ignore", divide="ignore"):
            for one, other in ((0, 1), (1, 2), (0, 2)):
                cross = (lines[other] - lines[one]) / (slopes[one] - slopes[other])
                inside = (cross > self.since) & (cross < until)
                begins.append(np.where(inside, cross, np.inf))
        starts = np.array([begins[0], *np.sort(begins[1:], axis=0)])
        some = np.isfinite(starts)
        some[0] = True
        ends = np.minimum(np.concatenate([starts[1:], np.full((1, len(rate)), np.inf)]), until)
        inner = _between(starts, ends)
        values = lines[:, None] + slopes[:, None] * inner
        least = np.argmin(values, axis=0)
        step = np.broadcast_to(np.arange(len(rate)), starts.shape).T[some.T]
        part = np.broadcast_to(np.arange(len(starts))[:, None], starts.shape).T[some.T]
        line = least.T[some.T]
        after = np.where(part, 0, self.after[step]).astype(np.int8)
        return StraightSteps(
            self.member[step], starts.T[some.T], after,
            lines[line, step], slopes[line, step], self.merge, self.end,
        )  # fmt: skip


def _between(begin: Floats, end: Floats) -> Floats:
    """Return a moment between others, whichever of them are infinite."""
    open_begin, open_end = ~np.isfinite(begin), ~np.isfinite(end)
    low = np.where(open_begin, np.where(open_end, 0.0, end) - 2.0, begin)
    high = np.where(open_end, low + 2.0, end)
    found: Floats = (low + high) / 2
    return found


def _until(member: Longs, since: Floats, end: float) -> Floats:
    last = np.concatenate([member[1:] != member[:-1], [True]])
    return np.where(last, end, np.concatenate([since[1:], [end]]))


@dataclass(frozen=True, slots=True, eq=False)
class StraightSteps:
    """What each member pays: level + slope t0 in each step.

    Attributes
    ----------
    member, since, after : ndarray, (S,)
        As in `MemberSteps`.
    level, slope : ndarray of float, (S,)
        What the member pays for a departure at 0, and for each second more.
    merge : ndarray of int, (S,)
        As in `MemberSteps`.
    end : float
        The last departure [s].
    """

    member: Longs
    since: Floats
    after: NDArray[np.int8]
    level: Floats
    slope: Floats
    merge: Longs
    end: float

    @property
    def until(self) -> Floats:
        """When each step ends [s], (S,)."""
        return _until(self.member, self.since, self.end)


@dataclass(frozen=True, slots=True, eq=False)
class StepCurve:
    """A sum that is linear between departures of the master.

    Attributes
    ----------
    since : ndarray of float, (S,)
        From which departure on each step holds [s], ascending.
    after : ndarray of int8, (S,)
        0 if it holds at that departure too, 1 if only after it.
    level, slope : ndarray of float, (S,)
        The sum is level + slope t0.
    end : float
        The last departure [s].
    """

    since: Floats
    after: NDArray[np.int8]
    level: Floats
    slope: Floats
    end: float

    @property
    def until(self) -> Floats:
        """When each step ends [s], (S,)."""
        return np.concatenate([self.since[1:], [self.end]])

    @property
    def begin_value(self) -> Floats:
        """The sum at the begin of each step, (S,)."""
        return self.level + _tilt(self.slope, self.since)

    @property
    def end_value(self) -> Floats:
        """The sum at the end of each step, (S,)."""
        return self.level + _tilt(self.slope, self.until)

    def moment(self, step: int) -> float:
        """Return a departure at which a step holds: the least of it, as near as there is one.

        Parameters
        ----------
        step : int
            Which.

        Returns
        -------
        float
            Seconds.
        """
        begin, end = float(self.since[step]), float(self.until[step])
        if not np.isfinite(begin):
            return end - 1.0 if np.isfinite(end) else 0.0
        if not self.after[step] or end <= begin:
            return begin
        return begin + 1.0 if not np.isfinite(end) else (begin + end) / 2

    def best(self, slack: float = 0.0) -> tuple[int, float]:
        """Return the earliest step that is least, and its value.

        Parameters
        ----------
        slack : float
            How far values may differ and be equal.

        Returns
        -------
        step : int
            Which.
        value : float
            The least value there.
        """
        values = self.begin_value
        least = float(values.min())
        step = int(np.argmax(values <= least + slack))
        return step, float(values[step])

    def values(self, departures: Floats) -> Floats:
        """Return the sum at some departures.

        Parameters
        ----------
        departures : ndarray of float, (k,)
            Seconds, none before the first step.

        Returns
        -------
        ndarray of float, (k,)
            Its values.
        """
        # What holds after a moment only does not hold at it.
        step = np.searchsorted(self.since, departures, "right") - 1
        late = (self.after[step] == 1) & (self.since[step] == departures)
        step = np.where(late, step - 1, step)
        return self.level[step] + _tilt(self.slope[step], departures)


def _tilt(slope: Floats, at: Floats) -> Floats:
    found: Floats = np.where(slope != 0, slope * np.where(np.isfinite(at), at, 0.0), 0.0)
    return found
