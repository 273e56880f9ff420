"""Run kernels side by side: they hold no lock, so threads use all cores."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

__all__ = ["cores", "run_all"]

Item = TypeVar("Item")
Result = TypeVar("Result")
_pools: dict[tuple[int, int], ThreadPoolExecutor] = {}


def cores() -> int:
    """Return how many cores this process may use.

    Returns
    -------
    int
        At least 1.
    """
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def run_all(task: Callable[[Item], Result], items: Sequence[Item], threads: int) -> list[Result]:
    """Return what a task makes of each item, in their order.

    The caller's thread takes its share: waking another costs as much as a small task.

    Parameters
    ----------
    task : callable
        What to do with an item; it may run beside itself.
    items : sequence
        What to do it with.
    threads : int
        Cores to use.

    Returns
    -------
    list
        One result an item.
    """
    if threads <= 1 or len(items) <= 1:
        return [task(item) for item in items]
    # A forked child inherits the pool but not its threads, hence the process id in the key.
    key = (os.getpid(), threads)
    if key not in _pools:
        _pools[key] = ThreadPoolExecutor(threads - 1, thread_name_prefix="sweep")
    results: list[Result | None] = [None] * len(items)
    waiting = iter(range(len(items)))

    def work() -> None:
        # `next` on a range iterator is one step under Python's lock, so no two take the same.
        for index in waiting:
            results[index] = task(items[index])

    others = [_pools[key].submit(work) for _ in range(min(threads, len(items)) - 1)]
    work()
    for other in others:
        other.result()
    return results  # type: ignore[return-value]  # none is missing, for all tasks have run
