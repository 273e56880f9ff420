"""Why a vehicle drives alone, truly."""

from __future__ import annotations

import numpy as np

from .answers import Answer
from .cases import MemberPlans
from .masters import fixed_master
from .question import Question

__all__ = ["reasons_alone"]


def reasons_alone(
    question: Question, answer: Answer, points: MemberPlans | None = None
) -> list[str]:
    """Return why each vehicle drives alone.

    Parameters
    ----------
    question : Question
        What was asked.
    answer : Answer
        What was chosen.
    points : MemberPlans, optional
        The members' points, where they tell whether the case can apply.

    Returns
    -------
    list of str, (N,)
        Empty for those in company, and for the master.
    """
    names = [item.vehicle for item in question.ends]
    reasons = [""] * len(names)
    for index, own in enumerate(answer.draft.companies):
        if index == answer.master or any(len(company) > 1 for company in own):
            continue
        reasons[index] = _reason(question, answer, index, names)
    del points
    return reasons


def _reason(question: Question, answer: Answer, index: int, names: list[str]) -> str:
    master = answer.master
    if master is None:
        return f"driving alone costs less than any way with {names[1 - index]}"
    asked = question.problem.case
    if asked in ("A", "B") and not _applies(question, asked, index, master):
        end = "destination" if asked == "A" else "origin"
        return f"case {asked} does not apply: its {end} is not on the route of {names[master]}"
    clock = question.windows is not None
    bounds = ", or the clock forbids them" if clock else ""
    if question.problem.max_platoon is not None:
        bounds += f", or platoons of {question.problem.max_platoon} are full"
    if len(names) == 2 or fixed_master(question) is not None:
        return f"driving alone costs less than any way with {names[master]}{bounds}"
    return f"driving alone costs less than any company that was found{bounds}"


def _applies(question: Question, case: str, index: int, master: int) -> bool:
    own = question.ends[index]
    places = own.destinations if case == "A" else own.origins
    nodes = question.net.path_nodes(question.alone[master])
    return bool(np.isin(nodes, list(places)).any())
