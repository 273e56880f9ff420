"""When the lead of one company is handed on, so that each leads about what it owes.

The vehicles of a company stand in a row; the first leads, and whoever has led falls back to the
end. On a road of length L with places p where that may happen, the turns are bounds

    0 = x_0 <= x_1 <= ... <= x_n = L,    x_j among the places,

so vehicle j of the row leads x_(j+1) - x_j, at most once. A turn that is not the last is nothing
(the vehicle is passed over) or at least the least turn; so is the last one, unless its vehicle
drives on in company. With o_j what vehicle j owes, but from 0 to L, for no road lets it lead more
or less, the greatest |o_j - (x_(j+1) - x_j)| is made
least, then the number of changes, then the sum of squares. Two passes over (vehicle, place), one
for each of the first two aims, are exact.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Row", "Turn", "turns_in_front"]

Floats = NDArray[np.float64]

SAME_M = 1.0
"""Deviations that differ by less than this are the same [m]."""

MOST = 24
"""Who stands farther back in a row than this does not come to lead in one company."""

CHANGE = 1e9
"""One change counts more than any sum of squares [km2]."""

SMALL = 1e-6
"""Less than any difference of squares that matters [km2]."""


@dataclass(frozen=True, slots=True)
class Row:
    """A company as it sets out on its road.

    Attributes
    ----------
    owes_m : tuple of float, (n,)
        How much each is to lead on this road, the first of the row first [m]; less than 0 if it has
        led too much before.
    goes_on : tuple of bool, (n,)
        Whether each drives on in company where the road ends.
    since_m : float
        How long the first has led already [m]; 0 if it begins to.
    """

    owes_m: tuple[float, ...]
    goes_on: tuple[bool, ...]
    since_m: float = 0.0


@dataclass(frozen=True, slots=True)
class Turn:
    """One vehicle's turn in front.

    Attributes
    ----------
    place : int
        Of the vehicle, in the row.
    begin_m, end_m : float
        From where to where on the road [m].
    """

    place: int
    begin_m: float
    end_m: float


def turns_in_front(
    row: Row, places_m: Sequence[float], length_m: float, least_m: float
) -> tuple[Turn, ...]:
    """Return who leads from where to where.

    Parameters
    ----------
    row : Row
        The company.
    places_m : sequence of float
        Where the lead may be handed on, between 0 and the end of the road, ascending [m].
    length_m : float
        The road's length [m].
    least_m : float
        Nobody leads less before it hands on the lead [m].

    Returns
    -------
    tuple of Turn
        In driving order, together the whole road; without those of length 0.
    """
    inner = [at for at in places_m if 0 < at < length_m]
    if not inner and 0 < row.since_m < least_m - SAME_M:
        # Who has just come to lead goes on.
        return (Turn(0, 0.0, length_m),)
    bounds = np.array([0.0, *inner, length_m])
    count = min(len(row.owes_m), MOST)
    lengths = bounds[None, :] - bounds[:, None]
    steps = [_allowed(row, j, lengths, least_m) for j in range(count)]
    owed = np.clip(row.owes_m, 0.0, length_m)
    away = [np.abs(owed[j] - lengths) for j in range(count)]
    far = [np.where(ok, off, np.inf) for ok, off in zip(steps, away, strict=True)]
    worst, _ = _least(far, np.maximum)
    most = worst + SAME_M
    # Every turn but that of the first begins with a change, if anybody led before.
    begins = (lengths > 0) & ((bounds > 0)[:, None] | (row.since_m > 0))
    # All else equal, those in front lead.
    nothing = (lengths == 0) * SMALL
    costs = [
        np.where(
            off <= most,
            (CHANGE * begins if j else 0.0) + (off / 1e3) ** 2 + nothing * (count - j),
            np.inf,
        )
        for j, off in enumerate(far)
    ]
    return _told(bounds, _least(costs, np.add)[1])


def _allowed(row: Row, j: int, lengths: Floats, least_m: float) -> NDArray[np.bool_]:
    """Mark which turns vehicle j of a row may have, by where they begin and end."""
    led = lengths + (row.since_m if j == 0 else 0.0)
    enough = (lengths > 0) & (led >= least_m - SAME_M)
    # Who has just come to lead is not passed over before it has led enough.
    nothing = (lengths == 0) & (j > 0 or row.since_m == 0.0 or row.since_m >= least_m - SAME_M)
    found = enough | nothing
    last = np.zeros_like(found)
    # The first need not have led enough where its road ends: nobody has to take over.
    last[:, -1] = (lengths[:, -1] > 0) & (row.goes_on[j] or j == 0)
    if j == 0:
        last[1:, -1] = False
    marked: NDArray[np.bool_] = found | last
    return marked


def _least(
    costs: Sequence[Floats], together: Callable[[Floats, Floats], Floats]
) -> tuple[float, list[NDArray[np.int64]]]:
    """Return the least cost of all turns, and where each turn begins by where it ends."""
    best = np.full(len(costs[0]), np.inf)
    best[0] = 0.0
    came: list[NDArray[np.int64]] = []
    for cost in costs:
        both = together(best[:, None], cost)
        came.append(np.argmin(both, axis=0))
        best = both.min(axis=0)
    return float(best[-1]), came


def _told(bounds: Floats, came: Sequence[NDArray[np.int64]]) -> tuple[Turn, ...]:
    found: list[Turn] = []
    at = len(bounds) - 1
    for j in range(len(came) - 1, -1, -1):
        begin = int(came[j][at])
        if begin < at:
            found.append(Turn(j, float(bounds[begin]), float(bounds[at])))
        at = begin
    return tuple(reversed(found))
