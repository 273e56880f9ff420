"""The plan under driving rules that is expected to save most if vehicles are late.

Looked at are the cheapest plan, the best with each of its vehicles as master, the cheapest with
each vehicle that has company driven by itself, those in which nobody arrives much later than alone,
and everybody alone. All are compared on the same days of delays. It is the best of these, not of
all plans; breaks and rests keep their length on late days, and the law is not judged again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ...plans.plan import Plan
from ..meeting_chances import DelaysSimulated, runs_for, simulate_delays
from ..most_expected import MOST_APART, MOST_RUNS, later_than, most_expected
from .legal_question import LegalQuestion
from .stars import Planned, alone_plan, planned_platoons

__all__ = ["most_robust_under_law"]

SPANS = 3_000
"""Spans of departures that are looked at for each other plan, about."""

HURRIED_S = (3600.0, 900.0)
"""How much later than alone all may arrive in further plans [s]."""


def most_robust_under_law(
    legal: LegalQuestion, plan: Plan, finish: Callable[[Planned], Plan]
) -> Plan:
    """Return the plan that is expected to save most.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law; its problem has delays.
    plan : Plan
        The cheapest plan, with its times.
    finish : callable
        Writes a plan with its times.

    Returns
    -------
    Plan
        With a remark on what was compared.
    """
    problem = legal.question.problem
    assert problem.delays is not None
    delays, runs = problem.delays, runs_for(plan, MOST_RUNS)

    def played(one: Plan) -> DelaysSimulated:
        return simulate_delays(one, delays, runs=runs, objective=problem.objective)

    compared = [(plan, played(plan))]
    for planned in _others(legal, plan):
        other = finish(planned)
        known = any(
            (one.stretches, one.ways, one.timetable)
            == (other.stretches, other.ways, other.timetable)
            for one, _ in compared
        )
        if not known and not later_than(other, plan):
            compared.append((other, played(other)))
    return most_expected(compared)


def _others(legal: LegalQuestion, plan: Plan) -> Iterator[Planned]:
    everyone = range(len(legal.question.ends))
    together = sorted({k for one in plan.stretches if one.together for k in one.vehicles})
    if len(together) <= MOST_APART:
        if legal.question.fixed_master is None:
            for master in together:
                yield planned_platoons(legal, SPANS, [master])
        for alone in together:
            yield planned_platoons(legal, SPANS, None, [k for k in everyone if k != alone])
    for limit_s in HURRIED_S:
        hurried = planned_platoons(legal.hurried(limit_s), SPANS)
        hurried.bound = hurried.waiting_bound = None
        yield hurried
    nobody = alone_plan(legal)
    nobody.bound = nobody.waiting_bound = None
    yield nobody
