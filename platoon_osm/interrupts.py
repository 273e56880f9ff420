"""Interrupts: what asks the process to end, and how it waits while something is half done."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

__all__ = ["asked_to_end", "ended_by_signals", "held_back"]

ENDING = tuple(
    getattr(signal, name)
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK")
    if hasattr(signal, name)
)
"""Ctrl-C; what `timeout` and schedulers send; a terminal that closes; Ctrl-Break of Windows."""

CLEANING_S = 2.0
"""Within this long after an interrupt others are left out: whoever presses twice gets one [s]."""


@contextmanager
def held_back() -> Iterator[None]:
    """Let interrupts wait until the block is done, where Python's own handlers would see them.

    Yields
    ------
    None
        Nothing; what came meanwhile is raised afterwards.
    """
    if not _in_main_thread():
        yield  # signals reach the main thread alone
        return
    came: list[int] = []
    before = {}

    def note(number: int, frame: FrameType | None) -> None:
        del frame
        came.append(number)

    try:
        for number in ENDING:
            handler = signal.getsignal(number)
            # None is a handler that C installed, which Python could not put back.
            if handler not in (signal.SIG_IGN, None):
                before[number] = handler
                signal.signal(number, note)
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        for number in dict.fromkeys(came):
            signal.raise_signal(number)


@contextmanager
def asked_to_end() -> Iterator[Callable[[], bool]]:
    """Let the first interrupt of a block ask for its end, which is told when it is convenient.

    A second one is raised as ever. Outside the main thread nobody asks.

    Yields
    ------
    callable
        Whether Ctrl-C was pressed since.
    """
    before = signal.getsignal(signal.SIGINT)
    if not _in_main_thread() or before in (signal.SIG_IGN, None):
        yield lambda: False
        return
    came = False

    def note(number: int, frame: FrameType | None) -> None:
        nonlocal came
        del number, frame
        came = True
        signal.signal(signal.SIGINT, before)

    signal.signal(signal.SIGINT, note)
    try:
        yield lambda: came
    finally:
        if not came:
            signal.signal(signal.SIGINT, before)


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """Treat every request to end like Ctrl-C, as a `KeyboardInterrupt` after which one cleans up.

    What somebody had ignored, as `nohup` does, stays ignored.

    Yields
    ------
    None
        Nothing.
    """
    if not _in_main_thread():
        yield
        return
    last = -CLEANING_S

    def end(number: int, frame: FrameType | None) -> None:
        del number, frame
        nonlocal last
        now = time.monotonic()
        if now - last >= CLEANING_S:
            last = now
            raise KeyboardInterrupt

    before = {}
    try:
        for number in ENDING:
            handler = signal.getsignal(number)
            if handler not in (signal.SIG_IGN, None):
                before[number] = handler
                signal.signal(number, end)
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _in_main_thread() -> bool:
    return threading.current_thread() is threading.main_thread()
