"""Round steps of scales: of numbers, and of hours of the clock."""

from __future__ import annotations

import math

from ...plans.clock import Clock

__all__ = ["MOST_HOURS", "hour_ticks", "round_below", "round_step"]

MOST_HOURS = 7
"""Ticks of a clock that can be read beside one another."""

STEPS_H = (0.25, 0.5, 1, 2, 3, 4, 6, 12, 24, 48, 96, 168, 336, 672)


def round_step(least: float) -> float:
    """Return the least of 1, 2, 5, 10, 20, ... and their tenths that is no less than a number.

    Parameters
    ----------
    least : float
        0 or more.

    Returns
    -------
    float
        The step.
    """
    power = 10.0 ** math.floor(math.log10(max(least, 1e-9)))
    return next(k * power for k in (1, 2, 5, 10) if k * power >= least * (1 - 1e-9))


def round_below(most: float) -> float:
    """Return the greatest of 1, 2, 5, 10, 20, ... and their tenths that is no more than a number.

    Parameters
    ----------
    most : float
        More than 0.

    Returns
    -------
    float
        The number.
    """
    power = 10.0 ** math.floor(math.log10(most))
    return max(k * power for k in (1, 2, 5) if k * power <= most)


def hour_ticks(
    clock: Clock, begin_s: float, end_s: float, most: int = MOST_HOURS
) -> list[tuple[float, str]]:
    """Return whole hours, or parts of one, within a span, few enough to be read.

    Parameters
    ----------
    clock : Clock
        What turns seconds into times of day.
    begin_s, end_s : float
        The span, in seconds of that clock.
    most : int
        That can be read beside one another.

    Returns
    -------
    list of tuple of float and str
        Each moment [s] and its time of day.
    """
    hours = (end_s - begin_s) / 3600
    least = math.ceil(hours / (24 * most)) * 24
    step = next((h for h in STEPS_H if hours / h <= most), least) * 3600
    moments: list[float] = []
    for begin, end, ahead in clock.spells(begin_s, end_s):
        midnight = clock.since_midnight_s + ahead
        first = math.ceil((midnight + begin) / step - 1e-9)
        last = math.floor((midnight + end) / step + 1e-9)
        # When clocks change, the hour belongs to what begins then.
        found = (k * step - midnight for k in range(first, last + 1))
        moments += [at for at in found if at < end or end == end_s]
    return [(moment, clock.text(moment)) for moment in moments]
