"""Whether any coalition could gain by itself, tried for all of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..errors import ScenarioError
from .coalitions import players_of, shares_of_coalitions

__all__ = ["Checked", "checked"]


@dataclass(frozen=True, slots=True)
class Checked:
    """The coalition that would gain most by itself.

    Attributes
    ----------
    coalitions : int
        How many were tried: all but nobody and everybody.
    worst : float
        The most that one of them is worth beyond its shares; at most 0 if the shares are in the
        core. 0 if there are none.
    who : tuple of int
        The players of that coalition, the first of equal ones.
    """

    coalitions: int
    worst: float
    who: tuple[int, ...]


def checked(shares: ArrayLike, values: ArrayLike) -> Checked:
    """Return the most that any coalition could gain by itself.

    Parameters
    ----------
    shares : array_like of float, (n,)
        What each player has.
    values : array_like of float, (2^n,)
        What each coalition is worth; see `platoon_osm.sharing.coalitions`.

    Returns
    -------
    Checked
        The worst of them.

    Raises
    ------
    ScenarioError
        Shares of another number of players, or a table that is none of values.
    """
    own, table = np.asarray(shares, np.float64), np.asarray(values, np.float64)
    players = players_of(table)
    if own.shape != (players,):
        raise ScenarioError(
            f"sharing: {own.size} shares and values for {players} players; give one share each"
        )
    if players < 2:
        return Checked(0, 0.0, ())
    excess = (table - shares_of_coalitions(own))[1:-1]
    at = int(np.argmax(excess))
    who = tuple(player for player in range(players) if (at + 1) >> player & 1)
    return Checked(len(excess), float(excess[at]), who)
