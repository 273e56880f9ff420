"""Spans of a master's departure, with beginnings of its stops, as the search keeps them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .stops import OPEN, Clocks, Night, Stops

__all__ = ["Past", "SpanNode", "halves"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Past:
    """How far vehicles have come in their lists of pairs, in each cell of a span.

    Attributes
    ----------
    rank : ndarray of int, (R, G)
        All pairs before this place are out in the cell.
    begin, width : int
        When the first cell begins, and how long each is [s].
    """

    rank: NDArray[np.int32]
    begin: int
    width: int

    def of(self, rows: Seconds | NDArray[np.bool_]) -> Past:
        """Return the same of some of the vehicles.

        Parameters
        ----------
        rows : ndarray
            Which, in their new order, or marked.

        Returns
        -------
        Past
            Likewise.
        """
        return Past(self.rank[rows], self.begin, self.width)


@dataclass(slots=True, eq=False)
class SpanNode:
    """A beginning of the master's stops, and a span of its departure.

    Attributes
    ----------
    stops : tuple of (int, int)
        Those decided.
    clocks : (int, int, int) or None
        The master's after the last of them; None if no other stops follow.
    begin, end : int
        The span [s].
    fixed : float
        What those pay together of whom it is settled.
    rows : ndarray of int, (R,)
        The others, as `StarNumbers` numbers them.
    low : ndarray of float, (R,)
        What each of these pays at least.
    rank : ndarray of int, (R,)
        The place of the pair at which it would, in its list; those before are out in this span.
    past : Past
        Likewise in each cell of a span that holds this one.
    night : (int, int, int)
        The next daily rest.
    looked : int
        How many own ways had been looked at when it was bounded.
    taken : bool
        Whether it was looked at before its turn.
    """

    stops: Stops
    clocks: Clocks | None
    begin: int
    end: int
    fixed: float
    rows: Seconds
    low: Floats
    rank: Seconds
    past: Past
    night: Night = OPEN
    looked: int = 0
    taken: bool = False

    def keep(self, kept: NDArray[np.bool_]) -> None:
        """Settle the other vehicles at what they pay at least.

        Parameters
        ----------
        kept : ndarray of bool, (R,)
            Which are not settled.
        """
        if not kept.all():
            self.fixed += float(self.low[~kept].sum())
            self.take(kept)

    def take(self, rows: Seconds | NDArray[np.bool_]) -> None:
        """Put the vehicles that are not settled in another order, or leave some out.

        Parameters
        ----------
        rows : ndarray
            Which, in their new order, or marked.
        """
        self.rows, self.low, self.rank = self.rows[rows], self.low[rows], self.rank[rows]
        self.past = self.past.of(rows)


def halves(begin: int, end: int) -> tuple[tuple[int, int], tuple[int, int]]:
    """Return the halves of a span.

    Parameters
    ----------
    begin, end : int
        The span [s].

    Returns
    -------
    (int, int), (int, int)
        The first is not shorter.
    """
    middle = (begin + end) // 2
    return (begin, middle), (middle + 1, end)
