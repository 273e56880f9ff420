"""What the hour is worth, for pages of plans: worked out where that takes next to no time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..driving.rules import places_pauses
from ..errors import PlatoonError

if TYPE_CHECKING:
    from ..network.road_network import RoadNetwork
    from ..planning.scenario.record import Scenario
    from ..plans.curves import DelayFrontier, DepartureCurve
    from ..plans.plan import Plan

__all__ = ["MOST_UNDER_RULES", "MOST_VEHICLES", "time_worth"]

MOST_VEHICLES = 12
"""Of more, curves take longer than a page is worth."""

MOST_UNDER_RULES = 4
"""Likewise under driving rules."""


def time_worth(
    asked: Scenario, net: RoadNetwork, plan: Plan
) -> dict[str, DepartureCurve | DelayFrontier]:
    """Return the curve of departures and the frontier of delays of a plan.

    Parameters
    ----------
    asked : Scenario
        What was planned.
    net : RoadNetwork
        Where.
    plan : Plan
        The answer.

    Returns
    -------
    dict of str to DepartureCurve or DelayFrontier
        "curve" and "frontier", as far as they say anything, under the rules of the plan; neither of
        a plan in which nobody drives in company, nor of one with many vehicles.
    """
    table = plan.timetable
    masters = {one.master for one in plan.platoons if len(one.vehicles) > 1}
    if table is None or len(masters) != 1:
        return {}
    if len(plan.trips) > (MOST_UNDER_RULES if places_pauses(table.rules) else MOST_VEHICLES):
        return {}
    from ..planning.curves import delay_frontier, departure_curve

    master = masters.pop()
    found: dict[str, DepartureCurve | DelayFrontier] = {}
    try:
        problem = asked.problem(net)
        frontier = delay_frontier(problem)
        if frontier.saving_share[-1] > 0:
            found["frontier"] = frontier
        if master is not None:
            curve = departure_curve(problem, plan.trips[master].vehicle)
            if len(curve) > 1:
                found["curve"] = curve
    except PlatoonError:
        # A page does without what this question has not.
        return found
    return found
