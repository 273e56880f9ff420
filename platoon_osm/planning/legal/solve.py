"""From a question under driving rules to a plan with its timetable, and what is proved about it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from ...plans.clock import late_by
from ...plans.lateness import NOT_LAWFUL
from ...plans.plan import Plan
from ...plans.proof import Proof
from ...plans.text_table import listed
from ...plans.timetable import LATE_S
from ...vehicles.profile import Vehicle
from ..answers import Answer
from ..best import ANY_WAY, ONE_STRETCH, TIME_PRICED, Best
from ..company.bound import least_total
from ..company.draft import NO_CHEAPER, Draft
from ..question import Question
from ..quick_alone import told_quick
from ..reasons import reasons_alone
from .conditions import (
    ALL_TOGETHER,
    MEMBERS,
    STANDS_FOR_LAW,
    STANDS_LONGER,
    STOPPED,
    of_every_plan,
)
from .lawful_plan import timed_under_law
from .legal_question import LegalQuestion
from .stars import Planned, planned_platoons
from .time_priced import least_with_time
from .what_would_do import what_would_do

__all__ = ["solved_under_law"]

Write = Callable[[Question, Best, Sequence[str]], Plan]
"""Makes a plan without times of an answer and the reasons of those who drive alone."""


def solved_under_law(question: Question, vehicles: Sequence[Vehicle], write: Write) -> Plan:
    """Return the best legal plan of a question.

    Parameters
    ----------
    question : Question
        What is asked, with driving rules that have limits.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.
    write : callable
        Makes a plan without times.

    Returns
    -------
    Plan
        With its timetable; nobody breaks a rule in it.

    Raises
    ------
    ScenarioError
        No trip names a time.
    NoLegalTripError
        A vehicle has no legal trip at all.
    """
    legal = LegalQuestion(question, vehicles)
    # Who has no cheap route in time takes a quick one there.
    question = legal.question

    def finish(planned: Planned, free: Planned | None = None) -> Plan:
        draft = Draft.of(planned.runs)
        master = planned.master if planned.master is not None else question.first_master
        asked = question.problem.case
        case = "C" if asked == "best" else asked
        answer = Answer(draft, draft.costs(question.fleet), case, master, planned.bound)
        best = Best(answer, _proof(legal, planned, answer, free), tuple(planned.tried), ())
        plan = write(question, best, reasons_alone(question, answer))
        return timed_under_law(legal, plan, planned.runs, planned.driven)

    if question.time_prices.are_free:
        timed = finish(planned_platoons(legal))
    else:
        timed = least_with_time(legal, finish)
    if question.problem.robust:
        from .robust_platoons import most_robust_under_law

        timed = most_robust_under_law(legal, timed, finish)
    return replace(timed, remarks=(*timed.remarks, *_late(legal, timed), *told_quick(question)))


def _proof(legal: LegalQuestion, planned: Planned, answer: Answer, free: Planned | None) -> Proof:
    """Tell what is proved of a plan's cost.

    Where time is paid for, whatever was planned without its prices (`free`) costs no more before
    it is paid, so its bounds hold.
    """
    question = legal.question
    any_plan = least_total(
        question.net, question.fleet, question.node_pairs, question.least, answer.cost
    )
    common = (*of_every_plan(question), *((TIME_PRICED,) if free is not None else ()))
    if len(question.ends) < 2:
        return Proof.of(answer.cost, answer.cost, common)
    stopped = (STOPPED,) if planned.unfinished else ()
    asked = planned if free is None else free
    aim = ALL_TOGETHER if question.problem.optimum == "system" else MEMBERS
    any_way = _proved(answer.cost, any_plan, (ANY_WAY, *stopped, *common), any_plan)
    if asked.bound is None or asked.waiting_bound is None:
        return any_way
    if free is not None:
        if asked.waiting_bound <= any_plan:
            return any_way
        fixed = question.fixed_master
        leads = "a master" if fixed is None else f"master {question.ends[fixed].vehicle}"
        whose = (f"{leads} on its own route, {STANDS_LONGER}", ONE_STRETCH, aim)
        least = min(asked.waiting_bound, answer.cost)
        return _proved(answer.cost, least, (*whose, *common), any_plan)
    name = question.ends[answer.master or 0].vehicle
    tried = f"{planned.masters} of {planned.masters} masters tried"
    compared = (tried,) if question.fixed_master is None else ()
    assert planned.bound is not None
    assert planned.waiting_bound is not None
    bound, stands = planned.bound, STANDS_FOR_LAW
    if planned.waits or planned.waiting_bound >= answer.cost * (1 - NO_CHEAPER):
        bound, stands = planned.waiting_bound, STANDS_LONGER
    kept = f"master {name} on its own route, {stands}"
    who = (kept, *compared, *stopped, ONE_STRETCH, aim)
    return _proved(answer.cost, min(bound, answer.cost), (*who, *common), any_plan)


def _proved(cost: float, bound: float, conditions: Sequence[str], any_plan: float) -> Proof:
    """Return the proof of a bound; a search that ended early may have reached it all the same."""
    proof = Proof.of(cost, bound, tuple(conditions), any_plan)
    if proof.kind != "exact":
        return proof
    return replace(proof, conditions=tuple(one for one in conditions if one != STOPPED))


def _late(legal: LegalQuestion, plan: Plan) -> Iterator[str]:
    """Yield who is late, or leaves late, for the law leaves it no other choice."""
    assert plan.timetable is not None
    late = [
        f"{times.vehicle} by {late_by(times.late_s)}"
        for times in plan.timetable.vehicles
        if times.late_s > LATE_S
    ]
    if late:
        yield (
            f"not feasible in time within the law: late even alone: {listed(late)}; give earlier "
            "departures or later arrivals"
        )
    held = [
        f"{trip.vehicle} by {late_by(own.after_latest_s)}"
        for trip, own in zip(plan.trips, legal.alone, strict=True)
        if own.after_latest_s
    ]
    if held:
        yield (
            f"{NOT_LAWFUL}: leave after their latest departure, for they must rest before: "
            f"{listed(held)}"
        )
    yield from what_would_do(legal)
