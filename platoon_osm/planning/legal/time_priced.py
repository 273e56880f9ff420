"""Plans under driving rules where the objective prices waiting or delay.

The search for a platoon knows nothing of these prices. So it is asked several times, each time with
a limit of how much later than alone vehicles may arrive, and everybody alone counts too; each plan
is written with its times, and the one is taken that costs least with what its waiting and delay
cost. That is the best of those, and no search of all: the proof is a bound for any company.

A vehicle waits as much longer as it stands on its way than on its legal trip alone. Its delay is
how much later it arrives than alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from ...plans.plan import Plan
from .legal_question import LegalQuestion
from .stars import Planned, alone_plan, planned_platoons

__all__ = ["DELAYS_S", "least_with_time", "time_cost"]

DELAYS_S = tuple(60 * minutes for minutes in (240, 120, 60, 30, 15, 0))
"""The limits of delay that are tried, besides the windows alone."""


def time_cost(legal: LegalQuestion, plan: Plan) -> float:
    """Return what waiting and delay cost in a plan.

    Parameters
    ----------
    legal : LegalQuestion
        What was asked, with its law.
    plan : Plan
        With its timetable.

    Returns
    -------
    float
        At the objective's prices.
    """
    prices, total = legal.question.time_prices, 0.0
    assert plan.timetable is not None
    for times, own, asked in zip(plan.timetable.vehicles, legal.alone, legal.asked, strict=True):
        total += prices.waiting * max(0.0, times.waiting_s - own.trip.paused_s)
        if times.earliest_departure_s is not None and asked.earliest is not None:
            takes = times.arrival_s - times.earliest_departure_s
            total += prices.delay * (takes - (own.trip.arrival_s - asked.earliest))
    return total


def least_with_time(legal: LegalQuestion, finish: Callable[[Planned], Plan]) -> Plan:
    """Return the plan that costs least with its waiting and delay.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    finish : callable
        Writes a plan with its times.

    Returns
    -------
    Plan
        With its times; its cost leaves both out.
    """
    best, least = None, math.inf
    for planned in _candidates(legal):
        plan = finish(planned)
        pays = planned.cost + time_cost(legal, plan)
        if pays < least:
            best, least = plan, pays
    assert best is not None
    return best


def _candidates(legal: LegalQuestion) -> Iterator[Planned]:
    yield planned_platoons(legal)
    for delay_s in DELAYS_S:
        yield planned_platoons(legal.hurried(delay_s))
    yield alone_plan(legal)
