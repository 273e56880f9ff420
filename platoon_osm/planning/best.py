"""The best answer to a problem, after times; and what is proved about it."""

from __future__ import annotations

from dataclasses import dataclass, replace

from ..plans.proof import Proof
from ..plans.records import MasterTried
from .answers import Answer, alone
from .company.bound import least_total
from .company.draft import NO_CHEAPER
from .masters import Tried, candidates
from .question import Question

__all__ = ["Best", "best_answer"]

WAITING_FREE = "waiting at merging points is free"
ALIKE = "vehicles are alike"
ONE_STRETCH = "one shared stretch for each member"
ANY_WAY = "all routes and companies of these trips are compared"
TIME_PRICED = "prices of waiting and delay count in the choice, not in the cost"
CLOCK_FORBIDS = "the clock forbids cheaper company, and this is the best that was found in time"


@dataclass(frozen=True, slots=True, eq=False)
class Best:
    """The answer that is taken.

    Attributes
    ----------
    answer : Answer
        Who drives what with whom.
    proof : Proof
        How good it is known to be.
    masters : tuple of MasterTried
        What each master that was tried would give, the cheapest first.
    remarks : tuple of str
        What a reader should know.
    others : tuple of Answer
        All answers from which it was taken.
    """

    answer: Answer
    proof: Proof
    masters: tuple[MasterTried, ...]
    remarks: tuple[str, ...]
    others: tuple[Answer, ...] = ()


def best_answer(question: Question) -> Best:
    """Return the cheapest answer that can be driven; of equally good ones the simplest.

    Parameters
    ----------
    question : Question
        What is asked.

    Returns
    -------
    Best
        The answer and what is proved about it.
    """
    fixed = question.fixed_master
    tried = candidates(question) if len(question.ends) > 1 else Tried()
    best = alone(question, question.first_master)
    # Who drives alone at the same cost as in company drives in company: the paper's tie rule.
    for answer in sorted(tried.answers, key=lambda one: (one.master is None, not _is_led(one))):
        level = 1 + NO_CHEAPER if not best.draft.together else 1 - NO_CHEAPER
        if answer.weighed < best.weighed * level and answer.draft.together:
            best = answer
    if fixed is None and best.master is not None and best.draft.together and not _is_led(best):
        led = best.draft.led()
        best = replace(best, master=led.index(max(led)), bound=None)
    if not best.draft.together:
        stayed = [one for one in tried.answers if not one.draft.together]
        same = [one for one in stayed if one.master == best.master or one.case == best.case]
        for one in same[:1]:
            best = replace(
                best, master=one.master, bound=one.bound, conditions=one.conditions,
                manner=one.manner,
            )  # fmt: skip
    return Best(
        best,
        _proof(question, best, tried),
        _masters(tried),
        tuple(_remarks(question, tried)),
        tuple(tried.answers),
    )


def _is_led(answer: Answer) -> bool:
    """Tell whether anybody drives with the master, as where others alone drive together."""
    master = answer.master
    return master is not None and any(len(one) > 1 for one in answer.draft.companies[master])


def _masters(tried: Tried) -> tuple[MasterTried, ...]:
    found = [
        MasterTried(answer.master, answer.case, answer.cost)
        for answer in tried.answers
        if answer.master is not None
    ]
    return tuple(sorted(found, key=lambda one: one.cost))


def _proof(question: Question, best: Answer, tried: Tried) -> Proof:
    any_plan = least_total(
        question.net, question.fleet, question.node_pairs, question.least, best.cost
    )
    prices = question.time_prices
    free = () if prices.waiting else (WAITING_FREE,)
    conditions = free if prices.are_free or question.windows is None else (*free, TIME_PRICED)
    if len(question.ends) < 2:
        return Proof.of(best.cost, best.cost, conditions)
    if best.case == "D" and best.bound is not None:
        # Vehicles that are not alike might part and meet again; that is not looked at.
        alike = (ALIKE,) if question.fleet.is_alike else ()
        own = (*conditions, *alike, ONE_STRETCH, *best.conditions)
        return Proof.of(best.cost, best.bound, own, any_plan)
    late = tried.blind < best.cost * (1 - NO_CHEAPER) and question.windows is not None
    late &= prices.are_free
    if best.bound is None or (late and not best.conditions):
        return _bounded(best, any_plan, late, conditions)
    assert best.master is not None
    name = question.ends[best.master].vehicle
    who = (f"master {name} {best.manner}", *_compared(question, tried), *best.conditions)
    return Proof.of(best.cost, min(best.bound, best.cost), (*who, *conditions), any_plan)


def _bounded(best: Answer, any_plan: float, late: bool, conditions: tuple[str, ...]) -> Proof:
    clock = (CLOCK_FORBIDS,) if late else ()
    return Proof.of(best.cost, any_plan, (ANY_WAY, *clock, *conditions), any_plan)


def _compared(question: Question, tried: Tried) -> tuple[str, ...]:
    if question.fixed_master is not None or not question.star_cases:
        return ()
    count = len(question.ends)
    planned = sum(answer.master is not None for answer in tried.answers)
    if tried.compared < count:
        return (f"{tried.compared} of {count} masters tried, those whose routes others share most",)
    if planned < count:
        return (f"{count} of {count} masters compared, {planned} of them planned in full",)
    return (f"{count} of {count} masters tried",)


def _remarks(question: Question, tried: Tried) -> list[str]:
    found = []
    for answer in tried.left_out:
        losers = question.losers(answer.draft)
        paid = answer.costs
        who = max(losers, key=lambda k: paid[k] / question.solo[k] if question.solo[k] else 0.0)
        more = paid[who] / question.solo[who] - 1 if question.solo[who] else 0.0
        saved = 1 - answer.cost / float(question.solo.sum())
        found.append(
            f"case {answer.case} would save {saved:.1%} in all, but {question.ends[who].vehicle} "
            f'would pay {more:.1%} more than alone; ask for objective "system" and share the gain'
        )
    return found
