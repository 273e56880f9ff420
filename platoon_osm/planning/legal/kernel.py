"""The label search, compiled where that pays.

Compiling takes a quarter of a minute once and is kept on disk; `platoon-osm warmup` does it ahead.
Until then searches run as they are, some hundred times slower, and give the same. When they have
taken as long in this process as compiling would, it is done: so nobody waits for more than twice
the better of the two.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import cache
from typing import Any

from ...search.hierarchy.runtime.jit import compiled, lies_in_cache
from .label_search import HELPERS, search

__all__ = ["compile_now", "is_kept", "label_search"]

COMPILING_S = 12.0
"""How long compiling takes, about [s]."""

SMALL = 150
"""Hops beyond which a search is compiled at once [1]."""

_spent_s = 0.0

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
    return bool(kernel.signatures) or _wanted or lies_in_cache(kernel)


def label_search(hops: int) -> Callable[..., Any]:
    """Return the search, compiled or not.

    Parameters
    ----------
    hops : int
        How many the road has.

    Returns
    -------
    callable
        `label_search.search`, or the same compiled.
    """
    if hops > SMALL or _spent_s > COMPILING_S or is_kept():
        return _compiled()
    return _plain


def _plain(*given: Any) -> Any:
    global _spent_s
    begin = time.perf_counter()
    found = search(*given)
    _spent_s += time.perf_counter() - begin
    return found
