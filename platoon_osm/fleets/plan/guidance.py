"""What the search takes from the bound: shares, and what they say of each truck."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

__all__ = ["GuideOf", "SharesOf"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


class SharesOf(Protocol):
    """Shares by pair and bucket, see the bound."""

    @property
    def starts(self) -> Ints:
        """First instant of each bucket."""

    @property
    def pairs(self) -> Ints:
        """The pairs that have shares, ascending."""

    @property
    def first_bucket(self) -> Ints:
        """The bucket in which the window of each opens."""

    @property
    def first_share(self) -> Ints:
        """Where the shares of each begin."""

    @property
    def share(self) -> Floats | Ints:
        """The shares."""


class GuideOf(Protocol):
    """What shares say of each truck, see the bound."""

    @property
    def least(self) -> Floats:
        """Least share of each pair."""

    @property
    def cost(self) -> Floats:
        """Each truck's cheapest schedule."""

    @property
    def lanes(self) -> NDArray[np.int32]:
        """The lanes of that schedule."""

    @property
    def count(self) -> Ints:
        """How many."""
