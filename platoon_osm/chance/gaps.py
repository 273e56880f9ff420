"""By how much one comes later than another to the place where they meet, as a distribution.

The gap is D = T_late - T_there. With both delays normal it is normal, with mean mu the difference
by the timetable and s^2 = s_A^2 + s_B^2 - 2 cov:

    P(D <= w) = Phi((w - mu) / s)
    E[max(D, 0)] = s phi(mu / s) + mu Phi(mu / s)
    E[min(max(D, 0), w)] = I(w) - I(0),  I(x) = (x - mu) Phi((mu - x) / s) - s phi((x - mu) / s)

where I is an antiderivative of 1 - Phi. With s = 0 the gap is mu itself.

With both lognormal, D = mu + A - B has no closed form, but given B it has one: A is lognormal
again. So the values given B are summed over B's normal variable, by the trapezoidal rule, whose
error falls faster than any power of its step for functions that fade out like these.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from .delays import Delays
from .normal import ROOT_TAU, below, density

__all__ = ["Gap", "LognormalGap", "NormalGap", "gap_of"]

Floats = NDArray[np.float64]

FARTHEST = 9.0
"""Beyond so many standard deviations lies less than the last digit of 1."""
STEPS, FINE_STEPS = 721, 14_401
"""Of the trapezoidal rule; more where one delay nearly follows from the other."""
NEARLY_SURE = 0.1
SURE = 1e-6
"""A normal variable spread less than this, given another, follows from it."""


class Gap(Protocol):
    """By how much one comes later than another."""

    @property
    def mean_s(self) -> float:
        """Mean [s]."""
        ...

    @property
    def spread_s(self) -> float:
        """Standard deviation [s]."""
        ...

    @property
    def hazard_rises(self) -> bool:
        """Whether who has not come is the likelier to come now, the longer one has waited."""
        ...

    def by(self, at_s: float) -> float:
        """Return the chance that it is at most so much.

        Parameters
        ----------
        at_s : float
            How much [s].

        Returns
        -------
        float
            From 0 to 1.
        """
        ...

    def density(self, at_s: float) -> float:
        """Return the density of its distribution.

        Parameters
        ----------
        at_s : float
            Where [s].

        Returns
        -------
        float
            1/s.
        """
        ...

    def expected_wait_s(self, up_to_s: float = math.inf) -> float:
        """Return how long one who is there waits on average.

        Parameters
        ----------
        up_to_s : float
            After how long it gives up [s].

        Returns
        -------
        float
            Seconds.
        """
        ...

    def turned(self) -> Gap:
        """Return by how much the other comes later than the one.

        Returns
        -------
        Gap
            With the sign turned.
        """
        ...


@dataclass(frozen=True, slots=True)
class NormalGap:
    """A gap that is normally distributed.

    Attributes
    ----------
    mean_s, spread_s : float
        Mean and standard deviation [s].
    """

    mean_s: float
    spread_s: float

    @property
    def hazard_rises(self) -> bool:
        """Whether who has not come is the likelier to come now: always, under this one."""
        return True

    def by(self, at_s: float) -> float:
        """Return the chance that the gap is at most so much.

        Parameters
        ----------
        at_s : float
            How much [s]; may be infinite.

        Returns
        -------
        float
            From 0 to 1.
        """
        if not self.spread_s:
            return float(self.mean_s <= at_s)
        return below((at_s - self.mean_s) / self.spread_s)

    def density(self, at_s: float) -> float:
        """Return the density of the gap.

        Parameters
        ----------
        at_s : float
            Where [s].

        Returns
        -------
        float
            1/s; 0 for a gap without spread, which has none.
        """
        if not self.spread_s:
            return 0.0
        return density((at_s - self.mean_s) / self.spread_s) / self.spread_s

    def expected_wait_s(self, up_to_s: float = math.inf) -> float:
        """Return how long one who is there waits on average.

        Parameters
        ----------
        up_to_s : float
            After how long it gives up [s].

        Returns
        -------
        float
            Seconds.
        """
        if not self.spread_s:
            return min(max(self.mean_s, 0.0), up_to_s)
        whole = 0.0 if math.isinf(up_to_s) else self._integral(up_to_s)
        return max(whole - self._integral(0.0), 0.0)

    def turned(self) -> NormalGap:
        """Return by how much the other comes later than the one.

        Returns
        -------
        NormalGap
            With the mean of the other sign.
        """
        return NormalGap(-self.mean_s, self.spread_s)

    def _integral(self, at_s: float) -> float:
        off = (at_s - self.mean_s) / self.spread_s
        return self.spread_s * (off * below(-off) - density(off))


@dataclass(frozen=True, slots=True)
class LognormalGap:
    """The gap of two whose delays are lognormal.

    Attributes
    ----------
    planned_s : float
        The gap by the timetable [s].
    late_s, there_s : float
        Median delay of who is awaited and of who is there [s]; 0 for one who is never late.
    correlation : float
        Of the logarithms of their delays.
    shape : float
        Standard deviation of these.
    """

    planned_s: float
    late_s: float
    there_s: float
    correlation: float = 0.0
    shape: float = 1.0

    @property
    def mean_s(self) -> float:
        """Mean [s]."""
        return self.planned_s + (self.late_s - self.there_s) * math.exp(self.shape**2 / 2)

    @property
    def spread_s(self) -> float:
        """Standard deviation [s]."""
        square = self.shape**2
        own = (self.late_s**2 + self.there_s**2) * math.expm1(square)
        both = 2 * self.late_s * self.there_s * math.expm1(self.correlation * square)
        return math.sqrt(max(own - both, 0.0) * math.exp(square))

    @property
    def hazard_rises(self) -> bool:
        """Whether who has not come is the likelier to come now: not under this one."""
        return False

    def by(self, at_s: float) -> float:
        """Return the chance that the gap is at most so much.

        Parameters
        ----------
        at_s : float
            How much [s]; may be infinite.

        Returns
        -------
        float
            From 0 to 1.
        """
        if math.isinf(at_s):
            return float(at_s > 0)
        return self._given(lambda late: late.by(at_s))

    def density(self, at_s: float) -> float:
        """Return the density of the gap.

        Parameters
        ----------
        at_s : float
            Where [s].

        Returns
        -------
        float
            1/s.
        """
        return self._given(lambda late: late.density(at_s))

    def expected_wait_s(self, up_to_s: float = math.inf) -> float:
        """Return how long one who is there waits on average.

        Parameters
        ----------
        up_to_s : float
            After how long it gives up [s].

        Returns
        -------
        float
            Seconds.
        """
        return self._given(lambda late: late.capped(up_to_s) - late.capped(0.0))

    def turned(self) -> LognormalGap:
        """Return by how much the other comes later than the one.

        Returns
        -------
        LognormalGap
            With both exchanged.
        """
        return LognormalGap(
            -self.planned_s, self.there_s, self.late_s, self.correlation, self.shape
        )

    def _given(self, value: Callable[[_Late], Floats]) -> float:
        """Return the mean of a value over the delay of who is there."""
        if not self.there_s:
            return float(value(_Late(np.array([self.planned_s]), self._late(0.0), self.shape))[0])
        rest = math.sqrt(max(1 - self.correlation**2, 0.0))
        z = np.linspace(-FARTHEST, FARTHEST, STEPS if rest > NEARLY_SURE else FINE_STEPS)
        spread = self.shape * max(rest, SURE)
        given = _Late(
            self.planned_s - self.there_s * np.exp(self.shape * z),
            self._late(self.correlation * self.shape * z),
            spread,
        )
        weight = np.exp(-0.5 * z * z) / ROOT_TAU * (z[1] - z[0])
        return float((weight * value(given)).sum() / weight.sum())

    def _late(self, log: Floats | float) -> Floats:
        """Return the logarithm of the median delay of who is awaited; -inf if it has none."""
        if not self.late_s:
            return np.full_like(np.atleast_1d(np.asarray(log, np.float64)), -np.inf)
        return np.atleast_1d(math.log(self.late_s) + np.asarray(log, np.float64))


@dataclass(frozen=True, slots=True, eq=False)
class _Late:
    """Gaps that are lognormal but for a shift: base + exp(log + spread Z), one for each entry."""

    base: Floats
    log: Floats
    spread: float

    def by(self, at_s: float) -> Floats:
        from scipy.special import ndtr

        delay = at_s - self.base
        found: Floats = np.where(delay < 0, 0.0, ndtr(self._off(delay)))
        return found

    def density(self, at_s: float) -> Floats:
        delay = at_s - self.base
        off = self._off(delay)
        with np.errstate(divide="ignore", invalid="ignore"):
            found = np.exp(-0.5 * off * off) / (ROOT_TAU * self.spread * delay)
        return np.where((delay > 0) & np.isfinite(off), found, 0.0)

    def capped(self, at_s: float) -> Floats:
        """Return E[min(D, at)], but for a constant: base + E[min(delay, at - base)]."""
        from scipy.special import ndtr

        # E[min(A, x)] = E[A] Phi((ln x - m) / q - q) + x (1 - Phi((ln x - m) / q))
        mean = np.exp(self.log + self.spread**2 / 2)
        if math.isinf(at_s):
            return self.base + mean
        delay = at_s - self.base
        off = self._off(delay)
        part = mean * ndtr(off - self.spread) + delay * ndtr(-off)
        return self.base + np.where(delay > 0, part, delay)

    def _off(self, delay: Floats) -> Floats:
        with np.errstate(divide="ignore", invalid="ignore"):
            off = (np.log(np.maximum(delay, 0.0)) - self.log) / self.spread
        # Who has no delay (its log is -inf) has come at 0.
        return np.where(np.isneginf(self.log), np.where(delay >= 0, np.inf, -np.inf), off)


def gap_of(delays: Delays, late: str, there: str, planned_s: float) -> Gap:
    """Return by how much one vehicle comes later than another.

    Parameters
    ----------
    delays : Delays
        How late vehicles may be.
    late, there : str
        Who is awaited, and who is there.
    planned_s : float
        By how much it comes later by the timetable [s]; negative if it comes first.

    Returns
    -------
    Gap
        As delays are: normal, or that of two lognormal ones.
    """
    correlation = delays.correlation_of(late, there)
    if delays.kind == "normal":
        own, other = delays.spread_s(late), delays.spread_s(there)
        square = own**2 + other**2 - 2 * correlation * own * other
        return NormalGap(planned_s, math.sqrt(max(square, 0.0)))
    return LognormalGap(
        planned_s, delays.median_s(late), delays.median_s(there), correlation, delays.shape
    )
