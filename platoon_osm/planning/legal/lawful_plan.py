"""The plan of a question under driving rules: company that can be driven, and its timetable.

Who drives with whom is given as runs, with the legal trip of each vehicle. They are written down,
cut where vehicles stand, and get the times of the linear programme. Should those break a closing
of a road, for they need not be the moments of the search, or may weeks matter, of which the
programme knows nothing, the search's own moments are taken.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from ...errors import ScenarioError
from ...network.placed import network_below
from ...plans.plan import Plan
from ...plans.stretches import Run
from ...plans.timetable import Timetable
from ..timing.hours_check import broken_hours
from ..timing.schedule import schedule
from .cut_at_pauses import Driven, plan_with_days
from .legal_question import LegalQuestion
from .moments import table_of_moments

__all__ = ["timed_under_law"]

WEEK_S = 7 * 86_400


def timed_under_law(
    legal: LegalQuestion, plan: Plan, routes: Sequence[Sequence[Run]], driven: Sequence[Driven]
) -> Plan:
    """Return a written plan with its pauses and times.

    Parameters
    ----------
    legal : LegalQuestion
        What was asked, with its law.
    plan : Plan
        Without times.
    routes : sequence of sequence of Run, (N, ...)
        What it was written from.
    driven : sequence of Driven, (N,)
        The legal trip of each vehicle.

    Returns
    -------
    Plan
        With a timetable that names its rules.
    """
    problem = legal.question.problem
    cut = plan_with_days(plan, legal.question.net, routes, driven)
    patience_s = problem.patience_min * 60.0
    below = network_below(legal.question.net)
    if not any(_minds_weeks(legal, one) for one in driven):
        try:
            table = schedule(cut.plan, problem.trips, patience_s, cut.days, legal.duration_s)
            assert table is not None
            found = _ruled(legal, cut.plan, table)
            if not broken_hours(found, below, legal.vehicles):
                return found
        except ScenarioError:
            # Rounded to the last digit, what is possible may seem not to be.
            pass
    moments = table_of_moments(legal, cut.plan, cut.days, cut.points, driven)
    return _ruled(legal, cut.plan, moments)


def _minds_weeks(legal: LegalQuestion, driven: Driven) -> bool:
    """Tell whether a vehicle's trip depends on what is driven in a week, or on weekly rests."""
    trip, rules = driven.trip, driven.rules
    limits, state = rules.limits, rules.state
    drives = float(driven.way.road.clock_s.sum())
    # The limits of two drivers are those of the vehicle; either might drive all the way.
    share = 2 if limits.change_s else 1
    begin = trip.departure_s if rules.state_at_s is None else rules.state_at_s
    passes = (trip.arrival_s - legal.monday_s) // WEEK_S > (begin - legal.monday_s) // WEEK_S
    return (
        state.driven_this_week_s + drives > limits.week_s / share
        or state.driven_this_week_s + state.driven_last_week_s + drives > limits.fortnight_s / share
        or state.since_weekly_rest_s + trip.arrival_s - begin > limits.weekly_after_s
        or (passes and limits.week_s < math.inf)
    )


def _ruled(legal: LegalQuestion, plan: Plan, table: Timetable) -> Plan:
    problem = legal.question.problem
    named = replace(table, rules=problem.rules.name, task_relief=problem.task_relief)
    stands = [own.trip.paused_s for own in legal.alone]
    trips = tuple(
        replace(trip, alone=replace(trip.alone, paused_s=paused_s))
        for trip, paused_s in zip(plan.trips, stands, strict=True)
    )
    return replace(plan, timetable=named, trips=trips)
