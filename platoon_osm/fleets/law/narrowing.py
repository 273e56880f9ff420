"""Windows of lanes that leave time for breaks and rests, for a search that knows no law.

Who has driven x of its way has paused at least P(x), and who has y left to drive pauses at least
P(y) more: so a truck enters a lane by P(x) later, and has to by P(y) earlier. The pauses that lie
between two lanes are not asked for, so what is found need not be lawful yet.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ...planning.legal.legal_question import LegalQuestion
from ...planning.legal.platoon.star_times import VehicleRules
from ..instance import Instance
from ..lanes import TICK_S

__all__ = ["least_pauses", "narrowed"]

Floats = NDArray[np.float64]


def least_pauses(rules: VehicleRules, driven_s: Floats, driven_before_s: float) -> Floats:
    """Return about how long a driver pauses at least on some driving.

    Parameters
    ----------
    rules : VehicleRules
        The law, for one driver.
    driven_s : ndarray of float
        Driving times [s].
    driven_before_s : float
        What was driven before, since the last break and today [s].

    Returns
    -------
    ndarray of float
        Seconds.
    """
    limits = rules.limits
    whole = driven_s + driven_before_s
    rests = np.zeros(len(driven_s))
    day_s = min(limits.long_day_s, limits.window_s)
    if math.isfinite(day_s) and day_s > 0:
        rests = np.maximum(0.0, np.ceil(whole / day_s - 1e-9) - 1)
    breaks = np.zeros(len(driven_s))
    if math.isfinite(limits.spell_s) and limits.spell_s > 0:
        breaks = np.maximum(0.0, np.ceil(whole / limits.spell_s - 1e-9) - 1)
    rest_s = limits.reduced_rest_s if limits.reduced_rests else limits.rest_s
    least: Floats = np.maximum(0.0, breaks - rests) * limits.break_s + rests * rest_s
    return least


def narrowed(instance: Instance, legal: LegalQuestion) -> Instance:
    """Return an instance whose pairs have narrower windows.

    Parameters
    ----------
    instance : Instance
        The problem in the windows that were asked for.
    legal : LegalQuestion
        The law of its trucks.

    Returns
    -------
    Instance
        The same pairs; those that would be left without a window keep theirs.
    """
    opens, closes = instance.opens.copy(), instance.closes.copy()
    for k, rules in enumerate(legal.rules):
        own = slice(int(instance.first_pair[k]), int(instance.first_pair[k + 1]))
        before = (instance.opens[own] - instance.earliest[k]) * TICK_S
        after = (instance.latest[k] - instance.closes[own]) * TICK_S
        state = rules.state
        behind = max(state.driven_since_break_s, 0.0)
        late = np.ceil(least_pauses(rules, before, behind) / TICK_S).astype(np.int64)
        early = np.ceil(least_pauses(rules, after, 0.0) / TICK_S).astype(np.int64)
        first, last = opens[own] + late, closes[own] - early
        fits = first <= last
        opens[own] = np.where(fits, first, opens[own])
        closes[own] = np.where(fits, last, closes[own])
    return replace(instance, opens=opens, closes=closes)
