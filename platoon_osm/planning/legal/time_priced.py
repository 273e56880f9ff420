"""Plans under driving rules where the objective prices waiting or delay.

The search for a platoon knows nothing of these prices. What it finds without them costs least
before waiting and delay are paid; if nobody pays any, nothing is cheaper with them either, and what
is proved without prices holds. Else it is asked again several times, each time with a limit of how
much later than alone vehicles may arrive, and everybody alone counts too; each plan is written with
its times, and the one is taken that costs least with what its waiting and delay cost. That is the
best of those, and no search of all. What was planned without prices costs no more before time is
paid, so its bound holds for all of them.

A vehicle waits as much longer as it stands on its way than on its legal trip alone. Its delay is
how much later it arrives than alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from ...plans.plan import Plan
from .legal_question import LegalQuestion
from .stars import Planned, alone_plan, planned_platoons

__all__ = ["DELAYS_S", "least_with_time", "time_cost"]

DELAYS_S = tuple(60 * minutes for minutes in (240, 120, 60, 30, 15, 0))
"""The limits of delay that are tried, besides the windows alone."""

NOTHING = 1e-9
"""Share of the cost below which waiting and delay cost nothing."""


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
            total += prices.delay * max(0.0, takes - (own.trip.arrival_s - asked.earliest))
    return total


def least_with_time(
    legal: LegalQuestion, finish: Callable[[Planned, Planned | None], Plan]
) -> Plan:
    """Return the plan that costs least with its waiting and delay.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    finish : callable
        Writes a plan with its times and what is proved of it; where time is paid for, beside what
        was planned without its prices.

    Returns
    -------
    Plan
        With its times; its cost leaves both out.
    """
    free = planned = planned_platoons(legal)
    plan = finish(planned, None)
    time = time_cost(legal, plan)
    if time <= NOTHING * planned.cost:
        return plan
    best, least = finish(planned, free), planned.cost + time
    for limit_s in DELAYS_S:
        if limit_s >= _longest_delay_s(legal, plan):
            continue  # the plan at hand is within it
        planned = planned_platoons(legal.hurried(limit_s))
        plan = finish(planned, free)
        time = time_cost(legal, plan)
        if planned.cost + time < least:
            best, least = plan, planned.cost + time
        if time <= NOTHING * planned.cost:
            break  # who hurries more has fewer plans to choose from, and nothing to pay for less
    planned = alone_plan(legal)
    if planned.cost >= least:
        return best
    plan = finish(planned, free)
    return plan if planned.cost + time_cost(legal, plan) < least else best


def _longest_delay_s(legal: LegalQuestion, plan: Plan) -> float:
    """Return by how much a vehicle arrives later than alone at most; inf if nobody can tell."""
    assert plan.timetable is not None
    longest = 0.0
    for times, own, asked in zip(plan.timetable.vehicles, legal.alone, legal.asked, strict=True):
        if times.earliest_departure_s is None or asked.earliest is None:
            return math.inf
        takes = times.arrival_s - times.earliest_departure_s
        longest = max(longest, takes - (own.trip.arrival_s - asked.earliest))
    return longest
