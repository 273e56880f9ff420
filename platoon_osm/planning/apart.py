"""Company that makes somebody break a driving ban or a road's hours is given up.

Times are found for company that was chosen by cost. If somebody then is on a closed road though it
could keep the law alone, those who break it whatever they do drive apart from the others; if that
is not enough, all who were linked with them drive alone.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from ..network.placed import network_below
from ..plans.plan import Plan
from ..plans.stretches import linked
from ..plans.text_table import listed
from ..vehicles.profile import Vehicle
from .answers import Answer
from .best import Best
from .company.draft import Company, Draft
from .question import Question
from .reasons import reasons_alone
from .timing.hours_check import broken_hours

__all__ = ["apart", "lawful_company"]

APART = "driving bans and hours of roads come before company"
KEPT_APART = "company would break driving bans or hours of roads"

Finish = Callable[[Best, Sequence[str]], Plan]
"""Makes a plan with times of an answer and the reasons of those who drive alone."""


def lawful_company(
    question: Question, best: Best, plan: Plan, vehicles: Sequence[Vehicle], finish: Finish
) -> Plan:
    """Return a plan whose company makes nobody break a closing who could keep it alone.

    Parameters
    ----------
    question : Question
        What is asked.
    best : Best
        The answer to it.
    plan : Plan
        What became of that answer, with its times.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.
    finish : callable
        Makes a plan of another answer.

    Returns
    -------
    Plan
        The same if company does no harm.
    """
    net = network_below(question.net)

    def out(who: Collection[int]) -> tuple[Best, list[str]]:
        return apart(question, best, who, APART, KEPT_APART)

    def breaking(one: Plan) -> set[int]:
        return {found.vehicle for found in broken_hours(one, net, vehicles)}

    broken = breaking(plan)
    groups = linked([stretch.vehicles for stretch in plan.stretches], len(plan.trips))
    harmed = {k for group in groups if len(group) > 1 and broken & set(group) for k in group}
    if not harmed:
        return plan
    never = breaking(finish(*out(harmed)))
    could = broken - never
    hurt = {k for group in groups if could & set(group) for k in group}
    if not hurt:
        return plan
    if never & hurt:
        some = finish(*out(never & hurt))
        if breaking(some) <= broken - could:
            return some
    return finish(*out(hurt))


def apart(
    question: Question, best: Best, who: Collection[int], condition: str, reason: str
) -> tuple[Best, list[str]]:
    """Return an answer in which some drive alone who have company by another.

    Parameters
    ----------
    question : Question
        What is asked.
    best : Best
        The other answer.
    who : collection of int
        Positions in the plan.
    condition : str
        What the proof holds for besides.
    reason : str
        Why they drive alone.

    Returns
    -------
    best : Best
        The answer and what is proved about it.
    reasons : list of str, (N,)
        Why each vehicle drives alone; empty for those in company.
    """
    draft = best.answer.draft
    routes = [question.alone[k] if k in who else route for k, route in enumerate(draft.routes)]
    companies: list[list[Company]] = [
        [(k,)] * len(routes[k])
        if k in who
        else [tuple(one for one in company if one not in who) for company in own]
        for k, own in enumerate(draft.companies)
    ]
    made = Draft(tuple(routes), tuple(companies))
    costs = made.costs(question.fleet)
    answer = Answer(made, costs, best.answer.case, best.answer.master, best.answer.bound)
    proof = replace(
        best.proof,
        kind=best.proof.kind if best.proof.bound is None else "bound",
        cost=answer.cost,
        conditions=(*best.proof.conditions, condition),
    )
    names = [question.ends[k].vehicle for k in sorted(who)]
    reasons = reasons_alone(question, answer)
    for k, own in enumerate(made.companies):
        if any(len(company) > 1 for company in draft.companies[k]) and not any(
            len(company) > 1 for company in own
        ):
            reasons[k] = reason
    remark = f"driven apart, for {reason}: {listed(names)}"
    return replace(best, answer=answer, proof=proof, remarks=(*best.remarks, remark)), reasons
