"""Write to memory past the caches.

A table of distances is larger than any cache and is not read again by the sweep that fills it. An
ordinary store first fetches the line it is about to overwrite, and in doing so displaces what the
sweep still needs; a streaming one does neither (writing a table row by row takes a fifth of the
time). It writes whole cache lines, so rows begin at a multiple of a line.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic
from numpy.typing import NDArray

from .lent import lent

__all__ = ["LINE", "aligned_rows", "stream_line"]

LINE = 8
"""Numbers of 8 bytes in a cache line."""


def aligned_rows(rows: int, columns: int) -> NDArray[np.float64]:
    """Return an uninitialised array whose rows begin at cache lines; columns a multiple of 8.

    Parameters
    ----------
    rows : int
        Number of rows.
    columns : int
        Numbers in a row, a multiple of 8.

    Returns
    -------
    ndarray of float, (rows, columns)
        Numbers of 8 bytes.
    """
    memory = lent(rows * columns + LINE)
    skipped = -(memory.ctypes.data // 8) % LINE
    return memory[skipped : skipped + rows * columns].reshape(rows, columns)


def _stream_line(_: Any, target: Any, to: Any, source: Any, at: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        line = ir.VectorType(ir.DoubleType(), LINE).as_pointer()
        into, out_of = (
            context.make_array(signature.args[k])(context, builder, arguments[k]).data
            for k in (0, 2)
        )
        values = builder.load(builder.bitcast(builder.gep(out_of, [arguments[3]]), line), align=8)
        store = builder.store(
            values, builder.bitcast(builder.gep(into, [arguments[1]]), line), align=8 * LINE
        )
        one = builder.module.add_metadata([ir.Constant(ir.IntType(32), 1)])
        store.set_metadata("nontemporal", one)
        return context.get_dummy_value()

    return types.void(target, to, source, at), generate


stream_line: Any = intrinsic(_stream_line)
"""Called in a kernel as `stream_line(target, to, source, at)`: copy source[at : at + 8] to
target[to : to + 8] past the caches. Both are one-dimensional float64 arrays; target[to] lies at the
beginning of a cache line."""
