"""Processes that do the runs of a study, and end with it."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from types import FrameType

__all__ = ["workers"]

PATIENCE_S = 5.0
"""How long an interrupted worker may take to tidy up [s]."""


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
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(count, mp_context=context, initializer=_leave_interrupts_to_parent)
    try:
        _start(pool, count)
        yield pool
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        ours = set(multiprocessing.active_children()) - others
        for child in ours:
            child.terminate()
        for child in ours:
            child.join(PATIENCE_S)
        raise
    pool.shutdown()


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


def _leave_interrupts_to_parent() -> None:
    # Ctrl-C reaches all processes of a terminal; the one that started them says what is kept.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _end)


def _end(number: int, frame: FrameType | None) -> None:
    del number, frame
    sys.exit(1)  # by way of all `finally`, so that no draft is left
