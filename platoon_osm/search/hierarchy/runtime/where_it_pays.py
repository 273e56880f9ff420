"""Kernels run as they stand where little is to be done, and compiled where that pays.

Compiling takes seconds once and is kept on disk (`platoon-osm warmup` does it ahead); loading what
is kept takes a moment, and so does importing numba. A small question waits for none of these.
Until a kernel is compiled, its plain runs are timed: when they have taken as long in this process
as compiling would, it is done. So nobody waits for more than about twice the better of the two.
The answers are the same.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from typing import Any, Generic, TypeVar, cast

__all__ = ["WhereItPays"]

LOADING_S = 0.05
"""How long loading a compiled kernel takes, about [s]."""

IMPORTING_S = 1.0
"""How long importing numba and loading a kernel take, about [s]."""

Kernel = TypeVar("Kernel", bound=Callable[..., Any])


class WhereItPays(Generic[Kernel]):
    """A kernel that is compiled where that pays.

    Parameters
    ----------
    plain : callable
        As it stands: a function of numbers and arrays.
    compiling_s : float
        About how long compiling takes [s].
    helpers : sequence of callable
        What the kernel calls, callees first.
    """

    def __init__(
        self, plain: Kernel, compiling_s: float, helpers: Sequence[Callable[..., Any]] = ()
    ) -> None:
        self._plain = plain
        self._compiling_s = compiling_s
        self._helpers = helpers
        self._lazy: Kernel | None = None
        self._wanted = False
        self._spent_s = 0.0

    def ready(self, plain_s: float) -> Kernel:
        """Return the kernel, compiled if it is already or if that pays.

        Parameters
        ----------
        plain_s : float
            About how long it would take as it stands [s].

        Returns
        -------
        callable
            The same function of the same arguments.
        """
        if self._wanted:
            return self._compiled()
        if self._spent_s + plain_s >= self._compiling_s:
            return self.now()
        worth_s = LOADING_S if "numba" in sys.modules else IMPORTING_S
        if self._spent_s + plain_s > worth_s and self.is_kept():
            return self.now()
        return cast(Kernel, self._timed)

    def now(self) -> Kernel:
        """Have the kernel compiled from now on, and return it so.

        Returns
        -------
        callable
            The kernel, which is compiled when it is first called.
        """
        self._wanted = True
        return self._compiled()

    def is_kept(self) -> bool:
        """Tell whether the compiled kernel lies in numba's cache, or is wanted anyway.

        Returns
        -------
        bool
            Whether calling it takes no compiling, or somebody has asked for that.
        """
        from .jit import lies_in_cache

        return self._wanted or lies_in_cache(self._compiled())

    def _compiled(self) -> Kernel:
        if self._lazy is None:
            from .jit import compiled, kept_with, made_known

            for helper in self._helpers:
                made_known(helper)
            self._lazy = compiled(self._plain)
            kept_with(self._lazy, self._helpers)
        return self._lazy

    def _timed(self, *given: Any) -> Any:
        begin = time.perf_counter()
        found = self._plain(*given)
        self._spent_s += time.perf_counter() - begin
        return found
