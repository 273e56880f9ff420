"""Plan a whole fleet: search for a good plan and for what no plan can undercut, side by side.

The bound's shares tell the search what a platoon's price is worth to each truck, and the best plan
tells the bound how far it may reach. Both take turns, each on all cores: the bound until the shares
are good, then the plan with them, then the bound with that plan as its aim, then the plan again;
last of all the bound is worked out anew in whole numbers.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from ..interrupts import asked_to_end
from ..planning.problem import Problem
from ..plans.fleet import FleetRecord, Moment, Unserved
from ..plans.plan import Plan
from ..plans.proof import Proof
from .bound.bound import Bound
from .certificate import certificate_of, write_fleet
from .conditions import conditions_of
from .limits import Limits
from .model import FleetModel, modelled
from .plan.search import FleetSearch
from .shifting import shifted
from .stopping import Course
from .written import plan_of

__all__ = ["plan_fleet"]

Ints = NDArray[np.int64]

COURSE = (
    ("bound", 0.05), ("construct", 0.05), ("bound", 0.15), ("construct", 0.15), ("bound", 0.40),
    ("construct", 0.40), ("plan", 0.64), ("bound", 0.74), ("plan", 0.96),
)  # fmt: skip
"""Who works until which share of the course."""

CROWDED_COURSE = (
    ("bound", 0.34), ("construct", 0.34), ("plan", 0.66), ("bound", 0.76), ("plan", 0.96),
)  # fmt: skip
"""The same from `CROWD` trucks on, where the first construction is worth waiting for."""

CROWD = 10_000

STEPS = 100
"""Steps of the bound in a round; it is evaluated over all pairs after each."""

MOVES, FEW_MOVES = 4000, 1000
"""Neighbourhoods of the plan in a round, and with as few trucks."""

COLD = 0.15
"""The last part of a phase accepts no plan that costs more."""

NOTHING_LEFT = 1e-5
"""A gap below this share of the savings is worth no more search."""

WRITING = 0.05
"""At most this share of the time goes into writing what is best so far."""


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a fleet's search is.

    Attributes
    ----------
    share : float
        Of the time or rounds that it may use.
    seconds : float
        Since it began [s].
    saving, bound : float
        What its best plan saves, and what no plan can save more than, in the unit of costs.
    gap : float
        By what share of the bound more could be saved at most.
    """

    share: float
    seconds: float
    saving: float
    bound: float

    @property
    def gap(self) -> float:
        """By what share of the bound more could be saved at most."""
        return max(0.0, (self.bound - self.saving) / self.bound) if self.bound > 0 else 0.0


def plan_fleet(
    problem: Problem,
    limits: Limits | None = None,
    *,
    write_to: str | os.PathLike[str] | None = None,
    on_progress: Callable[[Progress], None] | None = None,
    unserved: Sequence[Unserved] = (),
) -> Plan:
    """Plan who drives with whom in a whole fleet, and tell how much more could be saved at most.

    Ctrl-C ends the search, and the best plan so far is returned.

    Parameters
    ----------
    problem : Problem
        The trips, each with at least one time; its case and its master play no part, for a fleet
        has none. Its `max_platoon` is the largest platoon.
    limits : Limits, optional
        How long to search, on which routes, and who may drive with whom.
    write_to : str or path, optional
        A file for the plan with its certificate, as `platoon-osm certify` reads it; what is best so
        far is written as the search goes on, so that it is there if the process is killed.
    on_progress : callable, optional
        Told how far it is after each round.
    unserved : sequence of Unserved, optional
        Trips that are known to be none, as rows of a table that could not be read; they are listed
        before those that are found to be.

    Returns
    -------
    Plan
        Its `fleet` tells saving, bound, gap and conditions, and trips that could not be planned.

    Raises
    ------
    PlatoonError
        A question that fleets are not planned for, in one line; or no trip that can be planned.
    """
    if not isinstance(problem, Problem):
        raise ScenarioError(
            f"fleet: {brief(problem)} is no Problem; make one from a network and trips"
        )
    own = Limits() if limits is None else limits
    if not isinstance(own, Limits):
        raise ScenarioError(f"fleet: limits are {brief(limits)}; give Limits(...)")
    if own.time_s is None and own.rounds is None:
        raise ScenarioError("fleet: limits name neither time_s nor rounds; give one of them")
    with asked_to_end() as ends:
        course = Course(own, ends)
        model = modelled(problem, own, unserved)
        return _Search(model, own, course, write_to, on_progress).run()


class _Search:
    """One search, its bound, and what is told of them."""

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
        self.bound = Bound(model.instance, threads=limits.cores, seed=limits.seed)
        self.search = FleetSearch(model.instance, threads=limits.cores, seed=limits.seed)
        self.alone = int(model.instance.alone_cost.sum())
        self.history: list[Moment] = []
        self.written_s = 0.0
        self.written_at = 0.0
        self.written_cost = self.alone + 1

    def run(self) -> Plan:
        """Search to the end of the course and return the plan."""
        course = CROWDED_COURSE if self.model.instance.trucks >= CROWD else COURSE
        ended = self._follow(course)
        return self._finished(ended)

    def _follow(self, course: tuple[tuple[str, float], ...]) -> str:
        """Do what the course says; return why it ended."""
        at = self.course
        for who, until in course:
            stop = at.until(until)
            if who == "construct":
                self.search.construct(self.bound.shares, self.bound.guide)
                self._tell()
                continue
            begun, still = at.share, True
            while still and at.share < until and not stop():
                if self._proved:
                    return "proved"
                if who == "bound":
                    self.bound.improve(float(self.search.cost), STEPS, stop)
                    still = not self.bound.settled
                else:
                    left = (until - at.share) / max(until - begun, 1e-9)
                    heat = max(0.0, (left - COLD) / (1 - COLD))
                    moves = MOVES if self.model.instance.trucks > FEW_MOVES else FEW_MOVES
                    self.search.improve(self.bound.shares, self.bound.guide, moves, heat, stop)
                at.rounds += 1
                self._tell()
            if at.interrupted:
                return "interrupted"
        if self._proved:
            return "proved"
        return "time" if self.limits.time_s and at.share >= COURSE[-1][1] else "rounds"

    @property
    def _proved(self) -> bool:
        """Whether nothing is left between plan and bound."""
        room = self.alone - self.bound.cost
        return self.search.cost - self.bound.cost <= max(1.0, NOTHING_LEFT * room)

    def _tell(self) -> None:
        """Note how far it is, tell whoever wants to know, and write what is best."""
        unit = self.model.lanes.grains
        saving = (self.alone - self.search.cost) / unit
        bound = max(saving, (self.alone - self.bound.cost) / unit)
        now = Progress(min(1.0, self.course.share), self.course.seconds, saving, bound)
        last = self.history[-1] if self.history else None
        if last is None or saving > last.saving or bound < last.bound:
            self.history.append(Moment(round(now.seconds, 3), saving, bound))
        if self.on_progress is not None:
            self.on_progress(now)
        spent = self.written_s <= WRITING * now.seconds
        if self.write_to is not None and self.search.cost < self.written_cost and spent:
            self._finished("interrupted")
            self.written_s += self.course.seconds - now.seconds
            self.written_cost = self.search.cost

    def _finished(self, ended: str) -> Plan:
        """Return the plan as it is now, and write it if that is wanted."""
        model, unit = self.model, self.model.lanes.grains
        shares, least = self.bound.certified()
        best = self.search.best
        lanes = [best.lanes[k, :n].astype(np.int64) for k, n in enumerate(best.count)]
        departs = shifted(
            model.instance, lanes, [best.departs[k, :n] for k, n in enumerate(best.count)]
        )
        conditions = conditions_of(model, self.limits)
        plan = plan_of(model, lanes, departs, Proof("heuristic", 0.0, None), None)
        cost = sum(share.cost for stretch in plan.stretches for share in stretch.shares)
        alone = sum(trip.alone.cost for trip in plan.trips)
        # Costs in grains are rounded lane by lane: that much the bound may be off.
        bound = min(cost, least / unit)
        record = FleetRecord(
            saving=alone - cost, bound=max(alone - cost, alone - bound), alone_cost=alone,
            seconds=self.course.seconds, peak_mb=_peak_mb(), routes=self.limits.routes,
            per_trip=self.limits.per_trip, max_platoon=model.instance.largest or None,
            seed=self.limits.seed, ended=ended, rounds=self.course.rounds,
            history=tuple(self.history), unserved=model.unserved, conditions=conditions,
        )  # fmt: skip
        plan = replace(plan, fleet=record, proof=Proof.of(cost, bound, conditions))
        if self.write_to is not None:
            certificate = certificate_of(model, shares, lanes, departs, self.search.cost, least)
            write_fleet(plan, certificate, self.write_to)
        return plan


def _peak_mb() -> float:
    """Return the most memory this process has held [MB]; 0 where that is not told."""
    try:
        import resource
    except ImportError:  # not on Windows
        return 0.0
    peak: Any = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return float(peak) / (1e6 if sys.platform == "darwin" else 1e3)
