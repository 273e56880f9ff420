"""Ways of members to the route of a master, and from it: one to a position, or several."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Ways"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
Marks = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Ways:
    """Ways of M members to the positions of a route, or from these onward.

    Attributes
    ----------
    first : ndarray of int, (M + 1,)
        Where the ways of each member begin.
    at : ndarray of int, (W,)
        Positions on the route, ascending for each member.
    cost : ndarray of float, (W,)
        What they cost alone.
    time_s : ndarray of float, (W,)
        How long they take [s].
    """

    first: Longs
    at: Longs
    cost: Floats
    time_s: Floats

    @classmethod
    def joined(cls, parts: Sequence[tuple[Longs, Floats, Floats]]) -> Ways:
        """Return the ways of all members from those of each.

        Parameters
        ----------
        parts : sequence of tuple of ndarray, (M,)
            Positions, ascending, costs and times.

        Returns
        -------
        Ways
            One after the other.
        """
        first = np.concatenate([[0], np.cumsum([len(at) for at, _, _ in parts])]).astype(np.int64)
        if not parts:
            return cls(first, np.zeros(0, np.int64), np.zeros(0), np.zeros(0))
        at, cost, time_s = (np.concatenate(some) for some in zip(*parts, strict=True))
        return cls(first, at.astype(np.int64), cost, time_s)

    @classmethod
    def dense(cls, cost: Floats, time_s: Floats) -> Ways:
        """Return ways of which there is one to each position.

        Parameters
        ----------
        cost, time_s : ndarray of float, (M, K + 1)
            Costs and times; inf where there is none.

        Returns
        -------
        Ways
            Those of finite cost and time.
        """
        there = np.isfinite(cost) & np.isfinite(time_s)
        first = np.concatenate([[0], np.cumsum(there.sum(axis=1))]).astype(np.int64)
        return cls(first, np.nonzero(there)[1], cost[there], time_s[there])

    @property
    def member(self) -> Longs:
        """Whose each way is, (W,)."""
        return np.repeat(np.arange(len(self.first) - 1), np.diff(self.first))

    def kept(self, some: Marks) -> Ways:
        """Return some of the ways.

        Parameters
        ----------
        some : ndarray of bool, (W,)
            Which.

        Returns
        -------
        Ways
            In the same order.
        """
        counts = np.concatenate([[0], np.cumsum(some)]).astype(np.int64)
        return Ways(counts[self.first], self.at[some], self.cost[some], self.time_s[some])
