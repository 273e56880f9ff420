"""Sweep many sources at once: a row of distances for each node, side by side in memory.

One look at an arc serves all sources. Arcs are taken two at a time to spare loads. The sum of the
second is compared last: a comparison with the value in memory would become a masked store, which
is twice as slow.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..runtime.jit import compiled

__all__ = ["sweep_rows"]

Ints = NDArray[np.int32]
Floats = NDArray[np.float64]


@compiled
def sweep_rows(
    low: int, high: int, first: Ints, row: Ints, descend: Floats, known: NDArray[np.bool_],
    table: Floats,
) -> None:  # fmt: skip
    """Sweep from rank `high` down to `low`.

    Parameters
    ----------
    low : int
        First rank swept.
    high : int
        The rank after the last one swept.
    first : ndarray of int, (n + 1,)
        Where the arcs of each rank begin.
    row : ndarray of int, (a,)
        Row of each arc's upper end; that of rank v is v - low.
    descend : ndarray of float, (a,)
        Cost of each arc downward.
    known : ndarray of bool, (n,)
        Ranks whose rows hold costs already; others hold nothing yet.
    table : ndarray of float, (r, lanes)
        Costs so far, completed here.
    """
    for v in range(high - 1, low - 1, -1):
        own, a, end = table[v - low], first[v], first[v + 1]
        if not known[v]:
            if a == end:
                own[:] = np.inf
            elif (end - a) & 1:
                _set_one(own, table[row[a]], descend[a])
                a += 1
            else:
                _set_two(own, table[row[a]], descend[a], table[row[a + 1]], descend[a + 1])
                a += 2
        elif (end - a) & 1:
            _offer_one(own, table[row[a]], descend[a])
            a += 1
        while a < end:
            _offer_two(own, table[row[a]], descend[a], table[row[a + 1]], descend[a + 1])
            a += 2


@compiled
def _set_one(own: Floats, one: Floats, w: float) -> None:
    for k in range(len(own)):
        own[k] = one[k] + w


@compiled
def _offer_one(own: Floats, one: Floats, w: float) -> None:
    for k in range(len(own)):
        p, s = one[k] + w, own[k]
        own[k] = p if p < s else s


@compiled
def _set_two(own: Floats, one: Floats, w: float, two: Floats, x: float) -> None:
    for k in range(len(own)):
        p, q = one[k] + w, two[k] + x
        own[k] = p if p < q else q


@compiled
def _offer_two(own: Floats, one: Floats, w: float, two: Floats, x: float) -> None:
    for k in range(len(own)):
        p, q, s = one[k] + w, two[k] + x, own[k]
        p = p if p < s else s
        own[k] = p if p < q else q
