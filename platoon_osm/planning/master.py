"""Who is the master: the vehicle that is named, that of the longest route, or the best of all."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

__all__ = ["LONGEST", "longest_first", "longest_route"]

LONGEST = "longest"
"""The paper's rule, as problems name it."""

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
    return longest_first(lengths_m)[0]


def longest_first(lengths_m: Sequence[float] | NDArray[np.float64]) -> list[int]:
    """Return vehicles by the length of their routes, the first of equals first.

    Parameters
    ----------
    lengths_m : sequence of float, (N,)
        Length of each vehicle's route alone [m].

    Returns
    -------
    list of int
        Their positions.
    """
    rounded = np.round(np.asarray(lengths_m, np.float64), MILLIMETRES)
    order: list[int] = np.argsort(-rounded, kind="stable").tolist()
    return order
