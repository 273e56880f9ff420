"""Driver fatigue as a function of consecutive driving time, eq. 6 to 9 of the paper.

The curves are bumps: they rise and fall again, and they do not add up over edges. So fatigue is
never an edge weight here; it is evaluated on the driving clock of a whole journey.

References
----------
.. [1] Adas et al., "Joint travel route optimization", IFAC 2025, after Zhang et al. 2019.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError, brief
from ..kinds import is_number

__all__ = [
    "FITTED_RANGE_S", "PERIODS", "FatigueForm", "FatigueModel", "Period", "driving_clock",
    "fatigue_curve", "fatigue_heuristic",
]  # fmt: skip

FatigueForm = Literal["as_printed", "by_period", "monotone"]
Period = Literal["morning", "afternoon", "night"]
Floats = NDArray[np.float64]

# alpha, beta [s], epsilon [s] of each Gaussian, table of [1]_. Night repeats the two terms of the
# afternoon, as printed there.
_MORNING = ((60.83, 8834.0, 4760.0),)
_AFTERNOON = ((22.1, 9675.0, 6142.0), (92.1, 13820.0, 6358.0))
_NIGHT = ((2.599, 5046.0, 1257.0), (92.1, 13820.0, 6358.0), (22.1, 9675.0, 6142.0))
PERIODS: dict[str, tuple[tuple[float, float, float], ...]] = {
    "morning": _MORNING, "afternoon": _AFTERNOON, "night": _NIGHT,
}  # fmt: skip

FITTED_RANGE_S = (0.0, 16200.0)
"""Driving times the curves can speak for: up to 4 h 30, the longest legal spell without a break."""

GRID_S = 30.0
"""How finely the running maximum looks between the moments it is asked for."""

RATES = {"solo": 1.0, "platoon": 1.0, "wait": 0.0, "break": 0.0}
"""How fast the driving clock runs in each role, before a follower's task is relieved."""

PHI = 96.06
"""Inflation of the paper's heuristic, eq. 10 of [1]_."""


def fatigue_curve(driving_s: ArrayLike, period: Period) -> Floats:
    """Return fatigue after some time of consecutive driving, eq. 6, 7 or 8 of [1]_.

    Parameters
    ----------
    driving_s : array_like of float
        Consecutive driving time [s].
    period : {"morning", "afternoon", "night"}
        Of the day: eq. 6, 7 or 8.

    Returns
    -------
    ndarray of float
        Fatigue, of the shape of `driving_s`.

    Raises
    ------
    ScenarioError
        A period that is none.

    References
    ----------
    .. [1] Adas et al., "Joint travel route optimization", IFAC 2025, after Zhang et al. 2019.
    """
    if period not in PERIODS:
        raise ScenarioError(f"period {brief(period)} is unknown; use {', '.join(PERIODS)}")
    t = np.asarray(driving_s, np.float64)
    value = np.zeros_like(t)
    for alpha, beta, epsilon in PERIODS[period]:
        value = value + alpha * np.exp(-(((t - beta) / epsilon) ** 2))
    return value


def _printed(driving_s: Floats) -> Floats:
    return (
        fatigue_curve(driving_s, "morning")
        + fatigue_curve(driving_s, "afternoon")
        + fatigue_curve(driving_s, "night")
    )


@dataclass(frozen=True, slots=True)
class FatigueModel:
    """How to read the paper's curves.

    Attributes
    ----------
    form : {"as_printed", "by_period", "monotone"}
        "as_printed" is the sum of the three curves (eq. 9); "by_period" the curve of the time of
        day; "monotone" the running maximum of the sum: a driver does not recover by driving on.
    task_relief : float
        How much a follower's driving clock slows, [0, 1]: 1 stops it (the paper), 0 lets it run
        (EU law today).
    """

    form: FatigueForm = "monotone"
    task_relief: float = 1.0

    def __post_init__(self) -> None:
        if not isinstance(self.form, str) or self.form not in get_args(FatigueForm):
            raise ScenarioError(
                f"fatigue form {brief(self.form)} is unknown; use as_printed, by_period or monotone"
            )
        _check_relief(self.task_relief)

    def along(self, clock_s: ArrayLike, hour_of_day: ArrayLike | None = None) -> Floats:
        """Return fatigue along a journey.

        Parameters
        ----------
        clock_s : array_like of float, (k,)
            Driving clock at k moments in order [s].
        hour_of_day : array_like of float, (k,), optional
            Local time of those moments [h], needed by "by_period".

        Returns
        -------
        ndarray of float, (k,)
            Fatigue at those moments.

        Raises
        ------
        ScenarioError
            A moment that is not finite, or no hours of the day where they are needed.

        Warns
        -----
        UserWarning
            If the clock leaves the range the curves were fitted for.
        """
        clock = _moments("the driving clock", clock_s)
        if not np.isfinite(clock).all():
            raise ScenarioError("fatigue: the driving clock has a moment that is not finite")
        if clock.size and (clock.min() < FITTED_RANGE_S[0] or clock.max() > FITTED_RANGE_S[1]):
            warnings.warn(
                f"fatigue: driving clock reaches {clock.max() / 3600:.1f} h, the curves hold up to "
                f"{FITTED_RANGE_S[1] / 3600:.1f} h",
                stacklevel=2,
            )
        if self.form == "by_period":
            if hour_of_day is None:
                raise ScenarioError("fatigue by_period needs the hour of day of each moment")
            period = period_of_day(_moments("the hours of day", hour_of_day))
            if period.shape != clock.shape:
                raise ScenarioError(
                    f"fatigue: {period.size} hours of day and {clock.size} moments; give one for "
                    "each"
                )
            curves = [fatigue_curve(clock, name) for name in ("morning", "afternoon", "night")]
            return np.choose(period, curves)
        printed = _printed(clock)
        if self.form == "as_printed":
            return printed
        # The maximum over all driving so far, so that few moments give the same as many.
        grid = np.arange(0.0, max(float(clock.max(initial=0.0)), 0.0) + GRID_S, GRID_S)
        so_far = np.maximum.accumulate(_printed(grid))
        before = np.maximum(printed, so_far[np.maximum(clock // GRID_S, 0).astype(np.int64)])
        # After a break the clock, and the maximum with it, begins anew.
        spells = np.split(before, np.flatnonzero(np.diff(clock) < 0) + 1)
        running: Floats = np.concatenate([np.maximum.accumulate(spell) for spell in spells])
        return running


def _moments(label: str, values: ArrayLike) -> Floats:
    try:
        moments = np.asarray(values, np.float64)
    except (TypeError, ValueError):
        moments = np.zeros((0, 0))
    if moments.ndim != 1:
        raise ScenarioError(f"fatigue: {label} {brief(values)} must be a list of numbers")
    return moments


def _check_relief(task_relief: float) -> None:
    if not (is_number(task_relief) and 0 <= task_relief <= 1):
        raise ScenarioError(f"task_relief = {brief(task_relief)} must be a number in [0, 1]")


def period_of_day(hour: ArrayLike) -> NDArray[np.int64]:
    """Return 0 for morning (6 to 12 h), 1 for afternoon (12 to 20 h), 2 for night.

    Parameters
    ----------
    hour : array_like of float
        Hours of the day.

    Returns
    -------
    ndarray of int
        Of the shape of `hour`.
    """
    h = np.asarray(hour, np.float64) % 24
    return np.where((h >= 6) & (h < 12), 0, np.where((h >= 12) & (h < 20), 1, 2)).astype(np.int64)


def driving_clock(
    legs: Iterable[tuple[str, float]], task_relief: float, step_s: float = 300.0
) -> tuple[Floats, Floats]:
    """Return moments of a journey and the driving clock at each.

    Parameters
    ----------
    legs : iterable of tuple of str and float
        Role and duration [s] in order: "solo"; "platoon", in which the clock runs at
        1 - task_relief; "wait", in which it stands; "break", in which it stands and after which it
        runs from 0.
    task_relief : float
        How much a follower's clock slows, [0, 1].
    step_s : float
        Moments are at most this far apart [s].

    Returns
    -------
    time_s : ndarray of float, (k,)
        From 0 to the journey's end [s].
    clock_s : ndarray of float, (k,)
        The driving clock [s]; at the end of a break twice, before and after.

    Raises
    ------
    ScenarioError
        A role, duration, step or relief that cannot be.
    """
    _check_relief(task_relief)
    if not step_s > 0:
        raise ScenarioError(f"step_s = {brief(step_s)} must be above 0")
    times, clocks = [0.0], [0.0]
    for role, seconds in legs:
        if role not in RATES:
            raise ScenarioError(f"leg role {brief(role)} is unknown; use {', '.join(RATES)}")
        if not 0 <= seconds < np.inf:
            raise ScenarioError(
                f"leg of {brief(seconds)} s: a driving time is finite and 0 or more"
            )
        rate = RATES[role] - task_relief * (role == "platoon")
        count = max(1, int(np.ceil(seconds / step_s)))
        for _ in range(count):
            times.append(times[-1] + seconds / count)
            clocks.append(clocks[-1] + rate * seconds / count)
        if role == "break":
            times.append(times[-1])
            clocks.append(0.0)
    return np.array(times), np.array(clocks)


def fatigue_heuristic(distance_m: ArrayLike, master_cost: float, speed_mps: float) -> Floats:
    """Return the paper's inflated A* heuristic phi * C_master * F(t), eq. 10 of [1]_.

    It is not admissible: it exceeds the cost that remains by orders of magnitude, so A* with it
    is a greedy search, and its answers are not optimal.

    Parameters
    ----------
    distance_m : array_like of float
        Great-circle distance from each node to the goal [m].
    master_cost : float
        Travel cost of the master vehicle.
    speed_mps : float
        Cruising speed, for the estimated time t [m/s].

    Returns
    -------
    ndarray of float
        Of the shape of `distance_m`.

    References
    ----------
    .. [1] Adas et al., "Joint travel route optimization", IFAC 2025.
    """
    estimated_s = np.asarray(distance_m, np.float64) / speed_mps
    return PHI * master_cost * _printed(estimated_s)
