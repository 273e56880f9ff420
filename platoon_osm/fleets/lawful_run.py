"""The search for a fleet's plan under driving rules: without law first, then within it.

The bound is that of all plans in the same windows, with or without breaks: a break or a rest is a
wait, so a lawful plan is one of them. Waiting is free in it, even where it has a price: a plan only
saves less for that. The search without law is the same, but in windows that are narrowed by the
pauses that every trip needs at least before and after a lane; its ways and meetings are then made
lawful and improved (`law.rounds`). Where waiting has a price, it is searched with that price in the
whole windows: narrowed ones would ask for waits that cost.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..costs.time_prices import TimePrices
from ..plans.plan import Plan
from ..plans.proof import Proof
from .exact import Ways
from .instance import Instance
from .lanes import TICK_S
from .law.narrowing import narrowed
from .law.rounds import LawfulFleet
from .law.written import instants_of, lawful_plan, longer_s
from .limits import Limits
from .model import FleetModel
from .phases import phases_of
from .progress import Progress
from .run import FleetRun
from .stopping import Course

__all__ = ["LawfulRun"]

WITHOUT_LAW = 0.6
"""The part of the course in which who drives with whom is searched without law."""

LAST = 0.96
"""The part of the course at which the search within the law ends."""

WORTH_A_ROUND = 1e-4
"""A round of neighbourhoods that adds less than this share of the savings is the last."""

TRIES = 1
"""Neighbourhoods of a round for each truck."""


class LawfulRun(FleetRun):
    """A search under driving rules.

    Parameters
    ----------
    model : FleetModel
        The problem in whole numbers, with its law.
    limits : Limits
        What it may do.
    course : Course
        How far it is.
    write_to : str or path or None
        Where the best plan so far is kept.
    on_progress : callable or None
        Told how far it is.
    """

    def __init__(
        self,
        model: FleetModel,
        limits: Limits,
        course: Course,
        write_to: str | os.PathLike[str] | None,
        on_progress: Callable[[Progress], None] | None,
    ) -> None:
        super().__init__(model, limits, course, write_to, on_progress)
        assert model.legal is not None
        price = TimePrices.of(model.question.problem.objective).waiting
        apart: list[set[int]] = [set() for _ in range(model.instance.trucks)]
        for one, other in self.apart.pairs:
            apart[one].add(other)
            apart[other].add(one)
        self.law = LawfulFleet(
            model, apart, limits.seed, math.floor(price * model.lanes.grains)
        )  # fmt: skip

    def _searched_instance(self) -> Instance:
        """Return what is planned without law, with its price of waiting."""
        model = self.model
        assert model.legal is not None
        price = TimePrices.of(model.question.problem.objective).waiting
        if not price:
            return narrowed(model.instance, model.legal)
        # Narrowed windows would ask for waits that cost, as if they were none that one has alone.
        return replace(model.instance, waiting=math.floor(price * TICK_S * model.lanes.grains))

    @property
    def planned_cost(self) -> int:
        """What the lawful plan costs so far [grains]."""
        return self.law.cost

    def plan(self) -> Plan:
        """Search to the end of the course and return the plan."""
        phases = phases_of(self.model.instance.trucks)
        self._follow(tuple((who, WITHOUT_LAW * until) for who, until in phases))
        stop = self.course.until(LAST)
        self.law.start(*self.search.best.ways())
        self._tell()
        self.law.improve(stop)
        self._tell()
        while self.course.share < LAST and not stop():
            before = self.law.cost
            self.law.vary(TRIES * self.model.instance.trucks, stop)
            self.law.improve(stop)
            self.course.rounds += 1
            self._tell()
            if before - self.law.cost <= WORTH_A_ROUND * (self.alone - self.law.cost):
                break
        return self._finished(self._why_ended(LAST))

    def _try_exact(self, until: float) -> None:
        """Solve the exact model where waiting is free, as it takes it."""
        if not self.law.waiting:
            super()._try_exact(until)

    def _written(self) -> tuple[Plan, Ways, int]:
        """Return the lawful plan, its ways, and what they cost [grains]."""
        schedules = self.law.schedules
        departs = instants_of(self.model, schedules)
        plan = lawful_plan(
            self.model, schedules, departs, self.law.alone, Proof("heuristic", 0.0, None)
        )
        lanes = [np.asarray(own.way.lanes, np.int64) for own in schedules]
        # The certificate counts driving alone: its waiting is free.
        return plan, (lanes, departs), self.law.occupied.cost()

    def _waiting_cost(self, plan: Plan, ways: Ways) -> float:
        """Return what is paid for standing longer than alone."""
        del ways
        return TimePrices.of(self.model.question.problem.objective).waiting * longer_s(plan)
