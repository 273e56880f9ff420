"""Ways of companies to nodes, as labels (instant, cost), and the order of their turns.

Time backward is counted as minus the instant, so that labels are always made in order of time.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["FAR", "HELPERS", "Labels", "before", "labels", "pop", "push"]

Ints = NDArray[np.int64]

FAR = 1 << 54
"""More than all costs; sums of as many as there are trucks stay whole."""


class Labels(NamedTuple):
    """Ways of companies to nodes; those that were never worth keeping too.

    Attributes
    ----------
    time, cost, node : ndarray of int64, (C,)
        When, at what cost and where; instants of ways onward count backward.
    left, right : ndarray of int64, (C,)
        The label before a lane; both before a merge; -1 and the truck where a way begins.
    lane, enter : ndarray of int64, (C,)
        The lane driven last, -1 for none, and when it is entered [ticks].
    following : ndarray of int64, (C,)
        The next label of the same company and node; -1 for none.
    heap : ndarray of int64, (C,)
        Those that wait for their turn.
    """

    time: Ints
    cost: Ints
    node: Ints
    left: Ints
    right: Ints
    lane: Ints
    enter: Ints
    following: Ints
    heap: Ints


def labels(count: int) -> Labels:
    """Return space for some labels.

    Parameters
    ----------
    count : int
        How many.

    Returns
    -------
    Labels
        Without any.
    """
    return Labels(*(np.zeros(count, np.int64) for _ in range(len(Labels._fields))))


def before(one: int, other: int, known: Labels) -> bool:
    """Tell whether a label comes before another: by time, then by cost.

    Parameters
    ----------
    one, other : int
        Labels.
    known : Labels
        All.

    Returns
    -------
    bool
        Whether.
    """
    if known.time[one] != known.time[other]:
        return bool(known.time[one] < known.time[other])
    return bool(known.cost[one] < known.cost[other])


def push(waits: int, label: int, known: Labels) -> None:
    """Let a label wait for its turn.

    Parameters
    ----------
    waits : int
        How many wait already.
    label : int
        The label.
    known : Labels
        All; their heap is changed.
    """
    heap, place = known.heap, waits
    while place > 0:
        above = (place - 1) >> 1
        if not before(label, heap[above], known):
            break
        heap[place] = heap[above]
        place = above
    heap[place] = label


def pop(waits: int, known: Labels) -> int:
    """Return the label whose turn it is.

    Parameters
    ----------
    waits : int
        How many wait.
    known : Labels
        All; their heap is changed.

    Returns
    -------
    int
        The first by time, then by cost.
    """
    heap = known.heap
    top, last, place = heap[0], heap[waits - 1], 0
    while True:
        below = 2 * place + 1
        if below >= waits - 1:
            break
        if below + 1 < waits - 1 and before(heap[below + 1], heap[below], known):
            below += 1
        if not before(heap[below], last, known):
            break
        heap[place] = heap[below]
        place = below
    heap[place] = last
    return int(top)


HELPERS = (before, push, pop)
