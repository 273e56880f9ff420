"""Work in fixed chunks by several threads, so that the answer does not depend on how many."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from types import TracebackType

import numpy as np
from numpy.typing import NDArray

__all__ = ["Crew", "chunks_of"]

CHUNKS = 24
"""Into how many chunks work is cut."""


def chunks_of(loads: NDArray[np.int64]) -> list[tuple[int, int]]:
    """Cut a row of things into chunks of about as much work each.

    Parameters
    ----------
    loads : ndarray of int64, (n + 1,)
        Work up to each of them, ascending.

    Returns
    -------
    list of (int, int)
        Begin and end of each chunk that is not empty.
    """
    marks = np.linspace(loads[0], loads[-1], CHUNKS + 1)
    cuts = np.searchsorted(loads, marks[1:-1]).tolist()
    edges = [0, *cuts, len(loads) - 1]
    return [(begin, end) for begin, end in pairwise(edges) if end > begin]


class Crew:
    """Some threads.

    Parameters
    ----------
    threads : int
        How many; with one all is done at once.
    """

    def __init__(self, threads: int) -> None:
        self._pool = ThreadPoolExecutor(threads) if threads > 1 else None

    def __enter__(self) -> Crew:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._pool is not None:
            self._pool.shutdown()

    def each(self, work: Callable[[int, int], float], chunks: list[tuple[int, int]]) -> list[float]:
        """Do work chunk by chunk.

        Parameters
        ----------
        work : callable
            Of begin and end.
        chunks : list of (int, int)
            The chunks.

        Returns
        -------
        list of float
            What each came to, in order of the chunks.
        """
        if self._pool is None:
            return [work(begin, end) for begin, end in chunks]
        return list(self._pool.map(lambda chunk: work(*chunk), chunks))
