"""The kernels of windows, compiled where that pays."""

from __future__ import annotations

import numpy as np

from ...search.hierarchy.runtime.where_it_pays import WhereItPays
from .curve_kernel import met_on_route, steps_of_members
from .pareto_kernel import pareto_labels

__all__ = ["MET_ON_ROUTE", "PARETO_LABELS", "STEPS_OF_MEMBERS", "warm_up"]

COMPILING_S = 4.0
"""How long compiling takes, about [s]."""

STEPS_OF_MEMBERS = WhereItPays(steps_of_members, COMPILING_S)

MET_ON_ROUTE = WhereItPays(met_on_route, COMPILING_S)

PARETO_LABELS = WhereItPays(pareto_labels, COMPILING_S)


def warm_up() -> None:
    """Compile all kernels, and run them once on next to nothing."""
    one, none = np.zeros(1), np.zeros(0)
    first, at = np.array([0, 1]), np.zeros(1, np.int64)
    for fades in (none, one):
        for pairs in (False, True):
            STEPS_OF_MEMBERS.now()(
                first, at, one, one, fades, first, at + 1, one, one, one, one, np.zeros(2),
                0.0, 1.0, 0.0, pairs,
            )  # fmt: skip
    MET_ON_ROUTE.now()(at, at, at + 1, one, 1)
    PARETO_LABELS.now()(
        np.array([0, 1, 1]), at, at + 1, one + 1, one + 1, 0, np.zeros(2), np.zeros(2), 9.0, 9.0, 9
    )
