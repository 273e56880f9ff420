"""The kernel of the platoon's search, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from .platoon_kernel import HELPERS, evaluate

__all__ = ["compile_now", "evaluator", "is_kept"]

SMALL = 24
"""Members times points up to which an uncompiled search takes less than compiling [1]."""


_wanted = False


@cache
def _compiled() -> Callable[..., Any]:
    from numba.extending import register_jitable

    from ...search.hierarchy.runtime.jit import compiled

    for helper in HELPERS:
        register_jitable(helper)
    return compiled(evaluate)


def compile_now() -> None:
    """Have the platoon's kernel compiled from the next call on."""
    global _wanted
    _wanted = True


def is_kept() -> bool:
    """Tell whether the compiled kernel lies in numba's cache, or has been loaded.

    Returns
    -------
    bool
        Whether calling it takes no compiling.
    """
    kernel: Any = _compiled()
    if kernel.signatures or _wanted:
        return True
    index = getattr(getattr(kernel, "_cache", None), "_cache_file", None)
    return index is not None and Path(index._index_path).is_file()


def evaluator(size: int) -> Callable[..., Any]:
    """Return the kernel, compiled or not.

    Parameters
    ----------
    size : int
        Members times points.

    Returns
    -------
    callable
        `platoon_kernel.evaluate`, or the same compiled.
    """
    return evaluate if size <= SMALL and not is_kept() else _compiled()
