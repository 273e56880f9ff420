"""Kernels run as they stand where little is to be done, and compiled where it pays.

Compiling takes seconds once, and loading what is compiled a moment; a small plan waits for neither.
The answers are the same to the last digit.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TypeVar, cast

import numpy as np

from .curve_kernel import met_on_route, steps_of_members
from .pareto_kernel import pareto_labels

__all__ = ["ready", "warm_up"]

WORTH_COMPILING_S = 4.0
"""Seconds of plain work from which on kernels are compiled."""

Kernel = TypeVar("Kernel", bound=Callable[..., object])

_compiled: dict[str, Callable[..., object]] = {}


def ready(kernel: Kernel, plain_s: float) -> Kernel:
    """Return a kernel, compiled if it is already or if that pays.

    Parameters
    ----------
    kernel : callable
        As it stands.
    plain_s : float
        About how long it would take as it stands [s].

    Returns
    -------
    callable
        The same function of the same arguments.
    """
    name = kernel.__name__
    if name not in _compiled:
        # Where the engine's kernels are loaded, numba is, and ours most likely lie beside theirs.
        warm = "numba" in sys.modules and plain_s > 0.05 and _is_kept(kernel)
        if not warm and plain_s < WORTH_COMPILING_S:
            return kernel
        _compiled[name] = _made(kernel)
    return cast(Kernel, _compiled[name])


def _made(kernel: Callable[..., object]) -> Callable[..., object]:
    from ...search.hierarchy.runtime.jit import compiled

    return compiled(kernel)


def _is_kept(kernel: Callable[..., object]) -> bool:
    """Tell whether the compiled kernel lies in numba's cache."""
    from ...search.hierarchy.runtime.jit import lies_in_cache

    return lies_in_cache(_made(kernel))


def warm_up() -> None:
    """Compile all kernels, and run them once on next to nothing."""
    for kernel in (steps_of_members, met_on_route, pareto_labels):
        ready(kernel, np.inf)
    one, none = np.zeros(1), np.zeros(0)
    first, at = np.array([0, 1]), np.zeros(1, np.int64)
    for fades in (none, one):
        for pairs in (False, True):
            _compiled["steps_of_members"](
                first, at, one, one, fades, first, at + 1, one, one, one, one, np.zeros(2),
                0.0, 1.0, 0.0, pairs,
            )  # fmt: skip
    _compiled["met_on_route"](at, at, at + 1, one, 1)
    _compiled["pareto_labels"](
        np.array([0, 1, 1]), at, at + 1, one + 1, one + 1, 0, np.zeros(2), np.zeros(2), 9.0, 9.0, 9
    )
