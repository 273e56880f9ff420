"""Who gets what a plan saves: each vehicle's share beside what it saves as planned.

What each saves as planned is known: its bill alone less its bill as planned. A rule says what each
should have of the sum (`platoon_osm.planning.sharing_rules`); the differences are paid between
them. Every coalition is asked what it could gain by itself on the planned roads
(`platoon_osm.planning.road_game`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import get_args

from ..costs.objective import edge_weights
from ..costs.weights import EdgeWeights
from ..errors import ScenarioError, brief
from ..network.placed import network_below
from ..plans.gain import GainShare, GainSharing
from ..plans.plan import Plan
from ..plans.text_table import listed
from ..vehicles.profile import Vehicle
from .problem import Problem, check_choice
from .road_game import CENTS, RoadGame, road_games
from .sharing_rules import Shared, SharingRule, shared_on_road

__all__ = ["games_of", "recorded", "saved_cents", "with_gain"]

PLANNED = "on the planned roads"

DIGITS = 6
"""Of a cent; what lies beyond is last digits."""


def with_gain(plan: Plan, problem: Problem, rule: SharingRule = "equal") -> Plan:
    """Return a plan with shares of what it saves, coalitions asked on the planned roads.

    Parameters
    ----------
    plan : Plan
        Of the problem.
    problem : Problem
        What was asked; its objective has costs in money.
    rule : {"equal", "shapley", "least-core"}
        By what it is shared.

    Returns
    -------
    Plan
        The same, with `gain`.

    Raises
    ------
    ScenarioError
        An unknown rule, costs that are no money, or another problem than the plan's.
    """
    saved = saved_cents(plan)
    games = games_of(plan, problem, rule)
    return recorded(
        plan, saved, [shared_on_road(plan, game, rule) for game in games], rule, PLANNED
    )


def saved_cents(plan: Plan) -> tuple[int, ...]:
    """Return what each vehicle saves by a plan.

    Parameters
    ----------
    plan : Plan
        Whose costs are in money.

    Returns
    -------
    tuple of int, (N,)
        Cents, by its bill; without one by its costs, in which waiting and delay do not count.
    """
    if plan.bill is not None:
        return tuple(one.saved_cents for one in plan.bill.vehicles)
    return tuple(round(CENTS * (one.solo_cost - one.joint_cost)) for one in plan.vehicles)


def games_of(plan: Plan, problem: Problem, rule: SharingRule) -> list[RoadGame]:
    """Return the games of a plan on its planned roads, once it is sure that it can be shared.

    Parameters
    ----------
    plan : Plan
        Of the problem.
    problem : Problem
        What was asked.
    rule : {"equal", "shapley", "least-core"}
        By what it is to be shared.

    Returns
    -------
    list of RoadGame
        One for each group of vehicles that are linked by companies.

    Raises
    ------
    ScenarioError
        As `with_gain`.
    """
    check_choice("share", rule, get_args(SharingRule))
    names = [trip.vehicle for trip in problem.trips]
    if names != [trip.vehicle for trip in plan.trips]:
        raise ScenarioError(
            f"share_gain: the plan is not that of this problem, which has {listed(names)}; give "
            "the problem it was made from"
        )
    unit = plan.unit
    if not (len(unit) == 3 and unit.isascii() and unit.isalpha() and unit.isupper()):
        raise ScenarioError(
            f"share_gain: costs are in {brief(unit)}, no money; plan with an objective whose unit "
            'is a currency, as "EUR"'
        )
    return road_games(plan, _weights(problem, plan), saved_cents(plan))


def _weights(problem: Problem, plan: Plan) -> list[EdgeWeights]:
    """Return what edges of the plan's network cost each vehicle; one object for those alike."""
    net = network_below(problem.net)
    if plan.network.identity != net.identity():
        raise ScenarioError(
            f"share_gain: the plan was made on {plan.network.name}, the problem has another "
            "network; give the problem it was made from"
        )
    known: dict[Vehicle | None, EdgeWeights] = {}
    for trip in problem.trips:
        kind = problem.profile_of(trip)
        if kind not in known:
            known[kind] = edge_weights(problem.objective, net, "share_gain", kind)
    return [known[problem.profile_of(trip)] for trip in problem.trips]


def recorded(
    plan: Plan, saved: Sequence[int], found: Sequence[Shared], rule: str, manner: str
) -> Plan:
    """Return a plan with the record of its shares.

    Parameters
    ----------
    plan : Plan
        What was shared.
    saved : sequence of int, (N,)
        What each vehicle saves by it [cents].
    found : sequence of Shared
        Every vehicle in one of them.
    rule, manner : str
        By what it was shared, and how coalitions were asked.

    Returns
    -------
    Plan
        With `gain`.
    """
    shares = dict(pair for one in found for pair in zip(one.vehicles, one.shares, strict=True))
    games = [one for one in found if len(one.vehicles) > 1]
    gain = GainSharing(
        rule,
        plan.bill.currency if plan.bill else plan.unit,
        tuple(GainShare(own, shares[vehicle]) for vehicle, own in enumerate(saved)),
        sum(one.coalitions for one in games),
        max((round(one.worst, DIGITS) + 0.0 for one in games), default=None),
        manner if games else "",
        "; ".join(remark for one in found for remark in one.remarks),
    )
    return replace(plan, gain=gain)
