"""Dynamic programming over subsets of trucks: how companies form, drive, and part.

F[A][v] holds (instant, cost) of all ways in which the trucks of A can be together at node v, none
of them both later and dearer than another. It grows by two rules:

    merge   F[B][v] and F[A - B][v] give (max of the instants, sum of the costs),
    drive   over a lane that all of A may enter then, at what a company of |A| pays.

G[A][v] is the same backward in time: by when A must be at v, and what all of it pays from there to
its destinations. A plan of A whose trucks are all at v at some instant costs the least F + G whose
instants fit; a plan of all trucks parts them into such sets, or leaves some alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import driving
from .driving import potentials, searched, shared_windows
from .group import Group
from .labels import Labels, push
from .meeting import apart, joined, met

__all__ = ["HELPERS", "planted"]

Ints = NDArray[np.int64]


def begun(k: int, forward: bool, count: int, group: Group, known: Labels) -> int:
    """Let a truck's way begin at its origin, or end at its destination.

    Parameters
    ----------
    k : int
        The truck.
    forward : bool
        Which.
    count : int
        Labels so far.
    group : Group
        The trucks.
    known : Labels
        All.

    Returns
    -------
    int
        Labels now; -1 if there is no space left.
    """
    if count >= len(known.time):
        return -1
    known.time[count] = group.earliest[k] if forward else -group.latest[k]
    known.node[count] = group.origin[k] if forward else group.destination[k]
    known.cost[count], known.lane[count], known.enter[count] = 0, -1, 0
    known.left[count], known.right[count] = -1, k
    push(0, count, known)
    return count + 1


def planted(
    once: bool, group: Group, known: Labels, first: Ints, least: Ints, room: Ints, costs: Ints,
    halves: Ints,
) -> int:  # fmt: skip
    """Plan all subsets of a group.

    Parameters
    ----------
    once : bool
        Whether all merge at one node and part at one; else in any order, at any nodes. Once, only
        single trucks and the first so many are subsets.
    group : Group
        The trucks.
    known : Labels
        Space.
    first : ndarray of int64, (2, 2**k, V)
        Gets the first label of each company and node, forward and backward.
    least : ndarray of int64, (2, k, V)
        Room for what each truck pays at least.
    room : ndarray of int64, (4, max(L, V))
        More room.
    costs : ndarray of int64, (2**k,)
        Gets what each subset pays at best [grains].
    halves : ndarray of int64, (2**k, 2)
        Gets the labels at which both halves of its plan meet; -1 and a part of it where it is two
        plans.

    Returns
    -------
    int
        How many labels there are; -1 if there was no space for all.
    """
    trucks = len(group.origin)
    nodes, lanes = first.shape[2], len(group.tail)
    opens, closes = room[0, :lanes], room[1, :lanes]
    sums, last = room[2, :nodes], room[3, :nodes]
    whole = (1 << trucks) - 1
    for k in range(trucks):
        potentials(k, True, group, least[0, k])
        potentials(k, False, group, least[1, k])
    first[:] = -1
    count = 0
    for mask in range(1, whole + 1):
        single = mask & (mask - 1) == 0
        if once and not single and mask & (mask + 1) != 0:
            continue
        size, lowest = 0, -1
        for k in range(trucks):
            if mask >> k & 1:
                size += 1
                lowest = k if lowest < 0 else lowest
        shared_windows(mask, group, opens, closes)
        limit, part = int(group.alone_cost[lowest]) + 1, 0
        if not single:
            limit, part = apart(mask, lowest, once, costs)
        drives = single or not once or mask == whole
        for way in range(2):
            forward = way == 0
            sums[:] = 0
            for k in range(trucks):
                if mask >> k & 1:
                    sums += least[way, k]
            if single:
                count, waits = begun(lowest, forward, count, group, known), 1
            else:
                count, waits = met(mask, lowest, once, count, limit, sums, known, first[way])
            if count < 0:
                return -1
            count = searched(
                size, drives, forward, opens, closes, count, waits, limit, sums, group, known,
                last, first[way, mask],
            )  # fmt: skip
            if count < 0:
                return -1
        cost, label, after = joined(first[0, mask], first[1, mask], limit, known)
        costs[mask] = cost
        halves[mask, 0], halves[mask, 1] = (label, after) if label >= 0 else (-1, part)
    return count


HELPERS = (*driving.HELPERS, begun)
"""What `planted` calls, callees first."""
