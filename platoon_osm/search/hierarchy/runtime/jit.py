"""One way to compile the kernels: cached on disk, and running without Python's lock."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

import numba

__all__ = ["compiled", "lies_in_cache"]

Kernel = TypeVar("Kernel", bound=Callable[..., Any])


def compiled(kernel: Kernel) -> Kernel:
    """Compile a function when it is first called.

    `nogil` lets threads run kernels side by side. There is no `fastmath`: it would let the
    compiler reorder sums, and answers would differ between machines.

    Parameters
    ----------
    kernel : callable
        A function of numbers and arrays.

    Returns
    -------
    callable
        The same, compiled when it is first called.
    """
    return cast(Kernel, numba.njit(cache=True, nogil=True, error_model="numpy")(kernel))


def lies_in_cache(kernel: object) -> bool:
    """Tell whether a compiled function lies in numba's cache, so that loading it is quick.

    Parameters
    ----------
    kernel : callable
        As `compiled` returned it.

    Returns
    -------
    bool
        Whether there is an index of it.
    """
    index = getattr(getattr(kernel, "_cache", None), "_cache_file", None)
    return index is not None and Path(index._index_path).is_file()
