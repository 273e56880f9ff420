"""Shares in whole cents that add up to the total, by the largest remainder.

Each share is rounded down, and the cents that are left go to those who lost most by it. So a share
that is not negative stays so, and nobody's differs by a cent or more.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError

__all__ = ["in_cents"]

Floats = NDArray[np.float64]

SAME = 1e-6
"""Cents by which sums of shares may miss whole numbers in their last digits."""


def in_cents(shares: Sequence[float] | Floats, total: int) -> tuple[int, ...]:
    """Return shares in whole cents.

    Parameters
    ----------
    shares : sequence of float, (n,)
        In cents; they add up to the total but for their last digits.
    total : int
        Whole cents.

    Returns
    -------
    tuple of int, (n,)
        They add up to the total; of equal remainders the first gets the cent.

    Raises
    ------
    ScenarioError
        Shares that add up to something else.
    """
    exact = [float(share) for share in shares]
    room = SAME * max(1.0, len(exact))
    if not all(map(math.isfinite, exact)) or abs(math.fsum(exact) - total) > room:
        raise ScenarioError(
            f"sharing: shares add up to {math.fsum(exact):g} cents, not to {total}; share out the "
            "whole total and no more"
        )
    whole = [math.floor(share + SAME) for share in exact]
    left = total - sum(whole)
    order = sorted(range(len(exact)), key=lambda k: (-round(exact[k] - whole[k], 6), k))
    for k in order[:left]:
        whole[k] += 1
    return tuple(whole)
