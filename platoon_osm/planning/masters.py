"""Every vehicle is tried as master; those whose bound cannot win are skipped.

The star of a master costs no less than its bound (`Star.bound`), which is quick to work out. Stars
are planned in the order of their bounds, until the next bound is no better than the cheapest star.
With few vehicles nobody is skipped: then every star is also completed by the company that can be
had off its master's route.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from .answers import Answer, improved, of_pair, of_star, of_timed_pair
from .company.draft import NO_CHEAPER
from .problem import Optimum
from .question import Question
from .star import Star, StarChoice

__all__ = ["Tried", "candidates", "choices_of"]

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
        Cost of the cheapest answer without a clock; inf if there was none, or a pair's best in time
        is among the answers.
    left_out : list of Answer
        Cheaper for all, but somebody would pay more than alone.
    """

    answers: list[Answer] = field(default_factory=list)
    compared: int = 0
    blind: float = np.inf
    left_out: list[Answer] = field(default_factory=list)


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
    fixed = question.fixed_master
    if "D" in question.problem.cases:
        _try_pair(question, question.first_master, found)
    if question.star_cases:
        _try_stars(question, question.by_length if fixed is None else [fixed], found)
    return found


def _try_pair(question: Question, first: int, found: Tried) -> None:
    asked = question.problem.case == "D"
    answers = list(of_pair(question, first))
    some = [answer for answer in answers if question.in_time(answer.draft)]
    blind = np.inf if some else answers[0].cost
    # What is in time without looking is the best of all, unless time has a price.
    if question.windows is not None and not (some and question.time_prices.are_free):
        answers = list(of_timed_pair(question, first))
        some = [answer for answer in answers if question.in_time(answer.draft)]
    member = question.problem.optimum == "member"
    kept = [answer for answer in some if not (member and question.losers(answer.draft))]
    if kept or (asked and some):
        found.answers.append((kept or some)[0])
        return
    found.blind = blind
    found.left_out += some[:1]


def _try_stars(question: Question, masters: Sequence[int], found: Tried) -> None:
    stars = _stars(question, masters)
    skips = len(stars) > FULLY_TRIED
    planned: list[tuple[Star, list[StarChoice]]] = []
    best = np.inf
    for star in stars:
        if skips and star.bound >= best:
            break  # those after it have bounds no better
        choices = choices_of(star, question.star_cases, question.problem.optimum)
        best = min(best, choices[0].cost)
        planned.append((star, choices))
    # Of equally good ones that of the longest route, as the paper has it.
    rank = {vehicle: place for place, vehicle in enumerate(masters)}
    planned.sort(key=lambda one: rank[one[0].master])
    complete = len(planned)
    if skips or question.net.n > MOST_NODES:
        planned.sort(key=lambda one: one[1][0].cost)
        complete = MOST_COMPLETED
    for place, (star, choices) in enumerate(planned):
        answer = of_star(question, star, choices)
        if answer is not None:
            found.answers.append(_completed(question, answer) if place < complete else answer)
    found.compared, found.blind = len(stars), min(best, found.blind)


def _completed(question: Question, answer: Answer) -> Answer:
    """Return an answer with the company that can be had off its master's route, if it is cheaper.

    That is looked for by cost alone, so where time has a price it may be no better.
    """
    better = improved(question, answer).weighed_by(question)
    return better if better.weighed <= answer.weighed else answer


def _stars(question: Question, masters: Sequence[int]) -> list[Star]:
    """Return the stars to try, the most promising first where some may be skipped."""
    tried = list(masters)
    if len(tried) > FULLY_TRIED and not question.join_costs.at_once:
        shared = _shared_m(question)
        tried = sorted(tried, key=lambda one: -shared[one])[:MOST_UNBOUNDED]
    stars = [question.star(master) for master in tried]
    return sorted(stars, key=lambda star: star.bound) if len(stars) > FULLY_TRIED else stars


def _shared_m(question: Question) -> list[float]:
    """Return how much of each one's route others drive too, counted for each of them [m]."""
    on = np.zeros(question.net.m, np.int64)
    for route in question.alone:
        on[route] += 1
    return [float(((on[own] - 1) * question.net.length_m[own]).sum()) for own in question.alone]


def choices_of(star: Star, cases: Sequence[str], optimum: Optimum) -> list[StarChoice]:
    """Return what cases choose, the cheapest first, of equally good ones the simplest.

    Parameters
    ----------
    star : Star
        A master and its members.
    cases : sequence of str
        Of "A", "B" and "C".
    optimum : {"member", "system"}
        Whose cost is least.

    Returns
    -------
    list of StarChoice
        Each choice of points once, under the first case that has it.
    """
    found = [star.choose(case, optimum) for case in cases]
    distinct: dict[bytes, StarChoice] = {}
    for choice in found:
        points = choice.points
        key = points.merge_index.tobytes() + points.separation_index.tobytes()
        distinct.setdefault(key, choice)
    # Cost that differs by last digits alone is the same.
    level = min(choice.cost for choice in found) * (1 + NO_CHEAPER)
    return sorted(distinct.values(), key=lambda choice: choice.cost if choice.cost > level else 0)
