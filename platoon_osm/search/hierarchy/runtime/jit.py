"""One way to compile the kernels: cached on disk, and running without Python's lock."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
from numba.extending import register_jitable

__all__ = ["compiled", "kept_with", "lies_in_cache", "made_known"]

Kernel = TypeVar("Kernel", bound=Callable[..., Any])

MAKE_ARRAYS = {"arange", "copy", "empty", "full", "zeros"}
"""What kernels make arrays with."""


def compiled(kernel: Kernel) -> Kernel:
    """Compile a function when it is first called.

    `nogil` lets threads run kernels side by side. There is no `fastmath`: it would let the
    compiler reorder sums, and answers would differ between machines.

    Parameters
    ----------
    kernel : callable
        A function of numbers and arrays.

    Returns
    -------
    callable
        The same, compiled when it is first called.
    """
    return cast(Kernel, numba.njit(cache=True, nogil=True, error_model="numpy")(kernel))


def made_known(helper: Callable[..., Any]) -> None:
    """Let kernels call a function, which is compiled with them.

    Numba counts who holds an array at every call that it does not inline, with locked
    instructions, which takes longer than many of the calls. What makes no arrays needs no count,
    for its caller holds them.

    Parameters
    ----------
    helper : callable
        A function of numbers and arrays. Unless it names a function that makes arrays it must not
        need one: numba says so when it compiles it.
    """
    makes = not MAKE_ARRAYS.isdisjoint(helper.__code__.co_names)
    register_jitable(_nrt=makes)(helper)


def kept_with(kernel: object, helpers: Sequence[Callable[..., Any]]) -> None:
    """Have what lies in numba's cache count only while the files of all that is called are as then.

    Numba itself looks at the kernel's own file alone.

    Parameters
    ----------
    kernel : callable
        As `compiled` returned it, and not called yet.
    helpers : sequence of callable
        Functions of any modules that it calls.
    """
    index = getattr(getattr(kernel, "_cache", None), "_cache_file", None)
    if index is None:
        return
    files = sorted({helper.__code__.co_filename for helper in helpers})
    stats = [Path(file).stat() for file in files if Path(file).is_file()]
    others = tuple((one.st_mtime, one.st_size) for one in stats)
    index._source_stamp = (index._source_stamp, others)


def lies_in_cache(kernel: object) -> bool:
    """Tell whether a compiled function lies in numba's cache, so that loading it is quick.

    Parameters
    ----------
    kernel : callable
        As `compiled` returned it.

    Returns
    -------
    bool
        Whether there is an index of it that still holds.
    """
    index = getattr(getattr(kernel, "_cache", None), "_cache_file", None)
    if index is None or not Path(index._index_path).is_file():
        return False
    return bool(index._load_index())
