"""What responses look at and write to: the plan, how they guess, and space to work in."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .pairs_used import Used

__all__ = ["Desk", "Plan", "Taste", "desk", "traced"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

LABELS = 1 << 16
"""Labels of one search at most; further ones are left out."""


class Plan(NamedTuple):
    """What trucks drive: pairs of `Used`, and when.

    Attributes
    ----------
    legs : ndarray of int32, (N, w)
        Pairs of each truck in their order.
    departs : ndarray of int64, (N, w)
        When each is entered [ticks].
    lengths : ndarray of int64, (N,)
        How many; 0 for a truck that is taken out.
    first_apart, apart : ndarray of int64
        Trucks that each truck must not drive together with.
    """

    legs: NDArray[np.int32]
    departs: Ints
    lengths: Ints
    first_apart: Ints
    apart: Ints


class Taste(NamedTuple):
    """How a response guesses.

    Attributes
    ----------
    trust : float
        From 0, entering alone costs what driving alone does, to 1, member + share.
    blur : float
        Prices are multiplied by 1 - blur to 1 + blur.
    spread : float
        Shares are multiplied by 1 - spread to 1 + spread.
    crowd : float
        A company of m is joined at member + extra crowd / (m + crowd).
    lane, instant : int
        Where and when entering earns a bonus; lane -1 for nowhere.
    bonus : float
        The bonus [grains].
    """

    trust: float
    blur: float
    spread: float
    crowd: float
    lane: int
    instant: int
    bonus: float


class Desk(NamedTuple):
    """Space to work in, one for each thread.

    Attributes
    ----------
    blur, spread, low : ndarray of float64
        Of each pair of a truck: factors, and the least entering may cost.
    rest, popped : ndarray of float64
        Of each spot of a truck: the least of the way onward, and the cheapest label so far.
    time, parent, leg, spot : ndarray of int64, (LABELS,)
        Of labels.
    cost : ndarray of float64, (LABELS,)
        Of labels.
    heap_time, heap : ndarray of int64, (LABELS,)
        A heap of labels.
    until, older : ndarray of int64, (LABELS,)
        Of labels where waiting has a price, see `waiting.py`.
    newest : ndarray of int64
        The label taken last at each spot of a truck; then too.
    heap_cost : ndarray of float64, (LABELS,)
        What the heap is in order of then.
    legs, departs : ndarray of int64
        The answer.
    """

    blur: Floats
    spread: Floats
    low: Floats
    rest: Floats
    popped: Floats
    time: Ints
    parent: Ints
    leg: Ints
    spot: Ints
    cost: Floats
    heap_time: Ints
    heap: Ints
    until: Ints
    older: Ints
    newest: Ints
    heap_cost: Floats
    legs: Ints
    departs: Ints


def desk(used: Used, width: int) -> Desk:
    """Return space to work in.

    Parameters
    ----------
    used : Used
        The pairs.
    width : int
        Most lanes of a schedule.

    Returns
    -------
    Desk
        For one thread.
    """
    most = int(np.diff(used.first).max(initial=0)) + 1
    spots = int(np.diff(used.first_spot).max(initial=0)) + 1
    return Desk(
        blur=np.zeros(most), spread=np.zeros(most), low=np.zeros(most),
        rest=np.zeros(max(spots, most + 1)), popped=np.zeros(spots),
        time=np.zeros(LABELS, np.int64), parent=np.zeros(LABELS, np.int64),
        leg=np.zeros(LABELS, np.int64), spot=np.zeros(LABELS, np.int64), cost=np.zeros(LABELS),
        heap_time=np.zeros(LABELS, np.int64), heap=np.zeros(LABELS, np.int64),
        until=np.zeros(LABELS, np.int64), older=np.zeros(LABELS, np.int64),
        newest=np.zeros(spots, np.int64), heap_cost=np.zeros(LABELS),
        legs=np.zeros(width, np.int64), departs=np.zeros(width, np.int64),
    )  # fmt: skip


def traced(label: int, used: Used, work: Desk) -> int:
    """Write the schedule of a label.

    Parameters
    ----------
    label : int
        It.
    used : Used
        The pairs.
    work : Desk
        With the labels; gets the schedule.

    Returns
    -------
    int
        How many lanes it has; -1 if too many.
    """
    count, x = 0, label
    while work.parent[x] >= 0:
        count += 1
        x = work.parent[x]
    if count > len(work.legs):
        return -1
    x = label
    for q in range(count - 1, -1, -1):
        work.legs[q] = work.leg[x]
        work.departs[q] = work.time[x] - used.drive[work.leg[x]]
        x = work.parent[x]
    return count
