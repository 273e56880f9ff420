"""How the checker's own loops are compiled: apart from the planner's, and without bending sums."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numba

__all__ = ["compiled"]

Kernel = TypeVar("Kernel", bound=Callable[..., Any])


def compiled(kernel: Kernel) -> Kernel:
    """Compile a function of whole numbers when it is first called.

    Parameters
    ----------
    kernel : callable
        A function of numbers and arrays.

    Returns
    -------
    callable
        The same; `py_func` is the one that was given.
    """
    return cast(Kernel, numba.njit(cache=True, nogil=True)(kernel))
