"""Spans of a master's departure, with beginnings of its stops, as the search keeps them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .stops import Clocks, Stops

__all__ = ["SpanNode", "halves"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]


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
            self.rows, self.low, self.rank = self.rows[kept], self.low[kept], self.rank[kept]


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
