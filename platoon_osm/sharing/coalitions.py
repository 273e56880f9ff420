"""All coalitions of a few players in one table: position S holds the value of the players in S.

A coalition is a whole number whose bit i says whether player i is in it, so 0 is nobody and
2^n - 1 is everybody.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError

__all__ = [
    "MOST_PLAYERS", "best_part", "members", "players_of", "shares_of_coalitions",
    "superadditive_cover",
]  # fmt: skip

Floats = NDArray[np.float64]

MOST_PLAYERS = 12
"""Beyond it a table of all coalitions, 4,096 of them here, is too long to be worked through."""


def members(players: int) -> NDArray[np.bool_]:
    """Return who is in each coalition.

    Parameters
    ----------
    players : int
        How many there are.

    Returns
    -------
    ndarray of bool, (2^n, n)
        Row S marks the players of coalition S.

    Raises
    ------
    ScenarioError
        More players than a table can hold.
    """
    if players > MOST_PLAYERS:
        raise ScenarioError(
            f"sharing: {players} players have too many coalitions to try one by one; at most "
            f"{MOST_PLAYERS} can be"
        )
    marked: NDArray[np.bool_] = (np.arange(1 << players)[:, None] >> np.arange(players)) & 1 == 1
    return marked


def players_of(values: ArrayLike) -> int:
    """Return how many players a table of values is about.

    Parameters
    ----------
    values : array_like of float, (2^n,)
        What each coalition is worth.

    Returns
    -------
    int
        n.

    Raises
    ------
    ScenarioError
        A table of another length, of numbers that are not finite, or one in which nobody gains.
    """
    table = np.asarray(values, np.float64)
    players = max(table.size.bit_length() - 1, 0)
    if table.shape != (1 << players,):
        raise ScenarioError(
            f"sharing: values of {table.size} coalitions; n players have 2^n, nobody among them"
        )
    if not np.isfinite(table).all() or table[0] != 0:
        raise ScenarioError("sharing: values must be finite, and that of nobody 0")
    return players


def shares_of_coalitions(shares: ArrayLike) -> Floats:
    """Return what the members of each coalition have together.

    Parameters
    ----------
    shares : array_like of float, (n,)
        What each player has.

    Returns
    -------
    ndarray of float, (2^n,)
        Sums.
    """
    own = np.asarray(shares, np.float64)
    total: Floats = members(len(own)) @ own
    return total


def best_part(values: ArrayLike) -> Floats:
    """Return what coalitions are worth if members may stay out, which is worth nothing.

    Parameters
    ----------
    values : array_like of float, (2^n,)
        What each coalition is worth if all take part.

    Returns
    -------
    ndarray of float, (2^n,)
        The largest value of a part of each coalition, nobody being one.
    """
    best = np.array(values, np.float64)
    for player in range(players_of(best)):
        pairs = best.reshape(-1, 2, 1 << player)  # without the player, and with it
        np.maximum(pairs[:, 1], pairs[:, 0], out=pairs[:, 1])
    return best


def superadditive_cover(values: ArrayLike) -> Floats:
    """Return what coalitions are worth if they may split into several, each by itself.

    Parameters
    ----------
    values : array_like of float, (2^n,)
        What each coalition is worth as one.

    Returns
    -------
    ndarray of float, (2^n,)
        The largest sum over all ways to split each coalition; superadditive.
    """
    own = np.asarray(values, np.float64)
    players_of(own)
    cover = own.copy()
    for whole in range(1, len(own)):
        first = whole & -whole  # the part that holds the first member is tried in every size
        rest = whole ^ first
        part = rest
        while part:
            part = (part - 1) & rest
            split = own[first | part] + cover[rest ^ part]
            cover[whole] = max(cover[whole], split)
    return cover
