"""What any coalition of many vehicles could gain at most by itself, by one linear programme.

Vehicles drive planned stretches or stay at home. z_i in [0, 1] says how far i takes part, L_c how
far company c has a leader, and y_ck that it is k. With s what followers save, d what a leader
loses, o what a vehicle's own way costs more and x its share,

    max  sum_c (sum_i s_ci z_i - sum_k d_ck y_ck) - sum_i (o_i + x_i) z_i
    with sum_k y_ck = L_c >= z_i for all i in c,  y_ck <= z_k.

Every coalition is a point of it with at least the value that it has: of one vehicle alone on a
stretch it says l = s - d instead of 0. So nobody can gain more than its maximum, which is at least
0, as of nobody. It is no more than the best coalition gains where leaders save nothing and all of a
company lose the same by leading: then its corners are whole numbers.
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
        The players of each company, in the order of its game. None may gain by leading rather than
        following.
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
        A vehicle that saves more as a leader than as a follower, or a programme without an answer.
    """
    from scipy.optimize import linprog
    from scipy.sparse import coo_array

    away = np.asarray(own, np.float64) + np.asarray(shares, np.float64)
    n = len(away)
    worth = [-away]
    rows: list[int] = []
    columns: list[int] = []
    entries: list[float] = []
    sums: list[tuple[int, range]] = []  # the column of L, and those of its leaders
    count, width = 0, n

    def at_most(larger: int, smaller: int) -> None:
        nonlocal count
        rows.extend((count, count))
        columns.extend((smaller, larger))
        entries.extend((1.0, -1.0))
        count += 1

    for players, game in companies:
        if len(game) < 2:
            continue
        if (game.losses < 0).any():
            raise ScenarioError(
                "sharing: a vehicle saves more as leader than as follower; for many vehicles no "
                "bound is known then"
            )
        at = np.asarray(players, np.int64)
        np.add.at(worth[0], at, game.follow)
        led, leaders = width, range(width + 1, width + 1 + len(at))
        width += 1 + len(at)
        worth += [np.zeros(1), -game.losses]
        for player, leader in zip(at.tolist(), leaders, strict=True):
            at_most(led, player)
            at_most(player, leader)
        sums.append((led, leaders))
    if not sums:
        return float(np.maximum(worth[0], 0.0).sum())
    told = np.concatenate(worth)
    scale = float(np.abs(told).max()) or 1.0
    same = np.repeat(np.arange(len(sums)), [1 + len(leaders) for _, leaders in sums])
    where = [column for led, leaders in sums for column in (led, *leaders)]
    signs = [sign for _, leaders in sums for sign in (-1.0, *[1.0] * len(leaders))]
    # Stubs know arrays only; scipy takes sparse ones as well.
    at_most_rows: Any = coo_array((entries, (rows, columns)), shape=(count, width)).tocsr()
    sum_rows: Any = coo_array((signs, (same, where)), shape=(len(sums), width)).tocsr()
    answer = linprog(
        -told / scale,
        A_ub=at_most_rows,
        b_ub=np.zeros(count),
        A_eq=sum_rows,
        b_eq=np.zeros(len(sums)),
        bounds=(0, 1),
        method="highs",
    )
    if answer.fun is None:
        raise ScenarioError(f"sharing: no bound was found ({answer.message})")
    return max(-float(answer.fun) * scale, 0.0)
