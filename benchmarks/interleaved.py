"""Time alternatives in turns, so that whatever else the machine does touches all alike."""

from __future__ import annotations

import gc
import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

__all__ = ["Comparison", "compare"]


@dataclass(frozen=True, slots=True)
class Comparison:
    """Seconds of each alternative, one a round.

    Attributes
    ----------
    seconds : name -> times, in the order of the rounds.
    """

    seconds: Mapping[str, tuple[float, ...]]

    def median(self, name: str) -> float:
        """Median time of an alternative [s]."""
        return statistics.median(self.seconds[name])

    def ratio(self, slow: str, fast: str) -> float:
        """How many times longer `slow` takes: the median of the ratios of each round."""
        pairs = zip(self.seconds[slow], self.seconds[fast], strict=True)
        return statistics.median(a / b for a, b in pairs)

    def spread(self, slow: str, fast: str) -> tuple[float, float]:
        """Smallest and largest ratio over the rounds."""
        ratios = [a / b for a, b in zip(self.seconds[slow], self.seconds[fast], strict=True)]
        return min(ratios), max(ratios)


def compare(
    alternatives: Mapping[str, Callable[[], Any]], rounds: int = 5, turn_s: float = 0.0
) -> Comparison:
    """Run all alternatives once unmeasured, then in turns for some rounds.

    Parameters
    ----------
    turn_s : a turn lasts at least so long, by calling again: the first call after somebody else's
        turn finds the caches full of what is not its own.
    """
    for run in alternatives.values():
        run()
    seconds: dict[str, list[float]] = {name: [] for name in alternatives}
    for _ in range(rounds):
        for name, run in alternatives.items():
            gc.collect()
            calls, start = 0, time.perf_counter()
            while not calls or time.perf_counter() - start < turn_s:
                run()
                calls += 1
            seconds[name].append((time.perf_counter() - start) / calls)
    return Comparison({name: tuple(times) for name, times in seconds.items()})
