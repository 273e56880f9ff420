"""Processes that do the runs of a study, and end with it."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing.synchronize import Event

__all__ = ["stopped", "workers"]

_stop: Event | None = None
"""In a worker: set when it is to end."""


@contextmanager
def workers(count: int | None) -> Iterator[Executor | None]:
    """Give processes that do runs.

    Parameters
    ----------
    count : int or None
        How many; None is one for each core.

    Yields
    ------
    Executor or None
        None for one, which is this process.
    """
    count = count or os.cpu_count() or 1
    if count == 1:
        yield None
        return
    # Fresh processes: a forked one would inherit the progress bar's thread half alive.
    context = multiprocessing.get_context("spawn")
    stop = context.Event()
    pool = ProcessPoolExecutor(count, mp_context=context, initializer=_begin, initargs=(stop,))
    try:
        _start(pool, count)
        yield pool
    except BaseException:
        stop.set()  # each finishes the run it is at, and keeps it
        pool.shutdown(cancel_futures=True)
        raise
    pool.shutdown()


def stopped() -> bool:
    """Whether this process is a worker that is asked to end."""
    return _stop is not None and _stop.is_set()


def _start(pool: Executor, count: int) -> None:
    """Start all processes now, deaf to Ctrl-C from their first moment on."""
    if threading.current_thread() is not threading.main_thread():
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        for _ in range(count):
            pool.submit(os.getpid)
    finally:
        signal.signal(signal.SIGINT, before)


def _begin(stop: Event) -> None:
    # Ctrl-C reaches all processes of a terminal, and schedulers end whole groups of them; the one
    # that started them says when to end, and what is kept.
    global _stop
    _stop = stop
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
