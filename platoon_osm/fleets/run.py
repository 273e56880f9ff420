"""One search for a fleet's plan, and for what no plan can undercut, in turns.

The bound's shares tell the search what a platoon's price is worth to each truck, and the best plan
tells the bound how far it may reach. Both take turns, each on all cores: the bound until the shares
are good, then the plan with them, then the bound with that plan as its aim, then the plan again;
last of all the bound is worked out anew in whole numbers. Where few instants matter the exact model
is solved between.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from ..costs.time_prices import TimePrices
from ..errors import ScenarioError
from ..plans.fleet import FleetRecord, Moment
from ..plans.plan import Plan
from ..plans.proof import Proof
from .bound.bound import ROUNDING, Bound
from .certificate import certificate_of, write_fleet
from .conditions import conditions_of
from .cooling import heat_at
from .exact import Ways
from .exact_told import ExactTold, exact_told
from .instance import Instance
from .kept_apart import Apart
from .lanes import TICK_S
from .limits import Limits
from .memory import many_records, peak_mb
from .model import FleetModel
from .phases import Phases, phases_of
from .plan.schedules import Schedules
from .plan.search import FleetSearch
from .progress import Progress
from .shifting import shifted
from .stopping import Course
from .together import Together
from .trees.starting import tree_start
from .writing import Writing
from .written import plan_of

__all__ = ["FEW_MOVES", "FleetRun"]

Ints = NDArray[np.int64]

STEPS = 100
"""Steps of the bound in a round; it is evaluated over all pairs after each."""

STALLED, STALLED_ROUNDS, FINE_STALLED_ROUNDS = 0.01, 4, 6
"""A bound that closed less than this part of the gap in so many rounds goes on by fine steps, which
rise after some rounds only; if these stall, too, it leaves its time to the plan."""

MOVES, FEW_MOVES = 4000, 1000
"""Neighbourhoods of the plan in a round, and with as few trucks."""

NOTHING_LEFT = 1e-5
"""A gap below this share of the savings is worth no more search."""


class FleetRun:
    """One search, its bound, and what is told of them.

    Parameters
    ----------
    model : FleetModel
        The problem in whole numbers.
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
        self.model, self.limits, self.course = model, limits, course
        self.write_to, self.on_progress = write_to, on_progress
        names = [trip.vehicle for trip in model.question.problem.trips]
        self.bound = Bound(model.instance, threads=limits.cores, seed=limits.seed)
        self._guiding, self._fine = (self.bound.shares, self.bound.guide), False
        self.apart = Apart(names, limits.apart)
        self.together = Together(model, limits.together, self.apart.pairs)
        self.search = self._searching()
        self.alone = int(model.instance.alone_cost.sum())
        self.exact: ExactTold | None = None
        self.history: list[Moment] = []
        self._writing = Writing(course, self.alone, model.instance.trucks, write_to is not None)

    def _searched_instance(self) -> Instance:
        """Return the problem that the search works on."""
        return self.model.instance

    def _searching(self) -> FleetSearch:
        """Return a search that keeps to who must and must not drive together."""
        # They drive nowhere until they respond to the others.
        nowhere = (np.zeros(0, np.int64), np.zeros(0, np.int64))
        fixed = dict.fromkeys(self.together.trucks, nowhere)
        if self.limits.per_trip == "many" and any({*pair} & {*fixed} for pair in self.apart.pairs):
            raise ScenarioError(
                "fleet: vehicles that must drive together are planned as if nobody kept apart from "
                "them; let trips have one platoon, or leave one of both out"
            )
        search = FleetSearch(
            self._searched_instance(), threads=self.limits.cores, seed=self.limits.seed,
            apart=self.apart.rows, fixed=fixed,
        )  # fmt: skip
        if self.together:
            self.together.answered(search, from_nothing=True)
        return search

    def plan(self) -> Plan:
        """Search to the end of the course and return the plan."""
        return self._finished(self._searched())

    def _searched(self) -> str:
        """Search to the end of the course; return why it ended."""
        restricted = bool(self.apart) or bool(self.together)
        start = None if restricted else tree_start(self.model.instance)
        if start is not None:
            self.search.take(*start)
        return self._follow(phases_of(self.model.instance.trucks))

    def _follow(self, phases: Phases) -> str:
        """Do what each phase says; return why the search ended."""
        at, trucks = self.course, self.model.instance.trucks
        for number, (who, until) in enumerate(phases):
            stop = at.until(until)
            if who == "construct":
                self.search.construct(*self._guiding)
                self._tell()
                continue
            if who == "exact":
                self._try_exact(until)
                continue
            begun, still, rising = at.share, True, [self.bound.cost]
            while still and at.share < until and not stop():
                if self._proved:
                    return "proved"
                if who == "bound":
                    self._raise(stop)
                    rising.append(self.bound.cost)
                    if self.bound.settled or self._stalled(rising):
                        still, rising = self._refined(), [self.bound.cost]
                else:
                    heat = heat_at(phases, number, begun, at.share, trucks)
                    moves = MOVES if trucks > FEW_MOVES else FEW_MOVES
                    self.search.improve(*self._guiding, moves, heat, stop)
                    if self.together:
                        self.together.answered(self.search)
                at.rounds += 1
                self._tell()
            if at.interrupted:
                break
        return self._why_ended(phases[-1][1])

    def _raise(self, stop: Callable[[], bool]) -> None:
        """Raise the bound by some steps; fine ones leave the shares that guide the search alone."""
        self.bound.improve(float(self.cost), STEPS, stop, self._fine)
        if not self._fine:
            self._guiding = self.bound.shares, self.bound.guide

    def _refined(self) -> bool:
        """Go on by fine steps; tell whether that is new."""
        before, self._fine = self._fine, True
        return not before

    def _stalled(self, rising: Sequence[float]) -> bool:
        """Tell whether the bound rose so little that the plan can use the time better."""
        rounds = FINE_STALLED_ROUNDS if self._fine else STALLED_ROUNDS
        if len(rising) <= rounds:
            return False
        rise = rising[-1] - rising[-1 - rounds]
        return rise <= STALLED * (self.cost - rising[-1])

    def _why_ended(self, until: float) -> str:
        """Return why the search ended that might have gone on until a share of the course."""
        if self._nothing_left(self.planned_cost):
            return "proved"
        if self.course.interrupted:
            return "interrupted"
        return "time" if self.limits.time_s and self.course.share >= until else "rounds"

    @property
    def _proved(self) -> bool:
        """Whether nothing is left between plan and bound."""
        return self._nothing_left(self.cost)

    def _nothing_left(self, cost: int) -> bool:
        """Tell whether nothing is left between what a plan costs and the bound."""
        left = cost - self.least
        if left <= max(1.0, NOTHING_LEFT * (self.alone - self.least)):
            return True
        # So little may be what the bound was lowered by for rounding; in whole numbers it is exact.
        return left <= 2 * ROUNDING * self.alone and cost - self.bound.certified()[1] <= 1

    @property
    def cost(self) -> int:
        """What the best plan costs [grains]."""
        if self.exact is None:
            return self.search.cost
        return min(self.search.cost, self.exact.cost)

    @property
    def planned_cost(self) -> int:
        """What the plan costs that would be written now [grains]."""
        return self.cost

    @property
    def least(self) -> float:
        """What no plan undercuts, by shares or by the exact model [grains]."""
        return self.bound.cost if self.exact is None else max(self.bound.cost, self.exact.least)

    def _try_exact(self, until: float) -> None:
        """Solve the exact model, where it is small and plan and bound are not at one yet."""
        instance, late = self.model.instance, self.course.share >= until
        restricted = bool(self.apart) or bool(self.together)
        if late or self._proved or instance.waiting or restricted:
            return
        left_s = None
        if self.limits.time_s is not None:
            left_s = max(1.0, (until - self.course.share) * self.limits.time_s)
        found = exact_told(instance, left_s, self.course.until(until))
        if found is not None:
            self.exact = found
            self.course.rounds += 1
            self._tell()

    def _tell(self) -> None:
        """Note how far it is, tell whoever wants to know, and write what is best."""
        unit = self.model.lanes.grains
        saving = (self.alone - self.planned_cost) / unit
        bound = max(saving, (self.alone - self.least) / unit)
        now = Progress(min(1.0, self.course.share), self.course.seconds, saving, bound)
        last = self.history[-1] if self.history else None
        if last is None or saving > last.saving or bound < last.bound:
            self.history.append(Moment(round(now.seconds, 3), saving, bound))
        if self.on_progress is not None:
            self.on_progress(now)
        if self._writing.is_due(self.planned_cost, now.seconds):
            self._finished("interrupted")
            self._writing.done(self.planned_cost, now.seconds)

    def _best_ways(self) -> Ways:
        """Return lanes and instants of the best plan."""
        if self.exact is not None and self.exact.cost <= self.search.cost:
            return self.exact.ways
        return self.search.best.ways()

    def _written(self) -> tuple[Plan, Ways, int]:
        """Return the best plan, its ways, and what they cost [grains]."""
        lanes, departs = self._best_ways()
        moved, paid = shifted(self.model.instance, lanes, departs), self.cost
        if self.limits.per_trip == "many" and self.apart.kept_by((lanes, moved)):
            departs, paid = self._with_less_waiting(lanes, departs, moved)
        if self.together:
            lanes, departs = self.together.kept((lanes, departs))
            paid = Schedules.of(lanes, departs).cost(self.model.instance)
        plan = plan_of(self.model, lanes, departs, Proof("heuristic", 0.0, None), None)
        return plan, (lanes, departs), paid

    def _with_less_waiting(
        self, lanes: list[Ints], departs: list[Ints], moved: list[Ints]
    ) -> tuple[list[Ints], int]:
        """Return the better of two timings of a plan, and what it costs [grains]."""
        instance = self.model.instance
        if not instance.waiting:
            return moved, self.cost
        costs = [Schedules.of(lanes, own).cost(instance) for own in (departs, moved)]
        return (moved, costs[1]) if costs[1] <= costs[0] else (departs, costs[0])

    def _waiting_cost(self, plan: Plan, ways: Ways) -> float:
        """Return what waiting on the road costs."""
        del plan
        waiting = TimePrices.of(self.model.question.problem.objective).waiting
        ticks = Schedules.of(*ways).waited(self.model.instance) if waiting > 0 else 0
        return waiting * ticks * TICK_S

    def _finished(self, ended: str, write: bool = True) -> Plan:
        """Return the plan as it is now, and write it if that is wanted."""
        with many_records():
            return self._told(ended, write)

    def _told(self, ended: str, write: bool) -> Plan:
        model, unit = self.model, self.model.lanes.grains
        shares, certified = self.bound.certified()
        conditions = conditions_of(model, self.limits)
        plan, (lanes, departs), paid = self._written()
        cost = sum(share.cost for stretch in plan.stretches for share in stretch.shares)
        alone = sum(trip.alone.cost for trip in plan.trips)
        cost += self._waiting_cost(plan, (lanes, departs))
        saving = alone - cost
        bound = max(saving, (self.alone - certified) / unit)
        told = None
        if self.exact is not None and self.exact.least > certified:
            told = max(saving, (self.alone - self.exact.least) / unit)
        # What is saved is worked out anew edge by edge; costs in grains are rounded lane by lane.
        record = FleetRecord(
            saving=saving, bound=bound, alone_cost=alone, seconds=self.course.seconds,
            peak_mb=peak_mb(), routes=self.limits.routes, per_trip=self.limits.per_trip,
            max_platoon=model.instance.largest or None, seed=self.limits.seed, ended=ended,
            rounds=self.course.rounds, history=tuple(self.history), unserved=model.unserved,
            conditions=conditions, exact_bound=told,
        )  # fmt: skip
        plan = plan.told(fleet=record, proof=Proof.of(cost, alone - record.most, conditions))
        if write and self.write_to is not None:
            certificate = certificate_of(model, shares, lanes, departs, paid, certified)
            write_fleet(plan, certificate, self.write_to)
        return plan
