"""The plan that is expected to save most if vehicles are late, among those that were looked at.

The cheapest plan may rest on a merge that often fails. Looked at are

- the cheapest plan, the best of each master that was tried, and everybody alone;
- the cheapest plan with each vehicle that has company driven by itself;
- the best of each master where what company saves counts as much as it is likely to come about:
  with a chance p of meeting, a member of a platoon is planned at solo - p (solo - platoon), so a
  detour for company is taken only if it pays on average;
- the most promising of these with movers that aim to be at each merge some minutes earlier, and
  with the early start that is best for each merge by itself (`chance/giving_up.py`).

All are compared on the same days drawn at random, so that their differences are known better than
each by itself; another plan is taken only if it saves more than the cheapest by two standard errors
of the difference. It is the best of these, not of all plans, and the cost that is proved about is
that of a day on which nobody is late.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..chance.giving_up import early_start_s
from ..costs.time_prices import TimePrices
from ..network.placed import network_below
from ..plans.plan import Plan
from ..vehicles.profile import Vehicle
from .answers import Answer, alone
from .apart import apart
from .best import Best
from .masters import candidates
from .meeting_chances import DelaysSimulated, runs_for, simulate_delays
from .most_expected import (
    KEPT_APART,
    MOST_APART,
    MOST_RUNS,
    ROBUST,
    later_than,
    most_expected,
)  # fmt: skip
from .question import Question
from .reasons import reasons_alone
from .timing.days import Day, Stand
from .timing.hours_check import broken_hours

__all__ = ["Finish", "most_robust"]

BUFFERS_MIN = (2.0, 5.0, 10.0, 15.0, 20.0)
"""How much earlier movers aim to be there [min]."""
MOST_BUFFER_S = 3600.0
"""Nobody aims to be there earlier than this by itself [s]."""
MOST_BUFFERED = 3
"""How many of the best plans are tried with movers that come earlier."""
SURE = 0.999
"""Merges that succeed so often need no second look at what they are worth."""

Finish = Callable[[Best, Sequence[str], Sequence[Day] | None], Plan]
"""Makes a plan with times of an answer, reasons of those who drive alone, and stops asked for."""


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A plan that was looked at, and what it takes to make it again with other times."""

    best: Best
    reasons: Sequence[str]
    plan: Plan
    days: DelaysSimulated

    @property
    def expected(self) -> float:
        return self.days.chances.expected_saving


def most_robust(
    question: Question, best: Best, plan: Plan, vehicles: Sequence[Vehicle], finish: Finish
) -> Plan:
    """Return the plan that is expected to save most.

    Parameters
    ----------
    question : Question
        What is asked; its problem has delays.
    best : Best
        The cheapest answer.
    plan : Plan
        What became of it, with its times.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.
    finish : callable
        Makes a plan of another answer.

    Returns
    -------
    Plan
        With a remark on what was compared; the given one if it has no times.
    """
    if plan.timetable is None:
        return plan
    return _Choice(question, best, plan, vehicles, finish).made()


@dataclass(slots=True)
class _Choice:
    """A choice among plans."""

    question: Question
    best: Best
    plan: Plan
    vehicles: Sequence[Vehicle]
    finish: Finish

    def made(self) -> Plan:
        """Return the plan that is chosen."""
        reasons = reasons_alone(self.question, self.best.answer)
        first = _Candidate(self.best, reasons, self.plan, self._simulated(self.plan))
        compared = [first]
        for best, why in self._answers(first):
            self._look_at(compared, best, why, None)
        compared.sort(key=lambda one: -one.expected)
        for one in compared[:MOST_BUFFERED]:
            for days in _buffers(one, self._prices):
                self._look_at(compared, one.best, one.reasons, days)
        others = [one for one in compared if one is not first]
        return most_expected([(one.plan, one.days) for one in (first, *others)])

    @property
    def _prices(self) -> TimePrices:
        return self.question.time_prices

    def _simulated(self, plan: Plan) -> DelaysSimulated:
        problem = self.question.problem
        assert problem.delays is not None
        return simulate_delays(
            plan, problem.delays, runs=runs_for(self.plan, MOST_RUNS), objective=problem.objective
        )

    def _look_at(
        self,
        compared: list[_Candidate],
        best: Best,
        reasons: Sequence[str],
        days: Sequence[Day] | None,
    ) -> None:
        """Add a plan to those compared, if nobody is later or breaks more than by the cheapest."""
        plan = self.finish(best, reasons, days)
        if later_than(plan, self.plan) or any(_same(plan, one.plan) for one in compared):
            return
        net = network_below(self.question.net)
        broken = [len(list(broken_hours(one, net, self.vehicles))) for one in (plan, self.plan)]
        if broken[0] <= broken[1]:
            compared.append(_Candidate(best, reasons, plan, self._simulated(plan)))

    def _answers(self, first: _Candidate) -> Iterator[tuple[Best, list[str]]]:
        """Yield other answers to the same question, each with its reasons."""
        question = self.question
        drafted = [*self.best.others, *self._by_chance(first)]
        for answer in (*drafted, alone(question, question.first_master)):
            if answer.draft is not self.best.answer.draft:
                yield self._of(answer), reasons_alone(question, answer)
        together = {
            k for stretch in first.plan.stretches if stretch.together for k in stretch.vehicles
        }
        if len(together) <= MOST_APART:
            for k in sorted(together):
                found, reasons = apart(question, self.best, {k}, ROBUST, KEPT_APART)
                if question.allows(found.answer.draft):
                    yield found, reasons

    def _by_chance(self, first: _Candidate) -> Iterator[Answer]:
        """Yield answers of the question in which company saves as often as it comes about."""
        question = self.question
        meetings = first.days.chances.meetings
        worth = sum(max(one.gain, 0.0) for one in meetings)
        if not worth:
            return
        chance = sum(max(one.gain, 0.0) * one.chance for one in meetings) / worth
        if chance > SURE:
            return
        for answer in candidates(question.with_chance(chance)).answers:
            draft = answer.draft
            if draft.together and question.allows(draft):
                costs = draft.costs(question.fleet)
                yield Answer(draft, costs, answer.case, answer.master, None).weighed_by(question)

    def _of(self, answer: Answer) -> Best:
        """Return an answer with what is proved about it: that others may cost less."""
        proof = self.best.proof
        bound = None if proof.bound is None else min(proof.bound, answer.cost)
        kind = proof.kind if bound is None else "bound"
        return replace(
            self.best,
            answer=answer,
            proof=replace(proof, kind=kind, cost=answer.cost, bound=bound),
        )


def _buffers(one: _Candidate, prices: TimePrices) -> Iterator[list[Day]]:
    """Yield stops that let movers be at their merges earlier."""
    merges = [
        (event, one.days.chances.of_event(number))
        for number, event in enumerate(one.plan.events)
        if event.kind == "merge"
    ]
    wanted = [[60.0 * minutes] * len(merges) for minutes in BUFFERS_MIN]
    own = []
    for event, meeting in merges:
        price = prices.waiting * len(event.movers)
        room = MOST_BUFFER_S if meeting is None else min(meeting.window_s, MOST_BUFFER_S)
        spread, gain = (0.0, 0.0) if meeting is None else (meeting.spread_s, meeting.gain)
        own.append(max(early_start_s(spread, gain, price, room), 0.0))
    for buffers in (*wanted, own):
        stands: list[list[Stand]] = [[] for _ in one.plan.trips]
        for (event, _), least_s in zip(merges, buffers, strict=True):
            for mover in event.movers:
                leg = one.plan.ways[mover].index(event.stretch)
                if leg and least_s:
                    stands[mover].append(Stand(leg, least_s, ("company",)))
        if any(stands):
            yield [Day(tuple(sorted(some, key=lambda stand: stand.leg))) for some in stands]


def _same(plan: Plan, other: Plan) -> bool:
    """Tell whether two plans drive the same at the same times."""
    if (plan.stretches, plan.ways) != (other.stretches, other.ways):
        return False
    own, theirs = (
        np.array([span for times in one.times if times for span in times.legs])
        for one in (plan, other)
    )
    return bool(np.allclose(own, theirs, atol=1.0))
