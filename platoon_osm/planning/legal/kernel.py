"""The label search, compiled where that pays: the first small search of a machine runs as it is.

Compiling takes seconds once and is kept on disk; `platoon-osm warmup` does it ahead. Until then a
small search runs uncompiled, which is quicker than to wait, and gives the same.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from ...search.hierarchy.runtime.jit import compiled
from .label_search import HELPERS, search

__all__ = ["compile_now", "is_kept", "label_search"]

SMALL = 60
"""Places to pause beyond which a search is compiled [1]."""

ENOUGH = 400
"""Places of all searches so far, from which on searches are compiled: there will be more [1]."""

_searched = 0


_wanted = False


@cache
def _compiled() -> Callable[..., Any]:
    from numba.extending import register_jitable

    for helper in HELPERS:
        register_jitable(helper)
    return compiled(search)


def compile_now() -> None:
    """Have the label search compiled from the next call on."""
    global _wanted
    _wanted = True


def is_kept() -> bool:
    """Tell whether the compiled search lies in numba's cache, or has been loaded.

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


def label_search(places: int) -> Callable[..., Any]:
    """Return the search, compiled or not.

    Parameters
    ----------
    places : int
        How many places the road has where pauses are taken.

    Returns
    -------
    callable
        `label_search.search`, or the same compiled.
    """
    global _searched
    _searched += places
    few = places < SMALL and _searched < ENOUGH
    return search if few and not is_kept() else _compiled()
