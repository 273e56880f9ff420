"""The potential of searches for a truck's response: the least that the way onward could cost."""

from __future__ import annotations

from .desk import Desk
from .entering import FAR
from .pairs_used import Used

__all__ = ["UNREACHED", "least_onward"]

UNREACHED = 1e299
"""From spots whose way onward costs so much at least, the destination is out of reach."""


def least_onward(k: int, used: Used, work: Desk) -> None:
    """Fill the least that the way onward may cost from each spot of a truck.

    Parameters
    ----------
    k : int
        The truck.
    used : Used
        The pairs, in `onward` from the destination on.
    work : Desk
        With the least of each pair in `low`; its `rest` is filled.
    """
    first, spot0, rest = used.first[k], used.first_spot[k], work.rest
    for s in range(used.first_spot[k + 1] - spot0):
        rest[s] = FAR
    rest[used.to_spot[k] - spot0] = 0.0
    changed = True
    while changed:
        changed = False
        for i in range(first, used.first[k + 1]):
            p = used.onward[i]
            through = rest[used.head[p] - spot0] + work.low[p - first]
            if through < rest[used.tail_spot[p] - spot0] - 1e-9:
                rest[used.tail_spot[p] - spot0] = through
                changed = True
