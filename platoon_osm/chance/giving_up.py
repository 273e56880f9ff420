"""How long to wait for a late member, and what to plan ahead for it.

Who waits up to w for somebody who comes D later, with G gained if they meet and c the price of a
second's waiting, gains by it

    V(w) = G P(0 < D <= w) - c E[min(max(D, 0), w)],   V'(w) = (1 - F(w)) (G h(w) - c),

with h = f / (1 - F) the hazard. Where the hazard rises, as under a normal delay, V first falls and
then rises, so the best wait is nothing or all that the window W allows: all of it iff
G P(0 < D <= W) >= c E[min(max(D, 0), W)]. Under a lognormal one the hazard rises and falls again,
so the best wait is nothing, all, or up to where G h(w) = c on the falling branch.

Ahead of time, a platoon that leaves b after the mean of a normal arrival costs c b whatever happens
and meets with the chance Phi(b / s). G Phi(b / s) - c b is greatest at

    b = s sqrt(2 ln(G / (c s sqrt(2 pi))))

if the argument of the logarithm exceeds 1, which is when it still rises at b = 0; otherwise at 0.
A member that aims to be there y early loses G if it is late and pays c for its own wait alone;
G F(y) - c E[max(y - X, 0)] is greatest where G f(y) = c F(y).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from .gaps import Gap
from .normal import ROOT_TAU, below, density

__all__ = [
    "buffer_ahead_s",
    "counted_wait_s",
    "early_start_s",
    "last_to_come_s",
    "value_of_waiting",
    "wait_up_to_s",
]

PLACES = 120
"""Places at which the sign of V' is looked at where its hazard may fall."""
HALVINGS = 60
"""Of an interval, until its ends are the same to the last digits."""
FARTHEST = 40.0
"""A gap is not more than so many spreads beyond its mean, but with the least of chances."""
NEVER = 1e-10
"""Who comes later with a chance below this does not come."""
LEAST_OFF, MOST_OFF = -40.0, 12.0
"""Between them, in standard deviations, lies any early start that can be told from none or all."""


def value_of_waiting(gap: Gap, wait_s: float, gain: float, price: float) -> float:
    """Return what is gained on average by waiting up to some time, against going at once.

    Parameters
    ----------
    gap : Gap
        By how much the other comes later.
    wait_s : float
        When to give up [s].
    gain : float
        What is gained if they meet.
    price : float
        Of a second's waiting, in the same unit.

    Returns
    -------
    float
        V of the module's text, in that unit.
    """
    return gain * (gap.by(wait_s) - gap.by(0.0)) - price * gap.expected_wait_s(wait_s)


def wait_up_to_s(gap: Gap, window_s: float, gain: float, price: float) -> float:
    """Return how long it is best to wait for somebody who is late.

    Parameters
    ----------
    gap : Gap
        By how much the other comes later.
    window_s : float
        How long one can wait at most [s].
    gain : float
        What is gained if they meet.
    price : float
        Of a second's waiting, in the same unit; where it is 0 all of the window is waited.

    Returns
    -------
    float
        From 0 to `window_s` [s].
    """
    if gain <= 0 or window_s <= 0:
        return 0.0
    if price <= 0:
        return window_s
    found = [0.0, window_s]
    if not gap.hazard_rises:
        found += _peaks(gap, window_s, gain, price)
    # Of equally good waits the longest: who may as well wait does.
    return max(sorted(found, reverse=True), key=lambda w: value_of_waiting(gap, w, gain, price))


def last_to_come_s(gap: Gap, window_s: float) -> float:
    """Return from when on nobody comes any more who comes within a window.

    Parameters
    ----------
    gap : Gap
        By how much the other comes later.
    window_s : float
        How long one can wait at most [s].

    Returns
    -------
    float
        From 0 to `window_s` [s]; waiting longer is worth nothing.
    """
    most = gap.by(window_s) - NEVER
    if gap.by(0.0) >= most:
        return 0.0
    low, high = 0.0, window_s
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if gap.by(middle) >= most else (middle, high)
    return high


def _peaks(gap: Gap, window_s: float, gain: float, price: float) -> list[float]:
    """Return where V stops rising inside the window."""
    end = min(window_s, max(gap.mean_s, 0.0) + FARTHEST * gap.spread_s)

    def rises(at: float) -> bool:
        return gain * gap.density(at) > price * (1 - gap.by(at))

    # Denser near 0, where a lognormal hazard has its peak.
    places = [end * (k / PLACES) ** 2 for k in range(1, PLACES + 1)]
    signs = [rises(at) for at in places]
    found = []
    for k in range(PLACES - 1):
        if signs[k] and not signs[k + 1]:
            low, high = places[k], places[k + 1]
            for _ in range(HALVINGS):
                middle = (low + high) / 2
                low, high = (middle, high) if rises(middle) else (low, middle)
            found.append(low)
    return found


def counted_wait_s(
    gaps_s: NDArray[np.float64], window_s: float, gain: float, price: float
) -> float:
    """Return how long it would have been best to wait on days that were drawn.

    Parameters
    ----------
    gaps_s : ndarray of float, (runs,)
        By how much the other came later [s].
    window_s : float
        How long one can wait at most [s].
    gain : float
        What is gained if they meet.
    price : float
        Of a second's waiting, in the same unit.

    Returns
    -------
    float
        From 0 to `window_s` [s]; the same for all days.
    """
    if gain <= 0 or window_s <= 0:
        return 0.0
    if price <= 0:
        return window_s
    inside = gaps_s[(gaps_s > 0) & (gaps_s <= window_s)]
    # Between two of the days drawn waiting costs and nobody comes, so one of these is best.
    # Nobody is waited for longer than the last who comes.
    waits = np.unique(np.concatenate([[0.0], inside]))
    ordered = np.sort(gaps_s)
    sums = np.concatenate([[0.0], np.cumsum(np.maximum(ordered, 0.0))])
    met = np.searchsorted(ordered, waits, side="right")
    waited = sums[met] + waits * (len(ordered) - met)
    values = gain * met - price * waited
    # Of equally good waits the longest, as in closed form.
    return float(waits[len(waits) - 1 - int(np.argmax(values[::-1]))])


def buffer_ahead_s(spread_s: float, gain: float, price: float) -> float:
    """Return how long after the mean of an arrival a platoon is best planned to leave.

    Parameters
    ----------
    spread_s : float
        Standard deviation of the normal gap [s].
    gain : float
        What is gained if they meet.
    price : float
        Of a second of the buffer for all who wait, in the same unit; above 0.

    Returns
    -------
    float
        0 if no buffer is better than the best [s].
    """
    if spread_s <= 0 or gain <= 0 or price <= 0:
        return 0.0
    argument = gain / (price * spread_s * ROOT_TAU)
    if argument <= 1:
        return 0.0
    return spread_s * math.sqrt(2 * math.log(argument))


def early_start_s(spread_s: float, gain: float, price: float, most_s: float) -> float:
    """Return how much before the others a member best aims to be there.

    Parameters
    ----------
    spread_s : float
        Standard deviation of the normal gap [s].
    gain : float
        What is lost if it is late.
    price : float
        Of a second of its own waiting, in the same unit.
    most_s : float
        How early it can be [s].

    Returns
    -------
    float
        At most `most_s` [s]; negative where waiting is so dear that it better aims to be late.
    """
    if price <= 0:
        return most_s if gain > 0 else 0.0
    if spread_s <= 0 or gain <= 0:
        return 0.0
    level = price * spread_s / gain
    low, high = LEAST_OFF, MOST_OFF
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        # phi / Phi falls, so the root is where it meets the level.
        under = density(middle) > level * below(middle)
        low, high = (middle, high) if under else (low, middle)
    return min(low * spread_s, most_s)
