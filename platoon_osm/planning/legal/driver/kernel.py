"""The label search, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ....search.hierarchy.runtime.where_it_pays import WhereItPays
from .label_search import HELPERS, search

__all__ = ["LABELS", "label_search"]

COMPILING_S = 12.0
"""How long compiling takes, about [s]."""

HOP_S = 0.08
"""How long a plain search takes a hop, at worst about [s]: a long way is compiled for at once."""

LABELS: WhereItPays[Callable[..., Any]] = WhereItPays(search, COMPILING_S, HELPERS)


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
    return LABELS.ready(hops * HOP_S)
