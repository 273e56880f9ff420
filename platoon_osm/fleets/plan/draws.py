"""Random numbers that are the same in compiled kernels, in plain ones, and in any thread.

Two multiplicative congruential generators are combined (L'Ecuyer, Communications of the ACM 31,
1988); the period is about 2.3e18. The state is an array of two whole numbers.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["HELPERS", "below", "started", "uniform"]

Ints = NDArray[np.int64]

FIRST, SECOND = 2147483563, 2147483399


def started(seed: int, *numbers: int) -> Ints:
    """Return the state that a seed and some numbers begin.

    Parameters
    ----------
    seed : int
        The seed.
    *numbers : int
        What tells this stream from others.

    Returns
    -------
    ndarray of int64, (2,)
        The state.
    """
    words = np.random.SeedSequence([abs(seed), *numbers]).generate_state(2).astype(np.int64)
    return np.array([1 + words[0] % (FIRST - 1), 1 + words[1] % (SECOND - 1)], np.int64)


def uniform(state: Ints) -> float:
    """Return the next number between 0 and 1, and step the state.

    Parameters
    ----------
    state : ndarray of int64, (2,)
        The state.

    Returns
    -------
    float
        Above 0 and below 1.
    """
    state[0] = state[0] * 40014 % 2147483563
    state[1] = state[1] * 40692 % 2147483399
    mixed = state[0] - state[1]
    if mixed < 1:
        mixed += 2147483562
    return float(mixed / 2147483563.0)


def below(state: Ints, count: int) -> int:
    """Return the next whole number from 0 to below a count.

    Parameters
    ----------
    state : ndarray of int64, (2,)
        The state.
    count : int
        At least 1.

    Returns
    -------
    int
        The number.
    """
    return min(int(uniform(state) * count), count - 1)


HELPERS = (uniform, below)
