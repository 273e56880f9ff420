"""The Shapley value of any game of a few players, over all coalitions.

phi_i is the mean, over all orders in which players may arrive, of what i adds to those before it.
The players S come before i in |S|! (n - |S| - 1)! of the n! orders.
"""

from __future__ import annotations

from math import factorial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .coalitions import members, players_of

__all__ = ["shapley_value"]

Floats = NDArray[np.float64]


def shapley_value(values: ArrayLike) -> Floats:
    """Return the Shapley value.

    Parameters
    ----------
    values : array_like of float, (2^n,)
        What each coalition is worth; see `platoon_osm.sharing.coalitions`.

    Returns
    -------
    ndarray of float, (n,)
        Shares that add up to the value of everybody.

    Raises
    ------
    ScenarioError
        A table that is none of values, or too many players.
    """
    table = np.asarray(values, np.float64)
    n = players_of(table)
    inside = members(n)
    size = inside.sum(axis=1)
    weight = np.array([factorial(k) * factorial(n - k - 1) / factorial(n) for k in range(n)])
    shares = np.zeros(n)
    for player in range(n):
        without = np.flatnonzero(~inside[:, player])
        added = table[without | 1 << player] - table[without]
        shares[player] = float((weight[size[without]] * added).sum())
    return shares
