"""The search over subsets of trucks, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...search.hierarchy.runtime.where_it_pays import WhereItPays
from . import kernels

__all__ = ["PLANTED"]

PLANTED: WhereItPays[Callable[..., Any]] = WhereItPays(kernels.planted, 12.0, kernels.HELPERS)
"""See `kernels`."""
