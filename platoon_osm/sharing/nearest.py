"""Of all shares that keep some conditions, those nearest to given ones, in least squares.

Nobody worse off. The point of {x >= 0, sum x = t} nearest to y is x_i = max(y_i - c, 0), with the c
for which the sum is right: sorted downwards, c = (y_1 + ... + y_k - t) / k for the largest k with
y_k > c.

Any linear conditions G x >= h (Lawson and Hanson 1974, least distance programming): with the
u >= 0 that comes nearest to [G' ; h'] u = (0, ..., 0, 1), and r the difference left, the x of least
norm is -r_j / r_(n+1). The answer is one point, so vehicles alike get the same.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError

__all__ = ["nearest_meeting", "none_worse_off"]

Floats = NDArray[np.float64]

SAME = 1e-9
"""Share of the largest number by which sums and conditions may be missed in the last digits."""

MOST_AT_ONCE = 8
"""Conditions added before it is solved again."""

LEAST_RESIDUAL = 1e-13
"""A square of what is left below it says that no point meets the conditions."""


def none_worse_off(shares: ArrayLike) -> Floats:
    """Return the nearest shares of the same sum of which none is negative.

    Parameters
    ----------
    shares : array_like of float, (n,)
        Of a total that is not negative.

    Returns
    -------
    ndarray of float, (n,)
        The same shares if none of them is negative.

    Raises
    ------
    ScenarioError
        The total is negative: somebody must be worse off.
    """
    own = np.array(shares, np.float64)
    if (own >= 0).all():
        return own
    total = float(own.sum())
    if total < -SAME * float(np.abs(own).max()):
        raise ScenarioError(
            f"sharing: the total is {total:g}; where all together lose, somebody is worse off"
        )
    total = max(total, 0.0)
    down = np.sort(own)[::-1]
    taken = (np.cumsum(down) - total) / np.arange(1, len(down) + 1)
    kept = int(np.flatnonzero(down - taken > 0)[-1]) if (down - taken > 0).any() else 0
    found: Floats = np.maximum(own - taken[kept], 0.0)
    return found


def nearest_meeting(shares: ArrayLike, conditions: ArrayLike, least: ArrayLike) -> Floats:
    """Return the nearest shares of the same sum that meet linear conditions.

    Parameters
    ----------
    shares : array_like of float, (n,)
        What to be near to.
    conditions : array_like of float, (k, n)
        G, one condition a row.
    least : array_like of float, (k,)
        h, what each row of G x must be at least.

    Returns
    -------
    ndarray of float, (n,)
        Unique.

    Raises
    ------
    ScenarioError
        No shares of this sum meet them.
    """
    from scipy.optimize import nnls

    own = np.asarray(shares, np.float64)
    rows = np.asarray(conditions, np.float64)
    short = np.asarray(least, np.float64) - rows @ own
    # Moves that keep the sum: coordinates in the plane at right angles to (1, ..., 1).
    plane = np.linalg.svd(np.ones((1, len(own))))[2][1:]
    scale = float(np.abs(short).max(initial=0.0))
    move = np.zeros(len(own))
    kept: list[int] = []
    # Few of many conditions decide: those that fail are added until none does.
    while len(kept) < len(short):
        failing = short - rows @ move
        failing[kept] = -np.inf
        if failing.max() <= SAME * scale:
            break
        worst = np.argsort(-failing, kind="stable")[:MOST_AT_ONCE]
        kept += worst[failing[worst] > SAME * scale].tolist()
        system = np.vstack([plane @ rows[kept].T, short[kept] / scale])
        target = np.append(np.zeros(len(plane)), 1.0)
        weights, _ = nnls(system, target)
        left = system @ weights - target
        if float(left @ left) < LEAST_RESIDUAL:
            raise ScenarioError("sharing: no shares of this sum meet all conditions")
        move = -scale * plane.T @ (left[:-1] / left[-1])
    found: Floats = own + move
    return found
