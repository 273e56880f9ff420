r"""The game of one company on one stretch of road, with its fair shares in closed form.

Vehicle i saves s_i there as a follower and l_i as the leader, so leading costs it d_i = s_i - l_i.
A coalition S of two or more saves what all would as followers, less the least of these losses:

    v(S) = sum_S s_i - min_S d_i,   v({i}) = 0.

Equal parts of the leader's loss. With m = min d over all n, x_i = s_i - m / n. If nobody loses by
company (l_i >= 0) and nobody gains by leading rather than following (d_i >= 0), x is in the core:
no coalition does better by itself. For |S| >= 2,

    x(S) = sum_S s_i - |S| m / n >= sum_S s_i - m >= sum_S s_i - min_S d_i = v(S),

as |S| <= n, 0 <= m and m <= min_S d; equality holds for S = N, so nothing is left over. Alone,
x_i = s_i - m / n >= s_i - d_i = l_i >= 0 for the same reasons. The core of a sum of games holds the
sum of core elements, so the shares of several stretches can be added up.

The Shapley value. Number vehicles so that d_1 <= ... <= d_n. Apart from coalitions of one, v is the
additive game s less min_S d, and min_S d = sum_k (d_k - d_(k-1)) g_k(S) with d_0 = 0, where g_k(S)
is 1 if S is not empty and has no member before k. Of g_k each i >= k gets 1 / n, for it changes g_k
only when it comes first. As the shares add up to g_k(N) = [k = 1], each of the k - 1 vehicles
before k, which are alike in it, gets -(n - k + 1) / (n (k - 1)). So far a vehicle alone counts with
l_i instead of 0: the game of these amounts gives i the nth part of l_i less the mean of the others'
l, and is taken off. Together

    phi_i = s_i - d_i / n + sum_(k=i)^(n-1) (d_(k+1) - d_k) (n - k) / (n k)
            - l_i / n + sum_(j != i) l_j / (n (n - 1)).
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError
from .coalitions import members

__all__ = ["CompanyGame"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class CompanyGame:
    """What the vehicles of one company save on a stretch, as followers and as leader.

    Attributes
    ----------
    follow : ndarray of float, (n,)
        s, what each saves as a follower; any sequence of numbers will do.
    lead : ndarray of float, (n,)
        l, what each saves as the leader.

    Raises
    ------
    ScenarioError
        Lists of other lengths, none at all, or numbers that are not finite.
    """

    follow: Floats
    lead: Floats

    def __post_init__(self) -> None:
        for name in ("follow", "lead"):
            own = np.array(getattr(self, name), np.float64)
            own.flags.writeable = False
            object.__setattr__(self, name, own)
        if self.follow.ndim != 1 or not len(self.follow) or self.follow.shape != self.lead.shape:
            raise ScenarioError(
                f"sharing: {self.follow.size} savings as follower and {self.lead.size} as leader; "
                "give one of each for every vehicle"
            )
        if not (np.isfinite(self.follow).all() and np.isfinite(self.lead).all()):
            raise ScenarioError("sharing: savings must be finite numbers")

    def __len__(self) -> int:
        return len(self.follow)

    @property
    def losses(self) -> Floats:
        """What each loses by leading, d = s - l, (n,)."""
        return self.follow - self.lead

    @property
    def is_balanced(self) -> bool:
        """Whether equal parts are sure to be in the core, as l >= 0 and d >= 0 everywhere."""
        return len(self) < 2 or bool((self.lead >= 0).all() and (self.losses >= 0).all())

    def value(self, coalition: Collection[int]) -> float:
        """Return what a coalition saves by itself.

        Parameters
        ----------
        coalition : collection of int
            Positions of its vehicles, each once.

        Returns
        -------
        float
            v(S); 0 for fewer than two.
        """
        if len(coalition) < 2:
            return 0.0
        own = list(coalition)
        return float(self.follow[own].sum() - self.losses[own].min())

    def values(self) -> Floats:
        """Return what every coalition saves by itself.

        Returns
        -------
        ndarray of float, (2^n,)
            See `platoon_osm.sharing.coalitions`.
        """
        inside = members(len(self))
        least = np.where(inside, self.losses, np.inf).min(axis=1)
        table: Floats = inside @ self.follow - np.where(np.isinf(least), 0.0, least)
        table[inside.sum(axis=1) < 2] = 0.0
        return table

    def equal_parts(self, leader: int | None = None) -> Floats:
        """Return shares by which all bear the same part of the leader's loss.

        Parameters
        ----------
        leader : int, optional
            Who leads; by default who loses least by it.

        Returns
        -------
        ndarray of float, (n,)
            x, which adds up to what all save with this leader.
        """
        if len(self) < 2:
            return np.zeros(len(self))
        loss = self.losses.min() if leader is None else self.losses[leader]
        shares: Floats = self.follow - loss / len(self)
        return shares

    def shapley(self) -> Floats:
        """Return the Shapley value in closed form.

        Returns
        -------
        ndarray of float, (n,)
            phi: the mean, over all orders of arrival, of what each adds to those before it.
        """
        n = len(self)
        if n < 2:
            return np.zeros(n)
        order = np.argsort(self.losses, kind="stable")
        loss = self.losses[order]
        k = np.arange(1, n)
        steps = np.diff(loss) * (n - k) / (n * k)
        after = np.append(np.cumsum(steps[::-1])[::-1], 0.0)
        phi = np.empty(n)
        phi[order] = self.follow[order] - loss / n + after
        others = self.lead.sum() - self.lead
        shares: Floats = phi - self.lead / n + others / (n * (n - 1))
        return shares
