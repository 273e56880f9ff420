"""The kernels of the platoon's search, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ....search.hierarchy.runtime.where_it_pays import WhereItPays
from . import again_kernel, kernel, next_stops, own_places, own_ways

__all__ = ["KERNELS", "Kernels", "kernels_for"]

COMPILING_S = 12.0
"""How long compiling takes, about [s]."""

PLACE_S = 0.5
"""How long a plain search takes for each member and point, about [s]."""

Kernel = Callable[..., Any]


@dataclass(frozen=True, slots=True)
class Kernels:
    """The kernels, compiled or not.

    Attributes
    ----------
    evaluate, next_stops, plain_ways, entries_by_places, exits_by_places : callable
        Of the files that hold them.
    two_stretches : callable
        Likewise.
    """

    evaluate: Kernel = kernel.evaluate
    next_stops: Kernel = next_stops.next_stops
    plain_ways: Kernel = own_ways.plain_ways
    entries_by_places: Kernel = own_places.entries_by_places
    exits_by_places: Kernel = own_places.exits_by_places
    two_stretches: Kernel = again_kernel.two_stretches


_PLACES = own_places.HELPERS

KERNELS: tuple[WhereItPays[Kernel], ...] = (
    WhereItPays(kernel.evaluate, COMPILING_S, kernel.HELPERS),
    WhereItPays(next_stops.next_stops, COMPILING_S, next_stops.HELPERS),
    WhereItPays(own_ways.plain_ways, COMPILING_S, own_ways.HELPERS),
    WhereItPays(own_places.entries_by_places, COMPILING_S, _PLACES),
    WhereItPays(own_places.exits_by_places, COMPILING_S, _PLACES),
    WhereItPays(again_kernel.two_stretches, COMPILING_S, again_kernel.HELPERS),
)
"""In the order of `Kernels`."""


def kernels_for(size: int) -> Kernels:
    """Return the kernels, compiled or not.

    Parameters
    ----------
    size : int
        Members times points.

    Returns
    -------
    Kernels
        Those of the files, or the same compiled.
    """
    return Kernels(*(kernel.ready(size * PLACE_S) for kernel in KERNELS))
