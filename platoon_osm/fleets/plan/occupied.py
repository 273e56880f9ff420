"""Who enters which lane when, out of a list of entries."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .occupancy import Occupancy

__all__ = ["occupied"]

Ints = NDArray[np.int64]


def occupied(first: Ints, lane: Ints, departs: Ints) -> Occupancy:
    """Return the instants at which lanes are entered, and by how many trucks.

    Parameters
    ----------
    first : ndarray of int64, (L + 1,)
        Where the row of each lane begins, with room for all that may enter it.
    lane, departs : ndarray of int64
        Where and when a truck enters, for each entry [ticks].

    Returns
    -------
    Occupancy
        Rows sorted by time.
    """
    lanes = len(first) - 1
    at, count = np.zeros(first[-1], np.int64), np.zeros(first[-1], np.int64)
    size = np.zeros(lanes, np.int64)
    if len(lane):
        order = np.lexsort((departs, lane))
        lane, departs = lane[order], departs[order]
        new = np.concatenate([[True], (np.diff(lane) != 0) | (np.diff(departs) != 0)])
        begin = np.flatnonzero(new)
        own = lane[begin]
        size = np.bincount(own, minlength=lanes).astype(np.int64)
        rank = np.arange(len(begin)) - np.searchsorted(own, own)
        at[first[own] + rank] = departs[begin]
        count[first[own] + rank] = np.diff(np.append(begin, len(lane)))
    return Occupancy(first, size, at, count)
