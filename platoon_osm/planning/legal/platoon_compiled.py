"""The kernels of the platoon's search, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...search.hierarchy.runtime.where_it_pays import WhereItPays
from .platoon_kernel import HELPERS, evaluate, next_stops

__all__ = ["EVALUATE", "NEXT_STOPS", "Kernels", "kernels_for"]

COMPILING_S = 12.0
"""How long compiling takes, about [s]."""

PLACE_S = 0.5
"""How long a plain search takes for each member and point, about [s]."""

Kernels = tuple[Callable[..., Any], Callable[..., Any]]
"""`platoon_kernel.evaluate` and `next_stops`."""

EVALUATE: WhereItPays[Callable[..., Any]] = WhereItPays(evaluate, COMPILING_S, HELPERS)

NEXT_STOPS: WhereItPays[Callable[..., Any]] = WhereItPays(next_stops, COMPILING_S, HELPERS)


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
    return EVALUATE.ready(size * PLACE_S), NEXT_STOPS.ready(size * PLACE_S)
