"""Who would be late alone by its cheapest route takes the cheapest one that is in time.

Of all ways of which none is both cheaper and quicker the first, in the order of their costs, that
is quick enough; where none is, a quickest one: so nobody is called late that has a way to be in
time, and who must be late is as little late as can be. Routes that company opens are another
matter: they are in time or not taken.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..plans.clock import late_by
from ..search.searches import engine_for
from ..search.trees import Trees
from .question import Question, QuickRoute
from .timing.pareto import SAME_S, Budget, Reach, labels_of

__all__ = ["by_quick_routes", "quicker_ways", "told_quick"]

Edges = NDArray[np.int64]

LAST_DIGITS = 1 + 1e-9


def by_quick_routes(question: Question) -> Question:
    """Return a question in which who would be late alone takes a quicker route, if there is one.

    Parameters
    ----------
    question : Question
        In which all take their cheapest routes.

    Returns
    -------
    Question
        Otherwise the same.
    """
    quick: dict[int, QuickRoute] = {}
    for index, asked in enumerate(question.asked_windows):
        if asked.earliest is None or asked.arrival is None:
            continue
        most_s = asked.arrival - asked.earliest
        late_s = question.fleet.route_s((index,), question.alone[index]) - most_s
        if late_s <= SAME_S:
            continue
        ways = quicker_ways(question, index)
        if not ways:
            continue
        # The last one is a quickest.
        in_time = (one for one in ways if question.fleet.route_s((index,), one) <= most_s + SAME_S)
        quick[index] = QuickRoute(next(in_time, ways[-1]), late_s)
    return question.by_quick_routes(quick)


def quicker_ways(question: Question, index: int) -> list[Edges]:
    """Return the ways of a vehicle alone that are quicker than its route, the cheapest first.

    Parameters
    ----------
    question : Question
        What is asked.
    index : int
        The vehicle's position.

    Returns
    -------
    list of ndarray of int, (k,)
        Edge ids in driving order; none both cheaper and quicker than another.
    """
    own, fleet = question.ends[index], question.fleet
    weight, pace = fleet.alone(index), fleet.drive_s((index,))
    usual_s = fleet.route_s((index,), question.alone[index])
    trees = question.trees[index]
    quick = Trees(engine_for(question.net, fleet.barred(index, pace), question.problem.engine, 4))
    there, onward = (
        Reach(node, trees.costs([node], forward)[0], quick.costs([node], forward)[0])
        for node, forward in ((own.origin, True), (own.destination, False))
    )
    if there.time_s[own.destination] >= usual_s - SAME_S:
        return []
    # What is dearer than a quickest way is neither cheaper nor quicker than that.
    most = float(weight[quick.path(own.origin, own.destination)].sum()) * LAST_DIGITS
    budget = Budget.of(most, usual_s - 2 * SAME_S, onward, 1.0)
    found = labels_of(question.net, weight, pace, there, budget, forward=True)
    _, cost, time_s = found.at(np.array([own.destination], np.int64))
    cheapest = np.argsort(cost, kind="stable").tolist()
    return [found.route(own.destination, float(time_s[place])) for place in cheapest]


def told_quick(question: Question) -> Iterator[str]:
    """Yield who takes a quicker route than its cheapest, and why.

    Parameters
    ----------
    question : Question
        What is asked.

    Yields
    ------
    str
        A remark for each.
    """
    for index, late_s in question.quicker.items():
        if question.solo[index] <= question.least[index] * LAST_DIGITS:
            continue  # another one that is as cheap
        name = question.ends[index].vehicle
        yield (
            f"{name} takes a quicker route than its cheapest, by which it would be late even "
            f"alone by {late_by(late_s)}"
        )
