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

import numpy as np
from numpy.typing import NDArray

from ..costs.objective import edge_weights
from ..costs.weights import EdgeWeights
from ..errors import ScenarioError, brief
from ..network.placed import network_below
from ..plans.bill import CENTS
from ..plans.gain import GainShare, GainSharing
from ..plans.plan import Plan
from ..plans.text_table import listed
from ..sharing.rule_names import SharingRule
from ..vehicles.pace import drive_times
from ..vehicles.profile import Vehicle
from .fleet import Fleet
from .problem import Problem, check_choice
from .road_game import RoadGame, road_games
from .sharing_rules import Shared, shared_on_road

__all__ = ["games_of", "recorded", "saved_cents", "with_gain"]

Floats = NDArray[np.float64]

PLANNED = "on the planned roads"

DIGITS = 6
"""Of a cent; what lies beyond is last digits."""


def with_gain(
    plan: Plan,
    problem: Problem,
    rule: SharingRule = "equal",
    fleet: Fleet | None = None,
    *,
    bounded: bool = True,
) -> Plan:
    """Return a plan with shares of what it saves, coalitions asked on the planned roads.

    Parameters
    ----------
    plan : Plan
        Of the problem.
    problem : Problem
        What was asked; its objective has costs in money.
    rule : {"equal", "shapley", "least-core"}
        By what it is shared.
    fleet : Fleet, optional
        Of the plan's network without places between junctions, if it is known.
    bounded : bool
        Whether what groups of many linked vehicles could gain is bounded, which may take as long as
        planning.

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
    games = games_of(plan, problem, rule, fleet)
    return recorded(
        plan, saved, [shared_on_road(plan, game, rule, bounded) for game in games], rule, PLANNED
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


def games_of(
    plan: Plan, problem: Problem, rule: SharingRule, fleet: Fleet | None = None
) -> list[RoadGame]:
    """Return the games of a plan on its planned roads, once it is sure that it can be shared.

    Parameters
    ----------
    plan : Plan
        Of the problem.
    problem : Problem
        What was asked.
    rule : {"equal", "shapley", "least-core"}
        By what it is to be shared.
    fleet : Fleet, optional
        As in `with_gain`.

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
    return road_games(plan, fleet or _fleet(problem, plan), saved_cents(plan))


def _fleet(problem: Problem, plan: Plan) -> Fleet:
    """Return what edges of the plan's network cost each vehicle, and how fast it is."""
    net = network_below(problem.net)
    if plan.network.identity != net.identity():
        raise ScenarioError(
            f"share_gain: the plan was made on {plan.network.name}, the problem has another "
            "network; give the problem it was made from"
        )
    kinds = [problem.profile_of(trip) for trip in problem.trips]
    weights: dict[Vehicle | None, EdgeWeights] = {}
    paces: dict[Vehicle | None, Floats] = {}
    for kind in kinds:
        if kind not in weights:
            weights[kind] = edge_weights(problem.objective, net, "share_gain", kind)
            own = drive_times(net, kind)
            paces[kind] = next((one for one in paces.values() if np.array_equal(one, own)), own)
    return Fleet([weights[kind] for kind in kinds], None, [paces[kind] for kind in kinds])


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
        max(
            (round(one.worst, DIGITS) + 0.0 for one in games if one.worst is not None), default=None
        ),
        manner if games else "",
        "; ".join(remark for one in found for remark in one.remarks),
    )
    return replace(plan, gain=gain)
