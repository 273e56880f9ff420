"""The normal distribution: its density and how much of it lies below a value."""

from __future__ import annotations

import math

__all__ = ["ROOT_TAU", "below", "density"]

ROOT_TAU = math.sqrt(2 * math.pi)
"""The square root of 2 pi."""


def density(at: float) -> float:
    """Return the density of the standard normal distribution, exp(-x^2 / 2) / sqrt(2 pi).

    Parameters
    ----------
    at : float
        Where, in standard deviations.

    Returns
    -------
    float
        0 or more.
    """
    return math.exp(-0.5 * at * at) / ROOT_TAU


def below(at: float) -> float:
    """Return the share of the standard normal distribution that lies below a value.

    Parameters
    ----------
    at : float
        The value, in standard deviations; may be infinite.

    Returns
    -------
    float
        From 0 to 1; small shares keep their digits.
    """
    return 0.5 * math.erfc(-at / math.sqrt(2))
