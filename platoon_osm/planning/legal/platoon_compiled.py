"""The kernels of the platoon's search, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from .platoon_kernel import HELPERS, evaluate, next_stops

__all__ = ["compile_now", "is_kept", "kernels_for"]

SMALL = 24
"""Members times points up to which an uncompiled search takes less than compiling [1]."""


_wanted = False


Kernels = tuple[Callable[..., Any], Callable[..., Any]]
"""`platoon_kernel.evaluate` and `next_stops`."""


@cache
def _compiled() -> Kernels:
    from numba.extending import register_jitable

    from ...search.hierarchy.runtime.jit import compiled

    for helper in HELPERS:
        register_jitable(helper)
    return compiled(evaluate), compiled(next_stops)


def compile_now() -> None:
    """Have the platoon's kernels compiled from the next call on."""
    global _wanted
    _wanted = True


def is_kept() -> bool:
    """Tell whether the compiled kernel lies in numba's cache, or has been loaded.

    Returns
    -------
    bool
        Whether calling it takes no compiling.
    """
    from ...search.hierarchy.runtime.jit import lies_in_cache

    kernel: Any = _compiled()[0]
    return bool(kernel.signatures) or _wanted or lies_in_cache(kernel)


def kernels_for(size: int) -> Kernels:
    """Return the kernels, compiled or not.

    Parameters
    ----------
    size : int
        Members times points.

    Returns
    -------
    evaluate, next_stops : callable
        Of `platoon_kernel`, or the same compiled.
    """
    if size <= SMALL and not is_kept():
        return evaluate, next_stops
    return _compiled()
