"""Who is the master: the vehicle whose own route is the longest."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

__all__ = ["longest_route"]

MILLIMETRES = 3
"""Decimals of a metre to which routes are compared: sums of the same edges may differ beyond."""


def longest_route(lengths_m: Sequence[float] | NDArray[np.float64]) -> int:
    """Return whose route is the longest; the first of equals.

    Parameters
    ----------
    lengths_m : sequence of float, (N,)
        Length of each vehicle's route alone [m].

    Returns
    -------
    int
        Its position.
    """
    return int(np.argmax(np.round(np.asarray(lengths_m, np.float64), MILLIMETRES)))
