"""One way to compile the kernels: cached on disk, and running without Python's lock."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numba

__all__ = ["compiled"]

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
