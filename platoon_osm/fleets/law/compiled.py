"""The search that joins companies, compiled where that pays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...search.hierarchy.runtime.where_it_pays import WhereItPays
from .search_joining import HELPERS, search_joining

__all__ = ["HOP_S", "JOINING"]

COMPILING_S = 14.0
"""How long compiling takes, about [s]."""

HOP_S = 0.02
"""How long a plain search takes a hop, about [s]."""

JOINING: WhereItPays[Callable[..., Any]] = WhereItPays(search_joining, COMPILING_S, HELPERS)
