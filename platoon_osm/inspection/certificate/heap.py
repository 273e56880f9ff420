"""A heap of whole numbers: what has the least key comes out first."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .compiling import compiled

__all__ = ["drop_least", "put"]

Ints = NDArray[np.int64]


@compiled
def put(keys: Ints, items: Ints, size: int, key: int, item: int) -> int:
    """Put an item in; return how many there are then.

    Parameters
    ----------
    keys, items : ndarray of int64
        The heap, with room for one more.
    size : int
        How many are in it.
    key, item : int
        What to put in.

    Returns
    -------
    int
        One more.
    """
    at = size
    while at > 0:
        above = (at - 1) // 2
        if keys[above] <= key:
            break
        keys[at] = keys[above]
        items[at] = items[above]
        at = above
    keys[at] = key
    items[at] = item
    return size + 1


@compiled
def drop_least(keys: Ints, items: Ints, size: int) -> int:
    """Take the first item out; return how many are left.

    Parameters
    ----------
    keys, items : ndarray of int64
        The heap.
    size : int
        How many are in it, at least one.

    Returns
    -------
    int
        One fewer.
    """
    size -= 1
    key, item = keys[size], items[size]
    at = 0
    while True:
        below = 2 * at + 1
        if below >= size:
            break
        if below + 1 < size and keys[below + 1] < keys[below]:
            below += 1
        if keys[below] >= key:
            break
        keys[at] = keys[below]
        items[at] = items[below]
        at = below
    keys[at] = key
    items[at] = item
    return size
