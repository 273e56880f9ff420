"""Every vehicle is tried as master; those whose bound cannot win are skipped.

The star of a master costs no less than its bound (`Star.bound`), which is quick to work out. Stars
are planned in the order of their bounds, until the next bound is no better than the cheapest star.
With few vehicles nobody is skipped: then every star is also completed by the company that can be
had off its master's route.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from .answers import Answer, improved, of_pair, of_star
from .master import LONGEST, longest_first
from .question import Question
from .star import Star, StarChoice

__all__ = ["Tried", "candidates", "fixed_master"]

FULLY_TRIED = 12
"""Up to so many vehicles nobody is skipped, and each one's star is completed and improved."""

MOST_NODES = 5_000
"""On larger networks only the cheapest stars are completed, for every turn is a search."""

MOST_COMPLETED = 2
"""How many stars are completed where there are many vehicles or nodes."""

MOST_UNBOUNDED = 16
"""Masters tried where the costs of all routes do not fit into memory at once."""


@dataclass(slots=True, eq=False)
class Tried:
    """What came of trying masters.

    Attributes
    ----------
    answers : list of Answer
        One for each master that was planned, in no order of cost.
    compared : int
        Masters that were planned, or whose bound cannot win.
    blind : float
        Cost of the cheapest answer without a clock; inf if there was none.
    left_out : list of Answer
        Cheaper for all, but somebody would pay more than alone.
    """

    answers: list[Answer] = field(default_factory=list)
    compared: int = 0
    blind: float = np.inf
    left_out: list[Answer] = field(default_factory=list)


def fixed_master(question: Question) -> int | None:
    """Return the master that the problem asks for.

    Parameters
    ----------
    question : Question
        What is asked.

    Returns
    -------
    int or None
        A position; None if the best is to be found.
    """
    asked = question.problem.master
    names = [item.vehicle for item in question.ends]
    if asked is None:
        return None
    if asked in names:
        return names.index(asked)
    assert asked == LONGEST  # Problem takes nothing else
    return longest_first(question.lengths_m)[0]


def candidates(question: Question) -> Tried:
    """Return the answers from which the best is taken.

    Parameters
    ----------
    question : Question
        What is asked.

    Returns
    -------
    Tried
        At least one answer unless nobody can join anybody.
    """
    found = Tried()
    fixed = fixed_master(question)
    every = longest_first(question.lengths_m)
    if "D" in question.problem.cases:
        _try_pair(question, every[0] if fixed is None else fixed, found)
    if star_cases(question):
        _try_stars(question, [fixed] if fixed is not None else every, found)
    return found


def star_cases(question: Question) -> tuple[str, ...]:
    """Return the cases with one master that are asked for.

    Parameters
    ----------
    question : Question
        What is asked.

    Returns
    -------
    tuple of str
        Of "A", "B" and "C".
    """
    return tuple(case for case in question.problem.cases if case != "D")


def _try_pair(question: Question, first: int, found: Tried) -> None:
    asked = question.problem.case == "D"
    answers = list(of_pair(question, first))
    most = question.problem.max_platoon
    if most is not None and most < 2:
        return
    some = [answer for answer in answers if question.in_time(answer.draft)]
    member = question.problem.optimum == "member"
    kept = [answer for answer in some if not (member and question.losers(answer.draft))]
    if kept or (asked and some):
        found.answers.append((kept or some)[0])
    elif some:
        found.left_out.append(some[0])
    elif answers:
        found.blind = answers[0].cost


def _try_stars(question: Question, masters: Sequence[int], found: Tried) -> None:
    fixed = len(masters) == 1
    stars = list(_stars(question, masters))
    skips = len(stars) > FULLY_TRIED
    planned: list[tuple[float, int, Star, list[StarChoice]]] = []
    best = np.inf
    for number, star in enumerate(stars):
        if skips and star.bound >= best:
            break  # those after it have bounds no better
        choices = _choices(question, star)
        best = min(best, choices[0].cost)
        planned.append((choices[0].cost, number, star, choices))
    # Of equally good ones that of the longest route, as the paper has it.
    order = {vehicle: rank for rank, vehicle in enumerate(masters)}
    planned.sort(key=lambda one: (one[0], order[one[2].master]))
    every = not skips and question.net.n <= MOST_NODES
    if every:
        planned.sort(key=lambda one: order[one[2].master])
    for rank, (_, _, star, choices) in enumerate(planned):
        answer = of_star(question, star, choices)
        if answer is None:
            continue
        if every or rank < MOST_COMPLETED:
            answer = improved(question, answer, fixed and question.problem.master is not None)
        found.answers.append(answer)
    found.compared, found.blind = len(stars), min(best, found.blind)


def _stars(question: Question, masters: Sequence[int]) -> Iterator[Star]:
    """Yield the stars to try, the most promising first where some may be skipped."""
    tried = list(masters)
    if len(tried) > FULLY_TRIED and not question.join_costs.at_once:
        tried = sorted(tried, key=lambda one: -_shared_m(question, one))[:MOST_UNBOUNDED]
    stars = [
        Star(
            question.net, question.weights, question.ends, master, question.router,
            question.alone, question.join_costs,
        )
        for master in tried
    ]  # fmt: skip
    if len(stars) > FULLY_TRIED:
        stars.sort(key=lambda star: star.bound)
    yield from stars


def _shared_m(question: Question, master: int) -> float:
    """Return how much of its route others drive too, counted for each of them [m]."""
    on = np.zeros(question.net.m, np.int64)
    for route in question.alone:
        on[route] += 1
    own = question.alone[master]
    return float(((on[own] - 1) * question.net.length_m[own]).sum())


def _choices(question: Question, star: Star) -> list[StarChoice]:
    """Return what each case chooses, the cheapest first, of equally good ones the simplest."""
    optimum = question.problem.optimum
    found = [star.choose(case, optimum) for case in star_cases(question)]
    distinct: dict[bytes, StarChoice] = {}
    for choice in found:
        points = choice.points
        key = points.merge_index.tobytes() + points.separation_index.tobytes()
        distinct.setdefault(key, choice)
    # Cost that differs by last digits alone is the same.
    least = min(choice.cost for choice in found)
    return sorted(
        distinct.values(), key=lambda choice: choice.cost if choice.cost > least * (1 + 1e-9) else 0
    )
