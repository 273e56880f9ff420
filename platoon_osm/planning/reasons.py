"""Why a vehicle drives alone, truly."""

from __future__ import annotations

import numpy as np

from ..driving.rules import limits_of
from .answers import Answer
from .question import Question

__all__ = ["reasons_alone"]


def reasons_alone(question: Question, answer: Answer) -> list[str]:
    """Return why each vehicle drives alone.

    Parameters
    ----------
    question : Question
        What was asked.
    answer : Answer
        What was chosen.

    Returns
    -------
    list of str, (N,)
        Empty for those in company, and for the master.
    """
    names = [item.vehicle for item in question.ends]
    reasons = [""] * len(names)
    alone = [
        index
        for index, own in enumerate(answer.draft.companies)
        if index != answer.master and not any(len(company) > 1 for company in own)
    ]
    blind = _would_join(question, answer) if alone else set()
    for index in alone:
        reasons[index] = _reason(question, answer, index, names, index in blind)
    return reasons


def _would_join(question: Question, answer: Answer) -> set[int]:
    """Return who would join the master if there were no clock; nobody where there is none."""
    if question.windows is None or answer.master is None or question.problem.method != "dijkstra":
        return set()
    star = question.star(answer.master)
    asked = question.problem.case
    points = star.choose("C" if asked == "best" else asked, "member").points
    return {star.members[k] for k in np.flatnonzero(points.merge_index >= 0).tolist()}


def _reason(
    question: Question, answer: Answer, index: int, names: list[str], would_join: bool
) -> str:
    master = answer.master
    if master is None:
        return f"driving alone costs less than any way with {names[1 - index]}"
    asked = question.problem.case
    if asked in ("A", "B") and not _applies(question, asked, index, master):
        end = "destination" if asked == "A" else "origin"
        return f"case {asked} does not apply: its {end} is not on the route of {names[master]}"
    if would_join:
        problem = question.problem
        law = limits_of(problem.rules, problem.trips[index].driver.drivers).limits_driving
        forbid = "the clock and the driving rules forbid" if law else "the clock forbids"
        return f"{forbid} what it could save with {names[master]}"
    most = question.problem.max_platoon
    bounds = "" if most is None else f", or platoons of {most} are full"
    if len(names) == 2 or question.fixed_master is not None:
        return f"driving alone costs less than any way with {names[master]}{bounds}"
    return f"driving alone costs less than any company that was found{bounds}"


def _applies(question: Question, case: str, index: int, master: int) -> bool:
    own = question.ends[index]
    places = own.destinations if case == "A" else own.origins
    nodes = question.net.path_nodes(question.alone[master])
    return bool(np.isin(nodes, list(places)).any())
