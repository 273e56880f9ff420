"""Which pairs are worth a look: those whose cheapest way through costs little more than the best.

Under the bound's shares each pair costs at least min(alone, member + its least share). A truck's
cheapest way through a pair, less its cheapest way, is what a plan loses by it at least. Pairs that
lose more than a margin are left out, and so are those without shares. A part of what platooning can
save on a mean trip has proved wide enough.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from .compiled import THROUGH
from .pairs_used import used_pairs

__all__ = ["worth_a_look"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]

BATCH = 2000
"""Trucks that are looked at at once, so that memory stays small."""


def worth_a_look(instance: Instance, least: Floats, listed: Ints, part: float) -> Marks:
    """Mark pairs within the margin, and those of ways alone.

    Parameters
    ----------
    instance : Instance
        The problem.
    least : ndarray of float64, (P,)
        Least share of each pair [grains].
    listed : ndarray of int64
        Pairs that have shares; others are needed by no truck's cheapest schedule so far.
    part : float
        The margin as a part of what a mean trip could save.

    Returns
    -------
    ndarray of bool, (P,)
        Which.
    """
    lane = instance.pair_lane
    price = np.minimum(instance.alone[lane], instance.member[lane] + least)
    with np.errstate(invalid="ignore", divide="ignore"):
        saves = np.where(instance.alone > 0, 1 - instance.member / instance.alone, 0.0)
    margin = part * float(saves.mean()) * float(instance.alone_cost.mean())
    used, _ = used_pairs(instance, None)
    through = np.empty(instance.pairs)
    spots = int(np.diff(used.first_spot).max(initial=0)) + 1
    THROUGH.ready(instance.pairs * 3e-5)(
        used, price.astype(np.float64), np.empty(spots), np.empty(spots), through
    )
    known = np.zeros(instance.pairs, bool)
    known[listed] = True
    return instance.on_alone | (known & (through <= margin))
