"""A meeting drawn at random many times, with a seed: what chances and waits come out by counting.

Nothing of it uses the formulas of `gaps.py`; so each can be checked by the other.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from ..kinds import is_whole
from .delays import Delays

__all__ = ["MeetingsDrawn", "check_runs", "simulated"]

MOST_RUNS = 10_000_000
"""More draws than this fill the memory and tell no more."""


@dataclass(frozen=True, slots=True, eq=False)
class MeetingsDrawn:
    """What came of drawing a meeting many times.

    Attributes
    ----------
    gaps_s : ndarray of float, (runs,)
        By how much the one came later than the other [s].
    wait_s : float
        After how long who was there gave up [s].
    """

    gaps_s: NDArray[np.float64]
    wait_s: float

    @property
    def chance(self) -> float:
        """How often they met."""
        return float(np.mean(self.gaps_s <= self.wait_s))

    @property
    def chance_error(self) -> float:
        """Standard error of that."""
        share = self.chance
        return math.sqrt(share * (1 - share) / len(self.gaps_s))

    @property
    def expected_wait_s(self) -> float:
        """How long who was there waited on average [s]."""
        return float(np.mean(self._waits()))

    @property
    def wait_error_s(self) -> float:
        """Standard error of that [s]."""
        return float(np.std(self._waits()) / math.sqrt(len(self.gaps_s)))

    def value(self, gain: float, price: float) -> float:
        """Return what waiting gained on average, against going at once.

        Parameters
        ----------
        gain : float
            What is gained if they meet.
        price : float
            Of a second's waiting, in the same unit.

        Returns
        -------
        float
            In that unit.
        """
        late = (self.gaps_s > 0) & (self.gaps_s <= self.wait_s)
        return float(gain * np.mean(late) - price * np.mean(self._waits()))

    def _waits(self) -> NDArray[np.float64]:
        return np.clip(self.gaps_s, 0.0, self.wait_s)


def simulated(
    delays: Delays,
    late: str,
    there: str,
    planned_s: float = 0.0,
    wait_s: float = math.inf,
    *,
    runs: int = 100_000,
    seed: int = 0,
) -> MeetingsDrawn:
    """Draw a meeting of two vehicles many times.

    Parameters
    ----------
    delays : Delays
        How late vehicles may be.
    late, there : str
        Who is awaited, and who waits.
    planned_s : float
        By how much the one comes later by the timetable [s].
    wait_s : float
        After how long the other gives up [s].
    runs : int
        How many draws.
    seed : int
        Of numpy's generator.

    Returns
    -------
    MeetingsDrawn
        The same for the same seed.

    Raises
    ------
    ScenarioError
        No runs, a seed that is none, or correlations that cannot be.
    """
    check_runs(runs, seed)
    drawn = delays.draws((late, there), runs, seed)
    return MeetingsDrawn(planned_s + drawn[:, 0] - drawn[:, 1], wait_s)


def check_runs(runs: object, seed: object) -> None:
    """Check how often something is to be drawn, and with which seed.

    Parameters
    ----------
    runs, seed : object
        As users gave them.

    Raises
    ------
    ScenarioError
        Neither whole numbers of the right size.
    """
    if not (is_whole(runs) and 1 <= runs <= MOST_RUNS):
        raise ScenarioError(f"runs is {brief(runs)}; give a whole number from 1 to {MOST_RUNS}")
    if not (is_whole(seed) and seed >= 0):
        raise ScenarioError(f"seed is {brief(seed)}; give a whole number, 0 or more")
