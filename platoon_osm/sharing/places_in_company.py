"""The game of one company where what a vehicle saves depends on its place and on the size.

A coalition keeps the order in which its members are planned to drive, but for the leader: it is led
by whomever it saves most with. If all followers save alike whatever their place and the size, this
is the game of `platoon_osm.sharing.company`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError
from .coalitions import members

__all__ = ["values_by_place"]

Floats = NDArray[np.float64]


def values_by_place(gains: ArrayLike) -> Floats:
    """Return what every coalition saves by itself, led by its best leader.

    Parameters
    ----------
    gains : array_like of float, (n, n, n)
        What vehicle i saves at a place of a company of some size: `gains[size - 1, place, i]`, with
        place 0 for the leader. Vehicles stand in the order in which they are planned to drive.
        What is told of a company of one, or of places beyond the size, is not looked at.

    Returns
    -------
    ndarray of float, (2^n,)
        0 for coalitions of fewer than two.

    Raises
    ------
    ScenarioError
        A table of another shape.
    """
    table = np.asarray(gains, np.float64)
    players = len(table)
    if table.shape != (players,) * 3:
        raise ScenarioError(
            f"sharing: gains of shape {table.shape}; give one for each size, place and vehicle"
        )
    inside = members(players)
    rank = np.cumsum(inside, axis=1) - 1  # the place of each if the first leads
    size = inside.sum(axis=1)
    best = np.full(len(inside), -np.inf)
    everyone = np.arange(players)
    for leader in everyone:
        place = np.where(everyone < leader, rank + 1, rank)
        place[:, leader] = 0
        place = np.where(inside, place, 0)
        own = np.where(inside, table[size[:, None] - 1, place, everyone], 0.0).sum(axis=1)
        best = np.where(inside[:, leader], np.maximum(best, own), best)
    best[size < 2] = 0.0
    return best
