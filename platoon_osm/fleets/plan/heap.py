"""A heap of labels in arrays: each key is at most those of the two below it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["popped", "pushed"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


def pushed(keys: Ints | Floats, heap: Ints, size: int, key: float, label: int) -> int:
    """Put a label on the heap.

    Parameters
    ----------
    keys, heap : ndarray of int64 or float64, ndarray of int64
        Keys, the least first, and their labels.
    size : int
        How many there are.
    key, label : int or float, int
        One more.

    Returns
    -------
    int
        How many there are then.
    """
    i = size
    while i > 0:
        up = (i - 1) >> 1
        if keys[up] <= key:
            break
        keys[i], heap[i] = keys[up], heap[up]
        i = up
    keys[i], heap[i] = key, label
    return size + 1


def popped(keys: Ints | Floats, heap: Ints, size: int) -> int:
    """Take the first label off the heap.

    Parameters
    ----------
    keys, heap : ndarray of int64 or float64, ndarray of int64
        Keys, the least first, and their labels.
    size : int
        How many there are.

    Returns
    -------
    int
        How many are left.
    """
    size -= 1
    key, label = keys[size], heap[size]
    i = 0
    while True:
        low = 2 * i + 1
        if low >= size:
            break
        if low + 1 < size and keys[low + 1] < keys[low]:
            low += 1
        if keys[low] >= key:
            break
        keys[i], heap[i] = keys[low], heap[low]
        i = low
    keys[i], heap[i] = key, label
    return size
