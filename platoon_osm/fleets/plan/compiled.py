"""The search's loops, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...search.hierarchy.runtime.where_it_pays import WhereItPays
from . import kernels

__all__ = ["EXPLORE", "PLAIN_S", "SWEEP", "THROUGH"]

COMPILING_S = 12.0
"""How long compiling one takes, about [s]."""

PLAIN_S = 2e-3
"""How long a response takes where nothing is compiled, about [s]."""

EXPLORE: WhereItPays[Callable[..., Any]] = WhereItPays(
    kernels.explore, COMPILING_S, kernels.HELPERS
)
SWEEP: WhereItPays[Callable[..., Any]] = WhereItPays(kernels.sweep, COMPILING_S, kernels.HELPERS)
THROUGH: WhereItPays[Callable[..., Any]] = WhereItPays(kernels.through_pairs, 3.0)
"""See `kernels`."""
