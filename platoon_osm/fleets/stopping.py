"""When a search ends: at its limit of time or rounds, when asked to, or when nothing is left."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

from .limits import Limits

__all__ = ["Course"]


class Course:
    """How far a search is on its course, as a share of what it may use.

    Parameters
    ----------
    limits : Limits
        Of time and rounds.
    asked_to_end : callable
        Whether somebody wants it to end.
    """

    def __init__(self, limits: Limits, asked_to_end: Callable[[], bool]) -> None:
        self._begun = time.monotonic()
        self._limits, self._asked_to_end = limits, asked_to_end
        self.rounds = 0
        """Rounds that are done."""
        self.closing_s = 0.0
        """What is kept of the limit for telling the plan and writing it, at most half of it [s]."""

    @property
    def seconds(self) -> float:
        """Since it began [s]."""
        return time.monotonic() - self._begun

    @property
    def _search_s(self) -> float:
        """When the search has to end, so that the plan is written within the limit [s]."""
        limit = self._limits.time_s
        return math.inf if limit is None else limit - min(self.closing_s, limit / 2)

    @property
    def share(self) -> float:
        """How much of the time or of the rounds is used, whichever is more."""
        limits = self._limits
        of_time = self.seconds / self._search_s if limits.time_s else 0.0
        of_rounds = self.rounds / limits.rounds if limits.rounds else 0.0
        return max(of_time, of_rounds)

    @property
    def interrupted(self) -> bool:
        """Whether somebody wants it to end."""
        return self._asked_to_end()

    def until(self, share: float) -> Callable[[], bool]:
        """Return what tells whether work that may last until some share has to end.

        Parameters
        ----------
        share : float
            Of the course.

        Returns
        -------
        callable
            True once time has come that far, or somebody wants it to end. Rounds do not count:
            each is done whole, so that it is the same on every machine.
        """

        def ends() -> bool:
            return self.seconds >= share * self._search_s or self._asked_to_end()

        return ends
