"""Answers to a problem before the best is taken: stars of masters, and a pair's free routes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from ..plans.stretches import runs_alone, runs_along
from .company.draft import NO_CHEAPER, Draft, Floats, Order
from .company.side_by_side import side_by_side
from .company.turns import improved_in_turns
from .fleet import Fleet
from .member_plans import MemberPlans
from .no_wait import best_without_waiting, bound_if_waiting
from .pair import PairPlan, plan_pair
from .question import Question
from .star import Star, StarChoice
from .timed_star import TimedStar
from .timing.timed_pair import PairVehicle, TimedPair, plan_timed_pair

__all__ = ["IN_TIME", "Answer", "alone", "improved", "of_pair", "of_star", "of_timed_pair"]

IN_TIME = "all keep their limits of time"
ONE_LEADER = "one leads all the way"

OWN_ROUTE = "on its own route"
NO_WAIT = "on its own route, which does not wait"
ANY_WAIT = "on its own route, whether it waits or not"

CLOCK = (
    "driving times are the same alone and together",
    "nothing depends on the hour",
    "waiting before departure is free",
)
"""What the curve of costs against departures takes for granted."""

PRICED = "nobody takes a slower way to wait less"
"""What it takes for granted where time is priced."""


@dataclass(frozen=True, slots=True, eq=False)
class Answer:
    """One way to drive, and how it was found.

    Attributes
    ----------
    draft : Draft
        Who drives what with whom.
    costs : ndarray of float, (N,)
        What each pays.
    case : str
        "A", "B", "C" or "D".
    master : int or None
        The vehicle that the others join; None in case D.
    bound : float or None
        No answer of this case and master costs less; None if it is not known.
    conditions : tuple of str
        What that holds for, beside what it always does.
    manner : str
        Of which drives of the master the bound holds.
    time_cost : float
        What waiting and delay cost at least besides, at the objective's prices.
    """

    draft: Draft
    costs: Floats
    case: str
    master: int | None
    bound: float | None
    conditions: tuple[str, ...] = ()
    manner: str = OWN_ROUTE
    time_cost: float = 0.0

    @property
    def cost(self) -> float:
        """Cost of all together."""
        return float(self.costs.sum())

    @property
    def weighed(self) -> float:
        """By what answers are compared: the cost, with that of waiting and delay."""
        return self.cost + self.time_cost

    def weighed_by(self, question: Question) -> Answer:
        """Return the answer with what waiting and delay cost.

        Parameters
        ----------
        question : Question
            What is asked.

        Returns
        -------
        Answer
            What is proved of its cost alone is proved no more where time costs something.
        """
        price = question.time_cost(self.draft)
        bound = None if price else self.bound
        return replace(self, time_cost=price, bound=bound) if price else self


def alone(question: Question, master: int) -> Answer:
    """Return the answer in which everyone drives alone.

    Parameters
    ----------
    question : Question
        What is asked.
    master : int
        Whom the others might have joined.

    Returns
    -------
    Answer
        Always possible.
    """
    draft = Draft.alone(question.alone)
    case = question.problem.case
    free = "C" if case == "best" else case
    return Answer(draft, draft.costs(question.fleet), free, master, None).weighed_by(question)


def of_star(question: Question, star: Star, choices: list[StarChoice]) -> Answer | None:
    """Return the cheapest choice of points that can be driven in time.

    Parameters
    ----------
    question : Question
        What is asked.
    star : Star
        One master and its members.
    choices : list of StarChoice
        Of the cases asked for, the cheapest first.

    Returns
    -------
    Answer or None
        None if nobody can join this master.
    """
    found = _blind(question, star, choices)
    free = question.windows is None or question.time_prices.are_free
    if free and (question.windows is None or (found is not None and found[0] == 0)):
        return None if found is None else found[1]
    timed = _timed(question, star)
    blind = None if found is None else found[1].weighed_by(question)
    if timed is None or (blind is not None and blind.weighed < timed.weighed * (1 - NO_CHEAPER)):
        return None if blind is None else replace(blind, bound=None)
    return timed


def _blind(question: Question, star: Star, choices: list[StarChoice]) -> tuple[int, Answer] | None:
    """Return the first choice without a clock that happens to be in time, and its place."""
    most = question.problem.max_platoon
    for place, choice in enumerate(choices):
        points = choice.points
        if most is not None:
            points = star.within(points, choice.case, most)
        answer = _starred(question, star, choice.case, points)
        if points is choice.points:
            answer = replace(answer, bound=choice.bound)
        if question.allows(answer.draft):
            return place, answer
    return None


def _timed(question: Question, star: Star) -> Answer | None:
    """Return the best plan of a master that leaves at one moment and does not wait."""
    clocked = TimedStar(question, star)
    plans = [
        (case, found)
        for case in question.star_cases
        if (found := best_without_waiting(clocked, case)) is not None
    ]  # fmt: skip
    if not plans:
        return None
    level = min(found.choice.cost for _, found in plans) * (1 + NO_CHEAPER)
    case, best = next(one for one in plans if one[1].choice.cost <= level)
    points, chosen = clocked.points(case), best.choice.points
    most = question.problem.max_platoon
    if most is not None:
        chosen = star.within(chosen, case, most, clocked.open_costs(points, best.departure))
    draft = Draft.of(star.routes(chosen, partial(clocked.way, points, best.departure)))
    costs = draft.costs(question.fleet)
    if not question.allows(draft):
        return None
    answer = Answer(draft, costs, case, star.master, None).weighed_by(question)
    # Costs of a plan are those of driving; a bound that counts time is none of them alone.
    fewer = chosen is not best.choice.points and question.problem.optimum == "member"
    if not best.is_proved or answer.time_cost or fewer:
        return answer
    bound, manner = min(found.choice.bound for _, found in plans), NO_WAIT
    if clocked.is_free:
        whatever = min(bound_if_waiting(clocked, one) for one, _ in plans)
        if float(costs.sum()) <= whatever * (1 + NO_CHEAPER):
            bound, manner = whatever, ANY_WAIT
    conditions = CLOCK if clocked.is_free else (*CLOCK, PRICED)
    return replace(answer, bound=bound, conditions=conditions, manner=manner)


def _starred(question: Question, star: Star, case: str, points: MemberPlans) -> Answer:
    draft = Draft.of(star.routes(points))
    return Answer(draft, draft.costs(question.fleet), case, star.master, None)


def of_pair(question: Question, first: int) -> Iterator[Answer]:
    """Return the plan of two vehicles whose routes are both free, under either leader.

    Parameters
    ----------
    question : Question
        Of two trips.
    first : int
        Who leads rather than the other.

    Yields
    ------
    Answer
        The same routes with one leader, then with the other; once if they stay apart.
    """
    own, other = question.ends[first], question.ends[1 - first]
    fleet = question.fleet
    pair = plan_pair(
        question.net, fleet[first],
        (own.origin, other.origin), (own.destination, other.destination),
        trees=(question.trees[first], question.trees[1 - first]), pair_weight=_together(fleet),
        engine=question.problem.engine, alike=fleet[0] is fleet[1],
    )  # fmt: skip
    if not len(pair.shared):
        draft = Draft.alone(question.alone)
        yield Answer(draft, draft.costs(question.fleet), "D", None, pair.cost)
        return
    for order in ((first, 1 - first), (1 - first, first)):
        draft = _paired(first, order, pair)
        yield Answer(draft, draft.costs(question.fleet), "D", None, pair.cost)


def of_timed_pair(question: Question, first: int) -> Iterator[Answer]:
    """Return the cheapest plan of two vehicles with free routes among those that are in time.

    Parameters
    ----------
    question : Question
        Of two trips, one at least with times.
    first : int
        Who leads rather than the other.

    Yields
    ------
    Answer
        Under either leader, the cheaper first; once if they stay apart.
    """
    fleet, windows = question.fleet, question.windows
    assert windows is not None
    prices = question.time_prices
    orders = [(first, 1 - first), (1 - first, first)]
    vehicles = [
        PairVehicle(
            own.origin, own.destination, fleet.alone(k), fleet.drive_s((k,)),
            trees.tree(own.origin).dist, trees.tree(own.destination, False).dist,
            windows[k], question.alone_s[k],
            0.0 if question.asked_windows[k].earliest is None else prices.delay,
        )
        for k, (own, trees) in enumerate(zip(question.ends, question.trees, strict=True))
    ]  # fmt: skip
    conditions = (IN_TIME,) if fleet.is_alike else (IN_TIME, ONE_LEADER)
    found: dict[bytes, TimedPair | None] = {}
    answers: list[Answer] = []
    for order in orders:
        leader, other = order
        together = fleet.barred(0, fleet.barred(1, fleet[leader].master + fleet[other].platoon))
        key = together.tobytes()
        if key not in found:
            found[key] = plan_timed_pair(
                question.net, (vehicles[first], vehicles[1 - first]), together,
                fleet.drive_s((0, 1)), float(question.solo.sum()),
                prices.waiting,
            )  # fmt: skip
        pair = found[key]
        if pair is None:
            continue
        draft = _paired(first, order, pair)
        answer = Answer(draft, draft.costs(fleet), "D", None, None, conditions)
        answers.append(answer.weighed_by(question))
    if not answers:
        draft, cost = Draft.alone(question.alone), float(question.solo.sum())
        yield Answer(draft, draft.costs(fleet), "D", None, cost, conditions)
    # Where time has a price it was weighed too, so of the cost alone nothing is proved.
    pairs = [pair for pair in found.values() if pair is not None]
    paid = any(answer.time_cost for answer in answers)
    bound = None if paid else min((pair.cost for pair in pairs), default=None)
    for answer in sorted(answers, key=lambda one: one.weighed):
        yield replace(answer, bound=bound)


def _paired(first: int, order: tuple[int, int], pair: PairPlan | TimedPair) -> Draft:
    """Return the draft of a pair whose first vehicle is `first`, under some leader."""
    ways = [
        [
            *runs_alone(pair.before[k], index),
            *runs_along(pair.shared, [order] * len(pair.shared)),
            *runs_alone(pair.after[k], index),
        ]
        for k, index in enumerate((first, 1 - first))
    ]
    return Draft.of(ways if first == 0 else ways[::-1])


def _together(fleet: Fleet) -> Floats:
    """Return what two vehicles pay together, whoever of them leads for less; inf where barred."""
    pair = np.minimum(fleet[0].master + fleet[1].platoon, fleet[1].master + fleet[0].platoon)
    return fleet.barred(0, fleet.barred(1, pair))


def improved(question: Question, answer: Answer) -> Answer:
    """Return an answer with all company there can be, then improved in turns.

    Parameters
    ----------
    question : Question
        What is asked.
    answer : Answer
        Of a star.

    Returns
    -------
    Answer
        Never dearer; the given one if nothing was found.
    """
    problem = question.problem
    if problem.company == "master" or problem.case not in ("C", "best"):
        # In A and B as they are asked for, who drives beside the platoon may not be able to stay.
        return answer
    order = Order(question.lengths_m, answer.master)
    draft = side_by_side(answer.draft, question.fleet, order, problem.max_platoon, question.allows)
    # A master that the problem names keeps its route.
    movable = set(range(len(question.ends))) - {question.fixed_master}
    draft = improved_in_turns(
        question.net, draft, question.fleet, order, problem.max_platoon, question.allows,
        movable, question.node_pairs,
    )  # fmt: skip
    if draft is answer.draft:
        return answer
    case = "C" if problem.case == "best" else answer.case
    return Answer(draft, draft.costs(question.fleet), case, answer.master, None)
