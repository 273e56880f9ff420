"""The search's loops, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...search.hierarchy.runtime.where_it_pays import WhereItPays
from . import kernels

__all__ = ["EXPLORE", "SWEEP", "THROUGH"]

COMPILING_S = 12.0
"""How long compiling one takes, about [s]."""

EXPLORE: WhereItPays[Callable[..., Any]] = WhereItPays(
    kernels.explore, COMPILING_S, kernels.HELPERS
)
SWEEP: WhereItPays[Callable[..., Any]] = WhereItPays(kernels.sweep, COMPILING_S, kernels.HELPERS)
THROUGH: WhereItPays[Callable[..., Any]] = WhereItPays(kernels.through_pairs, 3.0)
"""See `kernels`."""
