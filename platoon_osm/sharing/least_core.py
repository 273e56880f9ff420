"""The least core: shares with which the coalition that could gain most by itself gains least.

A linear programme: least e with x(S) >= v(S) - e for every coalition S but nobody and everybody,
and x(N) = v(N). If e <= 0 the core is not empty, and x lies in it. A side condition may ask that
nobody be worse off, x_i >= 0. Many shares may have the same e; of them the one nearest to given
shares is taken, so that the answer is one and players alike get the same.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError
from .coalitions import members, players_of
from .nearest import nearest_meeting

__all__ = ["LeastCore", "least_core"]

Floats = NDArray[np.float64]

HAIR = 1e-7
"""Share of the largest value by which e is given room, so that nearest shares exist in numbers."""


@dataclass(frozen=True, slots=True, eq=False)
class LeastCore:
    """Shares of the least core.

    Attributes
    ----------
    shares : ndarray of float, (n,)
        Of the value of everybody.
    excess : float
        e: no shares that keep the conditions leave every coalition with less to gain by itself.
    prices : ndarray of float, (2^n,)
        The dual of the linear programme, which proves e: how much each coalition counts in it.
    """

    shares: Floats
    excess: float
    prices: Floats


def least_core(
    values: ArrayLike, near: ArrayLike | None = None, *, nobody_worse_off: bool = True
) -> LeastCore:
    """Return the shares of the least core that are nearest to given ones.

    Parameters
    ----------
    values : array_like of float, (2^n,)
        What each coalition is worth; see `platoon_osm.sharing.coalitions`.
    near : array_like of float, (n,), optional
        What to be near to; by default the same for each.
    nobody_worse_off : bool
        Whether no share may be negative.

    Returns
    -------
    LeastCore
        Shares and the proof.

    Raises
    ------
    ScenarioError
        A table that is none of values, too many players, or everybody together loses and yet nobody
        may be worse off.
    """
    from scipy.optimize import linprog

    table = np.asarray(values, np.float64)
    n = players_of(table)
    total = float(table[-1])
    if nobody_worse_off and total < 0:
        raise ScenarioError(
            f"sharing: everybody together has {total:g}; where all together lose, somebody is "
            "worse off"
        )
    prices = np.zeros(len(table))
    if n < 2:
        return LeastCore(np.full(n, total), 0.0, prices)
    scale = float(np.abs(table).max()) or 1.0
    inside = members(n)[1:-1].astype(np.float64)
    worth = table[1:-1] / scale
    low = 0.0 if nobody_worse_off else None
    answer = linprog(
        np.append(np.zeros(n), 1.0),
        A_ub=np.column_stack([-inside, -np.ones(len(inside))]),
        b_ub=-worth,
        A_eq=np.append(np.ones(n), 0.0)[None, :],
        b_eq=[total / scale],
        bounds=[(low, None)] * n + [(None, None)],
        method="highs",
    )
    if answer.x is None:
        raise ScenarioError(f"sharing: the least core was not found ({answer.message})")
    prices[1:-1] = -answer.ineqlin.marginals
    excess = float(answer.x[-1])
    # The same sum as asked for, wherever `near` adds up to.
    wish = np.zeros(n) if near is None else np.asarray(near, np.float64) / scale
    wish = wish + (total / scale - wish.sum()) / n
    rows = np.vstack([inside, np.eye(n)]) if nobody_worse_off else inside
    least = np.append(worth - excess - HAIR, np.full(len(rows) - len(inside), 0.0))
    shares = nearest_meeting(wish, rows, least)
    if nobody_worse_off:
        shares = np.maximum(shares, 0.0)
    return LeastCore(shares * scale, excess * scale, prices)
