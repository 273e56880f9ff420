"""Masters compared under driving rules: each is searched until it cannot be better than the best.

Those come first whose bound without a clock is least. Each search has a turn, in which a master is
given up as soon as all would pay no less than in the best plan that is known; then those that came
to no end go on, the one with the least bound first.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field

import numpy as np

from ...plans.records import MasterTried
from ..company.draft import NO_CHEAPER
from ..star import Star
from .legal_question import LegalQuestion
from .platoon.record import gained
from .star_in_time import Platooned, StarSearch, case_of

__all__ = ["Compared"]

FIRST_SPANS = 600
"""Spans of departures that are looked at for a master at its first turn."""

LEAST_SPANS = 500
"""But no fewer than this, however many masters there are."""


@dataclass(slots=True, eq=False)
class _Open:
    """A master whose search has not come to its end."""

    search: StarSearch
    bound: float
    waiting_bound: float
    work: int


@dataclass(slots=True, eq=False)
class Compared:
    """The best star of some vehicles.

    Attributes
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    among : collection of int or None
        The vehicles that may join; None for all.
    least : float
        What all pay in the best plan that is known; at first alone.
    best : Platooned or None
        That plan; None if nobody joins anybody.
    bound, waiting_bound : float
        See `Planned`.
    tried : dict of int to MasterTried
        What masters would give that were not given up before, by vehicle.
    unfinished : bool
        Whether a search ended that might have found something better.
    work : int
        Spans of departures looked at, real trips counted by what they took.
    """

    legal: LegalQuestion
    among: Collection[int] | None
    least: float
    best: Platooned | None = None
    bound: float = np.inf
    waiting_bound: float = np.inf
    tried: dict[int, MasterTried] = field(default_factory=dict)
    unfinished: bool = False
    work: int = 0

    def search(self, stars: Sequence[Star], most_spans: int) -> None:
        """Compare masters.

        Parameters
        ----------
        stars : sequence of Star
            In the order of their bounds without a clock.
        most_spans : int
            Spans of departures that are looked at for all together, about.
        """
        self.bound = self.waiting_bound = self.least
        first = min(max(most_spans // max(len(stars), 1), LEAST_SPANS), FIRST_SPANS)
        left: list[_Open] = []
        for star in stars:
            if star.bound >= self.least * (1 - NO_CHEAPER):
                self._take(star.bound, star.bound)
                break  # those after it have bounds no better
            one = _Open(StarSearch(self.legal, star, self.among), -np.inf, -np.inf, 0)
            if not self._turn(one, first):
                left.append(one)
        left.sort(key=lambda one: one.bound)
        for place, one in enumerate(left):
            share = (most_spans - self.work) // (len(left) - place)
            ended = one.bound >= self.least * (1 - NO_CHEAPER)
            if not ended and share > 0:
                ended = self._turn(one, share)
            if not ended:
                self._take(one.bound, one.waiting_bound)
        self.unfinished = self.bound < self.least * (1 - NO_CHEAPER)

    def _take(self, bound: float, waiting_bound: float) -> None:
        """Count a master's bounds."""
        self.bound = min(self.bound, bound)
        self.waiting_bound = min(self.waiting_bound, waiting_bound)

    def _turn(self, one: _Open, spans: int) -> bool:
        """Search on with a master; return whether that came to an end."""
        found = one.search.go_on(spans, self.least)
        timing, master = found.timing, one.search.star.master
        self.work += timing.work - one.work
        one.work = timing.work
        one.bound, one.waiting_bound = timing.bound, timing.waiting_bound
        if np.isfinite(timing.cost):
            known = self.tried.get(master)
            if known is None or timing.cost < known.cost:
                self.tried[master] = MasterTried(master, case_of(self.legal.question), timing.cost)
        better = timing.cost < self.least * (1 - (NO_CHEAPER if self.best is None else 0))
        if better and found.joined and _allowed(self.legal, found):
            self.least, self.best = timing.cost, found
        if timing.proved:
            self._take(timing.bound, timing.waiting_bound)
        return timing.proved


def _allowed(legal: LegalQuestion, found: Platooned) -> bool:
    """Tell whether nobody pays more than alone, where members look at their own cost."""
    question = legal.question
    if question.problem.optimum == "system":
        return True
    star = found.star
    return gained(star.gain, found.together) >= -NO_CHEAPER * float(question.solo[star.master])
