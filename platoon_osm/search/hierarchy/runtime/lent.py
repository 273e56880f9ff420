"""Arrays whose memory is used again.

Memory fresh from the system costs more than a sweep that fills it: each page is cleared when it is
first touched. So blocks of results and of costs are lent out, and lent again once nobody holds the
array, or any view of it, any more. `release` gives the system back what is not lent.
"""

from __future__ import annotations

import math
import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["KEPT_BYTES", "lent", "release"]

Floats = NDArray[np.float64]

WORTH_LENDING = 1 << 16
"""Bytes; smaller blocks come from memory that the process holds anyway."""


def _physical_bytes() -> int:
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):  # not on every system
        return 1 << 32


KEPT_BYTES = _physical_bytes() // 16
"""Most memory kept for later: a sixteenth of the machine's."""

_spare: dict[int, list[Floats]] = {}


class _Loan:
    """Owns a block as long as an array uses it."""

    __slots__ = ("__array_interface__", "block")

    def __init__(self, block: Floats) -> None:
        self.block = block
        self.__array_interface__: dict[str, Any] = block.__array_interface__

    def __del__(self) -> None:
        size = self.block.nbytes
        if size + sum(key * len(blocks) for key, blocks in list(_spare.items())) <= KEPT_BYTES:
            _spare.setdefault(size, []).append(self.block)


def lent(*shape: int) -> Floats:
    """Return an uninitialised array of a shape; its memory is kept when it is no longer used.

    Parameters
    ----------
    *shape : int
        Extent of each dimension.

    Returns
    -------
    ndarray of float
        Numbers of 8 bytes.
    """
    size = 8 * math.prod(shape)
    if not WORTH_LENDING <= size <= KEPT_BYTES:
        return np.empty(shape)
    try:
        # Two steps, look and take, would let two threads take the same.
        block = _spare.get(size, []).pop()
    except IndexError:
        block = np.empty(size // 8)
    return np.asarray(_Loan(block)).reshape(shape)


def release() -> None:
    """Give the system back the memory that is kept for later."""
    _spare.clear()
