"""What all pay together, as a function of the moment at which a master leaves that does not wait.

A member that joins at r_i and leaves at r_j, i < j, pays D_i + P_j - P_i + D'_j, P being the
platoon weight along the route: it leaves later, so nobody waits. So its least cost is a step
function of the master's departure t0: entries open at a_i, exits close at b_j (`open_points.py`).
Several ways to one position, of which none is both cheaper and quicker, are entries of their own.
If it has to leave by some time and a second's waiting costs w, an entry costs w (t0 - c_i) more
from some departure c_i on.

The sum over members falls only where something opens; so a least value is found at the earliest
departure, or where an entry opens.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .kernels import MET_ON_ROUTE

__all__ = ["Gains", "MemberSteps", "StepCurve"]

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

    @property
    def until(self) -> Floats:
        """When each step ends [s], (S,)."""
        last = np.concatenate([self.member[1:] != self.member[:-1], [True]])
        return np.where(last, self.end, np.concatenate([self.since[1:], [self.end]]))

    def least(self) -> Floats:
        """Return what each member pays at the departure that suits it best, (M,).

        Returns
        -------
        ndarray of float, (M,)
            Costs.
        """
        at = np.where(np.isfinite(self.since), self.since, 0.0)
        tilted = self.sloped + self.price * at if self.price else self.sloped
        found = np.full(self.members, np.inf)
        np.minimum.at(found, self.member, np.minimum(self.level, tilted))
        return found

    def curve(self, fixed: float = 0.0, gains: Gains | None = None) -> StepCurve:
        """Return the sum over the members.

        Parameters
        ----------
        fixed : float
            What is added whenever the master leaves.
        gains : Gains, optional
            What the master gains, to be taken off; for steps that were found with it.

        Returns
        -------
        StepCurve
            In order of departures.
        """
        parts = self.straight()
        since, after, level, member = parts.since, parts.after, parts.level, parts.member
        slope = np.where(parts.sloped < np.inf, self.price, 0.0)
        head = np.concatenate([[True], member[1:] != member[:-1]]) if len(member) else (
            np.zeros(0, bool)
        )  # fmt: skip
        before = ~head
        change = np.where(before, level - np.roll(level, 1), level)
        tilt = np.where(before, slope - np.roll(slope, 1), slope)
        order = np.lexsort((after, since))
        moments, kinds = since[order], after[order]
        total, slopes = np.cumsum(change[order]) + fixed, np.cumsum(tilt[order])
        if gains is not None:
            kernel = MET_ON_ROUTE.ready(len(order) * len(gains.gain) * 2e-7)
            rank = np.lexsort((self.after, self.since))
            met = kernel(
                self.member[rank], self.merge[rank], self.leave[rank], gains.gain, self.members
            )
            total = total - met
        if not len(order):
            moments, kinds = np.array([self.begin]), np.zeros(1, np.int8)
            total, slopes = np.array([fixed]), np.zeros(1)
        last = np.ones(len(moments), bool)
        last[:-1] = (moments[1:] != moments[:-1]) | (kinds[1:] != kinds[:-1])
        return StepCurve(moments[last], kinds[last], total[last], slopes[last], self.end)

    def straight(self) -> MemberSteps:
        """Return the steps cut where waiting becomes dearer than what is level.

        Returns
        -------
        MemberSteps
            In each step `level` is what the member pays; where `sloped` is finite, it is what it
            would pay for a departure at 0, and it grows by the price.
        """
        if not self.price:
            return self
        with np.errstate(invalid="ignore"):
            cross = (self.level - self.sloped) / self.price
        cross = np.where(np.isfinite(self.sloped), cross, -np.inf)
        tilted = cross > self.since
        cut = tilted & (cross < self.until)
        rows = np.concatenate([np.arange(len(self.since)), np.flatnonzero(cut)])
        second = np.arange(len(rows)) >= len(self.since)
        order = np.lexsort((second, rows))
        rows, second = rows[order], second[order]
        lean = tilted[rows] & ~second
        sloped = self.sloped[rows]
        return MemberSteps(
            self.member[rows],
            np.where(second, cross[rows], self.since[rows]),
            np.where(second, 0, self.after[rows]).astype(np.int8),
            np.where(lean, sloped, self.level[rows]),
            np.where(lean, sloped, np.inf),
            self.merge, self.leave, self.members, self.begin, self.end, self.price,
        )  # fmt: skip


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
