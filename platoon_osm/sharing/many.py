"""What any coalition of many vehicles could gain at most by itself, by one linear programme.

Vehicles drive planned stretches or stay at home. z_i in [0, 1] says how far i takes part; on the
stretch of company c, f_ci how far it follows and y_ck how far k leads, L_c and F_c being the sums
of both. With s what followers save, l what leaders save, o what a vehicle's own way costs more and
x its share,

    max  sum_c (sum_i s_ci f_ci + sum_k l_ck y_ck) - sum_i (o_i + x_i) z_i
    with f_ci + y_ci <= z_i,  L_c <= 1,  f_ci <= L_c - y_ci,  y_ci <= F_c - f_ci.

Every coalition is a point of it: one leads, the others follow, and where only one is there it does
neither. So nobody can gain more than its maximum, which is at least 0, as of nobody. Where leaders
save nothing and all of a company lose the same by leading, some best point is a coalition: with
less than the last condition the programme is to choose vehicles and, for each company that they
are in, one lead to pay, and its corners are whole numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError
from .company import CompanyGame

__all__ = ["most_to_gain"]

Floats = NDArray[np.float64]


def most_to_gain(
    companies: Sequence[tuple[Sequence[int], CompanyGame]], own: ArrayLike, shares: ArrayLike
) -> float:
    """Return a bound on what any coalition could gain by itself beyond its shares.

    Parameters
    ----------
    companies : sequence of (sequence of int, CompanyGame)
        The players of each company, in the order of its game.
    own : array_like of float, (n,)
        What each pays more on its way than alone, before anything is saved.
    shares : array_like of float, (n,)
        What each is to have.

    Returns
    -------
    float
        0 or more.

    Raises
    ------
    ScenarioError
        The programme has no answer.
    """
    from scipy.optimize import linprog
    from scipy.sparse import coo_array

    away = np.asarray(own, np.float64) + np.asarray(shares, np.float64)
    n = len(away)
    worth = [-away]
    rows: list[int] = []
    columns: list[int] = []
    entries: list[float] = []
    sums: list[tuple[int, range]] = []
    count, width = 0, n

    def at_most(smaller: tuple[int, ...], larger: int) -> None:
        nonlocal count
        rows.extend([count] * (len(smaller) + 1))
        columns.extend((*smaller, larger))
        entries.extend([1.0] * len(smaller) + [-1.0])
        count += 1

    for players, game in companies:
        size = len(game)
        if size < 2:
            continue
        # One column for L and F each, then those who lead, then those who follow.
        led, followed = width, width + 1
        leads = range(width + 2, width + 2 + size)
        follows = range(leads.stop, leads.stop + size)
        width = follows.stop
        worth += [np.zeros(2), game.lead, game.follow]
        for player, lead, follow in zip(players, leads, follows, strict=True):
            at_most((follow, lead), int(player))
            at_most((follow, lead), led)
            at_most((lead, follow), followed)
        sums += [(led, leads), (followed, follows)]
    if not sums:
        return float(np.maximum(worth[0], 0.0).sum())
    told = np.concatenate(worth)
    scale = float(np.abs(told).max()) or 1.0
    same = np.repeat(np.arange(len(sums)), [1 + len(parts) for _, parts in sums])
    where = [column for whole, parts in sums for column in (whole, *parts)]
    signs = [sign for _, parts in sums for sign in (-1.0, *[1.0] * len(parts))]
    many = {followed for followed, _ in sums[1::2]}
    bounds = [(0.0, np.inf if column in many else 1.0) for column in range(width)]
    # Stubs know arrays only; scipy takes sparse ones as well.
    at_most_rows: Any = coo_array((entries, (rows, columns)), shape=(count, width)).tocsr()
    sum_rows: Any = coo_array((signs, (same, where)), shape=(len(sums), width)).tocsr()
    answer = linprog(
        -told / scale,
        A_ub=at_most_rows,
        b_ub=np.zeros(count),
        A_eq=sum_rows,
        b_eq=np.zeros(len(sums)),
        bounds=bounds,
        method="highs",
    )
    if answer.fun is None:
        raise ScenarioError(f"sharing: no bound was found ({answer.message})")
    return max(-float(answer.fun) * scale, 0.0)
