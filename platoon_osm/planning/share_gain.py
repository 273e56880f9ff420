"""Who gets what a plan saves, and whether any coalition could do better on the road or anew.

On the planned roads coalitions drive as planned or alone (`platoon_osm.planning.gain_shared`).
Planned anew, each coalition of two or more is planned by the same problem without the others: the
same network, costs, times, rules and limits, and by the same planner. A master that is named and
not among them leads nobody, and any of them may be the master. What its plan saves is its value, or
nothing if it would lose; and as a coalition may split, the best sum over all ways to do so. The
planner need not find the best plan of all (its proof says how near it is), so a coalition might do
better still.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError
from ..kinds import kind_of
from ..plans.plan import Plan
from ..sharing.coalitions import superadditive_cover
from ..sharing.rule_names import SharingRule
from .gain_shared import games_of, recorded, saved_cents, with_gain
from .joint import solve
from .master import LONGEST
from .problem import Problem
from .sharing_rules import equal_parts, shared

__all__ = ["share_gain"]

ANEW = "planned anew"

MOST_ANEW = 8
"""Vehicles of the largest plan whose coalitions, 246 of them, are planned one by one."""


def share_gain(
    plan: Plan, problem: Problem, rule: SharingRule = "equal", *, anew: bool = False
) -> Plan:
    """Return a plan with shares of what it saves, and what coalitions could gain beyond them.

    Parameters
    ----------
    plan : Plan
        Of the problem.
    problem : Problem
        What was asked; its objective has costs in money.
    rule : {"equal", "shapley", "least-core"}
        By what it is shared: equal parts of the leader's loss, the Shapley value, or so that those
        who could gain most by themselves gain least.
    anew : bool
        Whether coalitions may plan anew for themselves, by the same problem; for at most 8
        vehicles. Otherwise they drive as planned, or alone.

    Returns
    -------
    Plan
        The same, with `gain`.

    Raises
    ------
    ScenarioError
        An unknown rule, costs that are no money, another problem than the plan's, or too many
        vehicles to plan for all coalitions.
    """
    if not isinstance(plan, Plan) or not isinstance(problem, Problem):
        raise ScenarioError(
            f"share_gain: {kind_of(plan)} and {kind_of(problem)} were given; give a Plan and the "
            "Problem it was made from"
        )
    if not anew:
        return with_gain(plan, problem, rule)
    games = games_of(plan, problem, rule)
    saved = saved_cents(plan)
    if len(saved) > MOST_ANEW:
        raise ScenarioError(
            f"share_gain: {len(saved)} vehicles have too many coalitions to plan for; at most "
            f"{MOST_ANEW} with anew=True"
        )
    equal = np.zeros(len(saved))
    for game in games:
        equal[list(game.vehicles)] = equal_parts(game)
    values = _values_anew(problem)
    more = float(values[-1]) - sum(saved)
    values[-1] = sum(saved)
    found = shared(plan, tuple(range(len(saved))), equal, values, rule)
    if more >= 1:
        told = f"planned apart in groups all would save {more / 100:,.2f} {plan.unit} more"
        found = replace(found, remarks=(*found.remarks, told))
    return recorded(plan, saved, [found], rule, ANEW)


def _values_anew(problem: Problem) -> NDArray[np.float64]:
    """Return what coalitions would save with plans of their own; everybody, in parts."""
    values = np.zeros(1 << len(problem.trips))
    for coalition in range(1, len(values) - 1):
        if coalition & (coalition - 1):  # two or more
            own = solve(_without_others(problem, coalition))
            values[coalition] = max(sum(saved_cents(own)), 0)
    return superadditive_cover(values)


def _without_others(problem: Problem, coalition: int) -> Problem:
    trips = tuple(trip for k, trip in enumerate(problem.trips) if coalition >> k & 1)
    known = {trip.vehicle for trip in trips} | {LONGEST}
    return replace(problem, trips=trips, master=problem.master if problem.master in known else None)
