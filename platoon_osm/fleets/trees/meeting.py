"""Where companies meet, and what they pay if they do not.

Two companies that can be at a node by some instants and at some costs can be there together by the
later of the instants, at the sum of the costs; of all such only those count that no other
undercuts.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import labels
from .labels import FAR, Labels, push

__all__ = ["HELPERS", "apart", "joined", "merged", "met"]

Ints = NDArray[np.int64]


def merged(
    one: int, other: int, count: int, waits: int, limit: int, least: Ints, known: Labels
) -> tuple[int, int]:
    """Let two companies meet at a node.

    Parameters
    ----------
    one, other : int
        The first label of each there.
    count, waits : int
        Labels so far, and those that wait.
    limit : int
        From which cost on it is worth nothing [grains].
    least : ndarray of int64, (V,)
        What both still pay at least [grains].
    known : Labels
        All.

    Returns
    -------
    count, waits : int
        Now; the first is -1 if there is no space left.
    """
    node = known.node[one]
    while one >= 0 and other >= 0:
        # Both as cheap as they can be by the later instant of the two.
        at = max(known.time[one], known.time[other])
        while known.following[one] >= 0 and known.time[known.following[one]] <= at:
            one = known.following[one]
        while known.following[other] >= 0 and known.time[known.following[other]] <= at:
            other = known.following[other]
        cost = known.cost[one] + known.cost[other]
        if cost + least[node] < limit:
            if count >= len(known.time):
                return -1, waits
            known.time[count], known.cost[count], known.node[count] = at, cost, node
            known.left[count], known.right[count] = one, other
            known.lane[count], known.enter[count] = -1, at
            push(waits, count, known)
            count += 1
            waits += 1
        after, after_other = known.following[one], known.following[other]
        if after < 0 and after_other < 0:
            break
        if after_other < 0 or (after >= 0 and known.time[after] <= known.time[after_other]):
            one = after
        else:
            other = after_other
    return count, waits


def joined(there: Ints, onward: Ints, limit: int, known: Labels) -> tuple[int, int, int]:
    """Return the cheapest plan in which a company is together at some node.

    Parameters
    ----------
    there, onward : ndarray of int64, (V,)
        First labels of each node, forward and backward.
    limit : int
        What it must cost less than [grains].
    known : Labels
        All.

    Returns
    -------
    cost, label, after : int
        Its cost, and where both halves meet; labels of -1 if there is none.
    """
    best, label, after = limit, -1, -1
    for node in range(len(there)):
        one = there[node]
        while one >= 0:
            other = onward[node]
            # Labels onward become cheaper the earlier they must be there.
            while other >= 0 and -known.time[other] >= known.time[one]:
                cost = known.cost[one] + known.cost[other]
                if cost < best:
                    best, label, after = cost, one, other
                other = known.following[other]
            one = known.following[one]
    return best, label, after


def apart(mask: int, lowest: int, once: bool, costs: Ints) -> tuple[int, int]:
    """Return what a subset pays at best as two that do not meet.

    Parameters
    ----------
    mask, lowest : int
        The subset, and its first truck.
    once : bool
        Whether all of it drive alone then.
    costs : ndarray of int64, (2**k,)
        What smaller subsets pay [grains].

    Returns
    -------
    cost, part : int
        And one of the two.
    """
    if once:
        part = mask >> 1
        return int(costs[part] + costs[mask ^ part]), part
    best, found = FAR, 0
    part = (mask - 1) & mask
    while part > 0:
        if part >> lowest & 1 and costs[part] + costs[mask ^ part] < best:
            best, found = int(costs[part] + costs[mask ^ part]), part
        part = (part - 1) & mask
    return best, found


def met(
    mask: int, lowest: int, once: bool, count: int, limit: int, least: Ints, known: Labels,
    first: Ints,
) -> tuple[int, int]:  # fmt: skip
    """Let every two parts of a subset meet wherever both can be.

    Parameters
    ----------
    mask, lowest, once : int, int, bool
        As of `apart`; once, a truck more meets those that have met.
    count, limit, least, known : int, int, ndarray, Labels
        As of `merged`.
    first : ndarray of int64, (2**k, V)
        First labels of smaller subsets.

    Returns
    -------
    count, waits : int
        As of `merged`.
    """
    waits = 0
    part = mask >> 1 if once else (mask - 1) & mask
    while part > 0:
        if part >> lowest & 1:
            for node in range(first.shape[1]):
                one, other = first[part, node], first[mask ^ part, node]
                if one >= 0 and other >= 0:
                    count, waits = merged(one, other, count, waits, limit, least, known)
                    if count < 0:
                        return -1, 0
        part = 0 if once else (part - 1) & mask
    return count, waits


HELPERS = (*labels.HELPERS, merged, joined, apart, met)
